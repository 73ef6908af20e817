"""A judged layout as a self-contained HTML page, with zoom and a search for parts."""

from base64 import b64encode
from collections.abc import Iterable, Sequence
from hashlib import sha256
from importlib.resources import files

from exactsweep import __version__
from exactsweep.layout.judge import Judgement
from exactsweep.layout.report.picture import SIDE, draw_parts, enlarge_faults, write_style
from exactsweep.layout.report.table import describe_fault, find_remarks, list_measures
from exactsweep.layout.report.worst import NO_CONTEXT, ReportContext, WorstFirst
from exactsweep.text.template import make_environment
from exactsweep.words import spell_out

_MAX_LISTED, _MAX_MARKED, _REPAIRED = 1000, 20, 50


def write_layout_page(
    judgement: Judgement,
    ranked: Sequence[WorstFirst],
    title: str,
    notes: Iterable[str] = (),
    *,
    y_down: bool = False,
    context: ReportContext = NO_CONTEXT,
) -> str:
    """Write a judged layout as an HTML page; arguments as for `report_layout` and `draw_layout`."""
    from markupsafe import Markup

    environment = make_environment()
    folder = files("exactsweep.layout.report")
    template = folder.joinpath("page.html.j2").read_text("utf-8")
    script = folder.joinpath("page.js").read_text("utf-8")
    digest = b64encode(sha256(script.encode()).digest()).decode()
    names = [spell_out(f"{k} {one.part}") for k, one in enumerate(judgement.layout.placements)]
    width, height, main = draw_parts(judgement, ranked, y_down=y_down)
    facts = list_measures(judgement, ranked, context)
    is_good = judgement.valid or all(one.accepted for one in ranked)
    return environment.from_string(template).render(
        side=SIDE,
        title=title,
        version=__version__,
        style=Markup(write_style()),
        script=Markup(script),
        script_hash=f"sha256-{digest}",
        names=names[:_MAX_LISTED],
        placed={
            number: " ".join(map(str, one.fault.placements[:_MAX_MARKED]))
            for number, one in enumerate(ranked[:_MAX_LISTED], 1)
        },
        verdict=facts.pop("verdict"),
        facts=facts,
        good=is_good,
        width=width,
        height=height,
        main=Markup(main),
        panels=[
            (panel.number, panel.caption, Markup(panel.svg))
            for panel in enlarge_faults(judgement, ranked, y_down=y_down, context=context)
        ],
        faults=[
            (
                number,
                one.fault.kind,
                *describe_fault(judgement, one, context, repaired=number <= _REPAIRED),
            )
            for number, one in enumerate(ranked[:_MAX_LISTED], 1)
        ],
        more=max(0, len(ranked) - _MAX_LISTED),
        notes=[*notes, *find_remarks(judgement, ranked, context)],
    )
