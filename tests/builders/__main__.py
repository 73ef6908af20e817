"""Add to the shipped corpus what the builders have more: `python -m tests.builders`.

Nothing that is shipped is changed: where a builder says something else of an id, or no longer has
it, nothing is written. With --renew the answers, flags and titles are worked out anew, and the
inputs stay.
"""

import json
import sys
from pathlib import Path

import click

# The tests import one another by bare names, as pytest sets them up.
sys.path.extend([str(Path(__file__).parents[1]), str(Path(__file__).parents[1] / "support")])
from builders.theme import THEMES, BuilderError, built, digest, with_answers, written

DATA = Path(__file__).parent.parent.parent / "exactsweep" / "corpus" / "data"
DIGESTS = Path(__file__).parent / "digests.json"


@click.command()
@click.option("--renew", is_flag=True, help="Work out answers, flags and titles anew.")
def main(renew: bool) -> None:
    """Write the themes to the package."""
    texts = {}
    digests: dict[str, str] = {}
    for name in THEMES:
        path = DATA / f"{name}.json"
        old = path.read_text(encoding="utf-8") if path.exists() else ""
        try:
            cases = with_answers(built(name), old, renew)
        except BuilderError as error:
            raise click.ClickException(str(error)) from None
        texts[path] = written(name, cases)
        digests |= {case.id: digest(case) for case in cases}
    texts[DIGESTS] = json.dumps(digests, indent=1) + "\n"
    for path, text in texts.items():
        path.write_text(text, encoding="utf-8", newline="\n")
    click.echo(f"{len(digests)} cases")


if __name__ == "__main__":
    main()
