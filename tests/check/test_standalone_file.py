"""The checker as a file: run by itself, and its certificates by the schema and the page."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from jsonschema import Draft202012Validator
from test_standalone import CERTIFICATES, SLOT, SQUARE

from exactsweep.check import standalone


def run(*arguments: str) -> tuple[int, str]:
    """Run the file by itself, in a process that cannot see the package."""
    done = subprocess.run(
        [sys.executable, "-I", standalone.__file__, *arguments],
        capture_output=True,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout


def test_the_file_proves_certificates_by_itself(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {
        "proof": json.dumps(CERTIFICATES["CM"]),
        "g": json.dumps(SQUARE),
        "d": '{"exterior": [[0, 0], [8, 0.0], ["8", 5e0], [7, 5], [3, 1], [2, 5], [0, 5]],'
        ' "holes": null}',
        "fit": json.dumps(CERTIFICATES["inside exactly"]),
        "slot": json.dumps(SLOT),
        "claim": json.dumps({k: v for k, v in CERTIFICATES["SS"].items() if k != "proof"}),
        "twice": '{"format": 1, "format": 1}',
        "nan": '{"format": NaN}',
        "bad": "{",
        "huge": "[[0, 0], [1, 0], [0, 1e999999999]]",
        "deep": "[" * 10**5,
        "long": json.dumps({**CERTIFICATES["CM"], "directrix": [["9" * 10**6, "0"]] * 9}),
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    at = {name: str(tmp_path / name) for name in files}
    code, said = run(at["proof"], at["g"], at["d"])
    assert (code, said[:37]) == (0, "proved: CM sweep of 4 around 7 vertic")
    assert run(at["proof"])[0] == 0
    marked = tmp_path / "marked"
    marked.write_text(files["proof"], encoding="utf-8-sig")
    assert standalone.main([str(marked)]) == 0
    assert capsys.readouterr().out.startswith("proved: ")
    assert standalone.main([at["proof"], at["g"], at["d"]]) == 0
    assert capsys.readouterr().out == said
    assert standalone.main([at["fit"], at["g"], at["slot"]]) == 0
    assert standalone.main([at["fit"], at["slot"], at["g"]]) == 1
    assert capsys.readouterr().out.endswith("not proved: part: not the polygon that is given\n")
    assert run(at["proof"], at["d"], at["g"]) == (
        1,
        "not proved: generatrix: not the polygon that is given\n",
    )
    assert run(at["proof"], at["huge"], at["d"]) == (
        1,
        "not proved: a number with too large an exponent\n",
    )
    over = str(tmp_path / "over")
    Path(over).write_text('[[0, 0], ["1/0", 0], [0, 1]]', encoding="utf-8")
    refused = [[at[name]] for name in ("claim", "twice", "nan", "bad", "deep", "long")]
    for arguments in (*refused, [str(tmp_path / "none")], [at["proof"], over, at["d"]]):
        assert standalone.main(arguments) == 1
        said = capsys.readouterr().out
        assert (said[:12], said.count("\n")) == ("not proved: ", 1)


@pytest.mark.parametrize("count", [0, 2, 4])
def test_shapes_are_given_both_or_not_at_all(
    count: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert standalone.main(["none"] * count) == 1
    assert capsys.readouterr().out.startswith("not proved: give a certificate, and perhaps both ")


def test_the_schema_takes_certificates_and_the_page_names_all_keys() -> None:
    folder = Path(standalone.__file__).parent
    schema = json.loads((folder / "certificate.schema.json").read_text(encoding="utf-8"))
    validator = Draft202012Validator(schema)
    page = (folder / "CERTIFICATES.md").read_text(encoding="utf-8")
    for certificate in CERTIFICATES.values():
        assert validator.is_valid(certificate)
        assert not validator.is_valid({**certificate, "version": 1})
        assert not validator.is_valid({**certificate, "exact_fits": [["0", "0"]]})
        assert not validator.is_valid({**certificate, "comment": ""})
        for key in (*certificate, *certificate.get("proof", [])):
            assert f"`{key}`" in page or f'"{key}"' in page, key
