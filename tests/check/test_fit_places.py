"""Places of possible exact fits, with very fine lattices, and without any."""

from fractions import Fraction
from importlib import import_module
from typing import Any

import pytest

from exactsweep import Polygon, PolygonError, sweep
from exactsweep.check import point_in_polygon, size, verify
from exactsweep.check.fits import count_pairs, find_places, list_exact_fits
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.check.shape import bring_to_integers
from exactsweep.check.sums import count_steps
from exactsweep.numbers.point import ORIGIN

# Two slots above, one below, each of width 1.
PLATE = [(0, 0), (3, 0), (3, 2), (4, 2), (4, 0), (9, 0), (9, 7), (7, 7), (7, 5), (6, 5), (6, 7)]
PLATE += [(2, 7), (2, 4), (1, 4), (1, 7), (0, 7)]
FRAME = NodeFrame((1, 0), 1)
PART = [(0, 0), (1, 0), (1, 1), (0, 1)]
FITS: list[Any] = [((1, 7), (1, 4)), ((3, -1), (3, 1)), ((6, 7), (6, 5))]


def test_fits_are_sorted_and_pairs_counted() -> None:
    """Below, D falls at 0 and 4 and rises at 3 and 9; turned, above, it falls at -9, -6 and -1,
    say, and rises at -7, -2 and 0. The part falls and rises once each."""
    d, g = (
        MonotoneLoop(FRAME.enter(Polygon(ring).vertices, ORIGIN), "loop", FRAME)
        for ring in (PLATE, PART)
    )
    inverse = g.turn_half()
    assert count_pairs(d, inverse) == 2 + 2 + 3 + 3
    # A sum of a fall of D and of one of the part, and of a rise of D and of one of the part.
    assert sorted((p.sign, p.x) for p in find_places(d, inverse)) == [(-1, -6), (-1, -1), (1, 3)]
    assert list_exact_fits(reversed(find_places(d, inverse)), FRAME) == FITS
    assert list_exact_fits(find_places(d, inverse), FRAME) == FITS
    two = d.turn_half()
    assert count_pairs(d, two) == 2 * 3 * 4
    # Falls 4 and -1, rises 3 and 0, an end.
    assert sorted((p.sign, p.x) for p in find_places(d, two)) == [(-1, 3), (1, 3)]


@pytest.mark.parametrize("over", [1, 2, 3])
def test_fits_are_proved_without_a_lattice(over: int, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("_SHORT", "_FEW"):
        monkeypatch.setattr(size, name, 0)
    d, g = ([(Fraction(x, over), Fraction(y, over)) for x, y in ring] for ring in (PLATE, PART))
    s = sweep(g, d)
    assert len(s.exact_fits) == 3
    assert verify(s.certificate()) == (True, "proved", None)


def test_places_are_looked_for_only_if_their_pairs_are_allowed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The steps are those of three sums, the pairs, each place along both, and the points, each
    with numbers of 11 words; and the area."""
    s = sweep(*([(x << 640, y << 640) for x, y in ring] for ring in (PART, PLATE)))
    d, g, t, inner, outer = (
        MonotoneLoop(FRAME.enter(p.vertices, ORIGIN), "loop", FRAME)
        for p in (s.directrix, s.generatrix, s.trajectory, s.inner, s.outer)
    )
    inverse = g.turn_half()
    sums = [(t, d, inverse), (outer, t, g), (t, inner, inverse)]
    points = sum(len(loop.nodes) for loop in (d, g, t, inner, outer))
    before = sum(count_steps(*loops) for loops in sums) + count_pairs(d, inverse) + points
    least, steps = (11 * n + 1 for n in (before, before + 3 * (len(d.nodes) + len(g.nodes))))
    certificate = s.certificate()
    assert verify(certificate, max_steps=steps).proved
    assert verify(certificate, max_steps=steps - 1).reason.startswith("too large")

    def find_none(*_: Any) -> Any:
        raise LookupError

    monkeypatch.setattr(import_module("exactsweep.check.verify"), "find_places", find_none)
    assert verify(certificate, max_steps=least - 1).reason.startswith("too large")
    with pytest.raises(LookupError):
        verify(certificate, max_steps=least)


@pytest.mark.parametrize("power", [1, 8191, 8192, 8300])
def test_shapes_come_to_integers_however_fine(power: int) -> None:
    """Beyond 8,192 bits a polygon by itself stays what it is."""
    triangle = Polygon([(0, 0), (Fraction(1, 2**power), 0), (3, 5)])
    other = Polygon([(0, 0), (Fraction(1, 2**8191), 0), (0, 1)])
    scale, ((one,), (two,)) = bring_to_integers([(triangle.vertices,), (other.vertices,)])
    assert scale == 2 ** max(power, 8191)
    for ring, polygon in ((one, triangle), (two, other)):
        assert all(isinstance(c, int) for p in ring for c in p)
        assert [(Fraction(x, scale), Fraction(y, scale)) for x, y in ring] == [*polygon.vertices]


def test_what_has_an_exterior_alone_is_no_region() -> None:
    class Bag:
        exterior = PART

    with pytest.raises(PolygonError):
        point_in_polygon((0, 0), Bag())
