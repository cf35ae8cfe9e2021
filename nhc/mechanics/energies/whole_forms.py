"""T's velocity forms with the functions that stand in front of them.

:mod:`nhc.mechanics.energies.kinetic` takes every factor out of a form, which leaves the fewest forms; where forms continue one
another the first of them, y1' = l sin(th1) th1', has to stay what the next ones, y2' = y1' + l sin(th2) th2', are made of.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import ADD, MUL, NEG, Graph, Node
from nhc.algebra.parts import list_terms, split_powers
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
    energy, degree = _with_begun_squares(system, energy, degree)
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


def _with_begun_squares(system: System, energy: Node, degree: list[int]) -> tuple[Node, list[int]]:
    """The energy, and the degrees of nodes, with l^2 sin(a)^2 a'^2 as the square of what other forms go on from: of
    l sin(a) a', where that is a term of theirs.
    """
    g, parameters = system.graph, system.graph.mask(system.p)
    lone = _lone_squares(system, energy, degree)
    if not lone:
        return energy, degree
    forms = list_atoms(g, energy, degree, lambda node: node)
    terms = {_moving(g, term, parameters) for form in forms if g.op[form] == ADD for term in list_terms(g, form)}
    begun = dict[Node, Node]()
    for node, powers in lone.items():
        half = {base: n // 2 for base, n in powers.items() if g.deps[base] & ~parameters}
        if frozenset(half.items()) in terms:
            rest = g.product([g.power(base, n) for base, n in powers.items() if base not in half])
            form = g.product([g.power(base, n) for base, n in half.items()])
            begun[node] = g.mul_number(g.split_coefficient(node)[0], g.mul(rest, g.power(form, 2)))
    if not begun:
        return energy, degree
    (made,) = substitute(g, [energy], begun)
    return made, degrees(g, system.v)


def _lone_squares(system: System, energy: Node, degree: Sequence[int]) -> dict[Node, dict[Node, int]]:
    """Products of T with the square of one velocity and with squares that move: the powers of their factors."""
    g, parameters, found = system.graph, system.graph.mask(system.p), dict[Node, dict[Node, int]]()
    stack, seen = [energy], set[Node]()
    while stack:
        node = stack.pop()
        if node in seen or degree[node] != 2:
            continue
        seen.add(node)
        if g.op[node] != MUL:
            stack.extend(g.children(node))
            continue
        _, powers = split_powers(g, node)
        moving = [n for base, n in powers.items() if g.deps[base] & ~parameters]
        own = [base for base in powers if degree[base]]
        if len(moving) > 1 and all(n == 2 for n in moving) and len(own) == 1 and own[0] in system.v:
            found[node] = powers
        elif len(own) == 1:
            stack += own
    return found


def _moving(graph: Graph, term: Node, parameters: int) -> frozenset[tuple[Node, int]]:
    """The powers of its factors that are no parameters."""
    return frozenset((base, n) for base, n in split_powers(graph, term)[1].items() if graph.deps[base] & ~parameters)


def _without_parameters(graph: Graph, node: Node, parameters: int, whole: Container[Node]) -> Node:
    while graph.op[node] in (MUL, NEG) and node not in whole and graph.neg(node) not in whole:
        constant = [c for c in graph.children(node) if not graph.deps[c] & ~parameters]
        moving = [c for c in graph.children(node) if graph.deps[c] & ~parameters]
        if graph.op[node] == MUL and not constant:
            break
        node = moving[0]
    return node
