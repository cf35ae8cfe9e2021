"""The associated system of Omega, read off its expanded coefficients: i_X Omega in the coframe, row by row.

This is Omega's face on paper; :mod:`nhc.mechanics.associate` is its face as a program, and
``tests/numeric/test_two_faces.py`` shows that the two are one.  With Omega = A_mu ^ (omega_mu - w_mu dt) and a field X whose
components along the omega_mu are w_mu,

    i_X Omega = A_mu(X) (omega_mu - w_mu dt),

so the coefficients of the velocities' differentials vanish, those of the omega_mu are the equations of motion, and that of dt
is their combination with -w_mu: the theorem of energy.  Nothing of this is assumed here; each claim is tested exactly.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Node
from nhc.exterior import Form, interior
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.formulations import euler_lagrange, lagrange, multipliers, newton, voronec
from nhc.mechanics.motion import Motion
from nhc.mechanics.system import System
from nhc.records import record
from nhc.thesis.tie import equation

AUTOMATIC, MOTION, ENERGY = "automatic", "motion", "energy"


@record
class AssociatedRow:
    """The coefficient ``node`` of i_X Omega on the basis form ``name``; ``kind`` is automatic, motion or energy."""

    name: str
    node: Node
    kind: str


def omega_of(system: System, formulation: Formulation) -> Form:
    """Omega of a formulation, expanded in its own coframe (omega_mu, domega_mu, dt)."""
    name, frame = formulation.name, formulation.frame
    if name == "newton":
        return newton.omega(system)
    if name == "lagrange":
        return lagrange.omega(system)
    if name == "multipliers":
        return multipliers.omega(system)
    assert frame is not None
    if name == "euler-lagrange":
        return euler_lagrange.omega(frame)
    assert formulation.dependent is not None
    return voronec.omega(voronec.reduce(frame, formulation.dependent.dependent))


def motion_components(system: System, motion: Motion) -> tuple[Node, ...]:
    """X along (omega_mu, domega_mu, dt): the kept velocities, their rates, and 1."""
    return (*motion.w, *motion.rates, system.graph.one)


@equation("III.1.1")
def associated_rows(omega: Form, components: Sequence[Node]) -> tuple[AssociatedRow, ...]:
    """All rows of i_X Omega, X given by its components along the coframe (velocities, rates, 1).

    A row of a velocity's differential is ``automatic`` when it vanishes identically (exact test) and ``motion`` otherwise, so
    that a 2-form which is not made of contact forms shows itself; the rows of the omega_mu are ``motion``, that of dt is
    ``energy``.
    """
    contracted = interior(components, omega)
    count = (len(omega.coframe) - 1) // 2
    nodes = [contracted.coefficient(k) for k in range(len(omega.coframe))]
    vanishing = are_zero(omega.graph, nodes[count : 2 * count])
    kinds = [MOTION] * count + [AUTOMATIC if zero else MOTION for zero in vanishing] + [ENERGY]
    return tuple(
        AssociatedRow(name, node, kind) for name, node, kind in zip(omega.coframe.names, nodes, kinds, strict=True)
    )


def energy_identity(omega: Form, rows: Sequence[AssociatedRow], components: Sequence[Node]) -> Node:
    """Omega(X, X) = w_mu row_mu + w'_mu row'_mu + row_t, which vanishes for every 2-form."""
    g = omega.graph
    return g.sum([g.mul(row.node, x) for row, x in zip(rows, components, strict=True)])
