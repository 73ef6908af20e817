"""Inputs are never overwritten, addresses are checked first, numbers never become infinite."""

import sys
from pathlib import Path

import pytest
from command import HOUSE, NOTCH, refusal, run

from exactsweep.batch import BatchError, take_all_pairs
from exactsweep.batch import run as run_batch
from exactsweep.batch.workers import _require_address
from exactsweep.formats import FormatError, NamedPolygon
from exactsweep.geometry.polygon import Polygon

UNIT = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])


@pytest.mark.parametrize("output", ["b.json", "link.json", "c.part", "parts/a.json"])
def test_a_batch_never_overwrites_its_input(
    output: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    text = Path(HOUSE).read_text()
    for name in ("a.json", "b.json", "c.part"):
        Path(name).write_text(text)
    Path("link.json").symlink_to("b.json")
    Path("parts").mkdir()
    Path("parts/a.json").write_text(text)
    read = {"c.part": "c.part", "parts/a.json": "parts"}.get(output, "b.json")
    given = "c" if output == "c.part" else output
    message = refusal(run("batch", "--all", "a.json", read, "-o", given))
    assert message.endswith(": is both input and output of this batch")
    assert Path("b.json").read_text() == Path("parts/a.json").read_text() == text
    assert not Path("c").exists()


@pytest.mark.parametrize(
    "address",
    ["9" * 400, "9" * 40, "host:0", "host:65536", f"host:{'9' * 300}", "a b:1", "tcp://", "[::1"],
    ids=lambda address: address[:12],
)
def test_invalid_addresses_are_rejected_before_connecting(address: str, tmp_path: Path) -> None:
    job = take_all_pairs([NamedPolygon(UNIT, "a")], [NamedPolygon(UNIT, "b")])
    with pytest.raises(
        BatchError, match=r"is not the address of a Dask scheduler, as in tcp://host:8786$"
    ):
        run_batch(job, str(tmp_path / "o.jsonl"), scheduler=address)


def test_addresses_may_have_a_port() -> None:
    for address in ("local", "127.0.0.1", "tcp://host:1", "[::1]:65535"):
        _require_address(address)


def test_schedulers_need_distributed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    job = take_all_pairs([NamedPolygon(UNIT, "a")], [NamedPolygon(UNIT, "b")])
    with pytest.raises(FormatError, match=r"needs distributed: pip install distributed$"):
        run_batch(job, str(tmp_path / "o.jsonl"), scheduler="local")


def test_areas_beyond_floats_are_not_infinities(tmp_path: Path) -> None:
    output = tmp_path / "o.parquet"
    (tmp_path / "a.json").write_text("[[0, 0], [1e160, 0], [0, 1e160]]")
    given = (
        "batch",
        "--all",
        *[str(tmp_path / "a.json")] * 2,
        "--round",
        "2",
        "--compute",
        "areas",
    )
    message = refusal(run(*given, "-o", str(output)))
    assert "exceeds the range of Parquet doubles; write .csv" in message
    assert run(*given, "-o", str(tmp_path / "o.csv")).exit_code == 0
    assert "inf" not in (tmp_path / "o.csv").read_text()


def test_two_reports_need_two_files(tmp_path: Path) -> None:
    one = str(tmp_path / "out")
    for pair in (("--json", "--html"), ("--journal", "--json"), ("--html", "--junit")):
        options = [word for name in pair for word in (name, one)]
        done = run("conform", *options, "--", "true")
        assert done.exit_code == 2
        assert "must be different files" in done.stderr


@pytest.mark.parametrize("command", ["sweep", pytest.param("draw", marks=pytest.mark.long)])
def test_a_write_that_fails_leaves_the_old_file(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    output = tmp_path / "old.svg"
    output.write_text("old")
    output.chmod(0o640)

    def fail(self: Path, *words: object, **named: object) -> None:
        with open(self, "w", encoding="utf-8") as file:
            file.write("half")
        raise OSError(28, "No space left on device")

    options = ["--to", "svg"] if command == "sweep" else []
    with monkeypatch.context() as patched:
        patched.setattr(Path, "write_text", fail)
        patched.setattr("exactsweep.draw.save", lambda figure, path: fail(Path(path)))
        message = refusal(run(command, HOUSE, NOTCH, *options, "-o", str(output)))
    assert message == f"{output}: No space left on device"
    assert output.read_text() == "old"
    assert [path.name for path in tmp_path.iterdir()] == ["old.svg"]
    assert run(command, HOUSE, NOTCH, *options, "-o", str(output)).exit_code == 0
    assert output.read_text().startswith("<")
    assert output.stat().st_mode & 0o777 == 0o640
    assert [path.name for path in tmp_path.iterdir()] == ["old.svg"]


def test_file_names_of_invalid_utf_8_are_reported(tmp_path: Path) -> None:
    path = tmp_path / "part-\udcff.json"
    try:
        path.write_text(Path(HOUSE).read_text())
    except (OSError, UnicodeError):
        pytest.skip("a file system of UTF-8 names only")
    two = tmp_path / "other.json"
    two.write_text(Path(HOUSE).read_text())
    message = refusal(run("convert", str(path), str(two), "--to", "csv"))
    assert "part-\\udcff" in message
    assert "is not valid UTF-8" in message
