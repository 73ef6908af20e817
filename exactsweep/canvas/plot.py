"""Shapes drawn with matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from exactsweep.canvas.window import DrawError
from exactsweep.numbers.error import require_imports
from exactsweep.numbers.number import PointRings

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def plot_rings(rings: PointRings, axes: Axes | None, style: dict[str, Any]) -> Axes:
    """Draw a filled shape, with equal units on both axes; see `PointSet.plot`."""
    with require_imports("matplotlib", "a picture", DrawError):
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path
    if axes is None:
        from matplotlib import pyplot

        axes = pyplot.figure().subplots()
    exterior, *holes = rings
    # Holes run clockwise, so that they are excluded.
    loops = [exterior, *(hole[::-1] for hole in holes)]
    paths = [Path([(float(x), float(y)) for x, y in (*r, r[0])], closed=True) for r in loops]
    axes.add_patch(PathPatch(Path.make_compound_path(*paths), **{"alpha": 0.5, **style}))
    axes.set_aspect("equal")
    axes.autoscale_view()
    return axes
