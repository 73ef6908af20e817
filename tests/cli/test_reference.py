"""The API reference: every public name has a docstring, and pdoc gives no warning."""

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

MODULES = [
    "exactsweep",
    *(
        module.name
        for module in pkgutil.iter_modules(exactsweep.__path__, "exactsweep.")
        if module.ispkg and hasattr(importlib.import_module(module.name), "__all__")
    ),
]


def public_names(module: ModuleType) -> list[str]:
    """Return the names that a module exports, or else the public names that it defines."""
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


def test_every_exported_name_exists() -> None:
    for name in MODULES:
        module = importlib.import_module(name)
        assert all(hasattr(module, public) for public in public_names(module)), name


@pytest.mark.long
def test_the_command_of_the_readme_makes_the_reference(tmp_path: Path) -> None:
    readme = Path(exactsweep.__file__).parents[1].joinpath("README.md").read_text("utf-8")
    (line,) = re.findall(r"pdoc (.*) -o reference (.*)$", readme, re.M)
    options, modules = (part.split() for part in line)
    assert modules == MODULES
    command = [sys.executable, "-m", "pdoc", *options, "-o", str(tmp_path), *modules]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr
    for name in MODULES:
        page = (tmp_path / Path(*name.split("."))).with_suffix(".html").read_text(encoding="utf-8")
        module = importlib.import_module(name)
        for public in public_names(module):
            if not inspect.ismodule(getattr(module, public)):
                assert f'id="{public}"' in page, f"{name}.{public}"
