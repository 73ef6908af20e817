"""`exactsweep reproduce` and its report."""

import csv
import json
import re
from functools import cache
from html.parser import HTMLParser
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path

import jsonschema
import pytest
from click.testing import CliRunner, Result
from mutations import MUTATIONS, mutated

from exactsweep import __version__
from exactsweep.cli import main
from exactsweep.paper import report
from exactsweep.paper.claim import (
    Claim,
    ClaimVerdict,
    Counterexample,
    Effort,
    Evidence,
    Finding,
    Table,
    reproduce,
)
from exactsweep.paper.data import describe_environment, make_slug, write_data
from exactsweep.paper.growth import Growth, Size
from exactsweep.paper.ledger import CLAIMS, find
from exactsweep.paper.report import count_verdicts, read_bibtex, render_row, write

FEW = ("Slope", "Corollary 3.4", "Lemma 5.3", "Lemma A.3")
EFFORT = Effort(5, quick=True)


@cache
def row(name: str) -> Finding:
    return next(reproduce([find(name)], EFFORT))


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, ["reproduce", *arguments])


def timeless(text: str) -> str:
    text = re.sub(r'<span class="time">[^<]*</span>', "", text)
    text = re.sub(r"(?m)^\| (bytes|seconds) of .*$", "", text)
    return re.sub(r"\*Time:\* [0-9.]+ s", "", text)


class Checker(HTMLParser):
    """A parser that checks the nesting of tags and collects references to other files."""

    VOID = ("meta", "img", "br")

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.references: list[str] = []
        self.ids: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in self.VOID:
            self.open.append(tag)
        found = dict(attrs)
        self.references += [found[name] or "" for name in ("href", "src") if name in found]
        self.ids += [found["id"] or ""] if "id" in found else []

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        pass

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.mark.long
def test_the_same_seed_gives_the_same_bytes_except_for_times(tmp_path: Path) -> None:
    texts = []
    again = list(reproduce(map(find, FEW), EFFORT))
    for name, rows in (("one", list(map(row, FEW))), ("two", again)):
        paths = write(tmp_path / name, rows, EFFORT)
        texts.append([timeless(path.read_text(encoding="utf-8")) for path in paths[:2]])
    assert texts[0] == texts[1]
    pictures = [sorted((tmp_path / name).glob("*.svg")) for name in ("one", "two")]
    assert [p.read_bytes() for p in pictures[0]] == [p.read_bytes() for p in pictures[1]]


@pytest.mark.long
def test_the_html_is_well_formed_and_needs_no_other_file(tmp_path: Path) -> None:
    html, markdown, _ = write(tmp_path, list(map(row, FEW)), EFFORT)
    checker = Checker()
    checker.feed(html.read_text(encoding="utf-8"))
    assert checker.open == []
    assert len(checker.ids) == len(set(checker.ids))
    assert {make_slug(name) for name in FEW} <= set(checker.ids)
    assert all(r.startswith(("#", "data:image/svg+xml;base64,")) for r in checker.references)
    assert {r[1:] for r in checker.references if r[0] == "#"} == set(checker.ids)
    text = markdown.read_text(encoding="utf-8")
    assert re.findall(r"!\[counts of ([^]]*)\]", text) == ["Corollary 3.4"]
    for name in re.findall(r"!\[[^]]*\]\(([^)]*)\)", text):
        assert (tmp_path / name).is_file()
    assert f"exactsweep {__version__}" in text
    assert "seed 5" in text


def test_words_of_checks_are_escaped(tmp_path: Path) -> None:
    nasty = "<script>alert(1)</script> | & m_b"
    evidence = Evidence(
        nasty, nasty, (Counterexample(nasty, nasty),), tables=(Table(nasty, (nasty,), [[nasty]]),)
    )
    claim = Claim(
        nasty, "1", nasty, ClaimVerdict.REFUTED, (), (nasty,), lambda effort: [evidence], nasty
    )
    (found,) = reproduce([claim], Effort())
    html, markdown, _ = write(tmp_path, [found], Effort())
    assert render_row(found).strip() in markdown.read_text(encoding="utf-8")
    assert "<script>" not in html.read_text(encoding="utf-8")
    assert "| <script>alert(1)</script> \\| & m_b |" in markdown.read_text(encoding="utf-8")


def test_measurements_are_not_plotted(tmp_path: Path) -> None:
    sizes = tuple(Size(n, n, n, n) for n in (8, 16, 32))
    timed = Growth("seconds of f", "ints", "n", sizes)
    claim = Claim(*("Timed", "1", "", ClaimVerdict.REFUTED, (), ()), lambda effort: [timed], "")
    _, markdown, _ = write(tmp_path, list(reproduce([claim], Effort())), Effort())
    assert "![counts of" not in markdown.read_text(encoding="utf-8")


def test_without_matplotlib_there_are_tables_only(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(report, "find_spec", lambda name: None)
    html, markdown, _ = write(tmp_path, [row("Corollary 3.4")], EFFORT)
    assert "<img" not in html.read_text(encoding="utf-8")
    assert "| m + n |" in markdown.read_text(encoding="utf-8")
    assert not list(tmp_path.glob("*.svg"))


def test_one_row_is_shown_in_full() -> None:
    result = run("lemma 5.3", "--quick")
    assert result.exit_code == 0
    assert result.output.startswith("### Lemma 5.3: reproduced with a condition\n\n")
    assert "1 rows: " not in result.output
    assert "*Counterexample:* Trajectory_MM along the inside of T extends from" in result.output


def test_named_rows_are_reported_on_request(tmp_path: Path) -> None:
    result = run("Slope", "Lemma 3.1", "--quick", "--out", str(tmp_path / "a" / "b"))
    assert result.exit_code == 0
    assert (tmp_path / "a" / "b" / "report.html").is_file()


def test_a_row_whose_evidence_fails_gives_exit_code_1(tmp_path: Path) -> None:
    with mutated(MUTATIONS[0]):
        result = run("Trajectory_CC", "--quick", "--out", str(tmp_path))
    assert result.exit_code == 1
    assert "**The evidence fails:** " in result.output
    assert "evidence fails" in (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Rows whose evidence fails" in (tmp_path / "report.md").read_text(encoding="utf-8")


def test_an_unwritable_folder_is_an_error(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("")
    result = run("Slope", "--quick", "--out", str(file / "folder"))
    assert result.exit_code == 1
    assert result.stderr.startswith("Error: ")


def test_the_citation_is_two_files_of_this_version(tmp_path: Path) -> None:
    # The second time, the folder exists.
    for _ in range(2):
        result = run("--cite", "--out", str(tmp_path / "cite"))
    paths = [tmp_path / "cite" / name for name in ("CITATION.cff", "references.bib")]
    assert result.output == f"{paths[0]} {paths[1]}\n"
    cff, bib = (path.read_text(encoding="utf-8") for path in paths)
    assert f"version: {__version__}\n" in cff
    assert f"version = {{{__version__}}}" in bib == read_bibtex()
    assert bib.count("{") == bib.count("}")
    keys = re.findall(r"@\w+\{(\w+),", bib)
    assert len(keys) == len(set(keys)) >= 14
    assert {key for claim in CLAIMS for key in claim.see} <= set(keys)


def test_the_ledger_is_written_as_data_that_its_schema_describes(tmp_path: Path) -> None:
    names = ("Lemma 5.3", "Local width", "Corollary 3.4", "Figure 2", "Slope")
    rows = list(map(row, names))
    write_data(tmp_path, rows, EFFORT)
    found = json.loads((tmp_path / "ledger.json").read_text(encoding="utf-8"))
    schema = files("exactsweep.paper").joinpath("ledger.schema.json").read_text(encoding="utf-8")
    jsonschema.validate(found, json.loads(schema))
    assert [claim["name"] for claim in found["claims"]] == list(names)
    assert found["failing"] == []
    assert found["environment"]["seed"] == 5
    text = (tmp_path / "tables" / "growth.csv").read_text(encoding="utf-8")
    lines = list(csv.reader(text.splitlines()))
    assert len(lines) - 1 == sum(len(g.points) for g in rows[2].evidence.growth)
    assert (tmp_path / "tables" / "figure-2-1.csv").is_file()
    assert (tmp_path / "tables" / "exponents.csv").is_file()


def test_the_totals_are_reported() -> None:
    rows = [row("Slope"), row("Lemma 3.1")]
    assert count_verdicts(rows).startswith("2 rows: 1 reproduced, 1 misprint; all supported; ")
    with mutated(MUTATIONS[0]):
        red = list(reproduce([find("Trajectory_CC")], Effort(quick=True)))
    assert "; evidence fails: Trajectory_CC; " in count_verdicts(red)


def test_the_environment_lists_the_installed_packages() -> None:
    found = describe_environment(Effort(7, quick=True))
    assert found["packages"]["sympy"] == version("sympy")
    assert None not in found["packages"].values()
    described = Path("/proc/cpuinfo")
    if described.exists() and "model name" in described.read_text(encoding="utf-8"):
        assert found["processor"] in described.read_text(encoding="utf-8")
    assert (found["exactsweep"], found["seed"], found["quick"]) == (__version__, 7, True)


def test_the_plot_of_growth_names_its_lines_and_axes() -> None:
    pytest.importorskip("matplotlib")
    points = tuple(Size(8 << k, 16, 100 << k, 8 << k) for k in range(3))
    drawn = report.plot_ratios([Growth("planted", "family", "mn", points)]).decode()
    for text in ("planted, family, m, / (mn)", "the greater of m and n", "count / bound"):
        assert text in drawn
