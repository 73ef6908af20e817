"""The claims of certificates, in the format of `check/CERTIFICATES.md`.

A claim is a question and its answer, still in Fractions; `proof.add_proof` makes it a certificate.
Positions are translations of the moving polygon.

>>> from exactsweep import sweep
>>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
>>> certificate = sweep(square, square).certificate()
>>> certificate["claim"], certificate["area"], certificate["proof"]["sums"]
('sweep', '8', [[0, [[-1], [-2], [-3], [-4]]]])
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.number import Fit, Point

HEADER = {"format": "exactsweep certificate", "version": 3}


def claim_no_fit(
    directrix: Region,
    generatrix: Region,
    exterior: Polygon,
    holes: Iterable[Polygon],
    exact_fits: Iterable[Fit],
) -> dict[str, Any]:
    """Claim a no-fit polygon."""
    return {
        **HEADER,
        "claim": "no_fit",
        "directrix": _list_rings(directrix),
        "generatrix": _list_rings(generatrix),
        "exterior": exterior.vertices,
        "holes": [hole.vertices for hole in holes],
        "exact_fits": list(exact_fits),
    }


def claim_sweep(
    no_fit: dict[str, Any],
    inner: Polygon,
    outer: Polygon,
    unswept: Iterable[Polygon],
    area: Fraction,
) -> dict[str, Any]:
    """Claim a swept area, given the claim of the no-fit polygon."""
    return {
        **no_fit,
        "claim": "sweep",
        "inner": inner.vertices,
        "outer": outer.vertices,
        "unswept": [loop.vertices for loop in unswept],
        "area": area,
    }


def claim_sum(shape: Region, path: Iterable[Point], found: Region) -> dict[str, Any]:
    """Claim the sum of a shape and a path; a closed path repeats its first point."""
    question = {"shape": _list_rings(shape), "path": list(path)}
    return {**HEADER, "claim": "sum", **question, **_list_rings(found)}


def claim_inner_fit(
    container: Region, part: Region, regions: Iterable[Region], exact_fits: Iterable[Fit]
) -> dict[str, Any]:
    """Claim an inner fit."""
    return {
        **HEADER,
        "claim": "inner_fit",
        "container": _list_rings(container),
        "part": _list_rings(part),
        "regions": [_list_rings(region) for region in regions],
        "exact_fits": list(exact_fits),
    }


def _list_rings(region: Region) -> dict[str, Any]:
    exterior, *holes = region.rings
    return {"exterior": exterior, "holes": holes}
