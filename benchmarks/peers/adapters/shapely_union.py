"""shapely: the union of sums of triangles, on GEOS.

Promise: coordinates are binary64, and new vertices of a union are rounded; GEOS' overlay
(OverlayNG) gives valid polygons, its result being exact except for that rounding where no heuristic
has to come in. It has no Minkowski sum: this is the usual recipe.

Question: D and -G are cut into triangles (`constrained_delaunay_triangles`, no new
vertices), each two of them summed as the convex hull of the nine sums of their vertices, and the
hulls united by `union_all`, without a grid. All is shapely's arithmetic, except for the sums of
two vertices, which are rounded as binary64 rounds them.
"""

from __future__ import annotations

from benchmarks.peers.adapters.adapter import Adapter, AnsweredRings, AskedShape, sum_adapter


def adapter(name: str) -> Adapter:
    """Return the adapter.

    Raises:
        ImportError: it is not installed.
    """
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
