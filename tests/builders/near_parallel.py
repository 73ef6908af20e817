"""Slopes that differ by one part in 10^15, where doubles and tolerances see no difference."""

from collections.abc import Iterator

from builders.entry import Entry, Ring, box, mapped, scaled, turned, under

TITLE = "Slopes that differ by one part in 10^15"

N = 10**15


def entries() -> Iterator[Entry]:
    wedge: Ring = [(0, 0), (N, 1), (0, 2)]
    tile: Ring = [(0, 0), (N, 0), (N, N), (0, N)]
    tilted: Ring = [(0, 0), (N, 1), (N - 1, N + 1), (-1, N)]
    fan: Ring = [(0, 0), (N, -2), (2 * N, -3), (3 * N, -3), (4 * N, -2), (5 * N, 0), (2 * N, N)]
    yield Entry("tiles", "Squares, one turned by one part in 10^15", tile, tilted)
    yield Entry(
        "tiles-back", "A square turned by one part in 10^15, the other one around it", tilted, tile
    )
    yield Entry(
        "tiles-opposite",
        "Squares turned against each other",
        tilted,
        [(0, 0), (N, -1), (N + 1, N - 1), (1, N)],
    )
    yield Entry("wedges", "Two wedges whose long sides are nearly parallel", wedge, turned(wedge))
    yield Entry("wedge-tile", "A wedge around a square", tile, wedge)
    yield Entry("fans", "Two fans of slopes k in 10^15 that alternate", fan, interleaved())
    yield Entry("fan-itself", "A fan around itself", fan, fan)
    yield Entry(
        "diagonals",
        "Diagonals of slope 1 and 1 + 10^-15",
        [(0, 0), (N, 0), (N, N)],
        [(0, 0), (N, 0), (N, N + 1)],
    )
    yield Entry(
        "steep",
        "Walls, one leaning by one part in 10^15",
        tile,
        [(0, 0), (N, 0), (N + 1, N), (1, N)],
    )
    yield Entry(
        "steep-and-upright-both",
        "Leaning walls of either sense",
        [(0, 0), (N, 0), (N + 1, N), (-1, N)],
        [(1, 0), (N, 0), (N + 1, N), (0, N)],
    )
    for k in (-1, 0, 1):
        word = {-1: "less steep than", 0: "as steep as", 1: "steeper than"}[k]
        yield Entry(
            f"tip-in-notch-{k + 1}",
            f"A tip {word} its notch, by one part in 10^15 or none",
            notch(),
            tip(k),
        )
    yield Entry("ripples", "A rippled bottom over a rippled top", ripple(1), turned(ripple(-1)))
    yield Entry(
        "ripples-on-a-slope",
        "A rippled bottom over a rippled top, on a slope of one",
        mapped(ripple(1), (1, 0, 1, 1)),
        mapped(turned(ripple(-1)), (1, 0, 1, 1)),
    )
    yield Entry("ripple-and-plank", "A plank over a rippled bottom", ripple(1), box(2 * N, N))
    yield Entry(
        "crossing-far-away",
        "Nearly parallel pieces that cross far out",
        under([(0, 0), (N, -N), (2 * N, 0), (3 * N, -N + 1), (4 * N, 0)], N),
        [(0, 0), (3 * N, 1), (3 * N, N), (0, N)],
    )
    yield Entry(
        "convergents",
        "Slopes are convergents of the golden ratio",
        convergents(30),
        convergents(31),
    )
    yield Entry(
        "convergents-64-bits",
        "Slopes are convergents of the golden ratio, of 60 bits",
        convergents(80),
        convergents(81),
    )
    yield Entry(
        "beyond-64-bits",
        "Slopes that differ by one part in 10^30",
        [(0, 0), (10**30, 0), (10**30, 10**30)],
        [(0, 0), (10**30, 0), (10**30, 10**30 + 1)],
    )
    yield Entry(
        "at-2-26",
        "Slopes that differ by one part in 2^52, their products rounding in doubles",
        scaled([(0, 0), (2**26, 0), (2**26, 2**26 - 1)], 1),
        [(0, 0), (2**26 + 1, 0), (2**26 + 1, 2**26)],
    )


def interleaved() -> Ring:
    return [(0, 0), (2 * N, -3), (4 * N, -4), (6 * N, -3), (8 * N, 0), (4 * N, N)]


def notch() -> Ring:
    return under([(0, 0), (N, N), (2 * N, 0)], 2 * N)


def tip(k: int) -> Ring:
    return [(0, 0), (2 * N, 0), (N, N + k)]


def ripple(sign: int) -> Ring:
    return under([(k * N, sign * (k % 2)) for k in range(5)], N)


def convergents(k: int) -> Ring:
    numbers = [0, 1]
    while len(numbers) < k + 2:
        numbers.append(numbers[-2] + numbers[-1])
    return [(0, 0), (numbers[k], 0), (numbers[k], numbers[k + 1])]
