"""Peers: programs that answer cases."""

import time
import traceback
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import islice
from typing import Any, NamedTuple, Protocol

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.protocol import SUM, Hello, list_reflected_rings
from exactsweep.corpus import Case
from exactsweep.formats.exact_json import describe_kind
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.number import Point

SECONDS = 10.0  # default time limit of an answer
MAX_STDERR = 16384  # bytes kept from the end of standard error
_MAX_REASON = 200
_MAX_ITEMS = 10**6
Function = Callable[..., Any]


class Answer(NamedTuple):
    """The reply of a peer: a result to compare, or a verdict with its reason."""

    result: Mapping[str, Any] | None = None
    verdict: Verdict | None = None
    reason: str = ""
    seconds: float = 0.0
    memory: int | None = None
    stderr: str = ""


class Peer(Protocol):
    hello: Hello

    def ask(self, case: Case) -> Answer:
        pass


def read_answer(result: Mapping[str, Any]) -> Answer:
    for name, verdict in (("unsupported", Verdict.UNSUPPORTED), ("error", Verdict.CRASH)):
        if name in result:
            said = result[name]
            reason = said if isinstance(said, str) else describe_kind(said)
            return Answer(verdict=verdict, reason=f"says: {cut(reason)}")
    return Answer(result=result)


def cut(reason: str) -> str:
    """Shorten an untrusted message to one line without control characters.

    >>> cut("first   second ") + cut(chr(27))
    'first second�'
    """
    return replace_controls(" ".join(reason[:_MAX_REASON].split()))


def replace_controls(text: str) -> str:
    """Replace control characters in untrusted text, except line ends and tabs."""
    return "".join(
        c if c.isprintable() or c in "\n\t" else "\N{REPLACEMENT CHARACTER}" for c in text
    )


def make_plain(value: Any) -> Any:
    """Convert vertices and rings of any type to lists; leave other values unchanged."""
    if isinstance(value, Region):
        value = value.rings if value.holes else value.vertices
    elif isinstance(value, Polygon):
        value = value.vertices
    elif hasattr(value, "tolist"):
        value = value.tolist()
    elif hasattr(value, "__geo_interface__"):
        value = _list_rings(value.__geo_interface__)
    if isinstance(value, (str, bytes, Mapping)) or not isinstance(value, Iterable):
        return value
    # A generator may be infinite.
    return [make_plain(one) for one in islice(value, _MAX_ITEMS)]


def _list_rings(shape: Mapping[str, Any]) -> list[Any]:
    """List the rings of GeoJSON, without the points and segments of exact fits."""
    if "geometries" in shape:
        return [ring for one in shape["geometries"] for ring in _list_rings(one)]
    places = list(shape["coordinates"])
    if shape["type"] == "MultiPolygon":
        return [ring for polygon in places for ring in polygon]
    is_fit = shape["type"] in ("Point", "MultiPoint", "MultiLineString")
    return [] if is_fit or (shape["type"] == "LineString" and len(places) < 3) else places


class CallablePeer:
    """A function in this process, which cannot be stopped; a timeout is detected afterwards."""

    def __init__(self, function: Function, hello: Hello, seconds: float = SECONDS) -> None:
        self._function, self._seconds = function, seconds
        self.hello = hello

    def ask(self, case: Case) -> Answer:
        parts = self.hello.parts(case)
        rings = case.directrix_rings, case.generatrix_rings
        if self.hello.questions == (SUM,):
            rings = case.directrix_rings, list_reflected_rings(case)
        given: list[Any] = [list(map(self._points, shape)) for shape in rings]
        if self.hello.shapes != "any":
            # Without holes there is one ring.
            given = [shape[0] for shape in given]
        if self.hello.questions != (SUM,):
            given += self._points([case.reference])
        began = time.monotonic()
        try:
            result = self._function(*given)
            if len(parts) == 1 and not isinstance(result, Mapping):
                result = {parts[0]: result}
            if isinstance(result, Mapping):
                result = {name: make_plain(value) for name, value in result.items()}
        except NotImplementedError as error:
            return Answer(verdict=Verdict.UNSUPPORTED, reason=cut(str(error)))
        except (Exception, SystemExit) as error:
            reason = cut(f"{type(error).__name__}: {error}")
            seconds = time.monotonic() - began
            # The innermost frames identify the fault.
            said = traceback.format_exc()[-MAX_STDERR:]
            return Answer(verdict=Verdict.CRASH, reason=reason, seconds=seconds, stderr=said)
        seconds = time.monotonic() - began
        if seconds > self._seconds:
            reason = f"no answer within {self._seconds:g} s"
            return Answer(verdict=Verdict.TIMEOUT, reason=reason, seconds=seconds)
        if not isinstance(result, Mapping):
            reason = f"returns {type(result).__name__}, not a mapping"
            return Answer(verdict=Verdict.MALFORMED, reason=reason, seconds=seconds)
        return read_answer({**result, "id": case.id})._replace(seconds=seconds)

    def _points(self, points: Sequence[Point]) -> list[Any]:
        kinds: dict[str, Callable[[Fraction], object]] = {"rational": Fraction, "binary64": float}
        kind = kinds.get(self.hello.numbers, int)
        return [(kind(x), kind(y)) for x, y in points]
