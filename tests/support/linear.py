"""A test of linear time that does not depend on the machine."""

import sys
import time
from collections import Counter
from collections.abc import Callable


def require_linear(action: Callable[[int], object], size: int = 10_000) -> None:
    """Require about eight times the cost for eight times the size; quadratic cost is 64."""
    # Load on the machine only lengthens runs. The small run is the minimum of three, so that it
    # cannot hide a slow large one; a large run that is too long is repeated.
    tries = (
        (_seconds(action, 8 * size), min(_seconds(action, size) for _ in range(3)))
        for _ in range(12)
    )
    assert any(large < 30 * max(0.001, small) for large, small in tries)


def count_calls(action: Callable[[], object]) -> int:
    """Count the calls and returns of functions in a run."""
    events = Counter[str]()
    before = sys.getprofile()
    sys.setprofile(lambda frame, event, argument: events.update([event]))
    try:
        action()
    finally:
        sys.setprofile(before)
    return events.total()


def _seconds(action: Callable[[int], object], size: int) -> float:
    """Return the processor time of one run."""
    start = time.process_time()
    action(size)
    return time.process_time() - start
