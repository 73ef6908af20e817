"""Rewrite the golden files: `python -m tests.goldens [PARTS]...`.

These are the texts of this folder, both golden.json, the reports of `conform`,
the options of all commands, all transcripts and all refusals.txt; git shows the changes.
"""

import json
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import chdir
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click

# Tests import each other by bare names, as under pytest.
sys.path.extend(
    f"{Path(__file__).parents[1]}/{folder}"
    for folder in ("", "support", "batch", "check", "cli", "conform", "formats", "layout")
)
import test_batch_golden as batch
import test_cli_options as options
import test_formats_golden as formats
import test_layout as layout
import test_reports_golden as reports
from refusals import renew_errors
from transcripts import TESTS, list_transcripts, replay

from goldens.texts import TEXTS, list_rows


def list_goldens() -> Iterator[tuple[Path, Callable[[], str]]]:
    """Yield the golden files, each with a function that makes its text."""
    for name, lines in (TEXTS | {"ledger": list_rows}).items():
        yield Path(__file__).with_name(f"{name}.txt"), partial(join_lines, lines)
    yield batch.FILE, partial(answer, batch.CASES, "record", batch.find_record)
    yield formats.FILE, partial(answer, formats.CASES, "outcome", formats.find_outcome)
    yield reports.FILE, reports.write_reports
    yield options.FILE, partial(join_lines, options.list_options)
    for path in list_transcripts():
        yield path, partial(replay_apart, path)
    for path in sorted(TESTS.glob("*/refusals.txt")):
        names = vars(layout) if path.parent.name == "layout" else {}
        yield path, partial(renew_errors, path, names)


def join_lines(lines: Callable[[], Iterable[str]]) -> str:
    return "".join(f"{line}\n" for line in lines())


def answer(cases: Iterable[dict[str, Any]], key: str, find: Callable[..., object]) -> str:
    found = ",\n".join(json.dumps({**case, key: find(case)}) for case in cases)
    return f"[\n{found}\n]\n"


def replay_apart(path: Path) -> str:
    with TemporaryDirectory() as folder, chdir(folder):
        return replay(path.read_text(encoding="utf-8"))


@click.command()
@click.argument("parts", nargs=-1)
def main(parts: tuple[str, ...]) -> None:
    """Rewrite the golden files, or those whose path contains one of the PARTS."""
    for path, make in list_goldens():
        name = path.relative_to(TESTS).as_posix()
        if any(part in name for part in parts or ("",)):
            print(name)
            path.write_text(make(), encoding="utf-8")


if __name__ == "__main__":
    main(prog_name="python -m tests.goldens")
