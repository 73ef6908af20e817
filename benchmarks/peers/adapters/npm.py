"""The npm packages clipper2-ts, js-angusj-clipper, polygon-clipping and convex-minkowski-sum.

Promise: clipper2-ts and js-angusj-clipper are Clipper2 and Clipper on integers within doubles;
crossings are rounded to integers. polygon-clipping computes unions of doubles with exact
predicates. convex-minkowski-sum accepts convex polygons.

Questions: `minkowskiSum` of -G and D by the two Clippers, scaled to integers, together with
`list_fillings` if it has a hole or a ring touches itself; the union of the sums of all pairs of
edges, and of `list_fillings`, by polygon-clipping; and the vertices of convex-minkowski-sum, which
`npm.js` sorts.

The environment variable EXACTSWEEP_NPM names the folder with the packages; `package.json` lists the
judged versions.
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
    package = f"node_modules/{name}/package.json"
    what = f"a folder with the installed packages of {SCRIPT.with_name('package.json')}"
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
