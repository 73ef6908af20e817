"""Bezier curves and arcs of circles as lines, within a tolerance that is proved.

Every vertex but those at the ends is a point of the curve, found in rational arithmetic, rounded to
a decimal grid. What is proved is a bound on the distance of line and curve, either way. A share
of the tolerance goes to the chords and another to the rounding.

Chords. Between two parameters h apart, a curve C and its chord, at the same parameter, are at
most h**2 / 8 * max |C''| apart (the error of linear interpolation).

Arcs. (1 - t**2, 2 t) / (1 + t**2) is a rational point of the unit circle, at the angle 2 atan(t),
so that h in t is at most 2 h in angle, and by angle |C''| is the radius. No trigonometry is needed
to go a quarter turn from t = 0 to t = 1, nor to an end that is itself a rational point.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from math import isqrt

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.error import FormatError
from exactsweep.geometry.point import Point

MAX_VERTICES = 100_000
"""The most vertices that one curve becomes."""


def root_above(square: Fraction, scale: int = 1) -> Fraction:
    """Return a number not below the square root, by less than 1/scale plus a part in 2**30.

    >>> root_above(Fraction(4)), root_above(Fraction(0))
    (Fraction(2, 1), Fraction(0, 1))
    """
    n, d = square.as_integer_ratio()
    # The root of n / d is that of n * d, over d; short arguments are widened for more digits.
    widen = scale * (1 << max(0, 60 - (n * d).bit_length()) // 2)
    widened = n * d * widen * widen
    root = isqrt(widened)
    return Fraction(root + (root * root < widened), d * widen)


def flatten_bezier(points: Sequence[Point], tolerance: Fraction) -> list[Point]:
    """Turn a quadratic or cubic Bezier curve into lines.

    Args:
        points: three or four control points.
        tolerance: how far line and curve may be apart.

    Returns:
        list of Point, the first and the last control point at its ends.

    Raises:
        FormatError: more than MAX_VERTICES would be needed.

    Cost: O(k) for k vertices, k being O((size / tolerance) ** 0.5).

    Example:
        >>> curve = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (1, 1), (2, 0)]]
        >>> [tuple(map(str, point)) for point in flatten_bezier(curve, Fraction(1, 2))]
        [('0', '0'), ('1', '1/2'), ('2', '0')]
    """
    degree = len(points) - 1
    # |C''| is at most degree * (degree - 1) times the largest second difference.
    bends = [
        (a.x - 2 * b.x + c.x) ** 2 + (a.y - 2 * b.y + c.y) ** 2
        for a, b, c in zip(points, points[1:], points[2:], strict=False)
    ]
    count = _count(degree * (degree - 1) * root_above(max(bends)) / 8, tolerance)
    inner = [_casteljau(points, Fraction(k, count)) for k in range(1, count)]
    return [points[0], *rounded(inner, tolerance), points[-1]]


def flatten_arc(
    center: Point, start: Point, end: Point, left: bool, image: Affine, tolerance: Fraction
) -> list[Point]:
    """Turn the image of an arc of a circle into lines.

    Args:
        center: the center of the circle.
        start: where the arc starts, a point of the circle.
        end: where it ends, exactly as far from the center; the start for a full turn.
        left: whether it runs counter-clockwise.
        image: what maps the circle, to an ellipse perhaps.
        tolerance: how far line and image may be apart.

    Returns:
        list of Point, the images of start and end exactly at its ends.

    Raises:
        FormatError: more than MAX_VERTICES would be needed.

    Cost: O(k) for k vertices, k being O((size / tolerance) ** 0.5).

    Example:
        >>> from exactsweep.formats.curved.affine import IDENTITY
        >>> o, a, b = (Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (5, 0), (3, 4)])
        >>> [tuple(map(str, p)) for p in flatten_arc(o, a, b, True, IDENTITY, Fraction(1))]
        [('5', '0'), ('22/5', '12/5'), ('3', '4')]
    """
    side = 1 if left else -1
    x, y = start.x - center.x, start.y - center.y
    p, q = end.x - center.x, end.y - center.y
    radius = x * x + y * y
    (ux, uy), (vx, vy) = image.vector(x, y), image.vector(-side * y, side * x)
    # Frobenius' norm is not below the largest stretching of the unit circle.
    count = _count(root_above(ux * ux + uy * uy + vx * vx + vy * vy) / 2, tolerance)
    turns = _turns((x * p + y * q) / radius, side * (x * q - y * p) / radius, count)
    middle = image.point(*center)
    points = [Point(middle.x + ux * c + vx * s, middle.y + uy * c + vy * s) for c, s in turns]
    return [image.point(*start), *rounded(points, tolerance), image.point(*end)]


def chord_arc_center(start: Point, end: Point, height: Fraction) -> Point:
    """Return the center of an arc over a chord, `height` half chords to the left of its middle."""
    dx, dy = (end.x - start.x) / 2, (end.y - start.y) / 2
    return Point(start.x + dx - height * dy, start.y + dy + height * dx)


def rounded(points: Sequence[Point], tolerance: Fraction) -> list[Point]:
    """Move points to a decimal grid, none by more than a fourth of the tolerance."""
    grid = Fraction(1)
    while grid * 4 > tolerance:
        grid /= 10
    return [Point(round(x / grid) * grid, round(y / grid) * grid) for x, y in points]


def _count(bend: Fraction, tolerance: Fraction) -> int:
    """The least n for which bend / n**2 is at most half the tolerance."""
    square = 2 * bend / tolerance
    if square > MAX_VERTICES**2:
        raise FormatError(f"a curve would need more than {MAX_VERTICES} vertices at this tolerance")
    return max(1, -(-root_above(square) // 1))


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


def _casteljau(points: Sequence[Point], t: Fraction) -> Point:
    row = list(points)
    while len(row) > 1:
        row = [Point(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)) for a, b in pairwise(row)]
    return row[0]
