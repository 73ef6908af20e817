"""Batches of polygons of any shape, with holes and exact fits."""

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
PARTS = (SQUARE, PLATE)


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
    assert one["holes"] == two["holes"] == [[["5", "1"], ["6", "1"], ["6", "2"], ["5", "2"]]]


def test_batches_that_differ_in_holes_differ() -> None:
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


def test_a_part_list_without_parts_is_rejected() -> None:
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
