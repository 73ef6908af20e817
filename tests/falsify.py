"""Falsify certificates, and check that they are rejected: `python -m tests.falsify`.

Changes of one value, mixtures of two certificates of related pairs, and an adversary that moves
loops and lets the finder prove them. With --layouts, certificates of layouts instead;
with --sums, of sums with paths. With --prove, certificates of random pairs and of the corpus are
proved by the file alone, in processes that cannot see the package. With --weaken, single lines of
the checker are weakened, and a test has to notice each.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from itertools import islice
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import click

from exactsweep import Polyline, Region, inner_fit_polygon, minkowski_sum, no_fit_polygon, sweep
from exactsweep.check import standalone
from exactsweep.check.standalone import Refused, area, edges, point, prove, read
from exactsweep.check.verify import normalize
from exactsweep.corpus import cases
from exactsweep.evidence.proof import add_proof

# Tests import each other by bare names, as under pytest.
sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent / "support"))
from families import random_pair
from layout_adversary import draw_layouts, is_true_layout, refill
from paths import draw_path
from rounded_pieces import claim_valid, draw_rounded, is_true_rounded
from shape_families import random_shapes
from tampering import get, put
from weakened import weaken

Certificate = dict[str, Any]
Place = tuple[Any, ...]

CLASSES = "CC", "CM", "MM", "SS"
BATCH = 200
# Run by Python alone: proves one certificate per line, and prints the number of rejections.
ALONE = """
import runpy, sys
checker, failed = runpy.run_path(sys.argv[1]), 0
for line in open(sys.argv[2], encoding="utf-8"):
    try:
        checker["prove"](checker["load"](line))
    except checker["Refused"] as error:
        print(error, file=sys.stderr)
        failed += 1
print(failed)
"""

ANSWERS = ("exterior", "holes", "exact_fits", "inner", "outer", "unswept", "area")


def draw_pair(rng: Random, has_direction: bool) -> tuple[Any, Any]:
    """Draw G and D: with a shared direction, or shapes of any kind."""
    if has_direction:
        pair = random_pair(rng)
        return pair.generatrix, pair.directrix
    drawn = random_shapes(rng)
    return Region(*drawn.generatrix), Region(*drawn.directrix)


def draw(rng: Random) -> Iterator[Certificate]:
    """Draw certificates of related pairs: one moving polygon and two stationary ones."""
    has_direction = rng.random() < 0.5
    g, d = draw_pair(rng, has_direction)
    for still in (d, draw_pair(rng, has_direction)[1]):
        shapes = [
            lambda d=still: sweep(g, d).certificate(),
            lambda d=still: no_fit_polygon(d, g).certificate(),
            lambda d=still: inner_fit_polygon(d, g).certificate(),
        ]
        yield json.loads(json.dumps(rng.choice(shapes)()))


def draw_sums(rng: Random) -> Iterator[Certificate]:
    """Draw certificates of the sums of one shape with two paths."""
    shape, _ = draw_pair(rng, rng.random() < 0.5)
    region = Region(shape)
    for _ in "12":
        found = minkowski_sum(region, draw_path(rng, region)).certificate()
        yield json.loads(json.dumps(found))


def reroute_sum(certificate: Certificate, rng: Random) -> tuple[str, Certificate]:
    """Change the path under its old answer, or the answer as `reroute` does; find a new proof."""
    if rng.random() < 0.5:
        return reroute(certificate, rng)
    path = list(certificate["path"])
    k = rng.randrange(len(path))
    path[k : k + 1] = rng.choice([[], [path[k - 1]], [path[k], rng.choice(path)]])
    found = add_proof({**certificate, "path": path})
    return "another path", json.loads(json.dumps(found))


def is_true_sum(certificate: Certificate, known: list[Certificate]) -> bool:
    """Decide whether the kernel gives the same sum."""
    found = minkowski_sum(read_region(certificate["shape"]), Polyline(certificate["path"]))
    return bool(found == read_region(certificate))


def draw_classes(rng: Random, pairs: int) -> Iterator[Certificate]:
    """Draw the certificates of sweeps and inner fits, of an equal number of pairs per class."""
    missing = dict.fromkeys(CLASSES, pairs)
    while any(missing.values()):
        g, d = draw_pair(rng, any(missing[kind] for kind in CLASSES[:3]) and rng.random() < 0.8)
        swept = sweep(g, d)
        if missing[swept.kind]:
            missing[swept.kind] -= 1
            yield swept.certificate()
            yield inner_fit_polygon(d, g).certificate()


def list_places(item: Any, path: Place = ()) -> list[Place]:
    """List all places of a certificate."""
    entries = item.items() if type(item) is dict else enumerate(item) if type(item) is list else ()
    below = [found for key, value in entries for found in list_places(value, (*path, key))]
    return [path, *below]


def change(certificate: Certificate, rng: Random) -> tuple[str, Certificate]:
    """Change one random value."""
    path = rng.choice(list_places(certificate)[1:])
    item = get(certificate, path)
    where = " ".join(map(str, path[: 2 if path[0] == "proof" else 1]))
    if type(item) is str:
        number = item if item[-1:].isdigit() else "0"
        by = rng.choice([Fraction(1, 10**9), Fraction(-1, 3), Fraction(1), -2 * Fraction(number)])
        return f"{where}: number", put(certificate, path, str(Fraction(number) + by))
    if type(item) is int:
        return f"{where}: index", put(certificate, path, item + rng.choice([-2, -1, 1, 2, 7]))
    if type(item) is list and len(item) > 1:
        k, j = rng.sample(range(len(item)), 2)
        swapped = list(item)
        swapped[k], swapped[j] = swapped[j], swapped[k]
        shorter, longer = item[:k] + item[k + 1 :], [*item[:k], item[j], *item[k:]]
        return f"{where}: list", put(certificate, path, rng.choice([swapped, shorter, longer]))
    return f"{where}: left out", put(certificate, path, None)


def mix(one: Any, other: Any, rng: Random) -> Any:
    """Replace some entries of an object, at any depth, by those of another one."""
    if not (type(one) is type(other) is dict):
        return other
    keys = [key for key in one if key in other and one[key] != other[key]]
    taken = {key: mix(one[key], other[key], rng) for key in keys if rng.random() < 0.4}
    return {**one, **taken}


def reroute(certificate: Certificate, rng: Random) -> tuple[str, Certificate]:
    """Move, drop or add vertices of an answer through true sums, and find a new proof."""
    places = [p for p in list_places(certificate) if p and p[0] in (*ANSWERS, "regions")]
    loops = [p for p in places if is_loop(get(certificate, p))]
    points = [point for p in loops for point in get(certificate, p)]
    if not loops:
        return "no loop", {}
    path = rng.choice(loops)
    loop = list(get(certificate, path))
    k = rng.randrange(len(loop))
    kind = rng.choice(["left out", "through another", "added", "exchanged"])
    if kind == "left out":
        del loop[k]
    elif kind == "through another":
        loop[k] = rng.choice(points)
    elif kind == "added":
        loop.insert(k, rng.choice(points))
    else:
        loop = list(get(certificate, rng.choice(loops)))
    least = min(range(len(loop)), key=lambda n: [Fraction(c) for c in loop[n]])
    changed = put(certificate, path, loop[least:] + loop[:least])
    if "area" in changed:
        loops = [changed["outer"], changed["inner"], *changed.get("unswept", [])]
        areas = [area(edges(read("loop", e, [point]))) for e in loops if len(e) > 2]
        changed["area"] = str(areas[0] - sum(areas[1:]))
    found = add_proof({k: v for k, v in changed.items() if k != "proof"})
    return f"rerouted: {kind}", json.loads(json.dumps(found))


def is_loop(item: Any) -> bool:
    """Decide whether an entry is a list of at least three points."""
    return (
        type(item) is list
        and len(item) > 2
        and all(type(p) is list and len(p) == 2 and type(p[0]) is str for p in item)
    )


def is_same_claim(one: Certificate, other: Certificate) -> bool:
    """Decide whether two certificates claim the same sets, whatever their proofs."""

    def normal(item: Any, key: Any = "") -> Any:
        if type(item) is dict:
            kept = {k: v for k, v in item.items() if k != "proof"}
            return {k: normal([] if v is None else v, k) for k, v in kept.items()}
        if type(item) is list and (key in ("holes", "unswept", "regions", "exact_fits")):
            ordered = [sorted(map(str, e)) if key == "exact_fits" else normal(e) for e in item]
            return sorted(ordered, key=str)
        if is_loop(item):
            return [*map(str, normalize(read("loop", item, [point])))]
        return item

    return bool(normal(one) == normal(other))


class Family(NamedTuple):
    """Certificates of one kind.

    Attributes:
        draw: draws certificates of related questions, with all evidence.
        adversary: changes the claim of a certificate, and finds evidence for it.
        is_true: decides whether a changed claim is true, or one of the known ones.
    """

    draw: Callable[[Random], Iterable[Certificate]]
    adversary: Callable[[Certificate, Random], tuple[str, Certificate]]
    is_true: Callable[[Certificate, list[Certificate]], bool]


def falsify(
    rng: Random, pairs: int, changes: int, family: Family
) -> tuple[Counter[str], list[Any]]:
    """Count trials, and list false certificates that were proved."""
    draw, adversary, is_true = family
    tried: Counter[str] = Counter()
    missed = []
    for _ in range(pairs):
        known = list(draw(rng))
        for n in range(changes if known else 0):
            one = known[n % len(known)]
            same = [c for c in known if c.get("claim") == one.get("claim") and c is not one]
            share = rng.random()
            try:
                if share < 0.2:
                    name, changed = adversary(one, rng)
                elif share < 0.4 and same:
                    name, changed = "mixture", mix(one, same[0], rng)
                else:
                    name, changed = change(one, rng)
            except Exception:  # whatever keeps the finder from ending with a proof
                tried["nothing to be proved"] += 1
                continue
            tried[name] += 1
            try:
                prove(changed)
            except Refused:
                continue
            if not is_true(changed, known):
                missed.append((name, changed))
    return tried, missed


def is_true(certificate: Certificate, known: list[Certificate]) -> bool:
    """Decide whether a claim is known, or the kernel gives the same answer for its polygons."""
    if any(is_same_claim(certificate, c) for c in known):
        return True
    names = ("part", "container") if "part" in certificate else ("generatrix", "directrix")
    g, d = (read_region(certificate[name]) for name in names)
    claim = certificate.get("claim")
    if claim == "inner_fit":
        true = inner_fit_polygon(d, g).certificate()
    elif claim == "no_fit":
        true = no_fit_polygon(d, g).certificate()
    else:
        true = sweep(g, d).certificate()
    return is_same_claim(certificate, json.loads(json.dumps(true)))


SHAPES = Family(draw, reroute, is_true)
SUMS = Family(draw_sums, reroute_sum, is_true_sum)
LAYOUTS = Family(draw_layouts, refill, is_true_layout)
ROUNDED = Family(draw_rounded, claim_valid, is_true_rounded)


def read_region(item: Any) -> Any:
    return Region(item["exterior"], item.get("holes") or ())


def prove_alone(certificates: Iterable[Certificate]) -> Iterator[tuple[int, int]]:
    """Prove certificates by the standalone file, in batches; count trials and rejections."""
    found = iter(certificates)
    with TemporaryDirectory() as folder:
        path = Path(folder) / "certificates.jsonl"
        while batch := list(islice(found, BATCH)):
            path.write_text("".join(f"{json.dumps(one)}\n" for one in batch), encoding="utf-8")
            command = [sys.executable, "-I", "-c", ALONE, standalone.__file__, str(path)]
            done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
            yield len(batch), int(done.stdout)


def list_corpus() -> Iterator[Certificate]:
    """List the certificates of the corpus: sweeps, no-fit polygons and inner fits."""
    for case in cases():
        d = Region(case.directrix_ring, case.directrix_holes)
        g = Region(case.generatrix_ring, case.generatrix_holes)
        yield sweep(g, d).certificate()
        yield no_fit_polygon(d, g).certificate()
        if case.inner_regions is not None:
            yield inner_fit_polygon(d, g).certificate()


@click.command()
@click.option(
    "--pairs", default=20, show_default=True, help="Number of pairs; with --prove, of each class."
)
@click.option("--changes", default=100, show_default=True, help="Number of changes of each pair.")
@click.option("--seed", default=1, show_default=True)
@click.option("--layouts", is_flag=True, help="Certificates of layouts.")
@click.option("--sums", is_flag=True, help="Certificates of sums with paths.")
@click.option("--rounded", is_flag=True, help="Certificates of layouts of rounded pieces.")
@click.option("--prove", "proved", is_flag=True, help="Prove certificates, unchanged, instead.")
@click.option("--corpus", is_flag=True, help="With --prove: the certificates of the corpus.")
@click.option("--weaken", "weakened", is_flag=True, help="Weaken lines of the checker instead.")
@click.option("--every", default=1, show_default=True, help="With --weaken: try every Nth change.")
def main(
    pairs: int,
    changes: int,
    seed: int,
    layouts: bool,
    sums: bool,
    rounded: bool,
    proved: bool,
    corpus: bool,
    weakened: bool,
    every: int,
) -> None:
    """Falsify certificates, and count rejections."""
    if weakened:
        number, unnoticed = weaken(every)
        click.echo("\n".join([*unnoticed, f"{number} lines weakened, {len(unnoticed)} unnoticed"]))
        sys.exit(bool(unnoticed))
    rng = Random(seed)
    if proved:
        drawn = list_corpus() if corpus else draw_classes(rng, pairs)
        count = failed = 0
        for number, rejected in prove_alone(drawn):
            count, failed = count + number, failed + rejected
            click.echo(f"{count - failed} of {count} proved", err=True)
        click.echo(f"{count - failed} of {count} proved")
        sys.exit(bool(failed))
    family = LAYOUTS if layouts else ROUNDED if rounded else SUMS if sums else SHAPES
    tried, missed = falsify(rng, pairs, changes, family)
    for name, number in sorted(tried.items()):
        click.echo(f"{number:7}  {name}")
    click.echo(f"{tried.total()} tried, {len(missed)} false ones proved")
    for name, certificate in missed:
        click.echo(f"{name}: {json.dumps(certificate)}")
    sys.exit(bool(missed))


if __name__ == "__main__":
    main()
