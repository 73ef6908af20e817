"""The pair of Figure 10, for all even sizes."""

from __future__ import annotations

Pair = tuple[int, int]


def bumps(m_b: int, n_t: int, n_b: int) -> tuple[list[Pair], list[Pair]]:
    """The pair of Figure 10: m_b / 2 teeth in D_b, n_t / 2 peaks in G_t, a round tip in G_b.

    Each peak passes under each tooth at a place of its own, and every time G_b draws its tip, which
    has n_b - 2 flat edges between steep flanks: the outer boundary of the lower sweep has
    m_b n_t n_b / 4 + 4 edges, 16 for (2, 4, 6).  m_b, n_t and n_b are even.
    """
    flat = n_b - 2
    pitch = 2 * flat + 2
    half = n_t * pitch // 4
    tooth, peak, flank = (flat + 1) * half, (flat + 2) * pitch // 2, (flat + 3) * (half - flat // 2)
    bottom = [(half * k, -tooth if k % 2 else 0) for k in range(m_b + 1)]
    directrix = [*bottom, (half * m_b // 2, tooth)]
    tip = [(half - flat // 2, -flank)]
    for k in range(flat):
        tip.append((tip[-1][0] + 1, tip[-1][1] + 2 * k - flat + 1))
    top = [(pitch * k // 2, peak if k % 2 else 0) for k in range(n_t, 0, -1)]
    return [(0, 0), *tip, *top], directrix


def edges_of_bumps(m_b: int, n_t: int, n_b: int) -> int:
    """Edges of the outer boundary of `bumps`: the tips, their flanks, and two edges at each end.

    >>> edges_of_bumps(2, 4, 6)
    16
    """
    return m_b * n_t * n_b // 4 + 4


def printed_count(m_b: int, n_t: int, n_b: int) -> int:
    """The paper's formula for the same number.

    >>> printed_count(2, 4, 6), printed_count(4, 4, 6)
    (16, 26)
    """
    return m_b + n_t + (m_b // 2) * (n_t // 2) * (n_b - 2) + 2
