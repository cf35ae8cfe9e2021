"""What a run may be asked for: a scene of the spec, and quantities by name."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.diagnostics import Span, suggest
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


def list_needs(spec: Spec) -> tuple[str, ...]:
    """Everything that a run can be asked for, each name once: an output may be called `energy`."""
    names = (
        *(c.name for c in spec.coordinates),
        *(f"{c.name}'" for c in spec.coordinates),
        *(q.name for q in spec.quasi_velocities),
        *(o.name for o in spec.outputs),
        "energy",
        *(("reactions",) if spec.constraints or spec.holonomic or spec.rotations else ()),
        *(reaction_name(constraint.name) for constraint in spec.constraints),
        *(reaction_name(equation.name) for equation in spec.holonomic),
    )
    return tuple(dict.fromkeys(names))


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
    hint = advise_need(name) if shown else suggest(name, known, f"it can be {', '.join(known)}")
    raise RunError(f"`--need` names `{text}`, which is no quantity of this spec", (hint,))


def list_wanted(spec: Spec, texts: Iterable[str]) -> tuple[Need, ...]:
    """What these names mean, as a scene needs it; what is named twice counts once.

    Raises:
        RunError: one is no quantity of the spec.
    """
    constraints = [one.name for one in spec.constraints] + [one.name for one in spec.holonomic]
    kinds = {reaction_name(name): "reaction" for name in constraints}
    kinds |= {f"{c.name}'": "velocity" for c in spec.coordinates} | {"energy": "energy", "reactions": "reactions"}
    kinds |= {c.name: "coordinate" for c in spec.coordinates} | {q.name: "quasi" for q in spec.quasi_velocities}
    kinds |= {o.name: "output" for o in spec.outputs}  # which may have the names of what nhc knows by itself
    names = dict.fromkeys(find_need(spec, text) for text in texts)
    whole = "reactions" in names  # the single ones among them
    return tuple(Need(kinds[x], x, Span(0, 0)) for x in names if not whole or kinds[x] != "reaction")
