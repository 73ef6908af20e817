"""The claims of the paper, with a verdict and evidence for each; see README.md."""

import tomllib
from importlib.resources import files
from typing import Any


def read_toml(path: str) -> dict[str, Any]:
    """Read a file, with a path such as "checks/containers.toml"."""
    return tomllib.loads(files("exactsweep.paper").joinpath(path).read_text(encoding="utf-8"))
