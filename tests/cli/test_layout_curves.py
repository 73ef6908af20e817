"""Finer flattening of undecided curves: the verdicts, and the vertices that they cost."""

from __future__ import annotations

from collections import Counter
from decimal import Decimal
from pathlib import Path

import pytest

from exactsweep.cli import judging
from exactsweep.cli.judging import MAX_VERTICES, judge_finely, judge_found
from exactsweep.formats.layouts import FoundLayout, read_layouts
from exactsweep.layout import Judgement

_SHEET = '<rect id="sheet" width="{0}" height="{1}" fill="none" stroke="#000"/>'


def _plate(x: Decimal) -> str:
    """Draw a plate from x to x + 30 with a curved hole."""
    outline = f"M{x} 25 C{x} 5 {x + 30} 5 {x + 30} 25 C{x + 30} 45 {x} 45 {x} 25Z"
    return outline + (
        f" M{x + 10} 25 C{x + 10} 18 {x + 20} 18 {x + 20} 25 C{x + 20} 32 {x + 10} 32 {x + 10} 25Z"
    )


def _disc(x: int, y: int) -> str:
    """Draw four curves around a point, through the points at distance 5 along the axes."""
    return (
        f"M{x - 5} {y} C{x - 5} {y - 2} {x - 2} {y - 5} {x} {y - 5}"
        f" C{x + 2} {y - 5} {x + 5} {y - 2} {x + 5} {y}"
        f" C{x + 5} {y + 2} {x + 2} {y + 5} {x} {y + 5}"
        f" C{x - 2} {y + 5} {x - 5} {y + 2} {x - 5} {y}Z"
    )


def _read(folder: Path, paths: list[str], width: int = 100, height: int = 50) -> FoundLayout:
    drawn = "".join(f'<path fill="none" stroke="red" d="{d}"/>' for d in paths)
    size = f'width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}"'
    sheet = _SHEET.format(width, height)
    file = folder / "nest.svg"
    file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{sheet}{drawn}</svg>')
    (found,) = read_layouts(str(file))
    return found


def _count(judgement: Judgement) -> int:
    parts = judgement.layout.parts
    return sum(len(ring) for part in parts for ring in (part.exterior, *part.holes))


@pytest.fixture(name="sizes")
def _sizes(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Collect the number of vertices of each judgement."""
    sizes: list[int] = []

    def judge(*args: object) -> Judgement:
        judgement = judge_found(*args)  # type: ignore[arg-type]
        sizes.append(_count(judgement))
        return judgement

    monkeypatch.setattr(judging, "judge_found", judge)
    return sizes


@pytest.mark.parametrize(
    ("x", "kinds"),
    [
        ("39.9", ["overlap"]),
        ("39.9999", ["overlap"]),
        ("39.999999999", ["undecided"]),
        ("40", ["undecided"]),
        ("40.000000001", ["undecided"]),
        ("40.0001", []),
    ],
)
def test_curves_are_refined_up_to_a_budget(
    tmp_path: Path, sizes: list[int], x: str, kinds: list[str]
) -> None:
    found = _read(tmp_path, [_plate(Decimal(10)), _plate(Decimal(x))])
    judgement = judge_finely(found, {}, "nest")
    assert [fault.kind for fault in judgement.faults] == kinds
    assert sum(sizes[1:]) <= MAX_VERTICES
    # Nothing is judged again after the verdict.
    assert sizes == sorted({*sizes})


def test_only_undecided_parts_are_refined(tmp_path: Path, sizes: list[int]) -> None:
    found = _read(tmp_path, [_disc(10, 10), _disc(20, 10), _disc(40, 10)])
    judgement = judge_finely(found, {}, "nest")
    assert [fault.placements for fault in judgement.faults] == [(0, 1)]
    errors = [part.error for part in judgement.layout.parts]
    assert errors[0] == errors[1] < errors[2]
    assert sum(sizes[1:-1]) <= MAX_VERTICES


def test_many_contacts_share_the_budget(tmp_path: Path, sizes: list[int]) -> None:
    discs = [_disc(10 * k + 5, 10 * i + 5) for k in range(8) for i in range(5)]
    judgement = judge_finely(_read(tmp_path, discs, 90, 60), {}, "nest")
    # Each disc touches its neighbors, and those at the border touch the sheet.
    assert Counter(fault.kind for fault in judgement.faults) == {"undecided": 67 + 12}
    assert max(sizes) <= MAX_VERTICES + sizes[0]


def test_an_overlap_needs_no_pieces(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither the verdict nor its certificate cuts a shape into convex pieces."""

    def cut(rings: object) -> object:
        raise AssertionError(rings)

    monkeypatch.setattr("exactsweep.layout.solid.cut_to_convex", cut)
    found = _read(tmp_path, [_plate(Decimal(10)), _plate(Decimal("39.9999"))])
    (fault,) = judge_finely(found, {}, "nest").certificate()["faults"]
    assert (fault["kind"], fault["placements"]) == ("overlap", [0, 1])
