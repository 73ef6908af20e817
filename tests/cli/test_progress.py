"""Progress: long commands show it on a terminal, and only there, after a second."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import StringIO
from pathlib import Path

import pytest
from command import HOUSE, NOTCH, run
from rich.console import Console

from exactsweep.cli import bar, working


class Soon:
    """A timer that is done as soon as it begins; or never, if it is cancelled before."""

    daemon = False

    def __init__(self, seconds: float, act: Callable[[], None]) -> None:
        assert seconds == 1
        self.act = act

    def start(self) -> None:
        self.act()

    def cancel(self) -> None:
        """It is done already."""

    join = cancel


class Later(Soon):
    """A timer whose time never comes."""

    def start(self) -> None:
        """Wait."""


def say(timer: type[Soon], *, terminal: bool = True) -> str:
    text = StringIO()
    with bar.words(Console(file=text, force_terminal=terminal), timer) as tell:  # type: ignore[arg-type]
        tell("sweeping")
    return text.getvalue()


def test_after_a_second_something_is_said_on_a_terminal() -> None:
    assert "sweeping" in say(Soon)
    assert say(Later) == ""
    assert say(Soon, terminal=False) == ""


PAIR = (HOUSE, NOTCH)


@pytest.mark.parametrize(
    "command",
    [
        ("sweep", *PAIR),
        ("sweep", *PAIR, "--to", "json", "--round", "2"),
        ("explain", *PAIR),
        ("draw", *PAIR, "-o", "a.svg"),
        ("view", *PAIR, "-o", "a.html"),
        ("nfp", *PAIR),
        ("ifp", *PAIR),
        ("verify", "proof.json"),
        ("convert", HOUSE, "--to", "json"),
    ],
    ids=lambda command: " ".join(Path(word).name for word in command),
)
def test_commands_say_what_they_do(
    command: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run("sweep", *PAIR, "--certificate", "-o", "proof.json").exit_code == 0
    said: list[str] = []

    @contextmanager
    def words() -> Iterator[Callable[[str], None]]:
        yield said.append

    monkeypatch.setattr(bar, "words", words)
    assert run(*command).exit_code == 0
    assert said == []
    monkeypatch.setattr(working, "_has_terminal", lambda: True)
    assert run(*command).exit_code == 0
    assert said
    assert all(said)
