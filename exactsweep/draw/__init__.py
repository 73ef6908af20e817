"""Pictures, drawn with matplotlib (the `plot` extra) at an exact scale.

`plot_sweep` draws a sweep, `plot_positions` a no-fit polygon or an inner fit. For other pictures
make a `Picture` on an Axes, with a `Scale` that covers all points, and draw on it:

    figure = make_figure()
    picture = Picture(figure.axes[0], Scale.of(d.vertices, *chains))
    picture.area(d.vertices, style.DIRECTRIX, "directrix D")
    draw_sub_trajectories(picture, chains, envelope)
    picture.legend()
    save(figure, "out.svg")

`Picture` accepts points with int or Fraction coordinates. The functions `draw_...` draw parts of a
sweep, and `style` defines the look of each. The package imports matplotlib only when it draws.
"""

from exactsweep.canvas import style
from exactsweep.canvas.error import DrawError
from exactsweep.canvas.scale import AxisScale, Scale
from exactsweep.draw.chains import draw_chains, draw_sub_trajectories
from exactsweep.draw.figure import SUFFIXES, make_figure, read_suffix, save, save_svg
from exactsweep.draw.no_fits import plot_positions
from exactsweep.draw.picture import Picture
from exactsweep.draw.stretches import ContactStretch, cut_trajectory
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

__all__ = [
    "SUFFIXES",
    "AxisScale",
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
