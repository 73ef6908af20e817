"""The exact judge of layouts.

In a valid layout, all parts are simple; every placed part lies in the closed container; interiors
are disjoint; any two parts are at least the spacing apart; every part is at least the margin away
from the boundary of the container and the defects; and demand, rotations and reflections obey the
rules. The verdict holds for the true curves: parts are separate if their gap is at least the
spacing plus the errors of both, and overlap if some point is deeper in each than its error;
otherwise the pair is undecided.
"""

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from functools import cached_property, partial
from typing import Any, get_args

from exactsweep.geometry.overlap import Relation
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import TURN_BITS
from exactsweep.layout.board import Board
from exactsweep.layout.certificate import write_certificate
from exactsweep.layout.fault import Fault, FaultKind
from exactsweep.layout.layout import Layout
from exactsweep.layout.nearest import NearestPair, find_nearest_pair
from exactsweep.layout.rounded import bound_area
from exactsweep.layout.verdict import PairVerdict, judge_pair
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Point
from exactsweep.words import count


class Judgement:
    """The faults and measures of a layout; see `judge_layout`.

    Attributes:
        faults: tuple of Fault, by kind in the order of `FaultKind`, then by placement.
        contacts: pairs of placements whose parts touch without overlap, sorted.
    """

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self._board = Board(layout)
        contacts: list[tuple[int, int]] = []
        faults = [
            *_judge_pairs(self._board, contacts),
            *_judge_container(self._board),
            *_judge_rules(layout),
        ]
        order = get_args(FaultKind)
        self.faults = tuple(sorted(faults, key=lambda f: (order.index(f.kind), f.placements)))
        self.contacts = tuple(sorted(contacts))

    def certificate(self) -> dict[str, Any]:
        """Return plain JSON data that proves the verdict; see `check/CERTIFICATES.md`.

        Raises:
            LayoutError: no fault has a proof; see `write_certificate`.
        """
        return write_certificate(self._board, self.faults)

    @property
    def valid(self) -> bool:
        """Whether there are no faults and no undecided pairs."""
        return not self.faults

    @property
    def density(self) -> Fraction | None:
        """The total area of the placed simple parts, relative to the container or else the `box`.

        It is None if nothing is placed or rounded pieces of a part overlap. The error is at most
        `density_error`.
        """
        return None if self._density is None else sum(self._density, Fraction(0)) / 2

    @property
    def density_error(self) -> Fraction:
        """A bound on the error of `density`; 0 if nothing is rounded."""
        return Fraction(0) if self._density is None else (self._density[1] - self._density[0]) / 2

    @cached_property
    def _density(self) -> tuple[Fraction, Fraction] | None:
        parts, container, box = self.layout.part_by_id, self.layout.container, self.box
        areas = Counter(self.layout.placements[k].part for k in self._board.placed)
        found = [(number, bound_area(parts[id].shape)) for id, number in areas.items()]
        if any(bounds is None for _, bounds in found):
            return None
        least, most = (
            add_up(number * bounds[end] for number, bounds in found if bounds) for end in (0, 1)
        )
        if container is not None:
            shape = container if isinstance(container, Region) else (container,)
            whole = bound_area(shape)
        else:
            whole = box and ((box[1].x - box[0].x) * (box[1].y - box[0].y),) * 2
        return whole and (least / whole[1], most / whole[0])

    @cached_property
    def box(self) -> tuple[Point, Point] | None:
        """The lower left and upper right corners of the bounding box of all placed parts.

        It is None if nothing is placed. The error of each side is at most `box_error`.
        """
        boxes = [(solid.box, solid.scale) for solid in map(self._board.solid, self._board.placed)]
        if not boxes:
            return None
        sides = [[Fraction(side) / scale for side in box] for box, scale in boxes]
        left, right, low, high = zip(*sides, strict=True)
        return Point(min(left), min(low)), Point(max(right), max(high))

    @property
    def box_error(self) -> Fraction:
        """A bound on the error of each side of the `box`; 0 if rotations and shapes are exact."""
        slacks = (self._board.solid(k).slack for k in self._board.placed)
        return max(slacks, default=Fraction(0))

    @cached_property
    def distance(self) -> NearestPair | None:
        """The nearest pair of placed parts; None for fewer than two.

        Parts that overlap or touch have distance 0. Irrational rotations and flattened curves cause
        errors; see `Layout.greatest_error`.
        """
        for fault in self.faults:
            if fault.kind == "overlap":
                k, j = fault.placements
                return NearestPair(Fraction(0), (k, j), fault.points)
        return find_nearest_pair(self._board, next(iter(self.contacts), None))

    def __repr__(self) -> str:
        what = ", ".join(f"{n} {kind}" for kind, n in Counter(f.kind for f in self.faults).items())
        return (
            f"<Judgement of {count(len(self.layout.placements), 'placement')}: {what or 'valid'}>"
        )


@explain_type_errors
def judge_layout(layout: Layout) -> Judgement:
    """Judge a layout exactly.

    Cost: O(n log n) for n placements and defects, plus `meet` for each pair whose boxes are nearer
    than the spacing.

    >>> square = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
    >>> layout = Layout.from_json({
    ...     "container": {"exterior": [["0", "0"], ["2", "0"], ["2", "1"], ["0", "1"]]},
    ...     "parts": [{"id": "tile", "exterior": square}],
    ...     "placements": [
    ...         {"part": "tile", "turn": "0", "move": ["0", "0"]},
    ...         {"part": "tile", "turn": "0", "move": ["0.9", "0"]},
    ...     ],
    ... })
    >>> judgement = judge_layout(layout)
    >>> judgement.valid, judgement.density
    (False, Fraction(1, 1))
    >>> (fault,) = judgement.faults
    >>> print(fault, fault.move)
    placements 0 and 1 overlap at (19/20,1/2) (1/10, 0)
    """
    return Judgement(layout)


def _judge_pairs(board: Board, contacts: list[tuple[int, int]]) -> Iterator[Fault]:
    spacing, solid = board.layout.spacing, board.solid
    for k, j in board.list_near(spacing):
        found = judge_pair(lambda bits: (solid(k, bits), solid(j, bits)), TURN_BITS, spacing)  # noqa: B023
        if found.meeting is Relation.CONTACT:
            contacts.append((k, j))
        if found.meeting is not Relation.APART or found.too_close is not False:
            yield from _name_faults(board, (k, j), found, "overlap")


def _judge_container(board: Board) -> Iterator[Fault]:
    """Yield the worst fault of each placement with the outside and the defects."""
    solid = board.solid
    for k, walls in board.list_obstacles():
        worst: list[tuple[Fraction, Fault]] = []
        for wall in walls:
            fixed = board.obstacles[wall]
            required = board.required(wall)
            found = judge_pair(lambda bits: (solid(k, bits), fixed), TURN_BITS, required)  # noqa: B023
            faults = _name_faults(board, (k,), found, "outside", wall)
            rank = Fraction(-1) if found.gap is None else found.gap.value
            worst += ((rank, fault) for fault in faults)
        if worst:
            yield min(worst, key=lambda found: found[0])[1]


def _name_faults(
    board: Board, placements: tuple[int, ...], found: PairVerdict, kind: FaultKind, wall: int = 0
) -> Iterator[Fault]:
    fault = partial(
        Fault,
        placements=placements,
        bound=found.slack,
        error=found.error,
        _board=board,
        _bits=found.bits,
        wall=wall,
    )
    if found.meeting is None or found.too_close is None:
        what = "overlap" if found.meeting is None else "distance"
        why = " (flattened curves)" if found.error else ""
        reason = f"the {what} is undecided within {abridge(found.slack)}{why}"
        yield fault(kind="undecided", reason=reason)
    elif found.meeting is Relation.OVERLAP:
        yield fault(kind=kind)
    elif found.too_close:
        assert found.gap is not None
        square, points = found.gap
        yield fault(kind="too close", distance_squared=square, _nearest=points)


def _judge_rules(layout: Layout) -> Iterator[Fault]:
    placements: dict[str, list[int]] = {part.id: [] for part in layout.parts}
    for k, placement in enumerate(layout.placements):
        placements[placement.part].append(k)
        part = layout.part_by_id[placement.part]
        if not part.allows(placement):
            kind_of_turn = "mirrored rotation" if placement.mirrored else "rotation"
            reason = f"part {part.id} forbids {kind_of_turn} by {placement.turn}"
            yield Fault("turn", (k,), part.id, reason)
        if part.mirrored is False and placement.mirrored:
            yield Fault("mirror", (k,), part.id, f"part {part.id} forbids mirroring")
    for part in layout.parts:
        its = tuple(placements[part.id])
        if part.shape is None:
            yield Fault("shape", its, part.id, part.refusal)
        if part.demand is not None and len(its) != part.demand:
            kind: FaultKind = "missing" if len(its) < part.demand else "surplus"
            yield Fault(kind, its, part.id, number=abs(part.demand - len(its)))
