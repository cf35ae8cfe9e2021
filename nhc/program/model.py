"""System, Formulation, Equations -> Program: names, units, defaults, scenes, and the functions."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.diagnostics import SpecError
from nhc.language.spec import Parameter, Scene
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.scenes import kept_velocities, start_of
from nhc.mechanics.system import System
from nhc.mechanics.values import parameter_value
from nhc.program.build import Planner, build_functions
from nhc.program.clock import find_stops
from nhc.program.hold import make_hold
from nhc.program.ir import Needed, Program, Quantity, SceneData
from nhc.program.leaps import find_leaps
from nhc.program.naming import identifier
from nhc.program.needed import list_columns, needed_function
from nhc.program.starting import warn_of_coframe
from nhc.program.watch import known_values, look_out


def build_program(
    system: System,
    formulation: Formulation,
    equations: Equations,
    only: Sequence[str] = (),
    scene: str = "",
    scenes: bool = True,
    driver: bool = False,
) -> Program:
    """The emitters' input; ``only`` names functions, ``scene`` keeps one scene (and its parameter values as defaults).

    Without ``scenes`` the starts of the spec's scenes are not computed: drivers need them.  With ``driver`` there is what a
    driver watches on its way, and what brings it back to the constraints.
    """
    planner = Planner(equations, formulation)
    spec = system.spec
    wanted = [s for s in spec.scenes if s.name == scene or (scenes and not scene)]
    starts = tuple(made for s in wanted if (made := _scene(system, planner, s, scene, driver)))
    chosen = next((s for s in starts if s.name == scene), None)
    return Program(
        system=spec.system,
        about=spec.about,
        source=spec.origin.path.rsplit("/", 1)[-1],
        formulation=formulation.name,
        equation=formulation.number,
        reason=formulation.reason,
        coordinates=tuple(Quantity(c.name, identifier(c.name), c.unit, c.about) for c in spec.coordinates),
        state=state_quantities(system, planner),
        parameters=tuple(
            Quantity(p.name, identifier(p.name), p.unit, p.about, _default(p, k, chosen))
            for k, p in enumerate(spec.parameters)
        ),
        constraints=tuple(Quantity(c.name, identifier(c.name)) for c in system.constraints),
        outputs=tuple(Quantity(name, identifier(name), system.units.get(name, "")) for name, _ in system.outputs),
        functions=build_functions(planner, only),
        scenes=starts,
        notes=_notes(formulation),
        warnings=warn_of_coframe(planner, wanted if scene else spec.scenes) if not only or "rhs" in only else (),
        lookout=look_out(planner, [start.p for start in starts]) if driver and starts else None,
        hold=make_hold(planner) if driver and starts else None,
        leaps=find_leaps(planner, known_values(system, [start.p for start in starts])) if driver and starts else None,
        needed=_needed(planner, starts) if driver else None,
    )


def state_quantities(system: System, planner: Planner) -> tuple[Quantity, ...]:
    """The full state: the coordinates, then the kept velocities."""
    coordinates = [Quantity(c.name, identifier(c.name), c.unit, c.about) for c in system.spec.coordinates]
    kept = [Quantity(name, identifier(name), system.units.get(name, "")) for name in planner.kept_names()]
    return (*coordinates, *kept)


def _default(parameter: Parameter, index: int, scene: SceneData | None) -> Fraction | float | None:
    if scene is not None:
        return scene.p[index]
    if parameter.value is None or isinstance(parameter.value, Fraction):
        return parameter.value
    return parameter_value(parameter.value)


def _scene(system: System, planner: Planner, scene: Scene, asked: str, driver: bool) -> SceneData | None:
    """The scene's start; a scene that cannot start is left out unless it was asked for by name."""
    try:
        start = start_of(system, scene)
    except SpecError:
        if asked == scene.name:
            raise
        return None
    y = (*start.q, *kept_velocities(system, planner.kept_forms(), start))
    need = tuple(entry.name for entry in scene.need)
    stops = find_stops(system, start.p, start.time) if driver else ()
    return SceneData(scene.name, scene.about, y, start.p, start.time, need, float(scene.tolerance), stops)


def _needed(planner: Planner, scenes: Sequence[SceneData]) -> Needed | None:
    """The quasi-velocities that scenes need and the state does not hold."""
    kept = {*planner.kept_names(), *(name for name, _ in planner.system.outputs)}
    wanted = dict.fromkeys(name for scene in scenes for name in scene.need)
    names = tuple(form.name for form in planner.system.quasi if form.name in wanted and form.name not in kept)
    return Needed(needed_function(planner, list_columns(planner, names)), names) if names else None


def _notes(formulation: Formulation) -> tuple[str, ...]:
    return tuple(
        f"hypothesis of I.3 that fails (the generalized equations are used): {text}" for text in formulation.broken
    )
