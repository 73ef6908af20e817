"""An interactive page of a sweep, as one HTML file."""

from exactsweep.view.inline import InlinePage
from exactsweep.view.page import make_page

__all__ = ["InlinePage", "make_page"]
