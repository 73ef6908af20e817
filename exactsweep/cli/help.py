"""Examples at the end of the help of each command."""

import click

EXAMPLES = {
    "sweep": [
        "house.json block.wkt",
        "parts.svg#bracket sheet.dxf#0 --flatten 1/1000 --json -o result.json",
    ],
    "nfp": [
        "plate.json fork.wkt",
        "sheet.dxf#0 parts.svg#bracket --reference 1/2 0 --json -o result.json",
        "sheet.dxf#0 part.svg --to dxf --round 3 --round-outward -o nfp.dxf",
    ],
    "ifp": [
        "sheet.json part.wkt",
        "sheet.json part.wkt --placed first.wkt --placed others.dxf --json",
        "sheet.json part.wkt --certificate -o proof.json",
    ],
    "layout": [
        "nest.svg --html nest.html",
        "final.json --spacing 0.5 --certificate proof.json",
        "solution.json --instance instance.json",
        "nests 'more/*.svg' --workers 4",
    ],
    "explain": ["house.json block.wkt"],
    "draw": [
        "house.json block.wkt --position 13/5 13/5 -o block.svg",
        "--of nfp block.wkt house.json -o nfp.svg",
    ],
    "view": ["house.json block.wkt -o sweep.html", "--of ifp sheet.json part.wkt -o fit.html"],
    "verify": ["proof.json"],
    "convert": [
        "drawing.dxf --flatten 1/100 --join 1e-6 --unit mm -o parts.json",
        "drawings --flatten 0.01 --nested -o parts.json",
        "parts.json#0 --to wkt --round 6",
    ],
    "batch": [
        "--all parts.dxf sheets.json -o results.jsonl",
        "pairs.jsonl --parts parts.svg --compute areas -o areas.parquet",
        "--all drawings 'sheets/*.dxf' --flatten 0.01 --compute areas --round 3 -o areas.csv",
        "--all parts.json parts.json --compute nfp --rotations 0,90,180,270 -o nfp.jsonl",
    ],
    "corpus list": ["--class MM --max-size 20", "families"],
    "corpus show": ["directions-y"],
    "corpus layouts": ["", "layouts-slot", "--json"],
    "corpus export": ["directions --to svg -o directions.svg"],
    "corpus generate": ["--family notched --seed 1 --count 100"],
    "corpus schema": [""],
    "conform": ["--filter class=CC -- python adapter.py", "--pairs parts.svg -- node adapter.js"],
    "example": ["", "convex.py -o adapter.py"],
    "judge": ["--cases cases.jsonl"],
    "compare": ["directions-y answer.json"],
    "reproduce": ['"Lemma 5.3"', "--quick --out report"],
}
"""What a command may be given; a command of a group by both names."""


def add_examples(command: click.Command, name: str = "") -> None:
    """Give a command, and those of a group, their examples.

    Args:
        command: that of the whole program, or part of it.
        name: what is typed for it after `exactsweep`.
    """
    if isinstance(command, click.Group):
        for word, inner in command.commands.items():
            add_examples(inner, f"{name} {word}".strip())
    elif name in EXAMPLES:
        lines = "".join(f"\n  {' '.join(('exactsweep', name, e)).strip()}" for e in EXAMPLES[name])
        # \b keeps click from wrapping what follows.
        command.epilog = f"\b\nExample{'s' * (len(EXAMPLES[name]) > 1)}:{lines}"
