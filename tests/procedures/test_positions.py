"""Polygons of any shape: known answers, counted squares, and the procedures of the paper."""

from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import Cells, Matrix, frame, free_cells, polyominoes, region, unit_edges
from strategies import pairs
from tiers import examples

from exactsweep import NoFitPolygon, Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.corpus import cases
from exactsweep.corpus.generator.cells import connect
from exactsweep.numbers.number import ORIGIN, Point, Vertex
from exactsweep.procedures.positions import find_inner_fit, find_no_fit

Ring = list[tuple[int, int]]
Fits = tuple[tuple[Point, Point], ...]


def box(left: int, low: int, right: int, high: int) -> Ring:
    return [(left, low), (right, low), (right, high), (left, high)]


def fits(*ends: tuple[int, int]) -> Fits:
    points = [Point(Fraction(x), Fraction(y)) for x, y in ends]
    return tuple(zip(points[::2], points[1::2], strict=True))


def computed(directrix: Region, generatrix: Region) -> NoFitPolygon:
    """Return the answer by contact segments, for any shapes."""
    return NoFitPolygon(directrix, generatrix, None, ORIGIN)


UNIT = box(0, 0, 1, 1)


def test_a_hole_of_the_same_size_is_a_single_position() -> None:
    n = no_fit_polygon(Region(box(-2, -2, 3, 3), [UNIT]), UNIT)
    assert (n.kind, n.holes, n.exact_fits) == ("SS", (), fits((0, 0), (0, 0)))
    assert n.exterior == Polygon(box(-3, -3, 3, 3))


def test_holes_come_in_order() -> None:
    chambers = [box(11, 1, 14, 4), box(1, 6, 4, 9), box(6, 1, 9, 4), box(1, 1, 4, 4)]
    plate: list[Sequence[Vertex]] = [box(0, 0, 15, 10)]
    plate += [chamber[::-1] for chamber in chambers]
    corners = [(int(x), int(y)) for (x, y), *_ in find_no_fit(plate, [UNIT]).within]
    assert corners == [(1, 1), (1, 6), (6, 1), (11, 1)]


def test_a_region_may_lie_in_the_hole_of_another() -> None:
    """A part around a defect of the container is not in the region around both."""
    container = Region(box(0, 0, 20, 20), [box(9, 9, 10, 10)])
    f = inner_fit_polygon(container, Region(box(0, 0, 5, 5), [box(1, 1, 4, 4)]))
    assert f.regions == (
        Region(box(0, 0, 15, 15), [box(4, 4, 10, 10)]),
        Region(box(6, 6, 8, 8)),
    )
    assert f.exact_fits == ()


# A cavity of 2 x 2 with a gap in its right wall, from y = 1 to at most 2.
GAPPED = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (3, 3), (3, 2), (4, 2), (4, 4), (0, 4)]


def test_a_cavity_with_an_exact_entry() -> None:
    n = no_fit_polygon(GAPPED, UNIT)
    assert n.holes == (Polygon(box(1, 1, 2, 2)),)
    # Through the gap, from the cavity to the outside; both ends lie on loops.
    assert n.exact_fits == fits((2, 1), (4, 1))


def test_defects_whose_loops_touch_in_a_point_stay_two_rings() -> None:
    plate = Region(box(0, 0, 10, 10), [box(3, 3, 4, 4), box(5, 5, 6, 6)])
    (found,) = inner_fit_polygon(plate, UNIT).regions
    assert found.holes == (Polygon(box(2, 2, 4, 4)), Polygon(box(4, 4, 6, 6)))


def test_three_loops_that_touch_at_two_points_stay_three_rings() -> None:
    """A single walk around them would pass each of the points twice."""
    defects = [box(5, 7, 6, 8), box(7, 5, 8, 6), box(9, 7, 10, 8)]
    (found,) = inner_fit_polygon(Region(box(0, 0, 13, 13), defects), UNIT).regions
    assert found.holes == tuple(map(Polygon, [box(4, 6, 6, 8), box(6, 4, 8, 6), box(8, 6, 10, 8)]))


def test_a_defect_whose_loop_touches_the_outer_one_at_a_point() -> None:
    diamond, part = [(2, 5), (3, 4), (4, 5), (3, 6)], [(0, 0), (2, 1), (0, 2)]
    (found,) = inner_fit_polygon(Region(box(0, 0, 10, 10), [diamond]), part).regions
    (hole,) = found.holes
    assert found.exterior == Polygon(box(0, 0, 8, 8))
    assert hole.vertices[0] == Point(Fraction(0), Fraction(4))


def test_a_fit_is_cut_at_the_corner_of_a_chamber() -> None:
    """A triangle on its tip fills a corridor; below a funnel it can also rise."""
    funnel = [(0, 0), (10, 0), (10, 1), (6, 1), (8, 3), (2, 3), (4, 1), (0, 1)]
    n = no_fit_polygon(Region(box(-1, -1, 11, 4), [funnel]), [(1, 0), (2, 1), (0, 1)])
    assert n.holes == (Polygon([(4, 0), (6, 2), (2, 2)]),)
    assert n.exact_fits == fits((4, 0), (0, 0), (4, 0), (8, 0))


def test_crossing_fits_are_not_split() -> None:
    """Through an opening as wide as G, accessible only from the corridor at (4, 0)."""
    corridor = [(0, 0), (10, 0), (10, 1), (5, 1), (6, 3), (3, 3), (4, 1), (0, 1)]
    n = no_fit_polygon(Region(box(-2, -2, 12, 5), [corridor]), UNIT)
    assert n.exact_fits == fits((0, 0), (9, 0), (4, 1), (4, 0))
    # In a cross-shaped hole, exact fits cross, without free positions next to the crossing.
    cross = [(2, 1), (3, 1), (3, 2), (4, 2), (4, 3), (3, 3), (3, 4), (2, 4), (2, 3), (1, 3)]
    n = no_fit_polygon(Region(box(0, 0, 5, 5), [[*cross, (1, 2), (2, 2)]]), UNIT)
    assert n.exact_fits == fits((1, 2), (3, 2), (2, 1), (2, 3))


def test_interlocked_links_have_a_single_position() -> None:
    """No edge of either can slide along the other: the defect and the wall touch at the origin."""
    wall = [(-20, -20), (20, -20), (20, -5), (0, 0), (20, 5), (20, 20), (-20, 20)]
    arms = [(-10, -10), (1, -10), (0, 0), (1, 10), (-10, 10)]
    gap = [(0, 0), (-1, 5), (-8, 5), (-8, -5), (-1, -5)]
    container = Region(wall, [[(0, 0), (-4, -1), (-4, 1)]])
    assert fits((0, 0), (0, 0))[0] in inner_fit_polygon(container, Region(arms, [gap])).exact_fits


def test_the_reference_point_moves_all() -> None:
    frame_ = Region(box(-2, -2, 7, 7), [box(0, 0, 4, 3)])
    n = no_fit_polygon(frame_, UNIT, reference=(1, "1/2"))
    assert n.holes == (Polygon(box(0, 0, 3, 2)).translated((1, "1/2")),)
    assert inner_fit_polygon(UNIT, UNIT, reference=(1, 1)).exact_fits == fits((1, 1), (1, 1))


@given(st.one_of(pairs("CC"), pairs("CM"), pairs("MM")))
def test_the_procedures_of_the_paper_agree(pair: tuple[Polygon, Polygon]) -> None:
    generatrix, directrix = pair
    s, n = sweep(generatrix, directrix), computed(Region(directrix), Region(generatrix))
    assert (n.exterior, n.holes, n.exact_fits) == (s.trajectory, (), s.exact_fits)


@pytest.mark.long
def test_answers_match_the_corpus() -> None:
    for case in cases(max_size=150):
        n = NoFitPolygon(Region(case.directrix), Region(case.generatrix), None, case.reference)
        assert (n.exterior, n.holes, n.exact_fits) == (
            case.trajectory,
            case.holes,
            case.exact_fits,
        ), case.id


SHEARS = [(1, 0, 0, 1), (1, 1, 0, 1), (2, 1, 1, 1), (0, -1, 1, 0), (3, -2, 1, 5), (1, 0, 0, -1)]


def check(directrix: Cells, generatrix: Cells, matrix: Matrix) -> None:
    """Compare a pair with the count, square by square, of the pair before its map."""
    n = computed(region(directrix, matrix), region(generatrix, matrix))
    holes, edges, points = free_cells(directrix, generatrix)
    a, b, c, d = matrix
    size = abs(a * d - b * c)
    assert sum((hole.area for hole in n.holes), Fraction(0)) == size * len(holes)
    overlapped = {(x - u, y - v) for x, y in directrix for u, v in generatrix}
    covered = {(x + i, y + j) for x, y in overlapped for i in (-1, 0) for j in (-1, 0)}
    assert n.exterior.area == size * len(covered | holes)

    def back(p: Point) -> tuple[int, int]:
        det = a * d - b * c
        return int((d * p.x - b * p.y) / det), int((a * p.y - c * p.x) / det)

    found = [(back(p), back(q)) for p, q in n.exact_fits]
    assert sorted(e for fit in found for e in unit_edges(fit)) == sorted(edges)
    assert {(2 * p[0], 2 * p[1]) for p, q in found if p == q} == points


@given(polyominoes(), polyominoes(6, 3), st.sampled_from(SHEARS))
def test_polyominoes_counted_square_by_square(d: Cells, g: Cells, matrix: Matrix) -> None:
    check(d, g, matrix)


@given(polyominoes(9, 4), st.sampled_from(SHEARS), st.sampled_from([1, 2]))
def test_a_polyomino_in_its_own_mold(g: Cells, matrix: Matrix, width: int) -> None:
    mold = frame(g, width)
    if len(connect(set(mold))) == len(mold):
        check(mold, g, matrix)


@given(polyominoes(8, 4), polyominoes(5, 3), st.sampled_from([10**30, 10**-30]))
@examples(20)
def test_size_does_not_matter(d: Cells, g: Cells, factor: float) -> None:
    scale = Fraction(factor) if factor > 1 else Fraction(1, 10**30)

    def scaled(shape: Region) -> Region:
        rings = [[(x * scale, y * scale) for x, y in ring] for ring in shape.rings]
        return Region(rings[0], rings[1:])

    small = computed(region(d), region(g))
    large = computed(scaled(region(d)), scaled(region(g)))
    assert large.exterior.area == small.exterior.area * scale**2
    assert [(p.x, p.y, q.x, q.y) for p, q in large.exact_fits] == [
        (p.x * scale, p.y * scale, q.x * scale, q.y * scale) for p, q in small.exact_fits
    ]


def test_slopes_that_differ_by_less_than_a_unit_are_distinguished() -> None:
    """3 / 2**40 and 1 / 2**41 are the same in units of 2**-32."""
    d = [(0, 0), (2**41, 1), (2**41 + 2**40, 4), (0, 10)]
    g = [(0, -10), (2**41, 3), (0, 0)]
    assert computed(Region(d), Region(g)).exterior == sweep(g, d).trajectory


def test_numbers_without_a_useful_lattice_change_no_answer() -> None:
    factor = 1 + Fraction(1, 3**5200)
    links = [(0, 0), (7, 0), (7, 5), (5, 5), (5, 4), (6, 4), (6, 1), (1, 1), (1, 4), (3, 4), (3, 5)]
    d, g = [*links, (0, 5)], [(0, 0), (2, 1), (1, 2)]
    near, far = (
        computed(*(Region([(f * x, f * y) for x, y in shape]) for shape in (d, g)))
        for f in (1, factor)
    )
    for one, other in zip((near.exterior, *near.holes), (far.exterior, *far.holes), strict=True):
        assert other == Polygon([(factor * x, factor * y) for x, y in one])
    scaled = [tuple(Point(factor * x, factor * y) for x, y in fit) for fit in near.exact_fits]
    assert [*far.exact_fits] == scaled


@pytest.mark.parametrize(
    ("part", "fits"), [((7, 5), True), ((8, 1), False), ((1, 6), False), ((1, 1), True)]
)
def test_a_part_that_is_too_long_or_too_tall_does_not_fit(
    part: tuple[int, int], fits: bool
) -> None:
    found = find_inner_fit([box(0, 0, 7, 5)], [box(0, 0, *part)])
    assert bool(found.regions or found.fits) is fits
