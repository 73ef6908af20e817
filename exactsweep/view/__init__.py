"""An interactive page of a sweep, as one HTML file."""

from exactsweep.view.inline import InlinePage
from exactsweep.view.page import page

__all__ = ["InlinePage", "page"]
