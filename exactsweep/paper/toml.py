"""The data of the checks, figures and reports, next to the modules that use them."""

from __future__ import annotations

import tomllib
from importlib.resources import files
from typing import Any


def read_toml(path: str) -> dict[str, Any]:
    """Read a file of this package, such as "checks/containers.toml"."""
    return tomllib.loads(files("exactsweep.paper").joinpath(path).read_text(encoding="utf-8"))
