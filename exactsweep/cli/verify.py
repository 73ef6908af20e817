import sys
from collections import Counter
from pathlib import Path
from typing import Any

import click

from exactsweep.cli.options import PATH
from exactsweep.cli.output import write
from exactsweep.cli.working import working
from exactsweep.formats import read_certificate, read_region, read_text, show_path
from exactsweep.formats.paths import parse_path
from exactsweep.text.results import verification_to_json
from exactsweep.words import count, write_pair

_NAMES = {"inner_fit": ("part", "container"), "sum": ("shape", "path")}


@click.command("verify")
@click.argument("file", type=PATH)
@click.argument("shapes", nargs=-1, metavar="[G D]", type=PATH)
@click.option(
    "--max-steps",
    type=click.IntRange(min=1),
    metavar="N",
    help="Maximum number of steps of up to a microsecond each; default: depends on the file.",
)
@click.option(
    "--coq",
    type=click.Path(dir_okay=False),
    metavar="OUTPUT",
    help="Write a proved claim as a theorem for Coq, for example to claim.v.",
)
@click.option(
    "--extracted",
    is_flag=True,
    help="Also run the checker extracted from the Coq proof; needs coqc, ocamlfind and zarith.",
)
@click.option("--json", "as_json", is_flag=True, help="Write the verdict as JSON.")
def verify_command(
    file: str,
    shapes: tuple[str, ...],
    max_steps: int | None,
    coq: str | None,
    extracted: bool,
    as_json: bool,
) -> None:
    """Check a certificate with independent code.

    Decides whether the certificate in FILE, or - for standard input, proves its answer: a sweep, a
    no-fit polygon, an inner fit, a sum, or the verdict on a layout. The checker is a single file
    without dependencies, check/standalone.py. Prints "proved" and the answer; or else the first
    condition that fails, with a translation or a point as a witness. The exit code is then 1.

    If G and D are given, the certificate must refer to these shapes: the moving and the stationary
    polygon, the part and the container of an inner fit, or the shape and the path of a sum.

    'exactsweep sweep', 'nfp', 'ifp', 'sum' and 'layout' write certificates with --certificate.

    Example:
      exactsweep verify proof.json
    """
    from exactsweep.check import verify

    if len(shapes) not in (0, 2):
        raise click.UsageError("One polygon is missing: give both G and D, or neither.")
    certificate: Any = read_certificate(file)
    if not isinstance(certificate, dict) or not certificate.keys() & {"format", "claim"}:
        raise click.ClickException(
            f"{show_path(file)}: not a certificate; commands write one with --certificate"
        )
    kind = certificate.get("claim")
    names = _NAMES.get(kind if type(kind) is str else "", ("generatrix", "directrix"))
    asked = {name: _read(name, file) for name, file in zip(names, shapes, strict=False)}
    with working("checking the certificate"):
        verdict = verify(certificate, **asked, max_steps=max_steps)
    if extracted and verdict.proved:
        verdict = _ask_extracted(certificate, verdict)
    if coq is not None and verdict.proved:
        from exactsweep.theorem.coq import write_theorem

        write(write_theorem(certificate, Path(coq).stem), coq)
    if as_json:
        text = verification_to_json(verdict)
    else:
        name = "standard input" if file == "-" else file
        if verdict.proved:
            found = f"proved\n{_describe(certificate)}"
        else:
            found = f"not proved: {verdict.reason}"
        text = f"{name}: {found}\n"
        if verdict.witness is not None:
            text += f"witness: {write_pair(verdict.witness)}\n"
    write(text, "-")
    sys.exit(0 if verdict.proved else 1)


def _read(name: str, file: str) -> Any:
    if name != "path":
        return read_region(file)
    path = parse_path(read_text(file), is_list=True)
    if path is None:
        raise click.ClickException(f"{show_path(file)}: not a path")
    return path


def _ask_extracted(certificate: Any, verdict: Any) -> Any:
    from exactsweep.theorem.extracted import ask

    try:
        with working("running the extracted checker"):
            answer = ask(certificate)
    except RuntimeError as error:
        raise click.ClickException(f"cannot run the extracted checker: {error}") from error
    if answer == "accepted":
        return verdict
    return verdict._replace(proved=False, reason=f"the extracted checker reports: {answer}")


def _describe(certificate: dict[str, Any]) -> str:
    if certificate["claim"] == "layout":
        placed = count(len(certificate["layout"]["placements"]), "placement")
        kinds = Counter(fault["kind"] for fault in certificate.get("faults", ()))
        faults = ", ".join(
            count(number, kind) if kind == "overlap" else f"{number} {kind}"
            for kind, number in kinds.items()
        )
        return f"layout of {placed}: {faults or 'valid'}"
    if certificate["claim"] == "sum":
        shape, points = _count_vertices(certificate["shape"]), len(certificate["path"])
        question = f"sum of {shape} vertices and a path of {points} points"
        holes = count(len(certificate["holes"]), "hole")
        return f"{question}: {len(certificate['exterior'])} vertices, {holes}"
    fits = count(len(certificate["exact_fits"]), "exact fit")
    if certificate["claim"] == "inner_fit":
        sizes = [_count_vertices(certificate[name]) for name in ("part", "container")]
        regions = count(len(certificate["regions"]), "region")
        return f"inner fit of {sizes[0]} in {sizes[1]} vertices: {regions}, {fits}"
    sizes = [_count_vertices(certificate[name]) for name in ("generatrix", "directrix")]
    question = f"of {sizes[0]} around {sizes[1]} vertices"
    holes = count(len(certificate["holes"]), "hole")
    no_fit = f"{len(certificate['exterior'])} vertices, {holes}, {fits}"
    if certificate["claim"] == "no_fit":
        return f"no-fit polygon {question}: {no_fit}"
    outer, inner = len(certificate["outer"]), len(certificate["inner"])
    return f"sweep {question}: outer {outer}, inner {inner} vertices; no-fit polygon: {no_fit}"


def _count_vertices(shape: dict[str, Any]) -> int:
    return sum(map(len, (shape["exterior"], *(shape.get("holes") or ()))))
