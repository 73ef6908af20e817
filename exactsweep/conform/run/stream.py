"""Answers from a pipe: `generator | program | exactsweep judge`.

The cases are not adapted, so the program reads rationals. It may use another reference point.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import BinaryIO

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome, judge_answer
from exactsweep.conform.run.peer import Answer, read_answer
from exactsweep.conform.run.protocol import ProtocolError, adapt, read_hello, read_reply
from exactsweep.corpus import Case
from exactsweep.formats.exact_json import describe_kind
from exactsweep.formats.files import split_lines
from exactsweep.numbers.error import quote

_MAX_COMPLAINTS = 20


class Stream:
    """The output of a program: a hello, then answers, one per line."""

    def __init__(self, file: BinaryIO) -> None:
        # A line that is too long is truncated, which makes it invalid.
        self._lines = (line.decode("utf-8", "replace").rstrip("\n") for line in split_lines(file))
        self.complaints: list[str] = []
        hello = next(self._lines, None)
        if hello is None:
            raise ProtocolError("no hello: the input is empty")
        self.hello = read_hello(hello)
        self._seen: set[str] = set()

    def outcomes(self, find: Callable[[str], Case]) -> Iterator[Outcome]:
        """Yield the outcomes of the answers; `find` returns a case by its id."""
        terms = replace(self.hello, numbers="rational")
        for number, line in enumerate(self._lines, 2):
            try:
                result = read_reply(line)
                case = self._case(result["id"], find)
                put = adapt(case, terms)
                outcome = judge_answer(case, put, read_answer(result), self.hello)
            except ValueError as error:
                if len(self.complaints) < _MAX_COMPLAINTS:
                    self.complaints.append(f"line {number}: {error}")
                continue
            yield outcome

    def unanswered(self, cases: Iterable[Case]) -> Iterator[Outcome]:
        answer = Answer(verdict=Verdict.CRASH, reason="no answer")
        for case in cases:
            if case.id not in self._seen:
                yield judge_answer(case, case, answer, self.hello)

    def _case(self, id: object, find: Callable[[str], Case]) -> Case:
        if not isinstance(id, str):
            raise ProtocolError(f'"id" is {describe_kind(id)}, not the id of a case')
        case = find(id)
        if id in self._seen:
            raise ProtocolError(f"second answer to {quote(id)}")
        self._seen.add(id)
        return case
