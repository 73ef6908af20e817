"""Pairs of outlines of parts, laid against each other in several ways."""

from collections.abc import Iterator

from builders import outlines
from builders.entry import Entry, mapped, mirrored, turned

TITLE = "Outlines of parts: profiles, brackets, gears, letters"

FLAG = ("part",)
# How many outlines further on the directrix stands, and how the generatrix is laid against it.
STEPS = [(1, "as drawn"), (4, "turned"), (6, "mirrored")]


def entries() -> Iterator[Entry]:
    names = [*outlines.ALONG_X]
    for step, manner in STEPS:
        for k, name in enumerate(names):
            other = names[(k + step) % len(names)]
            g, d = outlines.ALONG_X[name], outlines.ALONG_X[other]
            if manner == "turned":
                g = turned(g)
            elif manner == "mirrored":
                g, d = (mapped(mirrored(ring), (4, -3, 3, 4)) for ring in (g, d))
            how = {
                "as drawn": "",
                "turned": ", by half a turn",
                "mirrored": ", both mirrored and slanted 3 in 4",
            }[manner]
            yield Entry(f"{name}-around-{other}", f"{name} around {other}{how}", d, g, FLAG)
    letters = [*outlines.ALONG_Y]
    for k, name in enumerate(letters):
        other = letters[(k + 1) % len(letters)]
        g, d = outlines.ALONG_Y[name], outlines.ALONG_Y[other]
        yield Entry(f"{name}-around-{other}", f"{name} around {other}", d, g, FLAG)
