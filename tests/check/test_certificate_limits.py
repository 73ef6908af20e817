"""Results of accepted input are readable again, whatever the length of their numbers."""

import json
from fractions import Fraction
from random import Random
from typing import Any

import pytest
from click.testing import CliRunner
from hypothesis import assume, given
from hypothesis import strategies as st
from producer import SLOT, UNIT, VALLEY
from shape_certificates import HEAD
from shape_families import untangled
from steps import count_steps
from tiers import examples

from exactsweep import (
    DirectionError,
    Polygon,
    PolygonError,
    Region,
    inner_fit_polygon,
    limits,
    no_fit_polygon,
    sweep,
)
from exactsweep.check import verify
from exactsweep.check.standalone import Refused, Work, weight
from exactsweep.cli import main
from exactsweep.evidence.proof import add_proof
from exactsweep.formats.exact_json import parse_certificate
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.limits import answer_digits
from exactsweep.text.results import certificate_to_json, sweep_to_json

LONG = Fraction(10**4299 - 1, 10**4290 + 7)
LYING = [(0, 0), (2, 1), (0, 2), (3, 2), (3, 0)]  # monotone to Y and some directions beside it
CAVE = [(0, 0), (4, 0), (4, 4), (2, 4), (2, 3), (3, 3), (3, 1), (1, 1), (1, 4), (0, 4)]


def sheared(ring: Any, one: Fraction, other: Fraction) -> list[tuple[Fraction, Fraction]]:
    """Along X, then along Y: lines along Y become (one, one * other + 1)."""
    return [(x + one * y, other * (x + one * y) + y) for x, y in ring]


@pytest.mark.parametrize(
    "triangle", [[(0, 0), ("1e2001", 0), (0, "1e2001")], [(0, 0), (1, 0), (0, "1e4000")]]
)
def test_numbers_with_exponents_come_back(triangle: Any, tmp_path: Any) -> None:
    """Once areas beyond 1e4000 were refused by the reader of certificates."""
    s = sweep(triangle, triangle)
    assert s.area == 12 * Polygon(triangle).area
    assert verify(s.certificate()).proved
    path = tmp_path / "triangle.json"
    path.write_text(json.dumps(triangle))
    once = CliRunner().invoke(main, ["convert", str(path), "--to", "json"])
    path.write_text(once.output)
    again = CliRunner().invoke(main, ["convert", str(path), "--to", "json"])
    assert once.exit_code == again.exit_code == 0
    assert once.output == again.output


@pytest.mark.parametrize("answer", [sweep, no_fit_polygon, inner_fit_polygon])
@pytest.mark.parametrize("directrix", [VALLEY, CAVE])
def test_certificates_of_long_numbers_are_proved(answer: Any, directrix: Any) -> None:
    """Coordinates of 400 digits cross over denominators of thousands, and an area has more."""
    long = Fraction(10**400 - 1, 10**390 + 7)
    moved = [(x * long + 1 / (long + 5), y / long) for x, y in directrix]
    certificate = answer(moved, [(x / 7, y / 7) for x, y in directrix]).certificate()
    assert verify(parse_certificate(json.dumps(certificate))).proved


@pytest.mark.long
def test_directions_too_long_for_readers_of_json_are_strings() -> None:
    """Once `json.dumps` ended in Python's own words."""
    one, other = Fraction(10**4290 - 1, 10**4280 + 7), Fraction(10**4288 - 1, 10**4285 + 9)
    slanted = sheared([(y, x) for x, y in LYING], one, other)
    s = sweep(slanted, slanted, direction=(one * other + 1, -one))
    certificate = parse_certificate(certificate_to_json(s))
    assert isinstance(certificate, dict)
    assert [type(c) for c in certificate["direction"]] == [str, str]
    assert verify(certificate).proved
    for written in (str(s), repr(s), repr(s.trajectory.vertices), sweep_to_json(s)):
        assert written
    with pytest.raises(DirectionError, match=r"not monotone to \(\d{21}\.\.\., -\d{20}\.\.\.\)"):
        sweep(slanted, CAVE, direction=s.direction)
    for p, q in ((["1", "0"]), (["1/2", 3]), ([" 1", 0])):
        assert verify({**certificate, "direction": [p, q]}).reason.startswith("direction")


@given(st.integers(0, 10**9), st.integers(1, 40), st.integers(1, 40))
@examples(40)
def test_loops_are_no_longer_than_their_input_allows(seed: int, above: int, below: int) -> None:
    rng = Random(seed)

    def number() -> Fraction:
        return Fraction(rng.randrange(10**above), rng.randrange(10**below) + 1)

    shapes = [
        [
            (x + number() / 10**above, y + number() / 10**above)
            for x, y in untangled(rng, 7).vertices
        ]
        for _ in "gd"
    ]
    assume(all(map(is_simple, shapes)))
    s = sweep(*shapes)
    numbers = [c for shape in (s.generatrix, s.directrix) for v in shape.vertices for c in v]
    with limits(max_digits=max(digits(format_fraction(c)) for c in numbers)):
        most = answer_digits()
    found = [s.trajectory, s.inner, s.outer, *s.unswept, *s.no_fit_holes]
    assert max(digits(format_fraction(c)) for loop in found for v in loop for c in v) <= most


def is_simple(points: Any) -> bool:
    try:
        return bool(Polygon(points))
    except PolygonError:
        return False


def digits(number: str) -> int:
    return max(map(len, number.lstrip("-").split("/")))


def test_numbers_longer_than_steps_allow_are_refused_before_they_are_read() -> None:
    certificate = sweep(UNIT, SLOT).certificate()
    for key, value in (("outer", [["-" + "9" * 10**7, "0"]]), ("area", "7/" + "3" * 10**7)):
        assert verify({**certificate, key: value}).reason.startswith("too large: to check it would")
    assert verify({**certificate, "area": "1e99999999"}).reason == "area: not a number in a string"


def test_the_input_may_be_of_any_length() -> None:
    """Once of 20,000 digits, unless `limits` said more."""
    side = 10**20_000
    assert verify(sweep(UNIT, [(0, 0), (side, 0), (0, 1)]).certificate()).proved


def reading_steps(item: Any) -> int:
    work = Work(10**9)
    work.read(item)
    return int(10**9 - work.left)


def test_reading_counts_in_steps() -> None:
    """One for each list and eight entries, and more for long numbers.

    7,874**2 is 155 * 400,000 less 124, and 7,875**2 is more; 88**2 is below both.
    """
    assert reading_steps(["1", {"a": ["2"] * 7}, 3, ["4"] * 8, None]) == 1 + 1 + 1 + 2
    assert reading_steps(["7" * 20_000]) == 1 + 2820 + 1000
    assert [reading_steps(["7" * n]) for n in (99, 100)] == [1, 2]
    for n, squares in ((7874, 154), (7875, 155)):
        assert reading_steps(["7" * n]) == 1 + n * 88 // 1000 + squares
    assert reading_steps([1 << 60_000]) == reading_steps(["7" * 20_000])
    certificate = {**sweep(UNIT, SLOT).certificate(), "area": "9" * 10**7}
    assert verify(certificate, max_steps=10**8).reason == (
        "too large: to check it would take more than 100000000 steps"
    )
    nested: list[Any] = []
    nested.append(nested)
    assert not verify({**certificate, "contacts": nested}).proved


def test_a_list_that_holds_itself_many_times_ends_the_reading() -> None:
    """Nine levels of 100 entries are 10**18 strings."""
    nested: Any = "1"
    for _ in range(9):
        nested = [nested] * 100
    for key in ("claim", "trajectory"):
        result = verify({**HEAD, key: nested}, max_steps=10**4)
        assert result.reason == "too large: to check it would take more than 10000 steps"


def test_polygons_written_by_a_program_are_read() -> None:
    """The largest number that is accepted, and its inverse, through the format of the package."""
    largest = Fraction(10**4300 - 1)
    for c in (largest, 1 / largest, LONG):
        assert Polygon([(0, 0), (format_fraction(c), 0), (0, 1)]).area == c / 2


def test_the_work_on_a_claim_counts_in_steps() -> None:
    """With m = 8, n = 4, 18 points of rings and fits and one area; but that is not all."""
    plate = Region(_box(0, 3), [_box(1, 2)])
    certificate = sweep(UNIT, plate).certificate()
    least = 3 * 8 * 4 + 64 + 16 + 101 * 18 + 1
    assert verify(certificate, max_steps=10 * least).proved
    assert verify(certificate, max_steps=least).reason.startswith("too large: ")


def _box(low: int, high: int) -> list[tuple[int, int]]:
    return [(low, low), (high, low), (high, high), (low, high)]


@pytest.mark.parametrize(("digits", "reason"), [(4300, "not a pair"), (4301, "not primitive")])
def test_a_direction_is_a_string_only_if_it_has_to_be(digits: int, reason: str) -> None:
    certificate = sweep(UNIT, SLOT).certificate()
    long = "1" + "0" * (digits - 1)
    assert verify({**certificate, "direction": [long, 2]}).reason.startswith(f"direction: {reason}")


def test_the_longest_number_is_what_a_step_costs() -> None:
    """With 6,400 bits it is 101 steps and 10; with 1,000 words of 64 bits, 1,000 and as many."""
    for bits, steps in ((63, 1), (64, 2), (6400, 111), (63940, 2000)):
        work = Work(100 * steps)
        work.weight = weight(bits)
        work.take(100)
        with pytest.raises(Refused, match="too large"):
            work.take(1)


def find_least(certificate: Any) -> int:
    """Find the fewest steps with which a certificate is proved."""
    least = max(count_steps(certificate))
    assert verify(certificate, max_steps=least).proved
    assert not verify(certificate, max_steps=least - 1).proved
    return least


@pytest.mark.parametrize("answer", [sweep, no_fit_polygon])
def test_long_numbers_count_with_their_length(answer: Any) -> None:
    """The same in other units: of 20 words of 64 bits each step costs 20 times as much."""
    least = []
    for unit in (1, 2**1260):
        part, plate = ([(unit * x, unit * y) for x, y in ring] for ring in (UNIT, SLOT))
        least.append(find_least(add_proof(answer(plate, part).certificate())))
    assert 10 * least[0] < least[1] < 30 * least[0]


def test_each_drawing_takes_a_step() -> None:
    certificate = sweep(UNIT, SLOT).certificate()
    least = find_least(certificate)
    kinds = "vertex", "edge"
    certificate["inner_drawn"][0] = [
        [[one, i], [other, j]]
        for one in kinds
        for i in range(len(certificate["trajectory"]))
        for other in kinds
        for j in range(4)
    ]
    assert verify(certificate).reason == "inner_drawn[0]: a drawing is not along the edge"
    assert verify(certificate, max_steps=least).reason.startswith("too large")


def test_each_fault_of_a_layout_takes_the_steps_of_its_part() -> None:
    ring = [[str(k), str(k * k)] for k in range(30)]
    part = {"exterior": ring, "demand": 1}
    parts = [part | {"id": f"{k}"} for k in range(11)]
    certificate: dict[str, Any] = {
        **HEAD,
        "kind": "layout",
        "layout": {"container": {"exterior": ring}, "parts": parts, "placements": []},
        "valid": False,
        "turns": [],
        "frame": ["0", "0", "1", "1"],
        "pieces": [None] * 11,
        "outside": None,
        "apart": [],
    }

    def measure(**fault: Any) -> int:
        faults = [{**fault, "part": part["id"]} for part in parts]
        one, eleven = (find_least({**certificate, "faults": faults[:n]}) for n in (1, 11))
        return eleven - one

    assert measure(kind="missing") >= 10 * len(ring)
    # The points of a ring are read again as written, and so are the turns that are allowed.
    for part in parts:
        part |= {"exterior": [ring[0]] * 100 + [["2", "2"], ["1", "1"]], "turns": ["0"] * 100}
    assert measure(kind="shape", edges=[[0, 0], [0, 1]]) >= 10 * 100
    assert measure(kind="missing") >= 10 * 100
    certificate["faults"] = [{"kind": "missing", "part": "0"}]
    for part in parts:
        part |= {"exterior": ring, "turns": None, "demand": 20}
    placed = {"part": "0", "turn": "0", "move": ["0", "0"]}
    least = []
    for count in (1, 11):
        certificate["layout"]["placements"] = [placed] * count
        least.append(find_least({**certificate, "turns": [["1", "0"]] * count}))
    assert least[1] - least[0] >= 10 * len(ring)
