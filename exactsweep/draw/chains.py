"""Pictures of chains, sub-trajectories and envelopes."""

from collections.abc import Iterable, Mapping

from exactsweep.canvas import style
from exactsweep.draw.picture import Picture
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Vertex


@explain_type_errors
def draw_chains(picture: Picture, chains: Mapping[str, Iterable[Vertex]]) -> None:
    """Draw named chains, each with its own color and marker."""
    for k, (name, chain) in enumerate(chains.items()):
        picture.line(chain, style.choose_chain_look(k), name)


@explain_type_errors
def draw_sub_trajectories(
    picture: Picture, chains: Iterable[Iterable[Vertex]], envelope: Iterable[Vertex] | None = None
) -> None:
    """Draw sub-trajectories as thin dashed lines, and their lower envelope in bold."""
    for chain in chains:
        picture.line(chain, style.SUB_TRAJECTORY, "sub-trajectory")
    if envelope is not None:
        picture.line(envelope, style.ENVELOPE, "lower envelope")
