"""System, Formulation, Equations -> Program: names, units, defaults, scenes, and the functions."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.diagnostics import SpecError
from nhc.language.spec import Parameter, Scene, reaction_name
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.starts.scenes import kept_velocities, start_of
from nhc.mechanics.system import System
from nhc.mechanics.values import parameter_value
from nhc.program.build import build_functions
from nhc.program.ir import NO_DRIVING, Program, Quantity, SceneData, Stop
from nhc.program.planning.planner import Planner
from nhc.program.runs.starting import warn_of_coframe


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
    starts, refused = _scenes(system, planner, wanted, scene, driver)
    chosen = next((s for s in starts if s.name == scene), None)
    driving = NO_DRIVING
    if driver:
        from nhc.program.runs.driving import make_driving  # here, for what drivers need takes a fifth of all imports

        driving = make_driving(planner, starts)
    return Program(
        system=spec.system,
        about=spec.about,
        formulation=formulation.name,
        equation=formulation.number,
        reason=formulation.reason,
        coordinates=tuple(Quantity(c.name, c.unit, c.about) for c in spec.coordinates),
        state=planner.state_quantities(),
        parameters=tuple(
            Quantity(p.name, p.unit, p.about, _default(p, k, chosen)) for k, p in enumerate(spec.parameters)
        ),
        constraints=tuple(
            Quantity(c.name, unit=system.units.get(reaction_name(c.name), "")) for c in system.constraints
        ),
        outputs=tuple(Quantity(name, system.units.get(name, "")) for name, _ in system.outputs),
        functions=build_functions(planner, only),
        scenes=starts,
        notes=_notes(formulation),
        warnings=(*refused, *_warnings(planner, wanted if scene else spec.scenes, only)),
        driving=driving,
    )


def _default(parameter: Parameter, index: int, scene: SceneData | None) -> Fraction | float | None:
    if scene is not None:
        return scene.p[index]
    if parameter.value is None or isinstance(parameter.value, Fraction):
        return parameter.value
    return parameter_value(parameter.value)


def _warnings(planner: Planner, scenes: Sequence[Scene], only: Sequence[str]) -> tuple[str, ...]:
    return warn_of_coframe(planner, scenes) if not only or "rhs" in only else ()


def _scenes(
    system: System, planner: Planner, wanted: Sequence[Scene], asked: str, driver: bool
) -> tuple[tuple[SceneData, ...], tuple[str, ...]]:
    """The starts of the scenes, and what a driver leaves out, since it cannot start.

    Raises:
        SpecError: a scene that was asked for by name cannot start, or none of a driver's.
    """
    starts, refused, first = list[SceneData](), list[str](), None
    for scene in wanted:
        try:
            starts.append(_scene(system, planner, scene, driver))
        except SpecError as error:
            if asked == scene.name:
                raise
            first = first or error
            refused.append(f"the scene `{scene.name}` is left out of the driver: {error.diagnostics[0].message}")
    if driver and first is not None and not starts:
        raise first
    return tuple(starts), tuple(refused) if driver else ()


def _scene(system: System, planner: Planner, scene: Scene, driver: bool) -> SceneData:
    """The scene's start.

    Raises:
        SpecError: it cannot start.
    """
    start = start_of(system, scene)
    y = (*start.q, *kept_velocities(system, planner.kept_forms(), start))
    need = tuple(entry.name for entry in scene.need)
    stops: tuple[Stop, ...] = ()
    if driver:
        from nhc.program.runs.driving import stops_of

        stops = stops_of(system, start)
    return SceneData(scene.name, scene.about, y, start.p, start.time, need, float(scene.tolerance), stops)


def _notes(formulation: Formulation) -> tuple[str, ...]:
    return tuple(
        f"hypothesis of I.3 that fails (the generalized equations are used): {text}" for text in formulation.broken
    )
