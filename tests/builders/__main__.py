"""Add cases to the shipped corpus: `python -m tests.builders [NEW.json ...] [--renew]`.

A file has {"theme": NAME, "cases": [...]}, each case as the corpus writes it, without an answer.
Answers are computed, and nothing is written unless the certificates of all new cases are proved.
With --renew, all answers, facts and titles are recomputed; the inputs of shipped ids stay the same.
"""

import json
import sys
from pathlib import Path
from typing import Any

import click

# Tests import each other by bare names, as under pytest.
sys.path.extend([str(Path(__file__).parents[1]), str(Path(__file__).parents[1] / "support")])
from builders.shipping import ShippingError, digest, encoded, with_answers, written
from exactsweep.corpus import themes
from exactsweep.corpus.shipped import read_theme

DATA = Path(__file__).parent.parent.parent / "exactsweep" / "corpus" / "data"
DIGESTS = Path(__file__).parent / "digests.json"


@click.command()
@click.argument("new", nargs=-1, type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option("--renew", is_flag=True, help="Compute all answers, facts and titles again.")
def main(new: tuple[Path, ...], renew: bool) -> None:
    """Write the themes to the package, including the cases in NEW."""
    added: dict[str, list[dict[str, Any]]] = {name: [] for name in themes()}
    for path in new:
        read = json.loads(path.read_text(encoding="utf-8"))
        if read["theme"] not in added:
            raise click.ClickException(f"{path}: {read['theme']!r} is not a theme")
        added[read["theme"]] += read["cases"]
    files = {}
    digests: dict[str, str] = {}
    for name, entries in added.items():
        old = read_theme(DATA, name)
        try:
            cases = with_answers(name, old, entries, renew)
        except ShippingError as error:
            raise click.ClickException(str(error)) from None
        text = written(name, cases)
        digests |= {case.id: digest(case) for case in cases}
        # Recompressing the same text may change the bytes.
        if text != old:
            file, data = encoded(name, text)
            files[DATA / file] = data
    files[DIGESTS] = (json.dumps(digests, indent=1) + "\n").encode()
    for path, data in files.items():
        path.write_bytes(data)
    click.echo(f"{len(digests)} cases")


if __name__ == "__main__":
    main()
