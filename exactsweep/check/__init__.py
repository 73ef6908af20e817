"""Checkers, which work from the definition alone and share no code with the computation."""

from exactsweep.check.classify import Classification, classify
from exactsweep.check.location import point_in_polygon
from exactsweep.check.verify import Verification, verify

__all__ = ["Classification", "Verification", "classify", "point_in_polygon", "verify"]
