"""The job of a scene on the smallest state that its needs depend on."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.walks import count
from nhc.emit.statements import list_statuses
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.regular.given_rank import find_dependent_row
from nhc.mechanics.starts.massless import is_massless
from nhc.mechanics.starts.scenes import Start, kept_velocities
from nhc.program.ir import Driving
from nhc.program.model import build_program
from nhc.program.planning.exchanges import ExchangePlanner
from nhc.program.planning.scene import ScenePlanner
from nhc.program.reduced import build_scene_functions
from nhc.program.runs.beats import find_beats
from nhc.program.runs.clock import find_stops
from nhc.program.runs.leaps import find_leaps
from nhc.program.runs.needed import Column, list_energy, needed_function
from nhc.program.runs.structure import Structure
from nhc.program.runs.watch import watch_function
from nhc.program.scene_model import reduce_one
from nhc.simulate.prepare import Job, Recipe
from nhc.simulate.stepping_over import find_jumping

_LARGE = 5000
"""Operations beyond which looking for what can be left out takes longer than it saves in a run."""


def prepare_reduced(recipe: Recipe, formulation: Formulation, start: Start) -> Job | None:
    """The job of a scene's own needs in this formulation; None where the whole state is needed, or the system is too large."""
    equations = recipe.equations
    system, g = equations.system, equations.system.graph
    if count(g, [*equations.force, *equations.motion.velocities]) > _LARGE:
        return None
    lengths = len(system.rotations)
    if equations.multipliers or sum(form.equation is not None for form in system.constraints) > lengths:
        return None  # a run holds the state on these constraints, and needs all of it
    if is_massless(equations, formulation.frame, start) or find_dependent_row(system, start.values(system)) is not None:
        return None  # what a scene needs may not feel it: the whole model says that nothing is determined
    planner = reduce_one(equations, formulation, start)
    turned = {place for rotation in system.rotations for place in rotation.places}
    if not planner.reduction.left or turned & {*planner.reduction.kept, *planner.reduction.constants}:
        return None
    return replace(job_of(planner, start, recipe.jacobian, weak=recipe.weak), recipe=recipe)


def _exchanged(planner: ScenePlanner) -> list[Column]:
    """The needed columns where the coframe is solved with exchanges; none where it never is."""
    other, wanted = planner.exchanges, planner.reduction.outputs
    if not isinstance(other, ExchangePlanner):
        return []
    nodes = other.needed_nodes([column.name for column in wanted])
    return [Column(column.name, "need", node) for column, node in zip(wanted, nodes, strict=True)]


def job_of(planner: ScenePlanner, start: Start, jacobian: bool, energy: bool = False, weak: bool = False) -> Job:
    """The job of a reduction; ``energy``: with T + V and T as checks, where what is kept determines them."""
    system, made, equations = planner.system, planner.reduction, planner.original
    values = (*start.q, *kept_velocities(system, planner.kept_forms(), start))
    columns = [
        Column(wanted.name, "need", node, wanted.unit)
        for wanted, node in zip(made.outputs, planner.needed_nodes(), strict=True)
    ]
    checks = list_energy(planner) if energy else []
    known = {x: (v, v) for x, v in zip(system.p, start.p, strict=True)}
    watch, watched = watch_function(planner, None, weak, known, [start.values(system)])
    leaps, beats = find_leaps(planner, known), find_beats(planner)
    functions = build_scene_functions(planner, ("rhs", "jacobian") if jacobian else ("rhs",))
    functions += (
        needed_function(planner, [*columns, *checks], _exchanged(planner) if not checks else ()),
        *(() if watch is None else (watch,)),
        *(() if leaps is None else (leaps.function,)),
        *(() if beats is None else (beats.function,)),
    )
    whole = planner.state_quantities()
    constants = planner.list_constants(start)
    frame = build_program(system, made.formulation, equations, only=("residuals",), scenes=False)
    program = replace(
        frame,
        functions=functions,
        scenes=(),
        driving=Driving(leaps=leaps, beats=beats),
        state=tuple(whole[i] for i in made.kept),
        parameters=(*frame.parameters, *constants),
    )
    return Job(
        program=program,
        system=system,
        start=start,
        scene=start.scene,
        formulation=made.formulation,
        y=tuple(values[i] for i in made.kept),
        p=(*start.p, *(float(quantity.default or 0.0) for quantity in constants)),
        time=start.time,
        tolerance=float(start.scene.tolerance),
        columns=tuple(columns),
        checks=tuple(checks),
        meanings={status.code: status.what for status in list_statuses(program)},
        watch=watched,
        structure=Structure(),
        holds=(),
        stops=find_stops(system, start.p, start.time),
        symbols=planner.y_nodes,
        constants=planner.parameters[len(system.p) :],
        jumping=find_jumping(planner),
    )
