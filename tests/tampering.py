"""Change certificates in one place, so that they are no longer true: `python -m tests.tampering`.

All changes have to be caught.
"""

import copy
import random
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import click

from exactsweep import sweep
from exactsweep.check import verify
from exactsweep.numbers.digits import format_fraction

# The tests import one another by bare names, as pytest sets them up.
sys.path.insert(0, str(Path(__file__).parent / "support"))
from families import random_pair

Certificate = dict[str, Any]
Change = tuple[str, Certificate]
Vertex = tuple[Fraction, Fraction]

LOOPS = {"trajectory": "contacts", "inner": "inner_drawn", "outer": "outer_drawn"}
NUDGE = Fraction(1, 10**9)


def changes(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    """Every kind of single change, each at a place drawn at random, with what it is called."""
    for part in (_loops, _inputs, _contacts, _drawings, _fits, _rest):
        for name, changed in part(certificate, rng):
            if changed != certificate:
                yield name, changed


def get(item: Any, path: Iterable[Any]) -> Any:
    for key in path:
        item = item[key]
    return item


def put(item: Any, path: Sequence[Any], value: Any) -> Any:
    """Copy a certificate, or a part, with another value at one place."""
    changed = copy.deepcopy(item)
    get(changed, path[:-1])[path[-1]] = value
    return changed


def _moved(number: str, by: Fraction) -> str:
    return format_fraction(Fraction(number) + by)


def _nudge(certificate: Certificate, path: Sequence[Any], by: Fraction) -> Certificate:
    moved: Certificate = put(certificate, path, _moved(get(certificate, path), by))
    return moved


def _loops(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    for loop, evidence in LOOPS.items():
        points, drawn = certificate[loop], certificate[evidence]
        n = len(points)
        for axis in (0, 1):
            for by in (-NUDGE, NUDGE):
                yield (
                    f"{loop}: vertex moved",
                    _nudge(certificate, (loop, rng.randrange(n), axis), by),
                )
        i, j = rng.sample(range(n), 2)
        swapped = [points[{i: j, j: i}.get(k, k)] for k in range(n)]
        yield f"{loop}: vertices swapped", {**certificate, loop: swapped}
        k = rng.randrange(n)
        a, b = (tuple(map(Fraction, points[m % n])) for m in (k, k + 1))
        middle = [format_fraction((p + q) / 2) for p, q in zip(a, b, strict=True)]
        for name, changed, edges in (
            ("vertex dropped", points[:k] + points[k + 1 :], drawn[:k] + drawn[k + 1 :]),
            ("vertex repeated", points[: k + 1] + points[k:], drawn[: k + 1] + drawn[k:]),
            (
                "collinear vertex",
                [*points[: k + 1], middle, *points[k + 1 :]],
                drawn[: k + 1] + drawn[k:],
            ),
        ):
            yield f"{loop}: {name}", {**certificate, loop: changed}
            yield f"{loop}: {name}", {**certificate, loop: changed, evidence: edges}
        elsewhere = {key: certificate[key][1:] + certificate[key][:1] for key in (loop, evidence)}
        yield f"{loop}: begins elsewhere", {**certificate, **elsewhere}
        yield f"{loop}: clockwise", {**certificate, loop: points[:1] + points[:0:-1]}
        moved = [[_moved(x, NUDGE), y] for x, y in points]
        yield f"{loop}: moved as a whole", {**certificate, loop: moved}
        for other in LOOPS.keys() - {loop}:
            if points != certificate[other]:
                yield "loop: given as another one", {**certificate, loop: certificate[other]}
                yield "loops exchanged", {**certificate, loop: certificate[other], other: points}


def _inputs(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    for key in ("generatrix", "directrix"):
        points = certificate[key]
        place = key, rng.randrange(len(points)), rng.randrange(2)
        moved = _nudge(certificate, place, rng.choice([-NUDGE, NUDGE]))
        if _is_other_problem(moved):
            yield f"{key}: vertex moved", moved
        k = rng.randrange(len(points))
        yield f"{key}: vertex dropped", {**certificate, key: points[:k] + points[k + 1 :]}
    g, d = certificate["generatrix"], certificate["directrix"]
    yield "polygons exchanged", {**certificate, "generatrix": d, "directrix": g}


def _is_other_problem(changed: Certificate) -> bool:
    """A vertex that no loop feels, say at the bottom of a deep notch of G, may as well move."""
    try:
        s = sweep(
            changed["generatrix"],
            changed["directrix"],
            reference=changed["reference"],
            direction=changed["direction"],
        )
    except ValueError:
        return True
    true = s.certificate()
    return any(true[key] != changed[key] for key in (*LOOPS, "contacts", "exact_fits", "kind"))


def _contacts(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    edges = certificate["contacts"]
    k = rng.randrange(len(edges))
    listed, other = edges[k], edges[k - 1]
    m = rng.randrange(len(listed))
    rest, (event, i, j) = listed[:m] + listed[m + 1 :], listed[m]
    g, d = (len(certificate[key]) for key in ("generatrix", "directrix"))
    found = {
        "index changed": [[event, (i + rng.randrange(1, g)) % g, j]],
        "another index changed": [[event, i, (j + rng.randrange(1, d)) % d]],
        **{f"{name} instead": [[name, i, j]] for name in ("EV", "VE", "EE") if name != event},
        "one dropped": [],
        "one repeated": [listed[m], listed[m]],
    }
    if (added := rng.choice(other)) not in listed:
        found["one added"] = [listed[m], added]
    for name, entries in found.items():
        yield f"contacts: {name}", put(certificate, ("contacts", k), sorted([*rest, *entries]))
    swapped = put(certificate, ("contacts", k), other)
    yield "contacts: edges swapped", put(swapped, ("contacts", k - 1), listed)


def _drawings(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    for loop in ("inner", "outer"):
        key = LOOPS[loop]
        k = rng.randrange(len(certificate[key]))
        listed = certificate[key][k]
        m = rng.randrange(len(listed))
        found = {"one dropped": listed[:m] + listed[m + 1 :]}
        for item, of in ((0, "trajectory"), (1, "generatrix")):
            (kind, n), size = listed[m][item], len(certificate[of])
            found[f"place on the {of} changed"] = put(
                listed, (m, item, 1), (n + rng.randrange(1, size)) % size
            )
            found[f"feature of the {of} changed"] = put(
                listed, (m, item, 0), "edge" if kind == "vertex" else "vertex"
            )
        for name, changed in found.items():
            if not draws(certificate, loop, k, changed):
                yield f"{key}: {name}", put(certificate, (key, k), changed)
        another = put(certificate, (key, k), certificate[key][k - 1])
        yield f"{key}: given as that of another edge", another


def draws(certificate: Certificate, loop: str, k: int, drawings: Iterable[Any]) -> bool:
    """Decide by brute force whether all drawings lie along edge k of a loop and cover it."""
    p, q = (_vertex(certificate, loop, m) for m in (k, k + 1))
    along = q[0] - p[0], q[1] - p[1]
    square = along[0] ** 2 + along[1] ** 2
    rx, ry = map(Fraction, certificate["reference"])
    pieces = []
    for (where, i), (what, j) in drawings:
        shares = []
        for t in _ends(certificate, "trajectory", where, i):
            for g in _ends(certificate, "generatrix", what, j):
                x, y = t[0] - rx + g[0] - p[0], t[1] - ry + g[1] - p[1]
                if along[0] * y != along[1] * x:
                    return False
                shares.append((along[0] * x + along[1] * y) / square)
        piece = max(min(shares), Fraction(0)), min(max(shares), Fraction(1))
        if piece[0] >= piece[1]:
            return False
        pieces.append(piece)
    reach = Fraction(0)
    for low, high in sorted(pieces):
        if low > reach:
            return False
        reach = max(reach, high)
    return reach == 1


def _ends(certificate: Certificate, loop: str, kind: str, k: int) -> list[Vertex]:
    return [_vertex(certificate, loop, m) for m in ((k, k + 1) if kind == "edge" else (k,))]


def _vertex(certificate: Certificate, loop: str, k: int) -> Vertex:
    x, y = certificate[loop][k % len(certificate[loop])]
    return Fraction(x), Fraction(y)


def _fits(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    fits = certificate["exact_fits"]
    x, y = certificate["trajectory"][rng.randrange(len(certificate["trajectory"]))]
    for by in (NUDGE, -NUDGE):
        added = sorted([*fits, [[x, y], [x, _moved(y, by)]]], key=_as_points)
        yield "exact_fits: one added", {**certificate, "exact_fits": added}
    if not fits:
        return
    k = rng.randrange(len(fits))
    for end, axis, by in product((0, 1), (0, 1), (NUDGE, -NUDGE)):
        moved = _nudge(certificate, ("exact_fits", k, end, axis), by)
        yield "exact_fits: one longer, shorter or askew", moved
    for name, instead in (
        ("one dropped", []),
        ("one repeated", [fits[k], fits[k]]),
        ("hangs by the wrong end", [fits[k][::-1]]),
    ):
        changed = [*fits[:k], *instead, *fits[k + 1 :]]
        yield f"exact_fits: {name}", {**certificate, "exact_fits": changed}


def _as_points(fit: Any) -> list[list[Fraction]]:
    return [[Fraction(coordinate) for coordinate in point] for point in fit]


def _rest(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    for by in (NUDGE, -NUDGE):
        yield "area changed", {**certificate, "area": _moved(certificate["area"], by)}
        x, y = certificate["reference"]
        yield "reference moved", {**certificate, "reference": [_moved(x, by), y]}
        yield "reference moved", {**certificate, "reference": [x, _moved(y, by)]}
    for kind in ("CC", "CM", "MM"):
        yield "kind changed", {**certificate, "kind": kind}
    p, q = certificate["direction"]
    yield "direction not primitive", {**certificate, "direction": [-p, -q]}
    yield "direction not primitive", {**certificate, "direction": [2 * p, 2 * q]}
    for direction in ([0, 1], [1, 1], [1, -1], [3, 1]):
        if not _is_shared(certificate, direction):
            yield "direction not shared", {**certificate, "direction": direction}
    yield "version changed", {**certificate, "version": 1}
    yield "format changed", {**certificate, "format": "exactsweep"}
    key = rng.choice(sorted(certificate))
    yield "key dropped", {k: v for k, v in certificate.items() if k != key}
    yield "key added", {**certificate, "comment": ""}


def _is_shared(certificate: Certificate, direction: list[int]) -> bool:
    try:
        sweep(certificate["generatrix"], certificate["directrix"], direction=direction)
    except ValueError:
        return False
    return True


def tamper(
    certificates: Iterable[Certificate], rng: random.Random
) -> tuple[Counter[str], list[Change]]:
    """The number of trials of each kind of change, and the changes that were not caught."""
    tried: Counter[str] = Counter()
    missed = []
    for certificate in certificates:
        for name, changed in changes(certificate, rng):
            tried[name] += 1
            if verify(changed).proved:
                missed.append((name, changed))
    return tried, missed


def report(tried: Counter[str], missed: list[Change]) -> str:
    lost = Counter(name for name, _ in missed)
    lines = [f"{tried[name] - lost[name]:7} of {tried[name]:7}  {name}" for name in sorted(tried)]
    return "\n".join([*lines, f"{tried.total() - lost.total():7} of {tried.total():7}  caught"])


@click.command()
@click.option("--certificates", default=500, show_default=True, help="How many.")
@click.option("--seed", default=1, show_default=True)
def main(certificates: int, seed: int) -> None:
    """Tamper with the certificates of random pairs, and count what is caught."""
    rng = random.Random(seed)
    pairs = (random_pair(rng) for _ in range(certificates))
    tried, missed = tamper((sweep(p.generatrix, p.directrix).certificate() for p in pairs), rng)
    click.echo(report(tried, missed))
    sys.exit(bool(missed))


if __name__ == "__main__":
    main()
