"""Horizontal and vertical edges only, as in layouts: letters, stairs, combs, many on one line."""

from collections.abc import Iterator, Sequence

from builders.entry import Entry, Ring, columns, mirrored, scaled, turned, under
from exactsweep.corpus.generator.cells import draw

TITLE = "Horizontal and vertical edges: letters, stairs, combs, many vertices on one line"


def entries() -> Iterator[Entry]:
    names = [*SHAPES]
    for step, manner in (1, "as drawn"), (3, "turned"), (5, "mirrored, twice as large"):
        for k, name in enumerate(names):
            other = names[(k + step) % len(names)]
            d, g = SHAPES[other], SHAPES[name]
            if step == 3:
                g = turned(g)
            elif step == 5:
                g = scaled(mirrored(g), 2)
            title = f"{name} around {other}" + (f", {manner}" if step > 1 else "")
            yield Entry(f"{name}-around-{other}", title, d, g)
    for count in 8, 20:
        right: list[tuple[int, int]] = []
        for k in range(count):
            y = 3 * k
            right += [(7, y), (7, y + 1), (2, y + 1), (2, y + 3)]
        lying: Ring = [(0, 0), *right[:-2], (0, 3 * count - 2)]
        upright = [(y, -x) for x, y in lying]
        title = f"{count} teeth, their tips on one line"
        for slug, d in (("lying", lying), ("upright", upright)):
            yield Entry(f"teeth-{slug}-{count}", f"{title}, {slug}", d, SHAPES["square"])
            yield Entry(f"teeth-{slug}-{count}-bar", f"{title}, {slug}, a bar", d, SHAPES["bar"])
            yield Entry(f"teeth-{slug}-{count}-itself", f"{title}, {slug}, itself", d, d)


def drawn(*rows: str) -> Sequence[tuple[object, object]]:
    return draw(*rows).exterior.vertices


SHAPES: dict[str, Ring] = {
    "square": drawn("##", "##"),
    "bar": drawn("####"),
    "l": drawn("#  ", "#  ", "###"),
    "t": drawn("###", " # ", " # "),
    "u": drawn("# #", "# #", "###"),
    "s": drawn(" ##", "## "),
    "plus": drawn(" # ", "###", " # "),
    "stairs": drawn("#   ", "##  ", "### ", "####"),
    "pyramid": drawn("  #  ", " ### ", "#####"),
    "comb": under(columns([1, 1, 1, 1, 1, 1, 1], [0, 3, 0, 3, 0, 3, 0]), 4),
    "uneven": under(columns([1, 2, 1, 3, 1], [0, 2, -1, 1, 0]), 5),
    "e": drawn("###", "#  ", "###", "#  ", "###"),
}
