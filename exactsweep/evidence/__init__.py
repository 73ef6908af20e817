"""Reasons for a sweep: contacts, undercuts, exact fits, and the certificate."""
