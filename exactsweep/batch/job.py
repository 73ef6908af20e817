"""The pairs of a batch, in order."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from hashlib import sha256
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from exactsweep import __version__
from exactsweep.batch.parts import Part
from exactsweep.batch.record import QUANTITIES, Quantities
from exactsweep.batch.work import BatchError, Chunk, NumberedPair, Work
from exactsweep.formats.candidate import NamedPolygon
from exactsweep.formats.files import prefix_os_errors, show_path, split_lines
from exactsweep.formats.folder import make_unique
from exactsweep.formats.rounding import Rounding
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import explain_type_errors, quote
from exactsweep.numbers.limits import Limits, get_limits

CHUNK_PAIRS = 16  # for a small batch
_CHUNKS = 2**14  # maximum, since one process distributes them
_MAX_CHUNK_PAIRS = 512
_CHUNK_BYTES = 2**20


class Job(NamedTuple):
    """A batch: its work, the number of pairs, a digest of the input, and the file of pairs."""

    work: Work
    total: int
    digest: str
    path: str | None

    def chunks(self, start: int) -> Iterator[Chunk]:
        """Yield the pairs in order, beginning with index `start`."""
        most = min(max(CHUNK_PAIRS, self.total // _CHUNKS), _MAX_CHUNK_PAIRS)
        numbers = range(start, self.total)
        pairs: Iterable[int | bytes] = numbers
        if self.path is not None:
            pairs = islice(_lines(self.path), start, None)
        chunk: list[NumberedPair] = []
        size = 0
        for index, pair in zip(numbers, pairs, strict=False):
            chunk.append((index, pair))
            size += len(pair) if isinstance(pair, bytes) else 0
            if len(chunk) == most or size > _CHUNK_BYTES:
                yield chunk
                chunk, size = [], 0
        if chunk:
            yield chunk


@explain_type_errors
def take_all_pairs(
    generatrices: Iterable[NamedPolygon | Part],
    directrices: Iterable[NamedPolygon | Part],
    what: str = "loops",
    rounding: Rounding | None = None,
) -> Job:
    """Make a batch of all pairs from two part lists, with the generatrix in the outer loop.

    Args:
        generatrices: NamedPolygons, as from `read_polygons`, or Parts; repeated names get a number.
        directrices: as `generatrices`.
        what: "trajectory", "loops", "areas" or "nfp".
        rounding: writes rounded decimals instead of exact strings; None for no rounding.

    Raises:
        BatchError: unknown quantities.

    Example:
        >>> from exactsweep import Polygon
        >>> square = NamedPolygon(Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]), "square")
        >>> take_all_pairs([square], [square, square]).total
        2
    """
    work = Work(
        _require_known(what), _make_unique(generatrices), _make_unique(directrices), rounding
    )
    total = len(work.generatrices) * len(work.directrices)
    return Job(work, total, _digest_input(work, b"all pairs"), None)


@explain_type_errors
def take_listed_pairs(
    path: str,
    parts: Iterable[NamedPolygon | Part] = (),
    what: str = "loops",
    rounding: Rounding | None = None,
) -> Job:
    """Make a batch from a file of pairs, one JSON object per line.

    Args:
        path: a file of objects with "generatrix" and "directrix", each the name of a part, or a
            polygon as exact JSON or GeoJSON; optionally with "id", "reference", and (except for
            "nfp") "direction".
        parts: the parts that lines may name.
        what: as for `take_all_pairs`.
        rounding: as for `take_all_pairs`.

    Raises:
        BatchError: an unreadable file, two parts with the same name, or unknown quantities.

    Example:
        >>> from tempfile import TemporaryDirectory
        >>> from exactsweep import Polygon
        >>> square = Part("square", Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]))
        >>> with TemporaryDirectory() as folder:
        ...     file = Path(folder, "pairs.jsonl")
        ...     _ = file.write_text('{"generatrix": "square", "directrix": "square"}')
        ...     take_listed_pairs(str(file), [square]).total
        1
    """
    listed = _parts(parts)
    for name, count in Counter(part.name for part in listed).items():
        if count > 1:
            raise BatchError(f"{count} parts have the name {quote(name)}")
    seen, total = sha256(), 0
    for line in _lines(path):
        seen.update(line)
        total += 1
    work = Work(_require_known(what), listed, listed, rounding)
    return Job(work, total, _digest_input(work, seen.digest()), path)


def _require_known(what: str) -> Quantities:
    if what not in QUANTITIES:
        raise BatchError(f"{quote(what)} is not one of {', '.join(QUANTITIES)}")
    return what


def _parts(polygons: Iterable[NamedPolygon | Part]) -> Sequence[Part]:
    return tuple(
        Part(str(k) if p.name is None else p.name, p.polygon) for k, p in enumerate(polygons)
    )


def _make_unique(polygons: Iterable[NamedPolygon | Part]) -> Sequence[Part]:
    parts = _parts(polygons)
    names = make_unique([part.name for part in parts])
    return tuple(part._replace(name=name) for part, name in zip(parts, names, strict=True))


def _digest_input(work: Work, source: bytes) -> str:
    rounded = "" if work.rounding is None else f"{tuple(work.rounding)} "
    usual = Limits()._asdict()
    changed = {name: n for name, n in work.limits._asdict().items() if n != usual[name]}
    limited = f"{changed} " if changed else ""
    digest = sha256(f"{__version__} {work.what} {rounded}{limited}".encode() + source)
    for part in (*work.generatrices, None, *work.directrices):
        digest.update(repr(part and part.name).encode())
        if part is None or isinstance(part.polygon, str):
            digest.update(repr(part and part.polygon).encode())
        else:
            for k, ring in enumerate(part.polygon.rings):
                digest.update(b";" * (k > 0))
                for vertex in ring:
                    digest.update(" ".join(map(format_fraction, vertex)).encode() + b",")
    return digest.hexdigest()


def _lines(path: str) -> Iterator[bytes]:
    """Yield the nonblank lines of a file; b"" replaces a line that is too long."""
    with prefix_os_errors(path, BatchError):
        file = Path(path)
        if file.exists() and not file.is_file() and not file.is_dir():
            raise BatchError(
                f"{show_path(path)}: a pipe or a device cannot be read twice; save the pairs "
                "to a file"
            )
        with open(path, "rb") as lines:
            for line in split_lines(lines):
                if line.strip():
                    yield line if len(line) <= get_limits().max_bytes else b""
