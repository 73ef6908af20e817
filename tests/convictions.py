"""`python -m tests.convictions`: verdicts on faulty programs."""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import click

# The import path under pytest.
sys.path.insert(0, str(Path(__file__).parent / "support"))

from mistakes import MISTAKES, Mistake
from shipped_cases import shipped_cases
from spoiling import LOOPS, answer_exactly

from exactsweep import Point, Polygon
from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.rounding import grant_rounding
from exactsweep.conform.judge.verdict import Comparison, read_loop
from exactsweep.conform.run.protocol import UnsupportedError, adapt
from exactsweep.corpus import Case
from exactsweep.numbers.number import to_fraction


def list_cases() -> list[Case]:
    """List the shipped cases, small ones first, and two larger ones."""
    square = [(0, 0), (3, 0), (3, 3), (0, 3)]
    rounds = {n: [(k, k * k) for k in range(n)] for n in (60, 300)}
    own = [
        Case.of("many-vertices-of-d", "", rounds[300], square),
        Case.of("many-vertices-of-g", "", square, rounds[60]),
    ]
    return sorted([*shipped_cases(), *own], key=lambda case: (case.size, case.id))


class Judged(NamedTuple):
    """A wrong answer, judged."""

    case: Case
    found: Comparison

    def list_sayings(self) -> list[str]:
        """List the reasons, kinds and diagnoses in a comparison."""
        parts = self.found.parts
        return [self.found.reason, *(w for p in parts for w in (p.reason, p.kind, *p.diagnosis))]

    def is_right(self, mistake: Mistake) -> bool:
        """Decide whether the verdict is right and names the mistake."""
        is_named = any(re.search(mistake.says, words) for words in self.list_sayings())
        return self.found.verdict in mistake.verdicts and is_named


def judge_wrong_answers(name: str, cases: Iterable[Case]) -> Iterator[Judged]:
    """Judge exact answers after a mistake has changed them."""
    mistake = MISTAKES[name]
    hello, promised = mistake.hello, LOOPS if mistake.part == "trajectory" else ()
    for case in cases:
        try:
            put = adapt(case, hello)
            exact = answer_exactly(put, mistake.part)
            answer = mistake.change(put, exact)
        except (UnsupportedError, OverflowError):
            continue
        is_rounded = mistake.numbers == "binary64" and is_near(put, answer, exact)
        if answer and not is_rounded and not is_same(answer, exact):
            yield Judged(case, compare(put, answer, promised=promised, numbers=mistake.numbers))


def is_same(answer: dict[str, Any], exact: dict[str, Any]) -> bool:
    """Decide without the judge whether an answer is right, in any notation."""
    try:
        return {name: _forget_order(name, answer[name]) for name in exact} == {
            name: _forget_order(name, rings) for name, rings in exact.items()
        }
    except (ValueError, KeyError, TypeError):
        return False


def _forget_order(name: str, rings: Any) -> Any:
    if name.endswith("fits"):
        return {frozenset(Point(to_fraction(x), to_fraction(y)) for x, y in fit) for fit in rings}
    return sorted(Polygon(ring).vertices for ring in rings)


def is_near(case: Case, answer: Any, exact: dict[str, Any]) -> bool:
    """Decide whether the vertices of an answer in floats are within the permitted error."""
    return all(
        abs(to_fraction(a) - b)
        < grant_rounding(case, name, read_loop(answer[name], ""), "binary64")
        for name in LOOPS
        for ring, right in zip(answer[name], exact[name], strict=True)
        for p, q in zip(ring, right, strict=True)
        for a, b in zip(p, q, strict=True)
    )


@click.command()
@click.option(
    "--wrong",
    type=click.IntRange(min=1),
    default=20,
    help="Number of wrong answers of each program to judge; default: 20.",
)
def main(wrong: int) -> None:
    """Judge faulty programs on the shipped cases, and write the verdicts in Markdown.

    A row has the program, the verdicts on its wrong answers, and the most frequent diagnosis. The
    exit code is 1 if the judge accepts one of them, or gives another diagnosis.
    """
    chosen = list_cases()
    click.echo("| program | verdicts | diagnosis |")
    click.echo("|---|---|---|")
    failed = 0
    for name, mistake in MISTAKES.items():
        judged = [*islice(judge_wrong_answers(name, chosen), wrong)]
        verdicts = Counter(one.found.verdict.value for one in judged)
        diagnoses = Counter(
            next(words for words in one.list_sayings() if re.search(mistake.says, words) and words)
            for one in judged
            if one.is_right(mistake)
        )
        failed += len(judged) - diagnoses.total() + (not judged)
        listed = ", ".join(f"{number} {verdict}" for verdict, number in verdicts.most_common())
        words, _ = next(iter(diagnoses.most_common(1)), ("", 0))
        # The name comes before the description.
        click.echo(f"| {name} | {listed} | {words.partition(';')[0]} |")
    click.echo(f"\n{len(MISTAKES)} programs, {failed} answers misjudged.")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
