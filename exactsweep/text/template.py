"""The jinja2 environment."""

from __future__ import annotations

from typing import TYPE_CHECKING

# jinja2 is slow to import.
if TYPE_CHECKING:
    from jinja2 import BaseLoader, Environment


def make_environment(loader: BaseLoader | None = None, *, html: bool = True) -> Environment:
    """Make an environment that rejects undefined names and strips tag lines."""
    from jinja2 import Environment, StrictUndefined

    return Environment(
        loader=loader,
        autoescape=html,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
