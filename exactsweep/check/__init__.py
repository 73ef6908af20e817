"""The checking side: answers from the definition alone, sharing no code with the computation."""

from exactsweep.check.classify import Classification, classify
from exactsweep.check.definition import ReferenceLoops, reference_exact_fits, reference_loops
from exactsweep.check.location import point_in_polygon
from exactsweep.check.verify import Verification, verify

__all__ = [
    "Classification",
    "ReferenceLoops",
    "Verification",
    "classify",
    "point_in_polygon",
    "reference_exact_fits",
    "reference_loops",
    "verify",
]
