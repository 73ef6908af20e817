"""Answers with their evidence: contacts, undercuts, exact fits, certificates."""
