"""Quasi-velocities whose brackets are constant, as those of a body on its own axes: Poincaré's and Hamel's equations as printed.

With gamma^i_nu,mu (I.2.11) a number each, the rows (I.2.15) are d/dt p*_mu + gamma^i_nu,mu omega_nu p*_i - e_mu(T*) - P_mu, and no
direction cosine is left in them: Kirchhoff's equations of a body in a fluid, those of an aircraft.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from random import Random

from nhc.algebra.calculus import gradient
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.probe import probe_of
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.shorten import canonical_form
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.moving.moved import Moved, Spread, Weights
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import System

_MOST = 12  # quasi-velocities, whose brackets are some n^3/2
_NEAR = 1e-9

Brackets = dict[tuple[int, int], dict[int, Node]]
"""By (nu, mu) the numbers gamma^i_nu,mu that are not zero, by i."""


def move_by_structure(system: System, frame: Frame) -> tuple[System, Moved] | None:
    """T in the frame's own forms, and the system without the forces on these, which are loads; None where T is not written in
    them, or their brackets are not constant.
    """
    g, n, lower = system.graph, system.n, system.l
    free = frame.forms[lower:]
    rates = (None, *system.v)
    if n > _MOST or all(form.value in rates for form in free) or any(form.line is not None for form in free):
        return None
    values = [form_value(system, form) for form in frame.forms]
    u = tuple(g.symbol(f"form_{k}", "form") for k in range(n))
    tau = _energy_in(system, frame, values, u)
    brackets = None if tau is None else _find_brackets(system, frame)
    if tau is None or brackets is None:
        return None
    known_brackets(g)[frame.omega] = brackets
    slope = gradient(g, tau, u)
    hessian = tuple(tuple(gradient(g, pi, u)) for pi in slope)
    on_motion = (*(g.zero for _ in range(lower)), *frame.free)
    momenta = substitute(g, slope, dict(zip(u, on_motion, strict=True)))
    unit = [[g.one if i == j else g.zero for i in range(n)] for j in range(n)]
    weights = tuple(Weights(tuple(row), ()) for row in unit)
    bare, pushes = _split_forces(system, values)
    own = substitute(g, pushes, _meaning(g, values, on_motion))
    own = substitute(g, own, moving(system, frame.kinematics))
    loads = [g.sub(push, _swirl(g, brackets, on_motion, momenta, mu)) for mu, push in enumerate(own)]
    return bare, Moved(
        frame=frame,
        velocities=frame.kinematics,
        kinetic=Kinetic(system, tuple(values), u, tau, tuple(slope), hessian),
        u=on_motion,
        drift=(g.zero,) * n,
        weights=weights[lower:],
        weigh=lambda: weights[:lower],
        spread=lambda: Spread(frame.omega, frame.all_kinematics, frame.omega[:lower]),
        carried=(True,) * n,
        inertial=(False,) * n,
        loads=tuple(loads),
        potential=system.U,
        places={},
        settled=False,
        turning=(),
    )


def _energy_in(system: System, frame: Frame, values: Sequence[Node], u: Sequence[Node]) -> Node | None:
    """T in symbols for the frame's forms, as it is written in them, or with the constant matrix that it has in them."""
    g = system.graph
    (tau,) = substitute(g, [system.T], _meaning(g, values, u))
    if not g.depends(tau, g.mask(system.v)):
        return tau
    if system.l or not _seems_constant(system, frame):
        return None
    velocities = substitute(g, frame.kinematics, dict(zip(frame.omega, u, strict=True)))
    (tau,) = substitute(g, [tau], moving(system, velocities))
    rows = [gradient(g, slope, u) for slope in gradient(g, tau, u)]
    moves = ~g.mask(system.p)
    upper = [(i, j, canonical_form(g, rows[i][j])) for i in range(len(u)) for j in range(i, len(u))]
    if any(g.depends(entry, moves) for _, _, entry in upper):
        return None
    halves = ((entry if i != j else g.div(entry, g.number(2)), u[i], u[j]) for i, j, entry in upper)
    made = g.sum(g.mul(entry, g.mul(x, y)) for entry, x, y in halves if entry != g.zero)
    return made if is_zero(g, g.sub(tau, made)) else None


def _seems_constant(system: System, frame: Frame) -> bool:
    """Whether T has one value at two places, for the same values of the forms: in doubles, and without a node."""
    g, draw, found = system.graph, Random(7), list[float]()
    still = {x: draw.uniform(0.4, 1.6) for x in (*system.p, *frame.omega)}
    for _ in range(2):
        place = still | {x: draw.uniform(0.4, 1.6) for x in (*system.q, system.t)}
        try:
            velocities = map(float, evaluate(g, frame.kinematics, place))
            found.append(float(evaluate(g, [system.T], place | dict(zip(system.v, velocities, strict=True)))[0]))
        except (ArithmeticError, ValueError, TypeError, KeyError):
            return False
    return abs(found[0] - found[1]) <= _NEAR * abs(found[0])


def _meaning(graph: Graph, values: Sequence[Node], symbols: Sequence[Node]) -> dict[Node, Node]:
    """The forms' values, less their numbers, by their symbols: of a form 2 (...) T has squares 4 (...)^2."""
    cores = [graph.split_coefficient(value) for value in values]
    pairs = zip(cores, symbols, strict=True)
    return {core: graph.mul(graph.number(1 / Fraction(size)), symbol) for (size, core), symbol in pairs}


def known_brackets(graph: Graph) -> dict[tuple[Node, ...], Brackets]:
    """Constant ones that were found, by the symbols of the frame's forms."""
    found: dict[tuple[Node, ...], Brackets] = graph.memory.setdefault("brackets", {})
    return found


def drift_of(frame: Frame) -> list[Node] | None:
    """-gamma^i_nu,mu omega_nu omega_i, the rates of the free forms where T is half the sum of their squares and nothing pulls: of a
    point's velocity on a body's axes, u = R^T x', this is what R^T gives to u'.  None where no constant brackets are known.
    """
    g, lower = frame.graph, frame.system.l
    brackets = known_brackets(g).get(frame.omega)
    if brackets is None:
        return None
    omega = (*(g.zero for _ in range(lower)), *frame.free)
    return [g.neg(_swirl(g, brackets, omega, omega, mu)) for mu in range(lower, frame.system.n)]


def _split_forces(system: System, values: Sequence[Node]) -> tuple[System, list[Node]]:
    """The system without the forces on the frame's forms, and these, each by itself: they do work along one vector only."""
    g, given = system.graph, system.given
    own = [g.zero] * system.n
    if given is None or (given.Q, given.torques) != (system.Q, system.torques):
        return system, own
    places = {core: (k, size) for k, (size, core) in enumerate(g.split_coefficient(value) for value in values)}
    taken = set[str]()
    for force, form in given.on:
        size, core = g.split_coefficient(form_value(system, form))
        if core in places:
            k, whole = places[core]
            own[k] = g.add(own[k], g.mul(g.number(Fraction(size) / Fraction(whole)), force))
            taken.add(form.name)
    Q, torques = given.without(taken)
    return replace(system, Q=Q, torques=torques, pulls=None, given=None), own


def _swirl(graph: Graph, brackets: Brackets, omega: Sequence[Node], momenta: Sequence[Node], mu: int) -> Node:
    """gamma^i_nu,mu omega_nu p*_i."""
    terms = []
    for nu, velocity in enumerate(omega):
        for i, number in brackets.get((nu, mu), {}).items():
            terms.append(graph.mul(number, graph.mul(velocity, momenta[i])))
    return graph.sum(terms)


def _find_brackets(system: System, frame: Frame) -> Brackets | None:
    """None where one is no number, or where the time is in them."""
    g, n = system.graph, system.n
    probe, found, off = probe_of(g), Brackets(), list[Node]()
    for i in range(n):
        for mu in range(n):
            epsilon = frame.epsilon(i, mu)
            if not abs(probe.value(epsilon)) <= _NEAR:  # nan is none
                return None
            off.append(epsilon)
            for nu in range(mu):
                gamma = frame.gamma(i, nu, mu)
                value = probe.value(gamma)
                if not (math.isfinite(value) and abs(value - round(value)) <= _NEAR):
                    return None
                number = g.number(round(value))
                off.append(g.sub(gamma, number))
                if number != g.zero:
                    found.setdefault((nu, mu), {})[i] = number
                    found.setdefault((mu, nu), {})[i] = g.neg(number)
    return found if all(are_zero(g, off)) else None
