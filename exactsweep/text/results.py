"""JSON out: exact, a name a line."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.evidence.steps import Step, explain
from exactsweep.evidence.swept import Swept
from exactsweep.evidence.undercut import Undercut
from exactsweep.formats.outline import NamedPolygon
from exactsweep.formats.writing import _wkt
from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.polygon import Polygon

if TYPE_CHECKING:
    from exactsweep.check import Verification


def sweep_to_json(sweep: Swept) -> str:
    """Write a sweep, its input included, as JSON.

    Args:
        sweep: a Sweep.

    Returns:
        One object, a name a line: "kind", "direction", "reference", "area", and the vertex lists
        "generatrix", "directrix", "trajectory", "inner" and "outer". The direction is a pair
        of integers; all other numbers are strings that `to_fraction` reads.

    Cost: linear in the length of the result.
    """
    loops = {"trajectory": sweep.trajectory, "inner": sweep.inner, "outer": sweep.outer}
    texts = {
        **_input(sweep),
        **{name: _written(loop.vertices) for name, loop in loops.items()},
        "area": _written(sweep.area),
    }
    return _object(texts)


def certificate_to_json(sweep: Swept) -> str:
    """Write the certificate of a sweep, `Sweep.certificate`, as JSON.

    Args:
        sweep: a Sweep.

    Returns:
        One object, a name a line.

    Cost: that of `exactsweep.evidence.certificate`.
    """
    return _object({name: json.dumps(value) for name, value in sweep.certificate().items()})


def story_to_json(sweep: Swept) -> str:
    """Write the steps of a sweep, as `exactsweep.evidence.steps` finds them, as JSON.

    Args:
        sweep: a Sweep.

    Returns:
        One object: the input as by `sweep_to_json`, "undercuts", "exact_fits", and "steps", a step
        a line. Names are those of `Undercut` and `Step`. All numbers but the shared direction
        and the numbers of features, undercuts and exact fits are strings. Features are numbered
        as the caller gave them; "features" says which number each vertex listed, and the edge from
        it to the next, has there.

    Cost: that of `exactsweep.evidence.steps`.
    """
    steps = [_written(_step(step)) for step in explain(sweep)]
    return _object(
        {
            **_input(sweep),
            "features": _written(
                {
                    "generatrix": _numbers(sweep.generatrix),
                    "directrix": _numbers(sweep.directrix),
                }
            ),
            "undercuts": _written([_undercut(undercut) for undercut in sweep.undercuts]),
            "exact_fits": _written(sweep.exact_fits),
            "steps": "[\n    " + ",\n    ".join(steps) + "\n  ]",
        }
    )


def verification_to_json(verification: Verification) -> str:
    """Write a verdict of `exactsweep.check.verify` as JSON: "proved", "reason" and "witness".

    Args:
        verification: a Verification.

    Returns:
        One object; the witness is a point, two strings, or null.
    """
    return _object({name: _written(part) for name, part in verification._asdict().items()})


def _input(sweep: Swept) -> dict[str, str]:
    direction = (format_fraction(Fraction(component)) for component in sweep.direction)
    return {
        "generatrix": _written(sweep.generatrix.vertices),
        "directrix": _written(sweep.directrix.vertices),
        "kind": _written(sweep.kind),
        "direction": f"[{', '.join(direction)}]",
        "reference": _written(sweep.reference),
    }


def _numbers(polygon: Polygon) -> dict[str, list[int]]:
    size = len(polygon)
    return {
        "vertices": [polygon.vertex_index(k) for k in range(size)],
        "edges": [polygon.edge_index(k) for k in range(size)],
    }


def _undercut(undercut: Undercut) -> dict[str, object]:
    area = {"area": undercut.polygon.area}
    return {**undercut._asdict(), "polygon": undercut.polygon.vertices, **area}


def _step(step: Step) -> dict[str, object]:
    return {
        **step._asdict(),
        "direction": [Fraction(component) for component in step.direction],
        "touches": [touch._asdict() for touch in step.touches],
        "landmarks": [landmark._asdict() for landmark in step.landmarks],
    }


def _object(texts: Mapping[str, str]) -> str:
    lines = (f"  {json.dumps(name)}: {text}" for name, text in texts.items())
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _written(value: object) -> str:
    return json.dumps(value, default=format_fraction)


def sweep_to_wkt(sweep: Swept) -> str:
    """Write the loops of a sweep as three lines of WKT: trajectory, inner loop, outer loop.

    Args:
        sweep: a Sweep.

    Returns:
        Three POLYGONs, a line each, in exact decimals.

    Raises:
        FormatError: a coordinate is not a finite decimal, such as 1/3, which WKT cannot hold.

    Cost: linear in the length of the result, times the cost of a division of that length.
    """
    loops = {"trajectory": sweep.trajectory, "inner loop": sweep.inner, "outer loop": sweep.outer}
    return _wkt([NamedPolygon(loop, name) for name, loop in loops.items()])
