"""From what a user asks about (a scene, pairs, holds, a sweep) to linearisations: what ``nhc linearize`` runs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.dense import Singular
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.show import to_text
from nhc.diagnostics import Bag, Source, Span, quote, suggest
from nhc.language.expressions.names import fold_typed
from nhc.language.scope import names_in
from nhc.language.spec import Scene
from nhc.mechanics.about import Pair, point_of, read_pairs, scene_about, state_of
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.flow import Flow, flow_of
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.linearize import (
    HiddenLeaf,
    SymbolicMatrix,
    cyclic_of,
    hidden_leaf,
    is_autonomous,
    quantity,
    reduced,
    symbolic_matrix,
)
from nhc.mechanics.properties.symmetry import symmetries_of
from nhc.mechanics.properties.timed import timed_parts
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.mechanics.system import System
from nhc.mechanics.values import constant_value, named_constants
from nhc.records import record
from nhc.study.linearization.asked import SNAP, find_asked, has_halted, is_missed, list_lost
from nhc.study.linearization.branch import Branch
from nhc.study.linearization.coframes import by_multipliers, elsewhere
from nhc.study.linearization.field import Hold, SteadyModel
from nhc.study.linearization.found import NotSteady, Steady, check_frame, check_smooth
from nhc.study.linearization.leaf import defined_at, held_on_leaf, leaf_integrals
from nhc.study.linearization.linearize import Linearisation, linearise_at
from nhc.study.linearization.sweep import Sweep, sweep
from nhc.study.linearization.tape import Tapes


@record
class Request:
    """``about``: a scene or pairs; ``settings``, ``holds``: more pairs; ``sweep``: name, first and last value, count."""

    about: str
    settings: tuple[str, ...] = ()
    holds: tuple[str, ...] = ()
    sweep: tuple[str, float, float, int] | None = None


@record
class Findings:
    """What was found; ``paper`` holds the matrix as text (rows of texts) or is empty, ``why`` says why it is.

    ``absent``: parameters that are 0 and were left out of the equations.
    """

    flow: Flow
    formulation: Formulation
    model: SteadyModel
    linearisation: Linearisation
    paper: tuple[tuple[str, ...], ...]
    held: tuple[tuple[str, str], ...]
    why: str
    swept: Sweep | None
    lost: tuple[str, ...]
    """What has become of each velocity that was asked for and has gone."""
    halted: bool
    """Whether most of the motion that was asked about has gone."""
    missed: bool
    """Whether a velocity has gone that has much of the kinetic energy."""
    absent: tuple[str, ...] = ()


def steady_model(equations: Equations, formulation: Formulation, p: Sequence[float]) -> SteadyModel:
    """A model's field with what is cyclic in it and its leaves, at the parameters ``p``.

    Raises:
        NotSteady: the field depends on the time.
    """
    flow, system = flow_of(equations), equations.system
    if not is_autonomous(flow, p):
        advice = "`nhc stability` measures such a motion; or take a coordinate that turns with the time"
        timed = f" ({', '.join(parts)})" if (parts := timed_parts(system)) else ""
        raise NotSteady(
            f"the equations of motion depend on the time{timed}: nothing is steady", math.inf, advice=advice
        )
    frame, leaf = formulation.frame, HiddenLeaf(system.n)
    if system.constraints:
        try:
            leaf = hidden_leaf(system, frame or coordinate_frame(system, choose_dependent(system).dependent))
        except Singular:
            raise NotSteady("the constraints cannot be solved for any velocities", math.inf) from None
    made = SteadyModel(flow, frame, leaf, cyclic_of(flow), tuple(p), Tapes(flow.graph, flow.y))
    groups = symmetries_of(flow, frame, made.rest)
    return replace(made, generators=groups).with_parameters(made.p)


def linearise(equations: Equations, formulation: Formulation, request: Request, start: Start | None = None) -> Findings:
    """Find the steady motion, linearise about it, and sweep if asked.

    ``start`` is where the search begins, if it is not to be read from the request: its names may be those of quasi-velocities that
    this formulation does not have.

    Raises:
        nhc.diagnostics.SpecError: unknown names, or a guess that violates the constraints.
        NotSteady: no steady motion is found.
    """
    system = equations.system
    scene = scene_about(system.spec, request.about, request.settings)
    start = start or start_of(system, scene)
    model = steady_model(equations, formulation, start.p)
    flow = model.flow
    guess = state_of(flow, formulation.frame, start)
    if model.leaf.dimension < system.n:
        known = defined_at(system, leaf_integrals(system, formulation), model.values(guess))
        model = held_on_leaf(model, guess, known)
    holds = tuple(hold for text in request.holds for hold in read_holds(model, text, guess))
    steady = find_asked(model, scene, guess, holds)
    check_smooth(model, steady)
    made = linearise_at(model, steady)
    lost = list_lost(model, scene, guess, steady.y)
    halted = bool(lost) and has_halted(model, guess, steady.y)
    missed = bool(lost) and is_missed(model, scene, guess, steady.y)
    point = point_of(flow, scene)
    place = _exact_place(model, point, model.values(guess), steady)
    shifts = _list_shifts(model) if steady.turns else []
    nowhere = "nhc finds no expression in the parameters for the place of the motion"
    paper = _on_paper(model, place, shifts) if place else nowhere
    swept = sweep_along(model, scene, guess, guess, holds, request.sweep) if request.sweep else None
    if isinstance(paper, str):
        return Findings(flow, formulation, model, made, (), (), paper, swept, lost, halted, missed)
    rows = tuple(tuple(to_text(flow.graph, node) for node in row) for row in paper.entries)
    held = tuple((name, to_text(flow.graph, node)) for name, node in paper.held)
    return Findings(flow, formulation, model, made, rows, held, "", swept, lost, halted, missed)


def _on_paper(model: SteadyModel, place: dict[Node, Node], shifts: list[list[Node]]) -> SymbolicMatrix | str:
    """The matrix as expressions in the parameters, or why there is none.

    A motion may be steady only because some parameters are 0, as the amplitude of a force: they then hold for that alone.
    """
    flow, g = model.flow, model.flow.graph
    found = symbolic_matrix(flow, model.rest, place, shifts)
    names = (parameter.name for parameter in flow.system.spec.parameters)
    zeros = {symbol: name for symbol, name, value in zip(flow.system.p, names, model.p, strict=True) if value == 0.0}
    if not isinstance(found, str) or not zeros:
        return found
    nothing = dict.fromkeys(zeros, g.zero)
    still = dict(zip(place, substitute(g, list(place.values()), nothing), strict=True))
    again = symbolic_matrix(flow, model.rest, {**still, **nothing}, shifts)
    if isinstance(again, str):
        return found
    return replace(again, held=(*again.held, *((name, g.zero) for name in zeros.values())))


def _list_shifts(model: SteadyModel) -> list[list[Node]]:
    """The symmetries that shift coordinates and do nothing else, by the coordinates that are not cyclic."""
    zero, end = model.flow.graph.zero, len(model.flow.y)
    kept = [i for i in model.rest if i < model.flow.system.n]
    every = model.generators[-1] if model.generators else ()
    return [[one.get((i, end), zero) for i in kept] for one in every if all(column == end for _, column in one)]


def linearise_whole(equations: Equations, formulation: Formulation, request: Request) -> Findings:
    """The same where nobody asked for the formulation: one that is singular at the steady motion gives way to others.

    Raises:
        nhc.diagnostics.SpecError: unknown names, or a guess that violates the constraints.
        NotSteady: no steady motion is found.
    """
    system = equations.system
    better = reduced(system, formulation)
    start = start_of(system, scene_about(system.spec, request.about, request.settings))

    def study(own: System, other: Formulation) -> Findings:
        return linearise(equations_of(own, other), other, request, start)

    def keeps(made: Findings) -> bool:
        return not made.lost

    try:
        found = linearise(equations if better is formulation else equations_of(system, better), better, request)
    except NotSteady as error:
        return elsewhere(system, error, start, study, found_at, keeps)
    return (by_multipliers(system, start, study, keeps) or found) if found.missed else found


def found_at(findings: Findings) -> tuple[SteadyModel, Steady]:
    """The model with the steady motion that was found."""
    return findings.model, findings.linearisation.steady


def _exact_place(
    model: SteadyModel, point: dict[Node, Node] | None, guess: dict[Node, float], steady: Steady
) -> dict[Node, Node] | None:
    """The steady state as nodes: the guess's own expressions where it did not move, else zero and quarter turns.

    Wherever a cyclic coordinate has gone, the matrix does not contain it.
    """
    if point is None:
        return None
    flow, place = model.flow, dict[Node, Node]()
    g = flow.graph
    for i, (symbol, value) in enumerate(zip(flow.y, steady.y, strict=True)):
        turns = round(value / (math.pi / 2))
        if i in model.cyclic or abs(value - guess[symbol]) <= SNAP * (1.0 + abs(value)):
            if abs(model.value(steady.y, point[symbol]) - guess[symbol]) > SNAP * (1.0 + abs(value)):
                return None  # the start is completed in another way
            place[symbol] = point[symbol]
        elif abs(value - turns * math.pi / 2) <= SNAP and symbol in flow.system.q:
            place[symbol] = g.mul(g.div(g.number(turns), g.number(2)), g.pi())
        else:
            return None
    return place


def read_holds(model: SteadyModel, text: str, guess: Sequence[float]) -> list[Hold]:
    """``speed=5`` holds a value, ``roll`` that of the guess.

    Raises:
        nhc.diagnostics.SpecError: unknown names.
        NotSteady: the guess has no such value.
    """
    if "=" in text:
        source, given = read_pairs(text, "--hold")
        known = named_constants(model.flow.system.spec, model.p, [pair.value for pair in given])
        pairs = [(pair.name, _held_value(source, pair, known)) for pair in given]
    else:
        names = [fold_typed(name) for name in text.split(",") if name.strip()]
        pairs = [(name, _value_at(model, guess, name)) for name in names]
    return [Hold(name, named_quantity(model.flow, name, "--hold"), value) for name, value in pairs]


def _held_value(source: Source, pair: Pair, known: dict[str, float]) -> float:
    """The value of a pair.

    Raises:
        nhc.diagnostics.SpecError: it has none.
    """
    unknown = [name for name in names_in(pair.value) if name not in (*known, "pi")]
    bag = Bag(source)
    try:
        value = math.nan if unknown else constant_value(pair.value, known)
    except (ArithmeticError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        what = f"the value of `{pair.name}` is no real, finite number"
        bag.error("E0313", what, pair.span, help=("a value holds numbers, `pi`, parameters and definitions of these",))
    bag.raise_if_errors()
    return value


def _value_at(model: SteadyModel, guess: Sequence[float], name: str) -> float:
    node = named_quantity(model.flow, name, "--hold")
    try:
        return model.value(guess, node)
    except ArithmeticError as error:
        check_frame(model, guess, "where the search for a steady motion begins")
        raise NotSteady(f"`{name}` has no value where the search begins: {error}", math.inf, guess) from None


def named_quantity(flow: Flow, name: str, option: str, parameters: Sequence[str] = ()) -> Node:
    """A quantity of the state by its name; ``parameters``: what the option takes besides.

    Raises:
        nhc.diagnostics.SpecError: there is none.
    """
    node = quantity(flow, name)
    if node is not None:
        return node
    system = flow.system
    known = [
        *parameters,
        *flow.names,
        *(f"{q}'" for q in system.q_names),
        *(f.name for f in system.quasi),
        *(o for o, _ in system.outputs),
    ]
    bag = Bag(Source(option, name))
    help = suggest(name, known, f"known: {quote(list(dict.fromkeys(known))[:12])}")
    kinds = f"{'parameter, ' if parameters else ''}coordinate, velocity, quasi-velocity or output"
    bag.error("E0419", f"`{name}` is no {kinds}", Span(0, len(name)), help=(help,))
    bag.raise_if_errors()
    return flow.graph.zero


def sweep_along(
    model: SteadyModel,
    scene: Scene,
    guess: Sequence[float],
    begin: Sequence[float],
    holds: tuple[Hold, ...],
    request: tuple[str, float, float, int],
) -> Sweep:
    """Steady motions along a parameter, or along a quantity of the state that is held at each value, in place of any other.

    ``begin`` is where the first is looked for, ``guess`` what was asked for: along a parameter it may come to rest.
    """
    name, low, high, count = request
    values = [low + (high - low) * k / (count - 1) for k in range(count)]
    parameters = [p.name for p in model.flow.system.spec.parameters]
    if name not in parameters:
        node = named_quantity(model.flow, name, "--sweep", parameters)
        others = tuple(hold for hold in holds if hold.node != node)
        own = _value_at(model, begin, name)
        return sweep(Branch(lambda value: (model, (*others, Hold(name, node, value))), begin), values, name, own)
    index = parameters.index(name)
    found = sweep(
        Branch(lambda value: (model.with_parameter(index, value), holds), begin), values, name, model.p[index]
    )
    gone = []
    for value, point in zip(found.values, found.points, strict=True):
        at, y = model.with_parameter(index, value), point.steady.y
        gone.append(list_lost(at, scene, guess, y) if has_halted(at, guess, y) else ())
    return replace(found, gone=tuple(gone))
