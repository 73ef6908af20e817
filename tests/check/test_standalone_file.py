"""The checker as a file: run without the package, and its certificates compared with the schema."""

from __future__ import annotations

import ast
import json
import subprocess
import sys
from pathlib import Path

import pytest
from certified import Certificate, certificates, layout, rect, two_ls, with_faults
from jsonschema import Draft202012Validator
from rounded_pieces import rounded_layout

from exactsweep.check import standalone

FILE = Path(standalone.__file__)
FAULT = {"kind": "outside", "placements": [0, -1], "point": ["-1/2", "1"]}
WRONG = with_faults(
    layout([{"id": "a", "exterior": rect(0, 0, 2, 2)}], [{"part": "a", "move": ["-1", "0"]}], []),
    FAULT,
)
DISC = {"points": [["0", "0"]], "radius": "5"}
ROUND = rounded_layout([[{"points": [["1", "0"], ["3", "0"]], "radius": "2"}]], {"pieces": [DISC]})
ALL: dict[str, Certificate] = {**certificates(), "layout": two_ls(), "faults": WRONG}
ALL |= {"rounded": ROUND, "no container": rounded_layout([[DISC]])}


def run(path: Path) -> tuple[int, str]:
    """Run the file by itself, in a process that cannot see the package."""
    command = [sys.executable, "-I", str(FILE), str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def test_the_file_proves_certificates_by_itself(tmp_path: Path) -> None:
    path = tmp_path / "certificate.json"
    path.write_text(json.dumps(ALL["CM"]), encoding="utf-8-sig")
    code, said = run(path)
    assert (code, said[:16]) == (0, "proved: sweep of")
    path.write_text(json.dumps({**ALL["CM"], "area": "1"}), encoding="utf-8")
    assert run(path) == (1, "not proved: area: differs\n")


@pytest.mark.parametrize(
    "text",
    [
        '{"format": 1, "format": 1}',
        '{"format": NaN}',
        "{",
        "",
        "[" * 10**5,
        json.dumps({**ALL["CM"], "directrix": {"exterior": [["9" * 10**6, "0"]] * 9}}),
        json.dumps({**ALL["CM"], "claim": "\ud800"}),
        '{"version": ' + "9" * 10**5 + "}",
    ],
    ids=lambda text: text[:20],
)
def test_a_file_without_a_certificate_is_rejected_in_one_line(
    text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "certificate.json"
    path.write_text(text, encoding="utf-8")
    assert standalone.main([str(path)]) == 1
    said = capsys.readouterr().out
    assert (said[:12], said.count("\n")) == ("not proved: ", 1)


def test_one_file_is_needed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "certificate.json"
    path.write_text(json.dumps(ALL["CM"]), encoding="utf-8")
    for arguments in ([], ["none"], ["none", str(path)], [str(path)] * 2):
        assert standalone.main(arguments) == 1
    assert capsys.readouterr().out.count("not proved: ") == 4


def test_the_file_imports_only_the_standard_library() -> None:
    tree = ast.parse(FILE.read_text(encoding="utf-8"))
    names = [n.module for n in ast.walk(tree) if isinstance(n, ast.ImportFrom)]
    names += [a.name for n in ast.walk(tree) if isinstance(n, ast.Import) for a in n.names]
    assert {str(name).split(".")[0] for name in names} <= set(sys.stdlib_module_names)


@pytest.mark.parametrize("name", ALL)
def test_the_schema_accepts_certificates_and_the_page_names_all_keys(name: str) -> None:
    certificate = ALL[name]
    schema = json.loads((FILE.parent / "certificate.schema.json").read_text(encoding="utf-8"))
    validator = Draft202012Validator(schema)
    page = (FILE.parent / "CERTIFICATES.md").read_text(encoding="utf-8")
    assert validator.is_valid(certificate)
    assert not validator.is_valid({**certificate, "version": 2})
    assert not validator.is_valid({**certificate, "comment": ""})
    for key in certificate if len(json.dumps(certificate)) < 4000 else ():
        assert not validator.is_valid({k: v for k, v in certificate.items() if k != key})
    for key in (*certificate, *certificate.get("proof", []), *certificate.get("layout", [])):
        assert f"`{key}`" in page or f'"{key}"' in page, key
