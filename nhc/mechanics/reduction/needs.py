"""What a scene needs, as columns of a trajectory."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.language.spec import Need, Scene, reaction_name
from nhc.mechanics.associate import Equations
from nhc.mechanics.formulate import reaction_values
from nhc.mechanics.frame import form_value
from nhc.mechanics.rotations.turning import moving
from nhc.records import record


@record
class Wanted:
    """A column of what a scene needs: its name in a trajectory, and its value over (q, w, t), rates and multipliers."""

    name: str
    node: Node
    unit: str = ""
    about: str = ""


def list_needs(equations: Equations, scene: Scene) -> list[Wanted]:
    """The columns of a trajectory of the scene, in the order of its ``need``."""
    columns = [column for need in scene.need for column in _columns(equations, need)]
    units = equations.system.units
    return [replace(column, unit=units.get(column.name, "")) for column in columns]


def _columns(equations: Equations, need: Need) -> list[Wanted]:
    system, g = equations.system, equations.system.graph
    on = moving(system, equations.motion.velocities)
    if need.kind == "coordinate":
        i = system.q_names.index(need.name)
        return [Wanted(need.name, system.q[i], about=system.spec.coordinates[i].about)]
    if need.kind == "velocity":
        return [Wanted(need.name, equations.motion.velocities[system.q_names.index(need.name.removesuffix("'"))])]
    if need.kind in ("reactions", "reaction"):
        values = equations.multipliers or reaction_values(equations)
        every = [Wanted(reaction_name(c.name), node) for c, node in zip(system.constraints, values, strict=True)]
        return [wanted for wanted in every if need.kind == "reactions" or wanted.name == need.name]
    if need.kind == "energy":
        node, about = system.energy, "T + V"
    elif need.kind == "quasi":
        node, about = form_value(system, next(f for f in system.quasi if f.name == need.name)), ""
    else:
        node, about = dict(system.outputs)[need.name], ""
    return [Wanted(need.name, substitute(g, [node], on)[0], about=about)]
