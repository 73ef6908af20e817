"""Lessons: notebooks that are run by the tests and stored with what they show."""

from exactsweep.lessons.notebook import read_notebook, run_notebook, titles

__all__ = ["read_notebook", "run_notebook", "titles"]
