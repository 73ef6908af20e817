"""Squares inside of parallelograms of two edges: they are overlapped, and fill thin shapes."""

from fractions import Fraction
from itertools import product

from hypothesis import assume, example, given
from hypothesis import strategies as st
from strategies import Ring, simple_rings
from tiers import examples

from exactsweep.geometry.overlap import Overlap
from exactsweep.numbers.number import Point
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import find_contact_stretches
from exactsweep.procedures.cover import leave_out_covered
from exactsweep.procedures.crossings import cut_at_crossings
from exactsweep.procedures.parallelograms import fill_parallelograms
from exactsweep.procedures.ss import no_fit_ss

SCALES = [Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10**30)]


def zigzag(size: int) -> list[tuple[int, int]]:
    """A thin strip up and down."""
    up = [(2 * i, 400 if i % 2 else 0) for i in range(size // 2)]
    return up + [(x, y + 3) for x, y in reversed(up)]


@given(simple_rings(), simple_rings(), st.integers(4, 30), st.sampled_from(SCALES))
@examples(60)
def test_each_square_of_a_parallelogram_is_overlapped(
    d: Ring, g: Ring, columns: int, scale: Fraction
) -> None:
    stationary, orbiting = ([[(x * scale, y * scale) for x, y in ring]] for ring in (d, g))
    moving = [inverse(ring) for ring in orbiting]
    spans = [max(p[k] for p in ring) - min(p[k] for p in ring) for ring in (d, g) for k in (0, 1)]
    side = max(spans) * scale / columns
    left, low = (min(p[k] for p in stationary[0]) + min(p[k] for p in moving[0]) for k in (0, 1))
    found = [0] * (2 * columns + 2)
    fill_parallelograms(found, (left, low), side, (stationary, moving), 10**4)
    overlap = Overlap(stationary, orbiting)
    for k, rows in enumerate(found):
        for row in range(rows.bit_length()):
            if rows >> row & 1:
                for i, j in product((0, 1), (0, 1)):
                    x, y = left + (k + i) * side, low + (row + j) * side
                    assert overlap.at(Point(Fraction(x), Fraction(y)))


ways = st.tuples(st.integers(-9, 9), st.integers(-9, 9))


@given(ways, ways, st.integers(1, 2))
@example((9, 3), (3, 9), 1)
@example((9, -3), (3, -9), 1)
@examples(60)
def test_the_squares_inside_a_wide_parallelogram_are_found(
    a: tuple[int, int], b: tuple[int, int], finer: int
) -> None:
    """Squares that are inside by more than a sixteenth of their side are found, and no others."""
    area = a[0] * b[1] - a[1] * b[0]
    assume(finer * abs(area) > 5 * max(map(abs, (*a, *b))))
    corners = [(0, 0), a, b, (a[0] + b[0], a[1] + b[1])]
    (left, right), (low, high) = ((min(of), max(of)) for of in zip(*corners, strict=True))
    unit, far = 16 * finer, 100
    whole, sign = abs(area) * unit, 1 if area > 0 else -1

    def holds(k: int, row: int, room: int) -> bool:
        """Decide whether a square with sixteenths around it is inside."""
        xs, ys = (
            (16 * n - room + unit * of, 16 * n + 16 + room + unit * of)
            for n, of in ((k, left), (row, low))
        )
        return all(
            0 <= sign * share <= whole
            for x, y in product(xs, ys)
            for share in (x * b[1] - y * b[0], a[0] * y - a[1] * x)
        )

    found = [0] * (finer * (far + right - left))
    shapes, corner = ([[(0, 0), a]], [[(0, 0), b]]), (left - far, low - far)
    fill_parallelograms(found, corner, Fraction(1, finer), shapes, 0)  # one edge of each
    assert not any(found[: finer * far])
    for k, rows in enumerate(found[finer * far :]):
        rows, below = divmod(rows, 1 << finer * far)
        assert not below
        for row in range(finer * (high - low)):
            assert holds(k, row, 0) if rows >> row & 1 else not holds(k, row, 1)


def test_crossed_strips_leave_few_crossings() -> None:
    # Each of 40 strips crosses each of 40: of 320,000 crossings few are at the outside.
    strips = zigzag(80)
    moving = [[(y, -x) for x, y in strips]]
    stretches = find_contact_stretches([strips], moving)
    left = leave_out_covered(stretches, [strips], moving)
    cut_at_crossings(left)
    assert 0 < sum(len(stretch.cuts) for stretch in left) < 60_000
    found = no_fit_ss([strips], [inverse(moving[0])])
    # Two rows of 40 teeth each way, and what is between them.
    assert ([len(loop) for loop in found.around], found.within, found.fits) == ([236], [], [])


def test_shapes_without_squares_have_none() -> None:
    # Parallel edges span nothing, and short ones less than a square.
    found = [0] * 8
    needle = [[(0, 0), (6, 0), (6, 1)]]
    fill_parallelograms(found, (0, 0), 2, (needle, needle), 100)
    assert not any(found)
