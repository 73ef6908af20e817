"""HTML pictures and tables of sweeps, no-fit polygons and inner fits, for notebooks."""

from collections.abc import Iterable
from dataclasses import replace

from exactsweep.canvas import style
from exactsweep.canvas.svg import Shape, add_table, write_svg
from exactsweep.draw import sweeps
from exactsweep.draw.no_fits import Positions
from exactsweep.evidence.no_fit import InnerFitAnswer, NoFitAnswer
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.number import Fit
from exactsweep.words import CLASSES, write_pair, write_size


def draw_sweep(s: SweepAnswer) -> str:
    outer, inner = s.outer.vertices, s.inner.vertices
    placed = [
        sweeps.place_generatrix(s, place).rings for place in sweeps.choose_telling_positions(s)
    ]
    unswept = [loop.vertices for loop in s.unswept]
    shapes = [
        Shape([outer, inner, *unswept], style.SWEPT),
        Shape(list(s.directrix.rings), style.DIRECTRIX),
        Shape([undercut.polygon.vertices for undercut in s.undercuts], style.UNDERCUT),
        Shape([outer], style.OUTER),
        Shape([inner, *unswept], style.INNER),
        *(Shape(list(rings), style.GENERATRIX) for rings in placed),
        Shape([sweeps.trace_anchor(s).vertices], style.TRAJECTORY),
        *_fit_shapes(s.exact_fits, s),
    ]
    title = f"{s.kind} sweep of {len(s.generatrix)} around {len(s.directrix)} vertices"
    return write_svg(shapes, title)


def _fit_shapes(fits: Iterable[Fit], s: sweeps.Moving) -> list[Shape]:
    segments, points = sweeps.split_fits(fits)
    lines = [sweeps.move_to_anchor(fit, s) for fit in segments]
    # A line of length 0 with round ends appears as a dot.
    dots = [sweeps.move_to_anchor((p, p), s) for p in points]
    return [
        Shape(lines, style.EXACT_FIT, closed=False),
        Shape(dots, replace(style.POINT_FIT, width=8), closed=False),
    ]


def draw_positions(found: NoFitAnswer | InnerFitAnswer) -> str:
    shown = Positions.of(found)
    by = sweeps.find_shift(shown)
    exterior = () if shown.exterior is None else shown.exterior.translated(by).rings
    shapes = [
        Shape(list(shown.directrix.rings), style.DIRECTRIX),
        *(Shape(list(other.rings), style.GENERATRIX) for other in shown.placed),
        *(Shape(list(region.translated(by).rings), style.FREE) for region in shown.free),
        Shape(list(exterior), style.TRAJECTORY),
        *(
            Shape(list(sweeps.place_generatrix(shown, place).rings), style.GENERATRIX)
            for place in shown.choose_positions()
        ),
        *_fit_shapes(shown.exact_fits, shown),
    ]
    g, d = len(shown.generatrix), len(shown.directrix)
    words = "inner fit of {} in {} vertices", "no-fit polygon of {} around {} vertices"
    title = words[shown.exterior is not None].format(g, d)
    return write_svg(shapes, title)


def show_positions(found: NoFitAnswer | InnerFitAnswer) -> str:
    """Write a picture and a table of sizes as HTML."""
    shown = Positions.of(found)
    fixed, moving, _ = (name.split()[0] for name in shown.names)
    rows = [
        ("reference", write_pair(found.reference)),
        (fixed, write_size(len(shown.directrix), shown.directrix.area)),
        (moving, write_size(len(shown.generatrix), shown.generatrix.area)),
    ]
    if isinstance(found, NoFitAnswer):
        exterior = write_size(len(found.exterior), found.exterior.area)
        rows = [("class", CLASSES[found.kind]), *rows, ("exterior", exterior)]
        rows.append(("holes", str(len(found.holes))))
    else:
        rows.append(("regions", str(len(found.regions))))
    rows += [("exact fits", str(len(found.exact_fits))), ("area", abridge(found.area))]
    return add_table(draw_positions(found), rows)


def show_sweep(s: SweepAnswer) -> str:
    """Write a picture and a table of sizes as HTML."""
    rows = [
        ("class", CLASSES[s.kind]),
        ("direction", "no shared direction" if s.direction is None else write_pair(s.direction)),
        ("reference", write_pair(s.reference)),
    ]
    loops = {
        "generatrix": s.generatrix,
        "directrix": s.directrix,
        "trajectory": s.trajectory,
        "inner loop": s.inner,
        "outer loop": s.outer,
    }
    rows += [(name, write_size(len(loop), loop.area)) for name, loop in loops.items()]
    rows += [(f"unswept {k}", write_size(len(loop), loop.area)) for k, loop in enumerate(s.unswept)]
    rows += [
        ("swept area", abridge(s.area)),
        ("undercuts", str(len(s.undercuts))),
        ("exact fits", str(len(s.exact_fits))),
    ]
    return add_table(draw_sweep(s), rows)
