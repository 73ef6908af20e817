"""A program for polygons of any shape, with holes, that answers all questions.

The answers are those of exactsweep itself; replace `answer` with your own code.
"""

import json
import sys
from typing import Any

from exactsweep import Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.numbers.digits import format_fraction

HELLO = {
    "hello": "shapes.py",
    "questions": ["sweep", "no_fit", "inner_fit"],
    "loops": ["trajectory", "inner", "outer"],
    "shapes": "any",
    "numbers": "rational",
    "reference": "given",
}


def answer(part: str, d: Region, g: Region, reference: list[str]) -> dict[str, Any]:
    """Answer one part of the question: rings, and exact fits if the part has any."""
    if part == "no_fit":
        n = no_fit_polygon(d, g, reference=reference)
        loops = [loop.vertices for loop in (n.exterior, *n.holes)]
        return {part: loops, "exact_fits": n.exact_fits}
    if part == "inner_fit":
        f = inner_fit_polygon(d, g, reference=reference)
        rings = [ring for region in f.regions for ring in region.rings]
        return {part: rings, "inner_exact_fits": f.exact_fits}
    s = sweep(g, d, reference=reference)
    if part == "inner":
        # The regions that G cannot reach: around D, and elsewhere.
        return {part: [loop.vertices for loop in (s.inner, *s.unswept)]}
    return {part: getattr(s, part).vertices, "exact_fits": s.exact_fits}


if __name__ == "__main__":
    print(json.dumps(HELLO), flush=True)
    for line in sys.stdin:
        case = json.loads(line)
        if "bye" in case:
            break
        d, g = (Region(case[k], case.get(f"{k}_holes", [])) for k in ("directrix", "generatrix"))
        answers: dict[str, Any] = {"id": case["id"]}
        for part in case["ask"]:
            answers |= answer(part, d, g, case["reference"])
        print(json.dumps(answers, default=format_fraction), flush=True)
