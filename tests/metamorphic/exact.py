"""Accelerations in a prime field: equal motions have equal residues, however ill-conditioned a formulation is."""

from __future__ import annotations

from collections.abc import Mapping

from nhc.algebra.exact.modular import FieldPoint, Unlucky
from nhc.algebra.exact.residues import PRIMES
from nhc.algebra.graph import Node
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import build
from nhc.mechanics.formulate import accelerations, bordered_system, equations_of
from nhc.mechanics.frame import coordinate_form, form_value
from nhc.mechanics.system import System
from nhc.pipeline import decode, resolve
from tests.metamorphic.models import source_of

PRIME = PRIMES[0]
Residues = dict[str, int]  # by coordinate


def solve(matrix: list[list[int]], column: list[int]) -> list[int]:
    """matrix @ x = column mod p; unknowns without a pivot are 0."""
    rows = [[*row, x] for row, x in zip(matrix, column, strict=True)]
    width, pivots = len(matrix[0]) if matrix else 0, list[int]()
    for j in range(width):
        k = len(pivots)
        found = next((i for i in range(k, len(rows)) if rows[i][j] % PRIME), None)
        if found is None:
            continue
        rows[k], rows[found] = rows[found], rows[k]
        inverse = pow(rows[k][j], -1, PRIME)
        rows[k] = [x * inverse % PRIME for x in rows[k]]
        for i, row in enumerate(rows):
            if i != k and row[j]:
                rows[i] = [(x - row[j] * y) % PRIME for x, y in zip(row, rows[k], strict=True)]
        pivots.append(j)
    if any(row[width] for row in rows[len(pivots) :]):
        raise Unlucky
    result = [0] * width
    for k, j in enumerate(pivots):
        result[j] = rows[k][width]
    return result


def admissible(text: str, seed: int) -> Residues:
    """Residues of q' that satisfy the constraints, where the other symbols have the residues of ``seed``."""
    system = resolve(decode(source_of(text)))
    point = FieldPoint(system.graph, seed)
    v = point.evaluate(system.v)
    if system.constraints:
        rows = [point.evaluate(form.coefficients) for form in system.constraints]
        left = [sum(a * x for a, x in zip(row, v, strict=True)) for row in rows]
        off = [-x - c for x, c in zip(left, point.evaluate([f.constant for f in system.constraints]), strict=True)]
        v = [x + step for x, step in zip(v, solve(rows, off), strict=True)]
    return {name: x % PRIME for name, x in zip(system.q_names, v, strict=True)}


def exact_accelerations(text: str, formulation: str, seed: int, velocities: Mapping[str, int]) -> Residues:
    """Residues of q'' through a formulation's own state, by coordinate.

    Raises:
        Unlucky: draw another seed.
    """
    system = resolve(decode(source_of(text)))
    g, equations = system.graph, equations_of(system, made := build(system, formulation))
    forms = made.frame.forms[system.l :] if made.frame else [coordinate_form(system, i) for i in range(system.n)]
    v = {node: velocities[name] for node, name in zip(system.v, system.q_names, strict=True)}
    kept = FieldPoint(g, seed).evaluate([form_value(system, form) for form in forms], v)
    point = FieldPoint(g, seed)
    fixed = dict(zip(equations.motion.w, kept, strict=True))
    if point.evaluate(equations.motion.velocities, fixed) != list(v.values()):
        raise AssertionError("the kinematics do not give back an admissible velocity")
    rates = _rates(system, equations, point)
    return dict(zip(system.q_names, point.evaluate(accelerations(equations), rates), strict=True))


def _rates(system: System, equations: Equations, point: FieldPoint) -> dict[Node, int]:
    matrix, column = equations.mass, list(equations.force)
    unknowns = (*equations.motion.rates, *equations.multipliers)
    if equations.multipliers:
        wide, column = bordered_system(equations)
        matrix = tuple(tuple(row) for row in wide)
    residues = solve([point.evaluate(row) for row in matrix], point.evaluate(column)) if matrix else []
    return dict(zip(unknowns, residues, strict=True))
