"""CasADi's C for any spec: T, U, Q and the rows as the spec writes them, all derivatives and the algebra by CasADi.

The rates are solved for by elimination that takes constant pivots first, then rows with few entries, as one would by hand; the
accelerations by CasADi's LDL^T.  The state is nhc's own, so that results can be compared.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca

from benchmarks.models import Sources
from benchmarks.peers.casadi_c import print_sources
from nhc.algebra.evaluate import evaluate
from nhc.mechanics.frame import form_value
from nhc.mechanics.system import Form
from nhc.pipeline import Model
from nhc.program.planning.planner import Planner


class _Symbols:
    """CasADi's functions under the names of :func:`nhc.algebra.evaluate.evaluate`."""

    pi = ca.SX(ca.pi)
    sin, cos, asin, acos, atan, atan2 = ca.sin, ca.cos, ca.asin, ca.acos, ca.atan, ca.atan2
    sinh, cosh, tanh, exp, log, sqrt = ca.sinh, ca.cosh, ca.tanh, ca.exp, ca.log, ca.sqrt

    @staticmethod
    def number(numerator: int, denominator: int) -> Any:
        return ca.SX(numerator / denominator)


def casadi_sources(model: Model) -> Sources:
    """C of ``int casadi_call(t, y, p, dydt)`` for a model whose velocities are independent."""
    system = model.system
    g = system.graph
    q, v, p, t = (
        ca.SX.sym(name, size) for name, size in (("q", system.n), ("v", system.n), ("p", len(system.p)), ("t", 1))
    )
    values = dict(zip((*system.q, *system.v, *system.p, system.t), ca.vertsplit(ca.vertcat(q, v, p, t)), strict=True))
    kept = Planner(model.equations, model.formulation).kept_forms()

    def translate(nodes: Sequence[int]) -> Any:
        return ca.vertcat(*evaluate(g, nodes, values, _Symbols))

    def rows(forms: Sequence[Form]) -> Any:
        return translate([form_value(system, form) for form in forms]) if forms else ca.SX(0, 1)

    w = ca.SX.sym("w", len(kept))
    constrained, chosen = rows(system.constraints), rows(kept)
    together = ca.vertcat(constrained, chosen)
    start = ca.substitute(together, v, ca.SX.zeros(system.n))
    rates = _eliminate(ca.jacobian(together, v), ca.vertcat(ca.SX.zeros(constrained.numel()), w) - start)
    energy, potential = translate([system.T]), translate([system.U])
    load = translate(list(system.Q)) + ca.jacobian(potential, q).T
    momentum = ca.jacobian(energy, v).T
    mass = ca.jacobian(momentum, v)
    still = ca.jtimes(momentum, q, v) + ca.jacobian(momentum, t) - ca.jacobian(energy, q).T - load
    partial = ca.jacobian(rates, w)
    drift = ca.jtimes(rates, q, rates) + ca.jacobian(rates, t)
    mass, still = (ca.substitute(part, v, rates) for part in (mass, still))
    reduced, force = partial.T @ mass @ partial, -partial.T @ (mass @ drift + still)
    diagonal, upper, order = ca.ldl(reduced)
    slope = ca.cse(ca.vertcat(rates, ca.ldl_solve(force, diagonal, upper, order)))
    return print_sources(ca.Function("casadi_rhs", [ca.vertcat(q, w), p, t], [slope]))


def _eliminate(matrix: Any, right: Any) -> Any:
    """x of ``matrix x = right``: Gauss and Jordan with pivots in the order described above."""
    size = matrix.size1()
    rows = [
        (
            {j: matrix[i, j] for j in range(size) if matrix.sparsity().has_nz(i, j) and not matrix[i, j].is_zero()},
            right[i],
        )
        for i in range(size)
    ]
    found: dict[int, tuple[dict[int, Any], Any]] = {}
    while rows:
        best = min(
            ((not entry.is_constant(), len(row), k, j) for k, (row, _) in enumerate(rows) for j, entry in row.items()),
        )
        row, value = rows.pop(best[2])
        column = best[3]
        pivot = row.pop(column)
        unit = ({j: entry / pivot for j, entry in row.items()}, value / pivot)
        rows = [_reduce(other, column, unit) for other in rows]
        found = {j: _reduce(other, column, unit) for j, other in found.items()}
        found[column] = unit
    return ca.vertcat(*(found[j][1] for j in range(size)))


def _reduce(
    row: tuple[dict[int, Any], Any], column: int, unit: tuple[dict[int, Any], Any]
) -> tuple[dict[int, Any], Any]:
    entries, value = row
    factor = entries.get(column)
    if factor is None:
        return row
    made = {j: entry for j, entry in entries.items() if j != column}
    for j, entry in unit[0].items():
        made[j] = made[j] - factor * entry if j in made else -factor * entry
    return {j: entry for j, entry in made.items() if not ca.simplify(entry).is_zero()}, value - factor * unit[1]
