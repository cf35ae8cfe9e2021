"""Čaplygin's equations (I.3, III.3 with the sign of its last line; the boxed line of I.3 has the other one, erratum
E1).

The hypotheses: T, the constraints and the forces do not contain the dependent coordinates q_alpha nor t, and b_alpha
= 0. The generalization keeps what is essential (T and b_alphamu free of q_alpha) and adds b_alpha, t and forces:

    d/dt dT*/dq'_mu - dT*/dq_mu + p_alpha [(d_mu b_alphanu - d_nu b_alphamu) q'_nu + d_mu b_alpha - d_t b_alphamu] =
    Q_mu + b_alphamu Q_alpha
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from nhc.algebra.calculus import derivative, gradient, tangent
from nhc.algebra.dense import Singular, solve_double
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import Node
from nhc.algebra.solving.linear import steps_with
from nhc.diagnostics import quote
from nhc.mechanics.formulations.voronec import Reduced, applied_force, motion_rate
from nhc.mechanics.frame import Frame, dependent_coefficients
from nhc.mechanics.regular.trials import sampled_rows, trial_points
from nhc.mechanics.system import System
from nhc.records import record
from nhc.thesis.tie import equation

_LETTERS = re.compile(r"\bb_alpha\b|\bt\b(?= occurs)|\b[TU]\b|\bb\b(?= of)")
_SHIFT = 0.37
_ROUNDING = 1e-7


@record
class Hypotheses:
    """``broken`` are the hypotheses of I.3 that fail, each with the symbol that breaks it; ``fatal`` those without
    which the generalized equations do not hold either.
    """

    broken: tuple[str, ...]
    fatal: tuple[str, ...]


def mark_letters(hypothesis: str) -> str:
    """The sentence with the letters of the theory between dollar signs, for a derivation to typeset; names of the spec stay."""
    pieces = hypothesis.split("`")
    pieces[::2] = [_LETTERS.sub(lambda letter: f"${letter[0]}$", piece) for piece in pieces[::2]]
    return "`".join(pieces)


@equation("I.3")
def hypotheses(frame: Frame, dependent: Sequence[int]) -> Hypotheses:
    """Check I.3 exactly; once one is broken without which nothing holds, the others are not asked."""
    system, g = frame.system, frame.graph
    b, b_0 = dependent_coefficients(frame, dependent)
    entries = [entry for row in b for entry in row]
    fatal = [
        *_name(system, "T contains", [alpha for alpha in dependent if _contains(system, [system.T], alpha)]),
        *_name(
            system,
            "the coefficients b of the constraints contain",
            [alpha for alpha in dependent if _contains(system, entries, alpha)],
        ),
    ]
    if fatal:
        return Hypotheses(tuple(fatal), tuple(fatal))
    broken = _outside(system, b_0, dependent)
    if not all(are_zero(g, b_0)):
        broken.append("the constraints are not homogeneous (b_alpha is not zero)")
    timed = [derivative(g, x, system.t) for x in (system.T, system.U, *entries, *b_0)]
    if not all(are_zero(g, timed)) or steps_with(g, (system.T, system.U, *entries, *b_0), system.t):
        broken.append("the time t occurs in T, U or the constraints")
    return Hypotheses(tuple(broken), ())


def possible(system: System) -> list[int]:
    """The coordinates that may be dependent: those that T does not contain."""
    return [i for i in range(system.n) if not _contains(system, [system.T], i)]


def seem_free(system: System) -> Callable[[Sequence[int]], bool]:
    """A quick test of dependent velocities in doubles: whether b stays the same where their coordinates change, one at a time."""
    point = trial_points(system)[-1]
    base = sampled_rows(system, system.constraints, [dict(point)])
    moved: dict[int, list[list[list[float]]]] = {}

    def test(dependent: Sequence[int]) -> bool:
        for alpha in dependent:
            if alpha not in moved:
                other = {x: point[x] for x in (*system.q, *system.v, *system.p, system.t)}
                other[system.q[alpha]] += _SHIFT
                moved[alpha] = sampled_rows(system, system.constraints, [other])
        try:
            before = [_solved(rows, dependent) for rows in base]
            after = [_solved(rows, dependent) for alpha in dependent for rows in moved[alpha]]
        except (Singular, ArithmeticError):
            return True
        if not before:
            return True
        return all(abs(x - y) <= _ROUNDING * (1.0 + abs(y)) for b in after for y, x in zip(before[0], b, strict=True))

    return test


def _solved(rows: list[list[float]], dependent: Sequence[int]) -> list[float]:
    """b at one place, column by column."""
    block = [[row[j] for j in dependent] for row in rows]
    others = [j for j in range(len(rows[0])) if j not in dependent]
    return [x for j in others for x in solve_double(block, [-row[j] for row in rows])]


def _contains(system: System, nodes: Sequence[Node], i: int) -> bool:
    """Whether one of the nodes depends on q_i (exactly; a sign does, though its slope is zero)."""
    g, q = system.graph, system.q[i]
    seen = [node for node in nodes if g.depends(node, g.deps[q])]
    if not seen:
        return False
    return not all(are_zero(g, tangent(g, seen, {q: g.one}))) or steps_with(g, seen, q)


def _outside(system: System, b_0: Sequence[Node], dependent: Sequence[int]) -> list[str]:
    """Hypotheses on forces and on the affine part that dependent coordinates break."""
    forces = [system.force(i) for i in range(system.n)]
    affine = [alpha for alpha in dependent if _contains(system, b_0, alpha)]
    forced = [alpha for alpha in dependent if not is_zero(system.graph, forces[alpha])]
    broken = _name(system, "the affine part b_alpha of the constraints contains", affine)
    broken += _name(system, "a force acts on", forced)
    for i, force in enumerate(forces):
        inside = [alpha for alpha in dependent if alpha != i and _contains(system, [force], alpha)]
        broken += _name(system, f"the force on `{system.q_names[i]}` contains", inside)
    return broken


def _name(system: System, statement: str, dependent: Sequence[int]) -> list[str]:
    """The statement about all these coordinates in one sentence; none where there are none."""
    names = quote([system.q_names[alpha] for alpha in dependent])
    return [f"{statement} the dependent coordinate{'s' * (len(dependent) > 1)} {names}"] if dependent else []


@equation("I.3", "I.3.2", "III.3")
def printed_rows(reduced: Reduced, rates: tuple[Node, ...]) -> list[Node]:
    """The generalized equations above, left minus right, with q''_mu = ``rates``."""
    g, system = reduced.graph, reduced.system
    rows = []
    for k, momentum in enumerate(gradient(g, reduced.T_star, reduced.v_mu)):
        row = g.sub(motion_rate(reduced, momentum, rates), derivative(g, reduced.T_star, system.q[reduced.mu[k]]))
        for a, p in enumerate(reduced.p_alpha):
            row = g.add(row, g.mul(p, curl_term(reduced, a, k)))
        rows.append(g.sub(row, applied_force(reduced, k)))
    return rows


def curl_term(reduced: Reduced, a: int, k: int) -> Node:
    """(d_mu b_alphanu - d_nu b_alphamu) q'_nu + d_mu b_alpha - d_t b_alphamu."""
    g, system = reduced.graph, reduced.system
    mu = system.q[reduced.mu[k]]
    total = g.sub(derivative(g, reduced.b_0[a], mu), derivative(g, reduced.b[a][k], system.t))
    for m, nu in enumerate(reduced.mu):
        curl = g.sub(derivative(g, reduced.b[a][m], mu), derivative(g, reduced.b[a][k], system.q[nu]))
        total = g.add(total, g.mul(curl, reduced.v_mu[m]))
    return total
