"""The corpus as a folder of data: complete, with checksums and readers that agree."""

import json
import re
import subprocess
from dataclasses import replace
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from shutil import which
from typing import Any

import pytest
from command import ROOT, refusal, run
from shipped_cases import shipped_cases

from exactsweep.corpus import Case, case_from_json, publish, themes
from exactsweep.corpus.publish import VERSION, digest_release

RELEASE = ROOT / "exactsweep" / "corpus" / "release"

READERS = {
    "reader.cpp": ("g++", ["g++", "-std=c++17", "-o", "{out}", "{source}"], ["{out}"]),
    "reader.rs": ("rustc", ["rustc", "-o", "{out}", "{source}"], ["{out}"]),
    "reader.js": ("node", [], ["node", "{source}"]),
    "Reader.java": ("java", [], ["java", "{source}"]),
    "Reader.cs": ("dotnet-script", [], ["dotnet-script", "{source}"]),
    "reader.go": ("go", [], ["go", "run", "{source}"]),
}
# Short fractions, long integers, many exact fits.
READ = ("worked", "large", "fits", "reference")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("corpus") / "all"
    done = run("corpus", "release", "-o", str(path))
    assert (done.exit_code, done.stdout) == (0, "")
    return path


@pytest.mark.long
def test_every_case_is_published_with_a_version(folder: Path) -> None:
    listed = sorted(path.name for path in (folder / "cases").iterdir())
    assert listed == [f"{theme}.jsonl" for theme in themes()]
    lines = [
        json.loads(line)
        for name in listed
        for line in (folder / "cases" / name).read_text(encoding="utf-8").splitlines()
    ]
    assert [line["id"] for line in lines] == [case.id for case in shipped_cases()]
    assert {line["version"] for line in lines} == {*range(1, VERSION + 1)}
    known = {case.id: case for case in shipped_cases()}
    for line in lines[::50]:
        assert case_from_json(line) == known[line["id"]]


@pytest.mark.long
def test_checksums_are_those_of_all_files(folder: Path) -> None:
    sums = dict(
        line.split("  ")[::-1]
        for line in (folder / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    )
    found = {
        path.relative_to(folder).as_posix(): sha256(path.read_bytes()).hexdigest()
        for path in folder.rglob("*")
        if path.is_file() and path.name != "SHA256SUMS"
    }
    assert sums == found
    assert {
        "HOW-TO-READ.md",
        "CHANGELOG.md",
        "versions.json",
        "LICENSE",
        "schema.json",
        "notes.json",
        "VERSION",
    } < found.keys()
    assert (folder / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()


@pytest.mark.long
def test_strings_have_only_two_escapes(folder: Path) -> None:
    """So a simple reader suffices."""
    for path in (folder / "cases").iterdir():
        text = path.read_text(encoding="utf-8")
        assert not re.search(r'\\[^"\\]', text), path
        assert not re.search(r'"[:,] ', re.sub(r'"[^"]*"', '""', text)), path


def test_a_file_instead_of_the_folder_is_rejected(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    said = refusal(run("corpus", "release", "-o", str(tmp_path / "file")))
    assert said.startswith(str(tmp_path / "file"))


@pytest.mark.long
def test_ids_questions_and_answers_of_released_versions_are_unchanged() -> None:
    """Digests are recorded per version; cases are never changed or removed."""
    released = json.loads((RELEASE / "versions.json").read_text(encoding="utf-8"))
    assert [*released] == [str(k) for k in range(1, VERSION + 1)]
    changes = (RELEASE / "CHANGELOG.md").read_text(encoding="utf-8")
    before = 0
    for version, found in released.items():
        count = sum(case.version <= int(version) for case in shipped_cases())
        assert found == {"cases": count, "sha256": digest_release(int(version))}
        assert f"- **{version}**: {count - before:,} cases" in changes
        before = count


@pytest.mark.long
def test_the_digest_follows_the_page(folder: Path) -> None:
    page = (folder / "HOW-TO-READ.md").read_text(encoding="utf-8")
    recipe = page.partition("`versions.json`")[2].partition("`CHANGELOG.md`")[0]
    names = {*re.findall(r"`(\w+)`", recipe)}
    texts = [path.read_text(encoding="utf-8") for path in (folder / "cases").iterdir()]
    found = [json.loads(line) for text in texts for line in text.splitlines()]
    for version, released in json.loads((folder / "versions.json").read_text()).items():
        lines = [
            json.dumps(
                {name: case[name] for name in names & case.keys()},
                sort_keys=True,
                separators=(",", ":"),
            )
            for case in found
            if case["version"] <= int(version)
        ]
        text = "".join(f"{line}\n" for line in sorted(lines))
        assert sha256(text.encode()).hexdigest() == released["sha256"]


def test_the_digest_covers_only_questions_and_answers(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    case = shipped_cases()[0]

    def digest(**changes: Any) -> str:
        monkeypatch.setattr(publish, "cases", lambda: iter([replace(case, **changes)]))
        return digest_release(VERSION)

    same = digest()
    assert digest(title="another title", note="a note", flags=()) == same
    moved = case.reference._replace(x=case.reference.x + 1)
    for changes in ({"id": "x"}, {"reference": moved}, {"exact_fits": ((moved, moved),)}):
        assert digest(**changes) != same
    assert digest(version=VERSION + 1) != same


@pytest.mark.long
def test_readers_have_at_most_thirty_lines(folder: Path) -> None:
    assert {path.name for path in (folder / "readers").iterdir()} == READERS.keys()
    for path in (folder / "readers").iterdir():
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 30, path.name


@pytest.mark.long
@pytest.mark.parametrize("name", READERS)
def test_readers_read_the_cases(name: str, folder: Path, tmp_path: Path) -> None:
    needed, build, call = READERS[name]
    if which(needed) is None:
        pytest.skip(f"no {needed} here")
    places = {"source": str(folder / "readers" / name), "out": str(tmp_path / "reader")}
    if build:
        subprocess.run([part.format(**places) for part in build], check=True, capture_output=True)
    for theme in READ:
        command = [*(part.format(**places) for part in call), str(folder / f"cases/{theme}.jsonl")]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        expected = [write(c) for c in shipped_cases() if c.id.startswith(f"{theme}-")]
        assert done.stdout.splitlines() == expected


def write(case: Case) -> str:
    """Return the line that a reader writes for a case."""
    x, y = case.trajectory.vertices[0]
    counts = len(case.directrix_ring), len(case.trajectory), len(case.exact_fits)
    return " ".join([case.id, *map(str, counts), ratio(x), ratio(y)])


def ratio(value: Fraction) -> str:
    return f"{value.numerator}/{value.denominator}"
