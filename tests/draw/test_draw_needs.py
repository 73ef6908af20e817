"""Messages of pictures and formats if a library is missing or cannot be loaded."""

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from exactsweep.canvas.window import DrawError
from exactsweep.draw.figure import require_matplotlib
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import require_imports


def read_dreams() -> None:
    with require_imports("dreams", "sleep", FormatError):
        import dreams  # type: ignore[import-not-found]  # noqa: F401


@pytest.mark.parametrize(
    ("name", "load", "error", "missing", "broken"),
    [
        (
            *("matplotlib", require_matplotlib, DrawError),
            "a picture needs matplotlib: pip install matplotlib",
            "a picture needs matplotlib, which cannot be loaded: ft2font.so: failed to map segment",
        ),
        (
            *("dreams", read_dreams, FormatError),
            "sleep needs dreams: pip install dreams",
            "sleep needs dreams, which cannot be loaded: ft2font.so: failed to map segment",
        ),
    ],
)
def test_missing_and_broken_libraries_are_distinguished(
    name: str,
    load: Callable[[], None],
    error: type[Exception],
    missing: str,
    broken: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(error) as caught:
        load()
    assert str(caught.value) == missing
    monkeypatch.delitem(sys.modules, name)
    # The loader's message if memory is short has several lines.
    text = 'raise ImportError("ft2font.so: failed to\\n map segment")\n'
    (tmp_path / f"{name}.py").write_text(text)
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(error) as caught:
        load()
    assert str(caught.value) == broken
