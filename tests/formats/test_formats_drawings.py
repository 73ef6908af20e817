"""Sixty part files of many programs: read with at most two options, or rejected by name."""

from pathlib import Path

import pytest
from command import refusal, run
from drawings import Drawing, every_drawing

from exactsweep.formats import parse_regions

DRAWINGS = every_drawing()


def test_most_of_sixty_drawings_are_read() -> None:
    assert len(DRAWINGS) == len({drawing.name for drawing in DRAWINGS}) == 60
    assert sum(bool(drawing.areas) for drawing in DRAWINGS) >= 58
    for drawing in DRAWINGS:
        assert sum(option.startswith("--") for option in drawing.options) <= 2


@pytest.mark.parametrize("drawing", DRAWINGS, ids=lambda drawing: drawing.name)
def test_drawings_are_read_or_rejected_with_the_reason(drawing: Drawing, tmp_path: Path) -> None:
    path = tmp_path / drawing.name
    path.write_text(drawing.text, encoding="utf-8", newline="")
    result = run("convert", str(path), *drawing.options, "--to", "json")
    if not drawing.areas:
        assert drawing.reason in refusal(result)
        return
    assert result.exit_code == 0, result.output
    said = [
        line
        for line in result.stderr.splitlines()
        if not line.startswith(("Y axis flipped", "curves flattened"))
    ]
    assert (drawing.reason in result.stderr) if drawing.reason else not said
    regions = [part.region for part in parse_regions(result.stdout)]
    assert len(regions) == len(drawing.areas)
    for region, area in zip(regions, drawing.areas, strict=True):
        # A line off by the tolerance everywhere changes the area by tolerance times length.
        assert abs(float(region.area) - area) < 0.2 if drawing.options else region.area == area
