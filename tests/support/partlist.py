"""A part list as a sheet-metal shop has it: brackets, gussets, flanges, combs, washers' halves."""

from fractions import Fraction
from random import Random

from exactsweep.formats import NamedPolygon
from exactsweep.geometry.polygon import Polygon

Ring = list[tuple[Fraction, Fraction]]


def _outline(*numbers: object) -> Ring:
    values = [Fraction(str(number)) for number in numbers]
    return list(zip(values[::2], values[1::2], strict=True))


def _plate(random: Random) -> Ring:
    """A plate with its corners cut."""
    w, h, c = random.randint(40, 400), random.randint(30, 300), random.randint(3, 12)
    return _outline(c, 0, w - c, 0, w, c, w, h - c, w - c, h, c, h, 0, h - c, 0, c)


def _bracket(random: Random) -> Ring:
    """An angle of two arms."""
    w, h, t = random.randint(50, 200), random.randint(50, 200), random.randint(8, 30)
    return _outline(0, 0, w, 0, w, t, t, t, t, h, 0, h)


def _channel(random: Random) -> Ring:
    """A channel, open above; some are as wide inside as other parts are outside."""
    inside, t, h = random.choice([20, 40, 80]), random.randint(5, 15), random.randint(20, 90)
    w = inside + 2 * t
    return _outline(0, 0, w, 0, w, h, w - t, h, w - t, t, t, t, t, h, 0, h)


def _gusset(random: Random) -> Ring:
    """A triangle with its tips cut."""
    w, h, c = random.randint(40, 160), random.randint(40, 160), random.randint(4, 12)
    return _outline(c, 0, w, 0, w, c, c, h, 0, h, 0, c)


def _comb(random: Random) -> Ring:
    """A strip with teeth that narrow a little."""
    teeth, pitch, h = random.randint(3, 7), random.randint(12, 30), random.randint(10, 40)
    ring = [(0, 0), (teeth * pitch, 0)]
    for k in range(teeth - 1, -1, -1):
        x = k * pitch
        ring += [(x + pitch, 8), (x + pitch - 4, 8 + h), (x + 4, 8 + h), (x, 8)]
    return [(Fraction(x), Fraction(y)) for x, y in dict.fromkeys(ring)]


def _shim(random: Random) -> Ring:
    """A slip as wide as a channel is inside."""
    w, h = random.choice([20, 40, 80]), random.randint(5, 60)
    return _outline(0, 0, w, 0, w, h, 0, h)


def _half_disc(random: Random) -> Ring:
    """Half a disc, its rim of rational points of the circle."""
    radius, steps = random.randint(20, 120), random.randint(8, 20)
    ring = []
    for k in range(-steps, steps + 1):
        t = Fraction(k, steps)
        ring.append((radius * 2 * t / (1 + t * t), -radius * (1 - t * t) / (1 + t * t)))
    return ring


def _lever(random: Random) -> Ring:
    """An arm that gets thinner, in decimals, with a hook."""
    w, t = random.randint(80, 240), random.randint(10, 24)
    return _outline(
        0, 0, w, f"{t / 4}", w, f"{t}", f"{w - 5.5}", f"{t + 12.25}", f"{w - 14.5}", f"{t + 12.25}",
        f"{w - 9}", f"{t}", 0, f"{2 * t}",
    )  # fmt: skip


_KINDS = (_plate, _bracket, _channel, _gusset, _comb, _shim, _half_disc, _lever)


def part_list(count: int = 96, seed: int = 7) -> list[NamedPolygon]:
    """Parts in equal numbers of each kind, some turned by a multiple of 90 degrees."""
    random = Random(seed)
    parts = []
    for k in range(count):
        kind = _KINDS[k % len(_KINDS)]
        ring = kind(random)
        for _ in range(random.choice([0, 0, 1, 2, 3])):
            ring = [(-y, x) for x, y in ring]
        parts.append(NamedPolygon(Polygon(ring), f"{kind.__name__[1:]}-{k}"))
    return parts
