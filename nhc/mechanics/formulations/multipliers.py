"""Lagrange's equations with multipliers (I.4.1), (I.4.2): the reference that the other formulations are held against."""

from __future__ import annotations

from nhc.algebra.graph import Node
from nhc.exterior import Form, basis_form, one_form, wedge
from nhc.language.spec import reaction_name
from nhc.mechanics.formulations import lagrange
from nhc.mechanics.frame import form_value, total_derivative
from nhc.mechanics.system import System
from nhc.thesis.tie import equation


def multiplier_symbols(system: System) -> tuple[Node, ...]:
    """lambda_alpha, one for each constraint."""
    return tuple(system.graph.symbol(reaction_name(form.name), "multiplier") for form in system.constraints)


def omega(system: System) -> Form:
    """Omega + lambda_alpha a_alphai dq_i ^ dt: the reactions do work like forces, on virtual displacements none."""
    g = system.graph
    coframe = lagrange.phase_coframe(system)
    total = lagrange.omega(system)
    for symbol, form in zip(multiplier_symbols(system), system.constraints, strict=True):
        work = one_form(coframe, {i: g.mul(symbol, a) for i, a in enumerate(form.coefficients)})
        total = total + wedge(work, basis_form(coframe, 2 * system.n))
    return total


@equation("I.4.1", "I.4.2", "I.4.5", "I.4.6")
def printed_rows(system: System, rates: tuple[Node, ...]) -> list[Node]:
    """d/dt dT/dq'_i - dT/dq_i - Q_i - lambda_alpha a_alphai."""
    g = system.graph
    rows = []
    for i, row in enumerate(lagrange.printed_rows(system, rates)):
        reaction = g.sum(
            [
                g.mul(symbol, form.coefficients[i])
                for symbol, form in zip(multiplier_symbols(system), system.constraints, strict=True)
            ]
        )
        rows.append(g.sub(row, reaction))
    return rows


@equation("I.1.1")
def constraint_rates(system: System, rates: tuple[Node, ...]) -> list[Node]:
    """d/dt (a_alphai q'_i + a_alpha) with q'' = ``rates``: what completes the rows to an index-1 system."""
    acceleration = dict(zip(system.v, rates, strict=True))
    return [total_derivative(system, form_value(system, form), system.v, acceleration) for form in system.constraints]
