"""Cases as JSON lines, which lose nothing."""

import json

from exactsweep.corpus.case import Case
from exactsweep.corpus.case_json import case_to_json


def case_to_line(case: Case) -> str:
    """Write a case as one line of JSON, its end of line included."""
    return json.dumps(case_to_json(case), separators=(",", ":")) + "\n"
