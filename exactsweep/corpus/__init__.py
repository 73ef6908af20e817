"""The corpus: pairs with exact answers, for testing any program."""

from exactsweep.corpus.case import Case, CaseError
from exactsweep.corpus.case_json import case_from_json, case_to_json
from exactsweep.corpus.generator import FAMILIES, Family, generate
from exactsweep.corpus.layouts import (
    LayoutCase,
    PathCase,
    find_layout_case,
    find_path_case,
    layout_cases,
    path_cases,
)
from exactsweep.corpus.names import UnknownNameError
from exactsweep.corpus.shipped import Note, cases, find_case, notes, themes

__all__ = [
    "FAMILIES",
    "Case",
    "CaseError",
    "Family",
    "LayoutCase",
    "Note",
    "PathCase",
    "UnknownNameError",
    "case_from_json",
    "case_to_json",
    "cases",
    "find_case",
    "find_layout_case",
    "find_path_case",
    "generate",
    "layout_cases",
    "notes",
    "path_cases",
    "themes",
]
