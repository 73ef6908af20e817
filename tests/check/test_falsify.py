"""A small, fixed sample of `python -m tests.falsify`."""

from random import Random

from falsify import falsify, list_weakened

from exactsweep.check import standalone


def test_falsified_certificates_are_refused() -> None:
    tried, missed = falsify(Random(7), 2, 20)
    assert tried.total() == 40
    assert not missed


def test_conditions_are_dropped_one_at_a_time() -> None:
    source = "def f():\n    need(\n        1 > 2,\n        'no',\n    )\n    return 1\n"
    assert list(list_weakened(source)) == [(2, "def f():\n    pass\n    return 1\n")]
    with open(standalone.__file__, encoding="utf-8") as file:
        assert len(list(list_weakened(file.read()))) > 50
