"""Lagrange's equations by way of quasi-velocities: T's own angular velocities in place of the rates of Euler's angles.

With u = W q' for forms u of T, Poincaré's equations M u' = f (I.2.14) have a matrix that often hardly moves, where W^T M W is
full and moves with every angle.  The state stays (q, q'): u is put in, and q'' = W^-1 (u' - W' q').
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.walks import count
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.energies.kinetic import Kinetic, kinetic_structure, rates_of_positions, velocity_forms
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import Frame, complete_basis, coordinate_form, make_frame, velocity_symbol
from nhc.mechanics.rotations.turning import along
from nhc.mechanics.system import Form, System
from nhc.records import record

_MOST = 20
"""Coordinates beyond which a second matrix is not assembled."""


@record
class Detour:
    """``equations`` over the quasi-velocities u of ``frame``; ``values`` are theirs by the state's velocities w = ``back`` (u), and
    ``drift`` is W' w for u = W w.
    """

    equations: Equations
    frame: Frame
    values: dict[Node, Node]
    drift: tuple[Node, ...]
    back: tuple[Node, ...]

    @property
    def graph(self) -> Graph:
        return self.frame.graph

    def accelerations(self, rates: Sequence[Node]) -> list[Node]:
        """w' = W^-1 (u' - W' w) from the rates of u."""
        g = self.graph
        changed = [g.sub(rate, own) for rate, own in zip(rates, self.drift, strict=True)]
        return tangent(g, self.back, dict(zip(self.frame.free, changed, strict=True)))


def find_detour(equations: Equations) -> Detour | None:
    """By T's forms that are no rates of positions; None where there are none, or the system is not free, or is large."""
    system = equations.system
    if system.l or system.rotations or equations.motion.w != system.v or not 1 < system.n <= _MOST:
        return None
    if "detours" in system.graph.off:
        return None
    if rates_of_positions(system).issuperset(velocity_forms(system)):
        return None
    known: dict[tuple[Node, ...], Detour | None] = system.graph.memory.setdefault("detours", {})
    key = (system.T, system.U, *system.Q)
    if key not in known:
        known[key] = _make_detour(system)
    return known[key]


def _make_detour(system: System) -> Detour | None:
    kinetic = kinetic_structure(system)
    forms = _choose_forms(system, kinetic)
    if not forms:
        return None
    try:
        frame = make_frame(system, forms, [velocity_symbol(system, form) for form in forms])
        made = equations_of(system, _poincare(frame), kinetic)
    except Singular:
        return None
    if not made.definite:
        return None
    g = system.graph
    moving = {**along(system, system.v), system.t: g.one}
    return Detour(
        made,
        frame,
        {symbol: form.value for symbol, form in zip(frame.omega, forms, strict=True) if form.value is not None},
        tuple(tangent(g, [form.value], moving)[0] if form.value is not None else g.zero for form in forms),
        frame.kinematics,
    )


def _poincare(frame: Frame) -> Formulation:
    return Formulation("euler-lagrange", "I.2.14", frame, None, (), "")


def _choose_forms(system: System, kinetic: Kinetic) -> list[Form]:
    """A basis of T's forms that are no rates of positions, the simplest first, and of coordinates' velocities; empty without the
    former.

    Once as many forms as velocities stand in them are chosen, as for a body's three turns, no other form of these velocities
    is: a joint's rate stays beside its body's angular velocity.
    """
    g = system.graph
    turning = [k for k in range(len(kinetic.atoms)) if not kinetic.is_exact(k)]
    held = {k: {v for v in system.v if g.depends(kinetic.atoms[k], g.deps[v])} for k in turning}
    turning.sort(key=lambda k: (len(held[k]), count(g, [kinetic.atoms[k]]), k))
    chosen, rows = list[Form](), list[list[Node]]()
    closed, open_forms, opened = set[Node](), 0, set[Node]()
    for k in turning:
        form = kinetic.form(k)
        if held[k] & closed or rank(g, [*rows, list(form.coefficients)]) == len(rows):
            continue
        rows.append(list(form.coefficients))
        chosen.append(Form(f"own {k + 1}", form.coefficients, form.constant, form.place, value=kinetic.atoms[k]))
        opened |= held[k]
        open_forms += 1
        if len(opened) == open_forms:
            closed |= opened
            opened, open_forms = set(), 0
    return (
        [*chosen, *complete_basis(system, chosen, (coordinate_form(system, i) for i in range(system.n)))]
        if chosen
        else []
    )
