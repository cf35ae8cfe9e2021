"""From equations and a scene to what is integrated: program, start, columns."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.graph import Node
from nhc.emit.statements import list_statuses
from nhc.language.spec import Scene, reaction_name
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.resolving.drawing import Sketch
from nhc.mechanics.starts.scenes import Start, kept_velocities
from nhc.mechanics.system import Form, System
from nhc.program.build import build_functions
from nhc.program.ir import Beats, Driving, Function, Leaps, Program, Stop
from nhc.program.model import build_program
from nhc.program.planning.planner import Planner
from nhc.program.runs.beats import find_beats
from nhc.program.runs.clock import find_stops
from nhc.program.runs.hold import TORN_HOLD, hold_functions, tell_torn
from nhc.program.runs.leaps import find_leaps
from nhc.program.runs.needed import Column, list_checks, list_columns, needed_function, planned_sketch
from nhc.program.runs.sharing import NO_FRICTION, Held, list_corrections, put_values
from nhc.program.runs.structure import Structure, structure_of
from nhc.program.runs.watch import Event, Watch, watch_function
from nhc.records import record
from nhc.simulate.stepping_over import Jumping, find_jumping

_NOTHING = Sketch()


@record
class Recipe:
    """What a job is made of beside formulation and start, so that a run can make it again in another formulation.

    ``needs``: names of what the user wants (none: the scene's own); ``event``: its zero ends the run, ``until``: its text;
    ``jacobian``: an implicit method needs it; ``hold``: states are brought back to the constraints; ``checks``: energy and
    residuals are computed as well, with ``draw`` what the spec draws; ``weak``: the coframe is watched for where it becomes
    weak, before it is singular; ``held``: the frictions that hold, as the last constraints of the equations' system;
    ``fixed``: made for the start's values of the parameters only, not for those of all scenes.
    """

    equations: Equations
    needs: tuple[str, ...] = ()
    event: Event | None = None
    jacobian: bool = False
    hold: bool = True
    checks: bool = False
    draw: bool = False
    weak: bool = False
    until: str = ""
    held: Held = NO_FRICTION
    fixed: bool = True


@record
class Job:
    """A scene that is ready to run.

    ``y``, ``p``, ``time``: the start's state, parameters, and first and last time, in the spec's units; ``symbols``: the
    state's entries in the system's graph; ``constants``: those of what ``p`` has after the spec's parameters.  ``columns`` are
    what the user needs, ``checks`` energy and residuals after them, ``sketch`` what is drawn; ``needed`` of the program
    computes all, in this order.  ``meanings``: of the model's status codes; ``watch``: what each watched value means;
    ``holds``: see :func:`nhc.program.runs.hold.hold_functions`; ``stops``: see :mod:`nhc.program.runs.clock`; ``jumping``: see
    :mod:`nhc.simulate.stepping_over`.  ``kept``: the velocities of the state, or None where the state was reduced for this
    start alone.  ``recipe``: how the job is made again in another formulation; None where it cannot be.
    """

    program: Program
    system: System
    start: Start
    scene: Scene
    formulation: Formulation
    y: tuple[float, ...]
    p: tuple[float, ...]
    time: tuple[float, float]
    tolerance: float
    columns: tuple[Column, ...]
    checks: tuple[Column, ...]
    meanings: dict[int, str]
    watch: Watch
    structure: Structure
    holds: tuple[tuple[str, ...], ...]
    notes: tuple[str, ...] = ()
    stops: tuple[Stop, ...] = ()
    symbols: tuple[Node, ...] = ()
    constants: tuple[Node, ...] = ()
    kept: tuple[Form, ...] | None = None
    sketch: Sketch = _NOTHING
    recipe: Recipe | None = None
    jumping: Jumping | None = None

    @property
    def events(self) -> int:
        """How many of the watched values are the user's."""
        return self.watch.events

    @property
    def width(self) -> int:
        """How many numbers ``needed`` of the program gives."""
        return len(self.columns) + len(self.checks) + len(self.sketch.nodes)

    @property
    def state_names(self) -> tuple[str, ...]:
        return tuple(quantity.name for quantity in self.program.state)


def prepare(recipe: Recipe, formulation: Formulation, start: Start, *, natural: bool = False) -> Job:
    """The job of a scene on the whole state of a formulation.

    ``natural``: with the parts of T and V that structure-preserving methods take.

    Raises:
        KeyError: a need that the spec does not have.
    """
    equations, scene = recipe.equations, start.scene
    system = equations.system
    planner = Planner(equations, formulation)
    columns = _list_columns(planner, recipe, scene)
    checks = _list_checks(planner, recipe)
    sketch = planned_sketch(planner) if recipe.draw else _NOTHING
    known = {symbol: (value, value) for symbol, value in zip(system.p, start.p, strict=True)}
    watch, watched = watch_function(
        planner, recipe.event, recipe.weak, known if recipe.fixed else {}, [start.values(system)], recipe.held
    )
    structure = structure_of(planner) if natural else Structure()
    beside = _Beside(structure.functions) if natural else _beside_steps(planner, known, recipe.hold)
    functions = (
        *build_functions(planner, ("rhs", "jacobian") if recipe.jacobian else ("rhs",)),
        needed_function(planner, [*columns, *checks, *_drawn(sketch)], _exchanged(planner, recipe, scene)),
        *(() if watch is None else (watch,)),
        *(beside.functions if not natural else (*beside.functions, *build_functions(planner, ("velocities", "state")))),
    )
    frame = build_program(system, formulation, equations, only=("residuals",), scenes=False)
    program = replace(frame, functions=functions, scenes=(), driving=Driving(leaps=beside.leaps, beats=beside.beats))
    meanings = {status.code: status.what for status in list_statuses(program)}
    return Job(
        program=program,
        system=system,
        start=start,
        scene=scene,
        formulation=formulation,
        y=(*start.q, *kept_velocities(system, planner.kept_forms(), start)),
        p=start.p,
        time=start.time,
        tolerance=float(scene.tolerance),
        columns=tuple(columns),
        checks=tuple(checks),
        meanings=meanings | ({TORN_HOLD: tell_torn(system)} if beside.calls else {}),
        watch=watched,
        structure=structure,
        holds=beside.calls,
        stops=find_stops(system, start.p, start.time),
        symbols=planner.y_nodes,
        kept=tuple(planner.kept_forms()),
        sketch=sketch,
        recipe=None if natural else recipe,
        jumping=find_jumping(planner),
    )


def _list_columns(planner: Planner, recipe: Recipe, scene: Scene) -> list[Column]:
    """What is needed, with friction's values in it, and nothing of the constraints that stand for friction."""
    columns = list_columns(planner, recipe.needs or tuple(need.name for need in scene.need))
    own = {reaction_name(name) for name in recipe.held.names}
    kept = [column for column in columns if column.heading not in own]
    more = {reaction_name(name): node for name, node in list_corrections(planner, recipe.held).items()}
    g = planner.graph
    nodes = [g.add(column.node, more[column.heading]) if column.heading in more else column.node for column in kept]
    nodes = put_values(planner, recipe.held, nodes)
    return [replace(column, node=node) for column, node in zip(kept, nodes, strict=True)]


def _list_checks(planner: Planner, recipe: Recipe) -> list[Column]:
    if not recipe.checks:
        return []
    return [column for column in list_checks(planner) if column.heading not in recipe.held.names]


def _exchanged(planner: Planner, recipe: Recipe, scene: Scene) -> list[Column]:
    """The needed columns where the coframe is solved with exchanges; none where it never is."""
    other = planner.exchanges
    if other is None:
        return []
    columns = _list_columns(other, recipe, scene)
    checks = _list_checks(other, recipe)
    return [*columns, *checks, *_drawn(planned_sketch(other) if recipe.draw else _NOTHING)]


def _drawn(sketch: Sketch) -> list[Column]:
    return [Column(f"drawn {k}", "drawn", node) for k, node in enumerate(sketch.nodes)]


@record
class _Beside:
    """What steps need beside the right-hand side: ``functions``, what they must not leap over, the clocks, and the ``calls`` that
    bring their ends back to the constraints.
    """

    functions: tuple[Function, ...]
    leaps: Leaps | None = None
    beats: Beats | None = None
    calls: tuple[tuple[str, ...], ...] = ()


def _beside_steps(planner: Planner, known: dict[Node, tuple[float, float]], hold: bool) -> _Beside:
    leaps, beats = find_leaps(planner, known), find_beats(planner)
    held, calls = hold_functions(planner) if hold else ((), ())
    own = [found.function for found in (leaps, beats) if found is not None]
    return _Beside((*own, *held), leaps, beats, calls)


def move_start(job: Job, start: Start) -> Job:
    """The same job from another start of its system; the job's state must be whole (``kept`` is not None)."""
    assert job.kept is not None
    y = (*start.q, *kept_velocities(job.system, job.kept, start))
    stops = job.stops if start.p == job.p and start.time == job.time else find_stops(job.system, start.p, start.time)
    return replace(job, start=start, scene=start.scene, y=y, p=start.p, time=start.time, stops=stops)
