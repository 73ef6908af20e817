"""Adapters of other programs, to be judged if they are installed.

Programs that compute Minkowski sums are asked for the sum of D and -G, orbiting programs for the
path of G. D and G go in as the case has them, collinear
vertices included, but counter-clockwise, holes clockwise, and without repeated vertices, which
several of the programs require. The adapters return every ring of an answer, with nothing removed,
joined or rounded, unless the module of the adapter says so.

As a function: `load`. As a process that speaks the protocol of `exactsweep conform`:

    exactsweep conform -- python -m benchmarks.peers.adapters shapely
"""

from benchmarks.peers.adapters.adapter import Adapter, MissingError
from benchmarks.peers.adapters.names import NAMES, load

__all__ = ["NAMES", "Adapter", "MissingError", "load"]
