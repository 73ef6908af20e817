"""Write the golden files anew: `python -m tests.goldens [NAME...]`. Look at the changes in git."""

import sys
from pathlib import Path

# The tests import one another by bare names, as pytest sets them up.
sys.path.extend([str(Path(__file__).parents[1]), str(Path(__file__).parents[1] / "support")])
from goldens.texts import TEXTS, list_rows

if __name__ == "__main__":
    for name, lines in (TEXTS | {"ledger": list_rows}).items():
        if name in (sys.argv[1:] or (name,)):
            text = "".join(f"{line}\n" for line in lines())
            Path(__file__).with_name(f"{name}.txt").write_text(text, encoding="utf-8")
