"""Of all pairs of convex parts few are swept, and come together in few envelopes: by counting."""

from collections.abc import Sequence
from typing import Any

import pytest

from benchmarks.families import FAMILIES
from exactsweep import sweep
from exactsweep.procedures import part_pairs
from exactsweep.procedures.convex_part import ConvexPart, CrossingPart
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.lower_envelope import lower_envelope_mm

Counts = tuple[int, int, int]


@pytest.mark.parametrize(
    ("family", "size", "most"),
    [
        # Pairs swept, envelopes taken of runs, and runs; of the trajectory, inner and outer loop.
        ("mm", 24, [(58, 2, 9), (62, 2, 13), (80, 4, 18)]),
        ("mm", 60, [(222, 6, 29), (304, 6, 47), (385, 6, 73)]),
        ("stair", 24, [(72, 2, 12), (54, 2, 12), (78, 4, 11)]),
        ("stair", 60, [(163, 6, 26), (96, 6, 26), (154, 6, 17)]),
    ],
)
def test_no_more_pairs_are_swept_than_were(
    family: str, size: int, most: Sequence[Counts], monkeypatch: pytest.MonkeyPatch
) -> None:
    pairs: list[int] = []
    runs: list[int] = []
    for kind in (ConvexPart, CrossingPart):
        swept = kind.sweep

        def count(part: Any, chain: ConvexPart, source: int, swept: Any = swept) -> Any:
            pairs.append(source)
            return swept(part, chain, source)

        monkeypatch.setattr(kind, "sweep", count)

    def take(found: list[Envelope]) -> Envelope:
        runs.append(len(found))
        return lower_envelope_mm(found)

    monkeypatch.setattr(part_pairs, "lower_envelope_mm", take)
    generatrix, directrix = FAMILIES[family](size, size, 0)
    found = sweep(generatrix, directrix)
    for loop, (most_pairs, most_envelopes, most_runs) in zip(
        ("trajectory", "inner", "outer"), most, strict=True
    ):
        pairs.clear()
        runs.clear()
        assert getattr(found, loop)
        assert len(pairs) <= most_pairs
        assert len(runs) <= most_envelopes
        assert sum(runs) <= most_runs
