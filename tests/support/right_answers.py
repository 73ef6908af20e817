"""Notations of a right answer: any order, orientation and number type, with doubled lines."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator
from fractions import Fraction
from itertools import chain
from math import ulp
from typing import Any, NamedTuple

from exactsweep import Point
from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.region import find_differences
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.judge.witness import list_exact_fits, list_exact_rings
from exactsweep.conform.run.protocol import Hello, Numbers, UnsupportedError, adapt
from exactsweep.corpus import Case
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Fit

Ring = list[Point]
Rings = list[Ring]
Parts = dict[str, Rings]

FITS_OF = {"no_fit": "exact_fits", "inner_fit": "inner_exact_fits"}
SUM = "minkowski_sum"


class Writing(NamedTuple):
    """A notation of an answer.

    Attributes:
        rings: writes the rings of a part, given its exact fits; None where it does not apply.
        fits: writes the list of exact fits.
        number: writes a number.
        numbers: the numbers in the program's hello.
        verdicts: the allowed verdicts on right answers.
    """

    rings: Callable[[Rings, list[Fit]], Any] = lambda rings, fits: rings
    fits: Callable[[list[Fit]], Any] = lambda fits: fits
    number: Callable[[Fraction], object] = lambda value: value
    numbers: Numbers = "rational"
    verdicts: tuple[str, ...] = ("exact", "equivalent")


def each(change: Callable[[Ring], Any]) -> Callable[[Rings, list[Fit]], Any]:
    return lambda rings, fits: [change(ring) for ring in rings]


def between(a: Point, b: Point, share: Fraction) -> Point:
    return Point(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y))


def with_points(*shares: Fraction) -> Callable[[Ring], Ring]:
    """Return points on every edge."""

    def change(ring: Ring) -> Ring:
        return [
            p
            for k, b in enumerate(ring)
            for p in (*(between(ring[k - 1], b, share) for share in shares), b)
        ]

    return change


def turn(ring: Ring, k: int) -> Ring:
    return [*ring[k:], *ring[:k]]


def keyhole(start: Callable[[Ring], Ring]) -> Callable[[Rings, list[Fit]], Any]:
    """Join all rings into one that visits each other ring from its start and returns."""

    def change(rings: Rings, fits: list[Fit]) -> Any:
        if len(rings) < 2:
            return None
        first, *others = map(start, rings)
        found = [*first, first[0]]
        for ring in others:
            found += [*ring, ring[0], first[0]]
        return [found]

    return change


def hand_on(rings: Rings, fits: list[Fit]) -> Any:
    """Join all rings into one that visits each ring from the preceding one."""
    if len(rings) < 2:
        return None
    there = [p for ring in rings for p in (*ring, ring[0])]
    return [[*there, *(ring[0] for ring in rings[::-1])]]


def from_middle(ring: Ring) -> Ring:
    return [between(ring[-1], ring[0], Fraction(1, 2)), *ring]


def hang(rings: Rings, fits: list[Fit]) -> Any:
    """Trace each fit as a whisker of the ring that it touches, or as a separate ring."""
    if not fits:
        return None
    grown = [list(ring) for ring in rings]
    for a, b in fits:
        for ring in grown:
            if a in ring:
                k = ring.index(a)
                ring[k:k] = [a, b]
                break
        else:
            grown.append([a, b])
    return grown


def as_rings(*order: int) -> Callable[[Rings, list[Fit]], Any]:
    """Write each fit as a ring of its ends."""
    return lambda rings, fits: (
        [*rings, *([fit[k] for k in order] for fit in fits)] if fits else None
    )


def reach_by_fits(rings: Rings, fits: list[Fit]) -> Any:
    """Extend a ring along each fit that starts on it to the ring at the other end, and back."""
    left = [list(ring) for ring in rings]
    for a, b in fits:
        one = next((ring for ring in left if a in ring), None)
        other = next((ring for ring in left if b in ring and ring is not one), None)
        if one is not None and other is not None:
            left.remove(other)
            k, j = one.index(a), other.index(b)
            one[k:k] = [a, *turn(other, j), b]
    return left if len(left) < len(rings) else None


def split(rings: Rings, fits: list[Fit]) -> Any:
    """Decompose the region into trapezoids."""
    found = []
    for cell in find_differences(rings, []):
        (low, lower), (high, higher) = cell.low, cell.high
        corners = [
            Point(cell.left, low),
            Point(cell.right, lower),
            Point(cell.right, higher),
            Point(cell.left, high),
        ]
        found.append(list(dict.fromkeys(corners)))
    return found


def fan(rings: Rings, fits: list[Fit]) -> Any:
    """Return overlapping triangles with a common vertex, one for each edge."""
    if not rings:
        return None
    apex = rings[0][0]
    triangles = ([apex, ring[k - 1], b] for ring in rings for k, b in enumerate(ring))
    return [ring for ring in triangles if apex not in ring[1:]] or None


def join_touching(rings: Rings, fits: list[Fit]) -> Any:
    """Join rings that have a common vertex."""
    left = [list(ring) for ring in rings]
    joined = False
    for ring in list(left):
        for other in left:
            common = [p for p in ring if p in other]
            if other is not ring and common and ring in left:
                k, j = other.index(common[0]), ring.index(common[0])
                other[k:k] = turn(ring, j)
                left.remove(ring)
                joined = True
                break
    return left if joined else None


def open_pinches(ulps: int) -> Callable[[Rings, list[Fit]], Any]:
    """Join touching rings by a neck of a few ulps at the common point."""

    def change(rings: Rings, fits: list[Fit]) -> Any:
        left = [list(ring) for ring in rings]
        joined = False
        for ring in list(left):
            touched = next(
                ((other, p) for other in left if other is not ring for p in ring if p in other),
                None,
            )
            if touched is None:
                continue
            other, p = touched
            k, j = other.index(p), ring.index(p)
            off = ulps * Fraction(ulp(float(max(map(abs, p)))))
            other[k : k + 1] = [Point(p.x + off, p.y), *turn(ring, j)[1:], Point(p.x, p.y - off)]
            left.remove(ring)
            joined = True
        return left if joined else None

    return change


def close_pinches(rings: Rings, fits: list[Fit]) -> Any:
    """Move touching rings by an ulp at the common point, in different directions."""
    shared = {p for k, ring in enumerate(rings) for p in ring for r in rings[:k] if p in r}

    def move(p: Point, k: int) -> Point:
        off = Fraction(ulp(float(max(map(abs, p)))))
        return Point(p.x + off * (k % 3 - 1), p.y + off * (k % 2)) if p in shared else p

    return [[move(p, k) for p in ring] for k, ring in enumerate(rings)] if shared else None


def slit(ring: Ring) -> Ring:
    """Add a straight slit from the first vertex to another one and back, even outside."""
    middle = ring[len(ring) // 2]
    return [ring[0], middle, *ring]


def halve(fits: list[Fit]) -> list[Fit]:
    half = Fraction(1, 2)
    return [pair for a, b in fits for pair in ((a, between(a, b, half)), (between(a, b, half), b))]


def as_decimal(value: Fraction) -> object:
    for places in range(40):
        if (value * 10**places).denominator == 1:
            return f"{value.numerator * 10**places // value.denominator}e-{places}"
    raise OverflowError


def as_exact(kind: Any) -> Callable[[Fraction], object]:
    def write(value: Fraction) -> object:
        number = kind(value)
        if number != value:
            raise OverflowError
        return number

    return write


EXACT = ("exact",)
ROUNDED = ("exact", "equivalent", "within")

WRITINGS: dict[str, Writing] = {
    "as it is": Writing(verdicts=EXACT),
    "closed": Writing(each(lambda ring: [*ring, ring[0]]), verdicts=EXACT),
    "closed twice": Writing(each(lambda ring: [*ring, ring[0], ring[0]])),
    "clockwise": Writing(each(lambda ring: ring[::-1])),
    "closed and clockwise": Writing(each(lambda ring: [ring[0], *ring[::-1]])),
    "every other ring clockwise": Writing(
        lambda rings, fits: [r[:: 1 if k % 2 else -1] for k, r in enumerate(rings)]
    ),
    "the last ring first": Writing(lambda rings, fits: rings[::-1]),
    "the second ring first": Writing(lambda rings, fits: [*rings[1:], *rings[:1]]),
    "from the second vertex": Writing(each(lambda ring: turn(ring, 1)), verdicts=EXACT),
    "from the last vertex": Writing(each(lambda ring: turn(ring, len(ring) - 1)), verdicts=EXACT),
    "from the middle of an edge": Writing(each(from_middle)),
    "the middle of every edge": Writing(each(with_points(Fraction(1, 2)))),
    "both thirds of every edge": Writing(each(with_points(Fraction(1, 3), Fraction(2, 3)))),
    "the first vertex twice": Writing(each(lambda ring: [ring[0], *ring])),
    "every vertex twice": Writing(each(lambda ring: [p for p in ring for _ in range(2)])),
    "every vertex three times": Writing(each(lambda ring: [p for p in ring for _ in range(3)])),
    "repeated, collinear, closed and clockwise": Writing(
        each(lambda ring: [p for q in (*from_middle(ring), ring[-1]) for p in (q, q)][::-1])
    ),
    "every ring three times": Writing(lambda rings, fits: [r for r in rings for _ in range(3)]),
    "around every ring three times": Writing(each(lambda ring: ring * 3)),
    "keyholed from vertex to vertex": Writing(keyhole(lambda ring: ring)),
    "keyholed from edge to edge": Writing(keyhole(from_middle)),
    "keyholed, clockwise": Writing(keyhole(lambda ring: ring[::-1])),
    "keyholed from ring to ring": Writing(hand_on),
    "a slit": Writing(each(slit)),
    "in trapezoids": Writing(split),
    "in trapezoids, clockwise": Writing(
        lambda rings, fits: [ring[::-1] for ring in split(rings, fits)]
    ),
    "a fan of triangles": Writing(fan),
    "touching rings joined": Writing(join_touching),
    "fits as whiskers": Writing(hang, lambda fits: []),
    "fits as whiskers, and listed": Writing(hang),
    "fits as whiskers, clockwise": Writing(
        lambda rings, fits: [r[::-1] for r in hang(rings, fits)] if fits else None, lambda fits: []
    ),
    "fits as whiskers, closed": Writing(
        lambda rings, fits: [[*r, r[0]] for r in hang(rings, fits)] if fits else None,
        lambda fits: [],
    ),
    "fits as rings of two points": Writing(as_rings(0, 1), lambda fits: []),
    "fits as rings of three points": Writing(as_rings(1, 0, 1), lambda fits: []),
    "fits as rings, and listed": Writing(as_rings(0, 1, 0)),
    "keyholed along fits": Writing(reach_by_fits),
    "the last fit first": Writing(fits=lambda fits: fits[::-1]),
    "fits from their other ends": Writing(fits=lambda fits: [fit[::-1] for fit in fits]),
    "fits in halves": Writing(fits=halve),
    "fits twice": Writing(fits=lambda fits: [*fits, *fits]),
    "fractions as strings": Writing(number=format_fraction),
    "decimals as strings": Writing(number=as_decimal),
    "doubles that are exact": Writing(number=as_exact(float)),
    "integers that are exact": Writing(number=as_exact(int)),
    "scaled to integers": Writing(number=as_exact(int), numbers="integer", verdicts=ROUNDED),
    "the nearest doubles": Writing(number=float, numbers="binary64", verdicts=ROUNDED),
    "the nearest doubles, clockwise": Writing(
        each(lambda ring: ring[::-1]), number=float, numbers="binary64", verdicts=ROUNDED
    ),
    "the nearest doubles, keyholed": Writing(
        keyhole(lambda ring: ring), number=float, numbers="binary64", verdicts=ROUNDED
    ),
    "the nearest doubles, fits as whiskers": Writing(
        hang, lambda fits: [], float, "binary64", ROUNDED
    ),
    "the nearest doubles, pinches opened": Writing(
        open_pinches(1), number=float, numbers="binary64", verdicts=ROUNDED
    ),
    "the nearest doubles, pinches crossed": Writing(
        open_pinches(-1), number=float, numbers="binary64", verdicts=ROUNDED
    ),
    "the nearest doubles, pinches closed": Writing(
        close_pinches, number=float, numbers="binary64", verdicts=ROUNDED
    ),
    "the nearest integers": Writing(number=round, numbers="integer", verdicts=ROUNDED),
}


def write(case: Case, name: str, writing: Writing) -> dict[str, Any] | None:
    """Write one part of the exact answer; None if the spelling does not apply.

    Raises:
        OverflowError: the numbers are too large for the spelling.
    """
    listed = FITS_OF.get(name, "")
    fits = list(list_exact_fits(case, listed or name)) if listed or name == SUM else []
    rings = writing.rings([list(ring) for ring in list_exact_rings(case, name)], fits)
    if rings is None:
        return None
    found = {name: [_write(ring, writing) for ring in rings]}
    if listed:
        found[listed] = [_write(list(fit), writing) for fit in writing.fits(fits)]
    return found


def _write(ring: Ring, writing: Writing) -> list[list[object]]:
    return [[writing.number(c) for c in point] for point in ring]


def list_parts(case: Case) -> Iterator[str]:
    """List the parts that an answer to a case may have."""
    inside = ("inner_fit",) if case.inner_regions is not None else ()
    return chain(("inner", "outer", "no_fit", "minkowski_sum"), inside)


class Conviction(NamedTuple):
    """A right answer with a wrong verdict."""

    case: str
    part: str
    verdict: Verdict
    reason: str


class JudgedWriting(NamedTuple):
    """The number of judged answers, and those that were rejected."""

    number: int
    convicted: list[Conviction]


def judge_writing(
    writing: Writing, chosen: Iterable[Case], parts: Collection[str] = ()
) -> JudgedWriting:
    """Write parts of exact answers in one notation, by default all parts, and judge them."""
    hello = Hello("right", numbers=writing.numbers, shapes="any")
    count, convicted = 0, []
    for case in chosen:
        try:
            put = adapt(case, hello)
        except UnsupportedError:
            continue
        for name, answer in _write_all(put, writing):
            if parts and name not in parts:
                continue
            count += 1
            found = compare(put, answer, numbers=writing.numbers)
            if found.verdict not in (*writing.verdicts, *_but_fits(name, writing)):
                convicted.append(Conviction(case.id, name, found.verdict, found.reason))
    return JudgedWriting(count, convicted)


def _but_fits(name: str, writing: Writing) -> tuple[str, ...]:
    # Rounding destroys exact fits.
    is_rounded = "within" in writing.verdicts
    return ("equivalent except for exact fits",) if is_rounded and "fit" in name else ()


def _write_all(case: Case, writing: Writing) -> Iterator[tuple[str, dict[str, object]]]:
    for name in list_parts(case):
        try:
            answer = write(case, name, writing)
        except OverflowError:
            continue
        if answer is not None:
            yield name, answer
