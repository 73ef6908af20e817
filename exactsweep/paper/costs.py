"""The claimed bounds, compared with counts and measurements at doubling sizes.

CPU seconds are measured at larger sizes, in full runs only. Each bound is tested with both sizes
doubled and with only m or n doubled: with m = n, an m² term would pass for mn.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import product
from pkgutil import resolve_name
from typing import Any

from exactsweep.corpus.generator import growing
from exactsweep.paper import kernel, read_toml
from exactsweep.paper.claim import Effort, Evidence, Observation, Table
from exactsweep.paper.counting import PairFamily, count_by, grow
from exactsweep.paper.functions import clip_to, keep_corners
from exactsweep.paper.growth import BOUNDS, LIMITS, M_PLUS_N, Bound, Growth, write_power
from exactsweep.paper.pairs import Chains, SweepPair

DOUBLINGS, QUICK_DOUBLINGS, RETRIES = 5, 3, 3
UNITS = ("operations", "seconds", "bytes")

Procedure = Callable[[Chains], Iterable[Any]]


@dataclass(frozen=True)
class Cost:
    """One procedure on one family, with m, n or both doubled.

    `printed` is the procedure as printed, `row` the ledger row with the bound, and `varied` is "m",
    "n" or "mn". Sizes start at `first` for operations and bytes, at `timed` for seconds; `fixed` is
    the other size. For `limit` on operations and `slack` on bytes see `Growth`.
    """

    procedure: str
    run: Procedure
    printed: Procedure
    row: str
    bound: Bound
    family: PairFamily
    varied: str
    first: int
    timed: int
    fixed: int = 16
    limit: float = 1.08
    slack: float = LIMITS["bytes"]

    def sizes(self, first: int, doublings: int) -> list[tuple[int, int]]:
        doubled = [first << k for k in range(doublings + 1)]
        return [
            (x if "m" in self.varied else self.fixed, x if "n" in self.varied else self.fixed)
            for x in doubled
        ]

    def _doublings(self, effort: Effort, quick: int) -> int:
        """Return the number of doublings, which quick runs reduce except for linear procedures."""
        return quick if effort.quick and self.bound is not M_PLUS_N else DOUBLINGS

    def grow(self, unit: str, sizes: Iterable[tuple[int, int]], limit: float = 1.08) -> Growth:
        what, count = f"{unit} of {self.procedure}", count_by(unit, self.run)
        return grow(what, self.family, self.bound, sizes, count, limit)

    def compare(self) -> Iterator[str]:
        """Compare the output with that of the printed procedure at the three smallest sizes."""
        for m, n in self.sizes(self.first, 2):
            chains = SweepPair(*self.family(m, n)).chains
            found, printed = keep_corners(self.run(chains)), keep_corners(self.printed(chains))
            if found != clip_to(printed, found):
                yield f"{self.procedure} is wrong on {self.family.__name__}, ({m}, {n})"

    def time(self) -> Growth:
        """Measure CPU seconds; repeat if they exceed the bound, in case the machine is busy."""
        sizes = self.sizes(self.timed, DOUBLINGS)
        series = self.grow("seconds", sizes)
        for _ in range(RETRIES):
            if not series.is_flat:
                series = series.take_minima(self.grow("seconds", sizes))
        return series

    def measure(self, effort: Effort) -> Iterator[Growth]:
        sizes = self.sizes(self.first, self._doublings(effort, QUICK_DOUBLINGS))
        yield self.grow("operations", sizes, self.limit)
        yield self.grow("bytes", self.sizes(self.first, self._doublings(effort, 2)), self.slack)
        if not effort.quick:
            yield self.time()


_PROCEDURES: dict[str, tuple[Procedure, Procedure]] = {
    "Trajectory_CC": (lambda c: kernel.trajectory_cc(*c[::2]), kernel.find_trajectory),
    "SweepI_CC": (lambda c: kernel.sweep_inner_cc(*c[::2]), kernel.find_inner),
    "SweepO_CC": (lambda c: kernel.sweep_outer_cc(*c), kernel.find_outer),
    "Trajectory_CM": (lambda c: kernel.trajectory_cm(*c[::2]), kernel.find_trajectory),
    "SweepI_CM": (lambda c: kernel.sweep_inner_cm(*c[::2]), kernel.find_inner),
    "SweepO_CM": (lambda c: kernel.sweep_outer_cm(*c), kernel.find_outer),
    "Trajectory_MM": (lambda c: kernel.trajectory_mm(*c[::2]), kernel.find_trajectory),
    "Trajectory_MM as printed": (kernel.merge_sub_trajectories, kernel.find_trajectory),
    "Sweep_MM, outer loop": (lambda c: kernel.sweep_mm(*c)[1], kernel.find_outer),
    "Sweep_MM, inner loop": (lambda c: kernel.sweep_mm(*c)[0], kernel.find_inner),
}
"""Each procedure of the kernel, and the same as printed."""
RUNS = {name: run for name, (run, _) in _PROCEDURES.items()}


def _list_costs() -> Iterator[Cost]:
    for group in read_toml("costs.toml")["cost"]:
        for name, series in product(group.pop("procedures"), group.pop("series")):
            read = group | series
            read |= {"bound": BOUNDS[read["bound"]], "family": getattr(growing, read["family"])}
            yield Cost(name, *_PROCEDURES[name], **read)


COSTS = tuple(_list_costs())


def tabulate(growth: Iterable[Growth]) -> Table:
    lines: dict[tuple[str, str, str], dict[str, Growth]] = {}
    for series in growth:
        if series.unit in UNITS:
            key = series.what.partition(" of ")[2], series.family, series.varied
            lines.setdefault(key, {})[series.unit] = series
    rows = []
    for (procedure, family, varied), found in lines.items():
        one = next(iter(found.values()))
        exponents = {unit: write_power(s.exponent(s.fitted_sizes)) for unit, s in found.items()}
        verdict = "within" if all(series.is_flat for series in found.values()) else "beyond"
        powers = write_power(one.claimed()), *(exponents.get(unit, "-") for unit in UNITS)
        rows.append([procedure, family, varied, one.bound, *powers, verdict])
    header = ("procedure", "family", "doubled", "bound", "its exponent", *UNITS, "verdict")
    return Table("Exponents of the claimed bounds and of the measurements", header, rows)


def compare_outputs(procedure: str, effort: Effort) -> Iterator[Observation]:
    costs = [c for c in COSTS if c.procedure.partition(",")[0] == procedure]
    m, n = map(max, zip(*(size for c in costs for size in c.sizes(c.first, 2)), strict=True))
    what = "on families, equal to those of the printed procedure"
    yield Evidence(f"Outputs up to m = {m} and n = {n}, {what}.")
    for cost in costs:
        yield from cost.compare()


def measure_costs(row: str, effort: Effort) -> Iterator[Observation]:
    skipped = " A quick run skips seconds and large sizes." if effort.quick else ""
    measured = "Operations, bytes and seconds are measured over doubling sizes"
    yield Evidence(f"{measured}, and outputs are compared.{skipped}")
    for cost in COSTS:
        if cost.row == row:
            yield from cost.compare()
            yield from cost.measure(effort)


def count_all(row: str, effort: Effort) -> Iterator[Growth]:
    for group in read_toml("counts.toml")["count"]:
        for series in group.pop("series") if group.pop("row") == row else ():
            read = group | series
            (a, b), (c, d) = read.pop("m", (1, 0)), read.pop("n", (1, 0))
            sizes = [(a * k + b, c * k + d) for k, _ in effort.sizes(*read.pop("sizes", ()))]
            name, bound = read.pop("count"), read.pop("bound")
            read["count"] = (
                count_by("vertices", RUNS[name])
                if name in RUNS
                else resolve_name(f"{__package__}.checks.{name}")
            )
            read["family"] = getattr(growing, read["family"])
            yield grow(bound=BOUNDS.get(bound, bound), sizes=sizes, **read)
