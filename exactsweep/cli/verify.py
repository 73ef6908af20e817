"""`exactsweep verify`."""

import sys

import click

from exactsweep.cli.output import write
from exactsweep.cli.pair import PATH
from exactsweep.cli.working import working
from exactsweep.formats import read_certificate
from exactsweep.text.results import verification_to_json
from exactsweep.words import write_pair


@click.command("verify")
@click.argument("file", type=PATH)
@click.option(
    "--max-steps",
    type=click.IntRange(min=1),
    metavar="N",
    help="The most work to take on, in steps of about a microsecond; 10**8 if left out.",
)
@click.option("--json", "as_json", is_flag=True, help="Write the verdict as JSON.")
def verify_command(file: str, max_steps: int | None, as_json: bool) -> None:
    """Check a certificate, from the definition.

    Decides whether the certificate in FILE, or - for standard input, proves its answer, from
    the definition of a sweep, of a no-fit polygon or of an inner fit, and the polygons in the
    certificate, by code that has nothing to do with the one that wrote it. Prints "proved"; or the
    first thing that is wrong, with a witness, a translation or a point to see it by, and the exit
    code is 1.

    'exactsweep sweep', 'nfp' and 'ifp' write certificates, given --certificate.
    """
    from exactsweep.check import verify

    asked = {} if max_steps is None else {"max_steps": max_steps}
    with working("checking the certificate"):
        verdict = verify(read_certificate(file), **asked)
    if as_json:
        text = verification_to_json(verdict)
    else:
        text = f"{verdict.reason}\n"
        if verdict.witness is not None:
            text += f"witness: {write_pair(verdict.witness)}\n"
    write(text, "-")
    sys.exit(0 if verdict.proved else 1)
