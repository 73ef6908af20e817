"""The builders of the shipped corpus; `python -m tests.builders` adds what they add.

The inputs come from here and the answers from the sweep. A case, once shipped, is never changed.
"""
