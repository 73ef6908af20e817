"""The claims of the paper, with a verdict and evidence for each.

`ledger.toml` lists all definitions, theorems, lemmas, procedures and figures of the paper, and its
unproved remarks. `ledger.CLAIMS` holds the entries, `claim.reproduce` checks them, and
`report.write` writes a report, like the command `exactsweep reproduce`.
"""
