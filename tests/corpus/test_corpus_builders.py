"""The builders make the shipped corpus, and cannot change it."""

import json
import shutil
from pathlib import Path

import pytest
from builders import __main__ as command
from builders.entry import UNIT, Entry
from builders.theme import THEMES, BuilderError, built, digest, with_answers, written
from click.testing import CliRunner

from exactsweep.corpus import cases, themes
from exactsweep.corpus.shipped import read_theme


def text_of(theme: str) -> str:
    return read_theme(command.DATA, theme)


def test_there_is_a_builder_for_every_theme() -> None:
    assert sorted(THEMES) == sorted(themes())


@pytest.mark.parametrize("theme", sorted(THEMES))
def test_builders_make_the_shipped_files(theme: str) -> None:
    old = text_of(theme)
    assert written(theme, with_answers(built(theme), old, renew=False)) == old


def test_shipped_inputs_never_change() -> None:
    """Ids are immutable: the list of digests may grow, and no line of it may change."""
    digests = json.loads(command.DIGESTS.read_text(encoding="utf-8"))
    assert {case.id: digest(case) for case in cases()} == digests


@pytest.mark.parametrize("renew", [True, False])
def test_a_shipped_case_cannot_be_changed_or_dropped(renew: bool) -> None:
    entries = built("slivers")
    first = next(iter(entries))
    changed = entries | {first: entries[first]._replace(g=UNIT, d=UNIT)}
    moved = entries | {first: entries[first]._replace(reference=(1, 0))}
    dropped = {id: entry for id, entry in entries.items() if id != first}
    for faulty in changed, moved, dropped:
        with pytest.raises(BuilderError, match=f"^{first} is shipped, and its builder has another"):
            with_answers(faulty, text_of("slivers"), renew)


def test_nothing_is_written_where_a_builder_is_at_fault(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    data = tmp_path / "data"
    shutil.copytree(command.DATA, data)
    monkeypatch.setattr(command, "DATA", data)
    monkeypatch.setattr(command, "DIGESTS", tmp_path / "digests.json")
    monkeypatch.setattr(command, "THEMES", ["worked", "slivers"])
    (data / "worked.json").unlink()
    monkeypatch.setattr(THEMES["slivers"], "entries", list)
    result = CliRunner().invoke(command.main)
    assert result.exit_code == 1
    assert "slivers-needle-itself is shipped" in result.output
    assert sorted(path.name for path in tmp_path.iterdir()) == ["data"]
    assert not (data / "worked.json").exists()
    monkeypatch.undo()
    monkeypatch.setattr(command, "DATA", data)
    monkeypatch.setattr(command, "DIGESTS", tmp_path / "digests.json")
    monkeypatch.setattr(command, "THEMES", ["worked", "slivers"])
    assert CliRunner().invoke(command.main).exit_code == 0
    assert (data / "worked.json").read_text(encoding="utf-8") == text_of("worked")


def test_a_new_case_is_added_and_the_others_stay() -> None:
    old = text_of("slivers")
    entries = built("slivers") | {"slivers-new": Entry("new", "A square", UNIT, UNIT)}
    text = written("slivers", with_answers(entries, old, renew=False))
    before, after = json.loads(old)["cases"], json.loads(text)["cases"]
    assert after[:-1] == before
    assert after[-1]["expected"]["area"] == "8"


def test_an_id_can_be_given_once(monkeypatch: pytest.MonkeyPatch) -> None:
    twice = [Entry("same", "a", UNIT, UNIT), Entry("same", "b", UNIT, UNIT)]
    monkeypatch.setattr(THEMES["slivers"], "entries", lambda: twice)
    with pytest.raises(BuilderError, match="slivers-same is there twice"):
        built("slivers")
