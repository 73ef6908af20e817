"""Explanation of a sweep in words, step by step."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import Half, Landmark, Step, Touch, explain
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.geometry.outline import Outline, number_features
from exactsweep.geometry.region import AnyPolygon
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.number import Point
from exactsweep.words import CLASSES, count, name_heading, write_pair

_HALVES: dict[Half, str] = {
    "lower": "Below D: the lower sweep (G_t, D_b)",
    "right": "The right end",
    "upper": "Above D: the upper sweep (G_b, D_t)",
    "left": "The left end",
}


def describe_steps(s: SweepAnswer) -> Iterator[str]:
    """Explain a sweep; yield ASCII lines: the steps around D, the holes, and the exact fits.

    >>> from exactsweep import sweep
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> lines = list(describe_steps(sweep(square, [(0, 0), (3, 0), (0, 3)])))
    >>> print(*lines[7:9], sep=chr(10))
    Step 0: right, along (1,0), from (-1,-1) to (3,-1)
      EE: edge 2 of G, (1,1)-(0,1), slides along edge 0 of D, (0,0)-(3,0)
    """
    steps = explain(s)
    narrator = _Narrator(s)
    yield from narrator.opening(steps)
    half = None
    for k, step in enumerate(steps):
        if step.half != half and s.kind != "SS":
            half = step.half
            yield f"-- {_HALVES[half]} --"
            yield ""
        yield (
            f"Step {k}: {name_heading(step.direction)}, along {write_pair(step.direction)}, "
            f"from {write_pair(step.start)} to {write_pair(step.end)}"
        )
        for line in narrator.step(step, steps[(k + 1) % len(steps)]):
            yield f"  {line}"
        yield ""
    yield f"G is back at {write_pair(steps[0].start)}."
    yield from narrator.holes()
    yield from narrator.fits()


class _FeatureNames:
    """Names of the vertices and edges of a polygon, by input index."""

    def __init__(self, shape: AnyPolygon, letter: str) -> None:
        self.names: dict[str, dict[int, str]] = {"V": {}, "E": {}}
        self.corners, ends = number_features(shape)
        self.ends = {j: set(numbers) for j, numbers in ends.items()}
        self.reflex: set[int] = set()
        corners = shape.vertices
        outline = Outline(shape.rings)
        for k, (before, after) in enumerate(zip(outline.before, outline.after, strict=True)):
            i, j = shape.vertex_index(k), shape.edge_index(k)
            (px, py), (x, y), (qx, qy) = corners[before], corners[k], corners[after]
            start, end = write_pair((x, y)), write_pair((qx, qy))
            self.names["V"][i] = f"vertex {i} of {letter}, {start}"
            self.names["E"][j] = f"edge {j} of {letter}, {start}-{end}"
            if ((x - px) * (qy - y) < (y - py) * (qx - x)) == (k < len(shape.rings[0])):
                self.reflex.add(i)


class _Narrator:
    def __init__(self, s: SweepAnswer) -> None:
        self.sweep = s
        self.g = _FeatureNames(s.generatrix, "G")
        self.d = _FeatureNames(s.directrix, "D")

    def opening(self, steps: Sequence[Step]) -> Iterator[str]:
        s = self.sweep
        events = Counter(touch.contact.event for step in steps for touch in step.touches)
        endings = Counter(step.ending for step in steps)
        g, d = len(s.generatrix), len(s.directrix)
        yield f"Class {CLASSES[s.kind]}, with {g} and {d} vertices."
        yield (
            f"The generatrix G travels once around the directrix D in {len(steps)} steps, "
            "with D on its left."
        )
        yield (
            f"Positions are those of the reference point {write_pair(s.reference)} of G. "
            "Vertices and edges are numbered as in the input."
        )
        if s.kind == "SS":
            rest = count(len(s.no_fit_holes), "hole")
            reach = ", which G cannot reach by sliding" if s.no_fit_holes else ""
            yield f"Inside this path, the no-fit polygon has {rest}{reach}."
        elif s.direction and s.direction != (1, 0):
            yield (
                f"Both polygons are monotone in direction {write_pair(s.direction)}. "
                "The words below, above, left and right assume that this direction points right."
            )
        yield (
            f"Contacts: {', '.join(f'{events[e]} {e}' for e in ('EV', 'VE', 'EE') if events[e])}; "
            f"{count(endings['corner'], 'corner')}, {count(endings['stop'], 'stop')}; "
            f"{count(len(s.undercuts), 'undercut')}, {count(len(s.exact_fits), 'exact fit')}."
        )
        yield ""

    def step(self, step: Step, following: Step) -> Iterator[str]:
        for touch in step.touches:
            yield self._describe_touch(touch, step)
        for mark in step.landmarks:
            if mark.position != step.end:
                yield f"On the way, at {write_pair(mark.position)}, {self._describe_landmark(mark)}"
        yield f"{self._describe_ending(step)}; {self._describe_next(step, following)}"
        for mark in step.landmarks:
            if mark.position == step.end:
                yield f"Here {self._describe_landmark(mark)}"

    def holes(self) -> Iterator[str]:
        s = self.sweep
        loops = [hole.vertices for hole in s.no_fit_holes]
        for k, along in enumerate(s.contacts_along(loops)):
            loop = loops[k]
            yield ""
            yield (
                f"-- Hole {k} of the no-fit polygon, of area {abridge(s.no_fit_holes[k].area)}: "
                "G is free inside --"
            )
            for start, end, contacts in zip(loop, (*loop[1:], loop[0]), along, strict=True):
                way = name_heading((end.x - start.x, end.y - start.y))
                yield f"{way[0].upper()}{way[1:]}, from {write_pair(start)} to {write_pair(end)}"
                yield from (f"  {self._describe_slide(contact)}" for contact in contacts)

    def fits(self) -> Iterator[str]:
        s = self.sweep
        segments = iter(s.contacts_along([fit for fit in s.exact_fits if fit[0] != fit[1]]))
        for k, (start, end) in enumerate(s.exact_fits):
            yield ""
            if start == end:
                yield f"-- Exact fit {k}: G fits at {write_pair(start)} and cannot move --"
                for contact in self._drop_implied(s.contacts_at(start)):
                    g, d = self._name(contact)
                    yield f"  {contact.event}: {g}, is on {d}"
            else:
                way = name_heading((end.x - start.x, end.y - start.y))
                there = f"from {write_pair(start)} to {write_pair(end)}"
                yield f"-- Exact fit {k}: G could go {way}, {there} --"
                yield from (f"  {self._describe_slide(contact)}" for contact in next(segments)[0])

    def _name(self, contact: Contact) -> tuple[str, str]:
        event, i, j = contact
        return self.g.names[event[0]][i], self.d.names[event[1]][j]

    def _describe_slide(self, contact: Contact) -> str:
        mover, below = self._name(contact)
        how = "over" if contact.event == "EV" else "along"
        return f"{contact.event}: {mover}, slides {how} {below}"

    def _describe_touch(self, touch: Touch, step: Step) -> str:
        text = self._describe_slide(touch.contact)
        if touch.start != step.start:
            text += f", from {write_pair(touch.start)} on"
        if touch.end != step.end:
            text += f", until {write_pair(touch.end)}"
        return text

    def _describe_ending(self, step: Step) -> str:
        if step.ending == "corner":
            meetings = (", is on ".join(self._name(contact)) for contact in step.reasons)
            return f"Corner: {', and '.join(meetings)}"
        if step.ending == "stop":
            stops = (self._stop(contact, step.end) for contact in self._drop_implied(step.reasons))
            return f"Stop: {', and '.join(stops)}"
        return "Slot: nothing stops G, but straight ahead it would enter an exact fit"

    def _stop(self, contact: Contact, position: Point) -> str:
        event, i, j = contact
        g, d = self._name(contact)
        if event == "EE":
            return f"{g}, comes flush with {d}"
        if event == "VE":
            (x, y), (tx, ty), (rx, ry) = self.g.corners[i], position, self.sweep.reference
            return f"{g}, runs into {d}, at {write_pair((x + tx - rx, y + ty - ry))}"
        if event == "VV" and i in self.g.reflex:
            return f"{d}, enters the reflex corner at {g}"
        if event == "VV" and j in self.d.reflex:
            return f"{g}, enters the reflex corner at {d}"
        return f"{g}, runs into {d}"

    def _drop_implied(self, contacts: Iterable[Contact]) -> list[Contact]:
        """Drop contacts implied by an edge-edge contact."""
        contacts = list(contacts)
        implied: set[Contact] = set()
        for event, e, d in contacts:
            if event == "EE":
                implied.update(Contact("EV", e, j) for j in self.d.ends[d])
                implied.update(Contact("VE", i, d) for i in self.g.ends[e])
                implied.update(Contact("VV", i, j) for i in self.g.ends[e] for j in self.d.ends[d])
        return [contact for contact in contacts if contact not in implied]

    def _describe_next(self, step: Step, following: Step) -> str:
        names: dict[str, None] = {}
        for (event, i, j), start, _ in following.touches:
            if start == following.start:
                if event != "VE":
                    names[f"edge {i} of G"] = None
                if event != "EV":
                    names[f"edge {j} of D"] = None
        along = " and ".join(names)
        if step.ending == "corner":
            return f"G turns left, along {along}, the next by slope"
        return f"G turns right, along {along}"

    def _describe_landmark(self, landmark: Landmark) -> str:
        if landmark.mark == "exact fit":
            return self._exact_fit(landmark)
        undercut = self.sweep.undercuts[landmark.number]
        extremes = " and ".join(map(write_pair, undercut.extremes))
        name = f"undercut {landmark.number}, of area {abridge(undercut.polygon.area)},"
        if landmark.mark == "undercut":
            return f"G closes {name} by touching {extremes} at once"
        several = undercut.intersection == "point"
        if landmark.mark == "undercut opens":
            if several:
                return f"G begins to close {name} from {extremes}"
            return f"{name} closes: from here one edge of G slides over both {extremes}"
        if several:
            return f"G stops closing undercut {landmark.number}"
        return f"G leaves undercut {landmark.number}: its edge slides off"

    def _exact_fit(self, landmark: Landmark) -> str:
        hanging, inside = self.sweep.exact_fits[landmark.number]
        if hanging != landmark.position:
            hanging, inside = inside, hanging
        way = name_heading((inside.x - hanging.x, inside.y - hanging.y))
        return (
            f"exact fit {landmark.number} begins: G could go {way} to {write_pair(inside)}, "
            "touching D on both sides"
        )
