"""The checker in JavaScript, written from CERTIFICATES.md alone, agrees with the one in Python."""

import json
import re
import subprocess
from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from pathlib import Path
from random import Random
from typing import Any

import pytest
from certified import certificates, layout, rect, with_faults
from checkers import CHECKER, ask_node, check_agreement, needs_node
from falsify import draw, list_places, mix
from layout_adversary import draw_layouts
from tampering import get, put

from exactsweep import inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.corpus import cases, layout_cases
from exactsweep.layout import judge_layout
from exactsweep.layout.reading import LayoutError

HEAD = "format", "version", "claim"
SQUARE = [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]]
BOW = [["0", "0"], ["2", "2"], ["2", "0"], ["0", "2"]]

pytestmark = needs_node


def corpus_certificates(size: int, step: int) -> Iterator[Any]:
    for case in islice(cases(max_size=size), None, None, step):
        yield no_fit_polygon(case.directrix, case.generatrix).certificate()
        yield inner_fit_polygon(case.directrix, case.generatrix).certificate()
        yield sweep(case.generatrix, case.directrix).certificate()


def layout_certificates(step: int) -> Iterator[Any]:
    for case in islice(layout_cases(), None, None, step):
        try:
            yield judge_layout(case.layout).certificate()
        except LayoutError:  # no fault has a proof
            continue


def change(certificate: Any, rng: Random) -> Any:
    """Move a number, change an index, or drop an entry of a list."""
    places = [p for p in list_places(certificate) if p and p[0] not in HEAD]
    path = rng.choice(places)
    item = get(certificate, path)
    if type(item) is bool:
        return put(certificate, path, not item)
    if type(item) is int:
        return put(certificate, path, item + rng.choice([-2, -1, 1, 2, 7]))
    if type(item) is str and re.fullmatch("-?[0-9]+(/[0-9]+)?", item):
        by = rng.choice([Fraction(1, 10**9), Fraction(-1, 3), Fraction(1), -2 * Fraction(item)])
        return put(certificate, path, str(Fraction(item) + by))
    if type(item) is list and item:
        k = rng.randrange(len(item))
        return put(certificate, path, item[:k] + item[k + 1 :])
    return change(certificate, rng)


def changed(certificates: list[Any], count: int, seed: int) -> list[Any]:
    rng = Random(seed)
    return [change(c, rng) for c in certificates for _ in range(count)]


def test_both_agree_on_true_and_changed_certificates(tmp_path: Path) -> None:
    true = [*corpus_certificates(10, 120), *layout_certificates(16)]
    assert check_agreement(true, tmp_path) == len(true)
    false = changed(true, 5, seed=1)
    assert check_agreement(false, tmp_path) < len(false) / 2


def faulty_layout(hole: Any, point: Any) -> Any:
    part = {"id": "plate", "exterior": SQUARE, "holes": [hole]}
    return {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "layout",
        "layout": {"container": {"exterior": SQUARE}, "parts": [part], "placements": []},
        "turns": [],
        "valid": False,
        "faults": [{"kind": "shape", "part": "plate", "point": point}],
    }


def test_both_agree_on_hostile_text(tmp_path: Path) -> None:
    certificate = faulty_layout(BOW, ["1/2", "1"])
    text = json.dumps(certificate)
    texts = [
        text,
        json.dumps(faulty_layout(BOW[::-1], ["1/2", "1"])),
        json.dumps(faulty_layout(BOW[::-1], ["3/2", "1"])),
        *(text.replace('"1/2"', new) for new in ('"2/4"', '"-0"', '"1/1"', '"+1"', '"1 "', "0.5")),
        *(text.replace('"version": 3', f'"version": {new}') for new in ("3.0", "3e0", '"3"', "4")),
        text.replace('"turns"', '"valid": false, "turns"'),
        text.replace('"turns"', '"other": 1, "turns"'),
        text.replace('"turns": []', '"turns": null'),
        text.replace('"exterior"', '"error": null, "exterior"'),
        text.replace('"exterior"', '"error": "-1", "exterior"'),
        text[:-1],
        text + "x",
        "\ufeff" + text,
        "[" * 100_000,
        '"' + "1" * 100_000,
        "",
        "null",
        "NaN",
    ]
    assert check_agreement(texts, tmp_path) == 4


def valid_layout(**changes: Any) -> Any:
    """Return two distant squares in a container equal to the frame."""
    unit = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
    parts = [{"id": "a", "exterior": unit}]
    placements: Any = [{"part": "a", "move": ["0", "0"]}, {"part": "a", "move": ["3", "0"]}]
    certificate: Any = {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "layout",
        "layout": {"container": {"exterior": SQUARE}, "parts": parts, "placements": placements},
        "turns": [["1", "0"]] * 2,
        "valid": True,
        "proof": {
            "frame": ["0", "0", "4", "4"],
            "pieces": [[unit], []],
            "apart": changes.get("apart", []),
        },
    }
    if "turn" in changes:
        certificate["layout"]["placements"][0] |= {"turn": "1/10", "move": ["1", "1"]}
        certificate["turns"] = [changes["turn"], ["1", "0"]]
    if "flat" in changes:
        flat = {"id": "flat", "exterior": [["0", "0"], ["1", "0"], ["2", "0"]]}
        certificate["layout"]["parts"] = [*parts, flat]
        placements.append({"part": "flat", "move": ["0", "9"]})
        certificate["turns"].append(["1", "0"])
        certificate["proof"]["pieces"].insert(1, changes["flat"])
    return certificate


def test_both_agree_on_every_rule_of_the_page(tmp_path: Path) -> None:
    true = [
        valid_layout(),
        valid_layout(turn=["1", "0"]),
        valid_layout(apart=[[0, -1, 1, -1, "0", "0"]]),  # not needed
        valid_layout(apart=[[0, -2, 1, -1, "1", "0"]] * 2),  # of no body
    ]
    false = [
        valid_layout(turn=["11/10", "0"]),  # another length than 1
        valid_layout(apart=[[0, 10**9, 1, 0, "1", "0"]]),
        valid_layout(flat=[]),  # a part without pieces, outside
    ]
    assert check_agreement(true, tmp_path) == len(true)
    assert check_agreement(false, tmp_path) == 0


def test_required_keys_are_not_null(tmp_path: Path) -> None:
    true = [certificates()[name] for name in ("cave", "CM", "island")]
    lists = ("holes",), ("unswept",), ("regions", 0, "holes")
    false = [put(c, path, None) for c, path in zip(true, lists, strict=True)]
    assert check_agreement(true, tmp_path) == 3
    assert check_agreement(false, tmp_path) == 0


def test_a_file_of_large_numbers_is_checked_in_bounded_time(tmp_path: Path) -> None:
    certificate = faulty_layout([[f"{x}/{'3' * 20_000}1" for x in p] for p in BOW], ["1", "1"])
    certificate["layout"]["parts"][0]["turns"] = [f"1/{'7' * 40_000}"]
    assert ask_node([json.dumps(certificate)], tmp_path)[0].startswith("not proved: ")


@pytest.mark.parametrize("at", [0, 17 * 10**307, 10**400], ids=["0", "1.7e308", "1e400"])
def test_both_reject_an_edge_in_a_sum_at_any_position(at: int, tmp_path: Path) -> None:
    one, other = rect(at, at, at + 1, at + 1), rect(at + 1, at, at + 5, at + 1)
    moved = rect(-at, -at, 1 - at, 1 - at)
    pieces = {"directrix": [one, other], "generatrix": [moved]}
    certificate: Any = {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "no_fit",
        "directrix": {"exterior": rect(at, at, at + 5, at + 1)},
        "generatrix": {"exterior": moved},
        "exterior": rect(2 * at - 1, 2 * at - 1, 2 * at + 1, 2 * at + 1),  # the sum of `one` alone
        "holes": [],
        "exact_fits": [],
        "proof": {**pieces, "sums": [[0, [[-1], [-2], [-3], [-4]]]]},
    }
    assert check_agreement([certificate], tmp_path) == 0
    certificate["directrix"] = {"exterior": one}
    certificate["proof"]["directrix"] = [one]
    assert check_agreement([certificate], tmp_path) == 1


def test_half_planes_are_not_listed_by_number(tmp_path: Path) -> None:
    certificate = certificates()["inside"]
    proof = certificate["proof"]
    count = len(proof["sums"])
    entries = [[k, move(chains, count)] for k, chains in proof["sums"]]
    around = move(proof["around"], count)
    half_plane = [len(proof["outside"]) * len(proof["part"]), around[:1]]
    false = {**certificate, "proof": {**proof, "sums": [*entries, half_plane], "around": around}}
    assert check_agreement([certificate, false], tmp_path) == 1


def move(chains: Any, count: int) -> Any:
    """Renumber chains for one more entry before those of the half-planes."""
    return [[m + (m >= count) for m in chain] for chain in chains]


def test_a_missing_file_proves_nothing(tmp_path: Path) -> None:
    for arguments in ([], [str(tmp_path / "none.json")]):
        assert (
            subprocess.run(["node", str(CHECKER), *arguments], capture_output=True).returncode == 1
        )


@pytest.mark.long
@pytest.mark.parametrize("seed", [1, 2])
def test_both_agree_on_random_certificates(seed: int, tmp_path: Path) -> None:
    rng = Random(seed)
    certificates = [*corpus_certificates(14, 12), *layout_certificates(1)]
    for _ in range(15):
        drawn = [*draw(rng)]
        layouts = [*draw_layouts(rng)]
        certificates += drawn + layouts
        certificates += [mix(one, other, rng) for one, other in (drawn, drawn[::-1]) for _ in "12"]
    assert check_agreement(certificates, tmp_path) > 200
    false = changed(certificates, 6, seed)
    assert check_agreement(false, tmp_path) < len(false) / 2


def test_both_agree_on_distances_of_defects_and_rotations_of_mirrored_parts(tmp_path: Path) -> None:
    certificates = list[Any]()
    for spacing in (None, "2", "21/10", "-1"):
        defect = {"exterior": rect(1, 1, 4, 4), "spacing": spacing}
        part = {"id": "a", "exterior": rect(0, 0, 2, 2), "turns": ["180"]}
        for turns in (None, [], ["0"], ["1"], [["1", "1"]], "0"):
            placed = [{"part": "a", "move": ["8", "3"], "mirrored": True}]
            parts = [{**part, "mirrored_turns": turns}]
            pieces = [[rect(0, 0, 2, 2)]]
            found = layout(parts, placed, pieces, defects=[defect], margin="2")
            certificates += [found, with_faults(found, {"kind": "turn", "part": "a"})]
            close = {"kind": "too close", "placements": [0, -2], "point": ["5", "4"]}
            certificates.append(with_faults(found, close))
    assert check_agreement(certificates, tmp_path) > 10
