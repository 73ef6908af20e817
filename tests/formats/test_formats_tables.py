"""CSV, objects of x and y, lines of JSON, and results of our own and of other programs."""

import re

import pytest
from command import run

from exactsweep import Polygon
from exactsweep.formats import FormatError, parse_polygon, parse_polygons, parse_regions

TRIANGLE = Polygon([(0, 0), (1, 0), (0, "1/2")])


@pytest.mark.parametrize(
    "text",
    [
        "0,0\n1,0\n0,0.5\n",
        "x,y\n0,0\n1,0\n0,.5\n0,0\n",
        "\n Y ; X ;note\n0;0;a\n\n0;1;b\n+5e-1;0\n",
        '"x"\t"y"\r\n"0"\t0\r\n1\t0\r\n0\t0.5\r\n',
        '[{"x": 0, "y": 0}, {"x": 1, "y": 0}, {"x": 0, "y": 0.5}]',
        '[[{"X": 0, "Y": 0}, {"Y": 0, "X": 1}, {"X": 0, "Y": "1/2"}]]',
        '{"id": "case", "trajectory": [[[0, 0], [1, 0], [0, "1/2"]]]}',
    ],
)
def test_tables_and_answers_are_read(text: str) -> None:
    assert parse_polygon(text) == TRIANGLE


def test_columns_name_polygons_and_rings() -> None:
    rows = [("p", "out", c) for c in ("0,0", "9,0", "9,9", "0,9")]
    rows += [("q", "", c) for c in ("0,0", "1,0", "0,1")]
    rows += [("p", "in", c) for c in ("1,1", "2,1", "1,2")]
    text = "id,ring,x,y\n" + "".join(f"{name},{ring},{at}\n" for name, ring, at in rows)
    p, q = parse_regions(text)
    assert (p.name, len(p.region.holes), q.name, len(q.region.holes)) == ("p", 1, "q", 0)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x,y\n0,0\n1\n", "line 3: 1 cells, without x and y"),
        ("x,y\n0,0\n1,1/2\n1,1\n", "line 3: '1/2' is not a decimal number"),
        ("1,2\n3,\n", "line 2: '' is not a decimal number"),
        ("x,y\n" + "1" * 200_000 + ",2\n", "line 2: '1111"),
        ('[{"x": 0, "z": 0}]', "$[0] is an object, not a pair of numbers"),
        ('[{"x": 0, "y": "a"}]', "$[0].y: 'a' is not a number"),
    ],
)
def test_bad_rows_are_named(text: str, message: str) -> None:
    with pytest.raises(FormatError, match=f"^{re.escape(message)}"):
        parse_polygon(text)


LINES = (
    '{"index": 0, "generatrix": "a", "directrix": "b", "trajectory": [[0,0],[1,0],[0,1]], '
    '"unswept": [[[0,0],[2,0],[0,2]]]}\n'
    '{"index": 1, "error": "no simple polygon"}\n'
    "\n"
    '{"index": 2, "trajectory": [[0,0],[1,0],[0,\n'
    '{"index": 3, "id": "x", "exterior": [[0,0],[3,0],[0,3]], "holes": []}\n'
)


def test_lines_of_json_are_read_one_by_one() -> None:
    done = run("convert", "-", "--to", "json", stdin=LINES)
    assert done.exit_code == 0
    found = parse_polygons(done.stdout)
    assert [one.name for one in found] == ["a b trajectory", "a b unswept 0", "x"]
    assert done.stderr.splitlines() == [
        "left out: standard input: line 2: $: an error: no simple polygon",
        "left out: standard input: line 4: column 44: not JSON: Expecting value",
    ]
    parts = parse_polygons(LINES)
    assert [one.name for one in parts] == ["a b trajectory", "a b unswept 0", "x"]
    assert parts.left_out == [
        "line 2: $: an error: no simple polygon",
        "line 4: column 44: not JSON: Expecting value",
    ]
