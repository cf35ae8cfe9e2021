"""What ``nhc check --explain`` says of a system: facts as lines, as data, and as warnings with places."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from nhc.algebra.calculus import reachable
from nhc.algebra.interval import cannot_vanish
from nhc.algebra.show import to_text
from nhc.diagnostics import Bag
from nhc.mechanics import chaplygin
from nhc.mechanics.choose import Formulation, applicable, dependent_of
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.integrability import classify, cyclic_coordinates
from nhc.mechanics.kinetic import velocity_degrees
from nhc.mechanics.regularity import intervals
from nhc.mechanics.system import System


@dataclass
class Facts:
    """Lines for people, data for programs."""

    lines: tuple[str, ...] = ()
    data: dict[str, Any] = field(default_factory=dict)

    def say(self, key: str, value: object, line: str) -> None:
        self.data[key] = value
        self.lines = (*self.lines, line)


def describe(system: System, formulation: Formulation, bag: Bag) -> Facts:
    """Facts of the system; warnings go to the bag."""
    facts = Facts()
    n, lower = system.n, system.l
    facts.say("degrees", {"n": n, "l": lower}, f"{n} coordinates, {lower} constraints, {n - lower} free velocities")
    _kinetic(system, facts)
    if lower:
        _constraints(system, facts, bag)
        _dependent(system, facts, bag)
    _quasi(system, formulation, bag)
    cyclic = [system.q_names[i] for i in cyclic_coordinates(system)]
    facts.say("cyclic", cyclic, f"cyclic coordinates: {', '.join(cyclic) or 'none'}")
    names = [f.name for f in applicable(system)]
    facts.say("applicable", names, f"formulations that apply: {', '.join(names)}")
    line = f"formulation: {formulation.name} ({formulation.number}), {formulation.reason}"
    facts.say(
        "formulation", {"name": formulation.name, "number": formulation.number, "reason": formulation.reason}, line
    )
    _nonsmooth(system, bag)
    return facts


def _kinetic(system: System, facts: Facts) -> None:
    degree = velocity_degrees(system.graph, system.T, system.v)[system.T]
    text = {2: "quadratic in the velocities"}.get(degree, "no polynomial of degree 2 in the velocities")
    timed = system.graph.depends(system.T, system.graph.deps[system.t])
    facts.say("rheonomic", timed, f"T: {text}{', contains the time' if timed else ''}")


def _constraints(system: System, facts: Facts, bag: Bag) -> None:
    found = classify(system)
    kinds = [word for word, holds in (("affine", found.affine), ("time-dependent", found.rheonomic)) if holds]
    kind = ", ".join(kinds) or "homogeneous, scleronomic"
    growth = ", ".join(str(r) for r in found.growth)
    facts.say("growth", list(found.growth), f"constraints: {kind}; growth vector of ker A: ({growth})")
    if found.hidden:
        text = f"{found.hidden} of {system.l} constraint(s) integrable (holonomic in disguise)"
    else:
        text = "no integrable combination: truly nonholonomic"
    facts.say("hidden", found.hidden, f"integrability: {text}")
    spans = {c.name: c.span for c in system.spec.constraints}
    written = {form.name for form in system.constraints if form.equation is not None}
    hidden = found.hidden - len(written)
    named = [name for name in found.closed if name not in written]
    for name in named:
        bag.warning(
            "W0410",
            f"the constraint `{name}` is integrable: it is a holonomic constraint in disguise",
            spans[name],
            help=("give its integral under `holonomic:`, so that positions are held to it too",),
        )
    if hidden > len(named):
        bag.warning(
            "W0410",
            f"{hidden} combination(s) of the constraints are integrable (holonomic in disguise)",
            system.spec.key_span("constraints"),
            notes=(f"the growth vector of the allowed directions is ({growth}) in {system.n} coordinates",),
            help=("positions are not held to the integral by the velocities alone: watch the drift",),
        )


def _dependent(system: System, facts: Facts, bag: Bag) -> None:
    choice = dependent_of(system)
    names = ", ".join(f"{system.q_names[i]}'" for i in choice.dependent)
    who = "given" if system.dependent else "chosen"
    if choice.determinant is None:
        limit = "the determinant is too large to print"
    else:
        limit = f"determinant {to_text(system.graph, choice.determinant)}"
    regular = "never singular" if choice.regular else "singular where it vanishes"
    facts.say(
        "dependent",
        [system.q_names[i] for i in choice.dependent],
        f"dependent velocities ({who}): {names}; {limit}, {regular}",
    )
    if system.dependent and not choice.regular and choice.determinant is not None:
        bag.warning(
            "W0408",
            f"the dependent velocities {names} are singular where `{to_text(system.graph, choice.determinant)} = 0`",
            system.spec.key_span("dependent"),
            help=("leave `dependent:` out, or use quasi-velocities that stay regular",),
        )
    try:
        found = chaplygin.hypotheses(coordinate_frame(system, choice.dependent), choice.dependent)
    except ArithmeticError:
        return
    text = "; ".join(found.broken) if found.broken else "all hold"
    facts.say("chaplygin", list(found.broken), f"Čaplygin's hypotheses (I.3): {text}")


def _quasi(system: System, formulation: Formulation, bag: Bag) -> None:
    """A set of quasi-velocities that loses rank somewhere."""
    if formulation.frame is None or not system.quasi:
        return
    known = intervals(system)
    for guard, _ in formulation.frame.guards:
        if cannot_vanish(system.graph, guard, known):
            continue
        bag.warning(
            "W0408",
            f"the quasi-velocities are singular where `{to_text(system.graph, guard)} = 0`",
            system.spec.key_span("quasi_velocities"),
            help=("choose forms that stay independent there, or keep away from it",),
        )


def _nonsmooth(system: System, bag: Bag) -> None:
    rough = {"abs", "sign", "min", "max"}
    g = system.graph
    for key, node in (("T", system.T), (system.spec.potential_kind or "U", system.U)):
        found = sorted({g.op[n] for n in reachable(g, [node])} & rough)
        if found:
            bag.warning(
                "W0416",
                f"`{key}` contains {', '.join(found)}: differentiated almost everywhere",
                system.spec.key_span(key),
                help=("use a smooth function if the motion crosses the kink",),
            )
