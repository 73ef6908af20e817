"""Letting the garbage collector rest."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def resting() -> Iterator[None]:
    """Keep the collector from running while many objects are made that refer to one another.

    It looks for cycles among all objects whenever their number has grown by a part.  The kernel
    makes none, but 100,000 vertices make it look so often that this takes half of the time.
    """
    if not gc.isenabled():
        yield
        return
    gc.disable()
    try:
        yield
    finally:
        gc.enable()
