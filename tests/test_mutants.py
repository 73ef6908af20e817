"""The command that runs mutmut selects modules and tests, and reads the output."""

import click
import mutants
import pytest


def test_a_package_is_mutated_with_its_tests() -> None:
    settings = mutants.write_settings(("formats/rounding", "corpus/generator"), ())
    assert "only_mutate=\n    exactsweep/formats/rounding.py\n    exactsweep/corpus/" in settings
    assert "selection=\n    tests/formats\n    tests/corpus\npytest" in settings
    assert "selection=\n    tests/a.py\npytest" in mutants.write_settings(
        ("words",), ("tests/a.py",)
    )
    assert "selection=\n    tests\npytest" in mutants.write_settings(("words",), ())
    assert "selection=\n    tests/draw\npytest" in mutants.write_settings(("canvas",), ())


def test_unknown_packages_are_rejected() -> None:
    with pytest.raises(click.BadParameter, match="no package and no module 'cellar'"):
        mutants.write_settings(("cellar",), ())


def test_results_are_read() -> None:
    text = "    a.b.x_f__mutmut_1: survived\n    a.b.x_f__mutmut_2: no tests\n\n"
    assert mutants.read_results(text) == {
        "a.b.x_f__mutmut_1": "survived",
        "a.b.x_f__mutmut_2": "no tests",
    }
