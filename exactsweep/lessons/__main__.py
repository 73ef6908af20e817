"""Runs the lessons and stores what they show: `python -m exactsweep.lessons`."""

from exactsweep.lessons.notebook import FOLDER, read_notebook, run_notebook, titles, write_notebook

for name in titles():
    write_notebook(FOLDER / f"{name}.ipynb", run_notebook(read_notebook(name)))
