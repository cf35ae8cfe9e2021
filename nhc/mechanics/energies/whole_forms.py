"""T's velocity forms with the functions that stand in front of them.

:mod:`nhc.mechanics.energies.kinetic` takes every factor out of a form, which leaves the fewest forms; where forms continue one
another the first of them, y1' = l sin(th1) th1', has to stay what the next ones, y2' = y1' + l sin(th2) th2', are made of.
"""

from __future__ import annotations

from collections.abc import Collection, Container

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import MUL, NEG, Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import degrees
from nhc.mechanics.energies.kinetic import Kinetic, energy_as_squares, list_atoms
from nhc.mechanics.energies.positions import find_positions
from nhc.mechanics.system import System


def whole_kinetic(system: System, whole: Collection[Node] = ()) -> Kinetic | None:
    """T by forms of which only parameters are taken out; None where T is no quadratic polynomial in forms, or the rule is off.

    Forms in ``whole``, and their negatives, keep their parameters, and the number in front of them.
    """
    g = system.graph
    if "trees" in g.off:
        return None
    energy = energy_as_squares(system)
    degree = degrees(g, system.v)
    if degree[energy] != 2:
        return None
    parameters = g.mask(system.p)
    find_positions(system, list_atoms(g, energy, degree, lambda node: node))
    numbers = {rest: number for number, rest in map(g.split_coefficient, whole) if abs(number) != 1}
    kept = {*whole, *numbers}
    atoms = list_atoms(g, energy, degree, lambda node: _without_parameters(g, node, parameters, kept))
    u = tuple(g.symbol(f"u{k + 1}", "form") for k in range(len(atoms)))
    # z' = l cos(a) a'/2, whose square has the 1/4 in front, is the rate of a position as it is
    scale = [g.number(numbers.get(atom, 1)) for atom in atoms]
    (tau,) = substitute(g, [energy], {atom: g.div(x, c) for atom, x, c in zip(atoms, u, scale, strict=True)})
    atoms = [g.mul(c, atom) for atom, c in zip(atoms, scale, strict=True)]
    if g.depends(tau, g.mask(system.v)):
        return None
    slope = tuple(gradient(g, tau, u))
    place = {symbol: k for k, symbol in enumerate(u)}
    hessian = []
    for pi in slope:
        row = [g.zero] * len(u)
        held = [symbol for symbol in g.symbols_in(pi) if symbol in place]
        for symbol, h in zip(held, gradient(g, pi, held), strict=True):
            row[place[symbol]] = h
        hessian.append(tuple(row))
    return Kinetic(system, tuple(atoms), u, tau, slope, tuple(hessian))


def _without_parameters(graph: Graph, node: Node, parameters: int, whole: Container[Node]) -> Node:
    while graph.op[node] in (MUL, NEG) and node not in whole and graph.neg(node) not in whole:
        constant = [c for c in graph.children(node) if not graph.deps[c] & ~parameters]
        moving = [c for c in graph.children(node) if graph.deps[c] & ~parameters]
        if graph.op[node] == MUL and not constant:
            break
        node = moving[0]
    return node
