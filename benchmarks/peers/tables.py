"""The comparison as tables: the kernel beside CGAL with the bars, the others, floor, memory."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import RenderableType
from rich.markup import escape
from rich.table import Table

from benchmarks.peers.adapted import NAMES
from benchmarks.peers.cases import (
    CASES,
    FLOOR_BAR,
    FLOOR_CASES,
    LOOPS,
    MEMORY_BYTES,
    MEMORY_FIXED,
    PAIRS_BARS,
    READING_BAR,
    TRAJECTORY,
    Case,
)
from benchmarks.peers.measured import Comparison, Result
from benchmarks.peers.run import CGAL, CHECKED, FLOOR, OURS, READING

Row = list[str]
TIMES = (
    "Processor times in ms: median (least to greatest); ratios are of the medians and of the least "
    "times. CGAL goes by its fastest strategy for each step; its three loops are three sums. Both "
    "are given polygons; the times with checks are from lists of numbers, with every check that "
    "they are simple polygons, which CGAL does not make."
)


def tables(found: Comparison) -> Iterator[RenderableType]:
    """Everything, for the terminal."""
    yield found.machine
    yield ", ".join(found.versions.values())
    for name, reason in found.skipped.items():
        yield f"skipped: {name}, {reason}"
    yield TIMES
    for title, header, rows in sections(found):
        table = Table(title=title, title_justify="left")
        for k, name in enumerate(header):
            table.add_column(name, justify="left" if k == 0 else "right")
        for row in rows:
            table.add_row(*map(escape, row))
        yield table


def sections(found: Comparison) -> Iterator[tuple[str, Row, list[Row]]]:
    """The tables as (title, header, rows)."""
    for operation in (TRAJECTORY, LOOPS):
        header = [
            "pair",
            "vertices",
            OURS,
            CHECKED,
            CGAL,
            "ratio",
            "of the least",
            "bar",
            "strategy",
            "exact",
        ]
        rows = [_beside_cgal(found, case, operation) for case in _measured(found, operation)]
        yield f"{operation}: {CGAL}'s time over ours", header, rows
    others = [name for name in NAMES if name in found.versions]
    header = ["pair", "vertices", OURS, *others]
    rows = [_others(found, case, others) for case in _measured(found, TRAJECTORY)]
    yield "trajectory: the other programs; vertices that are not exact in brackets", header, rows
    rows = [row for case in FLOOR_CASES for row in _floor(found, case)]
    if rows:
        yield (
            "floor: the making of the output's Fractions and nothing else",
            ["pair", "vertices", "what", "time", "floor", "ratio", "bar"],
            rows,
        )
    yield (
        "small pairs on one core: outlines of parts, 7 to 38 vertices",
        ["operation", "pairs a second", "bar"],
        [
            [name, f"{rate:.0f}", f"{PAIRS_BARS[name]:g}" if name in PAIRS_BARS else "-"]
            for name, rate in found.pairs_a_second.items()
        ],
    )
    if found.memory:
        yield (
            "memory: peak of the trajectory of cm_hard 1024, 256",
            _MEMORY_HEADER,
            [_memory(found)],
        )


def _measured(found: Comparison, operation: str) -> list[Case]:
    return [case for case in CASES if found.find(OURS, operation, case)]


def _name(case: Case) -> str:
    return f"{case.family} {case.m}, {case.n}"


def _time(result: Result | None) -> str:
    if result is None:
        return "-"
    if result.times is None:
        return result.note
    median, least, greatest = (f"{t:.3g}" if t < 1000 else f"{t:.0f}" for t in result.times)
    return f"{median} ({least}..{greatest})"


def ratio(slow: Result | None, fast: Result | None, *, least: bool = False) -> float | None:
    """Return the ratio of two medians, or of two least times."""
    if slow is None or fast is None or slow.times is None or fast.times is None:
        return None
    if least:
        return slow.times.least / fast.times.least
    return slow.times.median / fast.times.median


def _beside_cgal(found: Comparison, case: Case, operation: str) -> Row:
    ours, theirs = (found.find(program, operation, case) for program in (OURS, CGAL))
    times, least, bar = ratio(theirs, ours), ratio(theirs, ours, least=True), case.bar(operation)
    vertices = "-" if ours is None else str(ours.vertices)
    strategy, exact = "-", "-"
    if theirs is not None and theirs.times is not None:
        strategy = theirs.note
        exact = f"{theirs.wrong} wrong" if theirs.wrong else "yes"
    return [
        _name(case),
        vertices,
        _time(ours),
        _time(found.find(CHECKED, operation, case)),
        _time(theirs),
        "-" if times is None else f"{times:.2f}",
        "-" if least is None else f"{least:.2f}",
        "-" if bar is None else f"{bar:g}" if times is None or times >= bar else f"{bar:g} missed",
        strategy,
        exact,
    ]


def _others(found: Comparison, case: Case, names: list[str]) -> Row:
    row = [_name(case)]
    ours = found.find(OURS, TRAJECTORY, case)
    row += ["-" if ours is None else str(ours.vertices), _time(ours)]
    for name in names:
        result = found.find(name, TRAJECTORY, case)
        wrong = f" [{result.wrong}]" if result is not None and result.wrong else ""
        row.append(_time(result) + wrong)
    return row


def _floor(found: Comparison, case: Case) -> list[Row]:
    floor = found.find(FLOOR, TRAJECTORY, case)
    # The floor is measured beside the trajectory, which comes right before it.
    before = found.results.index(floor) - 1 if floor in found.results else -1
    if floor is None or before < 0:
        return []
    ours = found.results[before]
    rows = []
    for what, result, most in (
        (TRAJECTORY, ours, FLOOR_BAR),
        (READING, found.find(READING, TRAJECTORY, case), READING_BAR),
    ):
        times = ratio(result, floor) or 0.0
        bar = f"{most:g}" + (" missed" if times > most else "")
        shown = [_time(result), _time(floor), f"{times:.2f}", bar]
        rows.append([_name(case), str(ours.vertices), what, *shown])
    return rows


_MEMORY_HEADER = ["vertices", "process, MB", "allowed, MB", "traced bytes a vertex"]


def _memory(found: Comparison) -> Row:
    vertices = found.memory["vertices"]
    allowed = MEMORY_BYTES * vertices + MEMORY_FIXED
    return [
        f"{vertices:.0f}",
        f"{found.memory['process'] / 1e6:.1f}",
        f"{allowed / 1e6:.1f}",
        f"{found.memory['traced'] / vertices:.0f}",
    ]
