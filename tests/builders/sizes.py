"""The same pairs at every size, at the edges of number types, far from the origin, and unequal."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import UNIT, Entry, Ring, box, moved, scaled, under

TITLE = "Huge, tiny, far away, and at the edges of int32, int64 and binary64"

BLOCK: Ring = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]
HOUSE: Ring = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
LEAF: Ring = [(0, 0), (3, -2), (7, 1), (4, 3)]
ROOF: Ring = under([(0, 0), (2, 2), (4, 0)], 4)


def entries() -> Iterator[Entry]:
    factors: list[tuple[str, int | Fraction]] = [
        ("10-30", 10**30),
        ("10-minus-30", Fraction(1, 10**30)),
        ("10-300", 10**300),
        ("10-400", 10**400),
        ("thirds", Fraction(1, 3)),
        ("2-minus-40", Fraction(1, 2**40)),
        ("2-60", 2**60),
    ]
    for name, factor in factors:
        yield Entry(
            f"times-{name}",
            f"A notched block, scaled: {name}",
            scaled(BLOCK, factor),
            scaled(HOUSE, factor),
        )
    for bits in 32, 64:
        low, high = -(2 ** (bits - 1)), 2 ** (bits - 1) - 1
        square: Ring = [(low, low), (high, low), (high, high), (low, high)]
        yield Entry(f"int{bits}-full", f"The full range of int{bits} around itself", square, square)
        yield Entry(
            f"int{bits}-unit", f"A unit square around the full range of int{bits}", square, UNIT
        )
        yield Entry(
            f"int{bits}-low-corner",
            f"Squares in opposite corners of int{bits}",
            box(1, 1, low, low),
            box(1, 1, high - 1, high - 1),
        )
        yield Entry(
            f"int{bits}-diagonals",
            f"Triangles over the diagonals of int{bits}",
            [(low, low), (high, low), (high, high)],
            [(low, high), (low, low), (high, high)],
        )
        yield Entry(
            f"int{bits}-notch",
            f"A notch as wide as int{bits}",
            [(low, low), (0, high - 1), (high, low), (high, high), (low, high)],
            [(low, 0), (0, low), (high, 0), (0, high)],
        )
        half, small = 2 ** (bits // 2), 2 ** (bits // 2 - 1)
        yield Entry(
            f"int{bits}-products",
            f"Coordinates whose products just leave int{bits}",
            [(0, 0), (half, 1), (half + 1, half), (1, half - 1)],
            [(0, 0), (small, -1), (small + 1, small)],
        )
    least = Fraction(1, 2**1074)
    yield Entry(
        "binary64-least",
        "Multiples of the least binary64",
        scaled(BLOCK, least),
        scaled(HOUSE, least),
    )
    yield Entry(
        "binary64-least-normal",
        "Multiples of the least normal binary64",
        scaled(BLOCK, Fraction(1, 2**1022)),
        scaled(HOUSE, Fraction(1, 2**1022)),
    )
    yield Entry(
        "binary64-greatest",
        "Near the greatest binary64; the answer is within",
        scaled(BLOCK, 2**1020),
        scaled(HOUSE, 2**1018),
    )
    yield Entry(
        "binary64-overflow",
        "The answer is beyond the greatest binary64",
        scaled(UNIT, MAX),
        scaled(UNIT, MAX),
    )
    yield Entry(
        "binary64-53-bits", "Odd numbers of 53 bits, which doubles still hold", *odd(2**53 - 1)
    )
    yield Entry(
        "binary64-54-bits", "Odd numbers of 54 bits, which doubles do not hold", *odd(2**53 + 1)
    )
    yield Entry(
        "binary64-mixed",
        "The least and a great binary64 in one polygon",
        [(0, 0), (2**100, 0), (2**100, 2**100), (0, 2**100)],
        [(0, 0), (2**100, 0), (0, Fraction(1, 2**900))],
    )
    yield Entry(
        "tenths",
        "Tenths, which doubles do not hold",
        scaled(BLOCK, Fraction(1, 10)),
        scaled(HOUSE, Fraction(1, 10)),
    )
    yield Entry(
        "far-2-52",
        "Moved by 2^52, where doubles have no fractions",
        moved(ROOF, 2**52, -(2**52)),
        moved(UNIT, -(2**52), 2**52),
    )
    yield Entry(
        "far-10-18",
        "Moved by 10^18, where doubles have no units",
        moved(BLOCK, 10**18, 10**18),
        HOUSE,
    )
    yield Entry("far-g", "G alone moved by 10^18", BLOCK, moved(HOUSE, -(10**18), 3))
    yield Entry(
        "far-halves",
        "Moved by 10^15, on eighths",
        moved(scaled(ROOF, Fraction(1, 8)), 10**15, 0),
        scaled(UNIT, Fraction(1, 8)),
    )
    for k in 3, 9, 18, 40:
        yield Entry(
            f"g-small-{k}",
            f"G is 10^{k} times smaller than D",
            BLOCK,
            scaled(HOUSE, Fraction(1, 10**k)),
        )
        yield Entry(f"g-large-{k}", f"G is 10^{k} times larger than D", BLOCK, scaled(HOUSE, 10**k))
    yield Entry(
        "long-fractions",
        "Denominators that have nothing in common",
        scattered(BLOCK),
        scattered(HOUSE),
    )
    yield Entry("leaf-in-leaf", "A D of 10^12 with details of 1", DETAILED, LEAF)


MAX = 2**1024 - 2**971
_PRIMES = [
    10007,
    10009,
    10037,
    10039,
    10061,
    10067,
    10069,
    10079,
    10091,
    10093,
    10099,
    10103,
    10111,
    10133,
]
DETAILED: Ring = under(
    [(0, 0), (10**12, 0), (10**12 + 1, 2), (10**12 + 3, 0), (2 * 10**12, 0)], 10**12
)


def odd(number: int) -> tuple[Ring, Ring]:
    return (
        [(0, 0), (number, 1), (number - 2, number), (-1, number - 2)],
        [(0, 0), (number - 4, -1), (number - 2, number - 6)],
    )


def scattered(ring: Ring) -> Ring:
    """Every coordinate moved by a fraction of its own; equal abscissas alike."""
    aside = {x: Fraction(1, _PRIMES[k]) for k, x in enumerate(sorted({x for x, _ in ring}))}
    return [(x + aside[x], y + Fraction(1, _PRIMES[-1 - k])) for k, (x, y) in enumerate(ring)]
