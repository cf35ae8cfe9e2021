"""From a spec's text to a scene that is ready to run."""

from __future__ import annotations

from dataclasses import replace

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.language.spec import Scene
from nhc.language.units.warnings import note_units
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.program.runs.starting import note_negative
from nhc.simulate.changes import UNCHANGED, Changes, changed
from nhc.simulate.edges import continue_beyond
from nhc.simulate.events import resolve_event
from nhc.simulate.methods import RUNGE_KUTTA, STRUCTURE
from nhc.simulate.methods.tableau import Collocation
from nhc.simulate.pacing import AUTO
from nhc.simulate.peers import SUNDIALS, WITH_JACOBIAN
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.project import projected_start
from nhc.simulate.reduced import prepare_reduced
from nhc.simulate.requests import RunError, find_need, find_scene


def open_scene(
    source: Source,
    scene: str = "",
    formulation: str = "",
    *,
    changes: Changes = UNCHANGED,
    needs: tuple[str, ...] = (),
    until: str = "",
    method: str = AUTO,
    hold: bool = True,
    project: bool = False,
    checks: bool = False,
    whole: bool = False,
    draw: bool = False,
    stay: bool = False,
    beside: tuple[Scene, ...] = (),
) -> Job:
    """The job of a scene (default: the first) in a formulation (default: the spec's, or the one that nhc chooses).

    ``changes``: other values and another time than it has; ``needs``: names of quantities (default: the
    scene's); ``until``: an expression in the spec's names whose zero ends the run; ``hold``: bring states back to the
    constraints; ``project``: replace a start that violates them by the nearest that does not; ``checks``: compute energy and
    residuals as well, with ``draw`` what the spec draws; ``whole``: keep states that this start alone does not need; ``stay``:
    keep to the formulation where it becomes singular (an ensemble, which is whole, always does); ``beside``: scenes that the
    spec does not have, whose values of the parameters the job must be right for, too.

    Raises:
        nhc.diagnostics.SpecError: the spec or the expression has errors.
        RunError: no such scene or quantity.
    """
    spec = decode(source, until)
    spec, chosen = changed(spec, find_scene(spec, scene), changes)
    wanted = tuple(dict.fromkeys(find_need(spec, need) for need in needs))
    spec = replace(spec, scenes=(*spec.scenes, *beside))
    if until and (method in STRUCTURE or method in SUNDIALS):
        raise RunError(f"the method `{method}` does not look for events", ("take dop853 with `--until`",))
    system, event = resolve_event(spec, until) if until else (resolve(spec), None)
    natural = method in STRUCTURE
    unheard = _tell_unheard(method, formulation) if natural and system.constraints else ()
    if natural and system.constraints and not formulation:
        formulation = "multipliers"  # its state has all velocities: these methods need not keep them on the constraints
    form = formulate(system, formulation)
    equations = equations_of(system, form)
    start, notes = projected_start(system, chosen) if project else (start_of(system, chosen), ())
    ending = None if event is None else continue_beyond(system.graph, event, start.values(system), intervals(system))
    implicit = method in WITH_JACOBIAN or isinstance(RUNGE_KUTTA.get(method), Collocation)
    plain = not (wanted or until or natural or checks or whole or draw)  # else more is asked than the scene needs
    weak = (method in RUNGE_KUTTA or method == AUTO) and not (stay or whole)
    told = " ".join(until.split())
    recipe = Recipe(equations, wanted, ending, implicit, hold, checks, draw, weak, told, fixed=not beside)
    job = prepare_reduced(recipe, form, start) if plain else None
    job = job or prepare(recipe, form, start, natural=natural)
    doubtful = (*note_units(spec, chosen, source), *note_negative(equations, form, start))
    job = replace(job, notes=(*notes, *unheard, *doubtful))
    lacking = job.structure.lacking
    if natural and not lacking and STRUCTURE[method].constant_mass and not job.structure.constant_mass:
        lacking = "its mass matrix is not constant"
    if natural and lacking:
        raise RunError(f"the method `{method}` does not fit this system: {lacking}", ("take dop853 or midpoint",))
    return job


def _tell_unheard(method: str, formulation: str) -> tuple[str, ...]:
    """A note where a method steps all velocities, and others are asked for."""
    note = f"`{method}` keeps all velocities, as multipliers do: `--formulation {formulation}` is not what it steps"
    return () if formulation in ("", "multipliers") else (note,)
