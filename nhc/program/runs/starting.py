"""Whether the accelerations are determined where a scene starts, for its values of the parameters, and for those of the spec."""

from __future__ import annotations

import math
import operator
from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.dense import RowSpace, Singular, pivot_signs, solve_double
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, SpecError, quote
from nhc.language.spec import Scene
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.regular.given_rank import find_dependent_as_given, find_dependent_row, given_states
from nhc.mechanics.regular.trials import velocity_units
from nhc.mechanics.regular.undefined import find_pole, find_undefined
from nhc.mechanics.starts.massless import is_massless
from nhc.mechanics.starts.scenes import Start, kept_velocities, left_at_zero, place_of, start_of
from nhc.mechanics.values import coordinate_ranges, is_outside
from nhc.program.planning.planner import Planner

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
    expression has no value or no slope.
    """
    if (told := _tell_undetermined(planner, start)) is not None:
        message, notes, help = told
        bag.warning("W0421", message, start.scene.span, notes=notes, help=help)


def refuse_massless(planner: Planner, start: Start) -> None:
    """Raise ``SpecError`` (E0404) where a coordinate has no inertia at the start: the least model may not feel it."""
    if not is_massless(planner.full_equations, planner.formulation.frame, start):
        return
    told = _tell_undetermined(planner, start)
    if told is not None:
        bag, (message, notes, help) = Bag(planner.system.spec.origin), told
        bag.error("E0404", message, start.scene.span, notes=notes, help=help)
        bag.raise_if_errors()


def _tell_undetermined(planner: Planner, start: Start) -> tuple[str, tuple[str, ...], tuple[str, ...]] | None:
    """What keeps a scene from running at its start, with notes and help; None where nothing does."""
    system, values = planner.system, start.values(planner.system)
    nodes = [system.T, *(a for form in system.constraints for a in form.coefficients)]
    what, zero = _find_dependent(planner, start)
    if not what:
        what, zero = find_undetermined(planner, start)
    part = None
    if not what:
        what, part = find_undefined(system, values)
    if not what:
        what, _, part = find_pole(system, values)
    if not what:
        return None
    held: tuple[str, ...] = ()
    if part is not None:
        from nhc.program.runs.friction import RUNS, is_at_rest  # here: commands that do without it start sooner

        if is_at_rest(system, part, values):
            return f"emitted functions refuse the start of the scene `{start.scene.name}`: {what} there", (), (RUNS,)
        nodes, held = [part], _held_by(planner, part)
    notes, help = _advise(planner, start, nodes, zero, held)
    message = f"the scene `{start.scene.name}` cannot run: {what} at its start"
    return message, notes, (help, *_advise_flat(planner, values))


def _advise_flat(planner: Planner, values: dict[Node, float]) -> tuple[str, ...]:
    """Help where the slopes of a holonomic equation vanish at a state that satisfies it, as those of a square do everywhere."""
    form = find_dependent_row(planner.system, values)
    if form is None or form.equation is None or any(evaluate(planner.graph, form.coefficients, values)):
        return ()
    return (f"if the slopes of `{form.name}` vanish wherever it holds, write `x = y` for `(x - y)^2 = 0`",)


def _advise(
    planner: Planner, start: Start, nodes: Sequence[Node], zero: Sequence[str], held: Sequence[str]
) -> tuple[tuple[str, ...], str]:
    """Notes and help on a scene that cannot run: by the parameters that are zero, by those alone that an expression without a value
    depends on, or by the coordinates in the nodes whose start was left out.
    """
    names, where = quote(zero or held), "under `parameters:` or in the scene"
    if zero:
        return (f"{names} {'is' if len(zero) == 1 else 'are'} zero there",), f"give {names} a value, {where}"
    if held:
        value = "another value" if len(held) == 1 else "other values"
        return ("no start changes this: it depends on parameters alone",), f"give {names} {value}, {where}"
    left = left_at_zero(planner.system, start.scene, start.values(planner.system), nodes)
    if left:
        return (f"{left} at 0, since `initial` does not give a value",), f"say in `initial` where {left}"
    return (), "let it start elsewhere"


def _held_by(planner: Planner, node: Node) -> tuple[str, ...]:
    """The parameters of an expression that depends on nothing else; empty where it varies with the state or the time."""
    g, system = planner.graph, planner.system
    if g.depends(node, g.mask((system.t, *system.q, *system.v))):
        return ()
    named = zip(system.p, system.spec.parameters, strict=True)
    return tuple(parameter.name for symbol, parameter in named if g.depends(node, g.deps[symbol]))


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


def find_undetermined(planner: Planner, start: Start) -> tuple[str, tuple[str, ...]]:
    """What is singular at a start, and the parameters in it that are zero; empty where the accelerations are determined.

    A coframe that is singular there is not asked for: a run begins with another.
    """
    g, system = planner.graph, planner.system
    rates = kept_velocities(system, planner.kept_forms(), start)
    values = {**dict(zip(planner.equations.motion.w, rates, strict=True)), **start.values(system)}
    for guard in planner.mass_guards:
        try:
            value, scale = (float(x) for x in evaluate(g, [guard.value, guard.scale], values))
        except (ArithmeticError, ValueError, KeyError):
            return _NOTHING  # the coframe, or a function outside its domain
        if math.isnan(value):
            return _NOTHING  # a pole
        if not abs(value) > guard.tolerance * scale:
            return guard.what, _blame(planner, start, guard.value)
    for solve in planner.solves:
        flat = [entry for row in solve.matrix for entry in row]
        try:
            numbers = [float(x) for x in evaluate(g, flat, values)]
            size = len(solve.matrix)
            solve_double([numbers[i * size : (i + 1) * size] for i in range(size)], [0.0] * size)
        except Singular:
            return solve.what, _blame(planner, start, *flat)
        except (ArithmeticError, ValueError, KeyError):
            return _NOTHING
    return _NOTHING


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
    names = _blame(planner, start, *flat, negative=True)
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


def _find_dependent(planner: Planner, start: Start) -> tuple[str, tuple[str, ...]]:
    """A constraint whose row vanishes, or depends on the others, at a start; empty where there is none."""
    values = start.values(planner.system)
    form = find_dependent_row(planner.system, values)
    if form is None:
        return _NOTHING
    moves = any(float(x) for x in evaluate(planner.graph, form.coefficients, values))
    how = "depends on the others" if moves else "restricts no velocity"
    return f"the constraint `{form.name}` {how}", _blame(planner, start, *form.coefficients)


def _blame(planner: Planner, start: Start, *nodes: Node, negative: bool = False) -> tuple[str, ...]:
    """The parameters in these nodes that are zero at a start, or negative."""
    g, system = planner.graph, planner.system
    return tuple(
        parameter.name
        for symbol, parameter, value in zip(system.p, system.spec.parameters, start.p, strict=True)
        if (value < 0.0 if negative else value == 0.0) and any(g.depends(node, g.deps[symbol]) for node in nodes)
    )
