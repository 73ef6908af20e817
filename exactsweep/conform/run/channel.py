"""Exchange of lines with an untrusted process, with limits on time and memory."""

import os
import selectors
import signal
import time
from collections.abc import Sequence
from contextlib import suppress
from typing import IO

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.peer import MAX_STDERR
from exactsweep.numbers.limits import get_limits
from exactsweep.processes import ChildProcess

_CHUNK = 65536
_LAST_CHUNKS = 16
_POLL_SECONDS = 0.2  # between checks of memory and exit
_EXIT_SECONDS = 1.0  # for the exit after a process closes its output


class ChannelError(Exception):
    """A missing line; the message gives the reason, and `verdict` the verdict."""

    verdict = Verdict.MALFORMED


class SilentError(ChannelError):
    verdict = Verdict.TIMEOUT


class ClosedError(ChannelError):
    verdict = Verdict.CRASH


class LongLineError(ChannelError):
    """A line has more bytes than `limits` allow."""


class LargeError(ChannelError):
    verdict = Verdict.MEMORY


class Channel:
    """A process that exchanges lines; `limits` and MAX_STDERR bound its buffers."""

    def __init__(self, command: Sequence[str], most: int | None = None) -> None:
        self._most = most
        self.peak: int | None = None
        self._started = ChildProcess(command)
        process = self._started.process
        self._selector = selectors.DefaultSelector()
        self._incoming, self._searched = bytearray(), 0
        self._outgoing, self._closing = bytearray(), False
        self._stderr = b""
        self._stdin = self._watch(process.stdin, None)
        self._stdout = self._watch(process.stdout, selectors.EVENT_READ)
        self._errors = self._watch(process.stderr, selectors.EVENT_READ)

    @property
    def stderr(self) -> str:
        return self._stderr.decode("utf-8", "replace")

    def send(self, line: str) -> None:
        """Queue a line, which `receive` writes while it waits, and reset the peak."""
        self._outgoing += line.encode() + b"\n"
        self._started.reset_peak()
        self.peak = None

    def receive(self, seconds: float) -> str:
        """Wait for a line, and replace invalid UTF-8; raise a ChannelError if there is none."""
        now = time.monotonic()
        deadline, look = now + seconds, now + _POLL_SECONDS
        while True:
            line = self._take()
            if line is not None:
                self._weigh()
                return line.decode("utf-8", "replace")
            now = time.monotonic()
            if now >= look:
                self._weigh()
                look = now + _POLL_SECONDS
            if now >= deadline:
                raise SilentError(f"within {seconds:g} s")
            self._transfer(deadline - now)

    def finish(self, line: str, seconds: float) -> str | None:
        """Send a last line, wait for the exit and kill all descendants; return any complaint."""
        self.send(line)
        self._closing = True
        try:
            said = self.receive(seconds)
        except SilentError:
            return f"did not exit within {seconds:g} s after bye"
        except LongLineError:
            return "kept writing after bye"
        except ClosedError:
            code = self._started.wait(seconds)
            if code is None:
                return f"closed its output, but did not exit within {seconds:g} s after bye"
            return None if code == 0 else f"after bye, {describe_exit(code)}"
        finally:
            self.kill()
        return f"kept writing after bye: {said[:40]!r}"

    def kill(self) -> None:
        self._selector.close()
        self._started.end()

    def _watch(self, pipe: IO[bytes] | None, event: int | None) -> int:
        assert pipe is not None
        os.set_blocking(pipe.fileno(), False)
        if event is not None:
            self._selector.register(pipe.fileno(), event)
        return pipe.fileno()

    def _weigh(self) -> None:
        peak = self._started.read_peak()
        if peak is not None and not self._closing:
            self.peak = max(peak, self.peak or 0)
            if self._most is not None and self.peak > self._most:
                raise LargeError(f"uses more than {self._most / 2**20:.1f} MiB")

    def _take(self) -> bytes | None:
        end = self._incoming.find(b"\n", self._searched)
        if (end if end >= 0 else len(self._incoming)) > get_limits().max_bytes:
            raise LongLineError(f"a line of more than {get_limits().max_mib:g} MiB (max_mib)")
        if end < 0:
            self._searched = len(self._incoming)
            return None
        line = bytes(self._incoming[:end])
        del self._incoming[: end + 1]
        self._searched = 0
        return line

    def _transfer(self, seconds: float) -> None:
        """Transfer what the pipes accept now, without blocking."""
        if self._outgoing:
            with suppress(KeyError):
                self._selector.register(self._stdin, selectors.EVENT_WRITE)
        had_ended = self._started.process.poll() is not None
        ready = self._selector.select(min(seconds, _POLL_SECONDS))
        if had_ended and not ready:
            # A descendant still holds its output open.
            raise ClosedError(self._end())
        for key, _ in ready:
            if key.fd == self._stdin:
                self._write()
            elif key.fd == self._errors:
                self._stderr = (self._stderr + self._read(key.fd))[-MAX_STDERR:]
            else:
                chunk = self._read(key.fd)
                if not chunk:
                    raise ClosedError(self._end())
                self._incoming += chunk

    def _write(self) -> None:
        try:
            del self._outgoing[: os.write(self._stdin, self._outgoing[:_CHUNK])]
        except BrokenPipeError:
            # It may still answer an earlier line.
            self._outgoing.clear()
        if not self._outgoing:
            self._selector.unregister(self._stdin)
            if self._closing:
                assert self._started.process.stdin is not None
                self._started.process.stdin.close()

    def _read(self, fd: int) -> bytes:
        chunk = os.read(fd, _CHUNK)
        if not chunk:
            self._selector.unregister(fd)
        return chunk

    def _end(self) -> str:
        code = self._started.wait(_EXIT_SECONDS)
        # The pipe still contains its last output; a descendant may still be writing.
        with suppress(OSError, KeyError):
            for _ in range(_LAST_CHUNKS):
                self._stderr = (self._stderr + self._read(self._errors))[-MAX_STDERR:]
        return "closed its output" if code is None else describe_exit(code)


def describe_exit(code: int) -> str:
    """Describe how a process ended.

    >>> describe_exit(3), describe_exit(-11)
    ('exited with code 3', 'was killed by signal 11, SIGSEGV')
    """
    if code >= 0:
        return f"exited with code {code}"
    try:
        name = f", {signal.Signals(-code).name}"
    except ValueError:
        name = ""
    return f"was killed by signal {-code}{name}"
