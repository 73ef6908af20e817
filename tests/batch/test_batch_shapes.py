"""Batches of polygons of any shape: holes in, and no-fit polygons with holes and exact fits out."""

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

from command import run
from hypothesis import given
from partlist import part_list
from strategies import simple_polygons
from tiers import examples

from exactsweep import Polygon, Region, no_fit_polygon, sweep
from exactsweep.batch import Part, read_parts, take_all_pairs, take_listed_pairs
from exactsweep.formats import parse_polygon
from exactsweep.geometry.region import AnyPolygon

SQUARE = Part("square", Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]))
# Holes of 2 x 1, exactly as high as the square, and of 2 x 2.
PLATE = Part(
    "plate",
    Region(
        [(0, 0), (9, 0), (9, 5), (0, 5)],
        [[(1, 1), (3, 1), (3, 2), (1, 2)], [(5, 1), (7, 1), (7, 3), (5, 3)]],
    ),
)
# A square that goes round a cave by its walls passes by the middle.
CAVE = Part(
    "cave",
    parse_polygon(
        "POLYGON ((0 0, 10 0, 10 10, 5 10, 5 8, 8 8, 8 2, 2 2, 2 8, 3 8, 3 10, 0 10, 0 0))"
    ),
)
PARTS = (SQUARE, PLATE, CAVE)


def records(what: str) -> dict[tuple[str, str], dict[str, Any]]:
    """The records of all pairs of PARTS, by their names."""
    job = take_all_pairs(PARTS, PARTS, what)
    lines = [line for chunk in job.chunks(0) for line in job.work.lines(chunk)]
    found = map(json.loads, lines)
    return {(record["generatrix"], record["directrix"]): record for record in found}


def test_a_no_fit_polygon_has_its_holes_and_exact_fits() -> None:
    assert records("nfp")["square", "plate"] == {
        "index": 1,
        "generatrix": "square",
        "directrix": "plate",
        "kind": "SS",
        "exterior": [["-1", "-1"], ["9", "-1"], ["9", "5"], ["-1", "5"]],
        "holes": [[["5", "1"], ["6", "1"], ["6", "2"], ["5", "2"]]],
        "exact_fits": [[["1", "1"], ["2", "1"]]],
        "area": "59",
    }


def test_pairs_without_a_shared_direction_are_swept() -> None:
    found = records("loops")
    assert not any("error" in record for record in found.values())
    record = found["square", "cave"]
    assert (record["kind"], record["direction"]) == ("SS", None)
    assert record["unswept"] == [[["3", "3"], ["7", "3"], ["7", "7"], ["3", "7"]]]
    assert list(record)[3:] == [
        "kind", "direction", "trajectory", "inner", "outer", "unswept", "area",
    ]  # fmt: skip
    assert record["area"] == str(144 - 60 - 16) == records("areas")["square", "cave"]["area"]
    assert list(found["square", "square"])[3:] == [
        "kind", "direction", "trajectory", "inner", "outer", "area",
    ]  # fmt: skip


@examples(10)
@given(simple_polygons(), simple_polygons())
def test_records_are_what_the_functions_return(g: Polygon, d: Polygon) -> None:
    for what in ("nfp", "loops"):
        work = take_all_pairs([Part("g", g)], [Part("d", d)], what).work
        record = json.loads(work.line(0, 0))
        expected = no_fit_polygon(d, g) if what == "nfp" else sweep(g, d)
        assert Fraction(record["area"]) == expected.area
        for name in ("exterior", "trajectory", "inner", "outer"):
            if name in record:
                assert Polygon(record[name]) == getattr(expected, name)
        for name in ("holes", "unswept"):
            if name in record:
                assert tuple(map(Polygon, record[name])) == getattr(expected, name)
        fits = [
            [(Fraction(x), Fraction(y)) for x, y in fit] for fit in record.get("exact_fits", [])
        ]
        if what == "nfp":
            assert fits == [list(fit) for fit in expected.exact_fits]


def test_holes_are_read_from_parts_and_pairs(tmp_path: Path) -> None:
    parts = tmp_path / "parts.json"
    plate: dict[str, Any] = {"id": "plate", "exterior": [[0, 0], [9, 0], [9, 5], [0, 5]]}
    holes = [[[1, 1], [3, 1], [3, 2], [1, 2]], [[5, 1], [7, 1], [7, 3], [5, 3]]]
    bad = {"id": "bad", "exterior": plate["exterior"], "holes": [[[8, 4], [10, 4], [8, 3]]]}
    parts.write_text(json.dumps({"polygons": [{**plate, "holes": holes}, plate, bad]}))
    whole, solid, refused = read_parts(str(parts))
    assert whole == PLATE
    assert solid == Part("plate", Polygon([(0, 0), (9, 0), (9, 5), (0, 5)]))
    assert isinstance(refused.polygon, str)
    assert refused.polygon.startswith("$.polygons[2]: the exterior, edge 1, and hole 0, ")
    pairs = tmp_path / "pairs.jsonl"
    line = {"generatrix": [[0, 0], [1, 0], [1, 1], [0, 1]], "directrix": {**plate, "holes": holes}}
    named = {"generatrix": line["generatrix"], "directrix": "plate"}
    pairs.write_text(f"{json.dumps(line)}\n{json.dumps(named)}\n")
    job = take_listed_pairs(str(pairs), [whole], "nfp")
    one, two = (json.loads(text) for chunk in job.chunks(0) for text in job.work.lines(chunk))
    assert one["holes"] == two["holes"] == records("nfp")["square", "plate"]["holes"]


def test_the_reference_counts_and_a_direction_has_no_place(tmp_path: Path) -> None:
    work = take_all_pairs(PARTS, PARTS, "nfp").work
    pair = b'{"generatrix": "square", "directrix": "plate", %s}'
    record = json.loads(work.line(0, pair % b'"reference": [1, "1/2"]'))
    assert record["exact_fits"] == [[["2", "3/2"], ["3", "3/2"]]]
    record = json.loads(work.line(0, pair % b'"direction": [1, 0]'))
    assert record["error"] == "$.direction: a no-fit polygon takes no direction"
    loops = take_all_pairs(PARTS, PARTS, "loops").work
    record = json.loads(loops.line(0, pair % b'"direction": [1, 0]'))
    assert record["error"] == "the directrix has a hole: it is monotone to no direction"


def test_batches_that_differ_in_holes_are_told_apart() -> None:
    assert isinstance(PLATE.polygon, Region)
    first, second = PLATE.polygon.holes
    solid = Polygon(PLATE.polygon.exterior)
    others: list[AnyPolygon] = [
        solid,
        Region(solid, [first]),
        Region(solid, [second]),
        PLATE.polygon,
    ]
    jobs = [take_all_pairs([SQUARE], [Part("plate", other)]) for other in others]
    assert len({job.digest for job in jobs}) == len(others)


def test_no_part_of_the_part_list_is_refused() -> None:
    parts = part_list(30)
    job = take_all_pairs(parts, parts[:3], "nfp")
    for chunk in job.chunks(0):
        assert not any(b'"error"' in line for line in job.work.lines(chunk))


def test_the_command_computes_no_fit_polygons(tmp_path: Path) -> None:
    parts, output = tmp_path / "parts.wkt", tmp_path / "out"
    parts.write_text(
        "POLYGON ((0 0, 5 0, 5 5, 0 5, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))\n"
        "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))\n"
    )
    options = ("--compute", "nfp", "-o", str(output), "--workers", "1")
    done = run("batch", "--all", f"{parts}#1", f"{parts}#0", *options)
    assert (done.exit_code, done.output) == (0, "1 pair, 0 refused\n")
    assert json.loads(output.read_text())["exact_fits"] == [[["1", "1"], ["1", "1"]]]
