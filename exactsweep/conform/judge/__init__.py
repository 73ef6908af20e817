"""Judging one answer: comparison, verdict, witness, shrinking."""
