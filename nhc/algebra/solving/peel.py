"""In which order linear rows can be solved, found without their coefficients.

Rows with one unknown left come first, rows with an unknown of their own last.  Only the rest, the core, needs a matrix; a chain of
bodies has none but at its root.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.modular import is_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.records import record

Single = tuple[int, int, Node]
"""Number of the row, number of the unknown, its coefficient, which is not zero."""


@record
class Peeled:
    """``first`` in the order in which they are solved, then the core, then ``last``; ``columns`` are the core's unknowns."""

    first: list[Single]
    rows: list[int]
    columns: list[int]
    last: list[Single]


def coefficients(graph: Graph, row: Node, unknowns: Sequence[Node]) -> list[Node]:
    """Of a row that is linear in the unknowns."""
    found = gradient(graph, row, unknowns)
    mask = graph.mask(unknowns)
    if any(graph.deps[c] & mask for c in found):  # by sight only
        found = substitute(graph, found, dict.fromkeys(unknowns, graph.zero), named=False)
    return found


class _Peeler:
    def __init__(self, graph: Graph, rows: Sequence[Node], unknowns: Sequence[Node]) -> None:
        self.graph, self.rows, self.unknowns = graph, rows, unknowns
        self.number = {graph.deps[x]: j for j, x in enumerate(unknowns)}
        self.open = self.everything = graph.mask(unknowns)
        self.masks = [graph.deps[row] & self.open for row in rows]
        self.left = list(range(len(rows)))

    def take(self, i: int, bit: int) -> Single | None:
        """Row i for the unknown of a bit; None where its coefficient vanishes identically."""
        g, unknown = self.graph, self.unknowns[self.number[bit]]
        slope = tangent(g, [self.rows[i]], {unknown: g.one})[0]
        if g.deps[slope] & self.everything:
            slope = substitute(g, [slope], dict.fromkeys(self.unknowns, g.zero), named=False)[0]
        if is_zero(g, slope):
            self.masks[i] &= ~bit
            return None
        self.open &= ~bit
        self.left.remove(i)
        return i, self.number[bit], slope

    def take_single_rows(self) -> list[Single]:
        found = []
        for i in list(self.left):
            bit = self.masks[i] & self.open
            if bit and not bit & (bit - 1):
                single = self.take(i, bit)
                if single is not None:
                    found.append(single)
        return found

    def take_own_unknowns(self) -> list[Single]:
        """Of rows that alone have some unknown, seen from the last one."""
        once = twice = 0
        for i in self.left:
            mask = self.masks[i] & self.open
            twice |= once & mask
            once |= mask
        found = []
        for i in reversed(self.left):
            bit = self.masks[i] & self.open & ~twice
            if bit:
                single = self.take(i, bit & -bit)
                if single is not None:
                    found.append(single)
        return found


def peel(graph: Graph, rows: Sequence[Node], unknowns: Sequence[Node]) -> Peeled:
    """An order in which rows that are linear in the unknowns can be solved one by one, as far as there is one.

    Rows with a single open unknown come first, unknowns that stand in a single row last; what is left has to be solved together.
    """
    work, first, last = _Peeler(graph, rows, unknowns), list[Single](), list[Single]()
    while work.left:
        found = work.take_single_rows()
        first += found
        if not found:
            found = work.take_own_unknowns()
            last += found
        if not found:
            break
    columns = [j for bit, j in work.number.items() if bit & work.open]
    return Peeled(first, work.left, sorted(columns), last[::-1])
