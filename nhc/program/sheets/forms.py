"""T on the constraints, the one-form theta, Omega_c, Omega_d and Omega."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import count
from nhc.exterior import Form, basis_form, one_form, wedge
from nhc.mechanics.formulations import euler_lagrange, lagrange, multipliers, voronec
from nhc.mechanics.rows import omega_of
from nhc.program.sheets.draft import Desk, Draft, DraftSheet, Part
from nhc.program.sheets.formulas import OMEGA, THETA, THETA_QUASI
from nhc.program.sheets.model import Mark
from nhc.records import record

MOST_TERMS = 400
"""Nonzero coefficients of Omega beyond which it is printed in factored form only."""
_READ = 40  # terms and operations of Omega up to which it is read at once
_MOST_OPERATIONS = 2500  # of all coefficients together
_MOST_WORK = 1500  # operations of T times coordinates, beyond which the coefficients are not even computed


@record
class Forms:
    """Omega = ``exact`` + ``dynamic`` (+ the reactions' work); ``whole`` is None where it is too long to be written out."""

    exact: Form | None
    dynamic: Form | None
    whole: Form | None


def make_forms(desk: Desk) -> Forms:
    """The expanded forms, or nothing where they would fill pages."""
    system, name, frame = desk.system, desk.formulation.name, desk.formulation.frame
    if count(desk.graph, [system.T]) * system.n > _MOST_WORK:
        return Forms(None, None, None)
    whole = desk.shortened(omega_of(system, desk.formulation))
    if name in ("newton", "lagrange", "multipliers"):
        parts = Forms(lagrange.kinetic_two_form(system), lagrange.dynamic_two_form(system), whole)
    elif name == "euler-lagrange":
        assert frame is not None
        exact = euler_lagrange.restrict(frame, euler_lagrange.kinetic_two_form(frame))
        dynamic = euler_lagrange.restrict(frame, euler_lagrange.dynamic_two_form(frame))
        parts = Forms(exact, dynamic, whole)
    else:
        dynamic = _reduced_work(desk, whole)
        parts = Forms(whole - dynamic, dynamic, whole)
    if len(whole.terms) > MOST_TERMS or count(desk.graph, list(whole.terms.values())) > _MOST_OPERATIONS:
        return Forms(None, None, None)
    return parts


def _reduced(desk: Desk) -> voronec.Reduced:
    assert desk.formulation.frame is not None and desk.formulation.dependent is not None
    return voronec.reduce(desk.formulation.frame, desk.formulation.dependent.dependent)


def _reduced_work(desk: Desk, whole: Form) -> Form:
    """(Q_mu + b_alphamu Q_alpha) dq_mu ^ dt."""
    reduced = _reduced(desk)
    work = one_form(whole.coframe, {k: voronec.applied_force(reduced, k) for k in range(len(reduced.mu))})
    return wedge(work, basis_form(whole.coframe, 2 * len(reduced.mu)))


def energy_sheet(desk: Desk) -> DraftSheet | None:
    """T on the constraints and the momenta that need all of T."""
    name, system, g = desk.formulation.name, desk.system, desk.graph
    if desk.formulation.frame is None:
        return None
    sheet = DraftSheet("kinetic", "The kinetic energy on the constraints" if system.l else "The kinetic energy")
    sheet.say("With the constraints put in, $T$ becomes" if system.l else "In the quasi-velocities,")
    if name == "euler-lagrange":
        frame = desk.formulation.frame
        energy = euler_lagrange.quasi_energy(frame)
        on = {w: g.zero for w in frame.omega[: system.l]}
        nodes = substitute(g, [energy, *gradient(g, energy, frame.omega)], on)
        sheet.add(Draft(desk.name(replace(desk.own("T"), star=bool(system.l))), desk.energy(nodes[0], g.zero)))
        if system.l:
            sheet.say(
                "The momenta belong to the full $T$, in all quasi-velocities; the constraints are used after differentiation:"
            )
        else:
            sheet.say("with the momenta")
        for form, node in zip(frame.forms, nodes[1:], strict=True):
            sheet.add(Draft(desk.name(Mark("p", (form.name,), star=True)), desk.value(node)))
        return sheet
    reduced = _reduced(desk)
    sheet.add(Draft(desk.name(replace(desk.own("T"), star=True)), desk.energy(reduced.T_star, g.zero)))
    if len(reduced.alpha) == 1:
        sheet.say("The momentum of the dependent velocity is that of the full $T$, on the constraint:")
    else:
        sheet.say("The momenta of the dependent velocities are those of the full $T$, on the constraints:")
    for alpha, p in zip(reduced.alpha, reduced.p_alpha, strict=True):
        sheet.add(Draft(desk.name(desk.own("p", system.q_names[alpha])), desk.value(p)))
    return sheet


def form_sheet(desk: Desk, forms: Forms) -> DraftSheet:
    """theta, Omega_c, Omega_d, Omega: general formulas first, then this system's."""
    sheet = DraftSheet("form", "The 2-form")
    name, system = desk.formulation.name, desk.system
    sheet.say("The Poincaré-Cartan 1-form is")
    if name == "euler-lagrange":
        sheet.add(THETA_QUASI)
    else:
        sheet.add(THETA)
    if forms.whole is None:
        sheet.add(OMEGA[name])
        sheet.say(
            "Written out in the coframe, the coefficients of the 2-form would fill pages. They are not expanded here:"
            " the contractions of its factors with the motion are the equations of motion below."
        )
        return sheet
    _theta(desk, sheet)
    assert forms.exact is not None and forms.dynamic is not None
    used = "On the constraints, which are used after differentiation, never before, its" if system.l else "Its"
    kinetic, dynamic, whole, parts = _NUMBERS[name]
    sheet.say(f"{used if parts else 'Its'} exterior derivative{parts} and the forces' part are")
    sheet.add(Draft(desk.name(desk.form_mark("Omega", "c")), desk.form(forms.exact), equation=kinetic))
    sheet.add(Draft(desk.name(desk.form_mark("Omega", "d")), desk.form(forms.dynamic), equation=dynamic))
    if name == "multipliers":
        sheet.say("The reactions work like forces:")
        sheet.add(Draft(desk.name(desk.form_mark("Omega", "r")), desk.form(_reaction_work(desk))))
    sheet.say("Together they make up the 2-form")
    sheet.add(OMEGA[name])
    if (forms.exact.terms and forms.dynamic.terms) or name == "multipliers":
        clear = _is_clear(desk, forms)
        sheet.say("which here is the sum of what stands above" if clear else "which here is")
        right = _sum_of_parts(desk, name) if clear else desk.form(forms.whole)
        sheet.add(Draft(desk.name(desk.form_mark("Omega")), right, equation=whole))
    return sheet


def _sum_of_parts(desk: Desk, name: str) -> tuple[Part, ...]:
    letters = ("c", "d", "r") if name == "multipliers" else ("c", "d")
    return tuple((desk.graph.one, (desk.form_mark("Omega", letter),)) for letter in letters)


def _is_clear(desk: Desk, forms: Forms) -> bool:
    """Whether Omega is long and one of its parts nearly as a whole: a reader would compare the terms one by one."""
    assert forms.whole is not None and forms.exact is not None and forms.dynamic is not None
    terms, sizes = desk.shortened(forms.whole).terms, dict[Node, int]()
    for node in terms.values():
        sizes[node] = desk.size(desk.short(node))
    own = [desk.shortened(part).terms for part in (forms.exact, forms.dynamic)]
    same = [sum(part.get(index) == node for index, node in terms.items()) for part in own]
    return len(terms) + sum(sizes.values()) > _READ and 2 * max(same) >= len(terms)


_NUMBERS = {
    "newton": ("II.1.4", "II.1.5", "II.1.3", ""),
    "lagrange": ("II.3.1", "II.2.3", "II.3", ""),
    "multipliers": ("II.3.1", "II.2.3", "II.3", ""),
    "euler-lagrange": ("", "III.2.1", "III.2.5", " (III.2.2 to III.2.4)"),
    "chaplygin": ("", "III.3.1", "III.3", " (III.3.2 to III.3.7)"),
    "voronec": ("", "III.4.1", "III.4", " (III.4.2 to III.4.5)"),
}
"""Of the kinetic part, the dynamic part and the whole; where the thesis numbers the kinetic part's terms only, these in words."""


def _theta(desk: Desk, sheet: DraftSheet) -> None:
    name, system, frame = desk.formulation.name, desk.system, desk.formulation.frame
    sheet.say("For this system")
    if name == "euler-lagrange":
        assert frame is not None
        theta = euler_lagrange.kinetic_one_form(frame)
    else:
        theta = lagrange.kinetic_one_form(system)
    sheet.add(Draft(desk.name(desk.form_mark("Theta")), desk.form(theta), equation="II.2.2"))


def _reaction_work(desk: Desk) -> Form:
    g, system = desk.graph, desk.system
    coframe = lagrange.phase_coframe(system)
    total: dict[int, Node] = {}
    for symbol, form in zip(multipliers.multiplier_symbols(system), system.constraints, strict=True):
        for i, a in enumerate(form.coefficients):
            total[i] = g.add(total.get(i, g.zero), g.mul(symbol, a))
    return wedge(one_form(coframe, total), basis_form(coframe, 2 * system.n))
