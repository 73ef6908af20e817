"""The output of commands, word for word; `python -m tests.goldens` writes it anew."""

from pathlib import Path

import pytest
from transcripts import list_transcripts, replay


@pytest.mark.parametrize("path", list_transcripts(), ids=lambda path: path.stem)
def test_commands_write_what_they_wrote(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    transcript = path.read_text(encoding="utf-8")
    assert replay(transcript) == transcript
