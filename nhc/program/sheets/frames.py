"""Kinematics: the solved constraints (I.1.2), or the coframe (I.2.3), its inverse (I.2.4), gamma and epsilon (I.2.11)."""

from __future__ import annotations

from nhc.algebra.graph import Node
from nhc.algebra.walks import count
from nhc.diagnostics import quote
from nhc.mechanics.frame import Frame
from nhc.program.sheets.draft import Desk, Draft, DraftSheet, Part
from nhc.program.sheets.formulas import GAMMA
from nhc.program.sheets.model import Mark

_HEAVY = 600  # operations of the inverse beyond which only what the motion needs is shown


def kinematics_sheet(desk: Desk) -> DraftSheet | None:
    """None where the coordinates' own velocities are kept."""
    frame = desk.formulation.frame
    if frame is None:
        return None
    if desk.formulation.name == "euler-lagrange":
        return _coframe_sheet(desk, frame)
    return _solved_constraints(desk, frame)


def _solved_constraints(desk: Desk, frame: Frame) -> DraftSheet:
    sheet = DraftSheet("kinematics", "The constraints, solved")
    system, choice = desk.system, desk.formulation.dependent
    assert choice is not None
    free = [i for i in range(system.n) if i not in choice.dependent]
    names = ", ".join(f"`{system.q_names[i]}'`" for i in choice.dependent)
    one = len(choice.dependent) == 1
    solved = (
        "The constraint is solved for the dependent velocity"
        if one
        else "The constraints are solved for the dependent velocities"
    )
    sheet.say(f"{solved} {names}:")
    rates = [desk.coordinate(i, 1) for i in free]
    for alpha in choice.dependent:
        coefficients = [e[alpha] for e in frame.free_vectors]
        right = desk.linear(coefficients, rates, frame.drift[alpha])
        sheet.add(Draft(desk.name(desk.coordinate(alpha, 1)), right, equation="I.1.2"))
    if choice.determinant is None:
        block = (
            "its coefficient does not vanish, which" if one else "the block of their coefficients is; its determinant"
        )
        sheet.say(f"The choice is regular where {block} is too long to show.")
    elif desk.graph.value(choice.determinant) is not None:
        sheet.say(f"{_name_determinant(one)} is a constant: the choice is regular everywhere.")
    else:
        note = "never zero for these parameters and ranges" if choice.regular else "where it vanishes, choose others"
        sheet.say(f"The choice is regular where {_name_determinant(one).lower()} does not vanish:")
        sheet.add(Draft(desk.name(desk.own("Delta")), desk.determinant(choice.determinant), note=note))
    return sheet


def _name_determinant(one: bool) -> str:
    return "Its coefficient" if one else "The determinant of their coefficients"


def _coframe_sheet(desk: Desk, frame: Frame) -> DraftSheet:
    sheet = DraftSheet("kinematics", "The coframe")
    system = desk.system
    lower = system.l
    if desk.formulation.added:
        names = quote(desk.formulation.added)
        fewer = "fewer quasi-velocities than there are free velocities" if system.quasi else "no quasi-velocities"
        sheet.say(f"The spec gives {fewer}; nhc has completed the coframe with {names}.")
    known = {form.name for form in frame.forms}
    values = _by_angular_velocities(desk, frame, known)
    if values:
        sheet.say("In the angular velocities, which are not part of it, its velocities are")
        sheet.add(*values)
    basis = [Mark(name, prefix="d") for name in system.q_names] + [Mark("t", prefix="d")]
    written: list[Draft] = []
    for j, form in enumerate(frame.forms):
        right = desk.differential_form(form, known) or desk.linear([*form.coefficients, form.constant], basis)
        left = desk.quasi_differential(j)
        if right != ((desk.graph.one, (left,)),):
            written.append(Draft(desk.name(left), right, equation="I.2.3", place=form.place))
    if not written:
        sheet.say("The quasi-velocities are the velocities of the coordinates: all $gamma$ and $epsilon$ vanish.")
        return sheet
    if lower:
        sheet.say("The forms of the constraints, zero on every motion, and those of the free quasi-velocities are")
    else:
        sheet.say("The forms of the quasi-velocities are")
    sheet.add(*written)
    _inverse(desk, frame, sheet)
    _structure(desk, frame, sheet)
    return sheet


def _by_angular_velocities(desk: Desk, frame: Frame, known: set[str]) -> list[Draft]:
    """Velocities made of angular ones whose forms are not in the coframe: as forms they are written in the rates of quaternions."""
    named = {name for declared in desk.system.spec.rotations for name in declared.velocities}
    if known >= named:
        return []
    free = zip(frame.free, frame.forms[desk.system.l :], strict=True)
    made = [(desk.mark(w), desk.velocity_form(form)) for w, form in free if form.name not in named]
    return [Draft(desk.name(left), right) for left, right in made if right is not None]


def _inverse(desk: Desk, frame: Frame, sheet: DraftSheet) -> None:
    system = desk.system
    full = count(desk.graph, [n for e in frame.vectors for n in e]) <= _HEAVY
    first = 0 if full else system.l
    sheet.say("They are inverted to" if full else "On the constraints they are inverted to")
    speeds = [desk.mark(w) for w in frame.omega[first:]]
    for i in range(system.n):
        left = desk.coordinate(i, 1)
        right = desk.linear([e[i] for e in frame.vectors[first:]], speeds, frame.drift[i])
        if right != ((desk.graph.one, (left,)),):
            sheet.add(Draft(desk.name(left), right, equation="I.2.4"))
    guards = [guard for guard, _ in frame.guards if desk.graph.value(guard) is None]
    if guards:
        sheet.say("which needs that these do not vanish:")
        for k, guard in enumerate(guards):
            sheet.add(Draft(desk.name(desk.own("Delta", str(k + 1))), desk.determinant(guard)))


def _structure(desk: Desk, frame: Frame, sheet: DraftSheet) -> None:
    """gamma and epsilon: of all pairs, or of the free ones where the frame is heavy (the equations need no others)."""
    system, n = desk.system, desk.system.n
    full = count(desk.graph, [x for e in frame.vectors for x in e]) <= _HEAVY // 2
    first = 0 if full else system.l
    names = [form.name for form in frame.forms]
    found: list[tuple[Mark, Node]] = []
    for i in range(n):
        for m in range(first, n):
            found += [(Mark("gamma", (names[m], names[j]), (names[i],)), frame.gamma(i, m, j)) for j in range(m + 1, n)]
        found += [(Mark("epsilon", (names[j],), (names[i],)), frame.epsilon(i, j)) for j in range(first, n)]
    kept = [entry for entry, keep in zip(found, desk.nonzero([node for _, node in found]), strict=True) if keep]
    if not kept:
        closed = "All their $gamma$ and $epsilon$ vanish: the forms are closed."
        free = "Their $gamma$ and $epsilon$ between free quasi-velocities, all that the motion needs, vanish."
        sheet.say(free if first else closed)
        return
    sheet.say("Their exterior derivatives define $gamma$ and $epsilon$:")
    sheet.add(GAMMA)
    which = " between free quasi-velocities" if first else ""
    sheet.say(f"Those{which} that do not vanish ($gamma$ is antisymmetric in its lower indices):")
    for mark, node in kept:
        right: tuple[Part, ...] = desk.value(node)
        sheet.add(Draft(desk.name(mark), right, equation="I.2.11"))
