"""The procedures of the paper, section by section, and what grew from them."""
