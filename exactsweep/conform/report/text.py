"""Comparisons and runs as text."""

from collections.abc import Mapping
from typing import Any

from exactsweep.conform.judge.verdict import Comparison, PartComparison, Verdict
from exactsweep.conform.judge.witness import PART_NAMES
from exactsweep.conform.run.outcome import list_witnesses
from exactsweep.conform.run.peer import cut
from exactsweep.conform.run.run import Run, Tally, fails
from exactsweep.text.report import approximate, lay_out, make_table, take_root
from exactsweep.words import count

_LISTED = 20


def describe(comparison: Comparison) -> str:
    """Write a comparison: the verdict, and each part with its verdict, errors and witnesses.

    >>> from exactsweep.conform.judge.compare import compare
    >>> from exactsweep.corpus import Case
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> case = Case.of("a", "", square, square)
    >>> print(describe(compare(case, {"trajectory": [[-1, -1], [1, -1], [0, 1]]})), end="")
    a: unsound
    trajectory: unsound, part of the exact trajectory is missing
      vertices off by up to 0.894427, area 2
      at (-1/2,1/2) G overlaps D; it is outside the answered trajectory
      translation (-1/2,1/2): OVERLAP, point (1/4,3/4)
    exact fits: exact
    """
    lines = [f"{comparison.id}: {comparison.verdict}"]
    if not comparison.parts:
        lines[0] += f", {comparison.reason}"
    for part in comparison.parts:
        lines += _part(part)
    return "".join(f"{line}\n" for line in lines)


def _part(part: PartComparison) -> list[str]:
    lines = [
        f"{PART_NAMES[part.name]}: {part.verdict}" + (f", {part.reason}" if part.reason else "")
    ]
    if part.distance_squared is not None and part.area:
        distance = approximate(take_root(part.distance_squared))
        granted = f", granted {approximate(part.granted)}" if part.granted else ""
        lines.append(f"  vertices off by up to {distance}, area {approximate(part.area)}{granted}")
    for witness in list_witnesses(part.to_json()):
        lines += (f"  {line}" for line in describe_witness(witness))
    return lines


def describe_witness(witness: Mapping[str, Any]) -> list[str]:
    """Describe a witness in one or two lines, with the exact verdict of `classify`."""
    lines = [witness["says"]]
    if witness["translation"] is not None:
        point = f", point ({','.join(witness['point'])})" if witness["point"] is not None else ""
        place = ",".join(witness["translation"])
        lines.append(f"translation ({place}): {witness['classified']}{point}")
    return lines


def write_table(summary: Tally, terminal_width: int | None = None) -> str:
    """Write the counts of verdicts for each class and flag, with colors on a terminal.

    >>> from exactsweep.conform.run.outcome import Outcome
    >>> from exactsweep.conform.judge.verdict import Verdict
    >>> outcomes = [Outcome("a", "CC", ("undercut",), Verdict.EXACT),
    ...             Outcome("b", "CC", (), Verdict.WRONG)]
    >>> print(write_table(Tally(outcomes)), end="")
              cases  exact  wrong
    all           2      1      1
    CC            2      1      1
    undercut      1      1
    """
    verdicts = summary.verdicts()
    heads = ("cases", *verdicts)
    grid = make_table(("", *heads), heads)
    for group in summary.groups():
        counts = (summary.total(verdict, group) for verdict in (None, *verdicts))
        grid.add_row(group, *(str(count or "") for count in counts))
    return lay_out([grid], terminal_width)


def close(run: Run) -> str:
    """Write the lines below the table: diagnosis, faults and result."""
    diagnosis = run.summary.diagnosis()
    lines = [] if diagnosis is None else [diagnosis]
    faults = run.list_faults()
    for fault in faults[:_LISTED]:
        smallest = fault.kept[0]
        more = f"  (and {fault.count - 1} more like it)" if fault.count > 1 else ""
        lines.append(f"{smallest.verdict}  {cut(smallest.id)}  {smallest.reason}{more}")
    if len(faults) > _LISTED:
        rest = sum(fault.count for fault in faults[_LISTED:])
        lines.append(
            f"... and {count(rest, 'other failure')} of {count(len(faults) - _LISTED, 'kind')}"
        )
    granted, where = run.summary.granted
    if granted:
        most = approximate(granted)
        lines.append(f"within: a rounding of up to {most} was granted ({cut(where)})")
    rounded = run.summary.total(Verdict.WITHIN)
    if rounded and fails(Verdict.WITHIN, run.accepted):
        lines.append(f"with --accept within, {count(rounded, 'rounded answer')} would pass")
    summary = run.summary
    ending = "passed" if run.passed else "failed"
    judged = f"{summary.judged} of {count(summary.total(), 'case')} judged"
    lines += [
        *run.find_objections(),
        f"{run.hello.name}: {ending}, {judged}, {count_failures(run)}",
    ]
    return "".join(f"{line}\n" for line in lines)


def count_failures(run: Run) -> str:
    """Count the failures, and state what is accepted."""
    ignored = {
        Verdict.EXACT: "",
        Verdict.EQUIVALENT: "",
        Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS: " (missing exact fits ignored)",
        Verdict.WITHIN: " (rounding and missing exact fits ignored)",
    }
    note = ignored.get(run.accepted, f" (verdicts up to {run.accepted} accepted)")
    return f"{count(run.summary.failures(run.accepted), 'failure')}{note}"


def write_counts(summary: Tally) -> str:
    return ", ".join(f"{summary.total(verdict)} {verdict}" for verdict in summary.verdicts())
