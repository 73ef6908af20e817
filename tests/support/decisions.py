"""Which ways the decisions of the kernel are taken, ties apart: a copy of it that takes notes.

A decision is a comparison, or the condition of an `if` or `while`, or a part of an `and` or `or`.
Numbers that are compared are less, equal or greater; anything else is true or false. What leads to
a refusal only, and what is asserted, is no decision.
"""

import ast
import importlib
import sys
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import spec_from_loader
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import exactsweep

ROOT = Path(exactsweep.__file__).parent
NOTED = (
    *(f"procedures.{path.stem}" for path in sorted((ROOT / "procedures").glob("[a-z]*.py"))),
    "evidence.contact",
    "procedures.exact_fit",
    "geometry.overlap",
)
_COPY, _NOTE_ORDER, _NOTE_TRUTH = "noted_exactsweep", "_note_order", "_note_truth"
_ORDERS = {ast.Lt: (0,), ast.LtE: (0, 1), ast.Gt: (2,), ast.GtE: (1, 2)}
_ORDERED = (int, float, Fraction, tuple, str)


class Decision(NamedTuple):
    """A place of the kernel, and the ways it can go."""

    module: str
    line: int
    source: str
    ways: tuple[str, ...]


class Outcome(NamedTuple):
    """A decision, by its number, and the way that it went, likewise."""

    decision: int
    way: int


class Notes:
    """The decisions of the copy, and the outcomes since they were last taken up."""

    def __init__(self) -> None:
        self.decisions: list[Decision] = []
        self._taken: set[tuple[int, int]] = set()

    def take_up(self) -> set[Outcome]:
        """The outcomes so far; begin again without any."""
        taken = {Outcome(*outcome) for outcome in self._taken}
        self._taken.clear()
        return taken

    def note_order(self, number: int, wanted: Sequence[int], first: Any, second: Any) -> bool:
        """Decide whether two values are in one of the wanted orders."""
        assert isinstance(first, _ORDERED)
        way = 0 if first < second else 1 if first == second else 2
        self._taken.add((number, way))
        return way in wanted

    def note_truth(self, number: int, value: Any) -> Any:
        """Note whether a value counts as true."""
        self._taken.add((number, 1 if value else 0))
        return value


class _Noting(ast.NodeTransformer):
    """Puts a note around every decision."""

    def __init__(self, module: str, text: str, notes: Notes) -> None:
        self._module, self._text, self._notes = module, text, notes

    def _number(self, node: ast.expr, *ways: str) -> ast.Constant:
        source = ast.get_source_segment(self._text, node) or ""
        decision = Decision(self._module, node.lineno, " ".join(source.split()), ways)
        self._notes.decisions.append(decision)
        return ast.Constant(len(self._notes.decisions) - 1)

    def _noted_truth(self, node: ast.expr) -> ast.expr:
        number = self._number(node, "false", "true")
        return _call(_NOTE_TRUTH, number, self._inside(node))

    def _inside(self, node: ast.expr) -> ast.expr:
        found = self.generic_visit(node)
        assert isinstance(found, ast.expr)
        return found

    def _condition(self, node: ast.expr) -> ast.expr:
        """A condition whose parts, down to single comparisons and values, are noted."""
        if isinstance(node, ast.Name) and node.id == "TYPE_CHECKING":
            return node
        if isinstance(node, ast.Compare | ast.BoolOp | ast.Constant):
            found = self.visit(node)
            assert isinstance(found, ast.expr)
            return found
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            node.operand = self._condition(node.operand)
            return node
        return self._noted_truth(node)

    def visit_Compare(self, node: ast.Compare) -> ast.expr:
        """A single comparison of order in three ways, any other in two."""
        if len(node.ops) == 1 and type(node.ops[0]) in _ORDERS:
            wanted = _ORDERS[type(node.ops[0])]
            number = self._number(node, "<", "=", ">")
            sides = [self.visit(node.left), self.visit(node.comparators[0])]
            return _call(
                _NOTE_ORDER,
                number,
                ast.Tuple([ast.Constant(way) for way in wanted], ast.Load()),
                *sides,
            )
        return self._noted_truth(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """Each part for itself."""
        node.values = [self._condition(value) for value in node.values]
        return node

    def visit_If(self, node: ast.If) -> ast.stmt:
        """Noted, unless it leads to a refusal."""
        if not isinstance(node.body[0], ast.Raise):
            node.test = self._condition(node.test)
        node.body = [self.visit(statement) for statement in node.body]
        node.orelse = [self.visit(statement) for statement in node.orelse]
        return node

    def visit_While(self, node: ast.While) -> ast.stmt:
        """Noted, unless it has no end."""
        node.test = self._condition(node.test)
        node.body = [self.visit(statement) for statement in node.body]
        return node

    def visit_IfExp(self, node: ast.IfExp) -> ast.expr:
        """Noted."""
        node.test = self._condition(node.test)
        node.body, node.orelse = self.visit(node.body), self.visit(node.orelse)
        return node

    def visit_comprehension(self, node: ast.comprehension) -> ast.comprehension:
        """Its conditions are noted."""
        node.iter = self.visit(node.iter)
        node.ifs = [self._condition(test) for test in node.ifs]
        return node

    def visit_Assert(self, node: ast.Assert) -> ast.stmt:
        """What must hold is no decision."""
        return node


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])


class _Importer(MetaPathFinder, Loader):
    """Imports modules of the package under the name of the copy, with notes in some of them."""

    def __init__(self, notes: Notes) -> None:
        self._notes = notes

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Only modules of the copy are found here."""
        if name.split(".")[0] != _COPY:
            return None
        is_package = ROOT.joinpath(*name.split(".")[1:]).is_dir()
        return spec_from_loader(name, self, is_package=is_package)

    def exec_module(self, module: ModuleType) -> None:
        """Run it with the copy imported instead of the package, and the means to take notes."""
        name = module.__name__.removeprefix(_COPY).removeprefix(".")
        path = ROOT.joinpath(*name.split(".")) if name else ROOT
        path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
        text = path.read_text()
        tree = ast.parse(text)
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module is not None:
                package, *rest = node.module.split(".")
                if package == exactsweep.__name__:
                    node.module = ".".join([_COPY, *rest])
        if name in NOTED:
            tree = _Noting(name, text, self._notes).visit(tree)
        vars(module)[_NOTE_ORDER] = self._notes.note_order
        vars(module)[_NOTE_TRUTH] = self._notes.note_truth
        exec(compile(ast.fix_missing_locations(tree), str(path), "exec"), vars(module))


@cache
def load_noted_kernel() -> tuple[Any, Notes]:
    """The package once more, with notes taken in `NOTED`.

    Decisions are numbered in the order of the modules there, whatever imports what.
    """
    notes = Notes()
    sys.meta_path.insert(0, _Importer(notes))
    for module in NOTED:
        importlib.import_module(f"{_COPY}.{module}")
    # So that small pairs come there, too.
    vars(sys.modules[f"{_COPY}.procedures.cover"])["_FEW"] = 8
    return importlib.import_module(_COPY), notes
