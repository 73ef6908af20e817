"""Outlines of parts from the corpus, with integer coordinates."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from math import lcm

from exactsweep import Polygon
from exactsweep.corpus import cases
from exactsweep.corpus.generator.shapes import Ring


def list_outlines(families: Collection[str]) -> Iterator[tuple[str, tuple[Ring, Ring]]]:
    """Yield the pairs without holes from themes of the corpus, as generatrix and directrix."""
    for case in cases():
        family = case.id.partition("-")[0]
        if family in families and not (case.directrix_holes or case.generatrix_holes):
            polygons = Polygon(case.generatrix_ring), Polygon(case.directrix_ring)
            scale = lcm(*(polygon.lattice()[0] for polygon in polygons))
            g, d = ([(int(scale * x), int(scale * y)) for x, y in p.vertices] for p in polygons)
            yield family, (g, d)
