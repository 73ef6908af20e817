"""The paper, claim by claim: what it says, whether it holds, and how one can see that.

`ledger.CLAIMS` has a row for each definition, theorem, lemma, corollary, table and procedure, and
for what the paper says without proof. `reproduce.reproduce` runs the checks, `report.write` makes
a report of them; on the command line, `exactsweep reproduce` does both.
"""
