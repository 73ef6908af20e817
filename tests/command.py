"""How the tests run the command line."""

import os
import re
import subprocess
import sysconfig
from pathlib import Path

from click.testing import CliRunner, Result

from exactsweep import sweep
from exactsweep.cli import main
from exactsweep.examples import DIRECTRIX, GENERATRIX

ROOT = Path(__file__).parent.parent
HOUSE = str(Path(__file__).parent / "polygons" / "house.json")
NOTCH = str(Path(__file__).parent / "polygons" / "notch.wkt")
EXAMPLE = sweep(GENERATRIX, DIRECTRIX)
SCRIPTS = sysconfig.get_path("scripts")
EXACTSWEEP = str(Path(SCRIPTS) / "exactsweep")


def run(*arguments: str, stdin: str | bytes | None = None) -> Result:
    return CliRunner().invoke(main, arguments, input=stdin)


def refusal(result: Result, code: int = 1) -> str:
    """The one line of a refusal."""
    assert result.exit_code == code
    assert result.stdout == ""
    assert re.fullmatch(r"Error: [^\n]+\n", result.stderr)
    return result.stderr.removeprefix("Error: ").removesuffix("\n")


def shell(command: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PATH": f"{SCRIPTS}{os.pathsep}{os.environ['PATH']}"}
    environment.pop("COLUMNS", None)
    return subprocess.run(
        ["bash", "-c", command], env=environment, capture_output=True, text=True, timeout=60
    )
