"""Drawing of figures: `drawings.toml` lists what to draw, the figure's module computes the shapes.

A panel is a list of instructions: a method of `PanelDrawer` and its arguments. A shape is a name,
such as "outer", "outer.3" for its vertex 3, or "outer/3" for the middle of its edge 3; or it is a
literal point or chain. In panel a, the shape "a_name" overrides "name". "=name" stands for
words that the module computes. A look is an entry of `looks`, or a name of the style.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import chain, pairwise, repeat
from typing import TYPE_CHECKING, Any

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.draw import Picture
from exactsweep.numbers.number import Vertex
from exactsweep.paper.figures.figure import PaperFigure, find_middle
from exactsweep.paper.figures.sheet import FONT, Extent, lay_out
from exactsweep.paper.toml import read_toml

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SMALL = 8.0
_LEADER = {"arrowstyle": "-", "linewidth": 0.6, "shrinkA": 1, "shrinkB": 0, "color": "black"}
_ARROW = {"mutation_scale": 7, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0}


@cache
def _load() -> dict[str, Any]:
    return read_toml("figures/drawings.toml")


def find_look(name: str) -> Look:
    """Find a look by name, in drawings.toml or in the style."""
    if name not in _load()["looks"]:
        found: Look = getattr(style, name)
        return found
    changes = dict(_load()["looks"][name])
    like = find_look(changes.pop("like")) if "like" in changes else Look(style.BLACK)
    for part in changes.keys() & {"color", "fill"}:
        name, _, opacity = changes[part].partition(" ")
        changes[part] = getattr(style, name, name) + opacity
    if isinstance(changes.get("dash"), list):
        changes["dash"] = (0, tuple(changes["dash"]))
    return replace(like, **changes)


def draw_figure(name: str, figure: PaperFigure) -> Figure:
    """Draw a figure by its entry in drawings.toml; raise DrawError if matplotlib is missing."""
    plan = _load()[name]
    panels = [
        PanelDrawer(
            entry.get("letter", letter), figure, [*plan.get("each", ()), *entry.get("draw", ())]
        )
        for letter, entry in zip("abcd", plan["panel"], strict=False)
    ]
    boxes = map(PanelDrawer.frame, panels, plan["panel"])
    rows = [[next(boxes) for _ in range(count)] for count in plan["rows"]]
    with style.use_style():
        made, pictures = lay_out(rows, plan["inches"])
        for panel, entry, picture in zip(panels, plan["panel"], pictures, strict=True):
            panel.draw(picture)
            for artist in picture.axes.get_children():
                artist.set_clip_on(entry.get("cut", False))
    return made


class PanelDrawer:
    """A panel of a figure; its methods are the instructions."""

    picture: Picture

    def __init__(
        self, letter: str, figure: PaperFigure, instructions: Sequence[Sequence[Any]]
    ) -> None:
        self.letter = letter
        self.shapes = figure.list_shapes()
        self.words = figure.words
        self.instructions = instructions

    def frame(self, entry: Mapping[str, Any]) -> Extent:
        """Return the extent of the panel, with title and margins."""
        points = chain.from_iterable(map(self._points, entry["around"]))
        (title,) = self._words(entry.get("title", ""))
        return Extent.around(points, title, entry.get("margins", (4, 4, 4, 4)))

    def draw(self, picture: Picture) -> None:
        self.picture = picture
        for kind, *arguments in self.instructions:
            getattr(self, kind)(*arguments)

    def area(self, what: Any, look: str) -> None:
        for loop in self._chains(what):
            self.picture.area(loop, find_look(look))

    def ring(self, outer: Any, inner: Any, look: str) -> None:
        self.picture.ring(self._find(outer), self._find(inner), find_look(look))

    def line(self, what: Any, look: str) -> None:
        for points in self._chains(what):
            self.picture.line(points, find_look(look))

    def loop(self, what: Any, look: str) -> None:
        for points in self._chains(what):
            self.picture.line(points, find_look(look), closed=True)

    def dots(self, what: Any, look: str = "DOT") -> None:
        self.picture.lines([[point] for point in self._points(what)], find_look(look))

    def arrow(self, what: Any, look: str = "TRAJECTORY", head: str = "-|>") -> None:
        color, dash = find_look(look).color, find_look(look).dash
        for ends in self._chains(what):
            start, end = self.picture.scale.places(ends)
            self.picture.axes.annotate(
                "",
                end,
                start,
                arrowprops={**_ARROW, "arrowstyle": head, "color": color, "linestyle": dash},
                zorder=10,
                annotation_clip=False,
            )

    def label(
        self,
        at: Any,
        words: str,
        dx: float | str = 0,
        dy: float = 0,
        how: Mapping[str, Any] | None = None,
    ) -> None:
        """Write words next to one or more points; "=name" stands for computed words.

        `dx` and `dy` are offsets to the right and upward, or `dx` names a shape with vectors. `how`
        has "ha" and "va" for the alignment, "leader" for a line to the point, and "small".
        """
        from matplotlib.patheffects import withStroke

        how = how or {}
        texts = self._words(words) if words.startswith("=") else repeat(words)
        moves = self._points(dx) if isinstance(dx, str) else repeat((dx, dy))
        for place, text, (right, up) in zip(self._points(at), texts, moves, strict=False):
            written = self.picture.axes.annotate(
                text,
                self.picture.scale.place(place),
                (float(right), float(up)),
                textcoords="offset points",
                ha=how.get("ha", "center"),
                va=how.get("va", "center"),
                fontsize=SMALL if how.get("small") else FONT,
                zorder=12,
                arrowprops=_LEADER if how.get("leader") else None,
                annotation_clip=False,
            )
            written.set_path_effects([withStroke(linewidth=2.2, foreground="white")])

    def _words(self, words: str) -> Sequence[str]:
        return self._named(self.words, words[1:]) if words.startswith("=") else [words]

    def _find(self, what: Any) -> Any:
        if isinstance(what, list):
            is_chain = any(isinstance(one, list) or str(one)[0].isalpha() for one in what)
            return [self._find(one) for one in what] if is_chain else tuple(map(Fraction, what))
        path, _, edge = what.partition("/")
        name, *numbers = path.split(".")
        found = self._named(self.shapes, name)
        for number in numbers:
            found = found[int(number)]
        return find_middle(*list(pairwise(found))[int(edge)]) if edge else found

    def _named(self, values: Mapping[str, Sequence[Any]], name: str) -> Any:
        own = f"{self.letter}_{name}"
        return values[own if own in values else name]

    def _chains(self, what: Any) -> Sequence[Sequence[Vertex]]:
        found = self._find(what)
        if found and not isinstance(found[0], (tuple, list)):
            return [[found]]
        return [found] if found and not isinstance(found[0][0], (tuple, list)) else found

    def _points(self, what: Any) -> list[Vertex]:
        return list(chain.from_iterable(self._chains(what)))
