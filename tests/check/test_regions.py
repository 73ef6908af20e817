"""False regions of inner fits whose loops together have the right winding number."""

import json
from pathlib import Path
from typing import Any

import pytest
from checkers import check_agreement, needs_node

from exactsweep import Region, inner_fit_polygon
from exactsweep.check.standalone import Refused, prove
from exactsweep.evidence.proof import add_proof


def certify(container: Region, part: list[tuple[int, int]]) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(json.dumps(inner_fit_polygon(container, part).certificate()))
    return found


def regroup(certificate: dict[str, Any], regions: list[Any]) -> dict[str, Any]:
    """Prove other regions with the same edges."""
    made = add_proof({**certificate, "regions": regions})
    found: dict[str, Any] = json.loads(json.dumps(made))
    return found


def pocket() -> tuple[dict[str, Any], dict[str, Any]]:
    """Return a region with a hole, and in the hole a region that touches the midpoint of an edge.

    The hole moves from one to the other.
    """
    ring = [(0, 0), (8, -8), (8, 10), (0, 2), (0, 14), (12, 14), (12, -12), (0, -12)]
    box = Region([(-10, -22), (22, -22), (22, 24), (-10, 24)], [ring])
    true = certify(box, [(0, 0), (-1, -1), (0, -2)])
    around, within = true["regions"]
    regions = [{**around, "holes": []}, {**within, "holes": around["holes"]}]
    return true, regroup(true, regions)


def lenses() -> tuple[dict[str, Any], dict[str, Any]]:
    """Return three regions between two points, whose six arcs are joined into crossing loops.

    The first loop consists of arcs 1 and 4, the second of 3 and 6, the hole of 2 and 5.
    """
    left = [(-4, 0), (-14, 12), (-14, 40), (-4, 40), (-14, 52), (-24, 52), (-24, 0)]
    right = [(0, 0), (20, 0), (20, 20), (4, 25), (-2, 37), (-2, 30), (10, 12)]
    box = [(-60, -60), ("-30.5", -60), (-2, -3), ("26.5", -60), (60, -60), (60, 40), (0, 40)]
    box += [(10, 52), (60, 52), (60, 100), (-60, 100)]
    true = certify(Region(box, [left, right]), [(0, 0), (-4, 0), (-2, -3)])
    arcs = list[list[Any]]()
    for region in true["regions"]:
        for a, b in ((["0", "40"], ["0", "0"]), (["0", "0"], ["0", "40"])):
            points = region["exterior"] * 2
            start = points.index(a)
            arcs.append(points[start : points.index(b, start)])
    one, two, three, four, five, six = arcs
    hole = (two + five)[::-1]
    start = hole.index(["0", "40"])
    first = {"exterior": four + one, "holes": [hole[start:] + hole[:start]]}
    return true, regroup(true, [first, {"exterior": six + three, "holes": []}])


FALSE = {
    "a hole around its exterior": (pocket, "regions[1].holes[0]: winding number 1, expected 0"),
    "a hole that crosses its exterior": (
        lenses,
        "regions[0].exterior, edge 12: meets regions[0].holes[0], edge 6",
    ),
}


@pytest.mark.parametrize("name", FALSE)
def test_false_regions_are_rejected(name: str) -> None:
    made, reason = FALSE[name]
    true, false = made()
    assert prove(true)
    with pytest.raises(Refused) as caught:
        prove(false)
    assert reason in str(caught.value)


@needs_node
@pytest.mark.parametrize("name", FALSE)
def test_both_checkers_agree_on_regions(name: str, tmp_path: Path) -> None:
    assert check_agreement(list(FALSE[name][0]()), tmp_path) == 1
