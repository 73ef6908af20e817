"""A run as a self-contained HTML page.

Pictures of failures show the exact loop, the answered loop and the witness. Coordinates are scaled
exactly before they become floats, so a picture shows even an error of one part in 10^15.
"""

import json
from collections.abc import Iterable, Sequence
from contextlib import suppress
from decimal import Decimal
from fractions import Fraction
from functools import partial
from importlib.resources import files
from itertools import islice
from typing import NamedTuple

from exactsweep import __version__
from exactsweep.canvas import style
from exactsweep.canvas.svg import write_path
from exactsweep.canvas.window import Window
from exactsweep.conform.judge.verdict import AnswerError, Verdict, read_loop
from exactsweep.conform.judge.witness import FITS_OF, PART_NAMES, SUM, add, list_exact_rings
from exactsweep.conform.report.text import count_failures, describe_witness
from exactsweep.conform.report.unit_test import guess_language, write_unit_test
from exactsweep.conform.run.outcome import Outcome, list_witnesses
from exactsweep.conform.run.peer import replace_controls
from exactsweep.conform.run.protocol import list_reflected_rings
from exactsweep.conform.run.run import SHOWN, Run, fails, read_any_length
from exactsweep.corpus import Case, case_from_json
from exactsweep.numbers.number import Loop, Point
from exactsweep.text.report import approximate, take_root
from exactsweep.text.template import make_environment

_MAX_LISTED = 2000
_KEY = (
    ("directrix", "D"),
    ("generatrix", "G, placed at the witness if that is a position"),
    ("exact", "exact"),
    ("theirs", "theirs"),
)
SIDE = 320
_MARGIN = 23
_ZOOM = 4
_WORTH_ZOOMING = 20
Layer = tuple[str, Sequence[Sequence[Point]], bool]


class Panel(NamedTuple):
    caption: str
    paths: dict[str, str]
    witness: tuple[float, float] | None


def write_html(run: Run) -> str:
    environment = make_environment()
    environment.filters |= {
        "about": _about,
        "root": take_root,
        "number": read_any_length,
        "plain": replace_controls,
        "part_name": PART_NAMES.get,
        "dump": partial(json.dumps, indent=1),
        "panels": _draw,
        "unit_test": partial(_write_unit_test, run),
        "witnesses": list_witnesses,
        "said": describe_witness,
    }
    template = files("exactsweep.conform.report").joinpath("report.html.j2")
    failed = (outcome for outcome in run.list_outcomes() if fails(outcome.verdict, run.accepted))
    summary = run.summary
    return environment.from_string(template.read_text(encoding="utf-8")).render(
        run=run,
        summary=summary,
        version=__version__,
        style=style,
        side=SIDE,
        bad={verdict for verdict in Verdict if fails(verdict, run.accepted)},
        key=_KEY,
        most_shown=SHOWN,
        answers=[PART_NAMES[q] for q in (*run.hello.loops, *run.hello.questions) if q != "sweep"],
        failures=count_failures(run),
        failed=islice(failed, _MAX_LISTED),
        more=max(0, summary.failures(run.accepted) - _MAX_LISTED),
    )


def _draw(outcome: Outcome) -> list[Panel]:
    try:
        return draw_panels(outcome) if outcome.case else []
    except (ArithmeticError, ValueError):  # a failed picture must not prevent the page
        return []


def _write_unit_test(run: Run, outcome: Outcome) -> str:
    """Write a failure as code for a unit test; "" if it has no loop."""
    part, numbers = outcome.worst, run.hello.numbers
    if part is None or outcome.case is None or part["name"].endswith("fits"):
        return ""
    case, name = case_from_json(outcome.case), part["name"]
    given = {
        "directrix": case.directrix_rings,
        "generatrix": case.generatrix_rings,
        "reference": ((case.reference,),),
    }
    if name == SUM:
        given = {"a": case.directrix_rings, "b": list_reflected_rings(case)}
    theirs = _read_rings(outcome, name)
    shapes = {**given, "exact": list_exact_rings(case, name), "theirs": theirs}
    remark = f"{outcome.id}, {name}: {outcome.verdict}"
    language = guess_language(run.command, run.hello.name)
    return write_unit_test(shapes.items(), language, numbers, remark)


def _about(value: Fraction) -> str:
    rounded = approximate(value)
    return rounded if Fraction(Decimal(rounded)) == value else f"about {rounded}"


class _Scene(NamedTuple):
    layers: tuple[Layer, ...]
    witness: Point | None
    error: Fraction | None

    def points(self, *names: str) -> list[Point]:
        return [
            p for name, rings, _ in self.layers if name in names for ring in rings for p in ring
        ]


def draw_panels(outcome: Outcome) -> list[Panel]:
    """Draw the worst part of an outcome, enlarged at D or the witness if these are too small."""
    name = outcome.worst["name"] if outcome.worst else "trajectory"
    scene = _scene(case_from_json(outcome.case), outcome, name)
    whole = _window(scene)
    drawn = [_panel(scene, whole, PART_NAMES[name])]
    near = _around(scene.points("directrix", "exact"))
    if whole.longest > _WORTH_ZOOMING * near.longest:
        drawn.append(_panel(scene, near, f"magnified {_times(whole.longest / near.longest)} at D"))
    if scene.error and scene.witness and whole.longest > _WORTH_ZOOMING * scene.error:
        x, y = scene.witness
        half = _ZOOM * scene.error
        zoomed = Window(x - half, y - half, x + half, y + half, SIDE, SIDE)
        times = _times(whole.longest / zoomed.longest)
        drawn.append(_panel(scene, zoomed, f"magnified {times} at the witness"))
    return drawn


def _scene(case: Case, outcome: Outcome, name: str) -> _Scene:
    part = outcome.worst
    witness = next(iter(list_witnesses(part)), {}) if part else {}
    generatrix = case.generatrix
    seen, t = map(_read_point, (witness.get("point"), witness.get("translation")))
    if t is not None:
        generatrix = generatrix.translated(t)
        if name not in ("inner", "outer"):
            seen = t if name == SUM else add(case.reference, t)
    layers: list[Layer] = [
        ("directrix", case.directrix.rings, True),
        ("generatrix", generatrix.rings, True),
    ]
    fits_of = {fits: loop for loop, fits in FITS_OF.items()}
    if name in fits_of:
        layers.append(("faint", list_exact_rings(case, fits_of[name]), True))
    layers.append(("exact", list_exact_rings(case, name), name not in fits_of))
    theirs = _read_rings(outcome, name)
    layers.append(("theirs", theirs, name not in fits_of))
    square = part and part["distance_squared"]
    return _Scene(tuple(layers), seen, take_root(read_any_length(square)) if square else None)


def _read_rings(outcome: Outcome, name: str) -> tuple[Loop, ...]:
    with suppress(AnswerError):
        return read_loop((outcome.result or {}).get(name), name).rings
    return ()


def _read_point(pair: Iterable[str] | None) -> Point | None:
    return None if pair is None else Point(*map(read_any_length, pair))


def _window(scene: _Scene) -> Window:
    """Return a window around everything, except an answer that reaches far."""
    own = scene.points("directrix", "generatrix", "exact", "faint")
    if scene.witness:
        own.append(scene.witness)
    window = _around(own)
    everything = _around([*own, *scene.points("theirs")])
    return everything if everything.longest <= 3 * window.longest else window


def _around(points: Iterable[Point]) -> Window:
    return Window.around(points, SIDE, SIDE, _MARGIN)


def _panel(scene: _Scene, window: Window, caption: str) -> Panel:
    if not window.is_true:
        caption += "; not to scale: the axes have different units"
    paths = {
        name: write_path((map(window.place, ring) for ring in rings), closed=closed)
        for name, rings, closed in scene.layers
        if rings
    }
    return Panel(caption, paths, window.place(scene.witness) if scene.witness else None)


def _times(value: Fraction) -> str:
    return f"{float(value):,.0f} times" if value < 10**6 else f"{approximate(value)} times"
