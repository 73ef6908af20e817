"""Answers as large as the paper says that they can get, and larger."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, box, turned, under
from exactsweep.corpus.generator.growing import bumps, comb

TITLE = "Answers as large as they can get"

FLAG = ("lower-bound",)


def polygon(n: int) -> Ring:
    """Convex, with 2 n edges of different slopes and their opposites."""
    steps = [(n, k) for k in range(-n // 2, n - n // 2)]
    chain = [(0, 0)]
    for dx, dy in [*steps, *((-x, -y) for x, y in steps)]:
        chain.append((chain[-1][0] + dx, chain[-1][1] + dy))
    return chain[:-1]


# Distances without a pattern.
PLACES = [0, 300, 691, 1013, 1502, 1844, 2365, 2700, 3131, 3651, 4000, 4507, 4900, 5403, 5801]
PLACES += [6388, 6700]


def zigzag() -> Ring:
    """Peaks and valleys at PLACES above, a point below."""
    top = [(4 * x, 10_000 * (k % 2)) for k, x in enumerate(PLACES)]
    return [(0, 0), (2 * PLACES[-1], -10_000), *top[:0:-1]]


def needles(count: int) -> Ring:
    """Needles hanging from a high ceiling, nearly as far apart as the zigzag is wide."""
    apart, ceiling = 4 * PLACES[-1] - 2 * PLACES[1], 80_000
    tips = [(k * apart + aside, y) for k in range(count) for aside, y in ((-1, 1), (0, 0), (1, 1))]
    bottom = [(x, ceiling * y) for x, y in tips]
    return [*bottom, (bottom[-1][0] // 2, ceiling + 1)]


def entries() -> Iterator[Entry]:
    for n in 2, 4, 8:
        for teeth in 2, 4:
            g = polygon(n)
            width = n * n
            size = f"{teeth} teeth a side, G of {2 * n} edges"
            yield Entry(
                f"trajectory-cm-{teeth}-{n}",
                f"Corollaries 4.3 and 4.4: {size}",
                comb(4 * teeth, 2 * width, 20 * width),
                g,
                FLAG,
            )
            yield Entry(
                f"fine-comb-cm-{teeth}-{n}",
                f"{size}, wider than two gaps",
                comb(4 * teeth, 2 * width // 5 + 1, 20 * width),
                g,
                FLAG,
            )
    for sizes in (2, 4, 8), (4, 4, 8), (6, 4, 4), (6, 6, 8), (2, 8, 4):
        g, d = bumps(*sizes)
        name = "-".join(map(str, sizes))
        yield Entry(
            f"outer-mm-{name}",
            f"Lemma 5.6: outer boundary of {name.replace('-', ', ')}",
            d,
            g,
            FLAG,
        )
        yield Entry(
            f"outer-mm-{name}-above",
            f"Lemma 5.6: outer boundary of {name.replace('-', ', ')}, above",
            turned(d),
            turned(g),
            FLAG,
        )
    for count in 2, 3:
        yield Entry(
            f"inner-mm-{count}",
            f"Lemma 5.5 as corrected: {count} needles before a zigzag, and order m n^2 inner edges",
            needles(count),
            zigzag(),
            FLAG,
        )
    yield Entry(
        "crossed-combs",
        "Lemma 5.2: combs of 6 and 5 teeth, their pitches prime to each other",
        comb(24, 11, 400),
        turned(comb(20, 13, 400)),
        FLAG,
    )
    yield Entry(
        "crossed-combs-fine",
        "Lemma 5.2: a fine comb over a coarse one",
        comb(12, 37, 400),
        comb(20, 5, 300),
        FLAG,
    )
    yield Entry("wide-comb", "Eight teeth and a square", comb(32, 3, 10), UNIT, FLAG)
    yield Entry(
        "wide-comb-bar",
        "Eight teeth and a bar that closes several gaps at once",
        comb(32, 3, 10),
        box(11, 1),
        FLAG,
    )
    yield Entry(
        "stairs-of-parts",
        "Convex parts of D, each lower than all before it",
        under([(k, -(k * k) // 2 - 3 * (k % 2)) for k in range(12)], 5),
        polygon(4),
        FLAG,
    )
