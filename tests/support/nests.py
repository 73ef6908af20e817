"""One layout as each nesting program writes it: an L and its half turn fill a box of 4 by 3.

The L stands at the origin of the box. The other one is turned by 180 degrees about the origin of
the part and moved to the opposite corner.
"""

import json
from typing import Any

L = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]]
# The box is 4 wide: between the arms of both there is a gap of 2 by 1.
BOX = [[0, 0], [4, 0], [4, 3], [0, 3]]
MOVES = [("0", [0, 0]), ("180", [4, 3])]

LAYOUT: dict[str, Any] = {
    "container": {"exterior": BOX},
    "parts": [{"id": "L", "exterior": L, "demand": 2, "turns": ["0", "180"], "mirrored": False}],
    "placements": [{"part": "L", "turn": turn, "move": move} for turn, move in MOVES],
}
ITEM: dict[str, Any] = {
    "id": 0,
    "demand": 2,
    "allowed_orientations": [0.0, 180.0],
    "shape": {"type": "simple_polygon", "data": L},
}
PLACED = [
    {"item_id": 0, "transformation": {"rotation": float(turn), "translation": move}}
    for turn, move in MOVES
]
SPARROW: dict[str, Any] = {
    "name": "two",
    "items": [ITEM],
    "strip_height": 3.0,
    "solution": {
        "strip_width": 4.0,
        "layout": {"container_id": 0, "placed_items": PLACED, "density": 0.8},
        "density": 0.8,
        "run_time_sec": 1,
    },
}
BINS: dict[str, Any] = {
    "name": "two",
    "items": [{**ITEM, "min_quality": 1, "shape": {"type": "polygon", "data": {"outer": L}}}],
    "bins": [
        {
            "id": 0,
            "shape": {
                "type": "rectangle",
                "data": {"x_min": 0, "y_min": 0, "width": 4, "height": 3},
            },
            "zones": [
                {
                    "quality": 0,
                    "shape": {"type": "simple_polygon", "data": [[2, 2], [3, 2], [2, 1]]},
                },
                {
                    "quality": 2,
                    "shape": {"type": "simple_polygon", "data": [[2, 2], [3, 2], [3, 1]]},
                },
            ],
            "stock": 2,
            "cost": 1,
        }
    ],
    "solution": {
        "cost": 2,
        "layouts": [{"container_id": 0, "placed_items": [placed]} for placed in PLACED],
        "density": 0.4,
    },
}
SPYRROW: dict[str, Any] = {
    "name": "two",
    "strip_height": 3.0,
    "items": [{"id": "L", "demand": 2, "allowed_orientations": None, "shape": L}],
}
SPYRROW_SOLUTION: dict[str, Any] = {
    "width": 4.0,
    "density": 0.8,
    "placed_items": [
        {"id": "L", "rotation": float(turn), "translation": move} for turn, move in MOVES
    ],
}
PACKING: dict[str, Any] = {
    "objective": "bin-packing",
    "parameters": {"item_item_minimum_spacing": 0},
    "bin_types": [
        {
            "type": "rectangle",
            "width": 4,
            "height": 3,
            "copies": 2,
            "item_bin_minimum_spacing": 0,
            "defects": [
                {
                    "type": "polygon",
                    "vertices": [{"x": 2, "y": 1}, {"x": 3, "y": 2}, {"x": 2, "y": 2}],
                    "item_defect_minimum_spacing": 1,
                }
            ],
        }
    ],
    "item_types": [
        {
            "type": "general",
            "copies": 2,
            "elements": [
                {"type": "LineSegment", "start": dict(zip("xy", p, strict=True)), "end": {}}
                for p in L
            ],
            "allowed_rotations": [{"start": 0, "end": 0}, {"start": 180, "end": 180}],
        }
    ],
}
PACKING_SOLUTION: dict[str, Any] = {
    "bins": [
        {
            "copies": 1,
            "id": 0,
            "shape": [{"type": "LineSegment", "xs": x, "ys": y, "xe": 0, "ye": 0} for x, y in BOX],
            "items": [
                {
                    "id": 0,
                    "x": x,
                    "y": y,
                    "angle": float(turn),
                    "mirror": False,
                    "item_shapes": [
                        {
                            "shape": [
                                {
                                    "type": "LineSegment",
                                    "xs": x + (a if turn == "0" else -a),
                                    "ys": y + (b if turn == "0" else -b),
                                }
                                for a, b in L
                            ]
                        }
                    ],
                }
                for turn, (x, y) in MOVES
            ],
        }
    ],
}
CGSHOP: dict[str, Any] = {
    "type": "cgshop2024_instance",
    "instance_name": "two",
    "num_items": 2,
    "container": {"x": [x for x, _ in BOX], "y": [y for _, y in BOX]},
    "items": [
        {"value": 1, "quantity": 3, "x": [x for x, _ in L], "y": [y for _, y in L]},
        {"value": 1, "quantity": 1, "x": [4 - x for x, _ in L], "y": [3 - y for _, y in L]},
    ],
}
CGSHOP_SOLUTION: dict[str, Any] = {
    "type": "cgshop2024_solution",
    "instance_name": "two",
    "num_included_items": 2,
    "item_indices": [0, 1],
    "x_translations": [0, 0],
    "y_translations": [0, 0],
}
_PATH = "M" + " L".join(f"{x},{y}" for x, y in L) + " z"
SPARROW_SVG = f"""<svg viewBox="0 0 5 4" xmlns="http://www.w3.org/2000/svg">
<g id="container_0"><path d="M0,0 L4,0 L4,3 L0,3 z"/><title>container</title></g>
<g id="items"><defs><g id="item_0"><path d="{_PATH}" fill-rule="nonzero"/></g>
<path d="{_PATH}" id="cd_shape_0"/></defs>
<use href="#item_0" transform="translate(0 0), rotate(0)"><title>item</title></use>
<use href="#item_0" transform="translate(4 3), rotate(-180)"/></g>
<g id="quality_zones"/>
<g id="optionals"><g><use href="#cd_shape_0" transform="translate(0 0), rotate(0)"/></g></g>
</svg>"""
SVGNEST_SVG = f"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 3">
<g transform="translate(0 0)"><rect class="bin" x="9" y="9" width="4" height="3"
 transform="translate(-9 -9)"/>
<g transform="translate(0 0) rotate(0)"><path d="{_PATH}"/></g>
<g transform="translate(4 3) rotate(180)"><path d="{_PATH}"/></g></g>
</svg>"""
DEEPNEST_SVG = f"""<svg xmlns="http://www.w3.org/2000/svg" width="4mm" height="3mm"
 viewBox="0 0 4 3">
<g transform="translate(-5 -5)">
<rect x="0" y="0" width="4" height="3" stroke="#00ff00" fill="none"/>
<g transform="translate(0 0) rotate(0)" id="0"><path d="{_PATH}"/></g></g>
<g transform="translate(-5 -2)">
<rect x="0" y="0" width="4" height="3" stroke="#00ff00" fill="none"/>
<g transform="translate(4 3) rotate(180)" id="1"><path d="{_PATH}"/></g></g>
</svg>"""
DRAWING_SVG = """<svg xmlns="http://www.w3.org/2000/svg">
<rect id="sheet" width="4" height="3"/>
<path id="a" d="M0 0H3V1H1V3H0z"/><path id="b" d="M4 3H1V2H3V0H4z"/>
</svg>"""

FILES: dict[str, tuple[str, str | None]] = {
    name: (
        text if isinstance(text, str) else json.dumps(text),
        None if instance is None else json.dumps(instance),
    )
    for name, (text, instance) in {
        "layout.json": (LAYOUT, None),
        "sparrow.json": (SPARROW, None),
        "bins.json": (BINS, None),
        "spyrrow.json": (SPYRROW_SOLUTION, SPYRROW),
        "packing.json": (PACKING_SOLUTION, PACKING),
        "drawn.json": (PACKING_SOLUTION, None),
        "cgshop.json": (CGSHOP_SOLUTION, CGSHOP),
        "sparrow.svg": (SPARROW_SVG, SPARROW),
        "svgnest.svg": (SVGNEST_SVG, None),
        "deepnest.svg": (DEEPNEST_SVG, None),
        "drawing.svg": (DRAWING_SVG, None),
    }.items()
}
"""By name: the text of a file, and that of its instance, if it needs one."""
