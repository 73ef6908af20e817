"""Computation of pairs in a worker process."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from exactsweep.batch.parts import Part
from exactsweep.batch.record import Quantities, write_error_line, write_result_line
from exactsweep.formats.choice import choose
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind, parse_certificate, parse_json
from exactsweep.formats.files import decode_text
from exactsweep.formats.json_polygons import find_candidates
from exactsweep.formats.rounding import Rounding
from exactsweep.geometry.region import AnyPolygon
from exactsweep.numbers.error import ExactSweepError, prefix_errors, quote
from exactsweep.numbers.limits import Limits, get_limits, limits
from exactsweep.sweep import NoFitPolygon, Sweep, no_fit_polygon, sweep
from exactsweep.words import suggest

Names = dict[str, object]
_OPTIONS = ("direction", "reference")
_MEMBERS = ("id", "generatrix", "directrix", *_OPTIONS)


# The index of a pair, and its number among all pairs of parts or its line in a file of pairs.
NumberedPair = tuple[int, int | bytes]
Chunk = Sequence[NumberedPair]


class BatchError(ExactSweepError):
    """A batch that cannot run or resume; the message says why."""


@dataclass(frozen=True)
class Work:
    """The data of a batch, sent once to every worker."""

    what: Quantities
    generatrices: Sequence[Part]  # the moving parts, or all parts that a file of pairs may name
    directrices: Sequence[Part]  # the fixed parts; for a file of pairs, also all parts
    rounding: Rounding | None = None
    limits: Limits = field(default_factory=get_limits)

    def lines(self, chunk: Chunk) -> list[bytes]:
        return [self.line(index, pair) for index, pair in chunk]

    def line(self, index: int, pair: int | bytes) -> bytes:
        """Compute the record of a pair; any exception becomes an error record."""
        names: Names = {}
        try:
            if isinstance(pair, int):
                parts = self._parts(pair)
                names |= {role: part.name for role, part in parts.items()}
                result = self._result(*(_polygon(part, role) for role, part in parts.items()))
            else:
                with limits(**self.limits._asdict()):
                    result = self._read(pair, names)
            return write_result_line(index, names, result, self.what, self.rounding)
        except ValueError as error:
            reason = str(error)
        except RecursionError:
            reason = "nested too deeply"
        except MemoryError:
            reason = "out of memory"
        except Exception as error:  # a bug must not end the batch either
            reason = f"internal error: {type(error).__name__}: {error}"
        return write_error_line(index, names, reason)

    def format_lost_pair(self, index: int, pair: int | bytes) -> bytes:
        parts = self._parts(pair) if isinstance(pair, int) else {}
        names: Names = {role: part.name for role, part in parts.items()}
        reason = "every process that tried this pair was killed"
        return write_error_line(index, names, reason)

    def _parts(self, pair: int) -> dict[str, Part]:
        i, k = divmod(pair, len(self.directrices))
        return {"generatrix": self.generatrices[i], "directrix": self.directrices[k]}

    def _result(
        self, generatrix: AnyPolygon, directrix: AnyPolygon, **options: Any
    ) -> Sweep | NoFitPolygon:
        if self.what != "nfp":
            return sweep(generatrix, directrix, **options)
        if "direction" in options:
            raise FormatError("$.direction: not supported for no-fit polygons")
        return no_fit_polygon(directrix, generatrix, **options)

    def _read(self, line: bytes, names: Names) -> Sweep | NoFitPolygon:
        if not line:
            raise FormatError(f"the line is longer than {get_limits().max_mib:g} MiB (max_mib)")
        text = decode_text(line)
        document = parse_json(text)
        if not isinstance(document, dict):
            raise FormatError(f"$ is {describe_kind(document)}, not an object")
        if document.get("id") is not None:
            names |= _identity(text)
        for member in ("generatrix", "directrix"):
            if isinstance(document.get(member), str):
                names[member] = document[member]
        for member in document:
            if member not in _MEMBERS:
                raise FormatError(
                    f"$ has an unknown key {quote(member)}{suggest(member, _MEMBERS)}"
                )
        options: dict[str, Any] = {
            name: _pair(document[name], name) for name in _OPTIONS if document.get(name) is not None
        }
        polygons = [self._member(document, name) for name in ("generatrix", "directrix")]
        return self._result(*polygons, **options)

    def _member(self, document: Mapping[str, object], name: str) -> AnyPolygon:
        if name not in document:
            raise FormatError(f"$ has no {name}")
        value = document[name]
        if isinstance(value, str):
            if value not in self._by_name:
                near = suggest(value, self._by_name)
                raise FormatError(f"$.{name}: there is no part {quote(value)}{near}")
            return _polygon(self._by_name[value], name)
        with prefix_errors(name, FormatError):
            return choose(find_candidates(value), None).shape()

    @cached_property
    def _by_name(self) -> dict[str, Part]:
        return {part.name: part for part in self.generatrices}


def _polygon(part: Part, member: str) -> AnyPolygon:
    if isinstance(part.polygon, str):
        raise FormatError(f"{member}: {part.polygon}")
    return part.polygon


def _identity(text: str) -> Names:
    """Parse the id again, because `parse_json` turned integers into strings."""
    document = parse_certificate(text)
    assert isinstance(document, dict)
    identity = document["id"]
    if not isinstance(identity, (str, int)) or isinstance(identity, bool):
        raise FormatError(f"$.id is {describe_kind(identity)}, not a string or an integer")
    return {"id": identity}


def _pair(value: object, name: str) -> list[object]:
    if not isinstance(value, list) or len(value) != 2:
        raise FormatError(f"$.{name} is {describe_kind(value)}, not a pair of numbers")
    return value
