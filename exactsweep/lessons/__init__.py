"""Lessons: notebooks, which the tests run, stored with their output."""

from exactsweep.lessons.notebook import list_titles, read_notebook, run_notebook

__all__ = ["list_titles", "read_notebook", "run_notebook"]
