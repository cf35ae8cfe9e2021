"""Coframes: bases of one-forms over the graph, with what d needs to know of them.

A coframe knows how a function's differential reads in it, and the exterior derivatives of its basis forms (its
structure equations). Two kinds are built here: coordinate differentials (d of each is zero) and general ones given by
their rows over coordinates.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.records import fresh, record

TwoFormTerms = Mapping[tuple[int, int], Node]


@record
class Coframe:
    """``variables`` are the coordinates of the chart; ``dual[k][r]`` are the components of the k-th dual vector along
    them.

    ``structure[k]`` holds the coefficients of d(basis_k) in the basis, for increasing index pairs; a missing k means
    closed.  ``inner[k]``, where there are any, are derivatives along the k-th dual vector of expressions that
    are known in a shorter form than the chain rule gives.
    """

    graph: Graph
    names: tuple[str, ...]
    variables: tuple[Node, ...]
    dual: tuple[tuple[Node, ...], ...]
    structure: Mapping[int, TwoFormTerms] = fresh(factory=dict)
    inner: tuple[Mapping[Node, Node], ...] = ()

    def __len__(self) -> int:
        return len(self.names)

    def differential(self, function: Node) -> dict[int, Node]:
        """Coefficients of d(function) in the basis."""
        g = self.graph
        if self.inner:
            seeds = [dict(zip(self.variables, vector, strict=True)) | dict(inner) for vector, inner in self._vectors()]
            found = [tangent(g, [function], along)[0] for along in seeds]
            return {k: node for k, node in enumerate(found) if node != g.zero}
        slopes = gradient(g, function, self.variables)
        result = {}
        for k, vector in enumerate(self.dual):
            total = g.sum([g.mul(s, x) for s, x in zip(slopes, vector, strict=True) if x != g.zero and s != g.zero])
            if total != g.zero:
                result[k] = total
        return result

    def _vectors(self) -> Iterator[tuple[tuple[Node, ...], Mapping[Node, Node]]]:
        return zip(self.dual, self.inner, strict=True)


def coordinate_coframe(graph: Graph, variables: Sequence[Node], names: Sequence[str]) -> Coframe:
    """The differentials of the chart's own coordinates."""
    size = len(variables)
    identity = tuple(tuple(graph.one if r == k else graph.zero for r in range(size)) for k in range(size))
    return Coframe(graph, tuple(names), tuple(variables), identity)


def general_coframe(
    graph: Graph,
    variables: Sequence[Node],
    names: Sequence[str],
    rows: Sequence[Sequence[Node]],
    dual: Sequence[Sequence[Node]],
) -> Coframe:
    """The forms ``rows[k][r] d(variables[r])`` with their dual vectors; the structure equations are computed.

    d(basis_k) = sum over r < s of (dc_kr/dx_s - dc_ks/dx_r) dx_s ^ dx_r, read in the basis by contraction with the
    dual vectors.
    """
    structure: dict[int, dict[tuple[int, int], Node]] = {}
    size = len(variables)
    for k, row in enumerate(rows):
        slopes = [gradient(graph, c, variables) for c in row]
        curl = [[graph.sub(slopes[r][s], slopes[s][r]) for s in range(size)] for r in range(size)]
        terms = {}
        for a in range(len(rows)):
            for b in range(a + 1, len(rows)):
                value = _contract_curl(graph, curl, dual[a], dual[b])
                if value != graph.zero:
                    terms[(a, b)] = value
        if terms:
            structure[k] = terms
    return Coframe(graph, tuple(names), tuple(variables), tuple(tuple(d) for d in dual), structure)


def _contract_curl(graph: Graph, curl: Sequence[Sequence[Node]], x: Sequence[Node], y: Sequence[Node]) -> Node:
    """d(form)(x, y) = (dc_r/dx_s - dc_s/dx_r) x_s y_r."""
    total = graph.zero
    for r, yr in enumerate(y):
        if yr == graph.zero:
            continue
        for s, xs in enumerate(x):
            if xs != graph.zero and curl[r][s] != graph.zero:
                total = graph.add(total, graph.mul(graph.mul(curl[r][s], xs), yr))
    return total
