"""READMEs: examples run, names exist, figures are correct.

Python examples run as doctests, README by README, by pytest itself.
"""

import importlib
import pkgutil
import re
import sys
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import pytest
from command import EXAMPLE, ROOT, run, shell
from shipped_cases import shipped_cases
from tiers import mostly_long

import exactsweep
from exactsweep.draw import make_figure, plot_sweep, save

PAGES = [path for path in (ROOT / "exactsweep").rglob("README.md") if "vendor" not in path.parts]
READMES = [
    ROOT / "README.md",
    *(ROOT / "benchmarks").rglob("README.md"),
    ROOT / "tests/README.md",
    *PAGES,
]
TEXTS = {
    str(path.relative_to(ROOT)): path.read_text(encoding="utf-8")
    for path in [*READMES, ROOT / "exactsweep/PROJECT.md"]
}
FIRST = TEXTS["README.md"]
SVG = "{http://www.w3.org/2000/svg}"


def commands(text: str) -> list[tuple[str, str]]:
    """Return the commands of the console blocks, each with the output shown."""
    blocks = re.findall(r"^```console\n(.*?)^```$", text, re.M | re.S)
    return re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", "".join(blocks), re.M)


@pytest.mark.parametrize(
    "name", mostly_long([name for name in sorted(TEXTS) if commands(TEXTS[name])], ["README.md"])
)
def test_console_blocks_run_as_shown(tmp_path: Path, name: str) -> None:
    # Two commands of the first README make the polygons that the others use.
    polygons = [made for made in commands(FIRST) if made[0].startswith("echo")]
    polygons = polygons[:2] if name != "README.md" else []
    for command, expected in polygons + commands(TEXTS[name]):
        done = shell(f"cd '{tmp_path}'; {{ {command}\n}} 2>&1")
        assert done.stdout == expected, command


def test_the_first_readme_is_short() -> None:
    assert len(FIRST.splitlines()) <= 200
    linked = re.findall(r"\]\((\S+README.md)\)", TEXTS["exactsweep/PROJECT.md"])
    assert {path.resolve() for path in READMES if path != ROOT / "README.md"} == {
        (ROOT / "exactsweep" / link).resolve() for link in linked
    }
    assert "exactsweep/PROJECT.md" in FIRST


@pytest.mark.parametrize("name", sorted(TEXTS))
def test_links_lead_somewhere(name: str) -> None:
    for link in re.findall(r"\]\(([^)\s]+)\)", TEXTS[name]):
        assert link.startswith("https://") or ((ROOT / name).parent / link).is_file(), link


@pytest.mark.parametrize("name", sorted(TEXTS))
def test_names_of_modules_exist(name: str) -> None:
    known = {module.name for module in pkgutil.walk_packages(exactsweep.__path__, "exactsweep.")}
    assert set(re.findall(r"`(exactsweep\.[a-z_.]+)`", TEXTS[name])) <= known


def test_imported_names_are_exported() -> None:
    lines = re.findall(
        r"^(?:>>> )?from (exactsweep[\w.]*) import ([\w, ]+)$", "".join(TEXTS.values()), re.M
    )
    assert len(lines) > 10
    for name, words in lines:
        module = importlib.import_module(name)
        for word in words.split(", "):
            assert word in getattr(module, "__all__", vars(module)), f"{name}.{word}"


def lines_drawn(path: Path) -> list[tuple[str, list[tuple[float, float]]]]:
    """List the lines of a matplotlib picture with their styles, relative to its frame."""
    axes = next(
        group for group in ElementTree.parse(path).iter(f"{SVG}g") if group.get("id") == "axes_1"
    )
    drawn = []
    for group in axes.iterfind(f"{SVG}g"):
        if not re.match(r"patch|line2d|PathCollection", group.get("id", "")):
            continue
        for shape in group.iterfind(f"{SVG}path"):
            numbers = [float(word) for word in re.findall(r"-?[\d.]+", shape.get("d", ""))]
            points = list(zip(numbers[::2], numbers[1::2], strict=True))
            drawn.append((shape.get("style", ""), points))
    frame = drawn[0][1]
    (left, right), (top, bottom) = ((min(side), max(side)) for side in zip(*frame, strict=True))
    return [
        (
            style,
            [
                (round((x - left) / (right - left), 3), round((y - top) / (bottom - top), 3))
                for x, y in points
            ],
        )
        for style, points in drawn
    ]


def test_the_picture_of_the_readme_is_up_to_date(tmp_path: Path) -> None:
    # The bytes depend on matplotlib's layout of the legend.
    figure = make_figure()
    plot_sweep(EXAMPLE, figure.axes[0])
    save(figure, str(tmp_path / "block.svg"))
    drawn = lines_drawn(tmp_path / "block.svg")
    assert len(drawn) > 8
    name = re.findall(r"\]\((\S+\.svg)\)", FIRST)[0]
    assert lines_drawn(ROOT / name) == drawn, "exactsweep draw -o " + name


def test_the_picture_of_a_layout_is_up_to_date(tmp_path: Path) -> None:
    nest, picture = str(tmp_path / "nest.json"), tmp_path / "nest.svg"
    Path(nest).write_text(run("corpus", "layouts", "layouts-tangram-nudged").stdout)
    assert run("layout", nest, "--svg", str(picture)).exit_code == 1
    name = re.findall(r"\]\((\S+\.svg)\)", FIRST)[1]
    drawn, shown = (path.read_text(encoding="utf-8") for path in (picture, ROOT / name))
    # The title has the path.
    assert re.sub("<title>.*?</title>", "", drawn) == re.sub("<title>.*?</title>", "", shown)


@pytest.mark.long
def test_the_counts_of_claims_and_cases_are_current() -> None:
    words = " ".join(FIRST.split())
    statuses = re.findall(r": ([a-z ]+) \(.*\)$", run("reproduce", "--list").stdout, re.M)
    count = Counter(statuses)
    held = count["reproduced"] + count["sharpened"]
    shown = re.search(r"the (\d+) claims of the paper: .*? \| (\d+), (\d+), (\d+), (\d+) ", words)
    assert shown
    refuted = count["refuted as stated"] + count["refuted by theorem"]
    less = [count["reproduced with a condition"], count["misprint"], refuted]
    added = count["added"]
    assert [*map(int, shown.groups())] == [len(statuses) - added, held, *less]
    assert sum([held, *less, added]) == len(statuses)
    assert f"out of {len(shipped_cases())} cases" in words


@pytest.mark.long
def test_the_campaigns_start() -> None:
    names = {*re.findall(r"python -m (tests\.\w+)", TEXTS["tests/README.md"])}
    assert len(names) >= 4
    for name in names:
        done = shell(f"cd '{ROOT}' && '{sys.executable}' -m {name} --help")
        assert (done.returncode, done.stderr) == (0, ""), name
        assert done.stdout.startswith(f"Usage: python -m {name}")
