"""A small, fixed sample of `python -m tests.falsify`."""

from random import Random
from unittest.mock import patch

import pytest
from falsify import LAYOUTS, ROUNDED, SHAPES, SUMS, Family, falsify
from rounded_pieces import draw_rounded, is_true_rounded
from weakened import list_weakened

from exactsweep.check import standalone


@pytest.mark.parametrize("family", [SHAPES, SUMS, LAYOUTS, ROUNDED])
def test_falsified_certificates_are_rejected(family: Family) -> None:
    tried, missed = falsify(Random(8), 2, 20, family)
    assert tried.total() == 40
    assert not missed


@pytest.mark.parametrize("seed", range(3))
def test_random_layouts_of_rounded_pieces_are_proved(seed: int) -> None:
    for rng in map(Random, range(seed, 60, 3)):
        for certificate in draw_rounded(rng):
            assert is_true_rounded(certificate, None)
            assert standalone.prove(certificate)


def test_a_layout_checker_that_trusts_all_normals_is_caught() -> None:
    with patch.object(standalone, "gap", lambda *_: True):
        _, missed = falsify(Random(5), 3, 20, LAYOUTS)
    assert missed


def test_conditions_are_dropped_one_at_a_time() -> None:
    source = "def f():\n    need(\n        1 > 2,\n        'no',\n    )\n    return 1\n"
    assert list(list_weakened(source)) == [(2, "def f():\n    pass\n    return 1\n")]
    with open(standalone.__file__, encoding="utf-8") as file:
        assert len(list(list_weakened(file.read()))) > 40
