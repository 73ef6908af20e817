"""Allowed imports of packages, sizes of modules, unique type names, and the order of docstrings.

Imports inside functions and under TYPE_CHECKING count.
"""

import ast
import re
import tomllib
from collections.abc import Iterable, Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "exactsweep"

RULES = tomllib.loads((Path(__file__).parent / "packages.toml").read_text("utf-8"))


def expand(names: Iterable[str]) -> set[str]:
    """Resolve the names of groups of packages."""
    groups = RULES["groups"]
    return {
        package
        for name in names
        for package in (expand(groups[name]) if name in groups else {name})
    }


@cache
def parse(source: str) -> ast.Module:
    """Parse a source, once."""
    return ast.parse(source)


@cache
def statements(source: str) -> list[ast.stmt]:
    """List all statements of a source, at any depth, without their expressions."""
    found: list[ast.AST] = [parse(source)]
    for node in found:
        for field in ("body", "orelse", "handlers", "finalbody", "cases"):
            found += getattr(node, field, ())
    return [node for node in found if isinstance(node, ast.stmt)]


def modules() -> dict[str, Path]:
    """Map the dotted names of all modules to their files."""
    named = {
        ".".join(path.relative_to(PACKAGE).with_suffix("").parts): path
        for path in PACKAGE.rglob("*.py")
    }
    return {name.removesuffix(".__init__") or name: path for name, path in named.items()}


def imported(source: str, known: set[str]) -> Iterator[str]:
    """Yield the modules of the package that a source imports."""
    for node in statements(source):
        if isinstance(node, ast.ImportFrom):
            assert node.level == 0, "imports are absolute"
            module = node.module or ""
            if module.partition(".")[0] != "exactsweep":
                continue
            inner = module.removeprefix("exactsweep").removeprefix(".")
            for alias in node.names:
                submodule = f"{inner}.{alias.name}".removeprefix(".")
                yield submodule if submodule in known else inner or "__init__"
        elif isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name.partition(".")[0] == "exactsweep":
                    yield alias.name.removeprefix("exactsweep").removeprefix(".") or "__init__"


def rule_of(module: str) -> str:
    """Return the innermost package of a module that has a rule."""
    parts = module.split(".")
    names = (".".join(parts[:k]) for k in range(len(parts), 0, -1))
    return next(name for name in names if name in RULES["packages"])


def broken(module: str, targets: Iterator[str]) -> Iterator[str]:
    """Describe the imports of a module that its package does not allow."""
    package = rule_of(module)
    rule = RULES["packages"][package]
    allowed = expand(rule["sees"])
    for target in targets:
        parts = target.split(".")
        if not allowed & {".".join(parts[:k]) for k in range(1, len(parts) + 1)}:
            yield f"{module} imports {target}, which {package} may not see: {rule['why']}"


@cache
def sources() -> dict[str, str]:
    """Return the sources of all modules of the package, by their names."""
    return {name: path.read_text(encoding="utf-8") for name, path in modules().items()}


@cache
def arrows() -> dict[str, set[str]]:
    """Return the modules that each module imports."""
    known = {*sources()}
    return {name: set(imported(source, known)) for name, source in sources().items()}


def circle(graph: dict[str, set[str]]) -> list[str]:
    """Return a cycle of a graph; empty if there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return [*error.args[1]]
    return []


def test_imports_are_allowed() -> None:
    complaints = [line for name, seen in arrows().items() for line in broken(name, iter(seen))]
    assert not complaints, "\n".join(complaints)


def test_modules_have_no_import_cycle() -> None:
    # Modules of a package do not import its __init__, which imports them.
    found = circle(arrows())
    assert not found, " -> ".join(found)


def test_packages_have_no_import_cycle() -> None:
    graph: dict[str, set[str]] = {}
    for name, seen in arrows().items():
        package = rule_of(name)
        graph.setdefault(package, set()).update({rule_of(other) for other in seen} - {package})
    found = circle(graph)
    assert not found, " -> ".join(found)


@pytest.mark.parametrize(
    ("module", "source", "complaint"),
    [
        ("check.verify", "from exactsweep.procedures.cc import merge_by_slope", "shares code"),
        ("check.verify", "def f():\n    from exactsweep.geometry import segment", "shares code"),
        ("geometry.polygon", "import exactsweep.procedures.chain", "nothing of sweeps"),
        ("formats.wkt", "from exactsweep import sweep", "do not sweep"),
        ("corpus.facts", "from exactsweep.paper.claim import Claim", "does not import its users"),
        ("procedures.mm", "from exactsweep.canvas.svg import svg", "nothing of pictures"),
    ],
)
def test_forbidden_imports_have_a_reason(module: str, source: str, complaint: str) -> None:
    (line,) = broken(module, imported(source, set(modules())))
    assert complaint in line


def test_cycles_are_found() -> None:
    assert {*circle({"a": {"b"}, "b": {"c"}, "c": {"b"}})} == {"b", "c"}


# The standalone checker is a single file by design.
MOST_LINES = {"check.standalone": 750}


def test_modules_are_short() -> None:
    assert len(list(PACKAGE.glob("*.py"))) <= 6
    long = [
        name
        for name, source in sources().items()
        if len(source.splitlines()) > MOST_LINES.get(name, 400)
    ]
    assert not long


def named_types(source: str) -> Iterator[str]:
    """Yield the classes and type aliases of a source, without leading underscores."""
    for node in statements(source):
        if isinstance(node, ast.ClassDef):
            yield node.name.lstrip("_")
    for node in parse(source).body:
        if isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = [ast.unparse(target).lstrip("_") for target in targets]
            # Constants are in capitals, variables in small letters.
            yield from (name for name in names if name[:1].isupper() and not name.isupper())


def namesakes(sources: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Return the names shared by several types, each with the modules."""
    homes: dict[str, list[str]] = {}
    for module, source in sources:
        for name in named_types(source):
            homes.setdefault(name, []).append(module)
    return {name: places for name, places in homes.items() if len(places) > 1}


def test_type_names_are_unique() -> None:
    # The standalone checker is exempt.
    found = namesakes(item for item in sources().items() if item[0] not in MOST_LINES)
    assert not found, found


def test_duplicate_type_names_are_found() -> None:
    one = "class Ring: ...\n"
    other = "LIMIT = 3\n_Ring = tuple[int, int]\nclass Loop:\n    class LIMIT: ...\n"
    third = "Loop: TypeAlias = list[int]\n"
    found = namesakes([("a", one), ("b", other), ("c", third)])
    assert found == {"Ring": ["a", "b"], "Loop": ["b", "c"]}


TREE = PACKAGE.parent
FOLDERS = ("exactsweep", "tests", "benchmarks")
SOURCES = [path for name in FOLDERS for path in TREE.glob(f"{name}/**/*.py")]
ORDER = (("Args", "Attributes"), ("Returns", "Yields"), ("Raises",), ("Cost",), ("Source",))
EXAMPLE = "Example"
HEADING = re.compile(r"([A-Z]\w+):(\s|$)")


def misplaced(docstring: str) -> str:
    """Return the first line of a docstring that is out of order or unknown."""
    ranks = {name: rank for rank, names in enumerate(ORDER) for name in names}
    ranks[EXAMPLE] = len(ORDER)
    reached = 0
    for line in docstring.splitlines()[1:]:
        heading = HEADING.match(line)
        name = heading[1] if heading else EXAMPLE if line.startswith(">>>") else ""
        if name:
            if ranks.get(name, -1) < reached:
                return line
            reached = ranks[name]
    return ""


def docstrings(source: str) -> Iterator[tuple[str, str]]:
    """Yield the first line of a module, and docstrings of its classes and functions, by name."""
    yield "module", (ast.get_docstring(parse(source)) or "").partition("\n")[0]
    for node in statements(source):
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            yield node.name, ast.get_docstring(node) or ""


def test_docstrings_keep_one_order() -> None:
    # The order: summary, arguments, results, errors, cost, source, example.
    found = [
        f"{path.relative_to(TREE)}: {name}: {line}"
        for path in SOURCES
        for name, text in docstrings(path.read_text(encoding="utf-8"))
        if (line := misplaced(text))
    ]
    assert not found, "\n".join(found)


@pytest.mark.parametrize(
    ("docstring", "line"),
    [
        ("Loops.\n\nArgs:\n    a: one.\n\nReturns:\n    Two.\n\nCost: O(n).\n\n>>> f(1)\n2", ""),
        ("Loops.\n\nReturns:\n    Two.\n\nArgs:\n    a: one.", "Args:"),
        ("Loops.\n\nExample:\n    >>> f(1)\n    2\n\nCost: O(n).", "Cost: O(n)."),
        ("Loops.\n\n>>> f(1)\n2\n\nRaises:\n    Error: no.", "Raises:"),
        ("Loops.\n\nNote: beware.", "Note: beware."),
    ],
)
def test_docstrings_out_of_order_are_found(docstring: str, line: str) -> None:
    assert misplaced(docstring) == line
