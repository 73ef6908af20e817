"""Figures 1, 2, 3 and 8: one pair, its Minkowski sum, chains and boundaries, and I(G)."""

from fractions import Fraction
from itertools import pairwise

from exactsweep.check import classify
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Point
from exactsweep.paper.figures.figure import (
    PaperFigure,
    find_middle,
    join_panels,
    place,
    shift,
    take_half,
)
from exactsweep.paper.functions import (
    clip_to,
    explain_unproved,
    frame_around,
    keep_corners,
    sample_between,
    take_bottom,
)
from exactsweep.paper.kernel import find_inner, find_trajectory, sweep_mm
from exactsweep.procedures.chain import split
from exactsweep.sweep import Sweep, inner_fit_polygon, no_fit_polygon, sweep

GENERATRIX = [(0, 0), (2, 1), (4, 0), (3, 3), (1, 3)]
DIRECTRIX = [(0, 5), (4, 0), (8, 4), (12, -1), (20, 5), (17, 10), (11, 6), (8, 11), (3, 9)]
# Positions of G in panel (b), with the reference point on two vertices and two edges of D.
ALONG = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 5), (12, -1), (16, 2), (11, 6)]]


def sweep_example() -> Sweep:
    return sweep(GENERATRIX, DIRECTRIX, reference=(2, 1))


def invert_generatrix(s: Sweep) -> Polygon:
    """Return I(G), with its reference point at the origin."""
    return s.generatrix.exterior.translated((-s.reference.x, -s.reference.y)).reflected()


def compute_minkowski() -> PaperFigure:
    # The sum of D and G is the no-fit polygon of D and I(G). The sum of D's boundary and G excludes
    # the points p such that p + I(G) lies in the interior of D.
    s = sweep_example()
    inverted = invert_generatrix(s)
    around = no_fit_polygon(s.directrix, inverted)
    inside = inner_fit_polygon(s.directrix, inverted)
    outer = around.exterior.vertices
    holes = [region.exterior.vertices for region in inside.regions]
    met = [classify(s.directrix, ring, (0, 0)).verdict for ring in place(s, ALONG)]
    # G is drawn at a corner, and where it closes the upper undercut.
    positions = [s.trajectory.vertices[6], s.undercuts[-1].positions[0]]
    return PaperFigure(
        facts=[
            ("class of the sweep", s.kind),
            ("edges of the trajectory", len(s.trajectory)),
            ("edges of the inner and the outer loop", f"{len(s.inner)}, {len(s.outer)}"),
            ("undercuts", len(s.undercuts)),
            ("positions in (b) at which G overlaps D", f"{met.count('OVERLAP')} of {len(met)}"),
            ("holes of the sum", len(holes)),
        ],
        laws=[
            ("boundary of the sum", explain_unproved(around), ""),
            ("holes of the sum", explain_unproved(inside), ""),
        ],
        shapes={"sum": outer, "holes": holes, "positions": positions}
        | {"b_positions": ALONG, "b_placed": place(s, ALONG)},
        sweeps=[(s, positions)],
    )


def compute_boundaries() -> PaperFigure:
    s = sweep_example()
    half = take_half(s)
    # By definition, the inner boundary is part of the top chain of the area covered in the lower
    # sweep, which extends beyond both ends of D.
    top, path = find_inner(half), find_trajectory(half)
    inner, outer = sweep_mm(*half)
    start, stop = (Point(x + s.reference.x, y + s.reference.y) for x, y in (path[0], path[-1]))
    distance = stop.x - start.x
    widths = sum(p.bounding_box[1].x - p.bounding_box[0].x for p in (s.generatrix, s.directrix))
    low = min(y for _, y in outer) - 3
    return PaperFigure(
        facts=[
            ("edges of the inner boundary", len(inner) - 1),
            ("edges of the outer boundary", len(outer) - 1),
            ("horizontal distance from start to stop", distance),
        ],
        laws=[
            ("inner boundary", clip_to(top, half.directrix), keep_corners(inner)),
            ("bottom of the outer loop", take_bottom(s.outer.vertices), keep_corners(outer)),
            ("horizontal distance", distance, widths),
            ("start", shift(half.top[:1], path[0]), half.directrix[:1]),
        ],
        shapes={"lower": outer, "upper": inner, "path": shift(path, s.reference)}
        | {"swept": [*outer, *reversed(top)], "ends": [start, stop]}
        | {"distance": [(start.x, low), (stop.x, low)]},
        words={"widths": [f"{distance} = width of $G$ + width of $D$"]},
        sweeps=[(s, [start, stop])],
    )


def compute_inverses() -> PaperFigure:
    s = sweep_example()
    inverted = invert_generatrix(s)
    outside = no_fit_polygon(s.trajectory, inverted).exterior
    # I(G) is drawn at these vertices of the loop that it retraces.
    places = {
        "a": [s.inner.vertices[k] for k in (0, 2, 4, 7)],
        "b": [s.outer.vertices[k] for k in (0, 4, 12, 20)],
    }
    turned = {
        letter: [shift(inverted.vertices, p) for p in found] for letter, found in places.items()
    }
    beyond = frame_around(s.trajectory, inverted)
    inside = [classify(beyond, inverted, p).verdict for p in s.inner.vertices]
    whole = PaperFigure(
        facts=[
            ("edges of the trajectory", len(s.trajectory)),
            ("edges of the inner loop, retraced inside", len(s.inner)),
            ("edges of the outer loop, retraced outside", len(s.outer)),
        ],
        laws=[
            ("the loop outside is the outer one", outside == s.outer, True),
            ("verdicts on I(G) and the exterior at the inner vertices", {*inside}, {"CONTACT"}),
        ],
        shapes={"widest": turned["b"]},
        sweeps=[(s, [])],
    )
    drawn = {k: PaperFigure(shapes={"places": places[k], "turned": turned[k]}) for k in "ab"}
    return join_panels({"": whole} | drawn)


# D of Figure 1, and G of Figure 1 at twice its size.
POLYGONS = {"D": DIRECTRIX, "G": [(2 * x, 2 * y) for x, y in GENERATRIX]}


def compute_chains() -> PaperFigure:
    return join_panels({letter: _show_chains(letter, ring) for letter, ring in POLYGONS.items()})


def _show_chains(letter: str, ring: Ring) -> PaperFigure:
    corners = Polygon(ring).vertices
    bottom, top = chains = split(corners)
    laws: list[tuple[str, object, object]] = [
        (f"vertices of {letter}", {*bottom, *top}, set(corners))
    ]
    for x in sample_between(corners):
        met = [
            sum(min(p[0], q[0]) < x < max(p[0], q[0]) for p, q in pairwise(chain))
            for chain in chains
        ]
        laws.append((f"edges of {letter}'s chains over x = {x}", met, [1, 1]))
    # Arrow heads at the midpoints of the edges, which run counter-clockwise.
    b_heads, t_heads = (
        [(find_middle(*e), find_middle(*e, share=Fraction(5, 8))) for e in pairwise(chain)]
        for chain in chains
    )
    return PaperFigure(
        facts=[(f"edges of {letter}_b", len(bottom) - 1), (f"edges of {letter}_t", len(top) - 1)],
        laws=laws,
        shapes={"ring": ring, "b": bottom, "t": top, "b_heads": b_heads, "t_heads": t_heads},
    )
