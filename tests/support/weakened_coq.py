"""The extracted checker with one side of one conjunction dropped, and claims that detect it.

A single program numbers all conjunctions and reports the dropped sides that change the answer to a
claim. It tries only sides whose value decides a conjunction, each until a claim reveals it.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterable, Iterator
from contextlib import suppress
from fractions import Fraction
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any

from certified import L, certificates, rect

from exactsweep import (
    Polyline,
    Region,
    inner_fit_polygon,
    minkowski_sum,
    no_fit_polygon,
    sweep,
)
from exactsweep.check.standalone import area, edges, node
from exactsweep.evidence.proof import add_proof
from exactsweep.layout import Layout, LayoutError, judge_layout
from exactsweep.theorem.claims import to_claim, write_numbers
from exactsweep.theorem.extracted import build_checker

CONJUNCTION = "(&&)"
LOOP = "(* One claim per line"
# Even numbers drop the second side of a conjunction, odd ones the first.
HEAD = """
let dropped = ref (-1)
let decided : (int, unit) Hashtbl.t = Hashtbl.create 400
let conj k a b =
  if a <> b then Hashtbl.replace decided (if a then 2 * k else 2 * k + 1) ();
  if !dropped = 2 * k then a else if !dropped = 2 * k + 1 then b else a && b
"""
MAIN = """
let shown = Hashtbl.create 400
let respond line =
  scan := Scanf.Scanning.from_string line;
  try Some (answer (token ())) with _ -> None
let () =
  try
    while true do
      let line = read_line () in
      Conjunctions.dropped := -1; Hashtbl.reset Conjunctions.decided;
      let expected = respond line in
      let decided = Hashtbl.fold (fun k () l -> k :: l) Conjunctions.decided [] in
      let tried = if expected = None then [] else decided in
      let tried = List.filter (fun k -> not (Hashtbl.mem shown k)) tried in
      let is_changed k = Conjunctions.dropped := k; respond line <> expected in
      let changed = List.filter is_changed tried in
      List.iter (fun k -> Hashtbl.replace shown k ()) changed;
      print_endline (String.concat " " (List.map string_of_int (List.sort compare changed)))
    done
  with End_of_file -> ()
"""


def build(extracted: Path, folder: Path) -> Path:
    """Compile the program with numbered conjunctions; return its path."""
    checker = (extracted / "checker.ml").read_text(encoding="utf-8")
    parts = checker.split(CONJUNCTION)
    numbered = parts[0] + "".join(f"(Conjunctions.conj {k}){e}" for k, e in enumerate(parts[1:]))
    driver = (extracted / "driver.ml").read_text(encoding="utf-8")
    (folder / "conjunctions.ml").write_text(HEAD, encoding="utf-8")
    (folder / "checker.ml").write_text(numbered, encoding="utf-8")
    (folder / "driver.ml").write_text(driver[: driver.index(LOOP)] + MAIN, encoding="utf-8")
    command = "ocamlfind ocamlopt -w -a -package zarith -linkpkg conjunctions.ml checker.ml"
    subprocess.run(
        [*command.split(), "driver.ml", "-o", "weak"], cwd=folder, check=True, capture_output=True
    )
    return folder / "weak"


def list_dropped(extracted: Path) -> dict[int, str]:
    """Return the numbers of dropped sides, each with the function that has the conjunction."""
    found, name = dict[int, str](), ""
    for line in (extracted / "checker.ml").read_text(encoding="utf-8").splitlines():
        if line.startswith(("let ", "and ")):
            words = line.split()
            name = words[2 if words[1] == "rec" else 1]
        for _ in range(line.count(CONJUNCTION)):
            k = len(found) // 2
            found |= {2 * k: f"{name}, second of {k}", 2 * k + 1: f"{name}, first of {k}"}
    return found


def find_noticed(program: Path, lines: Iterable[str]) -> list[set[int]]:
    """Return the dropped sides that change the answer to each claim."""
    text = "".join(f"{line}\n" for line in lines)
    done = subprocess.run([program], input=text, capture_output=True, text=True, check=True)
    return [{*map(int, line.split())} for line in done.stdout.splitlines()]


def change_words(line: str, rng: Random, times: int) -> Iterator[str]:
    """Yield a claim with one number or two adjacent numbers changed."""
    words = line.split()
    for _ in range(times):
        changed, k = list(words), rng.randrange(1, len(words))
        kind = rng.randrange(5)
        if kind == 0 and "/" in words[k]:
            n, d = words[k].split("/")
            changed[k] = f"{int(n) + rng.choice([-1, 1, int(d), -int(d), -2 * int(n)])}/{d}"
        elif kind == 1:
            changed[k] = rng.choice(words[1:])
        elif kind == 2 and k > 1:
            changed[k - 1 : k + 1] = changed[k - 1 : k + 1][::-1]
        elif kind == 3 and words[k][:2] == "0/":
            changed[k] = "1/3"  # 0 for a denominator that is not a multiple of 3
        elif "/" not in words[k]:
            changed[k] = str(int(words[k]) + rng.choice([-2, -1, 1, 2, -2 * int(words[k])]))
        if changed != words:
            yield " ".join(changed)


def square(left: int, low: int, side: int = 1) -> list[list[str]]:
    """Return the corners of a square as text."""
    return rect(left, low, left + side, low + side)


def disc(x: int, y: int, radius: str) -> dict[str, Any]:
    """Return a disc as a body."""
    return {"pieces": [{"points": [[str(x), str(y)]], "radius": radius}]}


def list_layouts() -> Iterator[dict[str, Any]]:
    """List small layouts, in which most conditions alone decide the answer."""
    unit = {"id": "a", "exterior": square(0, 0)}
    box = {"exterior": square(0, 0, 3)}
    one = [{"part": "a", "move": ["1", "1"]}]
    two = [*one, {"part": "a", "move": ["3", "1"]}]
    over = [*one, {"part": "a", "move": ["1", "1"], "turn": ["3/5", "4/5"]}]
    slot = {"pieces": [{"points": [["0", "0"], ["2", "0"]], "radius": "1/2"}]}
    tile = {"pieces": [{"points": square(0, 0, 2), "radius": "1/4"}]}
    rules = {"turns": ["0", "90"], "mirrored_turns": ["180"], "demand": 2}
    moved = [*one, {"part": "a", "move": ["4", "2"], "turn": "180", "mirrored": True}]
    ring = {"exterior": square(0, 0, 9), "holes": [square(3, 3, 3)]}
    yield {"parts": [unit], "placements": one}
    yield {"parts": [unit], "placements": two, "spacing": "1"}
    yield {"parts": [{**unit, "error": "1/4"}], "placements": two, "spacing": "1/2"}
    yield {"parts": [unit], "placements": one, "container": box, "margin": "1"}
    yield {"parts": [{**unit, "error": "1"}], "placements": one, "container": box}
    yield {"parts": [{"id": "a", "exterior": L}], "placements": one, "container": box}
    yield {"parts": [{"id": "a", **ring}], "placements": one}
    yield {"parts": [{**unit, **rules}], "placements": moved, "spacing": "1"}
    yield {"parts": [{"id": "a", **disc(0, 0, "1")}], "placements": two, "spacing": "0"}
    yield {"parts": [{"id": "a", **slot}], "placements": one, "container": disc(2, 1, "2")}
    yield {"parts": [unit], "placements": one, "container": {**disc(1, 1, "3"), "error": "1"}}
    yield {"parts": [unit], "placements": one, "defects": [{**box, "spacing": "1"}]}
    far = {"exterior": square(4, 1), "error": "1/2", "spacing": "1"}
    yield {"parts": [unit], "placements": one, "defects": [far]}
    yield {"parts": [unit], "placements": over}
    yield {"parts": [{**unit, "error": "1/8"}], "placements": over}
    yield {"parts": [{"id": "a", **disc(0, 0, "1"), "error": "1/4"}], "placements": over}
    yield {"parts": [{"id": "a", **tile, "error": "1/2"}], "placements": over}
    yield {"parts": [{"id": "a", **slot}], "placements": two, "spacing": "1"}
    yield {"parts": [unit], "placements": two, "spacing": "3/2"}
    yield {"parts": [unit], "placements": two, "container": {**box, "error": "1/4"}}
    yield {"parts": [unit], "placements": two, "container": disc(0, 0, "2"), "margin": "1"}
    yield {"parts": [{**unit, "error": "1/4"}], "placements": one, "container": tile}
    yield {"parts": [unit], "placements": one, "container": disc(1, 1, "3"), "margin": "2"}
    yield {"parts": [unit], "placements": one, "container": box, "margin": "5/4"}
    yield {"parts": [unit], "placements": one, "defects": [{"exterior": square(1, 1, 2)}]}
    yield {"parts": [{**unit, **rules, "mirrored": False}], "placements": [*moved, *one]}
    yield {"parts": [{**unit, "turns": ["90"], "demand": 3}], "placements": one}
    twice = square(0, 0, 2) * 2
    yield {"parts": [{"id": "a", "exterior": twice}], "placements": one}


def list_falsified() -> Iterator[dict[str, Any]]:
    """List false claims, each of which violates a condition alone, or nearly so."""
    known = certificates()
    # Loops without their holes: sides of sums are not covered.
    ring = Region(rect(0, 0, 6, 6), [rect(1, 1, 5, 5)])
    yield {**no_fit_polygon(ring, square(0, 0)).certificate(), "holes": []}
    yield {**known["island"], "regions": [{**known["island"]["regions"][0], "holes": []}]}
    swept = known["unswept"]
    lost = sum(area(edges([node(*map(Fraction, p)) for p in e])) for e in swept["unswept"])
    yield {**swept, "unswept": [], "area": str(Fraction(swept["area"]) + lost)}
    # Another inner loop
    yield add_proof({**swept, "inner": swept["unswept"][0], "unswept": [swept["inner"]]})
    # Two squares, and a loop around one of them; a ring that goes around twice
    made = no_fit_polygon(square(0, 0), square(0, 0)).certificate()
    far = [*rect(0, 0, 1, 1)[:2], *rect(9, 0, 10, 1), *rect(9, 0, 1, 1)[:2], *rect(0, 0, 1, 1)[2:]]
    for around, other in ((far, square(9, 0)), (square(0, 0) * 2, square(0, 0))):
        proof = {**made["proof"], "directrix": [square(0, 0), other]}
        yield {**made, "directrix": {"exterior": around}, "proof": proof}
    # The hole of a region in another one
    twin = [(0, 0), (9, 0), (9, 4), (10, 4), (10, 0), (19, 0), (19, 9), (10, 9), (10, "9/2")]
    twin += [(9, "9/2"), (9, 9), (0, 9)]
    made = inner_fit_polygon(Region(twin, [rect(4, 4, 5, 5)]), square(0, 0)).certificate()
    (one, other), holes = made["regions"], made["regions"][0]["holes"] + made["regions"][1]["holes"]
    moved = other if one["holes"] else one
    kept = one if one["holes"] else other
    yield add_proof({**made, "regions": [{**kept, "holes": []}, {**moved, "holes": holes}]})
    # A container with a hole, parts that leave the frame, pieces that fill half of a part
    unit, box = {"id": "a", "exterior": square(0, 0)}, {"exterior": square(0, 0, 3)}
    place = {"part": "a", "move": ["1", "1"]}
    layout = {"parts": [unit], "placements": [place], "container": box}
    made = judge_layout(Layout.from_json(layout)).certificate()
    yield {**made, "layout": {**layout, "container": {**box, "holes": [square(1, 1)]}}}
    yield {**made, "layout": {**layout, "placements": [{**place, "move": ["90", "90"]}]}}
    layout = {"parts": [{**unit, "exterior": rect(0, 0, 1, 2)}], "placements": [place]}
    layout["placements"] = [place, {**place, "move": ["1", "2"]}]
    pieces = {"pieces": [[square(0, 0)], None], "apart": []}
    yield {**made, "layout": layout, "turns": [["1", "0"]] * 2, "proof": pieces}


def list_claims() -> list[str]:
    """Return small claims of all kinds, and false ones."""
    found = list[Any]()
    for layout in list_layouts():
        with suppress(LayoutError):  # claims without a proof
            found.append(judge_layout(Layout.from_json(layout)).certificate())
    shapes = [square(0, 0), [["0", "0"], ["2", "0"], ["1", "2"]], square(0, 0, 2)]
    cave = [
        ["0", "0"],
        ["3", "0"],
        ["3", "3"],
        ["2", "3"],
        ["2", "1"],
        ["1", "1"],
        ["1", "3"],
        ["0", "3"],
    ]
    for d in [*shapes, cave]:
        for g in shapes[:2]:
            found += [no_fit_polygon(d, g).certificate(), inner_fit_polygon(d, g).certificate()]
            found.append(sweep(g, d).certificate())
    for path in ([(0, 0), (2, 0)], [(0, 0), (2, 0), (2, 2), (0, 2), (0, 0)]):
        found.append(minkowski_sum(Region(square(0, 0)), Polyline(path)).certificate())
    found += list_falsified()
    lines = (write_numbers(to_claim(json.loads(json.dumps(one)))) for one in found)
    return sorted(lines, key=len)


def weaken(changes: int, rng: Random) -> tuple[set[int], dict[int, str]]:
    """Return the dropped sides that change the answer to a claim, and all of them."""
    extracted = build_checker().parent
    with TemporaryDirectory() as folder:
        program = build(extracted, Path(folder))
        claims = list_claims()
        lines = [*claims, *(e for one in claims for e in change_words(one, rng, changes))]
        return set[int]().union(*find_noticed(program, lines)), list_dropped(extracted)
