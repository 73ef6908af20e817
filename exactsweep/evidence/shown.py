"""Answers as values: equality by question, certificates, and pictures."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Display(NamedTuple):
    """The functions that show answers of one kind.

    Attributes:
        plot: draws an answer on matplotlib Axes.
        draw: writes its picture as SVG.
        show: writes the picture and a table as HTML.
    """

    plot: Callable[..., Axes]
    draw: Callable[[Any], str]
    show: Callable[[Any], str]


class Shown:
    """An answer. Two answers are equal if they answer the same question about equal polygons.

    Polygons are equal as sets of points. The order of their vertices in the input does not matter
    here, though the numbers of features depend on it.
    """

    asked: ClassVar[tuple[str, ...]]
    """The names of the attributes that define the question."""
    _display: ClassVar[Callable[[], Display]]
    """Loads the Display of such an answer, from a higher package; `exactsweep.sweep` sets it."""

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self.asked)

    def __hash__(self) -> int:
        return hash(tuple(getattr(self, name) for name in self.asked))

    def certificate(self) -> dict[str, Any]:
        """Return plain JSON data that proves the answer, as `check/CERTIFICATES.md` describes it.

        `check/standalone.py`, one file, checks it. Positions are those of the origin of the polygon
        that moves.

        Raises:
            PolygonError: shapes are placed; certificates do not cover them.

        Cost: see `evidence.proof.add_proof`.

        Example:
            >>> from exactsweep import no_fit_polygon
            >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
            >>> no_fit_polygon(square, square).certificate()["exterior"]
            [['-1', '-1'], ['1', '-1'], ['1', '1'], ['-1', '1']]
        """
        from exactsweep.evidence.proof import add_proof

        return add_proof(self._claim())

    @abstractmethod
    def _claim(self) -> dict[str, Any]:
        """Return the claim that a certificate proves."""

    def plot(
        self,
        axes: Axes | None = None,
        *,
        positions: Iterable[Iterable[object]] | None = None,
        y_down: bool = False,
    ) -> Axes:
        """Draw the answer with matplotlib, the `plot` extra.

        The arguments are those of `exactsweep.draw.plot_sweep`, or of `plot_positions` for a no-fit
        polygon and an inner fit.
        """
        return type(self)._display().plot(self, axes, positions=positions, y_down=y_down)

    def _repr_svg_(self) -> str:
        return type(self)._display().draw(self)

    def _repr_html_(self) -> str:
        return type(self)._display().show(self)
