"""Minkowski sums by shapely and GEOS: unions of sums of triangles.

Promise: doubles; new vertices of a union are rounded. OverlayNG in GEOS returns valid polygons. It
has no Minkowski sum; this is the usual substitute.

Question: D and -G are triangulated by `constrained_delaunay_triangles`. The sum of two triangles is
the convex hull of the sums of their vertices. `union_all` unites the hulls.
"""

from __future__ import annotations

from benchmarks.peers.adapters.adapter import Adapter, AnsweredRings, AskedShape, sum_adapter


def adapter(name: str) -> Adapter:
    import numpy as np
    import shapely

    def triangles(shape: AskedShape) -> object:
        exterior, *holes = shape
        parts = shapely.constrained_delaunay_triangles(shapely.Polygon(exterior, holes)).geoms
        return np.array([part.exterior.coords[:3] for part in parts])

    def add(directrix: AskedShape, inverse: AskedShape) -> AnsweredRings:
        first, second = triangles(directrix), triangles(inverse)
        sums = first[:, None, :, None, :] + second[None, :, None, :, :]  # type: ignore[index]
        hulls = shapely.convex_hull(shapely.multipoints(sums.reshape(-1, 9, 2)))
        united = shapely.union_all(hulls)
        return [
            [(float(x), float(y)) for x, y in ring.coords]
            for part in shapely.get_parts(united)
            if part.geom_type == "Polygon"
            for ring in (part.exterior, *part.interiors)
        ]

    version = f"shapely {shapely.__version__}, GEOS {shapely.geos_version_string}"
    return sum_adapter(version, "binary64", add, shapes="any")
