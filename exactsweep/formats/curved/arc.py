"""Rational approximation of irrational points on a circle, and arcs between them.

The end of an arc is a rational point on the circle at most 10**-40 radii from the true end, as
interval arithmetic proves.
"""

from fractions import Fraction
from math import pi

from exactsweep.formats.curved.affine import Affine, make_affine
from exactsweep.formats.curved.curves import Arc
from exactsweep.formats.curved.path import Path
from exactsweep.formats.error import FormatError
from exactsweep.geometry.turn import bound_half_tangent, from_half_tangent, mpmath_lock
from exactsweep.numbers.number import Point

_DIGITS, _GUARD = 101, 20
_MAX_TURN = 10**6
_NEAR = Fraction(1, 10**40)
_FULL = Fraction(360)


def make_arc(image: Affine, start: Fraction, end: Fraction) -> Path:
    """Make an arc of the image of the unit circle, between two angles in degrees."""
    span = (end - start) % _FULL or _FULL
    points = [image.point(*find_unit_point(angle, _NEAR)) for angle in (start, end)]
    radians = pi / 180
    arc = Arc(
        image._replace(error=Fraction(0)), float(start % _FULL) * radians, float(span) * radians
    )
    size = Fraction(sum(map(abs, image[:4])))
    return Path(points, {0: (arc, True)}, image.bound_error([Point(size, size)]))


def make_rotation(degrees: Fraction, power: int = 1) -> Affine:
    """Make a rotation, with an error of at most 10**(-40 * power)."""
    error = _NEAR**power if degrees % 90 else Fraction(0)
    c, s = find_unit_point(degrees, error)
    return make_affine(c, s, -s, c, 0, 0)._replace(error=error)


def find_unit_point(degrees: Fraction, allowed: Fraction) -> Point:
    """Find a rational point of the unit circle within `allowed` of the point at an angle."""
    quarter, rest = divmod(degrees % 360, 90)
    return from_half_tangent(
        _round_half_tangent(rest, allowed / 2) if rest else Fraction(0), quarter
    )


def _round_half_tangent(degrees: Fraction, allowed: Fraction) -> Fraction:
    """Return a decimal within `allowed` of the tangent of half the angle."""
    digits = 3
    while allowed * 10**digits < 4:
        digits += 1
    low, high = bound_half_tangent(degrees, 4 * digits)
    found = round((low + high) / 2, digits)
    assert max(high - found, found - low) <= allowed
    return found


def to_degrees(radians: Fraction) -> Fraction:
    """Convert radians to a decimal number of degrees, with an error of at most 10**-100.

    Only 0 becomes a multiple of 90: other multiples of 90 degrees are irrational in radians.
    """
    if abs(radians) > _MAX_TURN:
        raise FormatError(f"the angle exceeds {_MAX_TURN} radians")
    digits = _DIGITS
    while True:
        degrees = round(radians * 180 / find_pi(4 * (digits + _GUARD)), digits)
        if degrees % 90 or not radians:
            return degrees
        digits *= 2


def find_pi(bits: int) -> Fraction:
    """Find pi, with an error of at most 2**-bits.

    >>> abs(find_pi(20) - Fraction(355, 113)) < Fraction(1, 10**6)
    True
    """
    from mpmath.libmp import mpf_pi, to_rational

    with mpmath_lock:
        return Fraction(*map(int, to_rational(mpf_pi(bits + 3))))
