"""A case by its id."""

from exactsweep.corpus.case import Case
from exactsweep.corpus.generator import generated_case
from exactsweep.corpus.shipped import shipped_case


def find_case(id: str) -> Case:
    """Return the case of this id: a shipped one, or a generated one, made again.

    Raises:
        UnknownNameError: there is none; the message suggests one whose id is similar.

    Example:
        >>> find_case("gen-convex-1-0").kind
        'CC'
    """
    return generated_case(id) if id.startswith("gen-") else shipped_case(id)
