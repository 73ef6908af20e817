"""A judged layout as one self-contained HTML page without scripts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from importlib.resources import files

from exactsweep import __version__
from exactsweep.layout.judge import Judgement
from exactsweep.layout.report.picture import SIDE, draw_parts, enlarge_faults, write_style
from exactsweep.layout.report.table import tell_error, tell_fault, write_verdict
from exactsweep.layout.report.worst import WorstFirst
from exactsweep.numbers.digits import abridge
from exactsweep.text.report import approximate, take_root
from exactsweep.text.template import make_environment

_MOST_LISTED = 1000


def write_layout_page(
    judgement: Judgement,
    ranked: Sequence[WorstFirst],
    title: str,
    notes: Iterable[str] = (),
    *,
    y_down: bool = False,
) -> str:
    """Write a judged layout as an HTML page, with pictures of the worst faults.

    Args:
        judgement: a Judgement.
        ranked: its faults, as `rank_faults` sorts them.
        title: the name of the layout.
        notes: further remarks.
        y_down: whether Y points down in the pictures.

    Returns:
        The page. It escapes all names.

    Cost: that of `draw_layout`.
    """
    from markupsafe import Markup

    environment = make_environment()
    template = files("exactsweep.layout.report").joinpath("page.html.j2").read_text("utf-8")
    width, height, main = draw_parts(judgement, ranked, y_down=y_down)
    environment.filters |= {"about": approximate, "exactly": abridge, "root": take_root}
    environment.filters["tell_error"] = tell_error
    return environment.from_string(template).render(
        side=SIDE,
        title=title,
        version=__version__,
        style=Markup(write_style()),
        verdict=write_verdict(judgement),
        judgement=judgement,
        width=width,
        height=height,
        main=Markup(main),
        panels=[
            (panel.number, panel.caption, Markup(panel.svg))
            for panel in enlarge_faults(judgement, ranked, y_down=y_down)
        ],
        faults=[(one.fault.kind, *tell_fault(one)) for one in ranked[:_MOST_LISTED]],
        more=max(0, len(ranked) - _MOST_LISTED),
        notes=[*notes],
    )
