"""The judge of one answer: comparison, diagnosis, verdict and witness."""
