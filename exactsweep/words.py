"""Words for people: points, directions and numbers of things."""

from collections.abc import Iterable

from exactsweep.chain import Vertex
from exactsweep.number import to_fraction
from exactsweep.polygon import abridged

CLASSES = {
    "CC": "CC, convex generatrix and convex directrix",
    "CM": "CM, convex generatrix and monotone directrix",
    "MM": "MM, monotone generatrix and monotone directrix",
}


def pair(point: Iterable[object]) -> str:
    """Write a point or a vector without blanks, long numbers cut short.

    >>> pair((1, "-7/2"))
    '(1,-7/2)'
    """
    return f"({','.join(abridged(to_fraction(c)) for c in point)})"


def count(number: int, thing: str) -> str:
    """Write how many there are, in the plain plural.

    >>> count(0, "step"), count(1, "step"), count(20, "step")
    ('no steps', '1 step', '20 steps')
    """
    return f"{number or 'no'} {thing}{'' if number == 1 else 's'}"


def heading(vector: Vertex) -> str:
    """Say where a vector points.

    >>> heading((-3, 1)), heading((0, -1))
    ('left and up', 'down')
    """
    x, y = vector
    words = ["right" if x > 0 else "left"] if x else []
    if y:
        words.append("up" if y > 0 else "down")
    return " and ".join(words)
