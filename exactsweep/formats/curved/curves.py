"""Bezier curves and arcs of circles as lines, within a tolerance that is proved.

Every vertex except those at the ends is a point of the curve, computed in rational arithmetic and
rounded to a decimal grid. The proof bounds the distance of line and curve in both directions. One
share of the tolerance is for the chords, and another for the rounding.

Chords. Between two parameters h apart, a curve C and its chord, at the same parameter, are at
most h**2 / 8 * max |C''| apart (the error of linear interpolation).

Arcs. (1 - t**2, 2 t) / (1 + t**2) is a rational point of the unit circle, at the angle 2 atan(t),
so that h in t is at most 2 h in angle, and by angle |C''| is the radius. No trigonometry is needed
to go a quarter turn from t = 0 to t = 1, nor to an end that is itself a rational point.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise, starmap
from math import isqrt

from exactsweep.formats.curved.affine import IDENTITY, Affine
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.number import Point


def bound_root(square: Fraction, scale: int = 1) -> Fraction:
    """Return a number not below the square root, by less than 1/scale plus a part in 2**30.

    >>> bound_root(Fraction(4)), bound_root(Fraction(0))
    (Fraction(2, 1), Fraction(0, 1))
    """
    n, d = square.as_integer_ratio()
    # The root of n / d is that of n * d, over d; short arguments are widened for more digits.
    widen = scale * (1 << max(0, 60 - (n * d).bit_length()) // 2)
    widened = n * d * widen * widen
    root = isqrt(widened)
    return Fraction(root + (root * root < widened), d * widen)


def flatten_bezier(
    points: Sequence[Point],
    image: Affine,
    reading: Reading,
    weights: Sequence[Fraction] = (),
) -> list[Point]:
    """Turn the image of a Bezier curve, rational if it has weights, into lines.

    Args:
        points: the control points, three or more.
        image: what maps the curve.
        reading: has the tolerance, how far line and curve may be apart.
        weights: one for each control point, all positive; all 1 if left out.

    Returns:
        list of Point, the images of the first and the last control point at its ends.

    Raises:
        FormatError: no tolerance, or more lines than are allowed.

    Cost: O(k) for k vertices, k being O((size / tolerance) ** 0.5).

    Example:
        >>> from exactsweep.formats.curved.affine import IDENTITY
        >>> curve = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (1, 1), (2, 0)]]
        >>> [tuple(map(str, p)) for p in flatten_bezier(curve, IDENTITY, Reading("1/2"))]
        [('0', '0'), ('1', '1/2'), ('2', '0')]
    """
    mapped = [image.point(*point) for point in points]
    first, last = place_points([points[0], points[-1]], image, reading)
    require_sharp(image, points, reading)
    count = _count(_bend(mapped, weights) / 8, reading)
    if weights:
        lifted = [(x * w, y * w, w) for (x, y), w in zip(mapped, weights, strict=True)]
        sums = (_casteljau(lifted, Fraction(k, count)) for k in range(1, count))
        inner = [Point(x / w, y / w) for x, y, w in sums]
    else:
        inner = [Point(*_casteljau(mapped, Fraction(k, count))) for k in range(1, count)]
    return [first, *round_points(inner, reading.allow_curve()), last]


def flatten_arc(
    center: Point, start: Point, end: Point, left: bool, image: Affine, reading: Reading
) -> list[Point]:
    """Turn the image of an arc of a circle into lines.

    Args:
        center: the center of the circle.
        start: where the arc starts, a point of the circle.
        end: where it ends, exactly as far from the center; the start for a full turn.
        left: whether it runs counter-clockwise.
        image: what maps the circle, to an ellipse perhaps.
        reading: has the tolerance, how far line and image may be apart.

    Returns:
        list of Point, the images of start and end at its ends.

    Raises:
        FormatError: no tolerance, or more lines than are allowed.

    Cost: O(k) for k vertices, k being O((size / tolerance) ** 0.5).

    Example:
        >>> from exactsweep.formats.curved.affine import IDENTITY
        >>> o, a, b = (Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (5, 0), (3, 4)])
        >>> [tuple(map(str, p)) for p in flatten_arc(o, a, b, True, IDENTITY, Reading(1))]
        [('5', '0'), ('22/5', '12/5'), ('3', '4')]
    """
    side = 1 if left else -1
    x, y = start.x - center.x, start.y - center.y
    p, q = end.x - center.x, end.y - center.y
    radius = x * x + y * y
    corners = [Point(center.x + i * x - j * y, center.y + i * y + j * x) for i, j in _CORNERS]
    require_sharp(image, corners, reading)
    (ux, uy), (vx, vy) = image.vector(x, y), image.vector(-side * y, side * x)
    # Frobenius' norm is not below the largest stretching of the unit circle.
    bend = bound_root(ux * ux + uy * uy + vx * vx + vy * vy) / 2
    along, across = (x * p + y * q) / radius, side * (x * q - y * p) / radius
    count = _count(bend, reading, quarters=1 if along > 0 and across > 0 else 4)
    middle = image.point(*center)
    turns = _turns(along, across, count)
    points = [Point(middle.x + ux * c + vx * s, middle.y + uy * c + vy * s) for c, s in turns]
    inner = round_points(points, reading.allow_curve())
    first, last = place_points([start, end], image, reading)
    return [first, *inner, last]


# Of a square around the circle through the first of them, in its radii.
_CORNERS = [(1, 1), (-1, 1), (-1, -1), (1, -1)]


def require_sharp(image: Affine, points: Sequence[Point], reading: Reading) -> None:
    """Refuse a map that is off, around these points, by more than a sixteenth of the tolerance."""
    if image.off and 16 * image.error(points) > reading.allow_curve():
        raise FormatError("numbers too large to be turned by an irrational angle")


def place_points(points: Sequence[Point], image: Affine, reading: Reading) -> list[Point]:
    """Map points, exactly, or rounded as `round_points` does where the map is irrational."""
    if image is IDENTITY:
        return [*points]
    require_sharp(image, points, reading)
    found = [*starmap(image.point, points)]
    return round_points(found, reading.allow_curve()) if image.off else found


def find_arc_center(start: Point, end: Point, height: Fraction) -> Point:
    """Return the center of an arc over a chord, `height` half chords to the left of its middle."""
    dx, dy = (end.x - start.x) / 2, (end.y - start.y) / 2
    return Point(start.x + dx - height * dy, start.y + dy + height * dx)


def round_points(points: Sequence[Point], tolerance: Fraction) -> list[Point]:
    """Move points to a decimal grid, none by more than a fourth of the tolerance."""
    grid = Fraction(1)
    while grid * 4 > tolerance:
        grid /= 10
    return [Point(round(x / grid) * grid, round(y / grid) * grid) for x, y in points]


def _count(bend: Fraction, reading: Reading, quarters: int = 1) -> int:
    """The least n for which bend / n**2 is at most half the tolerance, for each quarter."""
    count = max(1, -(-bound_root(2 * bend / reading.allow_curve()) // 1))
    reading.allow_curve(count * quarters)
    return count


def _bend(points: Sequence[Point], weights: Sequence[Fraction]) -> Fraction:
    """A bound for |C''| of a Bezier curve C.

    With weights C = N / W, and so W C'' = N'' - 2 W' C' - W'' C, W C' = N' - W' C; N and W are
    Bezier curves, whose derivatives are no larger than the differences of their control points
    times the degree. The origin may be any point; a control point keeps |C| small.
    """
    n = len(points) - 1
    x, y = points[0]
    moved = [Point(p.x - x, p.y - y) for p in points]
    if not weights:
        return n * (n - 1) * _largest(_differences(_differences(moved)))
    lifted = [Point(p.x * w, p.y * w) for p, w in zip(moved, weights, strict=True)]
    heights = [Point(w, Fraction(0)) for w in weights]
    first, first_w = _differences(lifted), _differences(heights)
    second, second_w = _differences(first), _differences(first_w)
    least, reach = min(weights), _largest(moved)
    speed = n * (_largest(first) + _largest(first_w) * reach) / least
    twice = n * (n - 1) * (_largest(second) + _largest(second_w) * reach)
    return (twice + 2 * n * _largest(first_w) * speed) / least


def _differences(points: Sequence[Point]) -> list[Point]:
    return [Point(b.x - a.x, b.y - a.y) for a, b in pairwise(points)]


def _largest(vectors: Sequence[Point]) -> Fraction:
    return bound_root(max((x * x + y * y for x, y in vectors), default=Fraction(0)))


def _turns(x: Fraction, y: Fraction, count: int) -> list[tuple[Fraction, Fraction]]:
    """Points of the unit circle between (1, 0) and (x, y), `count` to each whole quarter."""
    found: list[tuple[Fraction, Fraction]] = []
    c, s, last = 1, 0, False
    while not last:
        # The end as it is seen from the start of this quarter.
        along, across = c * x + s * y, c * y - s * x
        last = along >= 0 and (across > 0 or (across == 0 and bool(found)))
        stop = across / (1 + along) if last else Fraction(1)
        steps = max(1, -(-count * stop // 1))
        for k in range(steps):
            t = stop * k / steps
            p, q = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
            found.append((c * p - s * q, s * p + c * q))
        c, s = -s, c
    return found[1:]


def _casteljau(points: Sequence[tuple[Fraction, ...]], t: Fraction) -> tuple[Fraction, ...]:
    row = [tuple(point) for point in points]
    while len(row) > 1:
        row = [tuple(p + t * (q - p) for p, q in zip(a, b, strict=True)) for a, b in pairwise(row)]
    return row[0]
