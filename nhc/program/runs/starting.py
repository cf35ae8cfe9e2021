"""Whether the accelerations are determined where a scene starts, for its values of the parameters, and for those of the spec."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.dense import RowSpace, pivot_signs
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, SpecError, quote
from nhc.language.spec import Scene
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.regular.given_rank import find_dependent_as_given, find_dependent_row, given_states
from nhc.mechanics.regular.trials import velocity_units
from nhc.mechanics.regular.undefined import find_pole
from nhc.mechanics.starts.massless import is_massless
from nhc.mechanics.starts.scenes import Start, kept_velocities, place_of, start_of
from nhc.mechanics.values import coordinate_ranges, is_outside
from nhc.program.planning.planner import Planner
from nhc.program.runs.undetermined import blame, find_undetermined, tell_needed, tell_undetermined

_NOTHING: tuple[str, tuple[str, ...]] = ("", ())
_REFUSED, _OTHER = "the functions refuse that start", "the formulation `multipliers` has no coframe"


def warn_of_coframe(planner: Planner, scenes: Sequence[Scene]) -> tuple[str, ...]:
    """A line for each scene that starts where the planner's own formulation is singular, though another may not be, or where every
    one is, since the constraints lose their rank there.
    """
    g, system = planner.graph, planner.system
    told = g.mask((system.t, *system.q, *system.p))  # a determinant of parameters alone may vanish for their values
    pairs = [pair for pair in planner.full_equations.guards if g.deps[pair[0]] & told]
    guards = planner.frame_determinants() if pairs else ()
    if planner.exchanges:
        pairs = [(guard.value, guard.scale) for guard in guards]
    nodes = [x for pair in pairs for x in pair]
    lines = []
    for scene in scenes if guards or planner.full_equations.multipliers else ():
        try:
            place = place_of(system, scene)
            values = [float(x) for x in evaluate(g, nodes, place)]
        except (SpecError, ArithmeticError, ValueError):
            continue  # a scene without a start
        if guards and all(abs(x) > guards[0].tolerance * y for x, y in zip(values[::2], values[1::2], strict=True)):
            continue
        starts, form = f"the scene `{scene.name}` starts where", find_dependent_row(system, place)
        if form is not None:
            lines.append(
                f"{starts} the constraint `{form.name}` follows from the others: {_REFUSED}, in every formulation"
            )
        elif guards:
            lines.append(f"{starts} {guards[0].what}: {_REFUSED}; {_OTHER}")
    return tuple(lines)


def check_starts(planner: Planner, bag: Bag) -> None:
    """Add the errors of the scenes' starts, and what :func:`warn_undetermined` and :func:`warn_negative` say of the others."""
    for scene in planner.system.spec.scenes:
        try:
            start = start_of(planner.system, scene)
        except SpecError as error:
            bag.extend(error.diagnostics)
        else:
            warn_undetermined(planner, start, bag)
            warn_negative(planner, start, bag)
            _warn_outside(planner, start, bag)


def _warn_outside(planner: Planner, start: Start, bag: Bag) -> None:
    """Add a warning (W0429) where a coordinate starts outside of the range that is declared for it."""
    system = planner.system
    ranges = coordinate_ranges(system)
    for symbol, name, value in zip(system.q, system.q_names, start.q, strict=True):
        if symbol not in ranges or not is_outside(ranges[symbol], value):
            continue
        low, high = ranges[symbol]
        own = ("coordinate", name)
        given = [entry.value.span for entry in start.scene.initial if (entry.kind, entry.name) == own]
        bag.warning(
            "W0429",
            f"`{name}` starts at {value:.6g}, outside of its range [{low:.6g}, {high:.6g}]",
            given[0] if given else start.scene.span,
            notes=("velocities are chosen so that they are regular where coordinates are expected to stay",),
            help=("start it within, or declare where it goes",),
        )


def warn_undetermined(planner: Planner, start: Start, bag: Bag) -> None:
    """Add a warning (W0421) where a scene starts at a singular mass matrix, where the constraints lose their rank, or where an
    expression has no value or no slope, or a needed output no value.
    """
    if (told := tell_undetermined(planner, start) or tell_needed(planner, start)) is not None:
        message, notes, help = told
        bag.warning("W0421", message, start.scene.span, notes=notes, help=help)


def refuse_massless(planner: Planner, start: Start) -> None:
    """Raise ``SpecError`` (E0404) where a coordinate has no inertia at the start: the least model may not feel it."""
    if not is_massless(planner.full_equations, planner.formulation.frame, start):
        return
    told = tell_undetermined(planner, start)
    if told is not None:
        bag, (message, notes, help) = Bag(planner.system.spec.origin), told
        bag.error("E0404", message, start.scene.span, notes=notes, help=help)
        bag.raise_if_errors()


def warn_as_given(planner: Planner, bag: Bag) -> None:
    """Add a warning (W0422) where no state has determined accelerations and reactions with the parameters' values in the spec.

    Scenes may give other values: each has a warning of its own, and where one can run nothing is said of the spec's values.
    """
    system = planner.system
    if sum(d.code == "W0421" for d in bag.diagnostics) < len(system.spec.scenes):
        return
    if any(parameter.value is None for parameter in system.spec.parameters):
        return
    form, held = find_dependent_as_given(system)
    if form is not None:
        spans = system.spec.constraint_spans
        where = "where the equations under `holonomic:` hold" if held else "with the values under `parameters:`"
        bag.warning(
            "W0422",
            f"the constraint `{form.name}` follows from the others {where}",
            spans.get(form.name, system.spec.kinetic.span),
            notes=(
                "the reactions are not determined, and the equations of motion have no solution, or more than one",
                "other statements about the constraints hold for other values or positions only",
            ),
            help=("remove it" if held else "remove it, or give the parameters other values",),
        )
    if form is not None or system.spec.scenes:
        return
    poles = [find_pole(system, place) for place in given_states(system)]
    if poles and all(what for what, _, _ in poles):
        what, span, part = poles[0]
        held = part is None or system.graph.depends(part, system.graph.mask(system.p))
        real = "keep arguments where functions are real, or give a scene a start where they are"
        seen, advice = (
            ("with the values under `parameters:`", "give the parameters other values")
            if system.p and held
            else ("at the states that were tried", real)
        )
        bag.warning(
            "W0422",
            f"{what} {seen}",
            span,
            help=(advice,),
        )
        return
    scene = Scene("", system.spec.kinetic.span, "", (), (), (Fraction(0), Fraction(1)), (), Fraction(1))
    found = []
    for place in given_states(system):
        p, q, v = (tuple(place[symbol] for symbol in symbols) for symbols in (system.p, system.q, system.v))
        found.append(find_undetermined(planner, Start(scene, (place[system.t], place[system.t] + 1), p, q, v)))
    if found and all(what for what, _ in found):
        what, zero = found[0]
        names = quote(zero)
        bag.warning(
            "W0422",
            f"{what} with the values under `parameters:`",
            system.spec.kinetic.span,
            notes=(f"{names} {'is' if len(zero) == 1 else 'are'} zero",) if zero else (),
            help=(f"give {names} a value" if zero else "give the parameters other values",),
        )


def warn_negative(planner: Planner, start: Start, bag: Bag) -> None:
    """Add a warning (W0423) where T, at a scene's start, is negative for some motion that the constraints allow."""
    what, notes = find_negative(planner, start)
    if what and not bag.again("W0423", what, start.scene.span):
        help = ("look for a wrong sign in `T`, or in the values of the parameters",)
        bag.warning("W0423", what, start.scene.span, notes=notes, help=help)


def note_negative(equations: Equations, formulation: Formulation, start: Start) -> tuple[str, ...]:
    """The same as a note of what runs from this start, which may have other values than `nhc check` has seen; or none."""
    if equations.definite:
        return ()
    what, why = find_negative(Planner(equations, formulation), start)
    return (f"{': '.join((what, *why))} (W0423)",) if what else ()


def note_negative_starts(equations: Equations, formulation: Formulation, starts: Sequence[Start]) -> tuple[str, ...]:
    """The same of many starts, the first of which is named by its number from 1."""
    if equations.definite:
        return ()
    planner = Planner(equations, formulation)
    found = [(k, *find_negative(planner, start)) for k, start in enumerate(starts, 1)]
    found = [(k, what, why) for k, what, why in found if what]
    if not found:
        return ()
    k, what, why = found[0]
    where = f"start {k}" if len(found) == 1 else f"{len(found)} starts, {k} the first"
    return (f"{where}: {': '.join((what, *why))} (W0423)",)


def find_negative(planner: Planner, start: Start) -> tuple[str, tuple[str, ...]]:
    """That T is negative for some motion that the constraints allow at a start, and what may be to blame; empty where it is not.

    Said of the part of T that is of second order in the velocities, without which there is no motion.
    """
    equations = planner.equations
    if equations.definite:  # for the values of every scene
        return _NOTHING
    g, system = planner.graph, planner.system
    rates = kept_velocities(system, planner.kept_forms(), start)
    values = {**dict(zip(equations.motion.w, rates, strict=True)), **start.values(system)}
    flat = [entry for row in equations.mass for entry in row]
    size = len(equations.mass)
    try:
        numbers = [float(x) for x in evaluate(g, flat, values)]
        basis = _admissible(planner, values) if size == system.n and system.l else None
    except (ArithmeticError, ValueError, KeyError):
        return _NOTHING
    matrix = [numbers[i * size : (i + 1) * size] for i in range(size)]
    if basis is not None:
        moved = [[sum(map(operator.mul, row, vector)) for row in matrix] for vector in basis]
        matrix = [[sum(map(operator.mul, one, other)) for other in moved] for one in basis]
    if not all(map(math.isfinite, (x for row in matrix for x in row))) or not _is_negative_somewhere(matrix):
        return _NOTHING
    names = blame(planner, start, *flat, negative=True)
    notes = (f"{quote(names)} {'is' if len(names) == 1 else 'are'} negative there",) if names else ()
    return "the kinetic energy is negative for some motions where this scene starts", notes


def _admissible(planner: Planner, values: dict[Node, float]) -> list[list[float]]:
    """Vectors that span the motions which the constraints allow."""
    system = planner.system
    space, units = RowSpace(system.n), velocity_units(system)
    for form in system.constraints:
        row = [float(x) for x in evaluate(planner.graph, form.coefficients, values)]
        space.add([a * u for a, u in zip(row, units, strict=True)], 0.0)
    dependent = [column for column, _, _ in space.rows]
    basis = []
    for j in range(system.n):
        if j not in dependent:
            vector = [float(k == j) for k in range(system.n)]
            for column, row, _ in space.rows:
                vector[column] = -row[j]
            basis.append([x * u for x, u in zip(vector, units, strict=True)])
    return basis


def _is_negative_somewhere(matrix: list[list[float]]) -> bool:
    """Whether a symmetric matrix has a negative direction, clearly; units of the entries do not matter."""
    sizes = [math.sqrt(abs(row[i])) or 1.0 for i, row in enumerate(matrix)]
    scaled = [[x / (a * b) for x, b in zip(row, sizes, strict=True)] for row, a in zip(matrix, sizes, strict=True)]
    return any(row[i] < 0.0 for i, row in enumerate(scaled)) or -1 in pivot_signs(scaled)
