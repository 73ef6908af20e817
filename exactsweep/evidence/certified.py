"""Answers as values: equality by question, and certificates."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any, ClassVar


def refuse_to_set(answer: object, name: str, value: object) -> None:
    """Raise AttributeError, because answers cache their results.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> sweep(square, square).reference = (1, 1)
        Traceback (most recent call last):
        AttributeError: an answer is read-only: reference cannot be set; compute a new one
    """
    raise AttributeError(f"an answer is read-only: {name} cannot be set; compute a new one")


class Certified:
    """An answer; answers are equal if they answer the same question about equal polygons.

    Polygons are equal if they are the same set of points, even if their features have different
    numbers.
    """

    asked: ClassVar[tuple[str, ...]]
    """The names of the attributes that define the question."""

    __setattr__ = refuse_to_set

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self.asked)

    def __hash__(self) -> int:
        return hash(tuple(getattr(self, name) for name in self.asked))

    def certificate(self) -> dict[str, Any]:
        """Return plain JSON data that proves the answer to `check/standalone.py`.

        `check/CERTIFICATES.md` describes the format. Positions refer to the moving polygon's
        origin. Raises PolygonError for placed or attached shapes and for a NoFitUnion. Cost: as
        for `evidence.proof.add_proof`.

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
