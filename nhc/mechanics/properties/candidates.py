"""Combinations of candidates for constants of the motion, with coefficients that may be functions of the parameters.

Of two gears in mesh r2 p_1 + r1 p_2 is constant.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.dense import null_space
from nhc.algebra.exact.families import draw_parameters, find_families
from nhc.algebra.exact.modular import Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.graph import ADD, Graph, Node
from nhc.algebra.show import to_text
from nhc.mechanics.properties.constancy import rates_of
from nhc.mechanics.properties.sampling import Sampler
from nhc.records import record

_SPARE = 6  # points more than candidates


@record
class Candidate:
    """A function of q, q' and t with the text that names it; ``kind`` is energy, momentum or empty.

    ``scaled``: it is another one times a parameter.
    """

    text: str
    node: Node
    kind: str = ""
    scaled: bool = False


def combine_by_parameters(sampler: Sampler, candidates: Sequence[Candidate], known: int) -> list[list[Node]]:
    """The weights, polynomials in the parameters, with which the candidates make constants; none where no more than ``known`` are
    made by numbers.

    What is constant at given values of the parameters counts.  Of candidates that are combinations of each other, as an angular
    momentum of its velocity, only some are taken, for weights along what vanishes have no low degree; first those with a kind.
    """
    system, nodes = sampler.system, [c.node for c in candidates]
    g, prime = system.graph, primes_of(system.graph)[0]
    parameters = [symbol for symbol in system.p if symbol not in sampler.zeroed]
    rates = rates_of(sampler, nodes)

    def sample(nodes: Sequence[Node], unknowns: int, fixed: Mapping[Node, int]) -> list[list[int]]:
        return sampler.residues(nodes, unknowns + _SPARE, prime, fixed=fixed)

    try:
        rows = sample([*rates, *nodes], len(nodes), draw_parameters(parameters, prime, 1))
        first = sorted(range(len(nodes)), key=lambda k: not candidates[k].kind)
        vanishing = null_space([[row[len(nodes) + k] for k in first] for row in rows], len(nodes), prime)
        dropped = {first[max(k for k, weight in enumerate(vector) if weight)] for vector in vanishing}
        kept = [k for k in range(len(nodes)) if k not in dropped]
        width = len(kept)
        constant = null_space([[row[k] for k in kept] for row in rows], width, prime)
        if len(constant) <= known:
            return []
        used = [k for k in range(width) if any(vector[k] for vector in constant)]
        own = [rates[kept[k]] for k in used]
        found = find_families(g, parameters, lambda fixed: sample(own, len(own), fixed), len(used), prime)
    except Unlucky:
        return []
    spread = []
    for vector in found:
        weights = dict(zip((kept[k] for k in used), vector or (), strict=vector is not None))
        spread.append([weights.get(k, g.zero) for k in range(len(nodes))])
    return [weights for weights in spread if any(weight != g.zero for weight in weights)]


def combine(graph: Graph, vector: Sequence[Node], candidates: Sequence[Candidate]) -> Node:
    """sum k_j candidate_j."""
    return graph.dot(vector, [candidate.node for candidate in candidates])


def spell(graph: Graph, vector: Sequence[Node], candidates: Sequence[Candidate]) -> str:
    """The combination as text, the last candidate (its leading one) first."""
    text = ""
    for k, candidate in reversed([(k, c) for k, c in zip(vector, candidates, strict=True) if k != graph.zero]):
        negative = graph.coefficient[k] < 0
        size = graph.neg(k) if negative else k
        written = to_text(graph, size)
        factor = "" if size == graph.one else f"({written}) " if graph.op[size] == ADD else f"{written} "
        sign = ("-" if negative else "") if not text else (" - " if negative else " + ")
        text += f"{sign}{factor}{candidate.text}"
    return text
