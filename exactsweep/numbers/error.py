"""Errors: base classes, names of rejected inputs, arguments of the wrong type.

The decorator `explain_type_errors` compares arguments with their annotations only after a call has
failed. So successful calls cost nothing, and may pass tuples or arrays for lists.
"""

from __future__ import annotations

import builtins
import inspect
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import wraps
from itertools import islice
from types import NoneType, UnionType
from typing import Any, Literal, ParamSpec, TypeVar, Union, get_args, get_origin

_Accepted = ParamSpec("_Accepted")
_Returned = TypeVar("_Returned")

# The check examines this many items of an argument.
_LOOKED_AT = 100

# Maximum number of characters of a value in a message.
_ECHO = 40


class ExactSweepError(ValueError):
    """Base class of this package's errors; the message says what is wrong, and where."""


class NumberError(ExactSweepError):
    """A value that is not an exact rational number, or is beyond the limits."""


class ArgumentError(ExactSweepError):
    """An argument of the wrong type; the message names it."""


def quote(value: object) -> str:
    """Quote a value in a message: its repr, shortened if long.

    >>> quote("7" * 99)
    "'777777777777777777777777777777777777..."
    """
    try:
        text = repr(value)
    except Exception:  # a foreign repr may fail in any way
        text = f"<{type(value).__name__}>"
    if not text.isprintable():
        text = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text[:_ECHO])
    return text if len(text) <= _ECHO else f"{text[: _ECHO - 3]}..."


@contextmanager
def prefix_errors(name: str, error_type: type[ExactSweepError] | None = None) -> Iterator[None]:
    """Put a name in front of the message of an error inside a `with` block.

    With an `error_type`, any ValueError becomes an error of that type; otherwise an ExactSweepError
    keeps its type, and other errors pass.
    """
    try:
        yield
    except ValueError as error:
        if not (error_type or isinstance(error, ExactSweepError)):
            raise
        raise (error_type or type(error))(f"{name}: {error}") from None


@contextmanager
def require_imports(package: str, what: str, error_type: type[ExactSweepError]) -> Iterator[None]:
    """Raise an error that names the package to install if an import in the `with` block fails."""
    try:
        yield
    except ModuleNotFoundError:
        raise error_type(f"{what} needs {package}: pip install {package}") from None
    except ImportError as error:  # a library that the package needs, or too little memory
        reason = " ".join(str(error).split())
        raise error_type(f"{what} needs {package}, which cannot be loaded: {reason}") from None


def explain_type_errors(function: Callable[_Accepted, _Returned]) -> Callable[_Accepted, _Returned]:
    """Decorate a function so that a failure caused by an argument of the wrong type names it.

    If an argument does not match its annotation, ArgumentError replaces TypeError and similar
    errors. Other errors are unchanged.

    >>> @explain_type_errors
    ... def double(number: int) -> int:
    ...     return number.__index__() * 2
    >>> double("a")
    Traceback (most recent call last):
    exactsweep.numbers.error.ArgumentError: number is 'a', not int
    """

    @wraps(function)
    def wrapper(*arguments: _Accepted.args, **named: _Accepted.kwargs) -> _Returned:
        try:
            return function(*arguments, **named)
        except ExactSweepError:
            raise
        except Exception:
            # Do not blame the caller for an error in this package.
            fault = _find_fault(function, arguments, named)
            if fault is None:
                raise
        raise ArgumentError(fault)

    return wrapper


def _find_fault(
    function: Callable[..., object], arguments: tuple[object, ...], named: Mapping[str, object]
) -> str | None:
    signature = inspect.signature(function)
    try:
        bound = signature.bind(*arguments, **named)
    except TypeError:
        return None
    for name, value in bound.arguments.items():
        parameter = signature.parameters[name]
        is_variadic = parameter.kind in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL)
        if is_variadic or parameter.annotation is parameter.empty:  # such as self
            continue
        hint = _resolve(parameter.annotation, function)
        if not _fits(value, hint):
            return f"{name} is {quote(value)}, not {_name_kind(hint, parameter.annotation)}"
    return None


class _UnseenType(type):
    """A stand-in for a type imported only for type checkers; values match it by type name."""

    def __getattr__(cls, name: str) -> type:
        if name.startswith("_"):
            raise AttributeError
        return _UnseenType(name, (), {})

    def __getitem__(cls, of: object) -> type:
        return cls

    def __instancecheck__(cls, value: object) -> bool:
        return any(kind.__name__ == cls.__name__ for kind in type(value).__mro__)


class _KnownNames(dict[str, object]):
    """Names in annotations, including those imported only for type checkers."""

    def __missing__(self, name: str) -> object:
        return _UnseenType(name, (), {})


def _resolve(annotation: object, function: Callable[..., object]) -> object:
    if not isinstance(annotation, str):
        return annotation
    return eval(annotation, {}, _KnownNames(vars(builtins) | inspect.unwrap(function).__globals__))


def _fits(value: object, hint: object) -> bool:
    origin, of = get_origin(hint), get_args(hint)
    if hint is None or origin in (Union, UnionType):
        return any(_fits(value, one) for one in of) if of else value is None
    if origin is Literal:
        return any(type(value) is type(one) and value == one for one in of)
    kind = origin or hint
    if not isinstance(kind, type) or kind is Any:
        return True
    if kind in (int, float) and isinstance(value, bool):
        return False
    if kind is float:
        return isinstance(value, int | float) and value == value
    if getattr(kind, "_is_protocol", False) and kind.__module__ != "collections.abc":
        return all(hasattr(value, name) for name in vars(kind) if not name.startswith("_"))
    return isinstance(value, kind) and (not of or _fit_items(value, kind, of))


def _fit_items(value: object, kind: type, of: Sequence[object]) -> bool:
    """Match the first items of an argument, if it can be iterated more than once."""
    if isinstance(value, str | bytes | Mapping) and not issubclass(kind, Mapping):
        # Text and mappings do not count as lists.
        return type(value) in of
    if isinstance(value, Mapping):
        return all(_fits(one, of[0]) and _fits(other, of[1]) for one, other in value.items())
    if isinstance(value, tuple) and kind is tuple and ... not in of:
        return len(value) == len(of) and all(map(_fits, value, of))
    if isinstance(value, Iterator) or not isinstance(value, Iterable):
        return True
    return all(_fits(one, of[0]) for one in islice(value, _LOOKED_AT))


def _name_kind(hint: object, annotation: object) -> str:
    kinds = get_args(hint) if get_origin(hint) in (Union, UnionType) else (hint,)
    if not all(isinstance(kind, type) for kind in kinds):
        return re.sub(r"\b(?:[a-z_]+\.)+(?=[A-Z])", "", str(annotation))
    return " or ".join("None" if kind is NoneType else kind.__name__ for kind in kinds)
