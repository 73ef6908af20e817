"""The API reference: every public name says what it is, and pdoc has nothing to complain of."""

import importlib
import inspect
import pkgutil
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest
from command import PATIENCE

import exactsweep
from exactsweep.cli.reference import MODULES, front
from exactsweep.lessons import list_titles as read_lessons


def public_names(module: ModuleType) -> list[str]:
    """Return the names that a module exports, or that it defines itself and does not hide."""
    exported = getattr(module, "__all__", None)
    if exported is not None:
        return list(exported)
    return [
        name
        for name, value in vars(module).items()
        if not name.startswith("_") and getattr(value, "__module__", None) == module.__name__
        if inspect.isclass(value) or inspect.isroutine(value)
    ]


def summary(value: object) -> str:
    return (inspect.getdoc(value) or "").partition("\n")[0]


@pytest.mark.parametrize("name", MODULES)
def test_every_public_name_has_a_summary(name: str) -> None:
    module = importlib.import_module(name)
    assert re.search(r"\w.*[.!]$|\w.*:$", summary(module)), name
    for public in public_names(module):
        value = getattr(module, public)
        if not (inspect.isclass(value) or inspect.isroutine(value)):
            continue
        assert re.search(r"\w.*\w", summary(value)), f"{name}.{public}"
        if inspect.isclass(value) and value.__module__.startswith("exactsweep"):
            for member, inner in vars(value).items():
                shown = inspect.isroutine(inner) or isinstance(inner, property)
                if shown and not member.startswith("_"):
                    assert summary(inner), f"{name}.{public}.{member}"


def test_every_public_function_is_in_an_example() -> None:
    root = Path(exactsweep.__file__).parent
    texts = [
        path.read_text(encoding="utf-8")
        for path in [root.parent / "README.md", *root.rglob("*.md"), *root.rglob("*.py")]
    ]
    examples = re.findall(r"^ *(?:>>>|\.\.\.) (.*)$", "\n".join(texts), re.M)
    used = set(re.findall(r"\w+", "\n".join(examples)))
    missing = [
        f"{name}.{public}"
        for name in MODULES
        for module in [importlib.import_module(name)]
        for public in public_names(module)
        if inspect.isroutine(getattr(module, public)) and public not in used
    ]
    assert not missing


def test_every_module_with_exports_is_in_the_reference() -> None:
    found = {
        module.name
        for module in pkgutil.iter_modules(exactsweep.__path__, "exactsweep.")
        if module.ispkg and hasattr(importlib.import_module(module.name), "__all__")
    }
    assert found <= set(MODULES)
    for name in MODULES:
        module = importlib.import_module(name)
        assert all(hasattr(module, public) for public in public_names(module)), name


def test_the_first_page_says_what_each_module_is() -> None:
    shown = front().splitlines()
    for name in MODULES[1:]:
        assert f"- `{name}`: {summary(importlib.import_module(name))}" in shown
    assert [line for line in shown if line.startswith("# ")][:2] == ["# Modules", "# Lessons"]


@pytest.mark.long
def test_the_reference_is_made_without_a_warning(tmp_path: Path) -> None:
    command = [sys.executable, "-W", "error", "-m", "exactsweep.cli.reference", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    for name in MODULES:
        page = (tmp_path / Path(*name.split("."))).with_suffix(".html").read_text(encoding="utf-8")
        assert 'README.md"' not in page, f"{name}: a link to a file without a page"
        module = importlib.import_module(name)
        for public in public_names(module):
            if not inspect.ismodule(getattr(module, public)):
                assert f'id="{public}"' in page, f"{name}.{public}"
        for folder in getattr(module, "__path__", ()):
            if (readme := Path(folder, "README.md")).exists():
                title = readme.read_text(encoding="utf-8").partition("\n")[0].removeprefix("# ")
                assert f">{title}</h1>" in page, name
    front = (tmp_path / "exactsweep.html").read_text(encoding="utf-8")
    for path in tmp_path.rglob("*.html"):
        for link in re.findall(r'href="([^"#:$]+)(?:#[^"]*)?"', path.read_text(encoding="utf-8")):
            assert (path.parent / link).is_file(), (path.name, link)
        if path.name not in ("index.html", "exactsweep.html"):
            assert f'href="{path.relative_to(tmp_path).as_posix()}"' in front, path
    assert 'id="platforms"' in front
    # The README of a package links to that of another.
    corpus = (tmp_path / "exactsweep" / "corpus.html").read_text(encoding="utf-8")
    assert '<a href="layout.html">layouts</a>' in corpus
    lessons = tmp_path / "exactsweep" / "lessons"
    for lesson in read_lessons():
        text = (lessons / f"{lesson}.html").read_text(encoding="utf-8")
        assert "<h1" in text
        assert "{{" not in text
    assert "<svg" in (lessons / "tour.html").read_text(encoding="utf-8")
