"""Settings of all tests: no deadlines, a clean environment, and a browser."""

from __future__ import annotations

import gc
import os
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, settings
from shown import FLAGS, MILLISECONDS, SIZE, Open, Shown

from exactsweep import InnerFit, NoFitPolygon, Sweep
from exactsweep.view import make_page

for name in ("COLUMNS", "LINES", "TERM", "FORCE_COLOR", "NO_COLOR"):
    os.environ.pop(name, None)
# Tests start hundreds of processes, which would compile all modules each.
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

settings.register_profile("fresh", deadline=None, suppress_health_check=[HealthCheck.too_slow])
# All runs have the same examples, so that failures never depend on chance. Campaigns and
# `pytest --hypothesis-profile fresh` draw new ones; the long run has four times as many.
settings.register_profile("many", settings.get_profile("fresh"), derandomize=True, database=None)
settings.register_profile("few", settings.get_profile("many"), max_examples=25)
settings.load_profile("few")


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Iterator[None]:
    """Collect tests without the garbage collector, then freeze what exists."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()
        # The collector would spend most of its time on the corpus and golden data.
        gc.set_threshold(100_000, 50, 50)


def pytest_sessionfinish() -> None:
    """Freeze live objects, because pytest collects garbage five times."""
    gc.collect()
    gc.freeze()


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """Debian's Chromium with one context; without Chromium, the test is skipped."""
    playwright = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if chromium is None:
        pytest.skip("no Chromium on this machine")
    with playwright.sync_playwright() as driver:
        opened = driver.chromium.launch(executable_path=chromium, args=FLAGS, timeout=MILLISECONDS)
        opened.new_context(viewport=SIZE)
        yield opened
        opened.close()


@pytest.fixture
def heed_interrupts() -> Iterator[None]:
    """Restore SIGINT for started programs; a shell ignores it for background jobs."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture
def show(browser: Any, tmp_path: Path) -> Iterator[Open]:
    opened: list[Shown] = []

    def open_page(s: Sweep | NoFitPolygon | InnerFit, **options: Any) -> Shown:
        file = tmp_path / "sweep.html"
        file.write_text(make_page(s), encoding="utf-8")
        opened.append(Shown(browser, file, **options))
        return opened[-1]

    yield open_page
    for shown in opened:
        shown.tab.close()
        assert shown.complaints == []
        assert len(shown.requests) == 1
