"""Runs of a program over cases: protocol, processes, journal."""
