"""Both faces of Omega agree: its expanded coefficients, contracted with the motion, are the program's rows, exactly.

Three derivations of every row are compared modulo two primes: i_X Omega with Omega's coefficients written out, the thesis's printed
equations, and `mass w' - force` of the associated system that never expands anything.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Node
from nhc.exterior import basis_form, wedge
from nhc.language import decode, read
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation, applicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.formulations import chaplygin, euler_lagrange, lagrange, multipliers, voronec
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.rows import associated_rows, energy_identity, motion_components, omega_of
from nhc.mechanics.system import System

SPECS = Path(__file__).resolve().parents[2] / "specs"
MOST_COORDINATES = 6


@cache
def load(name: str) -> tuple[System, dict[str, Formulation]]:
    system = resolve(decode(read(str(SPECS / f"{name}.yaml"))))
    return system, {f.name: f for f in applicable(system)}


def list_cases() -> list[tuple[str, str]]:
    cases = []
    for path in sorted(SPECS.glob("*.yaml")):
        system, formulations = load(path.stem)
        if system.n <= MOST_COORDINATES:
            cases += [(path.stem, name) for name in formulations]
    return cases


CASES = list_cases()


def program_rows(equations: Equations) -> list[Node]:
    """mass w' - force - A^T lambda."""
    g, system = equations.system.graph, equations.system
    rows = []
    for k, (row, force) in enumerate(zip(equations.mass, equations.force, strict=True)):
        inertial = g.sum([g.mul(m, rate) for m, rate in zip(row, equations.motion.rates, strict=True)])
        reaction = g.sum(
            [
                g.mul(symbol, form.coefficients[k])
                for symbol, form in zip(equations.multipliers, system.constraints, strict=bool(equations.multipliers))
            ]
        )
        rows.append(g.sub(g.sub(inertial, force), reaction))
    return rows


def printed_rows(system: System, formulation: Formulation, rates: tuple[Node, ...]) -> list[Node]:
    frame = formulation.frame
    if formulation.name in ("newton", "lagrange"):
        return lagrange.printed_rows(system, rates)
    if formulation.name == "multipliers":
        return multipliers.printed_rows(system, rates)
    assert frame is not None
    if formulation.name == "euler-lagrange":
        return euler_lagrange.printed_rows(frame, rates)
    assert formulation.dependent is not None
    reduced = voronec.reduce(frame, formulation.dependent.dependent)
    print_them = chaplygin.printed_rows if formulation.name == "chaplygin" else voronec.printed_rows
    return print_them(reduced, rates)


def test_gallery_is_covered() -> None:
    names = {name for name, _ in CASES}
    kinds = {kind for _, kind in CASES}
    assert len(names) >= 30
    assert kinds == {"newton", "lagrange", "multipliers", "euler-lagrange", "voronec", "chaplygin"}


@pytest.mark.parametrize(("name", "kind"), CASES)
def test_both_faces_agree(name: str, kind: str) -> None:
    system, formulations = load(name)
    g, formulation = system.graph, formulations[kind]
    equations = equations_of(system, formulation)
    motion = equations.motion
    count = len(motion.w)
    components = motion_components(system, motion)
    form = omega_of(system, formulation)
    rows = associated_rows(form, components)

    assert [row.kind for row in rows] == ["motion"] * count + ["automatic"] * count + ["energy"]
    wanted = program_rows(equations)
    printed = printed_rows(system, formulation, motion.rates)
    contracted = [row.node for row in rows[:count]]
    # every row contains its own rate, so that zero = zero proves nothing here
    assert not any(are_zero(g, [g.sum([g.mul(s, s) for s in gradient(g, row, motion.rates)]) for row in wanted]))
    assert all(are_zero(g, [g.sub(x, y) for x, y in zip(contracted, wanted, strict=True)]))
    assert all(are_zero(g, [g.sub(x, y) for x, y in zip(printed, wanted, strict=True)]))
    assert are_zero(g, [energy_identity(form, rows, components)]) == [True]


def test_the_wrong_diagram_is_noticed() -> None:
    """T* put into theta before d (the wrong diagram of III.3) gives other rows, although they conserve energy too."""
    system, formulations = load("nh_particle")
    g, formulation = system.graph, formulations["chaplygin"]
    assert formulation.frame is not None and formulation.dependent is not None
    equations = equations_of(system, formulation)
    components = motion_components(system, equations.motion)
    reduced = voronec.reduce(formulation.frame, formulation.dependent.dependent)
    naive = replace(
        reduced,
        p_alpha=tuple(g.zero for _ in reduced.p_alpha),
        slopes=tuple(gradient(g, reduced.T_star, system.q)),
    )
    form = voronec.omega(naive)
    rows = associated_rows(form, components)
    wanted = program_rows(equations)
    assert not all(are_zero(g, [g.sub(row.node, w) for row, w in zip(rows[: len(wanted)], wanted, strict=True)]))
    assert are_zero(g, [energy_identity(form, rows, components)]) == [True]


def test_a_form_without_contact_is_noticed() -> None:
    """A term that is no multiple of a contact form spoils the rows of the velocities' differentials."""
    system, formulations = load("chaplygin_sleigh")
    formulation = formulations["euler-lagrange"]
    form = omega_of(system, formulation)
    count = (len(form.coframe) - 1) // 2
    spoiled = form + wedge(basis_form(form.coframe, count), basis_form(form.coframe, 2 * count))
    components = motion_components(system, equations_of(system, formulation).motion)
    kinds = [row.kind for row in associated_rows(spoiled, components)]
    assert kinds == ["motion"] * (count + 1) + ["automatic"] * (count - 1) + ["energy"]
