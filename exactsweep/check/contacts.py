"""The contacts of a trajectory: exactly the pairs of features that touch along each of its edges.

G + t touches D in a pair of features if t is in the sum of both in D + I(G). So the pairs that
touch along an edge of the trajectory are those whose sum draws it.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Container, Iterator, Mapping, Sequence

from exactsweep.check.certificate import CertificateError, ListedContact, ListedFeature
from exactsweep.check.chain import Line
from exactsweep.check.cover import LineInterval, check_covered, edge_extent, middle, sum_extent
from exactsweep.check.loop import MonotoneLoop, NodeFrame

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

    Cost: O(mn) look-ups of lines, and O(c log k) for c contacts of k edges.
    """
    edges = [edge_extent(trajectory, k) for k in range(len(trajectory.lines))]
    # By normal and constant of the line; edges of a simple loop on one line do not overlap.
    rows: dict[_Normal, dict[int, list[tuple[LineInterval, int]]]] = defaultdict(dict)
    for k, (a, b, c) in enumerate(trajectory.lines):
        rows[a, b].setdefault(c, []).append((edges[k], k))
    for constants in rows.values():
        for row in constants.values():
            row.sort()
    expected = [set(contacts) for contacts in listed]
    found: list[dict[ListedContact, LineInterval]] = [{} for _ in listed]
    for contact, line in _contacts_on_lines(directrix, inverse, rows):
        piece = _extent_of(contact, directrix, inverse, line)
        row = rows[line[:2]][line[2]]
        for m in range(bisect_right(row, piece.low, key=lambda entry: entry[0].high), len(row)):
            edge, k = row[m]
            part = edge.common(piece)
            if part.low >= part.high:
                break
            if contact not in expected[k]:
                witness = frame.leave(middle(part, line))
                raise CertificateError(f"contacts[{k}]: {contact} is missing", witness)
            found[k][contact] = piece
    for k, contacts in enumerate(listed):
        for contact in contacts:
            if contact not in found[k]:
                raise CertificateError(f"contacts[{k}]: {contact} does not touch along the edge")
        pieces = found[k].values()
        check_covered(f"contacts[{k}]", edges[k], pieces, trajectory.lines[k], frame)


def _contacts_on_lines(
    directrix: MonotoneLoop, inverse: MonotoneLoop, lines: Mapping[_Normal, Container[int]]
) -> Iterator[tuple[ListedContact, Line]]:
    """Find all contacts on some lines, given by normal and constant.

    D and I(G) lie to the left of their edges, and their sum to the left of any sum that is part of
    its boundary: so the sense of a line must agree, too.
    """
    parallel: dict[_Normal, list[int]] = defaultdict(list)
    for i, (a, b, c) in enumerate(inverse.lines):
        parallel[a, b].append(i)
        constants = lines.get((a, b), ())
        for j, (x, y, _) in enumerate(directrix.nodes if constants else ()):
            shifted = c - a * x - b * y
            if shifted in constants and not _on_edge_along(directrix, j, (a, b)):
                yield ListedContact("EV", i, j), (a, b, shifted)
    for j, (a, b, c) in enumerate(directrix.lines):
        constants = lines.get((a, b), ())
        for i, (x, y, _) in enumerate(inverse.nodes if constants else ()):
            shifted = c - a * x - b * y
            if shifted in constants and not _on_edge_along(inverse, i, (a, b)):
                yield ListedContact("VE", i, j), (a, b, shifted)
        for i in parallel[a, b] if constants else ():
            x, y, _ = inverse.nodes[i]
            shifted = c - a * x - b * y
            if shifted in constants:
                yield ListedContact("EE", i, j), (a, b, shifted)


def _on_edge_along(loop: MonotoneLoop, k: int, normal: _Normal) -> bool:
    """Whether a vertex ends an edge with this normal: then EE includes what it would add."""
    return normal in (loop.lines[k - 1][:2], loop.lines[k][:2])


def _extent_of(
    contact: ListedContact, directrix: MonotoneLoop, inverse: MonotoneLoop, line: Line
) -> LineInterval:
    event, i, j = contact
    of_g = ListedFeature("edge" if event[0] == "E" else "vertex", i)
    of_d = ListedFeature("edge" if event[1] == "E" else "vertex", j)
    extent = sum_extent(directrix, of_d, inverse, of_g, line)
    assert extent is not None  # its line is how it was found
    return extent
