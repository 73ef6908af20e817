"""Which functions of the package use which, read from its source with `ast`.

A function uses another one if its body names it: as a call, or as an argument such as that of
`reduce`. A method is known by its name alone; those of one name count as one.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator, Mapping
from functools import cache
from importlib.resources import files

PACKAGE = "exactsweep"

Uses = Mapping[str, frozenset[str]]
"""For each function, by name, the names of those that it uses."""


@cache
def uses(modules: tuple[str, ...]) -> Uses:
    """Read modules of the package.

    Args:
        modules: their names without that of the package; no function name may occur in two.

    Returns:
        The uses among the functions and methods of these modules.

    Example:
        >>> sorted(uses(("cc",))["sweep_outer_cc"])
        ['merge_by_slope', 'trajectory_cc']
    """
    trees = {name: ast.parse(_source(name)) for name in modules}
    bodies: dict[str, list[ast.FunctionDef]] = {}
    methods: set[str] = set()
    for tree in trees.values():
        for node in tree.body:
            if isinstance(node, ast.FunctionDef):
                bodies.setdefault(node.name, []).append(node)
            elif isinstance(node, ast.ClassDef):
                for part in node.body:
                    if isinstance(part, ast.FunctionDef):
                        bodies.setdefault(part.name, []).append(part)
                        methods.add(part.name)
    return {
        name: frozenset(used for body in found for used in _named(body, bodies, methods)) - {name}
        for name, found in bodies.items()
    }


def _source(module: str) -> str:
    return files(PACKAGE).joinpath("procedures", f"{module}.py").read_text(encoding="utf-8")


def _named(
    function: ast.FunctionDef, known: Collection[str], methods: Collection[str]
) -> Iterator[str]:
    """The functions that a body names; its own arguments and variables are none."""
    own = {node.arg for node in ast.walk(function) if isinstance(node, ast.arg)}
    own |= {
        node.id
        for node in ast.walk(function)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    }
    for node in ast.walk(function):
        if isinstance(node, ast.Name) and node.id in known and node.id not in own:
            if node.id not in methods:
                yield node.id
        elif isinstance(node, ast.Attribute) and node.attr in methods:
            yield node.attr


def reached(found: Uses, start: str) -> set[str]:
    """All that a function uses, directly or not.

    >>> sorted(reached({"a": frozenset("b"), "b": frozenset("c"), "c": frozenset()}, "a"))
    ['b', 'c']
    """
    seen: set[str] = set()
    waiting = [start]
    while waiting:
        for used in found.get(waiting.pop(), ()):
            if used not in seen:
                seen.add(used)
                waiting.append(used)
    return seen


def between(found: Uses, ends: Collection[str]) -> dict[str, frozenset[str]]:
    """What some functions use on the way from one of them to another.

    Returns:
        The uses among those functions and all others from which one of them is reached.

    Example:
        >>> chain = {"a": frozenset("xy"), "x": frozenset("b"), "y": frozenset(), "b": frozenset()}
        >>> sorted(between(chain, {"a", "b"}))
        ['a', 'b', 'x']
    """
    shown = {name for name in found if name in ends or not reached(found, name).isdisjoint(ends)}
    return {name: found[name] & shown for name in shown}
