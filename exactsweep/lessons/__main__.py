"""The command `python -m exactsweep.lessons`, which runs all lessons and stores their output."""

from exactsweep.lessons import notebook

for name in notebook.list_titles():
    document = notebook.run_notebook(notebook.read_notebook(name))
    notebook.write_notebook(notebook.FOLDER / f"{name}.ipynb", document)
