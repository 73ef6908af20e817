"""The transformations of SVG (SVG 1.1, 7.6), those that are rational."""

import re
from collections.abc import Callable, Sequence
from fractions import Fraction

from exactsweep.formats.curved.affine import IDENTITY, Affine, affine
from exactsweep.formats.decimals import read_decimals
from exactsweep.formats.error import FormatError
from exactsweep.geometry.number import abridged, quoted

_FUNCTION = re.compile(r"[\s,]*([A-Za-z]+)\s*\(([^()]*)\)[\s,]*")
# Products of long numbers get longer and longer.
_MAX_BITS = 50_000


def read_transform(text: str) -> Affine:
    """Read a `transform` attribute.

    Args:
        text: functions one after another, the last one applied first.

    Returns:
        The map, exactly.

    Raises:
        FormatError: an angle whose sine or tangent is irrational, numbers that grow too long, or
            whatever is not a list of transformations.

    Example:
        >>> read_transform("translate(10) rotate(90)").point(*map(Fraction, (1, 0)))
        Point(x=Fraction(10, 1), y=Fraction(1, 1))
    """
    product, place = IDENTITY, 0
    while place < len(text):
        match = _FUNCTION.match(text, place)
        if match is None:
            if not text[place:].strip():
                break
            raise FormatError(f"{quoted(text[place : place + 40])} is not a transformation")
        name, numbers = match.groups()
        make, counts = _FUNCTIONS.get(name, (None, ()))
        if make is None:
            raise FormatError(f"{quoted(name)} is not a transformation")
        given = read_decimals(numbers)
        if len(given) not in counts:
            raise FormatError(f"{name} with {len(given)} numbers")
        product = composed(product, make(given))
        place = match.end()
    return product


def composed(outer: Affine, inner: Affine) -> Affine:
    """Return the map that does `inner` and then `outer`; refuse numbers that grow too long."""
    product = outer @ inner
    if any(n.numerator.bit_length() + n.denominator.bit_length() > _MAX_BITS for n in product):
        raise FormatError("the numbers of the product of transformations are too long")
    return product


def _translate(numbers: Sequence[Fraction]) -> Affine:
    return affine(1, 0, 0, 1, numbers[0], numbers[1] if len(numbers) > 1 else 0)


def _scale(numbers: Sequence[Fraction]) -> Affine:
    return affine(numbers[0], 0, 0, numbers[-1], 0, 0)


def _rotate(numbers: Sequence[Fraction]) -> Affine:
    angle, *center = numbers
    if angle % 90:
        raise FormatError(f"rotate by {abridged(angle)} degrees is irrational")
    cos, sin = [(1, 0), (0, 1), (-1, 0), (0, -1)][int(angle // 90) % 4]
    x, y = center or (0, 0)
    return affine(1, 0, 0, 1, x, y) @ affine(cos, sin, -sin, cos, 0, 0) @ affine(1, 0, 0, 1, -x, -y)


def _skew(numbers: Sequence[Fraction]) -> int:
    angle = numbers[0]
    if angle % 45 or angle % 180 == 90:
        raise FormatError(f"a skew by {abridged(angle)} degrees is irrational")
    return {0: 0, 45: 1, 135: -1}[int(angle % 180)]


_FUNCTIONS: dict[str, tuple[Callable[[Sequence[Fraction]], Affine], tuple[int, ...]]] = {
    "matrix": (lambda numbers: Affine(*numbers), (6,)),
    "translate": (_translate, (1, 2)),
    "scale": (_scale, (1, 2)),
    "rotate": (_rotate, (1, 3)),
    "skewX": (lambda numbers: affine(1, 0, _skew(numbers), 1, 0, 0), (1,)),
    "skewY": (lambda numbers: affine(1, _skew(numbers), 0, 1, 0, 0), (1,)),
}
