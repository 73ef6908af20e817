"""The garbage collector rests, and goes on as before."""

import gc
from collections.abc import Iterator

import pytest

from exactsweep import sweep
from exactsweep.evidence.sweep import Sweep
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.monotone import LowerSweep, MonotoneSolution
from exactsweep.procedures.solution import made_once, pause_collector

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


@pytest.fixture(params=[True, False])
def enabled(request: pytest.FixtureRequest) -> Iterator[bool]:
    before = gc.isenabled()
    (gc.enable if request.param else gc.disable)()
    yield request.param
    (gc.enable if before else gc.disable)()


def test_the_collector_is_left_as_it_was(enabled: bool) -> None:
    with pause_collector():
        assert not gc.isenabled()
        with pause_collector():
            pass
        assert not gc.isenabled()
    assert gc.isenabled() == enabled
    with pytest.raises(ZeroDivisionError), pause_collector():
        _ = 1 // 0
    assert gc.isenabled() == enabled


def test_a_sweep_makes_no_cycles() -> None:
    """So that there is nothing for the collector to find."""
    gc.freeze()
    gc.disable()
    try:
        s = sweep(SQUARE, [(0, 0), (4, 0), (4, 3), (2, 1), (0, 3)])
        assert [len(loop) for loop in (s.trajectory, s.inner, s.outer)]
        del s
        assert gc.collect() == 0
    finally:
        gc.enable()


def test_what_is_made_once_is_made_once() -> None:
    half = LowerSweep("CC", [(1, 1), (0, 1)], [(0, 0), (1, 0)], [(0, 0), (3, 0)])
    assert half.outer is half.outer == [(-1, -1), (4, -1)]
    assert isinstance(LowerSweep.outer, made_once)
    s = sweep(SQUARE, SQUARE)
    assert s.trajectory is s.trajectory
    assert isinstance(Sweep.trajectory, made_once)


def test_envelopes_are_let_go_when_all_loops_are_there() -> None:
    slot = [(0, 0), (5, 0), (4, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    fork = [(0, 0), (1, 0), (1, 2), ("3/4", 1), ("1/2", 1), (0, 2)]
    s, afresh = sweep(fork, slot), sweep(fork, slot)
    assert [len(loop) for loop in (s.trajectory, s.inner, s.outer)]
    assert isinstance(s.solution, MonotoneSolution)
    held = [value for half in s.solution.halves for value in vars(half).values()]
    assert not any(isinstance(value, Envelope) for value in held)
    assert s.exact_fits == afresh.exact_fits != ()
    assert s.undercuts == afresh.undercuts
