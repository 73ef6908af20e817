"""Certificates as theorems: claims for the checker that is proved in Coq."""
