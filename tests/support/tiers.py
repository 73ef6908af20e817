"""How many examples a property is tried on: a few in the plain run, many in the long one."""

from hypothesis import settings


def examples(many: int) -> settings:
    """So many with `--hypothesis-profile many`, as in the long run, a quarter else."""
    return settings(max_examples=-(-many * settings().max_examples // 100))
