"""The contacts of a trajectory: exactly the pairs of features that touch along each of its edges.

G + t touches D in a pair of features if t is in the sum of both in D + I(G). So the pairs that
touch along an edge of the trajectory are those whose sum draws it. If the trajectory is right,
D + I(G) lies to the left of the edge, and with it D moved by any point of I(G), and I(G) by any of
D. Both lie to the left of their own edges. So a sum that draws the edge is that of

- two edges of its direction, or
- an edge of its direction and a convex corner of the other polygon, whose own two edges have this
  direction between theirs, counter-clockwise. Where one of them has it, too, it is as above.

This module examines no other pairs, and does not decide whether the trajectory is right.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Container, Iterator, Sequence
from math import gcd

from exactsweep.check.certificate import ListedContact, ListedFeature, flaw
from exactsweep.check.chain import Line, Node, turn
from exactsweep.check.cone import by_turn
from exactsweep.check.cover import (
    LineInterval,
    check_covered,
    find_edge_extent,
    find_middle,
    find_sum_extent,
    share_a_part,
)
from exactsweep.check.loop import MonotoneLoop, NodeFrame, reduce_line

_Normal = tuple[int, int]


def check_contacts(
    trajectory: MonotoneLoop,
    directrix: MonotoneLoop,
    inverse: MonotoneLoop,
    listed: Sequence[Sequence[ListedContact]],
    frame: NodeFrame,
) -> None:
    """Check that the listed contacts of each edge are those that draw it, and cover all of it.

    Args:
        trajectory: the loop.
        directrix: D.
        inverse: I(G).
        listed: for each edge of the trajectory its contacts. Of a contact EE the contacts EV and
            VE that are part of it are not listed.
        frame: to name witnesses in the plane.

    Raises:
        CertificateError: they are not, or do not.

    Cost: O((m + n) log(m + n)), a look-up of a line for each edge of one polygon and each convex
    corner of the other that may touch so, and O(c log k) for c contacts of k edges.
    """
    edges = [find_edge_extent(trajectory, k) for k in range(len(trajectory.lines))]
    # Edges of a simple loop on one line do not overlap.
    rows: dict[Line, list[tuple[LineInterval, int]]] = defaultdict(list)
    for k, line in enumerate(trajectory.lines):
        rows[line].append((edges[k], k))
    for row in rows.values():
        row.sort()
    expected = [set(contacts) for contacts in listed]
    found: list[dict[ListedContact, LineInterval]] = [{} for _ in listed]
    for contact, line in _contacts_on_lines(directrix, inverse, rows):
        piece = _extent_of(contact, directrix, inverse, line)
        row = rows[line]
        for m in range(bisect_right(row, piece[0], key=lambda entry: entry[0][1]), len(row)):
            edge, k = row[m]
            if not share_a_part(edge, piece):
                break
            if contact not in expected[k]:
                part = max(edge[0], piece[0]), min(edge[1], piece[1])
                witness = frame.leave(find_middle(part, line))
                raise flaw(("contacts", k), f"{_name(contact)} is missing", witness)
            found[k][contact] = piece
    for k, contacts in enumerate(listed):
        for contact in contacts:
            if contact not in found[k]:
                raise flaw(("contacts", k), f"{_name(contact)} does not touch along the edge")
        pieces = found[k].values()
        check_covered(("contacts", k), edges[k], pieces, trajectory.lines[k], frame)


def _contacts_on_lines(
    directrix: MonotoneLoop, inverse: MonotoneLoop, lines: Container[Line]
) -> Iterator[tuple[ListedContact, Line]]:
    """Find all contacts on some lines."""
    d_normals, i_normals = ([*map(_find_normal, loop.lines)] for loop in (directrix, inverse))
    normals = dict.fromkeys(d_normals + i_normals)
    ranks = {normal: k for k, normal in enumerate(sorted(normals, key=by_turn))}
    d_ranks, i_ranks = ([ranks[normal] for normal in found] for found in (d_normals, i_normals))
    for i, j in _facing(i_ranks, directrix, d_ranks):
        if (line := _moved(inverse.lines[i], directrix.nodes[j])) in lines:
            yield ("EV", i, j), line
    for j, i in _facing(d_ranks, inverse, i_ranks):
        if (line := _moved(directrix.lines[j], inverse.nodes[i])) in lines:
            yield ("VE", i, j), line
    parallel: dict[_Normal, list[int]] = defaultdict(list)
    for i, normal in enumerate(i_normals):
        parallel[normal].append(i)
    for j, edge in enumerate(directrix.lines):
        for i in parallel.get(d_normals[j], ()):
            if (line := _moved(edge, inverse.nodes[i])) in lines:
                yield ("EE", i, j), line


def _facing(
    edges: Sequence[int], corners: MonotoneLoop, ranks: Sequence[int]
) -> Iterator[tuple[int, int]]:
    """Pairs of an edge and a convex corner, the edge's direction between those of the two there.

    Of both loops the ranks of the edges are given, among all directions, counter-clockwise.
    """
    order = sorted((rank, k) for k, rank in enumerate(edges))
    ordered = [rank for rank, _ in order]
    for m, after in enumerate(corners.lines):
        before = corners.lines[m - 1]
        if turn(before, after) <= 0:
            continue
        start, end = ranks[m - 1], ranks[m]
        first, last = bisect_right(ordered, start), bisect_left(ordered, end)
        for _, k in order[first:last] if start < end else order[first:] + order[:last]:
            yield k, m


def _find_normal(line: Line) -> _Normal:
    """The direction of a line, the same for all that are parallel and run the same way."""
    a, b, _ = line
    common = gcd(a, b)
    return (a, b) if common == 1 else (a // common, b // common)


def _moved(line: Line, by: Node) -> Line:
    """A line moved by a node."""
    (a, b, c), (x, y, w) = line, by
    if w == 1:
        return a, b, c - a * x - b * y
    return reduce_line(a * w, b * w, c * w - a * x - b * y)


def _extent_of(
    contact: ListedContact, directrix: MonotoneLoop, inverse: MonotoneLoop, line: Line
) -> LineInterval:
    event, i, j = contact
    of_g: ListedFeature = ("edge" if event[0] == "E" else "vertex", i)
    of_d: ListedFeature = ("edge" if event[1] == "E" else "vertex", j)
    extent = find_sum_extent(directrix, of_d, inverse, of_g, line)
    assert extent is not None  # its line is how it was found
    return extent


def _name(contact: ListedContact) -> str:
    event, i, j = contact
    return f"{event} ({i}, {j})"
