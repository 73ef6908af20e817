"""Short notation for handwritten layouts."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from exactsweep.layout import Layout
from exactsweep.numbers.number import Rational

Ring = Sequence[Sequence[Any]]


def box(left: Any, low: Any, right: Any, high: Any) -> Ring:
    """Return the corners of a rectangle."""
    return [(left, low), (right, low), (right, high), (left, high)]


def put(
    part: str, move: Sequence[Any] = (0, 0), turn: Any = 0, *, mirrored: bool = False
) -> dict[str, Any]:
    """Return a placement."""
    return {"part": part, "turn": turn, "mirrored": mirrored, "move": move}


def lay(
    container: Ring,
    parts: dict[str, Any],
    *placements: dict[str, Any],
    defects: Sequence[Ring] = (),
    **gaps: Any,
) -> Layout:
    """Return a layout; a part is a ring, or a dict of the fields of a part."""
    described = [
        {"id": name, **(part if isinstance(part, dict) else {"exterior": part})}
        for name, part in parts.items()
    ]
    return Layout.from_json(
        {
            "container": {"exterior": container, "holes": defects},
            "parts": described,
            "placements": placements,
            **gaps,
        }
    )


def image(layout: Layout, factor: Fraction, x: Rational, y: Rational) -> Layout:
    """Return a layout, scaled and then moved as a whole."""
    data = layout.to_json()

    def scale(points: list[list[str]], x: Any = 0, y: Any = 0) -> list[list[Fraction]]:
        return [[factor * Fraction(px) + x, factor * Fraction(py) + y] for px, py in points]

    around = [(data["container"], (x, y))] if "container" in data else []
    for shape, by in (*around, *((part, (0, 0)) for part in data["parts"])):
        for piece in shape.get("pieces", ()):
            piece["points"] = scale(piece["points"], *by)
            piece["radius"] = factor * Fraction(piece["radius"])
        if "exterior" in shape:
            shape["exterior"] = scale(shape["exterior"], *by)
            shape["holes"] = [scale(hole, *by) for hole in shape["holes"]]
    for placement in data["placements"]:
        (placement["move"],) = scale([placement["move"]], x, y)
    for gap in ("spacing", "margin"):
        data[gap] = factor * Fraction(data[gap])
    return Layout.from_json(data)
