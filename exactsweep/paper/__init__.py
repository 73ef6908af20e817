"""The claims of the paper, with a verdict and evidence for each; see README.md."""
