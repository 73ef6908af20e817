"""`exactsweep sum` and `exactsweep overlap`: forms of paths, of results, and errors."""

import json
from pathlib import Path

import pytest
from command import refusal, run

from exactsweep import Polygon, Polyline, minkowski_sum, overlap
from exactsweep.formats import parse_regions

SQUARE, OTHER = [(0, 0), (4, 0), (4, 4), (0, 4)], [(2, 2), (6, 2), (6, 6), (2, 6)]
WKT = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"


def save(folder: Path, **texts: str) -> list[str]:
    for name, text in texts.items():
        (folder / name).write_text(text)
    return [str(folder / name) for name in texts]


@pytest.mark.parametrize(
    "path",
    [
        "LINESTRING (1 1, 3 2)",
        "linestring z (1 1 5, 3 2 6)",
        "[[1, 1], [3, 2]]",
        '{"type": "LineString", "coordinates": [[1, 1], [3, 2, 9]]}',
        '{"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[1, 1], [3, 2]]}}',
    ],
)
def test_paths_come_in_many_forms(path: str, tmp_path: Path) -> None:
    square, line = save(tmp_path, square=WKT, line=path)
    done = run("sum", square, line, "--json")
    found = json.loads(done.stdout)
    expected = minkowski_sum(SQUARE, Polyline([(1, 1), (3, 2)]))
    assert found["b"] == {"path": [["1", "1"], ["3", "2"]], "closed": False}
    assert Polygon(found["exterior"]) == expected.exterior
    assert (found["holes"], found["area"]) == ([], str(expected.area))


def test_a_list_of_points_is_a_path_with_the_option(tmp_path: Path) -> None:
    points = "[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]"
    square, ring = save(tmp_path, square=WKT, ring=points)
    (filled,) = parse_regions(run("sum", square, ring, "--wkt").stdout)
    assert filled.region == minkowski_sum(SQUARE, [(0, 0), (9, 0), (9, 9), (0, 9)])
    (covered,) = parse_regions(run("sum", square, "-", "--path", "--wkt", stdin=points).stdout)
    around = Polyline([(0, 0), (9, 0), (9, 9), (0, 9)], closed=True)
    assert covered.region == minkowski_sum(SQUARE, around)
    assert len(covered.region.holes) == 1
    assert "is not a path; --path reads" in run("sum", square, square, "--path").stderr


def test_sums_are_rounded_outward(tmp_path: Path) -> None:
    square, third = save(tmp_path, square=WKT, third='[[0, 0], ["1/3", 0]]')
    assert "not a finite decimal" in refusal(run("sum", square, third, "--wkt"))
    done = run("sum", square, third, "--to", "wkt", "--round", "1", "--round-outward")
    (found,) = parse_regions(done.stdout)
    assert found.region.area > minkowski_sum(SQUARE, Polyline([(0, 0), ("1/3", 0)])).area
    for wrong in (["--json", "--wkt"], ["--round", "1"]):
        assert run("sum", square, third, *wrong).exit_code == 2


def test_a_point_moves_the_polygon(tmp_path: Path) -> None:
    square, point = save(tmp_path, square=WKT, point="POINT (5 6)")
    assert run("sum", square, point, "--wkt").stdout == ("POLYGON ((5 6, 9 6, 9 10, 5 10, 5 6))\n")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("LINESTRING (0 0, 1)", "line 1, column 19: expected a number, found ')'"),
        ("LINESTRING (0 0, 1 1) POINT (0 0)", "after the end of the path"),
        ("[[0, 0], [1]]", r"$[1]"),
        ('{"type": "LineString", "coordinates": 5}', "$.coordinates"),
        ("[]", "at least one point"),
    ],
)
def test_a_wrong_path_is_named(text: str, message: str, tmp_path: Path) -> None:
    square, line = save(tmp_path, square=WKT, line=text)
    message_shown = refusal(run("sum", square, line))
    assert message in message_shown
    assert message_shown.startswith(line)


def test_one_pair_is_reported_in_full(tmp_path: Path) -> None:
    (both,) = save(tmp_path, both=f"{WKT} POLYGON ((2 2, 6 2, 6 6, 2 6, 2 2))")
    found = json.loads(run("overlap", both, "--json").stdout)
    o = overlap(SQUARE, OTHER)
    assert [found[name] for name in ("verdict", "area", "depth_squared")] == ["OVERLAP", "4", "4"]
    assert found["move"] == [str(c) for c in o.move]
    text = run("overlap", both).stdout
    assert text.splitlines()[:3] == ["verdict      OVERLAP", "common area  4", "depth        2"]


def test_all_pairs_are_compared_and_free_ones_are_counted(tmp_path: Path) -> None:
    squares = [[(5 * k + x, y) for x, y in SQUARE] for k in range(4)]
    squares += [[(x + 1, y + 4) for x, y in SQUARE], [(x + 2, y + 1) for x, y in SQUARE]]
    (many,) = save(tmp_path, many=json.dumps(squares))
    lines = [json.loads(line) for line in run("overlap", many, "--json").stdout.splitlines()]
    verdicts = {(line["a"], line["b"]): line["verdict"] for line in lines}
    assert verdicts == {
        ("0", "4"): "CONTACT",
        ("0", "5"): "OVERLAP",
        ("1", "4"): "CONTACT",
        ("1", "5"): "OVERLAP",
        ("4", "5"): "OVERLAP",
    }
    assert run("overlap", many).stdout.splitlines()[-1] == "3 overlaps, 2 in contact, 10 free"
    first, second = save(tmp_path, first=json.dumps(squares[:1]), second=json.dumps(squares[4:]))
    assert run("overlap", first, second).stdout.splitlines()[-1] == (
        "1 overlap, 1 in contact, 0 free"
    )


def test_a_single_polygon_is_an_error(tmp_path: Path) -> None:
    (one,) = save(tmp_path, one=WKT)
    assert refusal(run("overlap", one)) == f"{one}: contains a single polygon; give a second file"


def test_shapes_apart_have_a_distance(tmp_path: Path) -> None:
    a, b = save(tmp_path, a=WKT, b="POLYGON ((7 8, 9 8, 9 9, 7 9, 7 8))")
    assert run("overlap", a, b).stdout == ("verdict   FREE\ndistance  5\nnearest   (4,4) (7,8)\n")
    c, d = save(tmp_path, c=WKT, d="POLYGON ((4 4, 9 4, 9 9, 4 4))")
    assert run("overlap", c, d).stdout == ("verdict  CONTACT\nwitness  (4,4), on both boundaries\n")


def test_polygons_of_a_file_are_handled_alone_or_together(tmp_path: Path) -> None:
    two = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((2 0, 3 0, 3 1, 2 1, 2 0)))"
    unit = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
    obstacles, part = save(tmp_path, obstacles=two, part=unit)
    alone = run("nfp", obstacles, part)
    assert "2 polygons, handled one by one; --together treats them" in alone.stderr
    together = run("nfp", obstacles, part, "--together", "--wkt")
    assert together.stdout == (
        "POLYGON ((-1 -1, 3 -1, 3 1, -1 1, -1 -1))\nLINESTRING (1 -1, 1 1)\n"
    )
    assert together.stderr == ""
    found = json.loads(run("nfp", part, obstacles, "--together", "--json").stdout)
    assert (found["area"], len(found["orbiting"]), len(found["regions"])) == ("8", 2, 1)
    assert "stationary   2\norbiting     1\n" in run("nfp", obstacles, part, "--together").stdout
    for options in (["--certificate"], ["--turns", "0,90"]):
        assert run("nfp", obstacles, part, "--together", *options).exit_code != 0
    (knot,) = save(tmp_path, knot=f"{unit} POLYGON ((5 5, 7 7, 7 5, 5 7, 5 5))")
    assert run("nfp", knot, part).exit_code == 0
    assert "crosses itself" in refusal(run("nfp", knot, part, "--together"))


def test_a_group_of_svg_is_one_rigid_shape(tmp_path: Path) -> None:
    drawn = """<svg xmlns="http://www.w3.org/2000/svg"><rect id="sheet" width="100" height="50"/>
    <g id="part"><rect x="5" y="5" width="30" height="30"/><rect x="10" y="10" width="5" height="5"
    /><rect x="36" y="5" width="4" height="4"/></g><rect id="unit" width="1" height="1"/></svg>"""
    (file,) = save(tmp_path, drawing=drawn)
    found = json.loads(run("nfp", f"{file}#part", f"{file}#unit", "--json").stdout)
    # 31 by 31 and 5 by 5, less the hole of 4 by 4, where the unit fits.
    assert (found["area"], len(found["stationary"])) == ("970", 2)
    fit = json.loads(run("ifp", f"{file}#sheet", f"{file}#part", "--json").stdout)
    assert (fit["area"], len(fit["attached"])) == (str((100 - 35) * (50 - 30)), 1)
    turned = run("ifp", f"{file}#sheet", f"{file}#part", "--turns", "90", "--json").stdout
    assert json.loads(turned)["area"] == str((100 - 30) * (50 - 35))
    assert "outlines, not one" in refusal(run("ifp", f"{file}#part", f"{file}#unit"))
    assert "Groups need a single pair and pose" in run("nfp", file, f"{file}#part").stderr
