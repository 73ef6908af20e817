"""Every lesson runs, and shows what is stored with it."""

import copy
import json
import re
from collections.abc import Iterator
from typing import Any
from xml.etree import ElementTree

import pytest
from tiers import mostly_long

from exactsweep.lessons import render_lesson
from exactsweep.lessons.notebook import (
    FOLDER,
    list_titles,
    read_notebook,
    run_notebook,
    write_notebook,
)

TEXTS = ("text/plain",)


@pytest.fixture(autouse=True)
def without_windows() -> Iterator[None]:
    from matplotlib import pyplot

    pyplot.switch_backend("Agg")
    pyplot.close("all")  # what an example of a README.md left open
    yield
    pyplot.close("all")


def list_outputs(notebook: dict[str, Any]) -> list[Any]:
    """Return the output of the cells, with a mark for each picture."""
    found: list[Any] = []
    for cell in notebook["cells"]:
        for output in cell.get("outputs", ()):
            data = output.get("data", {})
            texts = ["".join(data[kind]) for kind in TEXTS if kind in data]
            found.append((sorted(data), texts, "".join(output.get("text", ()))))
    return found


def code(notebook: dict[str, Any]) -> list[str]:
    return ["".join(c["source"]) for c in notebook["cells"] if c["cell_type"] == "code"]


@pytest.mark.parametrize("name", mostly_long(list_titles(), ["gallery", "tour", "layouts"]))
def test_lessons_run_and_give_their_stored_output(name: str) -> None:
    stored = read_notebook(name)
    made = run_notebook(copy.deepcopy(stored))
    assert list_outputs(made) == list_outputs(stored), f"python -m exactsweep.lessons ({name})"
    assert code(made) == code(stored)
    pictures = 0
    for cell in stored["cells"]:
        for output in cell.get("outputs", ()):
            svg = "".join(output.get("data", {}).get("image/svg+xml", ()))
            pictures += bool(svg)
            assert not svg or ElementTree.fromstring(svg).tag.endswith("svg")
    assert pictures > 1 or name == "judging"


def test_all_lessons_are_listed() -> None:
    assert sorted(list_titles()) == sorted(path.stem for path in FOLDER.glob("*.ipynb"))
    assert all(list_titles().values())


def test_no_machine_details_are_stored() -> None:
    for name in list_titles():
        text = (FOLDER / f"{name}.ipynb").read_text(encoding="utf-8")
        assert not re.search(r"0x[0-9a-f]{6,}|/(?:tmp|home|root|work|usr)/", text)
        assert json.loads(text)["nbformat"] == 4


def test_changed_output_of_a_notebook_is_noticed(tmp_path: Any) -> None:
    stored = read_notebook("sweeps")
    (cell,) = (c for c in stored["cells"] if list_prints(c).startswith("swept 72"))
    cell["outputs"][0]["text"] = ["swept 71\n"]
    assert list_outputs(run_notebook(copy.deepcopy(stored))) != list_outputs(stored)
    path = tmp_path / "lesson.ipynb"
    write_notebook(path, stored)
    assert json.loads(path.read_text(encoding="utf-8")) == stored


def test_figures_of_others_stay_open_and_are_not_shown() -> None:
    from matplotlib import pyplot

    mine = pyplot.figure()
    draw = ["from matplotlib import pyplot\n", "axes = pyplot.figure().add_subplot()"]
    cells = [{"cell_type": "code", "source": source} for source in (["1"], draw)]
    shown = [cell["outputs"] for cell in run_notebook({"cells": cells})["cells"]]
    assert [[output["data"]["text/plain"] for output in cell] for cell in shown] == [
        [["1"]],
        [["<Figure>"]],
    ]
    assert pyplot.get_fignums() == [mine.number]


def list_prints(cell: dict[str, Any]) -> str:
    return "".join("".join(output.get("text", ())) for output in cell.get("outputs", ()))


def test_a_cell_that_fails_fails_the_notebook() -> None:
    cell = {"cell_type": "code", "source": ["from exactsweep import sweep\n", "sweep([], [])"]}
    with pytest.raises(ValueError, match="generatrix: fewer than three"):
        run_notebook({"cells": [cell]})


@pytest.mark.parametrize("name", list_titles())
def test_a_page_shows_all_cells_and_pictures_of_its_lesson(name: str) -> None:
    page = render_lesson(name)
    stored = read_notebook(name)
    assert page.count("<pre><code>") >= len(code(stored))
    assert page.count("<svg") >= sum("<svg" in json.dumps(cell) for cell in stored["cells"])
    assert f"<title>{list_titles()[name]}</title>" in page
    assert "{{" not in page
