"""Layouts by hand, written as short as can be."""

from collections.abc import Sequence
from typing import Any

from exactsweep.layout import Layout

Ring = Sequence[Sequence[Any]]


def box(left: Any, low: Any, right: Any, high: Any) -> Ring:
    """The corners of a rectangle."""
    return [(left, low), (right, low), (right, high), (left, high)]


def put(
    part: str, move: Sequence[Any] = (0, 0), turn: Any = 0, *, mirrored: bool = False
) -> dict[str, Any]:
    """A placement."""
    return {"part": part, "turn": turn, "mirrored": mirrored, "move": move}


def lay(
    container: Ring,
    parts: dict[str, Any],
    *placements: dict[str, Any],
    defects: Sequence[Ring] = (),
    **gaps: Any,
) -> Layout:
    """A layout; a part is a ring, or a dict of the fields of a part."""
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
