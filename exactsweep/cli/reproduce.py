import sys
from pathlib import Path

import click

from exactsweep.cli.complete import list_claims, offer


@click.command("reproduce")
@click.argument("names", nargs=-1, metavar="[NAME]...", shell_complete=offer(list_claims))
@click.option("--seed", default=1, show_default=True, help="Seed for the random pairs.")
@click.option(
    "--quick",
    is_flag=True,
    help="Try one in 30 pairs and only small sizes, and skip timing.",
)
@click.option(
    "--out",
    "folder",
    type=click.Path(file_okay=False, path_type=Path),
    help="Output folder; default without NAME: 'reproduced'.",
)
@click.option(
    "--list",
    "only_list",
    is_flag=True,
    help="List all claims with section, verdict and kinds of evidence.",
)
@click.option("--cite", is_flag=True, help="Write only CITATION.cff and references.bib.")
def reproduce_command(
    names: tuple[str, ...],
    seed: int,
    quick: bool,
    folder: Path | None,
    only_list: bool,
    cite: bool,
) -> None:
    """Check the claims of the paper one by one.

    Checks all definitions, theorems, lemmas, corollaries, procedures and figures of the paper, or
    the named ones, such as "Lemma 5.3". Each check searches for counterexamples. The output folder
    contains a report in HTML and Markdown, figures in SVG and PDF, the results as ledger.json and
    as tables, and the counterexamples as files for 'exactsweep sweep'. The exit code is 1 if the
    evidence for a claim fails.

    Example:
      exactsweep reproduce "Lemma 5.3"
      exactsweep reproduce --quick --out report
    """
    from exactsweep.paper.claim import Effort, reproduce
    from exactsweep.paper.ledger import CLAIMS, find
    from exactsweep.paper.report import count_verdicts, render_row, write, write_citation

    target = folder or Path("reproduced")
    if cite:
        click.echo(" ".join(map(str, write_citation(target))))
        return
    claims = [find(name) for name in names] or list(CLAIMS)
    if only_list:
        for claim in claims:
            kinds = ", ".join(claim.evidence)
            click.echo(f"{claim.section}, {claim.name}: {claim.verdict.value} ({kinds})")
            click.echo(f"    {claim.words}")
        return
    effort = Effort(seed, quick)
    rows = []
    for row in reproduce(claims, effort):
        rows.append(row)
        if names:
            click.echo(render_row(row))
        else:
            mark = f"FAILS: {row.disagreement}" if row.disagreement else row.claim.verdict.value
            click.echo(f"{row.seconds:6.2f} s  {row.claim.name}: {mark}")
    if not names:
        click.echo(count_verdicts(rows))
    if folder or not names:
        click.echo(" ".join(map(str, write(target, rows, effort))))
    sys.exit(any(row.disagreement for row in rows))
