"""The checking side: answers from the definition alone, sharing no code with the computation."""

from exactsweep.check.classify import Classification, classify
from exactsweep.check.definition import ReferenceLoops, reference_exact_fits, reference_loops
from exactsweep.check.location import point_in_polygon
from exactsweep.check.no_fit import (
    ReferenceInnerFit,
    ReferenceNoFit,
    ReferenceSwept,
    reference_inner_fit,
    reference_no_fit,
    reference_swept,
)
from exactsweep.check.verify import Verification, verify

__all__ = [
    "Classification",
    "ReferenceInnerFit",
    "ReferenceLoops",
    "ReferenceNoFit",
    "ReferenceSwept",
    "Verification",
    "classify",
    "point_in_polygon",
    "reference_exact_fits",
    "reference_inner_fit",
    "reference_loops",
    "reference_no_fit",
    "reference_swept",
    "verify",
]
