"""The table of hostile inputs in tests/README.md says how many each entry point is tried with."""

from pathlib import Path

TABLE = (Path(__file__).parents[1] / "README.md").read_text()


def require_row(entry: str, count: int) -> None:
    """Require that a row of the table says so."""
    assert f"| {entry} | {count:,} |" in TABLE, (entry, count)
