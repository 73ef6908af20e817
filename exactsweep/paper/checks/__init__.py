"""The checks of the ledger, by section of the paper."""
