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
    with bar.words(1, Console(file=text, force_terminal=terminal), timer) as tell:  # type: ignore[arg-type]
        tell("sweeping")
    return text.getvalue()


def test_after_a_second_something_is_said_on_a_terminal() -> None:
    assert "sweeping" in say(Soon)
    assert say(Later) == ""
    assert say(Soon, terminal=False) == ""


@pytest.mark.parametrize("terminal", [True, False, None])
def test_only_a_terminal_is_told(terminal: bool | None, monkeypatch: pytest.MonkeyPatch) -> None:
    class Stream(StringIO):
        def isatty(self) -> bool:
            return bool(terminal)

    monkeypatch.setattr("sys.stderr", None if terminal is None else Stream())
    assert working._has_terminal() is bool(terminal)


PAIR = (HOUSE, NOTCH)


PROVED = ("sweep", *PAIR, "--certificate", "-o", "proof.json")


@pytest.mark.parametrize(
    ("command", "words"),
    [
        (("sweep", *PAIR), ["reading", "reading", "reading", "computing"]),
        (("sweep", "--to", "json", "--round", "2"), ["computing", "rounding"]),
        (("explain",), ["explaining the sweep"]),
        (("draw", "-o", "a.svg"), ["sweeping", "drawing"]),
        (("nfp", HOUSE, HOUSE), [*["reading"] * 4, "no-fit polygons", "no-fit polygon 1 of 1"]),
        (("ifp", *PAIR), ["reading", "reading", "reading", "computing"]),
        (("verify", "proof.json"), ["checking the certificate"]),
        (("convert", HOUSE, "--to", "json"), ["reading", "reading"]),
        (("view", "-o", "a.html"), ["making the page"]),
        (("layout", "wrong.json"), ["judging 2 placements", "measuring fault 1 of 1", "writing"]),
    ],
    ids=lambda item: item[0],
)
def test_commands_say_what_they_do(
    command: tuple[str, ...], words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(*PROVED).exit_code == 0
    Path("wrong.json").write_text(run("corpus", "layouts", "layouts-missing").stdout)
    said: list[str] = []

    @contextmanager
    def listen(_: float) -> Iterator[Callable[[str], None]]:
        yield said.append

    monkeypatch.setattr(bar, "words", listen)
    code = run(*command).exit_code
    assert said == []
    monkeypatch.setattr(working, "_has_terminal", lambda: True)
    assert run(*command).exit_code == code
    assert said[: len(words)] == words
