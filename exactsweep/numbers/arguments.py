"""Arguments that are not what a function asks for: told by name, where it cannot do with them.

What can be done with is not looked at, so that lists may be tuples and arrays, and a call costs
nothing; only where a function fails are its arguments held against its annotations.
"""

from __future__ import annotations

import builtins
import inspect
import re
import typing
from collections import abc
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import wraps
from itertools import islice
from types import NoneType, UnionType
from typing import Any, Literal, ParamSpec, TypeVar, Union, get_args, get_origin

from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import quote

_Accepted = ParamSpec("_Accepted")
_Returned = TypeVar("_Returned")

# Of what an argument holds so many are looked at.
_LOOKED_AT = 100


class ArgumentError(ExactSweepError):
    """An argument that is not of the kind that a function asks for; the message names it."""


def tells_arguments(function: Callable[_Accepted, _Returned]) -> Callable[_Accepted, _Returned]:
    """Let a function that fails on an argument of another kind than its annotation say so.

    Args:
        function: with annotations.

    Returns:
        The same; it raises ArgumentError where it would raise Python's TypeError, or the like, for
        an argument of another kind. Whatever else it raises, it raises as before.

    Example:
        >>> @tells_arguments
        ... def double(number: int) -> int:
        ...     return number.__index__() * 2
        >>> double("a")
        Traceback (most recent call last):
        exactsweep.numbers.arguments.ArgumentError: number is 'a', not int
    """

    @wraps(function)
    def telling(*arguments: _Accepted.args, **named: _Accepted.kwargs) -> _Returned:
        try:
            return function(*arguments, **named)
        except ExactSweepError:
            raise
        except Exception:
            # A fault of this program must not be called one of the caller.
            fault = _find_fault(function, arguments, named)
            if fault is None:
                raise
        raise ArgumentError(fault)

    return telling


def _find_fault(
    function: Callable[..., object], arguments: tuple[object, ...], named: Mapping[str, object]
) -> str | None:
    """The first argument that is of another kind."""
    signature = inspect.signature(function)
    try:
        bound = signature.bind(*arguments, **named)
    except TypeError:
        return None
    for name, value in bound.arguments.items():
        parameter = signature.parameters[name]
        if parameter.kind in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL):
            continue
        if parameter.annotation is parameter.empty:  # self
            continue
        hint = _resolve(parameter.annotation, function)
        if not _fits(value, hint):
            return f"{name} is {quote(value)}, not {_name_kind(hint, parameter.annotation)}"
    return None


class _UnseenType(type):
    """Types that only type checkers know: what has a type of that name is of this one."""

    def __getattr__(cls, name: str) -> type:
        if name.startswith("_"):
            raise AttributeError
        return _UnseenType(name, (), {})

    def __getitem__(cls, of: object) -> type:
        return cls

    def __instancecheck__(cls, value: object) -> bool:
        return any(kind.__name__ == cls.__name__ for kind in type(value).__mro__)


class _ModuleNames(dict[str, object]):
    """The names of a module, and those that are imported for type checkers alone."""

    def __missing__(self, name: str) -> object:
        for module in (builtins, abc, typing):
            if hasattr(module, name):
                return getattr(module, name)
        return _UnseenType(name, (), {})


def _resolve(annotation: object, function: Callable[..., object]) -> object:
    """Resolve an annotation to the types that it allows."""
    if not isinstance(annotation, str):
        return annotation
    return eval(annotation, {}, _ModuleNames(inspect.unwrap(function).__globals__))


def _fits(value: object, hint: object) -> bool:
    if hint is None:
        return value is None
    if hint is Any or isinstance(hint, TypeVar):
        return True
    origin = get_origin(hint)
    if origin is Literal:
        return any(type(value) is type(one) and value == one for one in get_args(hint))
    if origin in (Union, UnionType):
        return any(_fits(value, one) for one in get_args(hint))
    kind = origin or hint
    if not isinstance(kind, type):
        return True
    if kind in (int, float) and isinstance(value, bool):
        return False
    if kind is float:
        return isinstance(value, int | float) and value == value
    if getattr(kind, "_is_protocol", False) and kind.__module__ != "collections.abc":
        return all(hasattr(value, name) for name in vars(kind) if not name.startswith("_"))
    if not isinstance(value, kind):
        return False
    of = get_args(hint)
    return not of or all(_fits(one, its) for one, its in _look_into(value, kind, of))


# Of this no value is.
_NOTHING = _UnseenType("nothing", (), {})


def _look_into(value: object, kind: type, of: Sequence[object]) -> Iterable[tuple[object, object]]:
    """The first things that an argument holds, as far as it can be looked into more than once."""
    if isinstance(value, str | bytes | Mapping) and not issubclass(kind, Mapping):
        # Letters and keys are no list of other things.
        return () if type(value) in of else [(value, _NOTHING)]
    if isinstance(value, tuple) and kind is tuple and ... not in of:
        return zip(value, of, strict=False) if len(value) == len(of) else [(value, _NOTHING)]
    if isinstance(value, Mapping):
        return [(one, its) for item in value.items() for one, its in zip(item, of, strict=True)]
    if isinstance(value, Iterable) and not isinstance(value, Iterator):
        return [(one, of[0]) for one in islice(value, _LOOKED_AT)]
    return ()


def _name_kind(hint: object, annotation: object) -> str:
    kinds = get_args(hint) if get_origin(hint) in (Union, UnionType) else (hint,)
    if not all(isinstance(kind, type) for kind in kinds):
        return re.sub(r"\b(?:[a-z_]+\.)+(?=[A-Z])", "", str(annotation))
    return " or ".join("None" if kind is NoneType else kind.__name__ for kind in kinds)
