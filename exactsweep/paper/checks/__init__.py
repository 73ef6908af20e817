"""The checks of the ledger, section by section."""
