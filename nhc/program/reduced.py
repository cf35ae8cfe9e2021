"""The program of a scene: the smallest model that delivers what the scene needs (:mod:`nhc.mechanics.reduction.reduce`)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.mechanics.reduction.reduce import keep_everything
from nhc.mechanics.starts.scenes import Start, kept_velocities
from nhc.program.build import build_function
from nhc.program.ir import NO_DRIVING, Driving, Function, Program, Quantity, SceneData
from nhc.program.model import build_program
from nhc.program.planning.scene import ScenePlanner
from nhc.program.runs.beats import find_beats
from nhc.program.runs.clock import find_stops
from nhc.program.runs.hold import make_hold, must_hold
from nhc.program.runs.leaps import find_leaps
from nhc.program.runs.starting import warn_of_coframe
from nhc.program.runs.watch import known_values, look_out
from nhc.program.scene_model import SceneModel

SCENE_FUNCTIONS = ("rhs", "state", "jacobian", "outputs")


def build_scene_program(
    model: SceneModel, only: Sequence[str] = (), driver: bool = False, notes: Sequence[str] = ()
) -> Program:
    """The program of a scene: its state, its constants after the spec's parameters, and its needs as the outputs.

    A ``driver`` that must bring its state back to the constraints needs all of it: then nothing is left out.  ``notes``: lines for
    the heads of files, before those of the model.
    """
    held = driver and must_hold(model.reduction.equations)
    if held:
        model = keep_all(model)
    system, made, planner = model.system, model.reduction, model.planner
    everything = (*model.start.q, *kept_velocities(system, planner.kept_forms(), model.start))
    constants = planner.list_constants(model.start)
    columns = made.outputs
    full = build_program(system, made.formulation, made.equations, only=("none",), scene=model.scene.name)
    data = SceneData(
        model.scene.name,
        model.scene.about,
        tuple(everything[i] for i in made.kept),
        (*model.start.p, *(float(quantity.default or 0.0) for quantity in constants)),
        model.start.time,
        tuple(column.name for column in columns),
        float(model.scene.tolerance),
        find_stops(system, model.start.p, model.start.time) if driver else (),
    )
    quantities = planner.state_quantities()
    return replace(
        full,
        state=tuple(quantities[i] for i in made.kept),
        parameters=(*full.parameters, *constants),
        outputs=tuple(Quantity(c.name, c.unit, c.about) for c in columns),
        functions=build_scene_functions(planner, only),
        scenes=(data,),
        notes=(*full.notes, *notes, *_notes(model)),
        warnings=warn_of_coframe(planner, (model.scene,)),
        driving=_make_driving(planner, model.start, held) if driver else NO_DRIVING,
    )


def _make_driving(planner: ScenePlanner, start: Start, held: bool) -> Driving:
    """What a driver of the scene needs; ``held``: its state is brought back to the constraints."""
    return Driving(
        lookout=look_out(planner, [start.p], [start.values(planner.system)]),
        hold=make_hold(planner) if held else None,
        leaps=find_leaps(planner, known_values(planner.system, [start.p])),
        beats=find_beats(planner),
    )


def keep_all(model: SceneModel) -> SceneModel:
    """The same formulation with its whole state; parameters whose values were put in stay so."""
    made, parameters = model.reduction, set(model.system.p)
    folded = tuple((symbol, value) for symbol, value in made.fixed if symbol in parameters)
    whole = replace(keep_everything(made.equations, made.formulation, model.scene), fixed=folded)
    return replace(model, reduction=whole, planner=ScenePlanner(made.equations, made.formulation, reduction=whole))


def build_scene_functions(planner: ScenePlanner, only: Sequence[str]) -> tuple[Function, ...]:
    """The functions asked for; all of them where none is named, or one that a scene's model does not have."""
    known = all(name in SCENE_FUNCTIONS for name in only)  # what is asked for and not there is the emitter's to refuse
    wanted = [name for name in SCENE_FUNCTIONS if not only or not known or name in only]
    return tuple(build_function(planner, getattr(planner, name)()) for name in wanted)


def _notes(model: SceneModel) -> list[str]:
    before, after = len(model.full_state), len(model.reduction.kept)
    needs = ", ".join(column.name for column in model.reduction.outputs)
    lines = [f"reduced for the scene {model.scene.name}, which needs {needs}: {after} of {before} states"]
    lines += ["the parameters' values of the scene are put in: the functions do not read them"] if model.folded else []
    lines += [f"left out: {omission.name}: {omission.reason}" for omission in model.reduction.left]
    return lines
