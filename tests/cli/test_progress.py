"""Long commands show progress after a second, and only on a terminal."""

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import StringIO
from pathlib import Path

import pytest
from command import HOUSE, NOTCH, run
from judged import CONVEX
from rich.status import Status

from exactsweep.cli import working


class Soon:
    """A timer that fires on start, unless it was canceled before."""

    daemon = False

    def __init__(self, seconds: float, act: Callable[[], None]) -> None:
        assert seconds == 1
        self.act = act

    def start(self) -> None:
        self.act()

    def cancel(self) -> None:
        """Do nothing, since the timer has fired."""

    join = cancel


class Later(Soon):
    """A timer that never fires."""

    def start(self) -> None:
        """Wait."""


@contextmanager
def terminal(monkeypatch: pytest.MonkeyPatch, timer: type[Soon]) -> Iterator[StringIO]:
    """A terminal on standard error."""
    text = StringIO()
    with monkeypatch.context() as patched:
        patched.setattr(working, "Timer", timer)
        patched.setattr(working, "_has_terminal", lambda: True)
        patched.setattr("sys.stderr", text)
        patched.setenv("FORCE_COLOR", "1")
        yield text


@pytest.mark.parametrize("timer", [Soon, Later])
def test_a_status_appears_after_one_second(
    timer: type[Soon], monkeypatch: pytest.MonkeyPatch
) -> None:
    with terminal(monkeypatch, timer) as text, working.working("sweeping"):
        pass
    assert ("sweeping" in text.getvalue()) == (timer is Soon)


@pytest.mark.parametrize("timer", [Soon, Later])
def test_a_bar_with_rate_and_time_begins_after_a_second(
    timer: type[Soon], monkeypatch: pytest.MonkeyPatch
) -> None:
    with terminal(monkeypatch, timer) as text, working.show_bar(256) as show:
        for done in (64, 128, 192, 256):
            show(done, "")
    for pattern in (r"256/256", r"\d+/s", r"\d:\d\d:\d\d"):
        assert bool(re.search(pattern, text.getvalue())) == (timer is Soon)


def test_a_run_shows_its_verdicts_so_far(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(working, "Timer", Soon)
    monkeypatch.setattr(working, "_has_terminal", lambda: True)
    monkeypatch.setenv("FORCE_COLOR", "1")
    done = run("conform", "--filter", "id=directions-y", "--", *CONVEX)
    assert "2 unsupported" in done.stderr
    assert "\x1b" not in done.stdout


@pytest.mark.parametrize("terminal", [True, False, None])
def test_progress_needs_a_terminal(terminal: bool | None, monkeypatch: pytest.MonkeyPatch) -> None:
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
def test_commands_show_their_progress(
    command: tuple[str, ...], words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert run(*PROVED).exit_code == 0
    Path("wrong.json").write_text(run("corpus", "layouts", "layouts-missing").stdout)
    shown: list[str] = []

    @contextmanager
    def listen(display: Status) -> Iterator[None]:
        shown.append(str(display.status))
        monkeypatch.setattr(display, "update", shown.append)
        yield

    monkeypatch.setattr(working, "_show_later", listen)
    code = run(*command).exit_code
    assert shown == []
    monkeypatch.setattr(working, "_has_terminal", lambda: True)
    assert run(*command).exit_code == code
    assert shown[: len(words)] == words
