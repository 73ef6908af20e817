"""Repaired layouts are valid and have the same parts, slightly moved; or there is none."""

import json
import re
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
from command import run
from layouts import box, lay, put

from exactsweep.layout import Layout, judge_layout
from exactsweep.layout import repaired as repaired_module
from exactsweep.layout.repaired import repair_layout
from exactsweep.numbers.number import Point

TILE, ELL = box(0, 0, 4, 3), [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)]


@pytest.mark.parametrize("size", ["1e-13", "1e-6", "0.01"])
@pytest.mark.parametrize("gaps", [{}, {"spacing": "0.25", "margin": "0.5"}], ids=["none", "gaps"])
def test_rounding_noise_is_repaired(size: str, gaps: dict[str, str]) -> None:
    rng, noise = Random(size), Fraction(size)
    pitch = 1 + Fraction(gaps.get("spacing", "0"))
    edge = Fraction(gaps.get("margin", "0"))

    def off() -> Fraction:
        return noise * rng.randrange(-100, 101) / 100

    placements = [
        put(
            rng.choice(["t", "e"]),
            (
                edge + i * (3 + pitch) + 2 * noise + off(),
                edge + j * (2 + pitch) + 2 * noise + off(),
            ),
        )
        for i in range(4)
        for j in range(4)
    ]
    width, height = 2 * edge + 4 * (3 + pitch) + 9 * noise, 2 * edge + 4 * (2 + pitch) + 9 * noise
    layout = lay(box(0, 0, width, height), {"t": TILE, "e": ELL}, *placements, **gaps)
    judgement = judge_layout(layout)
    assert not judgement.valid
    repaired = repair_layout(judgement)
    assert repaired is not None
    assert repaired.judgement.valid
    assert judge_layout(repaired.layout).valid
    assert 0 < repaired.longest_squared <= (20 * noise) ** 2
    for k, (old, new) in enumerate(zip(layout.placements, repaired.layout.placements, strict=True)):
        x, y = repaired.moves.get(k, Point(Fraction(0), Fraction(0)))
        assert (old.part, old.turn) == (new.part, new.turn)
        assert new.move == Point(old.move.x + x, old.move.y + y)


@pytest.mark.parametrize("size", ["1e-12", "1e-3"])
def test_rounding_noise_in_long_rows_is_repaired_within_a_few_rounds(size: str) -> None:
    rng, noise = Random(size), Fraction(size)
    placements = [
        put(rng.choice("te"), tuple(Fraction(c) + noise * rng.randrange(-50, 51) / 50 for c in at))
        for at in ((4 * i, 3 * j) for i in range(10) for j in range(10))
    ]
    room = 20 * noise
    container = box(-room, -room, 40 + room, 30 + room)
    judgement = judge_layout(lay(container, {"t": TILE, "e": ELL}, *placements))
    assert len(judgement.faults) > 50
    repaired = repair_layout(judgement)
    assert repaired is not None
    assert judge_layout(repaired.layout).valid
    assert repaired.longest_squared <= (10 * noise) ** 2


def test_a_valid_layout_is_unchanged() -> None:
    layout = lay(box(0, 0, 9, 9), {"t": TILE}, put("t"))
    repaired = repair_layout(judge_layout(layout))
    assert repaired is not None
    assert repaired.layout == layout
    assert repaired.moves == {}


def test_missing_placements_are_not_repaired() -> None:
    missing = lay(box(0, 0, 9, 9), {"t": {"exterior": TILE, "demand": 2}}, put("t"))
    assert repair_layout(judge_layout(missing)) is None


def test_a_part_moves_to_the_nearest_free_position(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(repaired_module, "_ROUNDS", 2)
    # The small part lies on the edge between two large ones; there is free space next to them.
    parts = {"t": TILE, "s": box(0, 0, 1, 1)}
    layout = lay(box(0, 0, 9, "3.5"), parts, put("t"), put("t", (5, 0)), put("s", ("4.3", 1)))
    repaired = repair_layout(judge_layout(layout))
    assert repaired is not None
    assert repaired.judgement.valid


def test_the_command_writes_a_repaired_layout(tmp_path: Path) -> None:
    layout = lay(box(0, 0, 9, 9), {"t": TILE}, put("t"), put("t", ("3.999999", 0)))
    path, fixed = tmp_path / "layout.json", tmp_path / "fixed.json"
    path.write_text(json.dumps(layout.to_json()))
    done = run("layout", str(path), "--repair", str(fixed))
    assert done.exit_code == 1
    assert re.search(r"moved by at most 0.0000010\d*; judged valid\n", done.stdout)
    assert "possibly rounding; --accept 0.000001 accepts this" in done.stdout
    assert judge_layout(Layout.from_json(json.loads(fixed.read_text()))).valid
    assert run("layout", str(fixed)).exit_code == 0
    assert run("layout", str(path), "--accept", "1e-6").exit_code == 0


@pytest.mark.long
def test_a_full_container_is_not_repaired(tmp_path: Path) -> None:
    path = tmp_path / "layout.json"
    full = lay(box(0, 0, 4, 3), {"t": TILE}, put("t"), put("t"))
    assert repair_layout(judge_layout(full)) is None
    path.write_text(json.dumps(full.to_json()))
    done = run("layout", str(path), "--repair", str(tmp_path / "none.json"))
    assert "note: no repair by small moves found" in done.stdout
    assert not (tmp_path / "none.json").exists()
