"""Straight angles in answers, repeated vertices and spikes in shapes: both checkers."""

import json
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import pytest
from certified import certificates, layout, with_faults
from checkers import check_agreement, needs_node
from falsify import ANSWERS, draw, draw_sums, is_loop, is_same_claim, list_places
from tampering import get, put

from exactsweep.check.standalone import prove
from exactsweep.evidence.proof import add_proof

Certificate = dict[str, Any]
LOOPS = (*ANSWERS, "regions")
SHAPES = "directrix", "generatrix", "container", "part", "shape"

pytestmark = needs_node


def draw_loop(certificate: Certificate, names: tuple[str, ...], rng: Random) -> tuple[Any, Any]:
    """Return the path to a random ring below some keys, and a copy with another first vertex."""
    places = [p for p in list_places(certificate) if p and p[0] in names]
    path = rng.choice([p for p in places if is_loop(get(certificate, p))])
    ring = get(certificate, path)
    k = rng.randrange(len(ring))
    return path, [*ring[k:], *ring[:k]]


def shift(p: Any, q: Any, share: Fraction) -> list[str]:
    """Return a point between two others."""
    return [
        str(Fraction(a) + (Fraction(b) - Fraction(a)) * share) for a, b in zip(p, q, strict=True)
    ]


def straighten(certificate: Certificate, rng: Random) -> Certificate:
    """Add a vertex with a straight angle to a loop."""
    path, loop = draw_loop(certificate, LOOPS, rng)
    changed: Certificate = put(certificate, path, [*loop, shift(loop[-1], loop[0], Fraction(1, 3))])
    return changed


def degrade(certificate: Certificate, rng: Random) -> Certificate:
    """Add a spike, a repeated vertex and a straight angle to a ring of a shape, or reverse it."""
    path, ring = draw_loop(certificate, SHAPES, rng)
    middle, tip = shift(ring[-1], ring[0], Fraction(1, 3)), shift(ring[0], ring[1], Fraction(-2))
    ring = [*ring, *rng.choice([[middle], [ring[-1]] * 2, [tip, ring[-1]], [middle, tip, middle]])]
    changed: Certificate = put(certificate, path, rng.choice([ring, ring[::-1]]))
    return changed


def bend(certificate: Certificate, rng: Random) -> Certificate:
    """Move the last vertex of a loop, or visit a vertex twice."""
    path, loop = draw_loop(certificate, LOOPS, rng)
    by = rng.choice([Fraction(1, 10**9), Fraction(1, 2), Fraction(-1, 10**9)])
    moved = [str(Fraction(n) + by) for n in loop[-1]]
    changed: Certificate = put(
        certificate, path, rng.choice([[*loop[:-1], moved], [*loop, moved, loop[-1]]])
    )
    return changed


def renew(claim: Certificate) -> Certificate:
    """Find a new proof, or keep the old one."""
    try:
        found: Certificate = json.loads(json.dumps(add_proof(claim)))
    except (ArithmeticError, LookupError, ValueError):  # the search for a proof may fail
        return claim
    return found


def drawn(rng: Random) -> Iterator[Certificate]:
    for _ in range(3):
        yield from (c for c in (*draw(rng), *draw_sums(rng)) if c.get("exterior"))
    yield from (certificates()[name] for name in ("cave", "inside", "CM", "path", "slit"))


@pytest.mark.parametrize("seed", [1, *(pytest.param(n, marks=pytest.mark.long) for n in "23456")])
def test_degenerate_rings_and_loops_are_proved_unless_changed(seed: int, tmp_path: Path) -> None:
    rng = Random(seed)
    plain = [*drawn(rng)]
    straight = [renew(straighten(straighten(c, rng), rng)) for c in plain]
    true = [*straight, *(degrade(degrade(c, rng), rng) for c in [*plain, *straight])]
    assert check_agreement(true, tmp_path) == len(true)
    bent = [(c, renew(bend(c, rng))) for c in straight]
    false = [b for c, b in bent if not is_same_claim(c, b)]
    assert len(false) > len(bent) / 2
    assert check_agreement(false, tmp_path) == 0


def test_a_part_may_touch_itself(tmp_path: Path) -> None:
    """Two triangles with a common vertex, as one ring, are a shape: a layout of it is valid."""
    low, high = [["0", "0"], ["2", "0"], ["1", "1"]], [["1", "1"], ["2", "2"], ["0", "2"]]
    part = {"id": "a", "exterior": [*low, *high[1:], high[0]]}
    true = layout([part], [{"part": "a", "move": ["0", "0"]}], [[low, high]], 2)
    fault = {"kind": "shape", "part": "a", "point": ["1", "1"]}
    assert check_agreement([true, with_faults(true, fault)], tmp_path) == 1
    assert prove(true)
