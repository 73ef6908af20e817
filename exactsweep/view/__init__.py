"""The interactive page of a result, as one HTML file."""

from exactsweep.view.page import InlinePage, make_page

__all__ = ["InlinePage", "make_page"]
