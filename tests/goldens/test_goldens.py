"""Pictures, figures and exports match the golden files, which goldens/__main__.py writes."""

from pathlib import Path

import pytest
from tiers import mostly_long

from goldens.texts import TEXTS


@pytest.mark.parametrize("name", mostly_long(TEXTS, {*TEXTS} - {"generated", "pictures"}))
def test_texts_are_golden(name: str) -> None:
    expected = Path(__file__).with_name(f"{name}.txt").read_text(encoding="utf-8")
    assert "".join(f"{line}\n" for line in TEXTS[name]()) == expected
