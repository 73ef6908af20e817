"""A test of linear time that is independent of the speed and load of the machine."""

import time
from collections.abc import Callable


def require_linear(action: Callable[[int], object], size: int = 10_000) -> None:
    """Eight times the size may take some eight times as long; squared, it would be 64."""
    tries = ((_seconds(action, 8 * size), _seconds(action, size)) for _ in range(4))
    assert any(large < 30 * max(0.001, small) for large, small in tries)


def _seconds(action: Callable[[int], object], size: int) -> float:
    """The least processor time of three tries, for what else runs must not count."""
    times = []
    for _ in range(3):
        start = time.process_time()
        action(size)
        times.append(time.process_time() - start)
    return min(times)
