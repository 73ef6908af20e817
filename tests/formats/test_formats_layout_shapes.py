"""Holes, defects and mirrors, where formats of nesting programs have them."""

import copy
from typing import Any

import nests
import pytest
from test_formats_layouts import read

HOLE = [[1, 1], [2, 1], [1, 2]]
READ_HOLE = [[str(c) for c in corner] for corner in HOLE]


def test_holes_of_jagua_are_its_inner_rings() -> None:
    data = copy.deepcopy(nests.BINS)
    data["items"][0]["shape"]["data"]["inner"] = [HOLE]
    for found in read(data):
        assert found.data["parts"][0]["holes"] == [READ_HOLE]


def test_defects_and_holes_of_packingsolver_are_read_as_they_are_drawn() -> None:
    drawn = [{"type": "LineSegment", "xs": x, "ys": y} for x, y in HOLE]
    data = copy.deepcopy(nests.PACKING_SOLUTION)
    data["bins"][0]["defects"] = [{"shape": drawn}]
    data["bins"][0]["items"][0]["item_shapes"][0]["holes"] = [drawn]
    (found,) = read(data)
    assert found.data["container"]["holes"] == [READ_HOLE]
    assert [part["holes"] for part in found.data["parts"]] == [[READ_HOLE], []]


@pytest.mark.parametrize("whole", [True, False])
@pytest.mark.parametrize("one", [True, False])
def test_packingsolver_allows_mirrors_of_an_item_or_of_a_rotation(whole: bool, one: bool) -> None:
    data: dict[str, Any] = copy.deepcopy(nests.PACKING)
    data["item_types"][0]["allow_mirroring"] = whole
    data["item_types"][0]["allowed_rotations"][1]["mirror"] = one
    (found,) = read(nests.PACKING_SOLUTION, data)
    (part,) = found.data["parts"]
    assert part.get("mirrored", True) is (whole or one)
