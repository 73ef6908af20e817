"""The outcome of one case, for journals and reports."""

import hashlib
import json
import signal
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from fractions import Fraction
from typing import Any, NoReturn, Self

from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.verdict import Comparison, Verdict
from exactsweep.conform.run.fault import mask_numbers, name_fault
from exactsweep.conform.run.peer import Answer, Peer
from exactsweep.conform.run.protocol import Hello, UnsupportedError, adapt
from exactsweep.conform.run.shrink import shrink
from exactsweep.corpus import Case, case_from_json, case_to_json
from exactsweep.numbers.error import ExactSweepError

COMPARE_SECONDS = 60.0  # CPU seconds per comparison; work bounds usually stop it earlier
_MAX_RESULT = 65536  # maximum length of a stored answer, in characters


@dataclass(frozen=True)
class Outcome:
    """The outcome of one case. Exact, equivalent and unsupported answers are not stored."""

    id: str
    kind: str
    flags: tuple[str, ...]
    verdict: Verdict
    reason: str = ""  # one line
    fault: str = ""  # by `name_fault`
    diagnosis: tuple[str, ...] = ()  # of the worst part
    seconds: float = 0.0  # until the answer
    memory: int | None = None  # the program's peak in bytes, if known
    digest: str = ""  # of the original case
    parts: tuple[Mapping[str, Any], ...] = ()  # by `PartComparison.to_json`
    case: Mapping[str, Any] | None = None  # the adapted case by `case_to_json`
    result: Mapping[str, Any] | None = None  # the answer; None if it is too long
    stderr: str = ""  # the last lines, if the program failed

    def to_json(self) -> dict[str, Any]:
        """Return plain data without empty members."""
        return {name: value for name, value in asdict(self).items() if value not in ("", (), None)}

    @property
    def size(self) -> int:
        """The number of vertices of D and G without holes; 0 without a case."""
        return len(self.case["directrix"]) + len(self.case["generatrix"]) if self.case else 0

    @property
    def worst(self) -> Mapping[str, Any] | None:
        """The first part with the worst verdict; None if there are no parts."""
        return max(self.parts, key=lambda part: Verdict(part["verdict"]).severity, default=None)

    def lead_with(self, cause: str | None) -> Self:
        """Move a diagnosis to the front; return the outcome unchanged if it lacks the diagnosis."""
        if cause not in self.diagnosis[1:]:
            return self
        first, parts = self.diagnosis[0], []
        for part in self.parts:
            said = part["diagnosis"]
            if cause in said:
                others = [words for words in said if words != cause]
                reason = part["reason"].replace(said[0], cause)
                part = {**part, "diagnosis": [cause, *others], "reason": reason}
            parts.append(part)
        return replace(
            self,
            reason=self.reason.replace(first, cause),
            fault=self.fault.replace(mask_numbers(first), mask_numbers(cause)),
            diagnosis=(cause, *(words for words in self.diagnosis if words != cause)),
            parts=tuple(parts),
        )


def outcome_from_json(data: Mapping[str, Any]) -> Outcome:
    try:
        parts = {**data, "verdict": Verdict(data["verdict"])}
        for name in ("flags", "parts", "diagnosis"):
            parts[name] = tuple(data.get(name, ()))
        return Outcome(**parts)
    except (KeyError, TypeError) as error:
        raise ExactSweepError(f"invalid outcome: {error}") from None


def list_witnesses(part: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [part[name] for name in ("unsound", "conservative") if part[name]]


def judge_case(peer: Peer, case: Case, rounding: Fraction | None = None) -> Outcome:
    return judge_answer(case, *ask(peer, case), peer.hello, rounding)


def ask(peer: Peer, case: Case) -> tuple[Case, Answer]:
    try:
        put = adapt(case, peer.hello)
    except UnsupportedError as error:
        return case, Answer(verdict=Verdict.UNSUPPORTED, reason=str(error))
    return put, peer.ask(put)


def judge_answer(
    case: Case, put: Case, answer: Answer, hello: Hello, rounding: Fraction | None = None
) -> Outcome:
    """Judge the answer to `put`, the adapted case; `rounding` as for `compare`."""
    if answer.result is None:
        assert answer.verdict is not None
        comparison = Comparison(case.id, answer.verdict, answer.reason)
    else:
        promised = hello.parts(case)
        comparison = compare_in_time(
            put, answer.result, rounding=rounding, promised=promised, numbers=hello.numbers
        )
    verdict = comparison.verdict
    kept = verdict not in (Verdict.EXACT, Verdict.EQUIVALENT, Verdict.UNSUPPORTED)
    parts = tuple(part.to_json() for part in comparison.parts) if kept else ()
    return Outcome(
        id=case.id,
        kind=case.kind,
        flags=case.flags,
        digest=digest_case(case),
        verdict=verdict,
        reason=comparison.reason,
        fault=name_fault(verdict, comparison.reason, parts, answer.stderr, case.id),
        diagnosis=comparison.worst.diagnosis if kept and comparison.worst else (),
        seconds=round(answer.seconds, 6),
        memory=answer.memory,
        parts=parts,
        case=case_to_json(put) if kept else None,
        result=_plain(answer.result) if kept and answer.result is not None else None,
        stderr=answer.stderr,
    )


def compare_in_time(case: Case, result: object, **options: Any) -> Comparison:
    """Compare an answer; in the main thread, give up after COMPARE_SECONDS seconds."""
    try:
        with stop_after(COMPARE_SECONDS):
            return compare(case, result, **options)
    except OvertimeError:
        reason = f"comparing the answer takes more than {COMPARE_SECONDS:g} s"
        return Comparison(case.id, Verdict.UNDECIDED, reason)


class OvertimeError(Exception):
    pass


@contextmanager
def stop_after(seconds: float) -> Iterator[None]:
    """Raise OvertimeError in a `with` block of the main thread after the given CPU time.

    >>> with stop_after(0.01):
    ...     while True:
    ...         pass
    Traceback (most recent call last):
    exactsweep.conform.run.outcome.OvertimeError
    """
    is_main = threading.current_thread() is threading.main_thread()
    if not (hasattr(signal, "SIGPROF") and is_main):  # Windows
        yield
        return

    def stop(number: int, frame: object) -> NoReturn:
        raise OvertimeError

    old = signal.signal(signal.SIGPROF, stop)
    try:
        signal.setitimer(signal.ITIMER_PROF, seconds)
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, old)


def shrink_outcome(
    peer: Peer, outcome: Outcome, seconds: float, rounding: Fraction | None = None
) -> Outcome:
    """Search for a smaller case with the same fault in limited time; return its outcome."""

    def judge(case: Case) -> Outcome:
        return judge_case(peer, case, rounding)

    case = case_from_json(outcome.case)
    return judge(shrink(case, lambda case: judge(case).fault, seconds=seconds))


def digest_case(case: Case) -> str:
    text = json.dumps(case_to_json(case), sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _plain(result: Mapping[str, Any]) -> Mapping[str, Any] | None:
    text = json.dumps(result, default=str)
    return json.loads(text) if len(text) <= _MAX_RESULT else None
