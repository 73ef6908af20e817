"""Points, directions and counts as text."""

from collections.abc import Iterable
from difflib import get_close_matches
from fractions import Fraction
from math import atan2, pi

from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Vertex, to_fraction

CLASSES = {
    "CC": "CC, convex generatrix and convex directrix",
    "CM": "CM, convex generatrix and monotone directrix",
    "MM": "MM, monotone generatrix and monotone directrix",
    "SS": "SS, polygons of any shape",
}


def write_pair(point: Iterable[object]) -> str:
    """Format a point or a vector without spaces, with long numbers shortened.

    >>> write_pair((1, "-7/2"))
    '(1,-7/2)'
    """
    return f"({','.join(abridge(to_fraction(c)) for c in point)})"


def write_vector(direction: Iterable[object]) -> str:
    """Format a direction like a Python tuple, with long numbers shortened.

    >>> write_vector((1, -2)), write_vector((1, 10**5000))
    ('(1, -2)', '(1, 1e+5000)')
    """
    return write_pair(direction).replace(",", ", ")


def count(number: int, thing: str) -> str:
    """Format a count and its noun, in the plural unless the count is 1.

    >>> count(0, "step"), count(1, "step"), count(20, "step")
    ('no steps', '1 step', '20 steps')
    """
    return f"{number or 'no'} {thing}{'' if number == 1 else 's'}"


def write_size(vertices: int, area: Fraction) -> str:
    return f"{vertices} vertices, area {abridge(area)}"


def name_heading(vector: Vertex) -> str:
    """Name the direction of a vector.

    >>> name_heading((-3, 1)), name_heading((0, -1))
    ('left and up', 'down')
    """
    x, y = vector
    words = ["right" if x > 0 else "left"] if x else []
    if y:
        words.append("up" if y > 0 else "down")
    return " and ".join(words)


def write_degrees(vector: Vertex) -> str:
    """Format the counter-clockwise angle of a vector from the X axis in degrees, rounded.

    >>> write_degrees((1, -2)), write_degrees((0, 10**400)), write_degrees((-1, 1))
    ('-63.4', '90', '135')
    """
    across, up = map(Fraction, vector)
    longest = max(abs(across), abs(up))
    x, y = float(across / longest), float(up / longest)
    return f"{atan2(y, x) * 180 / pi:.1f}".removesuffix(".0")


def suggest(word: str, words: Iterable[str]) -> str:
    """Suggest a similar word; "" if there is none.

    >>> suggest("brakcet", ["plate", "bracket"])
    "; did you mean 'bracket'?"
    """
    near = get_close_matches(word, words, n=1, cutoff=0.5)
    return f"; did you mean {quote(near[0])}?" if near else ""


def spell_out(text: str) -> str:
    r"""Format text on one line, with escapes for unprintable characters.

    >>> spell_out("a\nb")
    'a\\nb'
    """
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in text)
