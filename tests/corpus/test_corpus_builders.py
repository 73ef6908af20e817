"""Shipping: cases are added to the corpus, and never changed."""

import json
import shutil
from pathlib import Path

import pytest
from builders import __main__ as command
from builders.families import shipped
from builders.shipping import ShippingError, digest, with_answers, written
from click.testing import CliRunner
from shipped_cases import shipped_cases
from tiers import mostly_long

from exactsweep.corpus import themes
from exactsweep.corpus.case import read_given_rings
from exactsweep.corpus.shipped import read_theme

SQUARE = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
NEW = {"id": "slivers-new", "title": "A square", "directrix": SQUARE, "generatrix": SQUARE}


def text_of(theme: str) -> str:
    return read_theme(command.DATA, theme)


@pytest.mark.parametrize("theme", mostly_long(themes(), [*themes()][::3]))
def test_shipped_files_are_written_from_their_cases(theme: str) -> None:
    assert written(theme, with_answers(theme, text_of(theme), [])) == text_of(theme)


def test_shipped_inputs_never_change() -> None:
    """Ids are immutable: the list of digests may grow, but no line may change."""
    digests = json.loads(command.DIGESTS.read_text(encoding="utf-8"))
    assert {case.id: digest(case) for case in shipped_cases()} == digests


def test_parametric_families_equal_the_shipped_pairs() -> None:
    pairs = {case.id: (case.directrix_rings, case.generatrix_rings) for case in shipped_cases()}
    for id, d, g in shipped():
        assert (read_given_rings(d), read_given_rings(g)) == pairs[id], id


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"id": "slivers-needle-itself"}, "^slivers-needle-itself is shipped; a new case needs"),
        ({"id": "caves-new"}, "^caves-new does not start with the name of its theme, slivers$"),
    ],
)
def test_a_shipped_case_cannot_be_changed(change: dict[str, str], complaint: str) -> None:
    with pytest.raises(ShippingError, match=complaint):
        with_answers("slivers", text_of("slivers"), [NEW | change])
    with pytest.raises(ShippingError, match=r"^slivers-new is shipped"):
        with_answers("slivers", text_of("slivers"), [NEW, NEW])


def test_a_new_case_changes_no_other() -> None:
    old = text_of("slivers")
    text = written("slivers", with_answers("slivers", old, [NEW]))
    before, after = json.loads(old)["cases"], json.loads(text)["cases"]
    assert after[:-1] == before
    assert after[-1]["expected"]["area"] == "8"
    assert written("slivers", with_answers("slivers", text, [], renew=True)) == text


def test_nothing_is_written_if_a_case_is_invalid(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    data = tmp_path / "data"
    shutil.copytree(command.DATA, data)
    monkeypatch.setattr(command, "DATA", data)
    monkeypatch.setattr(command, "DIGESTS", tmp_path / "digests.json")
    monkeypatch.setattr(command, "themes", lambda: ["worked", "slivers"])
    good, bad = tmp_path / "good.json", tmp_path / "bad.json"
    worked = NEW | {"id": "worked-new"}
    good.write_text(json.dumps({"theme": "worked", "cases": [worked]}), encoding="utf-8")
    bad.write_text(json.dumps({"theme": "slivers", "cases": [worked]}), encoding="utf-8")
    result = CliRunner().invoke(command.main, [str(good), str(bad)])
    assert result.exit_code == 1
    assert "does not start with the name of its theme" in result.output
    assert not (tmp_path / "digests.json").exists()
    assert (data / "worked.json").read_text(encoding="utf-8") == text_of("worked")
    assert CliRunner().invoke(command.main, [str(good)]).exit_code == 0
    last = json.loads((data / "worked.json").read_text(encoding="utf-8"))["cases"][-1]
    assert last["id"] == "worked-new"
    assert (data / "slivers.json").read_text(encoding="utf-8") == text_of("slivers")
