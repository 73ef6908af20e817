"""Circles, slots and rounded rectangles of drawings, read as rounded pieces of layouts."""

from __future__ import annotations

from decimal import Decimal, localcontext
from fractions import Fraction
from typing import Any

import pytest
from mpmath import mp, mpf

from exactsweep.formats.layouts import parse_layouts, read_layouts
from exactsweep.layout import Layout, judge_layout

SLOT = "M0 0h8a1 1 0 0 1 0 2h-8a1 1 0 0 1 0-2z"


def read(shapes: str) -> list[dict[str, Any]]:
    (found,) = parse_layouts(f"<svg>{shapes}</svg>", container=False)
    parts: list[dict[str, Any]] = found.data["parts"]
    return parts


def pieces(shape: str) -> tuple[list[list[str]], str] | None:
    (part,) = read(shape)
    if "pieces" not in part:
        assert part["error"]
        return None
    (piece,) = part["pieces"]
    return sorted(piece["points"]), piece["radius"]


@pytest.mark.parametrize(
    ("shape", "points", "radius"),
    [
        ('<circle cx="1" cy="2" r="0.5"/>', [["1", "2"]], "1/2"),
        ('<ellipse cx="1" cy="2" rx="3" ry="3"/>', [["1", "2"]], "3"),
        ('<path d="M0 0a5 5 0 1 1 0 10a5 5 0 1 1 0-10"/>', [["0", "5"]], "5"),
        (f'<path d="{SLOT}"/>', [["0", "1"], ["8", "1"]], "1"),
        ('<path d="M0 0a1 1 0 0 0 0 2h8a1 1 0 0 0 0-2z"/>', [["0", "1"], ["8", "1"]], "1"),
        ('<rect width="10" height="6" rx="3"/>', [["3", "3"], ["7", "3"]], "3"),
        (
            '<rect width="9" height="6" ry="2"/>',
            [["2", "2"], ["2", "4"], ["7", "2"], ["7", "4"]],
            "2",
        ),
        ('<circle r="2" transform="matrix(3 4 -4 3 1 0)"/>', [["1", "0"]], "10"),
        ('<circle r="2" transform="scale(1 -1)"/>', [["0", "0"]], "2"),
        (f'<path d="{SLOT}" transform="scale(-2 2)"/>', [["-16", "2"], ["0", "2"]], "2"),
    ],
)
def test_arcs_of_one_radius_and_tangents_are_a_rounded_piece(
    shape: str, points: list[list[str]], radius: str
) -> None:
    assert pieces(shape) == (sorted(points), radius)


@pytest.mark.parametrize(
    "shape",
    [
        '<circle r="2" transform="scale(1 2)"/>',
        '<circle r="1" transform="matrix(1 1 -1 1 0 0)"/>',
        '<ellipse rx="3" ry="2"/>',
        '<rect width="9" height="6" rx="2" ry="1"/>',
        # Not tangent, two radii, a notch, and an arc of opposite orientation.
        '<path d="M0 0h8a1 1 0 0 1 0 2h-9a1 1 0 0 1 1-2z"/>',
        '<path d="M0 0h8a2 2 0 0 1 0 4h-8a2.5 2.5 0 0 1 0-4z"/>',
        '<path d="M0 0h8a1 1 0 0 1 0 2h-8a1 1 0 0 0 0-2z"/>',
        '<path d="M0 0h4v-1h1v1h3a1 1 0 0 1 0 2h-8a1 1 0 0 1 0-2z"/>',
        '<path d="M0 0a5 5 0 0 1 10 0z"/>',
    ],
)
def test_other_curves_keep_their_error(shape: str) -> None:
    assert pieces(shape) is None


def test_a_disc_with_a_hole_is_flattened() -> None:
    (part,) = read('<circle r="5"/><circle r="2"/>')
    assert "pieces" not in part
    assert len(part["holes"]) == 1


def test_discs_are_judged_without_error() -> None:
    shapes = "".join(f'<circle cx="{x}" cy="{y}" r="5"/>' for x, y in ((5, 5), (11, 13)))
    sheet = '<rect id="sheet" width="16" height="18"/>'
    (found,) = parse_layouts(f"<svg>{sheet}{shapes}</svg>")
    judgement = judge_layout(Layout.from_json(found.data))
    assert judgement.valid
    assert judgement.contacts == ((0, 1),)
    assert not judgement.layout.greatest_error


def test_a_disc_is_a_container() -> None:
    shapes = '<circle id="sheet" r="5"/><circle cx="3" r="2"/><circle cx="-2.9" r="2.11"/>'
    (found,) = parse_layouts(f"<svg>{shapes}</svg>")
    (fault,) = judge_layout(Layout.from_json(found.data)).faults
    assert (fault.kind, fault.placements) == ("outside", (1,))


def entity(kind: str, **groups: Any) -> str:
    return f"0\n{kind}\n8\n0\n" + "".join(f"{code[1:]}\n{v}\n" for code, v in groups.items())


def drawing(*entities: str) -> str:
    return "0\nSECTION\n2\nENTITIES\n" + "".join(entities) + "0\nENDSEC\n0\nEOF\n"


def test_dxf_circles_and_slots_are_rounded_pieces() -> None:
    text = drawing(
        entity("CIRCLE", _10=50, _20=1, _40="0.25"),
        entity("LINE", _10=0, _20=0, _11=8, _21=0),
        entity("ARC", _10=8, _20=1, _40=1, _50=270, _51=90),
        entity("LINE", _10=8, _20=2, _11=0, _21=2),
        entity("ARC", _10=0, _20=1, _40=1, _50=90, _51=270),
    )
    (found,) = parse_layouts(text, container=False)
    assert [part["pieces"][0]["radius"] for part in found.data["parts"]] == ["1/4", "1"]
    bulges = "".join(
        f"10\n{x}\n20\n{y}\n42\n{bulge}\n"
        for x, y, bulge in ((0, 20, 0), (8, 20, 1), (8, 24, 0), (0, 24, 1))
    )
    text = drawing(f"0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n{bulges}")
    (found,) = parse_layouts(text, container=False)
    (part,) = found.data["parts"]
    assert sorted(part["pieces"][0]["points"]) == [["0", "22"], ["8", "22"]]


def test_discs_of_an_instance_are_found_again(tmp_path: Any) -> None:
    sheet = '<rect id="sheet" width="99" height="99"/>'
    place = tmp_path / "nest.svg"
    place.write_text(
        f'<svg>{sheet}<circle cx="9" cy="9" r="4"/><path d="{SLOT}" '
        'transform="translate(50 50) matrix(.6 .8 -.8 .6 0 0)"/></svg>'
    )
    parts = tmp_path / "parts.svg"
    parts.write_text(
        f'<svg><circle id="disc" r="4"/><path id="slot" d="{SLOT}" '
        'transform="translate(20 20)"/><circle id="more" cx="90" r="5"/></svg>'
    )
    (found,) = read_layouts(str(place), instance=str(parts))
    judgement = judge_layout(Layout.from_json(found.data))
    assert [(fault.kind, fault.part) for fault in judgement.faults] == [("missing", "more")]


@pytest.mark.parametrize(
    "dot",
    [
        '<path d="M1 2h0" {}/>',
        '<path d="M1 2L1 2" {}/>',
        '<line x1="1" y1="2" x2="1" y2="2" {}/>',
        '<polyline points="1,2 1,2" {}/>',
        '<g {}><path d="M1 2z"/></g>',
    ],
)
def test_dots_with_round_caps_are_discs(dot: str) -> None:
    round_cap = dot.format('stroke="red" stroke-linecap="round" stroke-width="3px"')
    assert pieces(round_cap) == ([["1", "2"]], "3/2")
    scaled = f'<g transform="scale(2)">{round_cap}</g>'
    assert pieces(scaled) == ([["2", "4"]], "3")


@pytest.mark.parametrize("cap", ["butt", "square"])
@pytest.mark.parametrize("dot", ['<path d="M1 2h0" {}/>', '<path d="M1 2z" {}/>'])
def test_strokes_of_length_zero_are_reported(dot: str, cap: str) -> None:
    dot = dot.format(f'id="tick" stroke="red" stroke-linecap="{cap}"')
    (found,) = parse_layouts(f'<svg>{dot}<rect width="9" height="9"/></svg>', container=False)
    assert len(found.data["parts"]) == 1
    assert any("'tick': a stroke of length zero" in note for note in found.notes)


def test_a_single_point_is_not_a_dot() -> None:
    point = '<polyline points="1,2" stroke="red" stroke-linecap="round"/>'
    assert len(read(f'{point}<circle r="9"/>')) == 1


@pytest.mark.parametrize("at", ["", " 7 -9"])
@pytest.mark.parametrize(("off", "kinds"), [("-1e-30", ["overlap"]), ("1e-30", []), ("0", None)])
def test_rotated_discs_have_the_error_of_their_centers(
    at: str, off: str, kinds: list[str] | None
) -> None:
    with localcontext(prec=60):
        digits = f"{Decimal(24) + Decimal(off)}"
    discs = f'<circle cx="20" cy="3" r="2"/><circle cx="{digits}" cy="3" r="2"/>'
    parts = read(f'<g transform="rotate(30{at})">{discs}</g>')
    for part, x in zip(parts, ("20", digits), strict=True):
        (piece,) = part["pieces"]
        assert piece["radius"] == "2"
        with mp.workdps(60):
            a, b = map(mpf, at.split() or (0, 0))
            u, v = mpf(x) - a, 3 - b
            c, s = mp.sqrt(3) / 2, mpf(1) / 2
            true = a + c * u - s * v, b + s * u + c * v
            near = [mpf(n.numerator) / n.denominator for n in map(Fraction, piece["points"][0])]
            error = mpf(float(Fraction(part["error"])))
            assert mp.hypot(near[0] - true[0], near[1] - true[1]) <= error * (1 + mpf(10) ** -9)
    data = {"parts": parts, "placements": [{"part": p["id"], "move": ["0", "0"]} for p in parts]}
    found = [fault.kind for fault in judge_layout(Layout.from_json(data)).faults]
    assert found == (["undecided"] if kinds is None else kinds)
