"""The runner, which sends cases and collects outcomes."""

from collections.abc import Callable, Iterable, Iterator, Sequence

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.journal import Journal
from exactsweep.conform.run.outcome import Outcome, digest_case, judge_case, shrink_outcome
from exactsweep.conform.run.peer import SECONDS, CallablePeer, Function
from exactsweep.conform.run.pool import JudgeError, Judges
from exactsweep.conform.run.protocol import make_hello
from exactsweep.conform.run.run import ACCEPTED, Run
from exactsweep.corpus import Case
from exactsweep.corpus.selection import require_distinct
from exactsweep.numbers.error import explain_type_errors

SHRINK_SECONDS = 20.0  # for shrinking one failure
MAX_SHRINK_SECONDS = 120.0  # for shrinking all failures


def judge_cases(
    run: Run,
    judges: Judges,
    cases: Iterable[Case],
    *,
    journal: Journal | None = None,
    report: Callable[[], None] = lambda: None,
    made_smaller: int = 0,
) -> None:
    """Send cases to a program and collect the outcomes; skip cases in the journal.

    Ctrl-C and a case that cannot be judged end the run early; the outcomes so far are kept.
    """

    def skip_old(cases: Iterable[Case]) -> Iterator[Case]:
        for case in cases:
            old = journal and journal.find(digest_case(case))
            if old:
                run.add(old)
                report()
            else:
                yield case

    try:
        for outcome in judges.judge(skip_old(cases)):
            if journal:
                journal.add(outcome)
            run.add(outcome)
            report()
        failures = run.list_shrinkable(made_smaller)
        for id, smallest in judges.shrink(failures, _share_time(failures)):
            run.add_shrunk(id, smallest)
        judges.finish()
        run.complaints += judges.complaints
    except JudgeError as error:
        run.complaints.append(str(error))
        run.interrupted = True
    except KeyboardInterrupt:
        run.interrupted = True


def _share_time(failures: Sequence[Outcome]) -> float:
    return min(SHRINK_SECONDS, MAX_SHRINK_SECONDS / max(1, len(failures)))


@explain_type_errors
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
    """Judge a Python function against exact answers, in this process.

    Args:
        function: takes the directrix and the generatrix, each a list of (x, y), or a list of rings
            if `shapes` is "any"; and the reference point (x, y). If "minkowski_sum" is the only
            question, it takes a and b instead. Coordinates are int, float or Fraction, depending on
            `numbers`. It returns an answer as in the protocol, without the id; an answer with one
            member may also be the value of that member. Vertices may have any type that
            `make_plain` reads. An exception is a crash; NotImplementedError means unsupported.
        cases: the cases to judge.
        name: the name of the program.
        loops: as for `Hello`, like the next four.
        numbers: the numbers that the function takes.
        reference: its reference point of G.
        questions: the questions that it answers.
        shapes: the pairs that it accepts.
        seconds: the time limit of an answer; a function is not stopped.
        accepted: the worst verdict that passes.
        made_smaller: the number of failures of each fault to shrink.

    Returns:
        A Run; `exactsweep.conform.report` writes reports of it.

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
    failures = run.list_shrinkable(made_smaller)
    for outcome in failures:
        run.add_shrunk(outcome.id, shrink_outcome(peer, outcome, _share_time(failures)))
    return run
