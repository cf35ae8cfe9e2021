"""``nhc reduce``: the smallest model that delivers what a scene needs, and why."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from nhc.cli.options import (
    formulation_option,
    json_option,
    need_option,
    scene_set_option,
    scene_time_option,
    spec_argument,
    verb,
)
from nhc.cli.simplify import approximate, check_options
from nhc.cli.specs import open_spec, take_first_scene
from nhc.cli.terminal import Exit, put_json, put_text

if TYPE_CHECKING:
    from nhc.program.scene_model import SceneModel, Tried
    from nhc.program.validation.validate import Kept


@verb(
    "reduce",
    "nhc reduce rolling_disk --scene lean",
    "nhc reduce rolling_disk --scene lean --set R=0.3 --fold",
    "nhc reduce pendulum --scene small --tol 1e-4 -o small.yaml",
)
@spec_argument
@click.option(
    "--scene",
    metavar="NAME",
    default="",
    help="The scene whose needs the model has to deliver; default: the first.",
)
@scene_set_option
@scene_time_option
@need_option("What the model has to deliver")
@formulation_option
@click.option("--fold", is_flag=True, help="Put the scene's parameter values in as numbers first.")
@click.option(
    "--tol",
    "tolerance",
    type=float,
    help="Leave out terms, parameters and coordinates too, while the relative error of what is needed stays below this; "
    "default: nothing is approximated.",
)
@click.option("-o", "output", metavar="FILE", help="With --tol: write the smallest model as a spec.")
@click.option("--chart", metavar="FILE", help="With --tol: draw size against error, .svg or .html.")
@click.option("--force", is_flag=True, help="Overwrite files that exist.")
@json_option
def command(
    spec: str,
    scene: str,
    values: tuple[str, ...],
    time: str,
    needs: tuple[str, ...],
    formulation: str | None,
    fold: bool,
    tolerance: float | None,
    output: str | None,
    chart: str | None,
    force: bool,
    as_json: bool,
) -> int:
    """Explain the smallest exact model of a scene.

    Says which entries of the state the scene's needs depend on, why the others are left out, which formulations were tried
    and what each would cost.  `nhc emit --scene` writes this model.  With `--tol` it looks for an approximate one in place of
    that: runs say which terms, parameters and coordinates can go, and `-o` writes what is left as a spec.
    """
    check_options(tolerance, output, chart, fold, as_json)
    source = open_spec(spec)
    scene = scene or take_first_scene(source, "to reduce the model to")
    from nhc.pipeline import Options, reduce_scene
    from nhc.simulate.changes import Changes

    changes = Changes(values, time, needs)
    options = Options(formulation=formulation or "", scene=scene, fold=fold, changes=changes)
    if tolerance is not None:
        return approximate(source, options, tolerance, output, chart, force, as_json)
    made = reduce_scene(source, options)
    from nhc.program.validation.scenes import validate_scene

    kept = validate_scene(made)
    if as_json:
        put_json("nhc.reduce/1", {**_data(made), "exact": kept, "changes": list(changes.notes)})
    else:
        _print(made, kept, changes.notes)
    return Exit.FAILED if False in kept.values() else Exit.DONE


def _data(made: SceneModel) -> dict[str, Any]:
    reduction = made.reduction
    return {
        "system": made.system.name,
        "scene": made.scene.name,
        "need": [column.name for column in reduction.outputs],
        "full": {"formulation": made.full_formulation, "state": made.full_state, "operations": made.full_operations},
        "reduced": {
            "formulation": reduction.formulation.name,
            "state": reduction.state,
            "operations": made.operations,
            "constants": [reduction.names[i] for i in reduction.constants],
        },
        "undecided": reduction.undecided,
        "left_out": [{"name": omission.name, "reason": omission.reason} for omission in reduction.left],
        "tried": [
            {
                "formulation": tried.formulation,
                "reason": tried.reason,
                "state": tried.state,
                "constants": tried.constants,
                "operations": tried.operations if not tried.rejected else None,
                "cost": tried.cost if not tried.rejected else None,
                "rejected": tried.rejected or None,
            }
            for tried in made.tried
        ],
        "chosen": made.chosen,
    }


def _print(made: SceneModel, kept: Kept, notes: tuple[str, ...]) -> None:
    reduction = made.reduction
    put_text(f"{made.system.name}, scene {made.scene.name}: needs {', '.join(c.name for c in reduction.outputs)}")
    for note in notes:
        put_text(note)
    put_text(f"full     {_size(made.full_state, made.full_operations)}, {made.full_formulation}")
    put_text(
        f"reduced  {_size(reduction.state, made.operations)}, {reduction.formulation.name}: {reduction.formulation.reason}"
    )
    if reduction.left:
        put_text("left out")
        width = max(len(omission.name) for omission in reduction.left)
        for omission in reduction.left:
            put_text(f"  {omission.name:{width}}  {omission.reason}")
    if reduction.undecided:
        put_text(
            "left out nothing: the equations are singular wherever they were tried, or with any values for what would go"
        )
    quadratures = [reduction.names[i] for i in reduction.kept if i not in reduction.driving]
    if quadratures and len(reduction.kept) > 1:
        put_text(f"by quadrature, nothing else depends on them: {', '.join(quadratures)}")
    for line in _verdicts(kept):
        put_text(line)
    put_text("tried (cost: operations, with weights for divisions, functions and entries of the state)")
    for k, tried in enumerate(made.tried):
        put_text(f"  {'*' if k == made.chosen else ' '} {_trial(tried)}")


def _verdicts(kept: Kept) -> list[str]:
    """Whether the functions of the model give what the full equations give."""
    from nhc.program.validation import UNDECIDED

    groups = {
        verdict: ", ".join(name for name, found in kept.items() if found is verdict) for verdict in (True, False, None)
    }
    words = {
        True: "exact at every state: {}",
        False: "NOT what the full equations give: {}, which is an error of nhc; use `nhc emit` without `--scene`",
        None: f"not decided ({UNDECIDED}): {{}}",
    }
    return [words[verdict].format(names) for verdict, names in groups.items() if names]


def _size(state: tuple[str, ...], operations: int) -> str:
    return f"{len(state)} equations ({', '.join(state)}), {operations} operations"


def _trial(tried: Tried) -> str:
    constants = f", constant {', '.join(tried.constants)}" if tried.constants else ""
    cost = tried.rejected or f"{tried.operations} operations, cost {tried.cost}"
    return f"{tried.formulation}: {len(tried.state)} ({', '.join(tried.state)}){constants}; {cost}; {tried.reason}"
