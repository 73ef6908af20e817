"""The families of the generator, and the cases of a family."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import partial
from inspect import cleandoc
from itertools import count as count_from
from typing import Any, NamedTuple

from exactsweep.corpus.case import Case
from exactsweep.corpus.generator import any_shape, large, numeric, plain
from exactsweep.corpus.generator.prng import Prng
from exactsweep.corpus.names import UnknownNameError, require_known
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.arguments import tells_arguments
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import quote

_ID = re.compile(r"gen-([a-z0-9-]+)-(0|[1-9][0-9]{0,17})-(0|[1-9][0-9]{0,17})")


class Family(NamedTuple):
    """A family of generated pairs.

    Attributes:
        name: as on the command line.
        level: "easy", "degenerate", "numeric", "large" or "any shape": what it takes to get it
            right.
        make: draws generatrix and directrix, as lists of pairs of numbers or as Regions.
        flags: flags of all its cases that cannot be seen from the pair.
        respelled: whether the vertices are given as drawn, and not in canonical form.
    """

    name: str
    level: str
    make: Callable[[Prng], tuple[Any, Any]]
    flags: tuple[str, ...] = ()
    respelled: bool = False

    @property
    def description(self) -> str:
        """The description of its pairs."""
        return cleandoc(self.make.__doc__ or "")

    @property
    def summary(self) -> str:
        """The description of its pairs, in one line."""
        return self.description.partition("\n")[0]


FAMILIES: dict[str, Family] = {
    family.name: family
    for family in [
        Family("convex", "easy", plain.convex_pair),
        Family("notched", "easy", plain.notched_pair),
        Family("monotone", "easy", plain.monotone_pair),
        Family("grid", "degenerate", plain.grid_pair),
        Family("rectilinear", "degenerate", plain.rectilinear_pair),
        Family("fits", "degenerate", plain.fitting_pair),
        Family("equal-slopes", "degenerate", plain.equal_slopes_pair),
        Family("tangent", "degenerate", plain.tangent_pair, ("tangent",)),
        Family("turned", "degenerate", plain.turned_pair),
        Family("respelled", "degenerate", plain.respelled_pair, respelled=True),
        Family("rounded-crossings", "numeric", numeric.rounded_crossings_pair),
        Family("far", "numeric", numeric.far_pair),
        Family("fractions", "numeric", numeric.fractions_pair),
        Family("slivers", "numeric", numeric.sliver_pair, ("sliver",)),
        Family("near-parallel", "numeric", numeric.near_parallel_pair),
        Family("near-fits", "numeric", numeric.near_fit_pair, ("near-fit",)),
        Family("perturbed", "numeric", numeric.perturbed_pair),
        Family("int32-edge", "numeric", numeric.int32_edge_pair),
        Family("int64-edge", "numeric", numeric.int64_edge_pair),
        Family("binary64-edge", "numeric", numeric.binary64_edge_pair),
        Family("unequal", "large", large.unequal_pair),
        Family("lower-bound", "large", large.lower_bound_pair, ("lower-bound",)),
        Family("long", "large", large.long_pair),
        *(Family(name, "any shape", draw) for name, draw in any_shape.SHAPES.items()),
    ]
}


@tells_arguments
def generate(family: str, seed: int, count: int | None = None) -> Iterator[Case]:
    """Yield the cases of a family, making them one by one.

    A case depends on the family, the seed and its number alone; the stream of random numbers is
    that of `exactsweep.corpus.generator.prng`, seeded with "FAMILY:SEED:NUMBER".

    Args:
        family: a name in `FAMILIES`.
        seed: an int from 0 to 10**18 - 1, so that `generate_case` knows the ids.
        count: how many; without end if left out.

    Returns:
        An iterator of Case, numbered from 0: the ids are gen-FAMILY-SEED-NUMBER.

    Raises:
        UnknownNameError: no such family.
        ValueError: the seed is another number, or the count is negative.

    Cost: that of `Case.of`, a case.

    Example:
        >>> [case.id for case in generate("fits", 7, 2)]
        ['gen-fits-7-0', 'gen-fits-7-1']
    """
    chosen = FAMILIES[require_known(family, FAMILIES, "family")]
    if not 0 <= seed < 10**18:
        raise ExactSweepError(f"the seed is {seed}, which is not from 0 to 10**18 - 1")
    if count is not None and count < 0:
        raise ExactSweepError(f"the count is negative: {count}")
    numbers = count_from() if count is None else range(count)
    return (_make(chosen, seed, number) for number in numbers)


def generate_case(id: str) -> Case:
    """Make a generated case again, from its id.

    Args:
        id: gen-FAMILY-SEED-NUMBER.

    Returns:
        The same Case that `generate` yielded.

    Raises:
        UnknownNameError: the id is not of this form, or there is no such family.

    Example:
        >>> generate_case("gen-fits-7-1") == list(generate("fits", 7, 2))[1]
        True
    """
    match = _ID.fullmatch(id)
    if match is None:
        raise UnknownNameError(f"{quote(id)} is not of the form gen-FAMILY-SEED-NUMBER")
    family, seed, number = match.groups()
    return _make(FAMILIES[require_known(family, FAMILIES, "family")], int(seed), int(number))


def _make(family: Family, seed: int, number: int) -> Case:
    random = Prng(f"{family.name}:{seed}:{number}")
    of_any_shape = family.name in any_shape.SHAPES
    make: Callable[[Prng], tuple[Any, Any]] = family.make
    if of_any_shape:
        make = partial(any_shape.place, draw=family.make)
    generatrix, directrix = make(random)
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
