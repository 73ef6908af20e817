"""Exact numbers and points: read, limited, written. Below words and canvas."""
