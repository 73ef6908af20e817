"""Lessons: notebooks with stored output."""

from exactsweep.lessons.notebook import list_titles, read_notebook, run_notebook
from exactsweep.lessons.page import render_lesson

__all__ = ["list_titles", "read_notebook", "render_lesson", "run_notebook"]
