"""The garbage collector, paused while a loop is computed."""

import gc

import pytest

from exactsweep import sweep
from exactsweep.procedures.solution import pause_collector

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


@pytest.mark.parametrize("runs", [True, False])
def test_a_pause_leaves_the_collector_as_it_was(runs: bool) -> None:
    before = gc.isenabled()
    try:
        (gc.enable if runs else gc.disable)()
        with pause_collector():
            assert not gc.isenabled()
        assert gc.isenabled() == runs
        assert len(sweep(SQUARE, SQUARE).outer) == 4
        assert gc.isenabled() == runs
        with pytest.raises(ZeroDivisionError), pause_collector():
            raise ZeroDivisionError
        assert gc.isenabled() == runs
    finally:
        (gc.enable if before else gc.disable)()
