"""Pictures drawn with matplotlib (the `plot` extra) at an exact scale.

`plot_sweep` draws a sweep, and `plot_positions` a no-fit polygon or an inner fit. For other
pictures, create a `Picture` from an Axes and a `Scale` that covers all points, and draw on it:

    >>> from exactsweep import sweep
    >>> s = sweep([(0, 0), (1, 0), (0, 1)], [(0, 0), (9, 0), (9, 4), (5, 1), (4, 1), (0, 4)])
    >>> figure = make_figure()
    >>> picture = Picture(figure.axes[0], Scale.of(s.outer.vertices))
    >>> draw_loops(picture, s)
    >>> draw_undercuts(picture, s.undercuts)
    >>> draw_trajectory(picture, s)
    >>> positions = choose_telling_positions(s)
    >>> draw_generatrix(picture, s, positions)
    >>> draw_contacts(picture, s, positions)
    >>> picture.legend()
    >>> save_svg(figure).startswith("<?xml")
    True

More functions draw chains, shapes and exact fits:

    >>> figure = make_figure()
    >>> picture = Picture(figure.axes[0], Scale.of([(-1, -1), (9, 4)]))
    >>> draw_shape(picture, place_generatrix(s, s.trajectory.vertices[0]), style.GENERATRIX, "G")
    >>> draw_chains(picture, {"valley": [(0, 4), (4, 1), (5, 1), (9, 4)]})
    >>> draw_sub_trajectories(picture, [[(0, 3), (4, 0)], [(4, 0), (9, 3)]])
    >>> draw_exact_fits(picture, s, s.exact_fits, [s.trajectory])
    >>> save(figure, "out.svg")  # doctest: +SKIP

Points have int or Fraction coordinates. `style` defines the look of each part. Matplotlib is
imported on first use.
"""

from exactsweep.canvas import style
from exactsweep.canvas.window import AxisScale, DrawError, Scale
from exactsweep.draw.figure import SUFFIXES, make_figure, read_suffix, save, save_svg
from exactsweep.draw.intervals import ContactInterval, cut_trajectory
from exactsweep.draw.no_fits import plot_positions
from exactsweep.draw.picture import Picture, draw_chains, draw_sub_trajectories
from exactsweep.draw.sweeps import (
    choose_telling_positions,
    draw_contacts,
    draw_exact_fits,
    draw_generatrix,
    draw_loops,
    draw_shape,
    draw_trajectory,
    draw_undercuts,
    place_generatrix,
    plot_sweep,
)

ContactStretch = ContactInterval
"""The former name of ContactInterval."""

__all__ = [
    "SUFFIXES",
    "AxisScale",
    "ContactInterval",
    "ContactStretch",
    "DrawError",
    "Picture",
    "Scale",
    "choose_telling_positions",
    "cut_trajectory",
    "draw_chains",
    "draw_contacts",
    "draw_exact_fits",
    "draw_generatrix",
    "draw_loops",
    "draw_shape",
    "draw_sub_trajectories",
    "draw_trajectory",
    "draw_undercuts",
    "make_figure",
    "place_generatrix",
    "plot_positions",
    "plot_sweep",
    "read_suffix",
    "save",
    "save_svg",
    "style",
]
