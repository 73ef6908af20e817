"""Answers from a pipe: `gen | implementation | exactsweep judge`.

A pipe does not convert the cases for the implementation, which reads them as they were
written, with rationals, but is free to refer its trajectory to another reference point.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import BinaryIO

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome, judge_answer
from exactsweep.conform.run.peer import Answer, read_answer
from exactsweep.conform.run.protocol import ProtocolError, adapt, read_hello, read_object
from exactsweep.corpus import Case
from exactsweep.formats.exact_json import describe_kind
from exactsweep.formats.files import split_lines
from exactsweep.numbers.error import quote

_MOST_COMPLAINTS = 20


class Stream:
    """The output of an implementation: a hello, then answers, a line each.

    Args:
        file: where it is read from.

    Attributes:
        hello: the implementation's hello.
        complaints: list of lines on what was no answer to any case, or could not be judged; the
            first of them.

    Raises:
        ProtocolError: the first line is no hello.
    """

    def __init__(self, file: BinaryIO) -> None:
        # Of a line that is too long this is the start, which is no JSON.
        self._lines = (line.decode("utf-8", "replace").rstrip("\n") for line in split_lines(file))
        self.complaints: list[str] = []
        hello = next(self._lines, None)
        if hello is None:
            raise ProtocolError("no hello: the input is empty")
        self.hello = read_hello(hello)
        self._seen: set[str] = set()

    def outcomes(self, find: Callable[[str], Case]) -> Iterator[Outcome]:
        """Judge the answers as they come.

        Args:
            find: gives the case of an id, or raises UnknownNameError.

        Returns:
            An iterator of Outcome.
        """
        terms = replace(self.hello, numbers="rational")
        for number, line in enumerate(self._lines, 2):
            try:
                result = read_object(line)
                if "id" not in result:
                    raise ProtocolError('the answer has no "id"')
                case = self._case(result["id"], find)
                put = adapt(case, terms)
                outcome = judge_answer(case, put, read_answer(result), self.hello)
            except ValueError as error:
                if len(self.complaints) < _MOST_COMPLAINTS:
                    self.complaints.append(f"line {number}: {error}")
                continue
            yield outcome

    def unanswered(self, cases: Iterable[Case]) -> Iterator[Outcome]:
        """Yield an outcome for each case that has no answer, once all answers have been read."""
        answer = Answer(verdict=Verdict.CRASH, reason="no answer")
        for case in cases:
            if case.id not in self._seen:
                yield judge_answer(case, case, answer, self.hello)

    def _case(self, id: object, find: Callable[[str], Case]) -> Case:
        if not isinstance(id, str):
            raise ProtocolError(f'"id" is {describe_kind(id)}, not the id of a case')
        case = find(id)
        if id in self._seen:
            raise ProtocolError(f"answers {quote(id)} a second time")
        self._seen.add(id)
        return case
