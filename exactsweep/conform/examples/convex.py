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


if __name__ == "__main__":
    hello = {"hello": "convex.py", "loops": ["trajectory"]}
    print(json.dumps({**hello, "numbers": "rational", "reference": "given"}), flush=True)
    for line in sys.stdin:
        case = json.loads(line)
        if "bye" in case:
            break
        answer = {"id": case["id"], "unsupported": "not convex"}
        if case["class"] == "CC":
            rings = case["directrix"], case["generatrix"], [case["reference"]]
            d, g, [(x, y)] = ([(Fraction(a), Fraction(b)) for a, b in ring] for ring in rings)
            sums = sorted({(dx - gx + x, dy - gy + y) for dx, dy in d for gx, gy in g})
            loop = right_side(sums) + right_side(sums[::-1])
            answer = {"id": case["id"], "trajectory": loop}
        print(json.dumps(answer, default=str), flush=True)
