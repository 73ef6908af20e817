"""A case of the corpus: a pair with its exact answers and flags."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Self, get_args

from exactsweep.corpus.answered import AnsweredPair, make_shape
from exactsweep.corpus.facts import find_flags
from exactsweep.geometry.frame import Kind
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.error import ExactSweepError, explain_type_errors
from exactsweep.numbers.number import Loop
from exactsweep.sweep import inner_fit_polygon, sweep

KINDS: tuple[Kind, ...] = get_args(Kind)
Given = AnyPolygon | Iterable[Iterable[object]]


class CaseError(ExactSweepError):
    """An invalid case; the message states where."""


@dataclass(frozen=True, kw_only=True)
class Case(AnsweredPair):
    """A named pair of polygons with the exact answers; HOW-TO-READ.md describes all fields."""

    id: str  # its meaning never changes
    title: str
    flags: tuple[str, ...] = ()  # its special properties, sorted; `notes` explains them
    note: str = ""  # its origin
    version: int = 1  # the first version of the corpus with the case

    @classmethod
    @explain_type_errors
    def of(
        cls,
        id: str,
        title: str,
        directrix: Given,
        generatrix: Given,
        reference: Iterable[object] = (0, 0),
        flags: Iterable[str] = (),
        *,
        directrix_holes: Iterable[Given] = (),
        generatrix_holes: Iterable[Given] = (),
        inner_fit: bool = False,
        note: str = "",
    ) -> Self:
        """Make a case by sweeping the pair.

        Args:
            id: the name of the case.
            title: a description in one line.
            directrix: D, a Polygon, a Region or vertices as for `Polygon`, which are kept.
            generatrix: G, in any of these forms.
            reference: the reference point of G.
            flags: flags besides the results of `find_flags`.
            directrix_holes: the holes of D, unless it is a Region.
            generatrix_holes: the holes of G, unless it is a Region.
            inner_fit: whether to compute the positions of G inside D for any class.
            note: the origin of the case.

        Raises:
            ValueError: `sweep` rejects the pair.

        Example:
            >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
            >>> case = Case.of("mine-1", "a square around itself", square, square)
            >>> case.kind, case.area, case.integer_scale, sorted(case.representable)
            ('CC', Fraction(8, 1), 1, ['binary64', 'int32', 'int64'])
            >>> plate = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(2, 2), (4, 2), (4, 4), (2, 4)]])
            >>> case = Case.of("mine-2", "a square in a plate", plate, square)
            >>> case.kind, len(case.holes), len(case.inner_regions)
            ('SS', 1, 1)
        """
        d, g = (
            read_given_rings(directrix, directrix_holes),
            read_given_rings(generatrix, generatrix_holes),
        )
        s = sweep(make_shape(g), make_shape(d), reference=reference)
        inside = None
        if inner_fit or s.kind == "SS":
            inside = inner_fit_polygon(make_shape(d), make_shape(g), reference=reference)
        case = cls(
            id=id,
            title=title,
            directrix_ring=d[0],
            generatrix_ring=g[0],
            directrix_holes=d[1:],
            generatrix_holes=g[1:],
            reference=s.reference,
            kind=s.kind,
            trajectory=s.trajectory,
            inner=s.inner,
            outer=s.outer,
            unswept=s.unswept,
            exact_fits=s.exact_fits,
            area=s.area,
            holes=s.no_fit_holes,
            inner_regions=None if inside is None else inside.regions,
            inner_exact_fits=() if inside is None else inside.exact_fits,
            note=note,
        )
        return replace(case, flags=tuple(sorted({*flags, *find_flags(case)})))


def read_given_rings(shape: Given, holes: Iterable[Given] = ()) -> tuple[Loop, ...]:
    if isinstance(shape, Region):
        return shape.rings
    return (read_given_ring(shape), *map(read_given_ring, holes))


def read_given_ring(vertices: Given) -> Loop:
    """Read vertices as given, but drop a last one that repeats the first."""
    if isinstance(vertices, (Polygon, Region)):
        return vertices.vertices
    ring = tuple(read_point(pair, f"vertex {i}") for i, pair in enumerate(vertices))
    return ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring
