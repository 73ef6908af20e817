"""The thirteen figures of the paper, redrawn from computed sweeps of other polygons.

Each figure is a row of the ledger, and a module here. The module computes the figure's statements,
which its check compares with the definition, and its shapes, which `drawing` draws as
`drawings.toml` says. Drawing needs matplotlib, the `plot` extra.
"""
