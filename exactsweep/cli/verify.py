"""`exactsweep verify`."""

import json
import sys
from typing import Any

import click

from exactsweep.cli.options import PATH
from exactsweep.cli.output import write
from exactsweep.cli.working import working
from exactsweep.formats import read_certificate, read_region
from exactsweep.text.results import verification_to_json
from exactsweep.words import count, write_pair


@click.command("verify")
@click.argument("file", type=PATH)
@click.argument("shapes", nargs=-1, metavar="[G D]", type=PATH)
@click.option(
    "--add-proof",
    "output",
    type=click.Path(dir_okay=False),
    metavar="OUTPUT",
    help="Write the certificate with the proof that check/standalone.py reads, too.",
)
@click.option(
    "--max-steps",
    type=click.IntRange(min=1),
    metavar="N",
    help="The limit of work, in steps of about a microsecond; by default 10**8.",
)
@click.option("--json", "as_json", is_flag=True, help="Write the verdict as JSON.")
def verify_command(
    file: str, shapes: tuple[str, ...], output: str | None, max_steps: int | None, as_json: bool
) -> None:
    """Check a certificate, from the definition.

    Decides whether the certificate in FILE, or - for standard input, proves its answer, from
    the definition of a sweep, of a no-fit polygon or of an inner fit, and the polygons in the
    certificate, by code that has nothing to do with the one that wrote it. Prints "proved" and
    what is proved; or the first thing that is wrong, with a witness, a translation or a point to
    see it by, and the exit code is 1.

    With G and D, the certificate has to be about these two polygons: the one that moves and the
    one that stays; of an inner fit, the part and the container.

    'exactsweep sweep', 'nfp' and 'ifp' write certificates, given --certificate.

    Example:
      exactsweep verify proof.json
    """
    from exactsweep.check import verify

    if len(shapes) not in (0, 2):
        raise click.UsageError("Give both polygons, G and D, or none.")
    certificate: Any = read_certificate(file)
    is_inner = type(certificate) is dict and "part" in certificate
    names = ("part", "container") if is_inner else ("generatrix", "directrix")
    asked: dict[str, Any] = dict(zip(names, map(read_region, shapes), strict=False))
    if max_steps is not None:
        asked["max_steps"] = max_steps
    with working("checking the certificate"):
        verdict = verify(certificate, **asked)
    if verdict.proved and output is not None:
        from exactsweep.evidence.proof import add_proof

        write(f"{json.dumps(add_proof(certificate))}\n", output)
    if as_json:
        text = verification_to_json(verdict)
    else:
        text = f"{verdict.reason}\n"
        if verdict.proved:
            text += f"{_describe(certificate)}\n"
        if verdict.witness is not None:
            text += f"witness: {write_pair(verdict.witness)}\n"
    write(text, "-")
    sys.exit(0 if verdict.proved else 1)


def _describe(certificate: dict[str, Any]) -> str:
    """Say which question a certificate answers, of polygons of how many vertices."""
    if "layout" in certificate:
        faults, placed = certificate["faults"], certificate["layout"]["placements"]
        verdict = count(len(faults), "fault") if faults else "valid"
        return f"layout of {count(len(placed), 'placement')}, {verdict}"
    names = ("part", "container") if "part" in certificate else ("generatrix", "directrix")
    sizes = [sum(map(len, _list_rings(certificate[name]))) for name in names]
    question = certificate.get("kind") or certificate["claim"].replace("_", " ")
    return f"{question} of {sizes[0]} and {sizes[1]} vertices"


def _list_rings(shape: Any) -> list[Any]:
    return [shape] if type(shape) is list else [shape["exterior"], *shape["holes"]]
