"""What a run may be asked for: a scene of the spec, and quantities by name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.diagnostics import suggest
from nhc.language import Spec
from nhc.language.advice import advise_need
from nhc.language.expressions.names import ENERGIES, fold_typed
from nhc.language.spec import Need, Scene, reaction_name
from nhc.mechanics.starts.scenes import check_scene_name


class RunError(Exception):
    """What was asked does not fit the spec; ``help`` says what would."""

    def __init__(self, message: str, help: tuple[str, ...]) -> None:
        super().__init__(message)
        self.help = help


def find_scene(spec: Spec, name: str) -> Scene:
    """The scene of that name, or the first one.

    Raises:
        nhc.diagnostics.SpecError: the spec has scenes, and none of that name.
        RunError: it has none at all.
    """
    if not spec.scenes:
        advice = ("add one under `scenes:`, with `initial:` and `time: [start, end]`",)
        raise RunError("this spec has no scene to run", advice)
    if not name:
        return spec.scenes[0]
    check_scene_name(spec, name)
    return next(scene for scene in spec.scenes if scene.name == name)


def list_needs(spec: Spec) -> dict[str, str]:
    """Everything that a run can be asked for, with its kind as a scene needs it; an output may be called `energy`."""
    found = {c.name: "coordinate" for c in spec.coordinates} | {f"{c.name}'": "velocity" for c in spec.coordinates}
    found |= {q.name: "quasi" for q in spec.quasi_velocities} | {o.name: "output" for o in spec.outputs}
    own = {"energy": "energy"}
    if spec.constraints or spec.holonomic or spec.rotations:
        own["reactions"] = "reactions"
    own |= {reaction_name(constraint.name): "reaction" for constraint in spec.constraints}
    own |= {reaction_name(equation.name): "reaction" for equation in spec.holonomic}
    return found | {name: kind for name, kind in own.items() if name not in found}


def find_need(spec: Spec, text: str) -> str:
    """The needed name that a text means; ``xdot`` is ``x'`` while nothing else has that name."""
    name, known = fold_typed(text), list_needs(spec)
    if name in known:
        return name
    if name.endswith("dot") and f"{name[:-3]}'" in known:
        return f"{name[:-3]}'"
    if name == "reactions":
        raise RunError("there are no reactions: this spec has no constraint", ("leave `reactions` out",))
    if name == "t":
        raise RunError("the time needs not be asked for: it is the first column", ("leave `t` out",))
    shown = name in (*ENERGIES, *(d.name for d in spec.definitions))
    hint = advise_need(name) if shown else suggest(name, [*known], f"it can be {', '.join(known)}")
    raise RunError(f"`--need` names `{text}`, which is no quantity of this spec", (hint,))


def scene_of_needs(spec: Spec, scene: Scene, texts: Sequence[str]) -> Scene:
    """The scene with other needs, each once; itself where none are named.

    Raises:
        RunError: one is no quantity of the spec.
    """
    if not texts:
        return scene
    kinds, names = list_needs(spec), dict.fromkeys(find_need(spec, text) for text in texts)
    if "reactions" in names:  # the single ones are among them
        names = {name: None for name in names if kinds[name] != "reaction"}
    return replace(scene, need=tuple(Need(kinds[name], name, scene.span) for name in names))
