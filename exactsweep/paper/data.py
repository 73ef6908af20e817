"""The findings of a run as data: ledger.json, CSV tables and counterexample files."""

import csv
import json
import platform
import re
import subprocess
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import asdict
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

from exactsweep import __version__
from exactsweep.formats import NamedPolygon, format_polygons
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.digits import to_plain
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Finding
from exactsweep.paper.costs import tabulate
from exactsweep.paper.growth import Growth

FORMAT = "exactsweep ledger"
_TEXTS = ("name", "section", "words", "weight", "correction", "proof", "kernel", "chosen")
PACKAGES = ("sympy", "matplotlib", "jinja2")


def make_slug(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


def describe_environment(effort: Effort) -> dict[str, Any]:
    return {
        "exactsweep": __version__,
        "commit": _commit(),
        "python": f"{platform.python_implementation()} {platform.python_version()}",
        "packages": {name: found for name in PACKAGES if (found := _version(name))},
        "system": platform.platform(),
        "processor": _processor(),
        "seed": effort.seed,
        "quick": effort.quick,
        "date": f"{datetime.now(UTC):%Y-%m-%d}",
    }


def _commit() -> str | None:
    """Return the commit, with "+" if the checkout is modified; None outside a checkout."""
    command = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty=+"]
    try:
        found = subprocess.run(
            [*command, "--abbrev=40", "--exclude=*"], capture_output=True, text=True, check=False
        )
    except OSError:
        return None
    return found.stdout.strip() or None


def _version(name: str) -> str | None:
    with suppress(PackageNotFoundError):
        return version(name)
    return None


def _processor() -> str:
    described = Path("/proc/cpuinfo")
    text = described.read_text(encoding="utf-8") if described.exists() else ""
    named = re.search(r"^model name\s*:(.*)$", text, re.MULTILINE)
    return named[1].strip() if named else platform.processor() or platform.machine()


def as_json(rows: Sequence[Finding], effort: Effort) -> dict[str, Any]:
    return {
        "format": FORMAT,
        "version": 1,
        "environment": describe_environment(effort),
        "totals": dict(Counter(row.claim.verdict.value for row in rows)),
        "failing": [row.claim.name for row in rows if row.disagreement],
        "claims": [_row_as_json(row) for row in rows],
    }


def _row_as_json(row: Finding) -> dict[str, Any]:
    claim, found = row.claim, row.evidence
    data = {name: getattr(claim, name) or None for name in _TEXTS}
    data |= {"verdict": claim.verdict.value, "tried": found.tried, "sampled": found.sampled or None}
    data |= {name: getattr(claim, name) for name in ("evidence", "see", "code")}
    return to_plain(
        data
        | {
            "disagreement": row.disagreement or None,
            "counterexamples": [
                case._asdict() | {"file": name if case.generatrix else None}
                for name, case in name_cases(claim.name, found)
            ],
            "tables": [table._asdict() for table in found.tables],
            "growth": [_growth_as_json(series) for series in found.growth],
            "seconds": round(row.seconds, 3),
        }
    )


def _growth_as_json(series: Growth) -> dict[str, Any]:
    return {name: getattr(series, name) for name in ("what", "family", "varied", "bound")} | {
        "exponent": round(series.exponent(), 4),
        "claimed": round(series.claimed(), 4),
        "verdict": series.verdict,
        "points": [asdict(point) for point in series.points],
    }


def name_cases(name: str, found: Evidence) -> Iterator[tuple[str, Counterexample]]:
    for number, case in enumerate(found.cases, 1):
        stem = make_slug(name) + (f"-{number}" if number > 1 else "")
        yield f"counterexamples/{stem}.json", case


def write_data(folder: Path, rows: Sequence[Finding], effort: Effort) -> Path:
    """Write ledger.json, the CSV files and the counterexamples; return the path of ledger.json."""
    for name in ("tables", "counterexamples"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for row in rows:
        for number, table in enumerate(row.evidence.tables, 1):
            path = folder / "tables" / f"{make_slug(row.claim.name)}-{number}.csv"
            _write_csv(path, [table.header, *table.rows])
        for name, case in name_cases(row.claim.name, row.evidence):
            if case.generatrix:
                named = [
                    NamedPolygon(Polygon(case.generatrix), "G"),
                    NamedPolygon(Polygon(case.directrix), "D"),
                ]
                (folder / name).write_text(format_polygons(named, "json"), encoding="utf-8")
    growth = [(row.claim.name, series) for row in rows for series in row.evidence.growth]
    if growth:
        header = ("row", "what", "family", "m", "n", "count", "divided by", "bound")
        lines = (
            (name, s.what, s.family, p.m, p.n, p.count, s.bound, p.bound)
            for name, s in growth
            for p in s.points
        )
        _write_csv(folder / "tables" / "growth.csv", [header, *lines])
        costs = tabulate(s for name, s in growth if name.startswith("Corollary"))
        _write_csv(folder / "tables" / "exponents.csv", [costs.header, *costs.rows])
    path = folder / "ledger.json"
    text = json.dumps(as_json(rows, effort), indent=1, ensure_ascii=False)
    path.write_text(f"{text}\n", encoding="utf-8")
    return path


def _write_csv(path: Path, lines: Iterable[Sequence[object]]) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows(lines)
