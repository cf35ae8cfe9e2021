"""The steady motion that a scene belongs to, its eigenvalues, and their change over a parameter.

Hidden holonomic constraints are held at what the start makes of them: a bicycle stays on its ground.  Where the search does
not end from the start it is tried from places along the scene.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.carry import carry
from nhc.algebra.graph import Node
from nhc.language.spec import Scene
from nhc.mechanics.about import scene_about, state_of
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.flow import Flow
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import kept_forms
from nhc.mechanics.linearize import reduced
from nhc.mechanics.starts.scenes import Start, kept_velocities, start_of
from nhc.mechanics.system import System
from nhc.records import record
from nhc.study.linearization.absent import BEST, Left, Worth, ask_without_zeros, leave_zeros_out
from nhc.study.linearization.asked import find_asked, has_halted, is_missed, keep_ranges, list_lost
from nhc.study.linearization.coframes import by_multipliers, elsewhere
from nhc.study.linearization.field import SINGULAR, Hold, SteadyModel
from nhc.study.linearization.found import Locked, NotSteady, Steady, check_smooth
from nhc.study.linearization.leaf import held_on_leaf
from nhc.study.linearization.linearize import Linearisation, count_zeros, linearise_at
from nhc.study.linearization.motion import read_holds, steady_model, sweep_along
from nhc.study.linearization.steady import find_motion, find_steady
from nhc.study.linearization.sweep import Sweep

SweepRange = tuple[str, float, float, int]


@record
class Motion:
    """``place`` says from where it was found; ``swept`` is None where nothing was asked, ``along`` names what was varied.

    ``regularity`` in [0, 1]: of the mass matrix there, and of what inertia is left; below ``SINGULAR`` the coordinates
    themselves fail (gimbal lock) and the eigenvalues say nothing of the motion.  ``absent``: parameters that are 0 and were left
    out of the equations.  ``lost``: what has become of each velocity that was asked for and has gone; ``halted``: with most
    of the motion; ``missed``: one of them had much of it.
    """

    formulation: Formulation
    model: SteadyModel
    linearisation: Linearisation
    swept: Sweep | None
    place: str
    regularity: float
    along: str = ""
    absent: tuple[str, ...] = ()
    lost: tuple[str, ...] = ()
    halted: bool = False
    missed: bool = False

    @property
    def flow(self) -> Flow:
        return self.model.flow


@record
class Search:
    """``about``, ``settings``, ``holds``: as for ``nhc linearize``; ``hidden``: integrals of the constraints over q."""

    about: str
    settings: tuple[str, ...] = ()
    holds: tuple[str, ...] = ()
    sweep: SweepRange | None = None
    hidden: tuple[tuple[str, Node], ...] = ()


def steady_motion(
    equations: Equations, formulation: Formulation, search: Search, beside: Sequence[tuple[float, Start]] = ()
) -> Motion:
    """The steady motion near a start, or near one of the starts ``beside`` it (with their times); as ``nhc linearize`` has it.

    Raises:
        nhc.diagnostics.SpecError: unknown names.
        NotSteady: none is found, or the sweep leaves its branch.
    """
    system = equations.system
    scene = scene_about(system.spec, search.about, search.settings)
    start = start_of(system, scene)
    found: Motion | NotSteady
    try:
        found = _anywhere(equations, formulation, search, scene, start, beside)
    except NotSteady as error:
        found = error
    worth = None if isinstance(found, NotSteady) else _weigh(found)
    if worth != BEST:
        other = ask_without_zeros(
            leave_zeros_out(system, start, search.sweep[0] if search.sweep else "", formulation.name),
            lambda left: _anywhere(
                left.equations, left.formulation, _carried(search, system, left), scene, start, beside
            ),
            _weigh,
            worth,
            None if isinstance(found, NotSteady) else found.model,
        )
        if other is not None:
            return replace(other[0], absent=other[1])
    if isinstance(found, NotSteady):
        raise found
    return found


def _carried(search: Search, system: System, left: Left) -> Search:
    """The search with its integrals on the other equations' graph."""
    own = left.equations.system
    meaning = dict(zip((*system.q, *system.p, system.t), (*own.q, *own.p, own.t), strict=True))
    nodes = carry(system.graph, own.graph, [node for _, node in search.hidden], meaning)
    return replace(search, hidden=tuple(zip((name for name, _ in search.hidden), nodes, strict=True)))


def _weigh(found: Motion) -> Worth:
    """How many of the velocities that the scene gives have gone, and how many zeros are none of a family."""
    return len(found.lost), count_zeros(found.linearisation)


def _anywhere(
    equations: Equations,
    formulation: Formulation,
    search: Search,
    scene: Scene,
    start: Start,
    beside: Sequence[tuple[float, Start]],
) -> Motion:
    """The steady motion in this formulation, or in others where this one is singular."""
    system = equations.system
    better = reduced(system, formulation)
    own = equations if better is formulation else equations_of(system, better)

    def study(system: System, other: Formulation) -> Motion:
        return _motion(equations_of(system, other), other, search, scene, start, beside)

    def keeps(made: Motion) -> bool:
        return not made.lost

    try:
        found = _motion(own, better, search, scene, start, beside)
    except NotSteady as error:
        return elsewhere(system, error, start, study, lambda made: (made.model, made.linearisation.steady), keeps)
    return (by_multipliers(system, start, study, keeps) or found) if found.missed else found


def _motion(
    equations: Equations,
    better: Formulation,
    search: Search,
    scene: Scene,
    start: Start,
    beside: Sequence[tuple[float, Start]],
) -> Motion:
    model = steady_model(equations, better, start.p)
    guess = state_of(model.flow, better.frame, start)
    model = held_on_leaf(model, guess, search.hidden)
    holds = tuple(hold for text in search.holds for hold in read_holds(model, text, guess))
    steady, place, regularity = _find(model, scene, guess, holds, beside)
    if regularity > SINGULAR:
        check_smooth(model, steady)
    made = linearise_at(model, steady)
    swept, name = None, ""
    if search.sweep is not None:
        name = _spelled(model.flow, search.sweep[0])
        swept = sweep_along(model, scene, guess, steady.y, holds, (name, *search.sweep[1:]))
    lost = list_lost(model, scene, guess, steady.y)
    halted = bool(lost) and has_halted(model, guess, steady.y)
    missed = bool(lost) and is_missed(model, scene, guess, steady.y)
    return Motion(better, model, made, swept, place, regularity, name, lost=lost, halted=halted, missed=missed)


def _spelled(flow: Flow, name: str) -> str:
    """``v`` is the output ``speed`` where nothing else is called so."""
    known = {*flow.names, *(p.name for p in flow.system.spec.parameters), *(o for o, _ in flow.system.outputs)}
    known.update(form.name for form in flow.system.quasi)
    return "speed" if name == "v" and "v" not in known and "speed" in known else name


def _find(
    model: SteadyModel,
    scene: Scene,
    guess: Sequence[float],
    holds: tuple[Hold, ...],
    beside: Sequence[tuple[float, Start]],
) -> tuple[Steady, str, float]:
    """The steady motion, from where it was found, and how regular the coordinates are there."""
    begun = tuple(guess)
    guesses = [("the start", begun)]
    forms = kept_forms(model.flow.system, model.frame)
    for t, start in beside:
        guesses.append((f"the scene at t = {t:.6g}", (*start.q, *kept_velocities(model.flow.system, forms, start))))
    first: NotSteady | None = None
    searches = [(place, y, find_steady) for place, y in guesses]
    for place, y, search in (*searches, (*guesses[0], find_motion)):  # at rest where nothing else is found
        try:
            if y is begun:  # what was asked for is a start, not what a scene comes to later
                found = find_asked(model, scene, y, holds, search)
            else:
                found = keep_ranges(model, y, search(model, y, holds), holds)
            return found, place, model.regularity(found.y)
        except Locked as error:
            return error.steady, place, error.regularity
        except NotSteady as error:
            first = first or error
    assert first is not None
    raise first
