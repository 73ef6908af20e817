"""Sweeps and fits with their reasons: contacts, undercuts, exact fits, certificates."""
