"""On paper a rotation is written by the entries of its matrix: put back, they give what was derived, exactly."""

from __future__ import annotations

import pytest

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.emit.text import print_derivation
from nhc.language import Source, decode, read
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import form_value
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.program.paper import derivation
from nhc.program.sheets.draft import Desk, Part
from nhc.program.sheets.motion import _mass_matrix, _reaction_masses
from tests.support import spec_path

TWO = """nhc: 1
system: two
coordinates: [x, y, z]
rotation:
  A: {velocities: [p, q, r], frame: space}
  B: {velocities: [u, v, w]}
parameters: {m: 1, a: 0.3, g: 9.81, c: 0.1, k: 2, h: 0.5}
define: {X: x + a*B_x3, Y: y + a*B_y3, Z: z + a*B_z3}
T: m/2*(X'^2 + Y'^2 + Z'^2) + (p^2 + 2*q^2 + 3*r^2)/2 + (u^2 + 2*v^2 + 3*w^2)/2 + c*p*x'*A_z3
V: m*g*Z + k*A_x1*B_x1
forces: {p: -c*p, w: h*B_y2, x: -c*x'}
constraints:
  - r - 0.2 = 0
  - w - 2*u - A_x2*x' = 0
"""
NAMES = ("two", "heavy_top_quaternion", "free_rigid_body_quaternion", "chaplygin_ball_quaternion")


def load(name: str) -> System:
    return resolve(decode(Source("two.yaml", TWO) if name == "two" else read(str(spec_path(name)))))


def put_back(system: System, nodes: list[Node]) -> list[Node]:
    """The nodes with the definitions of the entries and of the angular velocities, by the spec's own names for them."""
    g, values = system.graph, dict[Node, Node]()
    for rotation, declared in zip(system.rotations, system.spec.rotations, strict=True):
        entries = [entry for row in rotation.matrix for entry in row]
        values |= {g.symbol(name, "entry"): node for name, node in zip(declared.entries, entries, strict=True)}
        values |= {
            g.symbol(name, "quasi"): node for name, node in zip(declared.velocities, rotation.omega, strict=True)
        }
    return substitute(g, nodes, values, named=False)


@pytest.mark.parametrize("name", NAMES)
def test_entries_put_back_give_what_was_derived(name: str) -> None:
    system = load(name)
    formulation = formulate(system, "")
    equations = equations_of(system, formulation)
    desk, g = Desk(system, formulation, equations), system.graph
    nodes = [system.T, system.U, *system.Q, *(x for torque in system.torques for x in torque)]
    shown = [desk.by_entries(node) for node in nodes]
    assert shown[0] != system.T
    assert all(are_zero(g, [g.sub(a, b) for a, b in zip(put_back(system, shown), nodes, strict=True)]))
    # the shortened coefficients of the equations, and the mass matrix that is made again
    rows = [*equations.mass, *(row.mass for row in equations.reactions)]
    shown_rows = [*_mass_matrix(desk), *_reaction_masses(desk)]
    derived = [*equations.force, *(x for row in rows for x in row)]
    short = [*(desk.short(node) for node in equations.force), *(x for row in shown_rows for x in row)]
    assert len(short) == len(derived)
    assert all(are_zero(g, put_back(system, [g.sub(a, b) for a, b in zip(short, derived, strict=True)])))


@pytest.mark.parametrize("name", NAMES)
def test_constraints_by_angular_velocities_are_the_same_forms(name: str) -> None:
    system = load(name)
    formulation = formulate(system, "")
    desk, g = Desk(system, formulation, equations_of(system, formulation)), system.graph
    found = 0
    for form in system.constraints:
        parts = desk.velocity_form(form)
        if parts is None:
            continue
        found += 1
        assert all(are_zero(g, put_back(system, [g.sub(contract(system, parts), form_value(system, form))])))
    assert found == {"two": 2, "chaplygin_ball_quaternion": 2}.get(name, 0)


def contract(system: System, parts: tuple[Part, ...]) -> Node:
    """The sum of coefficients times what their marks name."""
    g = system.graph
    rates = {(name, 1): v for name, v in zip(system.q_names, system.v, strict=True)}
    for declared in system.spec.rotations:
        rates |= {(name, 0): g.symbol(name, "quasi") for name in declared.velocities}
    terms = [g.mul(node, rates[marks[0].base, marks[0].dots]) if marks else node for node, marks in parts]
    return g.sum(terms)


def test_a_rolling_ball_reads_like_a_textbook() -> None:
    system = load("chaplygin_ball_quaternion")
    formulation = formulate(system, "")
    text = print_derivation(derivation(system, formulation, equations_of(system, formulation)))
    for line in (
        "  x' - a*R_y1 w1 - a*R_y2 w2 - a*R_y3 w3 = 0   (I.1.1)   roll_x",
        "  dpi_roll_y = dy + a*R_x1 dpi_w1 + a*R_x2 dpi_w2 + a*R_x3 dpi_w3",
        "  gamma^roll_x_{w1,w2} = -a*R_y3   (I.2.11)",
        "  (I1 + m*a^2*(1 - R_z1^2)) w1' - m*a^2*R_z1*R_z2 w2' - m*a^2*R_z1*R_z3 w3' = w2*w3*(I2 - I3)",
    ):
        assert line in text.splitlines(), line


@pytest.mark.parametrize("name", NAMES)
def test_the_turn_of_a_direction_has_no_name(name: str) -> None:
    """omega of a vector that is no velocity is another number than omega of the motion: it must not be printed under its name."""
    system = load(name)
    g = system.graph
    for rotation in system.rotations:
        for unit in range(4):
            turned = rotation.turning(g, [g.one if k == unit else g.zero for k in range(4)])
            assert not [g.labels[node] for node in turned if node in g.labels]
