"""The output of commands, word for word; `python -m tests.goldens` rewrites it."""

from pathlib import Path

import pytest
from transcripts import list_transcripts, replay

# These take seconds each.
LONG = {"conform", "compare", "draw", "layouts"}


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, marks=[pytest.mark.long] * (path.stem in LONG), id=path.stem)
        for path in list_transcripts()
    ],
)
def test_transcripts_are_golden(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    transcript = path.read_text(encoding="utf-8")
    assert replay(transcript) == transcript
