"""The walks of PROJECT.md compared with actual calls."""

import re
import sys
from collections.abc import Callable
from pathlib import Path
from types import FrameType, SimpleNamespace

import pytest
from tiers import mostly_long

from exactsweep import Polygon, sweep
from exactsweep.batch import Part, run, take_all_pairs, workers
from exactsweep.batch.work import Chunk, Work
from exactsweep.conform import conform
from exactsweep.corpus import Case, case_from_json, case_to_json
from exactsweep.formats import read_polygon
from exactsweep.paper.claim import Effort, reproduce
from exactsweep.paper.ledger import find
from exactsweep.paper.report import render_row
from exactsweep.procedures import monotone

PACKAGE = Path(__file__).parents[1] / "exactsweep"
Step = tuple[str, str]

HOUSE = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
MITRE = [(0, 0), (2, 0), (2, 3), (1, 1), (0, 3)]
BLOCK = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]
ARCH = [(0, 0), (4, 1), *BLOCK[1:]]


CASE = case_to_json(Case.of("mine", "", BLOCK, HOUSE))


class Here:
    """A pool that computes a batch in this process, so that calls can be traced."""

    count = 1
    lost = ()

    def __init__(self, work: Work, workers: int | None) -> None:
        self.work = work

    def submit(self, chunk: Chunk) -> SimpleNamespace:
        return SimpleNamespace(result=lambda: self.work.lines(chunk))

    def close(self) -> None:
        pass


def make_trajectory(folder: Path) -> object:
    # Empty the caches, as before a first sweep.
    monotone.split_polygon.cache_clear()
    return sweep(HOUSE, ARCH).trajectory


def make_inner_loop(folder: Path) -> object:
    monotone.split_polygon.cache_clear()
    return sweep(MITRE, ARCH).inner


def judge(folder: Path) -> object:
    case = case_from_json(CASE)
    answer = {"trajectory": [(-2, -2), (9, -2), (9, 6), (-2, 6)]}
    run = conform(lambda d, g, reference: answer, [case], name="mine", reference="origin")
    return list(run.show())


def report(folder: Path) -> object:
    # No other test has this seed: the loops of known pairs are cached.
    return [render_row(row) for row in reproduce([find("Lemma 3.2")], Effort(271828, quick=True))]


def record(folder: Path) -> object:
    part = Part("block", Polygon(BLOCK))
    job = take_all_pairs([part], [part])
    return run(job, str(folder / "records.jsonl"), workers=1)


def read(folder: Path) -> object:
    file = folder / "triangle.wkt"
    file.write_text("POLYGON ((0 0, 1 0, 0 1, 0 0))")
    return read_polygon(str(file))


WALKS: dict[str, Callable[[Path], object]] = {
    "A vertex list becomes a trajectory": make_trajectory,
    "A monotone pair gets its inner loop": make_inner_loop,
    "A case becomes a verdict": judge,
    "A claim becomes a row of the report": report,
    "A pair becomes a record": record,
    "A file becomes a Polygon": read,
}


def list_walks() -> dict[str, list[Step]]:
    """Return the steps of each walk in PROJECT.md as pairs of file and name."""
    text = (PACKAGE / "PROJECT.md").read_text(encoding="utf-8")
    listed = text.split("## Six walks through the code")[1].split("\n## ")[0]
    parts = re.split(r"^### (.*)$", listed, flags=re.M)[1:]
    return {
        title: re.findall(r"^\d+\. `([\w/.]+)`, `([\w.]+)`: ", body, flags=re.M)
        for title, body in zip(parts[::2], parts[1::2], strict=True)
    }


def follow(walk: Callable[[Path], object], folder: Path) -> list[Step]:
    """Return the functions of the package that a call enters, in order of their first entry."""
    seen: dict[Step, None] = {}

    def note(frame: FrameType, event: str, argument: object) -> None:
        path = Path(frame.f_code.co_filename)
        if event == "call" and path.is_relative_to(PACKAGE):
            seen.setdefault((path.relative_to(PACKAGE).as_posix(), frame.f_code.co_qualname))

    before = sys.getprofile()
    sys.setprofile(note)
    try:
        walk(folder)
    finally:
        sys.setprofile(before)
    return list(seen)


def find_misstep(listed: list[Step], seen: list[Step]) -> Step | None:
    """Return the first step that is missing or out of order."""
    rest = iter(seen)
    return next((step for step in listed if step not in rest), None)


def test_walks_of_the_page_are_current() -> None:
    assert list_walks().keys() == WALKS.keys()
    assert all(len(steps) > 6 for steps in list_walks().values())


@pytest.mark.parametrize(
    "title", mostly_long(WALKS, [title for title in WALKS if "claim" not in title])
)
def test_calls_follow_the_walk(title: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "LocalProcesses", Here)
    seen = follow(WALKS[title], tmp_path)
    assert find_misstep(list_walks()[title], seen) is None


def test_wrong_steps_are_found() -> None:
    a, b, c = ("a.py", "f"), ("b.py", "g"), ("c.py", "h")
    assert find_misstep([a, c], [a, b, c]) is None
    assert find_misstep([c, a], [a, b, c]) == a
    assert find_misstep([a, ("c.py", "i")], [a, b, c]) == ("c.py", "i")
