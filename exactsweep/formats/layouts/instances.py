"""Nesting instances, and their parts as polygons."""

from functools import partial

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.exact_json import read_number, read_vertices
from exactsweep.formats.layouts import cgshop, jagua, packingsolver
from exactsweep.formats.layouts.model import NestingInstance
from exactsweep.formats.node import Data, JsonNode
from exactsweep.formats.reading import Reading


def read_instance(document: JsonNode, reading: Reading) -> NestingInstance | None:
    if document.has("item_types"):
        return packingsolver.read_instance(document, reading)
    if document.get("type", "").value == "cgshop2024_instance":
        return cgshop.read_instance(document)
    return jagua.read_instance(document) if document.has("items") else None


def read_parts(document: object, reading: Reading) -> list[Candidate] | None:
    found = read_instance(JsonNode(document), reading)
    if found is None:
        return None
    reading.notes |= dict.fromkeys(found.notes)
    return [_make_candidate(name, part) for name, part in found.parts.items()]


def _make_candidate(name: str, part: Data) -> Candidate:
    place = f"item {name}"
    rings = [part["exterior"], *part.get("holes", [])]
    readers = [(place, partial(read_vertices, ring, place)) for ring in rings]
    return Candidate.of_rings(
        readers, place, name, error=read_number(part.get("error", "0"), place)
    )
