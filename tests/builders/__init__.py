"""The shipped corpus: cases are added to its files, never changed; and its parametric families."""
