"""Change certificates in one place, so that they are no longer true: `python -m tests.tampering`.

All changes have to be caught.
"""

import marshal
import random
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import click

from exactsweep import sweep
from exactsweep.check import verify
from exactsweep.numbers.number import format_fraction

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


def _edited(certificate: Certificate) -> Certificate:
    copied: Certificate = marshal.loads(marshal.dumps(certificate))
    return copied


def _moved(number: str, by: Fraction) -> str:
    return format_fraction(Fraction(number) + by)


def _loops(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    for loop, evidence in LOOPS.items():
        n = len(certificate[loop])
        for axis in (0, 1):
            for by in (-NUDGE, NUDGE):
                c = _edited(certificate)
                point = c[loop][rng.randrange(n)]
                point[axis] = _moved(point[axis], by)
                yield f"{loop}: vertex moved", c
        i, j = rng.sample(range(n), 2)
        c = _edited(certificate)
        c[loop][i], c[loop][j] = c[loop][j], c[loop][i]
        yield f"{loop}: vertices swapped", c
        k = rng.randrange(n)
        for with_evidence in (False, True):
            c = _edited(certificate)
            del c[loop][k]
            if with_evidence:
                del c[evidence][k]
            yield f"{loop}: vertex dropped", c
            c = _edited(certificate)
            c[loop].insert(k, c[loop][k])
            if with_evidence:
                c[evidence].insert(k, c[evidence][k])
            yield f"{loop}: vertex repeated", c
            a, b = (tuple(map(Fraction, certificate[loop][m % n])) for m in (k, k + 1))
            middle = [format_fraction((p + q) / 2) for p, q in zip(a, b, strict=True)]
            c = _edited(certificate)
            c[loop].insert(k + 1, middle)
            if with_evidence:
                c[evidence].insert(k, c[evidence][k])
            yield f"{loop}: collinear vertex", c
        c = _edited(certificate)
        for key in (loop, evidence):
            c[key] = c[key][1:] + c[key][:1]
        yield f"{loop}: begins elsewhere", c
        c = _edited(certificate)
        c[loop] = c[loop][:1] + c[loop][:0:-1]
        yield f"{loop}: clockwise", c
        c = _edited(certificate)
        c[loop] = [[_moved(x, NUDGE), y] for x, y in c[loop]]
        yield f"{loop}: moved as a whole", c
        for other in LOOPS.keys() - {loop}:
            if certificate[loop] != certificate[other]:
                c = _edited(certificate)
                c[loop] = c[other]
                yield "loop: given as another one", c
                exchanged = {loop: certificate[other], other: certificate[loop]}
                yield "loops exchanged", {**certificate, **exchanged}


def _inputs(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    for key in ("generatrix", "directrix"):
        c = _edited(certificate)
        point = c[key][rng.randrange(len(c[key]))]
        axis = rng.randrange(2)
        point[axis] = _moved(point[axis], rng.choice([-NUDGE, NUDGE]))
        if _is_other_problem(c):
            yield f"{key}: vertex moved", c
        c = _edited(certificate)
        del c[key][rng.randrange(len(c[key]))]
        yield f"{key}: vertex dropped", c
    if certificate["generatrix"] != certificate["directrix"]:
        c = _edited(certificate)
        c["generatrix"], c["directrix"] = c["directrix"], c["generatrix"]
        yield "polygons exchanged", c


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
    k = rng.randrange(len(certificate["contacts"]))
    listed = certificate["contacts"][k]
    m = rng.randrange(len(listed))
    for item, count in ((1, len(certificate["generatrix"])), (2, len(certificate["directrix"]))):
        c = _edited(certificate)
        c["contacts"][k][m][item] = (listed[m][item] + rng.randrange(1, count)) % count
        c["contacts"][k].sort()
        yield "contacts: index changed", c
    for event in {"EV", "VE", "EE"} - {listed[m][0]}:
        c = _edited(certificate)
        c["contacts"][k][m][0] = event
        c["contacts"][k].sort()
        yield "contacts: event changed", c
    c = _edited(certificate)
    del c["contacts"][k][m]
    yield "contacts: one dropped", c
    added = rng.choice(certificate["contacts"][k - 1])
    if added not in listed:
        c = _edited(certificate)
        c["contacts"][k] = sorted([*listed, added])
        yield "contacts: one added", c
    c = _edited(certificate)
    c["contacts"][k].insert(m, listed[m])
    yield "contacts: one repeated", c
    c = _edited(certificate)
    c["contacts"][k], c["contacts"][k - 1] = c["contacts"][k - 1], c["contacts"][k]
    yield "contacts: edges swapped", c


def _drawings(certificate: Certificate, rng: random.Random) -> Iterator[Change]:
    for loop in ("inner", "outer"):
        key = LOOPS[loop]
        k = rng.randrange(len(certificate[key]))
        listed = certificate[key][k]
        m = rng.randrange(len(listed))
        for item, of in ((0, "trajectory"), (1, "generatrix")):
            c = _edited(certificate)
            feature = c[key][k][m][item]
            feature[1] = (feature[1] + rng.randrange(1, len(c[of]))) % len(c[of])
            if not draws(c, loop, k, c[key][k]):
                yield f"{key}: place changed", c
            c = _edited(certificate)
            feature = c[key][k][m][item]
            feature[0] = "edge" if feature[0] == "vertex" else "vertex"
            if not draws(c, loop, k, c[key][k]):
                yield f"{key}: feature changed", c
        c = _edited(certificate)
        del c[key][k][m]
        if not draws(c, loop, k, c[key][k]):
            yield f"{key}: one dropped", c
        c = _edited(certificate)
        c[key][k] = c[key][k - 1]
        yield f"{key}: given as that of another edge", c


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
        c = _edited(certificate)
        c["exact_fits"] = sorted([*fits, [[x, y], [x, _moved(y, by)]]], key=_as_points)
        yield "exact_fits: one added", c
    if not fits:
        return
    k = rng.randrange(len(fits))
    for end in (0, 1):
        for axis in (0, 1):
            for by in (NUDGE, -NUDGE):
                c = _edited(certificate)
                point = c["exact_fits"][k][end]
                point[axis] = _moved(point[axis], by)
                yield "exact_fits: one longer, shorter or askew", c
    c = _edited(certificate)
    del c["exact_fits"][k]
    yield "exact_fits: one dropped", c
    c = _edited(certificate)
    c["exact_fits"].insert(k, fits[k])
    yield "exact_fits: one repeated", c
    c = _edited(certificate)
    c["exact_fits"][k].reverse()
    yield "exact_fits: hangs by the wrong end", c


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
