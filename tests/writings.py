"""`python -m tests.writings`: right answers in all notations, over the whole corpus."""

from __future__ import annotations

import sys
from pathlib import Path

import click

# Same import path as under pytest.
sys.path.insert(0, str(Path(__file__).parent / "support"))

from right_answers import WRITINGS, judge_writing

from exactsweep.corpus import cases


@click.command()
@click.option("--most", type=int, help="The most vertices of a case; any if left out.")
@click.option("--only", type=click.Choice([*WRITINGS]), multiple=True)
def main(most: int | None, only: tuple[str, ...]) -> None:
    """Judge right answers in all notations, and list those that are rejected.

    The exit code is 1 if there is one.
    """
    chosen, failed = list(cases(max_size=most)), 0
    for name, writing in WRITINGS.items():
        if only and name not in only:
            continue
        judged = judge_writing(writing, chosen)
        click.echo(f"{judged.number:6} {name}: {len(judged.convicted)} convicted")
        for one in judged.convicted[:5]:
            click.echo(f"       {one.case}, {one.part}: {one.verdict}, {one.reason}")
        failed += len(judged.convicted)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
