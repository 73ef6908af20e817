"""A judged layout as one self-contained HTML page without scripts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib.resources import files

from exactsweep import __version__
from exactsweep.layout.judge import Judgement
from exactsweep.layout.report.picture import SIDE, draw_parts, enlarge_faults, write_style
from exactsweep.layout.report.table import find_remarks, list_measures, tell_fault
from exactsweep.layout.report.worst import NO_CONTEXT, ReportContext, WorstFirst
from exactsweep.text.template import make_environment

_MOST_LISTED = 1000


def write_layout_page(
    judgement: Judgement,
    ranked: Sequence[WorstFirst],
    title: str,
    notes: Iterable[str] = (),
    *,
    y_down: bool = False,
    context: ReportContext = NO_CONTEXT,
) -> str:
    """Write a judged layout as an HTML page, with pictures of the worst faults.

    Args:
        judgement: a Judgement.
        ranked: its faults, as `rank_faults` sorts them.
        title: the name of the layout.
        notes: further remarks.
        y_down: whether Y points down in the pictures.
        context: what the reader of the file knows.

    Returns:
        The page. It escapes all names.

    Cost: that of `draw_layout`.
    """
    from markupsafe import Markup

    environment = make_environment()
    template = files("exactsweep.layout.report").joinpath("page.html.j2").read_text("utf-8")
    width, height, main = draw_parts(judgement, ranked, y_down=y_down)
    facts = list_measures(judgement, ranked, context)
    is_good = judgement.valid or all(one.accepted for one in ranked)
    return environment.from_string(template).render(
        side=SIDE,
        title=title,
        version=__version__,
        style=Markup(write_style()),
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
            (number, one.fault.kind, *tell_fault(judgement, one, context))
            for number, one in enumerate(ranked[:_MOST_LISTED], 1)
        ],
        more=max(0, len(ranked) - _MOST_LISTED),
        notes=[*notes, *find_remarks(judgement, ranked, context)],
    )
