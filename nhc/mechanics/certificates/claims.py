"""What each derivation claims of the motion, as small linear systems that can be solved at a point of any field.

A claim is a regular system ``matrix @ x = right`` for the rates (and multipliers, where they are unknowns), with the
accelerations and the reactions as affine functions of x.  Nothing is solved symbolically: solutions of large systems are
never written out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from nhc.algebra.dense import solve_double, solve_modulo
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import FieldPoint
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import linear_form
from nhc.mechanics.associate import Equations
from nhc.mechanics.certificates import wrong
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.formulate import bordered_system, motion_of, rate_symbols
from nhc.mechanics.formulations import multipliers, voronec
from nhc.mechanics.frame import Frame, form_value, total_derivative
from nhc.mechanics.motion import Motion
from nhc.mechanics.system import System
from nhc.records import record

V = TypeVar("V", int, float)

Affine = tuple[tuple[Node, ...], Node]
"""(coefficients of the unknowns, constant)."""

Guards = tuple[tuple[Node, Node], ...]


@record
class Claim:
    """``guards`` are (quantity, scale) pairs that must not vanish; ``reactions`` is empty where nothing is said of them."""

    name: str
    number: str
    matrix: tuple[tuple[Node, ...], ...]
    right: tuple[Node, ...]
    accelerations: tuple[Affine, ...]
    reactions: tuple[Affine, ...]
    guards: Guards = ()

    def nodes(self) -> list[Node]:
        """Every node that has to be evaluated."""
        rows = [entry for row in self.matrix for entry in row]
        affine = [n for coefficients, c in (*self.accelerations, *self.reactions) for n in (*coefficients, c)]
        return [*rows, *self.right, *affine]


@record
class Wrong:
    """A wrong derivation's claim, with the erratum it belongs to and what it does."""

    claim: Claim
    erratum: str
    about: str


def reference_claim(system: System) -> Claim:
    """d'Alembert with multipliers, straight from T by (I.4.1), and the differentiated constraints.

    It shares no row with the compiler's associated system.
    """
    rates = rate_symbols(system, system.v)
    symbols = multipliers.multiplier_symbols(system)
    rows = [*multipliers.printed_rows(system, rates), *multipliers.constraint_rates(system, rates)]
    matrix, right = _linear_rows(system.graph, rows, (*rates, *symbols))
    return _with_unit_outputs(system, "reference", "I.4.1" if system.l else "II.3", matrix, right)


def formulation_claim(equations: Equations) -> Claim:
    """What the compiler's associated system says: the mass matrix, right side and reaction rows that are emitted."""
    system, g = equations.system, equations.system.graph
    if equations.multipliers:
        matrix, right = bordered_system(equations)
        return _with_unit_outputs(system, equations.formulation, equations.number, matrix, right)
    reactions = tuple((row.mass, g.neg(row.force)) for row in equations.reactions)
    return Claim(
        equations.formulation,
        equations.number,
        equations.mass,
        equations.force,
        _accelerations(system, equations.motion),
        reactions,
        equations.guards,
    )


def wrong_claims(system: System, formulations: Sequence[Formulation]) -> list[Wrong]:
    """The tempting derivations that this system admits."""
    found = []
    by_name = {f.name: f for f in formulations}
    plain = by_name.get("voronec")
    if plain is not None and plain.frame is not None and plain.dependent is not None:
        reduced = voronec.reduce(plain.frame, plain.dependent.dependent)
        rates = rate_symbols(system, plain.frame.free)
        for one in wrong.REDUCED:
            found.append(Wrong(_wrong_claim(system, plain, one.name, one.rows(reduced, rates)), one.erratum, one.about))
    adapted = by_name.get("euler-lagrange")
    if adapted is not None and adapted.frame is not None:
        rates = rate_symbols(system, adapted.frame.free)
        for other in wrong.FRAME:
            rows = other.rows(adapted.frame, rates)
            found.append(Wrong(_wrong_claim(system, adapted, other.name, rows), other.erratum, other.about))
    return found


def _wrong_claim(system: System, formulation: Formulation, name: str, rows: Sequence[Node]) -> Claim:
    assert formulation.frame is not None
    rates = rate_symbols(system, formulation.frame.free)
    matrix, right = _linear_rows(system.graph, rows, rates)
    accelerations = _accelerations(system, motion_of(system, formulation))
    return Claim(name, formulation.number, _freeze(matrix), tuple(right), accelerations, (), formulation.frame.guards)


def _linear_rows(graph: Graph, rows: Sequence[Node], unknowns: Sequence[Node]) -> tuple[list[list[Node]], list[Node]]:
    forms = [linear_form(graph, row, unknowns) for row in rows]
    return [list(coefficients) for coefficients, _ in forms], [graph.neg(constant) for _, constant in forms]


def _accelerations(system: System, motion: Motion) -> tuple[Affine, ...]:
    """q''_i = vectors_k,i w'_k + what the kinematics turn by themselves."""
    drift = [total_derivative(system, node, motion.velocities, {}) for node in motion.velocities]
    return tuple((tuple(e[i] for e in motion.vectors), drift[i]) for i in range(system.n))


def _with_unit_outputs(
    system: System, name: str, number: str, matrix: Sequence[Sequence[Node]], right: Sequence[Node]
) -> Claim:
    """A claim whose unknowns are q'' and lambda themselves."""
    g, n = system.graph, system.n
    unit = [(tuple(g.one if j == i else g.zero for j in range(len(right))), g.zero) for i in range(len(right))]
    return Claim(name, number, _freeze(matrix), tuple(right), tuple(unit[:n]), tuple(unit[n:]))


def _freeze(matrix: Sequence[Sequence[Node]]) -> tuple[tuple[Node, ...], ...]:
    return tuple(tuple(row) for row in matrix)


# --- solving at a point -----------------------------------------------------------------------------------


def solve_exactly(claim: Claim, point: FieldPoint) -> tuple[list[int], list[int]]:
    """(q'', lambda) modulo the point's prime.

    Raises:
        nhc.algebra.dense.Singular: the claim determines no motion there.
        nhc.algebra.exact.modular.Unlucky: the point lies on a pole.
    """
    p, known = point.prime, point.evaluate(claim.nodes())
    x = solve_modulo(*_split(claim, known), p)
    rows = _affine_rows(claim, known)
    values = [(sum(a * b for a, b in zip(row[:-1], x, strict=True)) + row[-1]) % p for row in rows]
    n = len(claim.accelerations)
    return values[:n], values[n:]


def solve_in_doubles(claim: Claim, graph: Graph, state: dict[Node, float]) -> tuple[list[float], list[float]]:
    """(q'', lambda) in double precision.

    Raises:
        nhc.algebra.dense.Singular, ArithmeticError, ValueError: not at this state.
    """
    values = [float(x) for x in evaluate(graph, claim.nodes(), state)]
    x = solve_double(*_split(claim, values))
    found = [sum(a * b for a, b in zip(row[:-1], x, strict=True)) + row[-1] for row in _affine_rows(claim, values)]
    n = len(claim.accelerations)
    return found[:n], found[n:]


def _split(claim: Claim, values: Sequence[V]) -> tuple[list[list[V]], list[V]]:
    size = len(claim.right)
    matrix = [list(values[i * size : (i + 1) * size]) for i in range(size)]
    return matrix, list(values[size * size : size * size + size])


def _affine_rows(claim: Claim, values: Sequence[V]) -> list[list[V]]:
    size = len(claim.right)
    rest = values[size * size + size :]
    return [list(rest[k : k + size + 1]) for k in range(0, len(rest), size + 1)]


# --- admissible states ------------------------------------------------------------------------------------


@record
class Velocities:
    """Every velocity symbol as a function of free ones: q'_i and the quasi-velocities on the constraints."""

    symbols: tuple[Node, ...]
    nodes: tuple[Node, ...]
    guards: Guards = ()

    def standing(self) -> dict[Node, Node]:
        return dict(zip(self.symbols, self.nodes, strict=True))


def admissible_velocities(system: System, base: Frame | None, formulations: Sequence[Formulation]) -> Velocities:
    """``base`` (None: no constraints) is the frame whose free velocities are drawn."""
    motion = dict(zip(system.v, base.kinematics if base is not None else system.v, strict=True))
    for formulation in formulations:
        frame = formulation.frame
        if frame is None:
            continue
        for symbol, form in zip(frame.free, frame.forms[system.l :], strict=True):
            if symbol not in motion:
                value = form_value(system, form)
                known = dict(zip(system.v, motion.values(), strict=False))
                (motion[symbol],) = substitute(system.graph, [value], known)
    return Velocities(tuple(motion), tuple(motion.values()), base.guards if base is not None else ())
