"""The thirteen figures of the paper, redrawn from computed sweeps of other polygons.

Each figure has a row in the ledger and a module here, which computes its statements and shapes.
`drawing` draws the shapes by the instructions in `drawings.toml`, with matplotlib.
"""
