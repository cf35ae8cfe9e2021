"""The data: coordinates, parameters, T, U, Q, the constraints (I.1.1), and why this formulation."""

from __future__ import annotations

import math
import re
from fractions import Fraction

from nhc.language import Scene
from nhc.language.expressions.unparse import show_number, unparse
from nhc.mechanics.formulations.chaplygin import mark_letters
from nhc.program.sheets.bodies import say_bodies
from nhc.program.sheets.draft import Desk, Draft, DraftSheet
from nhc.program.sheets.formulas import NOTATION
from nhc.program.sheets.model import OTHER, Mark, Table


def data_sheet(desk: Desk, scene: Scene | None) -> DraftSheet:
    """Coordinates and parameters with units and values (the scene's where one is given), energies, forces, constraints."""
    sheet = DraftSheet("data", "The system")
    system = desk.system
    sheet.say("The coordinates are")
    rows = [(Mark(c.name), c.about, c.unit, _interval(c.range)) for c in system.spec.coordinates]
    sheet.add(_table(("coordinate", "meaning", "unit", "range"), rows))
    _parameters(desk, sheet, scene)
    say_bodies(desk.system.spec, sheet)
    _rotations(desk, sheet)
    sheet.say("The kinetic energy is")
    sheet.add(Draft(desk.name(desk.own("T")), desk.plain(desk.by_entries(system.T)), place=system.places["T"]))
    if desk.graph.zero != system.U:
        sheet.say("and the force function $U = -V$, whose derivatives are the forces of the potential,")
        sheet.add(
            Draft(desk.name(desk.own("U")), desk.plain(desk.by_entries(system.U)), place=system.places.get("U", ""))
        )
    else:
        sheet.say("No force has a potential: the force function $U$ and the potential energy $V = -U$ are zero.")
    _forces(desk, sheet)
    _constraints(desk, sheet)
    return sheet


def _parameters(desk: Desk, sheet: DraftSheet, scene: Scene | None) -> None:
    parameters = desk.system.spec.parameters
    if not parameters:
        return
    given = {entry.name: entry.value for entry in scene.parameters} if scene is not None else {}
    sheet.say(f"The parameters, with the values of the scene `{scene.name}`, are" if scene else "The parameters are")
    rows = []
    for parameter in parameters:
        value = given.get(parameter.name, parameter.value)
        shown = "" if value is None else show_number(value) if isinstance(value, Fraction) else unparse(value)
        rows.append((Mark(parameter.name), parameter.about, parameter.unit, shown or "given by each scene"))
    sheet.add(_table(("parameter", "meaning", "unit", "value"), rows))


def _interval(limits: tuple[Fraction, Fraction] | None) -> str:
    return "" if limits is None else f"{_limit(limits[0])} to {_limit(limits[1])}"


def _limit(value: Fraction) -> str:
    """A number, or a simple part of pi, which the language has rounded."""
    part = Fraction(float(value) / math.pi).limit_denominator(12)
    if not value or abs(float(value) - float(part) * math.pi) > 1e-14 * abs(float(value)):
        return show_number(value)
    above = {1: "pi", -1: "-pi"}.get(part.numerator, f"{part.numerator} pi")
    return above if part.denominator == 1 else f"{above}/{part.denominator}"


def _forces(desk: Desk, sheet: DraftSheet) -> None:
    """Forces by coordinates, torques by angular velocities."""
    system = desk.system
    turned = {k for rotation in system.rotations for k in rotation.places}
    acting = [(name, system.Q[i]) for i, name in enumerate(system.q_names) if i not in turned]
    for torque, declared in zip(system.torques, system.spec.rotations, strict=True):
        acting += zip(declared.velocities, torque, strict=True)
    acting = [entry for entry, keep in zip(acting, desk.nonzero([node for _, node in acting]), strict=True) if keep]
    if acting:
        by = ", by coordinates and angular velocities," if system.rotations else ""
        sheet.say(f"The forces without potential{by} are")
        for name, node in acting:
            force = desk.plain(desk.by_entries(node))
            sheet.add(Draft(desk.name(desk.own("Q", name)), force, place=system.places.get(name, "")))


def _rotations(desk: Desk, sheet: DraftSheet) -> None:
    """The entries of each rotation's matrix and its angular velocity, which all other statements use by name."""
    for rotation, declared in zip(desk.system.rotations, desk.system.spec.rotations, strict=True):
        axes = "the body" if declared.frame == "body" else "space"
        sheet.say(
            f"The matrix of the rotation `{declared.name}`, from the body's axes 1, 2, 3 to those of space, and its"
            f" angular velocity on the axes of {axes} are"
        )
        nodes = [entry for row in rotation.matrix for entry in row] + list(rotation.omega)
        for name, node in zip((*declared.entries, *declared.velocities), nodes, strict=True):
            sheet.add(Draft(desk.name(Mark(name)), desk.plain(node)))


def _table(
    head: tuple[str, ...],
    rows: list[tuple[Mark | str, ...]] | list[tuple[Mark, str, str, str]],
) -> Table:
    """The table without the columns that hold nothing."""
    kept = [k for k in range(len(head)) if any(row[k] != "" for row in rows)]
    return Table(tuple(head[k] for k in kept), tuple(tuple(row[k] for k in kept) for row in rows))


def _constraints(desk: Desk, sheet: DraftSheet) -> None:
    system = desk.system
    if not system.constraints:
        freedom = "one degree" if system.n == 1 else f"{system.n} degrees"
        sheet.say(f"There are no constraints: the system has {freedom} of freedom.")
        return
    count, n = system.l, system.n
    sheet.say(
        f"The motion obeys {'one constraint' if count == 1 else f'{count} constraints'}, linear in the velocities;"
        f" {n - count} of the {n} velocities {'is' if n - count == 1 else 'are'} free:"
    )
    rates = [desk.coordinate(i, 1) for i in range(n)]
    for form in system.constraints:
        left = desk.velocity_form(form) or desk.linear(form.coefficients, rates, form.constant)
        sheet.add(Draft(left, (), equation="I.1.1", place=form.place, note=form.name))
    held = [form for form in system.constraints if form.equation is not None]
    if held:
        one = len(held) == 1
        which = "It" if count == 1 else f"Of these, {', '.join(f'`{form.name}`' for form in held)}"
        sheet.say(
            f"{which} {'is the derivative' if one else 'are the derivatives'} of the holonomic"
            f" {'constraint' if one else 'constraints'}"
        )
        for form in held:
            assert form.equation is not None
            sheet.add(Draft(desk.plain(form.equation), (), place=form.place, note=form.name))


def reason_sheet(desk: Desk) -> DraftSheet:
    """Which formulation, why, and which hypotheses hold."""
    formulation = desk.formulation
    sheet = DraftSheet("formulation", "The formulation")
    title = TITLES[formulation.name]
    velocities = "|".join(map(re.escape, desk.system.q_names))
    turned = rf"(?<=turn with )(?:{velocities})(?!\w)"
    names = "|".join(
        [rf"(?:{velocities})'(?!\w)", turned, *(rf"{re.escape(name)}(?=[,:]|$)" for name in formulation.added)]
    )
    reason = re.sub(rf"(?<!\w)({names})", r"$\1$", formulation.reason.rstrip("."))
    sheet.say(f"The equations are {title}. Why these: {reason}.")
    if formulation.name == "chaplygin":
        if formulation.broken:
            sheet.say("Of the hypotheses of I.3 these do not hold, and the generalized equations are used:")
            for line in formulation.broken:
                sheet.say(f"- {mark_letters(line)}.")
        else:
            sheet.say(
                "The hypotheses of I.3 hold: $T$ and the constraints contain neither the dependent coordinates nor the time,"
                " the constraints are homogeneous, no force acts on a dependent coordinate or contains one, and the potential"
                " does not contain the time."
            )
    _notation(desk, sheet)
    return sheet


def _notation(desk: Desk, sheet: DraftSheet) -> None:
    """What the indices and letters of the general formulas stand for."""
    name = desk.formulation.name
    counted = _COUNTED[name if desk.system.l or name != "euler-lagrange" else "free"]
    force = "X_i" if name == "newton" else "Q_i"
    own = [letter for letter in re.findall(r"\$(\w+)\$", counted) if desk.is_named(letter)]
    shown = ", ".join(f"${letter}$" for letter in own)
    not_own = f" There {shown} {'is' if len(own) == 1 else 'are'} not the spec's." if own else ""
    sheet.say(
        f"In the general formulas {counted}.{not_own} ${force}$ is the whole force, that of the potential included."
    )
    if name in NOTATION:
        sheet.say("The constraints are written" if name == "multipliers" else "The letters are defined by")
        sheet.add(NOTATION[name])


def add_letters(desk: Desk, sheet: DraftSheet) -> None:
    """Which symbols of the theory stand in another shape, since the spec gives their letters a meaning of its own."""
    if not desk.reshaped:
        return
    sheet.say(
        "The spec uses letters of the theory for quantities of its own. In general formulas, and where a sentence speaks of"
        " energies or forces, they are the theory's; in the equations of this system the theory's are written"
    )
    rows: list[tuple[Mark | str, ...]] = [
        (mark, " of ".join([_THEORY[mark.base.removesuffix(OTHER)], *(x for x in mark.lower if not x.isdigit())]))
        for mark in desk.reshaped
    ]
    sheet.add(_table(("written", "what it is"), rows))


_THEORY = {
    "T": "kinetic energy",
    "U": "force function",
    "E": "energy",
    "H": "generalized energy",
    "Q": "force",
    "p": "momentum",
    "lambda": "reaction",
    "omega": "quasi-velocity",
    "Delta": "determinant",
}

_INDEPENDENT = "$alpha$ and $beta$ count the dependent velocities, $mu$ and $nu$ the independent ones"
_COUNTED = {
    "newton": "$i$ and $mu$ count the coordinates $x_i$, each with its mass $m_i$ and its velocity $v_i$",
    "lagrange": "$i$ and $mu$ count the coordinates",
    "multipliers": "$i$ and $mu$ count the coordinates, $alpha$ the constraints",
    "euler-lagrange": (
        "$alpha$ counts the constraints, whose quasi-velocities are zero on the motion, $mu$ and $nu$ the free quasi-velocities,"
        " $i$, $j$ and $m$ all $n$ of them; $r$, $s$ and $t$ run to $n + 1$ for the time"
    ),
    "free": "$i$, $j$, $m$ and $mu$ count the $n$ quasi-velocities; $r$, $s$ and $t$ run to $n + 1$ for the time",
    "chaplygin": _INDEPENDENT,
    "voronec": _INDEPENDENT,
}

TITLES = {
    "newton": "Newton's",
    "lagrange": "Lagrange's",
    "euler-lagrange": "the Euler-Lagrange equations in quasi-velocities (Poincaré, Hamel)",
    "chaplygin": "Čaplygin's",
    "voronec": "Voronec's",
    "multipliers": "Lagrange's with multipliers",
}
