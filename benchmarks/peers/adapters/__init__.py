"""Adapters for judging other programs, if they are installed.

Programs for Minkowski sums compute D + (-G); orbiting programs compute the path of G. Exteriors are
counter-clockwise, holes clockwise, without repeated vertices, as several programs require. The
adapters return all rings of an answer unchanged, unless their docstring states otherwise.

`load` returns an adapter as a function. As a process:

    exactsweep conform -- python -m benchmarks.peers.adapters shapely
"""

from benchmarks.peers.adapters.adapter import Adapter, MissingError
from benchmarks.peers.adapters.names import NAMES, load

__all__ = ["NAMES", "Adapter", "MissingError", "load"]
