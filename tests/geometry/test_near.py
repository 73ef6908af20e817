"""Boxes that meet, found by halves, against all pairs."""

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep.geometry import near
from exactsweep.geometry.near import find_near

# On so small a grid many borders coincide with those of the halves.
ends = st.tuples(st.integers(0, 9), st.integers(0, 3)).map(lambda end: (end[0], end[0] + end[1]))
boxes = st.lists(st.builds(lambda x, y: (*x, *y), ends, ends), min_size=2, max_size=30)


@examples(200)
@given(boxes, st.integers(0, 2), st.integers(1, 4))
def test_pairs_within_reach_are_found_once(
    given_boxes: list[tuple[int, int, int, int]], reach: int, few: int
) -> None:
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(near, "_FEW", few)
        found = sorted(find_near(given_boxes, reach))
    assert found == [
        (k, j)
        for (k, one), (j, other) in combinations(enumerate(given_boxes), 2)
        if all(max(one[i], other[i]) <= min(one[i + 1], other[i + 1]) + reach for i in (0, 2))
    ]
