"""The runner, which asks cases and collects outcomes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.journal import Journal
from exactsweep.conform.run.outcome import Outcome, digest_case, judge_case, shrink_outcome
from exactsweep.conform.run.peer import SECONDS, CallablePeer, Function
from exactsweep.conform.run.pool import JudgeError, Judges
from exactsweep.conform.run.protocol import make_hello
from exactsweep.conform.run.run import Run
from exactsweep.conform.run.tally import ACCEPTED
from exactsweep.corpus import Case
from exactsweep.corpus.selection import require_distinct
from exactsweep.numbers.error import tells_arguments

TO_MAKE_SMALLER = 20.0
"""Time limit of the reduction of one failure, in seconds."""
MOST_TO_MAKE_SMALLER = 120.0
"""Time limit of all reductions, in seconds."""


def judge_cases(
    run: Run,
    judges: Judges,
    cases: Iterable[Case],
    *,
    journal: Journal | None = None,
    tell: Callable[[], None] = lambda: None,
    made_smaller: int = 0,
) -> None:
    """Ask a program cases and collect the outcomes.

    Cases in the journal are not asked again. Ctrl-C and a case that cannot be judged end the run
    early; the outcomes so far are kept.

    Args:
        run: collects the outcomes.
        judges: the program.
        cases: the cases.
        journal: the file that records each outcome at once.
        tell: a function to call after each outcome.
        made_smaller: the number of failures of each fault to shrink.
    """

    def skip_old(cases: Iterable[Case]) -> Iterator[Case]:
        for case in cases:
            old = journal and journal.find(digest_case(case))
            if old:
                run.add(old)
                tell()
            else:
                yield case

    try:
        for outcome in judges.judge(skip_old(cases)):
            if journal:
                journal.add(outcome)
            run.add(outcome)
            tell()
        failures = run.to_be_smaller(made_smaller)
        for id, smallest in judges.shrink(failures, _share_time(failures)):
            run.add_smaller(id, smallest)
        judges.finish()
        run.complaints += judges.complaints
    except JudgeError as error:
        run.complaints.append(str(error))
        run.interrupted = True
    except KeyboardInterrupt:
        run.interrupted = True


def _share_time(failures: Sequence[Outcome]) -> float:
    return min(TO_MAKE_SMALLER, MOST_TO_MAKE_SMALLER / max(1, len(failures)))


@tells_arguments
def conform(
    function: Function,
    cases: Iterable[Case],
    *,
    name: str,
    loops: Iterable[str] = ("trajectory",),
    numbers: str = "rational",
    reference: str = "given",
    questions: Iterable[str] = ("sweep",),
    shapes: str = "monotone",
    seconds: float = SECONDS,
    accepted: Verdict = ACCEPTED,
    made_smaller: int = 0,
) -> Run:
    """Judge a Python function by exact answers, in this process.

    Args:
        function: of directrix, generatrix and reference: lists of (x, y), and (x, y); int for the
            integer numbers, float for "binary64", else Fraction; if `shapes` is "any", polygons are
            lists of rings, the exterior first. If "minkowski_sum" is the only question, it gets a
            and b instead. It returns the members of an answer of the protocol without the id, or
            the only member; vertices in any form that `make_plain` reads, numbers as `to_fraction`
            reads them. An exception is a crash; NotImplementedError is unsupported.
        cases: the cases.
        name: of the program.
        loops: as for `Hello`, likewise the next four.
        numbers: the numbers that the function gets.
        reference: the point of G whose path it answers.
        questions: its questions.
        shapes: the pairs that it accepts.
        seconds: the time limit of an answer. A function cannot be stopped: the verdict timeout
            comes with the late answer.
        accepted: the worst verdict that passes; with Verdict.EQUIVALENT, lost exact fits fail.
        made_smaller: the number of failures of each fault to shrink.

    Returns:
        A Run; `exactsweep.conform.report` writes it for people and for CI.

    Raises:
        ProtocolError: the loops, numbers, reference, questions or shapes are invalid.
        SelectionError: two cases have the same id.

    Example:
        >>> from exactsweep import no_fit_polygon
        >>> from exactsweep.corpus import Case
        >>> def mine(directrix, generatrix, reference):
        ...     return {"trajectory": no_fit_polygon(directrix, generatrix).exterior.vertices}
        >>> triangle = Case.of("t", "", [(0, 0), (1, 0), (0, 1)], [(0, 0), (1, 0), (0, 1)], (1, 0))
        >>> conform(mine, [triangle], name="mine", reference="origin").passed
        True
        >>> run = conform(mine, [triangle], name="mine", made_smaller=1)
        >>> run.passed, run.outcomes[0].verdict.value, run.shrunk["t"].case["reference"]
        (False, 'wrong', ['1', '0'])
    """
    said = {"hello": name, "loops": loops, "numbers": numbers, "reference": reference}
    hello = make_hello({**said, "questions": tuple(questions), "shapes": shapes})
    peer = CallablePeer(function, hello, seconds)
    run = Run(peer.hello, accepted=accepted)
    for case in require_distinct(cases):
        run.add(judge_case(peer, case))
    failures = run.to_be_smaller(made_smaller)
    for outcome in failures:
        run.add_smaller(outcome.id, shrink_outcome(peer, outcome, _share_time(failures)))
    return run
