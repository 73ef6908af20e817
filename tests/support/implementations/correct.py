"""exactsweep itself behind the protocol; the faulty program changes the result of `answer`."""

from __future__ import annotations

import json
import sys
from typing import Any

from exactsweep import sweep
from exactsweep.numbers.digits import format_fraction

LOOPS = ["trajectory", "inner", "outer"]


def hello(**changes: Any) -> dict[str, Any]:
    fields = {"hello": "correct", "loops": LOOPS, "numbers": "rational", "reference": "given"}
    return {**fields, **changes}


def answer(case: dict[str, Any]) -> dict[str, Any]:
    s = sweep(case["generatrix"], case["directrix"], reference=case["reference"])
    loops = {name: getattr(s, name).vertices for name in LOOPS}
    return {"id": case["id"], **loops, "exact_fits": s.exact_fits}


def written(data: dict[str, Any]) -> str:
    return json.dumps(data, default=format_fraction)


def main() -> None:
    print(written(hello()), flush=True)
    for line in sys.stdin:
        case = json.loads(line)
        if "bye" in case:
            break
        print(written(answer(case)), flush=True)


if __name__ == "__main__":
    main()
