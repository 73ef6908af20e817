"""No-fit polygons of SVGnest and Deepnest by Clipper, in node.

Promise: doubles, as integers in units of 10^-7; the largest ring of the sum of the boundaries.

Questions: `minkowskiDifference(D, G)` of SVGnest, and `getOuterNfp(D, G)` of Deepnest, without
holes; Deepnest's compiled addon for holes is not tested. The answer is the path of G's first
vertex, converted to that of the origin.

The environment variables EXACTSWEEP_SVGNEST and EXACTSWEEP_DEEPNEST name the folders with the
source, which `nest.js` loads.
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import Any

from benchmarks.peers.adapters.adapter import Adapter, AskedShape, refer
from benchmarks.peers.adapters.program import Program, find_node, write_shape
from exactsweep.conform.run.protocol import Hello

SCRIPT = Path(__file__).with_name("nest.js")
SOURCES = {"svgnest": "svgnest.js", "deepnest": "main/background.js"}


def adapter(name: str) -> Adapter:
    """Make the adapter of either program."""
    project = name.partition("-")[0]
    version, program = start(project, "clipper")

    def ask(part: str, directrix: AskedShape, generatrix: AskedShape) -> dict[str, Any]:
        line = f"{part} {write_shape(directrix, repr)} {write_shape(generatrix, repr)}"
        (ring,) = program.ask(line)
        return {part: refer(ring, generatrix[0][0])}

    title = f"{'SVGnest' if project == 'svgnest' else 'Deepnest'} {version}, Clipper"
    hello = Hello(title, ("trajectory",), "binary64", "origin", ("sweep",), "simple")
    return Adapter(hello, ask, program.close)


def start(project: str, way: str) -> tuple[str, Program]:
    """Return a digest of a project's source as its version, and the program that runs it."""
    variable, source = f"EXACTSWEEP_{project.upper()}", SOURCES[project]
    node, folder = find_node(project, variable, source, "the folder of its source")
    digest = hashlib.sha256(Path(folder, source).read_bytes()).hexdigest()[:8]
    return f"of sha256 {digest}", Program([node, str(SCRIPT), project, way, str(folder)])
