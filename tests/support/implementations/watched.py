"""The correct implementation with a log of its questions: `watched.py LOG GATE`.

Before its tenth answer, it waits until the file GATE exists.
"""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

from correct import answer, hello, written


def main(log: str, gate: str) -> None:
    print(written(hello(hello="watched")), flush=True)
    for number, line in enumerate(sys.stdin, start=1):
        case = json.loads(line)
        if "bye" in case:
            break
        with open(log, "a") as file:
            file.write(f"{case['id']}\n")
        while number == 10 and not Path(gate).exists():
            time.sleep(0.01)
        print(written(answer(case)), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
