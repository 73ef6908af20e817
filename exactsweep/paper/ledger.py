"""All rows of the ledger, in the order of the paper, and how to find one by its name."""

from __future__ import annotations

from difflib import get_close_matches

from exactsweep.paper import figures
from exactsweep.paper.checks import (
    appendix,
    section1,
    section2,
    section3,
    section4,
    section4_sizes,
    section5,
    section5_sizes,
    section5_time,
)
from exactsweep.paper.claim import Claim

ORDER = (
    "Definition 1.1",
    "Definition 1.2",
    "Definition 1.3",
    "Paths of two points",
    "Sweep and Minkowski sum",
    "Figure 1",
    "Theorem 2.1",
    "Figure 2",
    "Theorem 2.2",
    "Definition 2.1",
    "Figure 3",
    "Distance travelled",
    "Table 1",
    "VV is incidental",
    "Convex chain",
    "Definition 3.1",
    "Slope",
    "Lemma 3.1",
    "Figure 4",
    "Lemma 3.2",
    "Figure 5",
    "Corollary 3.3",
    "Trajectory_CC",
    "SweepI_CC",
    "SweepO_CC",
    "Corollary 3.4",
    "Lemma 4.1",
    "Figure 6",
    "Lemma 4.2",
    "Total size of the parts",
    "Corollary 4.3",
    "Every edge of D is touched",
    "Number of undercuts",
    "Corollary 4.4",
    "Monotone inner boundary",
    "Trajectory_CM",
    "SweepI_CM",
    "SweepO_CM",
    "Corollary 4.5",
    "Two forms of a bottom chain",
    "Figure 7",
    "Corollary 4.6",
    "Lemma 5.1",
    "Lemma 5.2",
    "Monotone trajectory",
    "Definition 5.1",
    "Definition 5.2",
    "Lemma 5.3",
    "Figure 8",
    "Local width",
    "Figure 9",
    "Corollary 5.4",
    "Lemma 5.5",
    "Lemma 5.6",
    "Figure 10",
    "Figure 10's count",
    "Trajectory_MM",
    "Sweep_MM",
    "Two chains in linear time",
    "Levels of divide and conquer",
    "LowerEnvelope_MM",
    "Corollary 5.7",
    "Corollary 5.8",
    "A faster inner loop",
    "Figure 11",
    "Lemma A.1",
    "Figure 12",
    "Lemma A.2",
    "Figure 13",
    "Lemma A.3",
    "Corollary A.4",
    "LowerEnvelope_CM",
)
_MODULES = (
    section1,
    section2,
    section3,
    section4,
    section4_sizes,
    section5,
    section5_sizes,
    section5_time,
    appendix,
    figures,
)
_BY_NAME: dict[str, Claim] = {claim.name: claim for module in _MODULES for claim in module.CLAIMS}
CLAIMS: tuple[Claim, ...] = tuple(_BY_NAME[name] for name in ORDER)


class UnknownClaimError(ValueError):
    """A name that no row of the ledger has."""


def find(name: str) -> Claim:
    """Return the claim of a name, upper and lower case being the same.

    Raises:
        UnknownClaimError: there is none; the message suggests others.

    >>> find("lemma 5.3").name
    'Lemma 5.3'
    >>> find("Lema 5.3")
    Traceback (most recent call last):
    exactsweep.paper.ledger.UnknownClaimError: no claim 'Lema 5.3'; did you mean 'Lemma 5.3'?
    """
    wanted = " ".join(name.lower().split())
    names = {known.lower(): known for known in ORDER}
    if wanted in names:
        return _BY_NAME[names[wanted]]
    close = [known for known in names if wanted and wanted in known]
    close += [known for known in get_close_matches(wanted, names, 1) if known not in close]
    meant = " or ".join(f"'{names[known]}'" for known in close[:3])
    hint = f"did you mean {meant}?" if meant else "'--list' shows them all"
    raise UnknownClaimError(f"no claim '{name}'; {hint}")
