"""What a driver needs beside the functions of a model: what it watches and keeps on its way, and what its scenes ask for.

A module of its own, for only drivers import it: it knows all of what may happen to a motion.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Node
from nhc.mechanics.starts.scenes import Start
from nhc.mechanics.system import System
from nhc.program.ir import NO_DRIVING, Driving, Needed, SceneData, Stop
from nhc.program.planning.planner import Planner
from nhc.program.runs.beats import find_beats
from nhc.program.runs.clock import find_stops
from nhc.program.runs.hold import make_hold
from nhc.program.runs.leaps import find_leaps
from nhc.program.runs.needed import list_columns, needed_function
from nhc.program.runs.watch import known_values, look_out


def make_driving(planner: Planner, scenes: Sequence[SceneData]) -> Driving:
    """The parts for a driver of these scenes."""
    if not scenes:
        return NO_DRIVING
    parameters = [scene.p for scene in scenes]
    return Driving(
        lookout=look_out(planner, parameters, [_values(planner.system, scene) for scene in scenes]),
        hold=make_hold(planner),
        leaps=find_leaps(planner, known_values(planner.system, parameters)),
        beats=find_beats(planner),
        needed=_needed(planner, scenes),
    )


def _values(system: System, scene: SceneData) -> dict[Node, float]:
    """Those of t, q and p at a scene's start."""
    known = zip((system.t, *system.q, *system.p), (scene.time[0], *scene.y[: system.n], *scene.p), strict=True)
    return dict(known)


def stops_of(system: System, start: Start) -> tuple[Stop, ...]:
    """Where a driver stops on its way from a start."""
    return find_stops(system, start.p, start.time)


def _needed(planner: Planner, scenes: Sequence[SceneData]) -> Needed | None:
    """The quasi-velocities that scenes need and the state does not hold."""
    kept = {*planner.kept_names(), *(name for name, _ in planner.system.outputs)}
    wanted = dict.fromkeys(name for scene in scenes for name in scene.need)
    names = tuple(form.name for form in planner.system.quasi if form.name in wanted and form.name not in kept)
    if not names:
        return None
    others = list_columns(planner.exchanges, names) if planner.exchanges else ()
    return Needed(needed_function(planner, list_columns(planner, names), others), names)
