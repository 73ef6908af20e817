"""SVG transforms (SVG 1.1, 7.6), exact if rational."""

import re
from collections.abc import Callable, Sequence
from fractions import Fraction

from exactsweep.formats.curved.affine import IDENTITY, Affine, make_affine, scale_axes, translate
from exactsweep.formats.curved.arc import make_rotation
from exactsweep.formats.decimals import read_decimals, show_number
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import quote

_FUNCTION = re.compile(r"[\s,]*([A-Za-z]+)\s*\(([^()]*)\)[\s,]*")
_MAX_BITS = 50_000  # bounds the growth of products of many transforms


def read_transform(text: str) -> Affine:
    """Read a `transform` attribute; its last function applies first."""
    product, place = IDENTITY, 0
    while place < len(text):
        match = _FUNCTION.match(text, place)
        if match is None:
            if not text[place:].strip():
                break
            raise FormatError(f"{quote(text[place : place + 40])} is not a transformation")
        name, numbers = match.groups()
        make, counts = _FUNCTIONS.get(name, (None, ()))
        if make is None:
            raise FormatError(f"{quote(name)} is not a transformation")
        given = read_decimals(numbers)
        if len(given) not in counts:
            raise FormatError(
                f"{name} takes {' or '.join(map(str, counts))} numbers, not {len(given)}"
            )
        product = compose(product, make(given))
        place = match.end()
    return product


def compose(outer: Affine, inner: Affine) -> Affine:
    """Return the map that applies `inner` and then `outer`; reject excessively long numbers."""
    product = outer @ inner
    if any(n.numerator.bit_length() + n.denominator.bit_length() > _MAX_BITS for n in product):
        raise FormatError("the numbers in the product of the transformations are too long")
    return product


def _rotate(numbers: Sequence[Fraction]) -> Affine:
    angle, *center = numbers
    turn = make_rotation(angle)
    if not center:
        return turn
    x, y = center
    return translate(x, y) @ turn @ translate(-x, -y)


def _skew_x(numbers: Sequence[Fraction]) -> Affine:
    (angle,) = numbers
    if angle % 45 == 0 and angle % 180 != 90:
        return make_affine(1, 0, {0: 0, 45: 1, 135: -1}[int(angle % 180)], 1, 0, 0)
    turn = make_rotation(angle)
    if abs(turn.a) < Fraction(1, 10**6):
        raise FormatError(f"cannot skew by {show_number(angle)} degrees")
    # The derivative of the tangent is 1 / cos**2.
    return make_affine(1, 0, turn.b / turn.a, 1, 0, 0)._replace(error=2 * turn.error / turn.a**2)


def _skew_y(numbers: Sequence[Fraction]) -> Affine:
    skew = _skew_x(numbers)
    return skew._replace(b=skew.c, c=skew.b)


_Make = Callable[[Sequence[Fraction]], Affine]
_FUNCTIONS: dict[str, tuple[_Make, tuple[int, ...]]] = {
    "matrix": (lambda numbers: Affine(*numbers), (6,)),
    "translate": (lambda n: translate(n[0], n[1] if n[1:] else Fraction(0)), (1, 2)),
    "scale": (lambda n: scale_axes(n[0], n[-1]), (1, 2)),
    "rotate": (_rotate, (1, 3)),
    "skewX": (_skew_x, (1,)),
    "skewY": (_skew_y, (1,)),
}
