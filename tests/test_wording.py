"""Files that are not exempt avoid the words in `wording.toml`."""

import pytest
from wording import LIST, find_in, find_words, list_files

EXEMPT: set[str] = {name for names in LIST["exempt"].values() for name in names}


def test_files_avoid_the_listed_words() -> None:
    found = [
        f"{name}:{line}: {word}"
        for name, path in list_files().items()
        if name not in EXEMPT
        for line, word in find_in(name, path)
    ]
    assert not found, "\n".join(found)


def test_exempt_files_have_listed_words() -> None:
    files = list_files()
    assert {*files} >= EXEMPT
    clean = [name for name in sorted(EXEMPT) if not find_in(name, files[name])]
    assert not clean, "delete in wording.toml: " + ", ".join(clean)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('"""Loops that are told."""', ["told"]),
        ("# A count of so\n# many.", ["so many"]),
        ("def left_alone() -> None: ...", ["left alone"]),
        ("class OtherStretch: ...", ["stretch"]),
        ("found.left_out = '`told`'", []),
        ("always = sideways", []),
    ],
)
def test_words_are_found_in_prose_and_names(text: str, words: list[str]) -> None:
    assert [word for _, word in find_words(f"{text}\n")] == words


def test_code_of_pages_and_strings_of_tests_do_not_count() -> None:
    page = "Many `ways`.\n\n```\nways\n```\n\nIt is\ntold.\n"
    assert [*find_words(page, ".md")] == [(7, "told")]
    assert not [*find_words("a = 'told'\n", strings=False)]
