"""Packages of npm: clipper2-ts, js-angusj-clipper, polygon-clipping, convex-minkowski-sum, by node.

Promise: clipper2-ts and js-angusj-clipper are Clipper2 and Clipper on integers that a
double holds; vertices of the result are integers, so crossings are rounded. polygon-clipping has
unions on doubles, with predicates that are exact. convex-minkowski-sum takes convex polygons.

Questions: the two Clippers are asked for `minkowskiSum` of -G and D, times the scale that makes the
case integer, united with what fills it where it has a hole or a ring that may hide one;
polygon-clipping for the union of the sums of each two edges, and of what fills them;
convex-minkowski-sum for its corners, which `npm.js` puts in order.

They are the user's, in the folder that the environment variable EXACTSWEEP_NPM names; the versions
that were judged are those of `package.json` in this folder.
"""

from __future__ import annotations

import json
from pathlib import Path

from benchmarks.peers.adapters.adapter import (
    Adapter,
    AnsweredRings,
    AskedShape,
    require_range,
    sum_adapter,
)
from benchmarks.peers.adapters.program import Program, find_node, write_ring

SCRIPT = Path(__file__).with_name("npm.js")
MOST = 2**53 - 1


def adapter(name: str) -> Adapter:
    """Return the adapter of a package.

    Raises:
        MissingError: there is no node, or the package is not to be found.
    """
    package = f"node_modules/{name}/package.json"
    what = f"a folder in which npm has installed {SCRIPT.with_name('package.json')}"
    node, folder = find_node(name, "EXACTSWEEP_NPM", package, what)
    version = json.loads(Path(folder, package).read_text(encoding="utf-8"))["version"]
    running = Program([node, str(SCRIPT), name, str(folder)])
    is_clipper = "clipper" in name

    def add(directrix: AskedShape, inverse: AskedShape) -> AnsweredRings:
        if is_clipper:
            require_range(directrix, inverse, MOST)
        write = str if is_clipper else repr
        return running.ask(f"{write_ring(directrix[0], write)} {write_ring(inverse[0], write)}")

    return sum_adapter(
        f"{name} {version}",
        "int64" if is_clipper else "binary64",
        add,
        shapes="convex" if name == "convex-minkowski-sum" else "simple",
        close=running.close,
    )
