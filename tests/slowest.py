"""Search for the slowest certificates of 100 kB: `python -m tests.slowest`.

The checker must end within half a minute and a gigabyte. The search draws files of every kind, and
changes the slowest one as long as that makes it slower.
"""

from __future__ import annotations

import json
import resource
import sys
import time
from collections.abc import Callable, Mapping
from fractions import Fraction
from random import Random
from typing import Any

import click

from exactsweep.check.standalone import Refused, prove

Ring = list[list[str]]
Certificate = dict[str, Any]

BYTES = 100_000
SECONDS, MEGABYTES = 30, 1000
HEAD = {"format": "exactsweep certificate", "version": 3}


def write(points: list[tuple[Any, Any]]) -> Ring:
    return [[str(x), str(y)] for x, y in points]


def rectangle(left: Any, low: Any, right: Any, high: Any) -> Ring:
    return write([(left, low), (right, low), (right, high), (left, high)])


def least_first(points: list[tuple[Any, Any]]) -> Ring:
    k = points.index(min(points))
    return write(points[k:] + points[:k])


def claim_no_fit(
    d: tuple[Any, list[Ring]], g: tuple[Any, list[Ring]], loop: Ring, fits: Any = (), sums: Any = ()
) -> Certificate:
    proof = {"directrix": d[1], "generatrix": g[1], "sums": list(sums)}
    shapes = {"directrix": d[0], "generatrix": g[0], "exterior": loop, "holes": []}
    return {**HEAD, "claim": "no_fit", **shapes, "exact_fits": list(fits), "proof": proof}


def square(size: Any) -> tuple[Any, list[Ring]]:
    ring = rectangle(0, 0, size, size)
    return {"exterior": ring}, [ring]


def polygon(count: int, x: Any = 0) -> list[tuple[Any, Any]]:
    """Return a convex polygon on a parabola."""
    return [(x + k, k * k) for k in range(count)]


def crowd(n: int, digits: int) -> Certificate:
    """Return a tiny loop of large shapes, so that all boxes are in a single cell."""
    den = max(2 * n + 3, 10**digits)
    teeth = [(Fraction(1, den), Fraction(1, 3)), (Fraction(2 * n + 1, den), Fraction(1, 3))]
    for k in range(n, 0, -1):
        teeth += [
            (Fraction(2 * k + 1, den), Fraction(2, 3)),
            (Fraction(2 * k, den), Fraction(1, 2)),
        ]
    teeth.append((Fraction(1, den), Fraction(3, 5)))
    return claim_no_fit(square(10**40), square(10**40), least_first(teeth))


def strips(n: int, digits: int) -> Certificate:
    """Return two strips of triangles, and a loop with an edge whose box holds all of their sums."""
    den = 10**digits if digits > 1 else 0
    rows = [(k + (Fraction(1, den + 2 * k + 1) if den else 0), k % 2) for k in range(n + 2)]
    pieces = [rows[k : k + 3] if k % 2 else rows[k : k + 3][::-1] for k in range(n)]
    outline = rows[0::2] + rows[1::2][::-1]
    moved = [[(x + 2 * n, y) for x, y in piece] for piece in pieces]
    d = {"exterior": write([(x + 2 * n, y) for x, y in outline])}, [*map(write, moved)]
    far = 10 * n + 10
    loop = write([(-far, -far), (far, -far), (far, far)])
    return claim_no_fit(d, ({"exterior": write(outline)}, [*map(write, pieces)]), loop)


def corners(n: int, digits: int) -> Certificate:
    """Return two pieces with many corners, and a long fan of edges around their sum."""
    one = polygon(n // 2 + 3)
    d = {"exterior": write(one)}, [write(one)]
    size = n * n + 10**digits
    loop = [
        (-size, -size),
        (size, -size),
        *((size - k, -size + k * k + 1) for k in range(n)),
        (0, size * 9),
    ]
    return claim_no_fit(d, d, write(loop))


def slices(n: int, digits: int) -> Certificate:
    """Return slices with many corners along a diagonal, whose boxes overlap."""
    wide = max(2, digits)
    lines = [[(k + j, j * j * (2 if k else 1)) for j in range(wide)] for k in range(2)]
    ring = write(lines[1] + lines[0][::-1])
    strips = [[(k, 0), (k + 1, 0), (k + 10 * n + 1, 9 * n), (k + 10 * n, 9 * n)] for k in range(n)]
    outline = (
        rectangle(0, 0, 1, 1)
        if not strips
        else write([(0, 0), (n, 0), (11 * n, 9 * n), (10 * n, 9 * n)])
    )
    del ring
    return claim_no_fit(({"exterior": outline}, [*map(write, strips)]), square(1), outline)


def islands(n: int, digits: int) -> Certificate:
    """Return pieces without common vertices, and a loop of many edges."""
    squares = [[(3 * k, 0), (3 * k + 1, 0), (3 * k + 1, 1), (3 * k, 1)] for k in range(n)]
    shape = {"exterior": write([p for ring in squares for p in (*ring, ring[0])])}
    teeth = [(9 * n - k, 9 + (k % 2) * digits) for k in range(3 * n)]
    loop = write([(-9 * n, -9), (9 * n + 1, -9), *teeth])
    return claim_no_fit((shape, [*map(write, squares)]), (shape, [*map(write, squares)]), loop)


def fits_in_a_cell(n: int, digits: int) -> Certificate:
    """Fits, single points or crossing segments, in one cell."""
    den = 10**digits + 1
    points = [[str(Fraction(k + 1, den * n)), str(Fraction(1, k + 2))] for k in range(n)]
    fits = [[p, p if digits % 2 else points[0]] for p in points]
    return claim_no_fit(square(10**40), square(10**40), rectangle(-9, -9, 10**41, 9), fits)


def chains(n: int, digits: int) -> Certificate:
    """Return an entry whose chains refer repeatedly to sums or edges with many sides."""
    one = write(polygon(max(3, digits * 20)))
    d = {"exterior": one}, [one]
    far = 10**6
    sides = 2 * len(one)
    chain = [0 if digits % 2 else -1] * max(1, n // 4)
    sums = [[0, [chain, *[[0]] * (len(one) - 1)]]]
    del sides
    loop = write([(-far, -far), (far, -far), (0, far)])
    return claim_no_fit(d, square(1), loop, (), sums)


def long_numbers(n: int, digits: int) -> Certificate:
    """Long denominators, and chains that refer to them often."""
    den = 10 ** (digits * 40)
    d = [(Fraction(1, den + 1), Fraction(1, den + 3)), (Fraction(den, den + 7), 0), (0, 1)]
    shape = {"exterior": write(d)}, [write(d)]
    loop = write([(-3, Fraction(1, den + 9)), (3, -3), (3, 3)])
    chain = [-1, 0] * max(1, n // 8)
    return claim_no_fit(shape, shape, loop, (), [[0, [chain, *[[0]] * 5]]])


def zigzags(n: int, digits: int) -> Certificate:
    """Return a path of many segments, a strip of pieces, and an edge whose box holds all sums."""
    count, far = digits * 10, 9 * n + 99
    shape = {"exterior": rectangle(0, 0, count, 1)}
    path = write([(2 * far + 3 * k, k % 2 * digits) for k in range(n)])
    loop = write([(-far, -far), (9 * far, -far), (9 * far, far)])
    pieces = [rectangle(k, 0, k + 1, 1) for k in range(count)]
    proof = {"shape": pieces, "sums": [], "slits": []}
    answer = {"exterior": loop, "holes": [], "proof": proof}
    return {**HEAD, "claim": "sum", "shape": shape, "path": path, **answer}


def denominators(n: int, digits: int) -> Certificate:
    """Pieces of many points, each with a different denominator."""
    points = [(k + Fraction(1, 10**digits + 2 * k + 1), Fraction(k * k)) for k in range(n)]
    one = write(points)
    d = {"exterior": one}, [one]
    return claim_no_fit(
        d,
        d,
        write([(-(10**12), -(10**12)), (10**12, -(10**12)), (0, 10**12)]),
        (),
        [[0, [[-1], [-1]]]],
    )


def holes(n: int, digits: int) -> Certificate:
    """Return a region with many holes, with the frame as container."""
    ring, far = rectangle(0, 0, 9 * n, 9 * n), 9 * n - 1
    hole = [write([(3 * k + 1, 1), (3 * k + 2, 1), (3 * k + 1, 1 + digits)]) for k in range(n)]
    frame = ["0", "0", str(9 * n), str(9 * n)]
    shapes = {"container": {"exterior": ring}, "part": square(1)[0]}
    regions = [{"exterior": rectangle(0, 0, far, far), "holes": hole}]
    proof = {"frame": frame, "outside": [], "part": square(1)[1], "sums": [], "around": [[]] * 4}
    answer = {"regions": regions, "exact_fits": [], "proof": proof}
    return {**HEAD, "claim": "inner_fit", **shapes, **answer}


def layout(
    parts: list[Any], placements: list[Any], proof: Any = None, faults: Any = None, **more: Any
) -> Certificate:
    far = 10**6
    given = {"container": {"exterior": rectangle(0, 0, far, far)}, "parts": parts}
    body = {**HEAD, "claim": "layout", "layout": {**given, "placements": placements, **more}}
    turns = [["1", "0"]] * len(placements)
    if faults is not None:
        return {**body, "valid": False, "turns": turns, "faults": faults}
    frame = ["0", "0", str(far), str(far)]
    evidence = {"frame": frame, "pieces": [*proof, []], "apart": []}
    return {**body, "valid": True, "turns": turns, "proof": evidence}


def placements(n: int, digits: int) -> Certificate:
    """Return placements of a part of many pieces, near each other."""
    count = digits * 10
    pieces = [rectangle(k, 0, k + 1, 1) for k in range(count)]
    part = {"id": "a", "exterior": rectangle(0, 0, count, 1)}
    placed = [{"part": "a", "move": ["500000", str(10 + 2 * k)]} for k in range(n)]
    return layout([part], placed, [pieces], spacing="1", margin="1")


def faults(n: int, digits: int) -> Certificate:
    """Return witnesses in parts of many edges."""
    part = {"id": "a", "exterior": write(polygon(max(3, digits * 30)))}
    placed = [{"part": "a", "move": ["9", str(k)]} for k in range(n)]
    found = [
        {"kind": "overlap", "placements": [0, k], "point": ["11", str(n + 5)]} for k in range(1, n)
    ]
    return layout([part], placed, None, found)


def turned(n: int, digits: int) -> Certificate:
    """Placements at different rotations of a part whose points have long denominators."""
    points = [(k + Fraction(1, 10**digits + 2 * k + 1), Fraction(k * k)) for k in range(40)]
    placed = [{"part": "a", "move": ["500000", str(500 + 2 * k)]} for k in range(n)]
    found = layout([{"id": "a", "exterior": write(points)}], placed, [[write(points)]])
    turns = [
        [str(Fraction(k * k - 1, k * k + 1)), str(Fraction(2 * k, k * k + 1))]
        for k in range(2, n + 2)
    ]
    for entry, turn in zip(placed, turns, strict=True):
        entry["turn"] = turn
    return {**found, "turns": turns}


def rotations(n: int, digits: int) -> Certificate:
    """Return a layout with irrational rotations."""
    part = {"id": "a", "exterior": write(polygon(digits + 3))}
    placed = [{"part": "a", "turn": "1", "move": ["9", str(k)]} for k in range(n)]
    return layout([part], placed, None, [{"kind": "missing", "part": "a"}])


def rounded(n: int, digits: int) -> Certificate:
    """Pieces of many points in a rounded container of many points."""
    size = 40 + 10 * digits
    hull = write([(10**6 * x, 10**6 * x * x - 10**9) for x in range(-size, size + 1)])
    piece = {"points": write(polygon(max(3, digits * 5))), "radius": "1"}
    parts = [{"id": "a", "pieces": [piece]}]
    placed = [{"part": "a", "move": ["9", str(10**3 * k)]} for k in range(n)]
    found = layout(parts, placed, [None])
    found["layout"]["container"] = {"pieces": [{"points": hull, "radius": "9"}]}
    found["proof"]["frame"] = None
    return found


KINDS: Mapping[str, Callable[[int, int], Certificate]] = {
    kind.__name__: kind
    for kind in (crowd, strips, corners, slices, islands, fits_in_a_cell, chains, zigzags, holes)
} | {
    kind.__name__: kind
    for kind in (denominators, long_numbers, placements, faults, turned, rotations, rounded)
}


def fill(kind: str, digits: int, share: float = 1.0) -> Certificate:
    """Make a file of the maximum size, or of a share of it."""
    low, high = 3, 40_000
    while high - low > max(1, low // 50):
        middle = (low + high) // 2
        size = len(json.dumps(KINDS[kind](middle, digits), separators=(",", ":")))
        low, high = (middle, high) if size <= BYTES else (low, middle)
    return KINDS[kind](max(3, int(low * share)), digits)


def measure(certificate: Certificate) -> tuple[float, str]:
    """Return the processor time and the outcome of the checker."""
    start = time.process_time()
    try:
        verdict = prove(certificate)
    except Refused as refused:
        verdict = str(refused)
    return time.process_time() - start, verdict


def search(kind: str, seconds: float, rng: Random) -> tuple[float, str]:
    """Search for the slowest file of a kind; return its time and name."""
    found: tuple[float, str] = (0.0, "")
    digits, share, end = 1, 1.0, time.process_time() + seconds
    while time.process_time() < end:
        took, verdict = measure(fill(kind, digits, share))
        if took > found[0]:
            found, best = (
                (took, f"digits {digits}, share {share:.2f}: {verdict[:60]}"),
                (digits, share),
            )
        digits = max(1, int(best[0] * rng.choice([0.5, 1, 1, 1.5, 2, 4]) + rng.randint(0, 1)))
        share = min(1.0, max(0.02, best[1] * rng.choice([0.3, 0.6, 1, 1, 1.6])))
    return found


@click.command()
@click.option("--seconds", default=15.0, show_default=True, help="Time for each kind.")
@click.option("--seed", default=1, show_default=True)
@click.argument("kinds", nargs=-1, type=click.Choice(sorted(KINDS)))
def main(seconds: float, seed: int, kinds: tuple[str, ...]) -> None:
    """Search for the slowest certificate of each kind; exit with 1 if one is too slow."""
    slowest = 0.0
    sys.set_int_max_str_digits(0)
    for kind in kinds or KINDS:
        took, name = search(kind, seconds, Random(seed))
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1000
        click.echo(f"{took:6.2f} s {memory:5} MB  {kind}, {name}")
        slowest = max(slowest, took)
        if memory > MEGABYTES:
            sys.exit(1)
    sys.exit(slowest > SECONDS)


if __name__ == "__main__":
    main()
