"""The paper, claim by claim: statements, verdicts and evidence.

`ledger.toml` has a row for each definition, theorem, lemma, corollary, table, procedure and figure,
and for each remark without proof, in the order of the paper; its head describes a row. A row names
functions of `checks`: laws, to try on random pairs, and a check, which looks for counterexamples in
other methods, or counts. `ledger.CLAIMS` has the rows, `claim.reproduce` checks them, and
`report.write` reports the findings, as does the command `exactsweep reproduce`.
"""
