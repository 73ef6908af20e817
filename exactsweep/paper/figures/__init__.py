"""The thirteen figures of the paper, redrawn from computed sweeps of polygons of our own.

Each is a row of the ledger, and a module of this folder: what it states is computed, and its check
holds that against the definition. Drawing needs matplotlib, the `plot` extra.
"""
