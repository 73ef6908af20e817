"""Adapters for judging other programs, if they are installed.

Programs for Minkowski sums compute D + (-G); orbiting programs compute the path of G. Several
programs require counter-clockwise exteriors and clockwise holes without repeated vertices, so all
adapters pass these. They return all rings of an answer unchanged, unless their docstring states
otherwise.

`load` returns an adapter as a function. As a process:

    exactsweep conform -- python -m benchmarks.peers.adapters shapely
"""

from benchmarks.peers.adapters.adapter import Adapter, MissingError
from benchmarks.peers.adapters.names import NAMES, load

__all__ = ["NAMES", "Adapter", "MissingError", "load"]
