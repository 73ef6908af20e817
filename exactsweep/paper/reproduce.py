"""Run the checks of claims."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from time import process_time

from exactsweep.paper.claim import Claim, Evidence, Row, Run


def reproduce(claims: Iterable[Claim], run: Run) -> Iterator[Row]:
    """Check claims one by one.

    Args:
        claims: rows of the ledger.
        run: the seed and the effort.

    Yields:
        A Row for each claim.  A check that breaks off counts as one that fails.

    Example:
        >>> from exactsweep.paper.ledger import find
        >>> row, = reproduce([find("Slope")], Run(quick=True))
        >>> row.claim.status.value, row.disagreement
        ('refuted as stated', '')
    """
    for claim in claims:
        start = process_time()
        try:
            evidence = claim.check(run)
        except Exception as error:
            evidence = Evidence("broken off", f"{type(error).__name__}: {error}")
        yield Row(claim, evidence, process_time() - start)
