"""Processes that speak the protocol."""

import time
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run import protocol
from exactsweep.conform.run.channel import Channel, ChannelError, ClosedError, SilentError
from exactsweep.conform.run.fault import find_error
from exactsweep.conform.run.peer import SECONDS, Answer, cut, read_answer
from exactsweep.conform.run.protocol import Hello, ProtocolError
from exactsweep.corpus import Case
from exactsweep.formats.exact_json import describe_kind
from exactsweep.numbers.error import quote

START_SECONDS = 30.0  # until the hello
EXIT_SECONDS = 2.0  # until the exit after bye


class Terms(NamedTuple):
    command: Sequence[str]
    seconds: float = SECONDS
    rounding: Fraction | None = None
    most: int | None = None


class ProcessPeer:
    """A process that speaks the protocol; restarted after each failure."""

    def __init__(self, terms: Terms, to_start: float = START_SECONDS) -> None:
        self.terms, self._to_start = terms, to_start
        self._channel: Channel | None = None
        self.hello = self._start()

    def ask(self, case: Case) -> Answer:
        try:
            if self._channel is None and self._start() != self.hello:
                self.kill()
                raise ProtocolError("the hello changed after a restart")
        except ProtocolError as error:
            return Answer(verdict=Verdict.CRASH, reason=f"cannot be restarted: {error}")
        channel = self._channel
        assert channel is not None
        began = time.monotonic()
        answer = self._exchange(channel, case)
        return answer._replace(seconds=time.monotonic() - began, memory=channel.peak)

    def close(self) -> str | None:
        """Send bye, wait for the exit or kill the process; return a complaint, if any."""
        channel, self._channel = self._channel, None
        if channel is None:
            return None
        complaint = channel.finish(protocol.BYE, EXIT_SECONDS)
        return complaint and _with_last_words(complaint, channel)

    def kill(self) -> None:
        if self._channel is not None:
            self._channel.kill()
            self._channel = None

    def _exchange(self, channel: Channel, case: Case) -> Answer:
        channel.send(protocol.write_case_line(case, self.hello))
        try:
            result = protocol.read_reply(channel.receive(self.terms.seconds))
            if result["id"] != case.id:
                raise ProtocolError(f"answers {describe_kind(result['id'])}, which was not sent")
            return read_answer(result)
        except ChannelError as error:
            verdict, reason = error.verdict, str(error)
            if isinstance(error, SilentError):
                reason = f"no answer {reason}"
            elif isinstance(error, ClosedError):
                reason = _with_last_words(reason, channel)
        except ProtocolError as error:
            verdict, reason = Verdict.MALFORMED, str(error)
        self.kill()
        return Answer(verdict=verdict, reason=reason, stderr=channel.stderr)

    def _start(self) -> Hello:
        try:
            channel = self._channel = Channel(self.terms.command, self.terms.most)
        except (OSError, ValueError) as error:
            reason = getattr(error, "strerror", None) or error
            raise ProtocolError(f"cannot run {quote(self.terms.command[0])}: {reason}") from None
        try:
            return protocol.read_hello(channel.receive(self._to_start))
        except (KeyboardInterrupt, SystemExit):
            self.kill()
            raise
        except SilentError as error:
            reason = f"no hello {error}; does the program flush its output?"
        except ChannelError as error:
            reason = f"no hello: {error}"
        except ProtocolError as error:
            reason = str(error)
        self.kill()
        raise ProtocolError(_with_last_words(reason, channel))


def _with_last_words(reason: str, channel: Channel) -> str:
    said = find_error(channel.stderr)
    return f"{reason}; it says: {cut(said)}" if said else reason
