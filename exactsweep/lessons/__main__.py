"""The command `python -m exactsweep.lessons`, which runs all lessons and stores their output."""

from exactsweep.lessons.notebook import (
    FOLDER,
    list_titles,
    read_notebook,
    run_notebook,
    write_notebook,
)

for name in list_titles():
    write_notebook(FOLDER / f"{name}.ipynb", run_notebook(read_notebook(name)))
