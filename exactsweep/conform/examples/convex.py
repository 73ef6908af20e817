"""The trajectory of convex pairs: the hull of the differences of their vertices."""

import json
import sys
from fractions import Fraction

Points = list[tuple[Fraction, Fraction]]


def right_side(points: Points) -> Points:
    """Return the corners to the right of sorted points, without the last one."""
    found: Points = []
    for x, y in points:
        while len(found) > 1:
            (ax, ay), (bx, by) = found[-2:]
            if (bx - ax) * (y - ay) > (x - ax) * (by - ay):
                break
            found.pop()
        found.append((x, y))
    return found[:-1]


def answer(d: Points, g: Points, reference: tuple[Fraction, Fraction]) -> Points:
    """Return the trajectory; put your own code in its place."""
    x, y = reference
    sums = sorted({(dx - gx + x, dy - gy + y) for dx, dy in d for gx, gy in g})
    return right_side(sums) + right_side(sums[::-1])


if __name__ == "__main__":
    hello = {"hello": "convex.py", "loops": ["trajectory"]}
    print(json.dumps({**hello, "numbers": "rational", "reference": "given"}), flush=True)
    for line in sys.stdin:
        case = json.loads(line)
        if "bye" in case:
            break
        said = {"id": case["id"], "unsupported": "not convex"}
        if case["class"] == "CC":
            rings = case["directrix"], case["generatrix"], [case["reference"]]
            d, g, [reference] = ([(Fraction(a), Fraction(b)) for a, b in ring] for ring in rings)
            said = {"id": case["id"], "trajectory": answer(d, g, reference)}
        print(json.dumps(said, default=str), flush=True)
