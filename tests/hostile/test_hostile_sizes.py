"""Large output is readable: its writer names the limit, if one is needed.

The limit is low here, so that the answers to two small polygons are far beyond it.
"""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from command import run
from tiers import mostly_long

from exactsweep import Polygon, limits
from exactsweep.formats import FORMATS, format_polygons
from exactsweep.formats.parsing import measure_written

MOST = 1200
WRITERS = {
    **{f"s.{form}": ("sweep", "--to", form) for form in FORMATS},
    **{f"n.{form}": ("nfp", "--to", form) for form in FORMATS},
    "s": ("sweep", "--json"),
    "n": ("nfp", "--json"),
    "i": ("ifp", "--json"),
    "s.text": ("sweep", "--wkt"),
    "s.cert": ("sweep", "--certificate"),
    "n.cert": ("nfp", "--certificate"),
    "i.cert": ("ifp", "--certificate"),
    "b.jsonl": ("batch", "--all"),
}


def readers(name: str) -> list[tuple[str, ...]]:
    """The readers of files: verify reads certificates, every other command polygons."""
    if name.endswith(".cert"):
        return [("verify", name)]
    read: list[tuple[str, ...]] = [("convert", name, "--to", "json")]
    if name == "i":
        return read
    file = f"{name}#0"
    read += [("sweep", file, "g.json")]
    if name not in ("s", "n"):
        return read
    read += [
        ("nfp", file, "g.json"),
        ("ifp", file, "g.json"),
        ("explain", file, "g.json"),
        ("batch", "--all", "g.json", name, "--workers", "1", "-o", "more.jsonl", "--restart"),
    ]
    if name == "s":
        read += [("compare", name, name), ("compare", "pair", name)]
        read += [("draw", f"{name}#outer", "g.json", "-o", "out.svg")]
        read += [("view", f"{name}#outer", "g.json", "-o", "out.html")]
    return read


@pytest.fixture
def low_limit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("exactsweep.formats.size.DEFAULT_MIB", MOST / 2**20)
    parabola = [(k, k * k) for k in range(45)]
    for name, points in (("g", parabola), ("d", [(5 * x, 7 * y) for x, y in parabola])):
        text = format_polygons([Polygon(points)], "json")
        Path(f"{name}.json").write_text(text)
        assert measure_written(text) < MOST
    Path("pair").write_text('{"generatrix": [[0,0],[1,0],[0,1]], "directrix": [[0,0],[1,0],[0,1]]}')
    with limits(max_mib=MOST / 2**20):
        yield


@pytest.mark.parametrize("name", mostly_long(WRITERS, {*WRITERS} - {"s", "s.cert", "n"}))
@pytest.mark.usefixtures("low_limit")
def test_outputs_beyond_the_limit_name_a_sufficient_one(name: str) -> None:
    command, *how = WRITERS[name]
    pair = ["d.json", "g.json"] if command in ("nfp", "ifp") else ["g.json", "d.json"]
    more = ["--workers", "1"] if command == "batch" else []
    written = run(command, *how, *pair, *more, "-o", name)
    assert written.exit_code == 0, written.stderr
    size = measure_written(Path(name).read_text())
    said = re.findall(
        rf"{re.escape(name)}: large file; reading it requires --max-mib (\d+)\n", written.stderr
    )
    assert bool(said) == (size > MOST)
    # The result of an inner fit includes more than its regions, so it is always large.
    assert said
    for reader in readers(name):
        refused = run(*reader)
        assert refused.exit_code == 1, (reader, refused.output)
        assert re.search(r"more than [\d,.e-]+ [a-z ]*(MiB )?\(max_mib\)$", refused.stderr)
        result = run(*reader, "--max-mib", said[0])
        # That is the answer to another pair.
        expected = 1 if reader[1] == "pair" else 0
        assert result.exit_code == expected, (reader, result.output, result.exception)


@pytest.mark.parametrize("name", ["b.jsonl", "s", "n.cert"])
@pytest.mark.usefixtures("low_limit")
def test_the_named_limit_is_tight(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    named: list[int] = []
    monkeypatch.setattr("exactsweep.cli.output.find_needed_mib", named.append)
    command, *how = WRITERS[name]
    run(command, *how, "g.json", "d.json", "-o", name)
    assert named[-1:] == [measure_written(Path(name).read_text())]
