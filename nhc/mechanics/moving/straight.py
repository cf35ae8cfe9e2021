"""A vector that the spec has on leaning axes, on the axes before the lean: in the components of directions and spins there.

The contact of a wheel with the ground stands in a spec on the axes of its fork, by the vertical's components there.  Each of these
is a combination of those on the axes of the steering joint; written so, with the components as symbols, the lean cancels.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import ADD, Graph, Node
from nhc.algebra.rebuilding import Replacement, substitute
from nhc.algebra.rewriting.digits import normalise_kept, shorter_kept
from nhc.algebra.walks import reachable
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.rotations.turns import Path, Vector, change_axes, turn_in, turn_out

_TERMS = 60


def straighten(setting: Setting, path: Path, local: Vector) -> tuple[Path, Vector]:
    """The vector ``local`` on the axes before the last turn of ``path``, if that turn leads back from a straightened joint.

    Otherwise the path and the vector as they are.
    """
    if not path or path[-1] not in setting.backs:
        return path, local
    g, back, path = setting.graph, path[-1], path[:-1]
    vectors = [*(change_axes(g, unit, (), path) for unit in _units(g)), setting.spin(path)]
    symbols = [_symbols(g, number) for number in range(len(vectors))]
    named: dict[tuple[int, ...], list[Node]] = {}
    for node in reachable(g, local):
        named.setdefault(setting.marks.of(node), []).append(node)
    mapping: dict[Node, Node] = {}
    for vector, own in zip(vectors, symbols, strict=True):
        for component, symbol in zip(turn_in(g, back, vector), turn_in(g, back, own), strict=True):
            mark = setting.marks.of(component)
            if any(mark):
                mapping.update((node, symbol) for node in named.get(mark, ()))
                mapping.update((node, g.neg(symbol)) for node in named.get(setting.marks.negative(mark), ()))
    there = _Shortened(g, mapping, ()).vector(local)
    variables = [*symbols[-1], *setting.system.v]
    x, y, z = (_by_velocities(g, node, variables) for node in turn_out(g, back, there))
    meaning = {s: v for own, vector in zip(symbols, vectors, strict=True) for s, v in zip(own, vector, strict=True)}
    return path, _Shortened(g, meaning, list(meaning.values())).vector((x, y, z))


def _units(graph: Graph) -> tuple[Vector, ...]:
    zero, one = graph.zero, graph.one
    return (one, zero, zero), (zero, one, zero), (zero, zero, one)


def _symbols(graph: Graph, number: int) -> Vector:
    x, y, z = (graph.symbol(f"straight_{number}_{axis}", "test") for axis in range(3))
    return x, y, z


def _by_velocities(graph: Graph, node: Node, velocities: Sequence[Node]) -> Node:
    """What is linear in the velocities, each factor in canonical form and with all velocities that it multiplies: factors that are
    equal in several components are then one.
    """
    g = graph
    rest = substitute(g, [node], dict.fromkeys(velocities, g.zero), named=False)[0]
    behind: dict[Node, Node] = {}
    for slope, velocity in zip(gradient(g, node, velocities), velocities, strict=True):
        k, factor = g.split_coefficient(normalise_kept(g, slope, _TERMS))
        if k:
            behind[factor] = g.add(behind.get(factor, g.zero), g.mul(g.number(k), velocity))
    return g.add(g.sum(g.mul(factor, total) for factor, total in behind.items()), normalise_kept(g, rest, _TERMS))


class _Shortened(Replacement):
    """A substitution; sums are brought to canonical form as they are made, where that is shorter beside what is there anyway."""

    def __init__(self, graph: Graph, mapping: dict[Node, Node], beside: Sequence[Node]) -> None:
        super().__init__(graph, mapping)
        self._beside = beside

    def vector(self, nodes: Vector) -> Vector:
        x, y, z = self.of(nodes)
        return x, y, z

    def make(self, node: Node, children: Sequence[Node]) -> Node:
        g, made = self.graph, super().make(node, children)
        if made == node or g.op[made] != ADD:
            return made
        return shorter_kept(g, made, _TERMS, self._beside)
