"""SVGnest and Deepnest: the path of their no-fit polygons through Clipper, run by node.

Promise: doubles, as integers in units of 10^-7; of the sum of the boundaries the largest
ring, so no holes.

Questions: `minkowskiDifference(D, G)` of SVGnest, and `getOuterNfp(D, G)` of Deepnest,
both without holes; Deepnest has another program for these, an addon to be compiled, which is not
asked. The answer is the path of G's first vertex, from which that of the origin follows.

Their source is the user's, in the folders that the environment variables EXACTSWEEP_SVGNEST and
EXACTSWEEP_DEEPNEST name; `nest.js` in this folder loads it as it is.
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
    """Return the adapter of either.

    Raises:
        MissingError: there is no node, or its source is not to be found.
    """
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
    """Return a short digest of a project's source, for a version, and the program that runs it.

    Raises:
        MissingError: there is no node, or the source is not to be found.
    """
    variable, source = f"EXACTSWEEP_{project.upper()}", SOURCES[project]
    node, folder = find_node(project, variable, source, "the folder of its source")
    digest = hashlib.sha256(Path(folder, source).read_bytes()).hexdigest()[:8]
    return f"of sha256 {digest}", Program([node, str(SCRIPT), project, way, str(folder)])
