"""What a run needs beside the right-hand side: one function for all wanted quantities (:mod:`nhc.program.runs.watch` has another).

``needed`` takes the state to the columns of a trajectory; it does not mind whether a quantity belongs to the
formulation's state, for everything is an expression in (t, y, p).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.exact.modular import Unlucky
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.shorten import shorten
from nhc.language.spec import reaction_name
from nhc.mechanics.dependence import find_dependence
from nhc.mechanics.flow import flow_of
from nhc.mechanics.formulate import reaction_values
from nhc.mechanics.frame import form_value
from nhc.mechanics.resolving.drawing import Sketch, sketch_of
from nhc.mechanics.rotations.turning import moving
from nhc.program.ir import Function
from nhc.program.planning.planner import Planner
from nhc.program.planning.scene import ScenePlanner
from nhc.records import record


@record
class Column:
    """``heading`` as a CSV has it; ``group`` is need, energy, kinetic, residual or position; ``unit`` where it is known."""

    heading: str
    group: str
    node: Node
    unit: str = ""


def list_columns(planner: Planner, needs: Sequence[str]) -> list[Column]:
    """The columns behind names of coordinates, velocities, quasi-velocities, outputs, ``energy``, ``reactions`` and single ones.

    Raises:
        KeyError: a name that the spec does not have.
    """
    system = planner.system
    units = system.units
    named: dict[str, Node] = dict(zip(system.q_names, system.q, strict=True))
    moving: dict[str, Node] = {f"{name}'": v for name, v in zip(system.q_names, system.v, strict=True)}
    moving.update((form.name, form_value(system, form)) for form in system.quasi)
    moving.update(system.outputs)
    if "energy" not in named:  # a coordinate may have this name, too
        moving.setdefault("energy", system.energy)
    wanted = [name for name in needs if name in moving]
    named.update(zip(wanted, planner.on_motion([moving[name] for name in wanted]), strict=True))
    reactions = [reaction_name(form.name) for form in system.constraints]
    if any(need not in named for need in needs):  # they take a sweep
        named.update(zip(reactions, reactions_of(planner), strict=True))
    lists = [reactions if need == "reactions" and need not in named else [need] for need in needs]
    names = dict.fromkeys(name for several in lists for name in several)
    return [Column(name, "need", named[name], units.get(name, "")) for name in names]


def reactions_of(planner: Planner) -> list[Node]:
    """lambda_a in terms of the state and of the unknowns of the planner's solves."""
    if planner.equations.multipliers:
        return list(planner.equations.multipliers)
    return shorten(planner.graph, planner.known(reaction_values(planner.equations)))


def list_checks(planner: Planner) -> list[Column]:
    """The energy, the constraints' left sides, and the holonomic ones at position level."""
    system = planner.system
    forms = [form_value(system, form) for form in system.constraints]
    energy, kinetic, *residuals = planner.on_motion([system.energy, system.T, *forms])
    found = [Column("energy", "energy", energy), Column("T", "kinetic", kinetic)]
    found += [Column(f.name, "residual", r) for f, r in zip(system.constraints, residuals, strict=True)]
    found += [Column(f.name, "position", f.equation) for f in system.constraints if f.equation is not None]
    return found


def list_energy(planner: ScenePlanner) -> list[Column]:
    """T + V and T of a scene's model; nothing where they depend on what the model leaves out."""
    system, made, g = planner.system, planner.reduction, planner.graph
    on = moving(system, planner.original.motion.velocities)
    nodes = substitute(g, [system.energy, system.T], on)
    held = {*made.kept, *made.constants, *(integral.index for integral in made.integrals)}
    try:
        dependence = find_dependence(flow_of(planner.original), nodes)
    except Unlucky:
        return []
    if any(entries - held for entries in dependence.needs):
        return []
    energy, kinetic = planner.fix(nodes)
    return [Column("energy", "energy", energy), Column("T", "kinetic", kinetic)]


def planned_sketch(planner: Planner) -> Sketch:
    """What the spec draws, in terms of the state."""
    sketch = sketch_of(planner.system)
    return replace(sketch, nodes=tuple(planner.on_motion(sketch.nodes)))


def needed_function(planner: Planner, columns: Sequence[Column], others: Sequence[Column] = ()) -> Function:
    """out[k] is column k; ``others`` are the same columns of the planner's exchanges."""
    nodes = [column.node for column in columns]
    names = [column.heading for column in columns]
    solves = planner.graph.mask([s for plan in planner.solves for column in plan.symbols for s in column])
    dense = any(planner.graph.depends(node, solves) for node in nodes) if planner.solves else False
    guards = planner.frame_guards() if others else planner.last_guards()
    guards += planner.mass_guards if "lambda" in " ".join(names) else ()
    about = "what the run needs, in the order of its columns"
    made = planner.lower_out("needed", about, nodes, names, guards, planner.solves if dense else ())
    if not others or planner.exchanges is None:
        return made
    return replace(
        made, otherwise=planner.exchanges.lower_out("needed", about, [column.node for column in others], names)
    )
