"""The associated system, the equations of motion, the reactions and the energy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.calculus import derivative, gradient
from nhc.algebra.dense import Singular
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import solve
from nhc.algebra.walks import count
from nhc.mechanics.formulate import bordered_system
from nhc.mechanics.formulations.euler_lagrange import quasi_energy
from nhc.mechanics.formulations.lagrange import momenta
from nhc.mechanics.formulations.multipliers import multiplier_symbols
from nhc.mechanics.frame import Frame
from nhc.mechanics.properties.constancy import has_jumps
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.rows import ENERGY, MOTION, associated_rows, energy_identity, motion_components
from nhc.program.sheets.draft import Desk, Draft, DraftSheet, Part
from nhc.program.sheets.forms import Forms
from nhc.program.sheets.formulas import (
    CONTRACTION,
    CONTRACTION_NEWTON,
    CONTRACTION_QUASI,
    ENERGY_THEOREM,
    ENERGY_THEOREM_FREE,
    EQUATIONS,
    POINCARE,
    REACTION,
)
from nhc.program.sheets.model import Mark

_SOLVED = 6  # rates up to which the system is solved on paper
_SHORT = 60  # operations of a solved rate that is still worth printing
_MORE = 90  # operations of all rates together that the equations do not have
_WORTH = 300  # operations of mass and force up to which solving is tried
_CONTRACTIONS = {"euler-lagrange": CONTRACTION_QUASI, "newton": CONTRACTION_NEWTON}


def associated_sheet(desk: Desk, forms: Forms) -> DraftSheet:
    """i_X Omega row by row, each claim tested exactly."""
    sheet = DraftSheet("associated", "The associated system")
    motion, system = desk.equations.motion, desk.system
    field = desk.vector_field()
    sheet.say(f"The interior product of the 2-form with a vector field ${field}$ that satisfies the kinematics is")
    general = _CONTRACTIONS.get(desk.formulation.name, CONTRACTION)
    sheet.add(replace(general, text=general.text.replace("X", field), latex=general.latex.replace("X", field)))
    if forms.whole is None:
        sheet.say(
            "So the rows of the velocities' differentials hold automatically, those of the velocity forms are the equations of"
            " motion, and the row of $dt$ is their combination: the theorem of energy."
        )
        return sheet
    components = motion_components(system, motion)
    rows = associated_rows(forms.whole, components)
    basis = desk.basis(forms.whole)
    sheet.say(f"The motion is the vector field ${field}$ for which this vanishes; its components along the coframe are")
    for mark, node in zip(basis, components, strict=True):
        sheet.add(Draft(desk.name(replace(mark, at=f"({field})")), desk.plain(node)))
    automatic, one = sum(row.kind == "automatic" for row in rows), len(motion.w) == 1
    if automatic == len(motion.w):
        which = "one holds" if one else f"{automatic} hold"
        whose = "that of the velocity's differential" if one else "those of the velocities' differentials"
        sheet.say(f"Of its {len(rows)} rows {which} automatically (checked exactly), {whose}.")
    sheet.say("The equation of motion is the row" if one else "The equations of motion are the rows")
    for row, mark in zip(rows, basis, strict=True):
        if row.kind == MOTION:
            sheet.add(Draft(desk.value(row.node), (), equation="III.1.1", label=mark))
    identity = energy_identity(forms.whole, rows, components)
    (last,) = [row for row in rows if row.kind == ENERGY]
    weighted = desk.graph.sum(
        [desk.graph.mul(w, row.node) for w, row in zip(motion.w, rows[: len(motion.w)], strict=True)]
    )
    if not any(desk.nonzero([identity, desk.graph.add(last.node, weighted)])):
        sheet.say(
            f"The row of $dt$ is {'this one times minus its' if one else 'the sum of these, each times minus its'} velocity"
            f" (checked exactly): the theorem of energy, a consequence of the {'equation' if one else 'equations'} of motion."
        )
    return sheet


def motion_sheet(desk: Desk) -> DraftSheet:
    """mass w' = force, the kinematics that complete it, and the solution where it is short."""
    sheet = DraftSheet("motion", "The equations of motion")
    equations, system, name = desk.equations, desk.system, desk.formulation.name
    motion = equations.motion
    sheet.say("In general form they are")
    sheet.add(POINCARE if name == "euler-lagrange" and not system.l else EQUATIONS[name])
    rates = [desk.mark(rate) for rate in motion.rates]
    sheet.say("For this system" if rates else "No velocity is free: the constraints alone determine the motion.")
    for k, (row, force) in enumerate(zip(_mass_matrix(desk), equations.force, strict=True)):
        right: tuple[Part, ...] = desk.value(force)
        if equations.multipliers:
            coefficients = [form.coefficients[k] for form in system.constraints]
            marks = [desk.mark(symbol) for symbol in multiplier_symbols(system)]
            right += desk.linear(coefficients, marks)
        sheet.add(Draft(desk.linear(row, rates), right, equation=equations.number, place=system.places["T"]))
    if equations.multipliers:
        _constraint_rates(desk, sheet)
        return sheet
    _kinematics(desk, sheet)
    _solution(desk, sheet)
    return sheet


def _mass_matrix(desk: Desk) -> list[list[Node]]:
    """That of the equations; with rotations made again from T, where their entries still stand and can be read."""
    frame = desk.formulation.frame
    if not desk.system.rotations or frame is None or desk.formulation.name != "euler-lagrange":
        return [list(row) for row in desk.equations.mass]
    return _inertia(desk, frame.free, frame)


def _reaction_masses(desk: Desk) -> list[list[Node]]:
    """The same for the rows of the reactions."""
    frame = desk.formulation.frame
    if not desk.system.rotations or frame is None or desk.formulation.name != "euler-lagrange":
        return [list(row.mass) for row in desk.equations.reactions]
    return _inertia(desk, frame.omega[: desk.system.l], frame)


def _inertia(desk: Desk, rows: Sequence[Node], frame: Frame) -> list[list[Node]]:
    """d2T/d omega_i d omega_mu on the constraints, for i in ``rows`` and mu free; rotations are written by their entries."""
    g = desk.graph
    momentum_nodes = gradient(g, desk.by_entries(quasi_energy(frame)), rows)
    held = dict.fromkeys(frame.omega[: desk.system.l], g.zero)
    slopes = [gradient(g, p, frame.free) for p in momentum_nodes]
    return [substitute(g, row, held, named=False) for row in slopes]


def _constraint_rates(desk: Desk, sheet: DraftSheet) -> None:
    """The differentiated constraints; with them the system is linear in the accelerations and the multipliers."""
    system, g = desk.system, desk.graph
    sheet.say(
        "completed by the rates of the constraints. The whole is linear in the accelerations and the multipliers, and determines"
        " them where the constraints are independent and $T$, its part of second degree, is not degenerate on the velocities that"
        " they leave free. The emitted code solves it by elimination, with row pivoting wherever that is needed."
    )
    _, right = bordered_system(desk.equations)
    rates = [desk.mark(rate) for rate in desk.equations.motion.rates]
    for form, value in zip(system.constraints, right[system.n :], strict=True):
        sheet.add(
            Draft(desk.linear(form.coefficients, rates), desk.value(g.neg(value)), place=form.place, equation="I.1.1")
        )


def _kinematics(desk: Desk, sheet: DraftSheet) -> None:
    system, motion = desk.system, desk.equations.motion
    drafts = []
    speeds = [desk.mark(w) for w in motion.w]
    drift = desk.formulation.frame.drift if desk.formulation.frame is not None else (desk.graph.zero,) * system.n
    for i in range(system.n):
        left = desk.coordinate(i, 1)
        right = desk.linear([e[i] for e in motion.vectors], speeds, drift[i])
        if right != ((desk.graph.one, (left,)),):
            number = "I.2.4" if desk.formulation.name == "euler-lagrange" else "I.1.2"
            drafts.append(Draft(desk.name(left), right, equation=number))
    if drafts:
        sheet.say("together with the kinematics")
        sheet.add(*drafts)


def _solution(desk: Desk, sheet: DraftSheet) -> None:
    equations, rates = desk.equations, desk.equations.motion.rates
    if not rates or _already_solved(desk):
        return
    solved = _solve(desk)
    if solved:
        sheet.say("Solved for the rates:")
        for rate, value in zip(rates, solved, strict=True):
            sheet.add(Draft(desk.name(desk.mark(rate)), desk.value(value)))
        return
    long = "Solved for the rates the equations are too long to be read: the emitted code solves them at each state"
    if equations.definite:
        sheet.say(
            "The matrix on the left is symmetric and, for the values of the parameters in the spec and its scenes, positive"
            f" wherever the motion is regular. {long}, without pivoting."
        )
    else:
        sheet.say(
            "The matrix on the left is symmetric, but not positive everywhere for the values of the parameters in the spec and its"
            f" scenes, as far as nhc can tell. {long}, with row pivoting."
        )


def _solve(desk: Desk) -> list[Node]:
    """The rates where they are short, or little is to be read beside the equations themselves; else nothing."""
    equations, g = desk.equations, desk.graph
    nodes = [x for row in equations.mass for x in row] + list(equations.force)
    before = count(g, nodes)
    if len(equations.motion.rates) > _SOLVED or before > _WORTH:
        return []
    try:
        (values,) = solve(g, equations.mass, [list(equations.force)]).unknowns
    except Singular:
        return []
    short = [desk.short(value) for value in values]
    if all(desk.size(value) <= _SHORT for value in short):
        return short
    known = [desk.short(node) for node in nodes]
    return short if count(g, [*known, *short]) - count(g, known) <= _MORE else []


def _already_solved(desk: Desk) -> bool:
    g, mass = desk.graph, desk.equations.mass
    return all(x == (g.one if i == j else g.zero) for i, row in enumerate(mass) for j, x in enumerate(row))


def reaction_sheet(desk: Desk) -> DraftSheet | None:
    """lambda_alpha from the constraints' own vectors; with multipliers they are unknowns already."""
    system, equations, g = desk.system, desk.equations, desk.graph
    if not equations.reactions:
        return None
    sheet = DraftSheet("reactions", "The reactions")
    sheet.say("Each constraint adds its reaction to the forces:")
    sheet.add(REACTION)
    sheet.say("On the motion")
    rates = [desk.mark(rate) for rate in equations.motion.rates]
    rows = zip(multiplier_symbols(system), equations.reactions, _reaction_masses(desk), system.constraints, strict=True)
    for symbol, row, mass, form in rows:
        right = (*desk.linear(mass, rates), *desk.value(g.neg(row.force)))
        sheet.add(Draft(desk.name(desk.mark(symbol)), right, equation="I.4.1", place=form.place))
    return sheet


def energy_theorem_sheet(desk: Desk) -> DraftSheet:
    """T + V on the motion, and what changes p q' - T - U: terms that vanish identically are left out."""
    sheet = DraftSheet("energy", "The energy")
    system, g, motion = desk.system, desk.graph, desk.equations.motion
    on = moving(system, motion.velocities)
    slope = g.dot(momenta(desk.system), system.v)
    generalized = g.sub(g.sub(slope, system.T), system.U)
    power = g.dot(system.Q, system.v)
    change = g.sub(g.sub(power, derivative(g, system.T, system.t)), derivative(g, system.U, system.t))
    energy, whole, change = substitute(g, [system.energy, generalized, change], on)
    reactions = [form.constant for form in system.constraints]
    reactions_matter = any(desk.nonzero(reactions))
    changes, differs, mixed = desk.nonzero([change, g.sub(energy, whole), g.sub(g.sub(slope, system.T), system.T)])
    sheet.add(Draft(desk.name(desk.own("E")), desk.energy(energy, g.neg(system.U))))
    constant = not changes and not reactions_matter and not differs
    where = " where it does not jump" if constant and has_jumps(system, [system.energy], undecided=False) else ""
    if constant and not mixed and not _contains_time(desk) and not any(desk.nonzero(system.Q)):
        sheet.say(
            "$T$ is homogeneous quadratic in the velocities and nothing depends on the time:"
            f" the energy $E$ is constant{where}."
        )
        return sheet
    sheet.add(ENERGY_THEOREM if system.constraints else ENERGY_THEOREM_FREE)
    if constant:
        sheet.say(
            f"{'On the constraints the' if mixed else 'The'} left side is the rate of $E$, and on the right side no term is left"
            f" on the motion: the energy $E$ is constant{where}."
        )
        return sheet
    mark = desk.own("E")
    if differs:
        sheet.say("Here $T$ is not homogeneous quadratic in the velocities; what the theorem speaks of is")
        mark = desk.own("H")
        sheet.add(Draft(desk.name(mark), desk.value(whole)))
    right: tuple[Part, ...] = desk.value(change)
    marks = [desk.mark(symbol) for symbol in multiplier_symbols(system)]
    right += desk.linear([g.neg(a) for a in reactions], marks) if reactions_matter else ()
    sheet.say("so that on the motion" if right else "which is constant:")
    sheet.add(Draft(desk.name(Mark(mark.base, dots=1)), right))
    return sheet


def _contains_time(desk: Desk) -> bool:
    system, g = desk.system, desk.graph
    entries = [x for form in system.constraints for x in (*form.coefficients, form.constant)]
    return any(g.depends(node, g.deps[system.t]) for node in (system.T, system.U, *system.Q, *entries))
