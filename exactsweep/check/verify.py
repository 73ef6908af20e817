"""Proving a certificate from the definition alone.

`standalone`, the checker that anyone can carry away, proves layouts and sweeps of polygons with a
shared direction. Where a certificate has the key `claim`, it is about polygons of any shape, and
`claim` proves it by finding the answer again; with a `proof` in it `standalone` proves it, too.
"""

from __future__ import annotations

from itertools import chain
from typing import Any, NamedTuple

from exactsweep.check.claim import prove_claim
from exactsweep.check.standalone import Refused, Ring, Work, check_given, node, prove
from exactsweep.numbers.error import ExactSweepError, tells_arguments
from exactsweep.numbers.number import Point, to_fraction

# About a microsecond each.
_MAX_STEPS = 10**8
_PLAIN = {str, int, float, bool, type(None), dict, list}


class Verification(NamedTuple):
    """The verdict on a certificate: proved, or the first thing that is wrong with it.

    The witness, if there is one, is a point of the loop or edge that the reason speaks of, or in
    its way. For the trajectory, contacts and exact fits it is a translation of G, without regard to
    the reference point; so it is where the reason has G moved into the inner loop.
    """

    proved: bool
    reason: str
    witness: Point | None


@tells_arguments
def verify(
    certificate: Any,
    *,
    generatrix: Any = None,
    directrix: Any = None,
    part: Any = None,
    container: Any = None,
    max_steps: int = _MAX_STEPS,
) -> Verification:
    """Decide whether a certificate proves its answer, from the definition alone.

    Args:
        certificate: as `json.loads` gives it, from any source. With a `proof`, the checker that
            stands alone has to prove it, too; layouts are proved by that alone.
        generatrix: the polygon G that the certificate should be about: a Polygon, its vertices or a
            Region. If left out, the certificate may be about any.
        directrix: D, likewise.
        part: that of an inner fit, likewise.
        container: likewise.
        max_steps: the most work to do, in steps of about a microsecond. A certificate that needs
            more is not proved. `verify` refuses it, at the latest after that many steps.

    Returns:
        Verification. The reason is "proved", or says which loop, edge or list is wrong. No
        certificate makes `verify` raise an exception.

    Raises:
        ExactSweepError: a polygon that is none, or `max_steps` that is no int above 0.

    Cost: with m and n edges, O((m + n) log(m + n)) for convex polygons. For others with a shared
        direction, the edges of sums of convex parts, and those of the loop that holds them at the
        same x; parts without a common slope take a step. For polygons of any shape that of
        `reference_no_fit` and its like, by pieces that meet.
    Source: Definitions 1.1 to 1.3, Theorems 2.1 and 2.2, Lemma 5.3 as far as it holds.

    >>> verify({"format": "exactsweep certificate"})
    Verification(proved=False, reason='version: not 2', witness=None)
    """
    if type(max_steps) is not int or max_steps < 1:
        raise ExactSweepError("max_steps must be an int, at least 1")
    names = "generatrix", "directrix", "part", "container"
    asked = zip(names, (generatrix, directrix, part, container), strict=True)
    given = {name: _read_given(shape) for name, shape in asked if shape is not None}
    try:
        _check_types(certificate)
        is_claim = type(certificate) is dict and "claim" in certificate
        if is_claim:
            Work(max_steps).read(certificate)
            prove_claim(certificate, max_steps)
        if not is_claim or "proof" in certificate:
            prove(certificate, max_steps)
        for name, rings in given.items():
            check_given(certificate, name, rings)
    except Refused as flaw:
        seen = None if flaw.witness is None else Point(*flaw.witness)
        return Verification(False, str(flaw), seen)
    return Verification(True, "proved", None)


def _check_types(certificate: Any) -> None:
    """Refuse types that `json.loads` does not return: their methods could do anything."""
    level, seen = [certificate], set[int]()
    while level:
        for kind in {*map(type, level)} - _PLAIN:
            raise Refused(f"a {kind.__name__} is not JSON")
        # A list may hold itself.
        nested = {id(item): item for item in level if type(item) is list or type(item) is dict}
        new = [item for key, item in nested.items() if key not in seen]
        seen.update(nested)
        parts = ([*item, *item.values()] if type(item) is dict else item for item in new)
        level = [*chain.from_iterable(parts)]


def _read_given(shape: Any) -> list[Ring]:
    rings = (shape.exterior, *shape.holes) if hasattr(shape, "holes") else (shape,)
    try:
        return [
            [node(*map(to_fraction, p)) for p in getattr(points, "vertices", points)]
            for points in rings
        ]
    except TypeError:
        raise ExactSweepError(f"a {type(shape).__name__} is no polygon and no Region") from None
