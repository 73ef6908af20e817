"""Certificates as they come in: plain JSON, read into exact numbers, or refused with a reason.

This module checks everything that needs no geometry: keys, types, numbers in lowest terms, indices
in range. It computes nothing from the certificate.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from fractions import Fraction
from itertools import chain, pairwise
from math import gcd
from typing import Any, Literal, NamedTuple, TypeVar

from exactsweep.geometry.canonical import find_least
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import (
    NumberError,
    divide_all,
    divide_exactly,
    format_fraction,
    read_any_length,
)
from exactsweep.numbers.point import Fit, Loop, Point

FORMAT = "exactsweep certificate"
VERSION = 2

DIGITS_OF_AN_INT = 4300  # as JSON is read by Python
_SHORT = 600  # digits of an int that Python reads whatever its own limit is

_T = TypeVar("_T")

# Where in a certificate something is, to be written out only if it is wrong: a key, or a place and
# what follows it, the number of an entry or a key in it.
KeyPath = str | tuple["KeyPath", int | str]


class CertificateError(ExactSweepError):
    """The first thing that is wrong with a certificate, and a point or translation to see it by."""

    def __init__(self, reason: str, witness: Point | None = None) -> None:
        super().__init__(reason)
        self.witness = witness


# Vertex k, or edge k, from vertex k to the next one.
ListedFeature = tuple[Literal["vertex", "edge"], int]

# Edge (E) or vertex (V) i of the generatrix on vertex or edge j of the directrix.
ListedContact = tuple[Literal["EV", "VE", "EE"], int, int]

# A feature of the generatrix while its reference point is on a feature of the trajectory: that of
# the trajectory first.
ListedDrawing = tuple[ListedFeature, ListedFeature]


class Certificate(NamedTuple):
    """The content of a certificate: loops as tuples of Point, evidence by their edges."""

    generatrix: Loop
    directrix: Loop
    kind: str
    direction: tuple[int, int]
    reference: Point
    trajectory: Loop
    inner: Loop
    outer: Loop
    area: Fraction
    exact_fits: tuple[Fit, ...]
    contacts: tuple[tuple[ListedContact, ...], ...]
    inner_drawn: tuple[tuple[ListedDrawing, ...], ...]
    outer_drawn: tuple[tuple[ListedDrawing, ...], ...]


def read(certificate: Any) -> Certificate:
    """Read a certificate as `json.loads` gives it.

    Returns: Certificate.
    Raises: CertificateError, naming the key and the place in it.
    Cost: linear in the length of the input, for numbers of bounded length.
    """
    check_keys(certificate, Certificate._fields)
    if not any(is_exactly(certificate["kind"], str, kind) for kind in ("CC", "CM", "MM")):
        raise CertificateError("kind is not CC, CM or MM")
    g, d = (read_loop(certificate[name], name) for name in ("generatrix", "directrix"))
    reference = _point(certificate["reference"], "reference")
    direction = _direction(certificate["direction"])
    t, inner, outer = (
        read_loop(certificate[name], name) for name in ("trajectory", "inner", "outer")
    )
    fits = read_list(certificate["exact_fits"], "exact_fits", read_fit)
    area = read_number(certificate["area"], "area")

    def contact(item: Any, place: KeyPath) -> ListedContact:
        event, i, j = read_tuple(item, place, 3)
        if event not in ("EV", "VE", "EE"):
            raise flaw(place, "not EV, VE or EE")
        return event, _index(i, len(g), place), _index(j, len(d), place)

    def drawing(item: Any, place: KeyPath) -> ListedDrawing:
        position, feature = read_tuple(item, place, 2)
        return _feature(position, len(t), place), _feature(feature, len(g), place)

    contacts = _evidence(certificate["contacts"], "contacts", len(t), contact)
    for k, listed in enumerate(contacts):
        if any(a >= b for a, b in pairwise(listed)):
            raise CertificateError(f"contacts[{k}]: not in increasing order")
    return Certificate(
        generatrix=g,
        directrix=d,
        kind=certificate["kind"],
        direction=direction,
        reference=reference,
        trajectory=t,
        inner=inner,
        outer=outer,
        area=area,
        exact_fits=fits,
        contacts=contacts,
        inner_drawn=_evidence(certificate["inner_drawn"], "inner_drawn", len(inner), drawing),
        outer_drawn=_evidence(certificate["outer_drawn"], "outer_drawn", len(outer), drawing),
    )


def check_keys(certificate: Any, fields: Collection[str]) -> None:
    """Check that a certificate is an object of this format, with these keys and no others."""
    if type(certificate) is not dict:
        raise CertificateError(f"a certificate is an object, not a {type(certificate).__name__}")
    for key in ("format", "version", *fields):
        if key not in certificate:
            raise CertificateError(f"the key {key!r} is missing")
    if len(certificate) > 2 + len(fields):
        raise CertificateError("there are unknown keys")
    if not is_exactly(certificate["format"], str, FORMAT):
        raise CertificateError(f"format is not {FORMAT!r}")
    if not is_exactly(certificate["version"], int, VERSION):
        raise CertificateError(f"version is not {VERSION}")


def is_exactly(item: Any, kind: type, value: object) -> bool:
    """Equality of values of one type only: True is not 1."""
    return type(item) is kind and bool(item == value)


def flaw(place: KeyPath, what: str, witness: Point | None = None) -> CertificateError:
    """The error that describes a flaw at a place."""
    path = ""
    while isinstance(place, tuple):
        place, last = place
        path = (f"[{last}]" if isinstance(last, int) else last) + path
    return CertificateError(f"{place}{path}: {what}", witness)


def read_list(item: Any, place: KeyPath, entry: Callable[[Any, KeyPath], _T]) -> tuple[_T, ...]:
    """Read a list, each entry with its place."""
    if type(item) is not list:
        raise flaw(place, f"a {type(item).__name__}, not a list")
    return tuple([entry(value, (place, k)) for k, value in enumerate(item)])


def read_tuple(item: Any, place: KeyPath, length: int) -> list[Any]:
    """Take a list of a known length apart."""
    if type(item) is not list or len(item) != length:
        raise flaw(place, f"not a list of {length}")
    return item


def read_number(item: Any, place: KeyPath) -> Fraction:
    """Read a rational in lowest terms."""
    if type(item) is not str:
        raise flaw(place, f"a {type(item).__name__}, not a number in a string")
    if len(item) <= _SHORT:
        # A number in normal form is read in a fifth of the time. Comparing it with its text
        # excludes the other notations that int() accepts.
        n, _, d = item.partition("/")
        try:
            above, below = int(n), int(d or 1)
        except ValueError:
            below = 0
        if below > 0 and str(value := divide_exactly(above, below)) == item:
            return value
    try:
        value = read_any_length(item)
    except NumberError as error:
        raise flaw(place, str(error)) from None
    # A text of digits alone has been read as an int.
    if not item.isdecimal() and format_fraction(value) != item:
        raise flaw(place, "not a number in lowest terms")
    return value


def _point(item: Any, place: KeyPath) -> Point:
    x, y = read_tuple(item, place, 2)
    return Point(read_number(x, (place, 0)), read_number(y, (place, 1)))


def _read_ints(item: Any) -> Loop | None:
    """Read points whose coordinates are ints as Python writes them, all at once, in half the time.

    `read_number` reads all other points one number at a time, and so finds the place of an error.
    """
    if type(item) is not list or set(map(type, item)) != {list} or set(map(len, item)) != {2}:
        return None
    texts = [*chain.from_iterable(item)]
    if set(map(type, texts)) != {str} or max(map(len, texts)) > _SHORT:
        return None
    try:
        numbers = [*map(int, texts)]
    except ValueError:
        return None
    if [*map(str, numbers)] != texts:
        return None
    found = divide_all(numbers, 1)
    return tuple(map(Point._make, zip(found[::2], found[1::2], strict=True)))


def read_loop(item: Any, name: KeyPath) -> Loop:
    """Read a loop of at least three points, the least one first."""
    points = _read_ints(item) or read_list(item, name, _point)
    if len(points) < 3:
        raise flaw(name, "fewer than three vertices")
    if (least := points[find_least(points)]) != points[0]:
        raise flaw(name, "not canonical, its least vertex is not the first", least)
    return points


def read_fit(item: Any, place: KeyPath) -> Fit:
    """Read a pair of points."""
    hanging, end = read_tuple(item, place, 2)
    return _point(hanging, (place, 0)), _point(end, (place, 1))


def _direction(item: Any) -> tuple[int, int]:
    p, q = (_read_long_int(c) if type(c) is str else c for c in read_tuple(item, "direction", 2))
    if type(p) is not int or type(q) is not int:
        raise CertificateError("direction: not a pair of integers")
    if gcd(p, q) != 1 or not (p > 0 or (p, q) == (0, 1)):
        raise CertificateError("direction: not primitive")
    return p, q


def _read_long_int(text: str) -> int | Fraction:
    """Read an int that Python's reader of JSON would refuse."""
    value = read_number(text, "direction")
    is_long = value.denominator == 1 and len(text) > DIGITS_OF_AN_INT
    return value.numerator if is_long else value


def _index(item: Any, length: int, place: KeyPath) -> int:
    if type(item) is not int or not 0 <= item < length:
        raise flaw(place, f"not an index below {length}")
    return item


def _feature(item: Any, length: int, place: KeyPath) -> ListedFeature:
    kind, index = read_tuple(item, place, 2)
    if kind not in ("vertex", "edge"):
        raise flaw(place, "neither a vertex nor an edge")
    return kind, _index(index, length, place)


def _evidence(
    item: Any, name: str, edges: int, entry: Callable[[Any, KeyPath], _T]
) -> tuple[tuple[_T, ...], ...]:
    lists = read_list(item, name, lambda listed, place: read_list(listed, place, entry))
    if len(lists) != edges:
        raise CertificateError(f"{name}: {len(lists)} lists for a loop of {edges} edges")
    for k, listed in enumerate(lists):
        if len(listed) > 1 and len(set(listed)) < len(listed):
            raise CertificateError(f"{name}[{k}]: something is listed twice")
    return lists
