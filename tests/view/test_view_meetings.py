"""Features that can touch, by the angles of edges."""

from itertools import product

from exactsweep.geometry.outline import Outline
from exactsweep.view.data import find_facing

COMPASS = [(x, y) for x, y in product(range(-2, 3), repeat=2) if 2 in (abs(x), abs(y))]


def test_an_edge_can_touch_the_corners_to_its_right() -> None:
    """These corners are convex, with both edges to the right of the edge or along it."""
    # Edge 2 k leads to point k of the compass, and the next one back.
    rose = Outline([[(5, 5), (5 + x, 5 + y)] for x, y in COMPASS])
    for forward, back in product(COMPASS, repeat=2):
        turn = forward[0] * back[1] - forward[1] * back[0]
        if turn == 0:
            continue
        faced = {
            i // 2
            for i, j in find_facing(rose, Outline([[(0, 0), forward, back]]))
            if j == 0 and i % 2 == 0
        }
        assert faced == {
            k
            for k, (x, y) in enumerate(COMPASS)
            if turn > 0 and all(x * w <= y * v for v, w in (forward, back))
        }
