"""Enlarged details below a picture, for tiny polygons and flat pictures."""

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from string import ascii_lowercase
from typing import NamedTuple, Self

from exactsweep.canvas.scale import Scale
from exactsweep.draw.picture import Picture
from exactsweep.geometry.region import AnyPolygon
from exactsweep.numbers.number import Point, Vertex

# Ratios of picture size and polygon size that call for a detail, up to the resolution of floats.
_SMALL = range(25, 10**9)
_MAX_DETAILS = 3
# Relative to the picture's width: the width of a detail, and the horizontal and vertical spacing.
_WIDTH, _SPACING, _BELOW = 0.3, 0.35, 0.18
# The size of a detail relative to that of the small polygon.
_ENLARGED = Fraction(5, 2)


class Detail(NamedTuple):
    """An enlarged square of the plane: its lower left corner and side length."""

    left: Fraction
    bottom: Fraction
    side: Fraction

    @classmethod
    def around(cls, center: Vertex, side: Fraction) -> Self:
        x, y = center
        return cls(x - side / 2, y - side / 2, side)

    @property
    def corners(self) -> tuple[Point, Point]:
        left, bottom, side = self
        return Point(left, bottom), Point(left + side, bottom + side)

    def is_near(self, other: Self) -> bool:
        """Decide whether two details mostly overlap."""
        reach = self.side / 2
        return abs(self.left - other.left) < reach and abs(self.bottom - other.bottom) < reach


def find_details(
    shown: Iterable[Vertex],
    directrix: AnyPolygon,
    placed: Sequence[AnyPolygon],
    spots: Iterable[Vertex],
) -> list[Detail]:
    """Choose up to three details: shapes under 1/25 of the picture's size, or else spots."""
    corners = list(shown)
    boxes = [(min(values), max(values)) for values in zip(*corners, strict=True)]
    sides = [Fraction(high - low) for low, high in boxes]
    whole = max(sides)
    found: list[Detail] = []
    for shapes in ([directrix], placed):
        small = max(map(_longest, shapes))
        if int(whole / small) in _SMALL:
            found += [Detail.around(_middle(shape), _ENLARGED * small) for shape in shapes]
    if not found and not Scale.of(corners).is_true and int(whole / min(sides)) in _SMALL:
        middle = Point(*((low + high) / Fraction(2) for low, high in boxes))
        short = sides.index(min(sides))
        for x, y in spots:
            center = (x, middle.y) if short else (middle.x, y)
            found.append(Detail.around(center, min(sides)))
    chosen: list[Detail] = []
    for detail in found:
        if len(chosen) < _MAX_DETAILS and not any(map(detail.is_near, chosen)):
            chosen.append(detail)
    return chosen


def _longest(shape: AnyPolygon) -> Fraction:
    low, high = shape.bounding_box
    return max(high.x - low.x, high.y - low.y)


def _middle(shape: AnyPolygon) -> Point:
    low, high = shape.bounding_box
    return Point((low.x + high.x) / 2, (low.y + high.y) / 2)


def draw_with_details(
    picture: Picture, details: Sequence[Detail], paint: Callable[[Picture], None]
) -> None:
    """Draw a picture with its legend and frames around the details, and the details below it."""
    paint(picture)
    for k, detail in enumerate(details):
        low, high = detail.corners
        # Convert a share of the width to a share of the height.
        height = picture.aspect
        axes = picture.axes.inset_axes(
            (k * _SPACING, -(_BELOW + _WIDTH) / height, _WIDTH, _WIDTH / height)
        )
        scale = Scale.of([low, high])
        enlarged = Picture(axes, scale, y_down=picture.y_down, window=(low, high))
        paint(enlarged)
        enlarged.show_window()
        (left, bottom), (right, top) = picture.scale.place(low), picture.scale.place(high)
        picture.axes.indicate_inset((left, bottom, right - left, top - bottom), edgecolor="black")
        name = ascii_lowercase[k]
        picture.text(low if picture.y_down else (low.x, high.y), name)
        axes.set_title(f"{name}, to scale", fontsize="small")
    if details:
        picture.reserve(_BELOW + _WIDTH)
    picture.legend()
