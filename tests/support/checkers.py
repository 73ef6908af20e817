"""The checkers in Python and JavaScript on the same certificates."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from exactsweep.check.standalone import Refused, load, prove

CHECKER = Path(__file__).parents[2] / "exactsweep" / "check" / "standalone.js"
needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="no node")


def is_proved(certificate: Any) -> bool:
    """Decide whether the checker in Python proves a certificate, JSON data."""
    try:
        prove(certificate)
    except Refused:
        return False
    return True


def is_text_proved(text: str) -> bool:
    try:
        certificate = load(text.removeprefix("\ufeff"))
    except (Refused, ValueError, RecursionError):  # the latter two: not JSON
        return False
    return is_proved(certificate)


def ask_node(texts: list[str], folder: Path) -> list[str]:
    """Return the output lines of one process for all certificates."""
    files = [folder / f"{n}.json" for n in range(len(texts))]
    for file, text in zip(files, texts, strict=True):
        file.write_text(text, encoding="utf-8")
    command = ["node", str(CHECKER), *(file.name for file in files)]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", cwd=folder)
    lines = done.stdout.splitlines()
    assert not done.stderr
    assert done.returncode == (0 if all(line.startswith("proved: ") for line in lines) else 1)
    return lines


def check_agreement(certificates: list[Any], folder: Path) -> int:
    """Require that both checkers agree on each certificate; return the number of proofs."""
    texts = [c if type(c) is str else json.dumps(c) for c in certificates]
    answers = ask_node(texts, folder)
    assert len(answers) == len(texts)
    verdicts = [is_text_proved(text) for text in texts]
    for text, answer, verdict in zip(texts, answers, verdicts, strict=True):
        assert answer.startswith("proved: " if verdict else "not proved: "), (answer, text)
    return sum(verdicts)
