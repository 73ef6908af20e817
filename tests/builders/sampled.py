"""A few small cases of every family of the generator, kept for good."""

from collections.abc import Iterator
from itertools import islice

from builders.entry import Entry
from exactsweep.corpus import FAMILIES, generate

TITLE = "Samples of every family of the generator"

SEED = 1997
EACH = 3
MOST = 26


def entries() -> Iterator[Entry]:
    for family in FAMILIES.values():
        if family.name == "long":
            continue
        small = (case for case in generate(family.name, SEED) if case.size <= MOST)
        for k, case in enumerate(islice(small, EACH)):
            yield Entry(
                f"{family.name}-{k}",
                case.title,
                case.directrix_ring,
                case.generatrix_ring,
                family.flags,
                case.reference,
                inside=case.inner_regions is not None,
                d_holes=case.directrix_holes,
                g_holes=case.generatrix_holes,
            )
