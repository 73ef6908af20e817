"""Add to the shipped corpus what the builders have more: `python -m tests.builders`.

Nothing that is shipped is changed: where a builder says something else of an id, or no longer has
it, nothing is written; nor where a certificate of a new case is not proved. With --renew the
answers, flags and titles are worked out anew, and the inputs stay.
"""

import json
import sys
from pathlib import Path

import click

# The tests import one another by bare names, as pytest sets them up.
sys.path.extend([str(Path(__file__).parents[1]), str(Path(__file__).parents[1] / "support")])
from builders.theme import THEMES, BuilderError, built, digest, encoded, with_answers, written
from exactsweep.corpus.shipped import read_theme

DATA = Path(__file__).parent.parent.parent / "exactsweep" / "corpus" / "data"
DIGESTS = Path(__file__).parent / "digests.json"


@click.command()
@click.option("--renew", is_flag=True, help="Work out answers, flags and titles anew.")
def main(renew: bool) -> None:
    """Write the themes to the package."""
    files = {}
    digests: dict[str, str] = {}
    for name in THEMES:
        try:
            old = read_theme(DATA, name)
        except FileNotFoundError:
            old = ""
        try:
            cases = with_answers(built(name), old, renew)
        except BuilderError as error:
            raise click.ClickException(str(error)) from None
        text = written(name, cases)
        digests |= {case.id: digest(case) for case in cases}
        # Compressed anew, the same text may have other bytes.
        if text != old:
            file, data = encoded(name, text)
            files[DATA / file] = data
    files[DIGESTS] = (json.dumps(digests, indent=1) + "\n").encode()
    for path, data in files.items():
        path.write_bytes(data)
    click.echo(f"{len(digests)} cases")


if __name__ == "__main__":
    main()
