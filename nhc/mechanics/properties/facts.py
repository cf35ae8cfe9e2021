"""What ``nhc check --explain`` says of a system: facts as lines, as data, and as warnings with places."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

from nhc.algebra.bounds.common_zero import find_common_zero
from nhc.algebra.exact.modular import Unlucky, is_zero
from nhc.diagnostics import Bag, several
from nhc.mechanics.added_forms import describe_added
from nhc.mechanics.choosing.choose import Formulation, applicable, chaplygin_dependent, checked_dependent
from nhc.mechanics.formulations.chaplygin import mark_letters
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.properties.coframe import warn_of_dependent, warn_of_quasi_velocities
from nhc.mechanics.properties.conserved import Integral, find_conserved
from nhc.mechanics.properties.inertia import warn_of_inertia
from nhc.mechanics.properties.integrability import Integrability, classify, classify_as_given, cyclic_coordinates
from nhc.mechanics.properties.integrals import PositionIntegral, find_position_integrals, quote_integral, tell_integral
from nhc.mechanics.properties.named import LONG, is_cut, product_text
from nhc.mechanics.properties.rough import list_torn, warn_rough
from nhc.mechanics.properties.singular import find_rank_loss, needs_ranges
from nhc.mechanics.properties.still import depends_on_time, describe_affine, describe_kinetic
from nhc.mechanics.properties.zeros import never_vanishes, where_all_zero, where_zero
from nhc.mechanics.regular.determined import warn_of_bare
from nhc.mechanics.regular.regularity import Choice, choose_dependent
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.system import System

_UNDECIDED = "not decided (too many nested roots for the exact test)"
_UNKNOWN = "; nhc has found none in elementary functions"
_SHOWN, _READABLE = 6, 400  # minors that are written out; characters of one


@dataclass
class Facts:
    """Lines for people, data for programs; in ``marked``, which a derivation typesets, expressions stand between dollar signs.

    No name or expression of a spec contains these; ``lines``, for a terminal, are without them.
    """

    marked: dict[str, str] = field(default_factory=dict)
    data: dict[str, Any] = field(default_factory=dict)

    def say(self, key: str, value: object, line: str) -> None:
        self.data[key] = value
        self.marked[key] = line

    @property
    def lines(self) -> tuple[str, ...]:
        return tuple(line.replace("$", "") for line in self.marked.values())


def describe(
    system: System, formulation: Formulation, bag: Bag, *, explain: bool = True, by_name: bool | None = None
) -> Facts:
    """Facts of the system; warnings go to the bag.  Without ``explain`` little more is looked at than what may be warned of.

    ``by_name``: whether somebody asked for the formulation; None where only the spec may have.
    """
    facts = Facts()
    n, lower = system.n, system.l
    parts = ((n, "coordinate", "coordinates"), (lower, "constraint", "constraints"))
    text = ", ".join(_numbered(*part) for part in (*parts, (n - lower, "free velocity", "free velocities")))
    facts.say("degrees", {"n": n, "l": lower}, text)
    _kinetic(system, facts, explain)
    warn_of_bare(system, bag)
    warn_of_inertia(system, bag)
    integrals: tuple[PositionIntegral, ...] = ()
    torn = list_torn(system)
    if lower:
        integrals = _constraints(system, formulation, facts, torn, bag, explain)
        choice = formulation.dependent or checked_dependent(system)
        if by_name is None:
            by_name = (system.spec.formulation or "auto") != "auto"
        _dependent(system, formulation, choice, by_name, facts, bag)
        if explain:
            _hypotheses(system, choice, facts)
    warn_of_quasi_velocities(system, formulation, bag)
    if explain:
        cyclic = [system.q_names[i] for i in cyclic_coordinates(system)]
        facts.say("cyclic", cyclic, f"cyclic coordinates: {_list_marked(cyclic) or 'none'}")
        try:
            _conserved(system, formulation, integrals, facts)
        except Unlucky:
            facts.say("conserved", [], f"constants of the motion: {_UNDECIDED}")
        names = [f.name for f in applicable(system)]
        facts.say("applicable", names, f"formulations that apply: {', '.join(names)}")
    added = describe_added(system, formulation.frame)
    data = {"name": formulation.name, "number": formulation.number, "reason": formulation.reason, "added": added}
    line = f"formulation: {formulation.name} ({formulation.number}), {formulation.reason}"
    facts.say("formulation", data, "; ".join([line, *(_with_its_name(name, text) for name, text in added.items())]))
    warn_rough(system, torn, bag)
    return facts


def _with_its_name(name: str, text: str) -> str:
    """An added velocity as an equation; where it is said what it makes of others, these are equations already."""
    return f"{name}: {text}" if "' = " in text else f"{name} = {text}"


def _numbered(number: int, one: str, several: str) -> str:
    return f"{number} {one if number == 1 else several}"


def _list_marked(expressions: Iterable[str]) -> str:
    return ", ".join(f"${text}$" for text in expressions)


def _kinetic(system: System, facts: Facts, explain: bool) -> None:
    text = describe_kinetic(system, explain)
    timed = depends_on_time(system, system.T)
    facts.say("rheonomic", timed, f"$T$: {text}{', contains the time' if timed else ''}")


def _constraints(
    system: System, formulation: Formulation, facts: Facts, torn: Collection[str], bag: Bag, explain: bool
) -> tuple[PositionIntegral, ...]:
    try:
        found = classify(system, formulation.frame, levels=explain)
    except Unlucky:
        facts.say("hidden", None, f"integrability: {_UNDECIDED}")
        return ()
    affine = describe_affine(system) if explain and found.affine else "affine"
    kinds = [word for word, holds in ((affine, found.affine), ("time-dependent", found.rheonomic)) if holds]
    kind = ", ".join(kinds) or "homogeneous, scleronomic"
    growth = ", ".join(str(r) for r in found.growth)
    # with what moves by itself, which is no direction that is chosen, the rest is filled
    still = " while the time stands still" if found.growth and system.n - found.growth[-1] > found.hidden else ""
    text = f"constraints: {kind}; growth vector of the allowed directions: $({growth})${still}"
    facts.say("growth", list(found.growth), text)
    facts.data.update({"affine": found.affine, "time_dependent": found.rheonomic, "kinds": _kinds(system, found)})
    special = classify_as_given(system, found, levels=explain)
    text = _count_hidden(system, found)
    if special:
        text += f" (for arbitrary parameters; with their values in the spec: {_count_hidden(*special)})"
    apart = [form.name for form in system.constraints if form.name in torn]
    if apart and (found.hidden or special):
        text += f"; at each side of where {', '.join(apart)} {'jumps' if len(apart) == 1 else 'jump'}"
    facts.say("hidden", found.hidden, f"integrability: {text}")
    integrals = _integrals(system, found, facts)
    if special:
        own = _integrals(*special, facts, "_as_given")
        facts.data["hidden_as_given"] = special[1].hidden
        _warn_integrable(special[0], special[1], own, torn, bag, " with the values under `parameters:`")
    else:
        _warn_integrable(system, found, integrals, torn, bag)
    if explain:
        _rank_loss(system, facts)
    return integrals


def _count_hidden(system: System, found: Integrability) -> str:
    if found.hidden == system.l:
        return "all constraints are integrable: the system is holonomic"
    if found.hidden:
        declared = sum(form.equation is not None for form in system.constraints)
        parts = [(declared, "as declared"), (found.hidden - declared, "holonomic in disguise")]
        kinds = [(count, word) for count, word in parts if count]
        ways = ", ".join(f"{count} {word}" if len(kinds) > 1 else word for count, word in kinds)
        return f"{found.hidden} of {system.l} constraints integrable ({ways}), the others truly nonholonomic"
    return "no combination of the constraints is integrable: truly nonholonomic"


def _kinds(system: System, found: Integrability) -> list[dict[str, object]]:
    """Each constraint by itself."""
    g = system.graph
    kinds: list[dict[str, object]] = []
    for form in system.constraints:
        timed = any(g.depends(x, g.deps[system.t]) for x in (*form.coefficients, form.constant))
        affine = not is_zero(g, form.constant)
        alone = form.name in found.closed
        kinds.append({"name": form.name, "affine": affine, "time_dependent": timed, "integrable_alone": alone})
    return kinds


def _integrals(system: System, found: Integrability, facts: Facts, given: str = "") -> tuple[PositionIntegral, ...]:
    """``given`` marks what holds for the parameters' values in the spec only."""
    if not found.hidden:
        return ()
    frame = coordinate_frame(system, choose_dependent(system).dependent)
    integrals = find_position_integrals(system, frame, found.hidden, found.closed)
    data = [{"integral": i.whole, "constraints": list(i.names)} for i in integrals]
    lost = found.hidden - len(integrals)
    declared = {form.name for form in system.constraints if form.equation is not None}
    lines = [tell_integral(i, declared) for i in integrals]
    if lost:
        lines.append(f"{lost} not found in elementary functions")
    where = " with the parameters' values in the spec" if given else ""
    facts.say(f"integrals{given}", data, f"integrals{where}: {'; '.join(lines)}")
    return integrals


def _warn_integrable(
    system: System,
    found: Integrability,
    integrals: tuple[PositionIntegral, ...],
    torn: Collection[str],
    bag: Bag,
    given: str = "",
) -> None:
    """Integrable constraints that the spec does not give under ``holonomic:``; ``given``: with which values they are.

    Those that are ``torn`` are so at each side of a jump only, with a constant of its own: there is nothing to be held to.
    """
    spans = {c.name: c.span for c in system.spec.constraints}
    written = {form.name for form in system.constraints if form.equation is not None}
    named = [name for name in found.closed if name not in written]
    for name in named:
        if name in torn:
            bag.warning(
                "W0410",
                f"the constraint `{name}` is integrable{given}, but it jumps: its integral is another one at each side",
                spans[name],
                help=(
                    "write it with continuous functions, or as one constraint for the side that the motion keeps to",
                ),
            )
            continue
        shown = _shown(name, [i for i in integrals if set(i.names) <= {*named, *written}])
        bag.warning(
            "W0410",
            f"the constraint `{name}` is integrable{given}: it is a holonomic constraint in disguise",
            spans[name],
            notes=shown,
            help=(
                f"give its integral under `holonomic:`, so that positions are held to it too{'' if shown else _UNKNOWN}",
            ),
        )
    combined = found.hidden - len(written) - len(named)
    if combined > 0:
        growth, verb = ", ".join(str(r) for r in found.growth), "is" if combined == 1 else "are"
        aside = " where they do not jump" if any(name in torn for name in spans if name not in found.closed) else ""
        texts = [f"an integral is {quote_integral(i)}" for i in integrals if len(i.names) > 1]
        bag.warning(
            "W0410",
            f"{several(combined, 'combination')} of the constraints {verb} integrable{given}{aside} (holonomic in disguise)",
            system.spec.key_span("constraints"),
            notes=(f"the growth vector of the allowed directions is ({growth}) in {system.n} coordinates", *texts),
            help=("positions are not held to the integral by the velocities alone: watch the drift",),
        )


def _shown(name: str, integrals: Sequence[PositionIntegral]) -> tuple[str, ...]:
    """The integral of an integrable constraint, or with others that are integrable, too: either can be given for it."""
    for found in sorted((i for i in integrals if name in i.names), key=lambda i: len(i.names)):
        others = " and ".join(f"`{other}`" for other in found.names if other != name)
        whose = f"with that of {others} it makes" if others else "its integral is"
        return (f"{whose} {quote_integral(found)}",)
    return ()


def _rank_loss(system: System, facts: Facts) -> None:
    found, full = find_rank_loss(system), None
    signed = [(minor, system.graph.neg(minor)) for minor in found.minors]  # what is zero has no sign
    minors = [min((product_text(system, one, _READABLE) for one in pair), key=len) for pair in signed]
    where = where_all_zero(system, found.minors, minors, _SHOWN, "$") if minors else ""
    if found.regular is None:
        text = "too large to decide where it is lost"
    elif found.regular:
        text, full = f"full everywhere{' in the declared ranges' if needs_ranges(system) else ''}", True
    elif find_common_zero(system.graph, found.minors, (*system.q, system.t), trial_points(system)) is not None:
        text, full = f"lost where {where}: the motion is undefined there", False
    else:
        text = f"full wherever it was tried; it would be lost where {where}"
    whole = [LONG if is_cut(minor) else minor for minor in minors]
    facts.say("rank", {"full": full, "lost_where_all_vanish": whole}, f"rank of the constraints: {text}")


def _conserved(system: System, formulation: Formulation, integrals: tuple[PositionIntegral, ...], facts: Facts) -> None:
    """Energy or its balance, and the constants of the motion that were found."""
    frame = coordinate_frame(system, choose_dependent(system).dependent) if system.l else None
    found = find_conserved(system, frame, formulation.frame, [i.node for i in integrals])
    if found.energy:
        line = "energy: $T + V$ is conserved"
        if found.torn:
            line += f" (for the parameters' values in the spec and its scenes; {' and '.join(found.torn)} may jump for others)"
    else:
        line = f"energy: $T + V$ is not conserved, because of: {', '.join(found.power)}"
    if found.jacobi is not None:
        line += f"; $p q' - T + V$ {'is' if found.jacobi else 'is not conserved either'}"
    facts.say(
        "energy",
        {
            "conserved": found.energy,
            "power": list(found.power),
            "generalized": found.jacobi,
            "torn_elsewhere": list(found.torn),
        },
        line,
    )
    data = [{"integral": i.text, "where_zero": list(i.where), "moving_energy": i.moving} for i in found.integrals]
    texts = [_spell(i) for i in found.integrals]
    facts.say("conserved", data, f"constants of the motion: {', '.join(texts) or 'none'} (sought among {found.tried})")
    if found.outputs:
        facts.say("constant_outputs", list(found.outputs), f"outputs that are constant: {_list_marked(found.outputs)}")


def _spell(integral: Integral) -> str:
    kind = "the moving energy " if integral.moving else ""
    where = f" (for {_list_marked(f'{name} = 0' for name in integral.where)})" if integral.where else ""
    return f"{kind}${integral.text}${where}"


def _dependent(system: System, formulation: Formulation, choice: Choice, by_name: bool, facts: Facts, bag: Bag) -> None:
    names = [f"{system.q_names[i]}'" for i in choice.dependent]
    who = "given" if set(system.dependent) == set(choice.dependent) else "chosen"
    unused = " for Voronec's equations" if who == "chosen" and formulation.dependent is None else ""
    # the choice is made by itself where it is regular, or stays so on walks along all that the mechanism can reach; so it is for
    # a name that says no more than `auto` would
    usual = formulation.dependent is not None and choice.dependent == checked_dependent(system).dependent
    tried = formulation.dependent is not None and not (by_name and usual)
    never = choice.regular or never_vanishes(system, choice.determinant)
    aside = ", as it does on none of the positions that were tried" if tried else ""
    g, given = system.graph, choice.determinant
    fixed = given is not None and g.value(given) is None and not g.depends(given, ~g.mask(system.p))
    always = "never singular unless it is 0" if fixed else "never singular"
    regular = always if never else f"singular where it vanishes{aside}"
    if choice.determinant is None:
        limit = "the determinant is too large to print"
    else:
        shown = product_text(system, choice.determinant)
        limit = "the determinant is long" if is_cut(shown) else f"determinant ${shown}$"
        if not never and is_cut(shown):
            regular = f"singular where {where_zero(system, choice.determinant, '$')}{aside}"
    facts.say(
        "dependent",
        [system.q_names[i] for i in choice.dependent],
        f"dependent velocities ({who}{unused}): {_list_marked(names)}; {limit}, {regular}",
    )
    if system.dependent and who == "chosen":
        warn_of_dependent(system, checked_dependent(system), bag)
    elif not tried and (system.dependent or formulation.dependent is not None):
        warn_of_dependent(system, choice, bag)


def _hypotheses(system: System, choice: Choice, facts: Facts) -> None:
    """Those of Čaplygin's equations, and for which dependent velocities."""
    try:
        other, _, found = chaplygin_dependent(system, choice)
    except ArithmeticError:
        return
    text = "; ".join(map(mark_letters, found.broken)) if found.broken else "all hold"
    if found.broken and not found.fatal:
        text += "; the generalized equations (III.3) hold without these"
    if other.dependent != choice.dependent:
        names = [f"{system.q_names[i]}'" for i in other.dependent]
        text = f"with {_list_marked(names)} dependent, {text}"
    facts.say("chaplygin", list(found.broken), f"Čaplygin's hypotheses (I.3): {text}")
