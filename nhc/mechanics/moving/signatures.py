"""Values of expressions at two random points of prime fields: equal expressions have equal signatures.

Two different ones share a signature with a probability of about (degree / 2**61)**2, as in :mod:`nhc.algebra.exact.modular`.  Signs and
roots are arbitrary functions of what they are taken of: in the field x and abs(x) agree at every second point.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.values import ArbitraryPoint

Signature = tuple[int, ...]
_TRIES = 20


class Signatures:
    """Signatures of nodes of one graph; ``bind`` gives symbols the signature of what they stand for.

    Raises:
        Unlucky: no point was found where the ``announced`` nodes have values.
    """

    def __init__(self, graph: Graph, announced: Sequence[Node]) -> None:
        self._points: list[FieldPoint] = []
        for k, prime in enumerate(primes_of(graph)[:2]):
            for attempt in range(_TRIES):
                point = ArbitraryPoint(graph, 31 + 977 * k + attempt, prime)
                try:
                    point.evaluate(announced)
                except Unlucky:
                    continue
                self._points.append(point)
                break
            else:
                raise Unlucky

    def of(self, node: Node) -> Signature:
        first, second = (point.values.get(node) for point in self._points)
        if first is not None and second is not None:
            return first, second
        return tuple(point.evaluate([node])[0] for point in self._points)

    def negative(self, signature: Signature) -> Signature:
        return tuple(-value % point.prime for value, point in zip(signature, self._points, strict=True))

    def bind(self, meanings: Mapping[Node, Node]) -> None:
        """Symbol -> the node whose value it has."""
        for point in self._points:
            values = point.evaluate(list(meanings.values()))
            point.values.update(zip(meanings, values, strict=True))
