"""The paper, claim by claim: what it says, whether it holds, and how one can see that.

`ledger.toml` has a row for each definition, theorem, lemma, corollary, table, procedure and figure,
and for what the paper says without proof, in the order of the paper; at its head stands what a row
consists of. A row names functions of `checks`: laws, which are tried on random pairs, and a check,
which looks for counterexamples otherwise, or counts. `ledger.CLAIMS` has the rows,
`claim.reproduce` checks them, `report.write` makes a report of what they find; on the command line,
`exactsweep reproduce` does all of it. To add a row, write it into `ledger.toml`.
"""
