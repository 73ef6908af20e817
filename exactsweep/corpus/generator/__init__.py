"""Case generator: named families of seeded random cases, reproducible on every machine."""

from exactsweep.corpus.generator.families import FAMILIES, Family, generate, generate_case

__all__ = ["FAMILIES", "Family", "generate", "generate_case"]
