"""The pair that is swept when none is given."""

from exactsweep.polygon import Polygon

# A house that cannot reach the bottom of a lopsided notch: a CM sweep with one undercut. All
# loops have finite decimal coordinates, so that every output format can hold them.
GENERATRIX = Polygon([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)])
DIRECTRIX = Polygon([(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)])
