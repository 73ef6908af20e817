"""Mutants of a module: copies of its text that differ in one operator, number or statement."""

import ast
from collections.abc import Iterator
from itertools import pairwise
from typing import NamedTuple

_COMPARISONS: dict[type[ast.cmpop], tuple[str, ...]] = {
    ast.Lt: ("<=", ">"),
    ast.LtE: ("<", ">"),
    ast.Gt: (">=", "<"),
    ast.GtE: (">", "<"),
    ast.Eq: ("!=",),
    ast.NotEq: ("==",),
    ast.Is: ("is not",),
    ast.IsNot: ("is",),
    ast.In: ("not in",),
    ast.NotIn: ("in",),
}
_ARITHMETIC: dict[type[ast.operator], str] = {
    ast.Add: "-",
    ast.Sub: "+",
    ast.Mult: "+",
    ast.Div: "*",
    ast.FloorDiv: "*",
    ast.Mod: "*",
    ast.Pow: "*",
    ast.BitOr: "&",
    ast.BitAnd: "|",
    ast.LShift: ">>",
    ast.RShift: "<<",
}
_NAMES = {
    "min": "max",
    "max": "min",
    "any": "all",
    "all": "any",
    "bisect_left": "bisect_right",
    "bisect_right": "bisect_left",
    "sorted": "list",
}


class Mutant(NamedTuple):
    """A change of one place in a module; `start` and `end` are offsets in its bytes."""

    path: str
    line: int
    start: int
    end: int
    new: str

    def applied(self, text: bytes) -> bytes:
        """The text of the module with the change."""
        return text[: self.start] + self.new.encode() + text[self.end :]

    def lines(self, text: bytes) -> range:
        """The lines of its statement, without a body: what does not run them does not notice."""
        last = self.line + text.count(b"\n", self.start, self.end)
        *_, found = (
            node
            for node in ast.walk(ast.parse(text))  # what is around comes before what is within
            if isinstance(node, ast.stmt) and node.lineno <= self.line
            if last <= (node.end_lineno or 0)
        )
        body = getattr(found, "body", [])
        return range(found.lineno, max(body[0].lineno if body else 0, last + 1))

    def shown(self, text: bytes) -> tuple[str, str]:
        """The lines that are changed, before and after, without what is around."""
        first = text.rfind(b"\n", 0, self.start) + 1
        last = text.find(b"\n", self.end)
        after = text[first : self.start] + self.new.encode() + text[self.end : last]
        before, changed = (" ".join(t.decode().split()) for t in (text[first:last], after))
        return before, changed


def mutants_of(path: str, text: bytes) -> list[Mutant]:
    """All mutants of a module, in the order of its text.

    Types, strings, what is asserted and the messages of refusals stay as they are.
    """
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    module = _Module(text, starts)
    found = {
        Mutant(path, text.count(b"\n", 0, start) + 1, start, end, new)
        for node in _walk(ast.parse(text))
        for start, end, new in module.changes(node)
    }
    return sorted(found, key=lambda mutant: mutant[2:])


def _walk(node: ast.AST) -> Iterator[ast.AST]:
    """What of a tree is mutated."""
    if isinstance(node, ast.Assert | ast.Raise | ast.JoinedStr | ast.Import | ast.ImportFrom):
        return
    if isinstance(node, ast.keyword) and node.arg == "strict":  # as good as asserted
        return
    yield node
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "bases"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST):
                yield from _walk(child)


_Change = tuple[int, int, str]


class _Module(NamedTuple):
    text: bytes
    starts: list[int]

    def changes(self, node: ast.AST) -> Iterator[_Change]:
        """The changes at a node."""
        match node:
            case ast.Compare():
                sides = [node.left, *node.comparators]
                for k, comparison in enumerate(node.ops):
                    old = _symbol(comparison)
                    for new in _COMPARISONS[type(comparison)]:
                        yield from self._between(sides[k], sides[k + 1], old, new)
            case ast.BinOp() if type(node.op) in _ARITHMETIC and not _is_type(node):
                old, new = _symbol(node.op), _ARITHMETIC[type(node.op)]
                yield from self._between(node.left, node.right, old, new)
            case ast.BoolOp():
                old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
                for first, second in pairwise(node.values):
                    yield from self._between(first, second, old, new)
            case ast.AugAssign() if type(node.op) in _ARITHMETIC:
                old, new = _symbol(node.op), _ARITHMETIC[type(node.op)]
                yield from self._between(node.target, node.value, f"{old}=", f"{new}=")
                yield *self._span(node), "pass"
            case ast.UnaryOp(op=ast.Not() | ast.USub()):
                start, _ = self._span(node)
                is_not = isinstance(node.op, ast.Not)
                yield (start, start + 3, "") if is_not else (start, start + 1, "+")
            case ast.Constant(value=bool(value)):
                yield *self._span(node), str(not value)
            case ast.Constant(value=int(value)):
                yield *self._span(node), str(value + 1)
                if value > 0:
                    yield *self._span(node), str(value - 1)
            case ast.If() | ast.While() | ast.IfExp() if not _is_type_check(node.test):
                start, end = self._span(node.test)
                yield start, end, f"(not ({self.text[start:end].decode()}))"
            case ast.Call(func=ast.Name(id=name)) if name in _NAMES:
                yield *self._span(node.func), _NAMES[name]
            case ast.Expr(value=ast.Call()) | ast.Delete():
                yield *self._span(node), "pass"
            case ast.Continue():
                yield *self._span(node), "break"
            case ast.Break():
                yield *self._span(node), "continue"

    def _span(self, node: ast.expr | ast.stmt) -> tuple[int, int]:
        assert node.end_lineno is not None
        assert node.end_col_offset is not None
        return (
            self.starts[node.lineno - 1] + node.col_offset,
            self.starts[node.end_lineno - 1] + node.end_col_offset,
        )

    def _between(self, first: ast.expr, second: ast.expr, old: str, new: str) -> Iterator[_Change]:
        (_, low), (high, _) = self._span(first), self._span(second)
        at = low + self.text[low:high].index(old.encode())
        yield at, at + len(old), new


def _symbol(operator: ast.AST) -> str:
    """How an operator is written."""
    name = ast.Name("x")
    if isinstance(operator, ast.cmpop):
        return ast.unparse(ast.Compare(name, [operator], [name]))[2:-2]
    assert isinstance(operator, ast.operator)
    return ast.unparse(ast.BinOp(name, operator, name)).strip("x ")


def _is_type(node: ast.BinOp) -> bool:
    """Whether a union of types, not of sets or bits."""
    sides = ast.unparse(node.left), ast.unparse(node.right)
    return isinstance(node.op, ast.BitOr) and any(
        side[0].isupper() or side in ("None", "int", "str") or "[" in side for side in sides
    )


def _is_type_check(test: ast.expr) -> bool:
    return isinstance(test, ast.Name) and test.id == "TYPE_CHECKING"
