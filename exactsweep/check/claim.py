"""Certificates for polygons of any shape as they come in: a claim, read into exact numbers.

The key `claim` of a certificate names one of these:

    no_fit      directrix, generatrix; exterior, holes, exact_fits: translations of the generatrix
    inner_fit   container, part; regions, exact_fits: translations of the part
    sweep       as no_fit, and kind, inner, outer, unswept, area: the area swept along the exterior

Shapes, and regions of translations, are objects with `exterior` and `holes`; loops are lists of
points, points are pairs of rationals in strings, exact fits pairs of points.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep.check.certificate import (
    CertificateError,
    KeyPath,
    check_keys,
    flaw,
    is_exactly,
    read_fit,
    read_list,
    read_loop,
    read_number,
)
from exactsweep.numbers.point import Fit, Loop


class ClaimedShape(NamedTuple):
    """A polygon with holes, not checked yet."""

    exterior: Loop
    holes: tuple[Loop, ...]


class NoFitClaim(NamedTuple):
    """All positions at which G touches D without overlap: loops, and exact fits."""

    directrix: ClaimedShape
    generatrix: ClaimedShape
    exterior: Loop
    holes: tuple[Loop, ...]
    exact_fits: tuple[Fit, ...]


class InnerFitClaim(NamedTuple):
    """All positions of a part inside a container: regions, and exact fits."""

    container: ClaimedShape
    part: ClaimedShape
    regions: tuple[ClaimedShape, ...]
    exact_fits: tuple[Fit, ...]


class SweepClaim(NamedTuple):
    """A no-fit polygon, and what G sweeps along its exterior."""

    no_fit: NoFitClaim
    inner: Loop
    outer: Loop
    unswept: tuple[Loop, ...]
    area: Fraction


ShapeClaim = NoFitClaim | InnerFitClaim | SweepClaim

_SWEPT = ("kind", "inner", "outer", "unswept", "area")
_KEYS = {
    "no_fit": NoFitClaim._fields,
    "inner_fit": InnerFitClaim._fields,
    "sweep": NoFitClaim._fields + _SWEPT,
}


def read_claim(certificate: dict[Any, Any]) -> ShapeClaim:
    """Read a certificate that has the key `claim`.

    Returns:
        NoFitClaim, InnerFitClaim or SweepClaim.

    Raises:
        CertificateError: naming the key and the place in it.

    Cost: linear in the length of the input, for numbers of bounded length.
    """
    name = next((name for name in _KEYS if is_exactly(certificate["claim"], str, name)), None)
    if name is None:
        raise CertificateError(f"claim is not {', '.join(_KEYS)}")
    check_keys(certificate, ("claim", *_KEYS[name]))
    shapes = ("container", "part") if name == "inner_fit" else ("directrix", "generatrix")
    d, g = (_read_shape(certificate[key], key) for key in shapes)
    fits = read_list(certificate["exact_fits"], "exact_fits", read_fit)
    if name == "inner_fit":
        return InnerFitClaim(d, g, read_list(certificate["regions"], "regions", _read_shape), fits)
    exterior = read_loop(certificate["exterior"], "exterior")
    no_fit = NoFitClaim(d, g, exterior, _loops(certificate["holes"], "holes"), fits)
    if name == "no_fit":
        return no_fit
    if not is_exactly(certificate["kind"], str, "SS"):
        raise CertificateError("kind is not SS")
    inner, outer = (read_loop(certificate[k], k) for k in ("inner", "outer"))
    unswept = _loops(certificate["unswept"], "unswept")
    return SweepClaim(no_fit, inner, outer, unswept, read_number(certificate["area"], "area"))


def _loops(item: Any, place: KeyPath) -> tuple[Loop, ...]:
    return read_list(item, place, read_loop)


def _read_shape(item: Any, place: KeyPath) -> ClaimedShape:
    if type(item) is not dict or item.keys() != {"exterior", "holes"}:
        raise flaw(place, "not an object of exterior and holes")
    exterior = read_loop(item["exterior"], (place, ".exterior"))
    return ClaimedShape(exterior, _loops(item["holes"], (place, ".holes")))
