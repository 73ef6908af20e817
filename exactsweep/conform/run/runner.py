"""The runner: cases in, outcomes out, kept as they come."""

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
"""Seconds that may be spent on one failure to find a smaller one like it."""
MOST_TO_MAKE_SMALLER = 120.0
"""Seconds that may be spent so on all of them."""


def judge_cases(
    run: Run,
    judges: Judges,
    cases: Iterable[Case],
    *,
    journal: Journal | None = None,
    tell: Callable[[], None] = lambda: None,
    made_smaller: int = 0,
) -> None:
    """Put cases to an implementation and collect the outcomes.

    Cases that are in the journal already are not asked again. Ctrl-C ends the run early, and so
    does a case that cannot be judged; the outcomes so far are kept.

    Args:
        run: where the outcomes go.
        judges: the implementation.
        cases: the cases.
        journal: the file that records each outcome at once.
        tell: a function to call after each outcome.
        made_smaller: the number of failures of each fault to shrink.
    """

    def leave_out_old(cases: Iterable[Case]) -> Iterator[Case]:
        for case in cases:
            old = journal and journal.find(digest_case(case))
            if old:
                run.add(old)
                tell()
            else:
                yield case

    try:
        for outcome in judges.judge(leave_out_old(cases)):
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
    """The seconds that may be spent on one of some failures to find a smaller one like it."""
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
            integer numbers, float for "binary64", else Fraction; polygons as lists of rings, the
            exterior first, where `shapes` is "any". If "minkowski_sum" is the only question it gets
            a and b instead. It returns the members of an answer of the protocol, without the id; or
            the only one. Vertices are in any form that `make_plain` takes, and coordinates any
            numbers that `to_fraction` reads. An exception is a crash, NotImplementedError is
            unsupported.
        cases: the cases.
        name: of the implementation.
        loops: the loops that it answers, of "trajectory", "inner", "outer".
        numbers: "rational", "integer", "int64", "int32" or "binary64", as for `Hello`.
        reference: "given", "origin" or "first", as for `Hello`.
        questions: its questions, of "sweep", "no_fit", "minkowski_sum", "inner_fit".
        shapes: the pairs that it takes: "convex", "monotone", "simple" or "any".
        seconds: that an answer may take. A function cannot be stopped: an answer that comes too
            late is a timeout when it comes.
        accepted: the worst verdict that passes; Verdict.EQUIVALENT makes exact fits count, too.
        made_smaller: the number of failures of each fault to shrink.

    Returns:
        A Run; `exactsweep.conform.report` writes it for people and for CI.

    Raises:
        ProtocolError: the loops, numbers or reference are none of those.
        SelectionError: two cases have the same id.

    Cost: for each case that of the function and of `compare`, and O(m + n) besides.

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
