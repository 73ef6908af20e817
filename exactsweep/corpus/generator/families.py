"""The families of the generator, and their cases."""

import re
from collections.abc import Callable, Iterator
from inspect import cleandoc
from itertools import count as count_from
from typing import Any, NamedTuple

from exactsweep.corpus.case import Case
from exactsweep.corpus.generator import any_shape, numeric, plain
from exactsweep.corpus.generator.prng import Prng
from exactsweep.corpus.names import UnknownNameError, require_known
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import ExactSweepError, explain_type_errors, quote

_ID = re.compile(r"gen-([a-z0-9-]+)-(0|[1-9][0-9]{0,17})-(0|[1-9][0-9]{0,17})")
# The families by level.
LEVELS = {
    "easy": (plain, "convex notched monotone"),
    "degenerate": (plain, "grid rectilinear fits equal-slopes tangent turned respelled"),
    "numeric": (
        numeric,
        "rounded-crossings far fractions slivers near-parallel near-fits perturbed int32-edge "
        "int64-edge binary64-edge",
    ),
    "large": (numeric, "unequal lower-bound long"),
    "any shape": (
        any_shape,
        "polyominoes jigsaw mould cave spiral rings stars tangles plate container combs",
    ),
}
FLAGS = {
    "tangent": "tangent",
    "slivers": "sliver",
    "near-fits": "near-fit",
    "lower-bound": "lower-bound",
}


class Family(NamedTuple):
    """A family of generated pairs."""

    name: str
    level: str  # "easy", "degenerate", "numeric", "large" or "any shape"
    make: Callable[[Prng], Any]  # draws G and D, as lists of pairs of numbers or as Regions
    flags: tuple[str, ...] = ()  # of all cases, besides the results of `find_flags`
    respelled: bool = False  # whether the vertices stay as generated instead of canonical

    @property
    def description(self) -> str:
        """The description of its pairs."""
        return cleandoc(self.make.__doc__ or "")

    @property
    def summary(self) -> str:
        """The first line of the description."""
        return self.description.partition("\n")[0]


FAMILIES: dict[str, Family] = {
    name: Family(
        name,
        level,
        getattr(module, f"{name.replace('-', '_')}_pair"),
        (FLAGS[name],) if name in FLAGS else (),
        respelled=name == "respelled",
    )
    for level, (module, names) in LEVELS.items()
    for name in names.split()
}


@explain_type_errors
def generate(family: str, seed: int, count: int | None = None) -> Iterator[Case]:
    """Yield the cases of a family.

    A case depends only on the family, the seed and its number, counted from 0.

    Args:
        family: a name in `FAMILIES`.
        seed: an int from 0 to 10**18 - 1.
        count: the number of cases; None for infinitely many.

    Raises:
        UnknownNameError: the family does not exist.
        ValueError: the seed is out of range, or the count is negative.

    Example:
        >>> [case.id for case in generate("fits", 7, 2)]
        ['gen-fits-7-0', 'gen-fits-7-1']
    """
    chosen = FAMILIES[require_known(family, FAMILIES, "family")]
    if not 0 <= seed < 10**18:
        raise ExactSweepError(f"the seed {seed} is outside the range 0 to 10**18 - 1")
    if count is not None and count < 0:
        raise ExactSweepError(f"the count is negative: {count}")
    numbers = count_from() if count is None else range(count)
    return (_make(chosen, seed, number) for number in numbers)


def generate_case(id: str) -> Case:
    """Make the case with an id gen-FAMILY-SEED-NUMBER."""
    match = _ID.fullmatch(id)
    if match is None:
        raise UnknownNameError(f"{quote(id)} is not of the form gen-FAMILY-SEED-NUMBER")
    family, seed, number = match.groups()
    return _make(FAMILIES[require_known(family, FAMILIES, "family")], int(seed), int(number))


def _make(family: Family, seed: int, number: int) -> Case:
    random = Prng(f"{family.name}:{seed}:{number}")
    of_any_shape = family.level == "any shape"
    pair = any_shape.place(random, family.make) if of_any_shape else family.make(random)
    generatrix, directrix = pair
    corner = generatrix.vertices[0] if of_any_shape else generatrix[-1]
    if not (family.respelled or of_any_shape):
        generatrix, directrix = Polygon(generatrix), Polygon(directrix)
    return Case.of(
        f"gen-{family.name}-{seed}-{number}",
        f"Family {family.name}, seed {seed}, number {number}",
        directrix,
        generatrix,
        random.choice([(0, 0), (0, 0), corner]),
        ("generated", *family.flags),
        inner_fit=of_any_shape,
    )
