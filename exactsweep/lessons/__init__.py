"""Lessons: notebooks that are run by the tests and stored with what they show."""

from exactsweep.lessons.notebook import list_titles, read_notebook, run_notebook

__all__ = ["list_titles", "read_notebook", "run_notebook"]
