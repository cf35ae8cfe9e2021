"""From a spec's text to a scene that is ready to run."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, Source, Span, SpecError, suggest
from nhc.language import Spec, decode
from nhc.language.advice import advise_need
from nhc.language.expressions.names import ENERGIES, fold_typed
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Name, Syntax, fold_tree, rebuild
from nhc.language.scope import Declared, Scope
from nhc.language.spec import Definition, Scene
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.expressions import Resolver, define_names
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.resolve import resolve
from nhc.mechanics.scenes import check_scene_name, start_of
from nhc.mechanics.system import System
from nhc.simulate.edges import continue_beyond
from nhc.simulate.methods import RUNGE_KUTTA, STRUCTURE
from nhc.simulate.methods.tableau import Collocation
from nhc.simulate.pacing import AUTO
from nhc.simulate.peers import SUNDIALS, WITH_JACOBIAN
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.project import projected_start
from nhc.simulate.reduced import prepare_reduced

_EVENT, _OPTION = "until", "--until"


class RunError(Exception):
    """What was asked does not fit the spec; ``help`` says what would."""

    def __init__(self, message: str, help: tuple[str, ...]) -> None:
        super().__init__(message)
        self.help = help


def open_scene(
    source: Source,
    scene: str = "",
    formulation: str = "",
    *,
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

    ``needs``: names of quantities (default: the scene's); ``until``: an expression in the spec's names whose zero ends the run;
    ``hold``: bring states back to the constraints; ``project``: replace a start that violates them by the nearest that does not;
    ``checks``: compute energy and residuals as well, with ``draw`` what the spec draws; ``whole``: keep states that this start
    alone does not need; ``stay``: keep to the formulation where it becomes singular (an ensemble, which is whole, always does);
    ``beside``: scenes that the spec does not have, whose values of the parameters the job must be right for, too.

    Raises:
        nhc.diagnostics.SpecError: the spec or the expression has errors.
        RunError: no such scene or quantity.
    """
    spec = decode(source, until)
    chosen = find_scene(spec, scene)
    wanted = tuple(dict.fromkeys(find_need(spec, need) for need in needs))
    spec = replace(spec, scenes=(*spec.scenes, *beside))
    if until and (method in STRUCTURE or method in SUNDIALS):
        raise RunError(f"the method `{method}` does not look for events", ("take dop853 with `--until`",))
    system, event = resolve_event(spec, until) if until else (resolve(spec), None)
    natural = method in STRUCTURE
    if natural and system.constraints and not formulation:
        formulation = "multipliers"  # its state has all velocities: these methods need not keep them on the constraints
    form = formulate(system, formulation)
    equations = equations_of(system, form)
    start, notes = projected_start(system, chosen) if project else (start_of(system, chosen), ())
    ending = None if event is None else continue_beyond(system.graph, event, start.values(system), intervals(system))
    implicit = method in WITH_JACOBIAN or isinstance(RUNGE_KUTTA.get(method), Collocation)
    plain = not (wanted or until or natural or checks or whole or draw)  # else more is asked than the scene needs
    weak = (method in RUNGE_KUTTA or method == AUTO) and not (stay or whole)
    recipe = Recipe(equations, wanted, ending, implicit, hold, checks, draw, weak)
    job = prepare_reduced(recipe, form, start) if plain else None
    job = job or prepare(recipe, form, start, natural=natural, fixed=not beside)
    job = replace(job, notes=notes)
    lacking = job.structure.lacking
    if natural and not lacking and STRUCTURE[method].constant_mass and not job.structure.constant_mass:
        lacking = "its mass matrix is not constant"
    if natural and lacking:
        raise RunError(f"the method `{method}` does not fit this system: {lacking}", ("take dop853 or midpoint",))
    return job


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
    shown = name in (*ENERGIES, *(d.name for d in spec.definitions)) or name.startswith("lambda_")
    hint = advise_need(name) if shown else suggest(name, known, f"it can be {', '.join(known)}")
    raise RunError(f"no quantity `{text}` in this spec", (hint,))


def resolve_event(spec: Spec, text: str) -> tuple[System, Node]:
    """The system, and the value whose zero ends the run.

    Raises:
        nhc.diagnostics.SpecError: the spec or the expression has errors.
        RunError: the expression never changes.
    """
    tree = parse_event(spec, text)
    try:
        system = resolve(replace(spec, outputs=(*spec.outputs, Definition(_EVENT, tree, Span(0, 0)))))
    except SpecError:
        # raises, too, unless the expression is to blame: then it is said with places in its own text
        resolve(spec)
        probe = Resolver(spec)
        define_names(probe)
        probe.bag = Bag(Source(_OPTION, text))
        energies = {name: probe.graph.symbol(name, "energy") for name in ENERGIES}  # they have values, whichever
        probe.node(tree, {**energies, **probe.names})
        probe.bag.raise_if_errors()
        raise
    event = system.outputs[-1][1]
    if not system.graph.deps[event] & ~system.graph.mask(system.p):
        advice = ('name something that moves: `--until "t - 0.5"` stops at the time 0.5',)
        raise RunError(f"`{text}` never crosses zero: it stays what it is during the run", advice)
    return replace(system, outputs=system.outputs[:-1]), event


def parse_event(spec: Spec, text: str) -> Syntax:
    """The tree of an expression in the spec's names, outputs among them, as an output would be read.

    Raises:
        nhc.diagnostics.SpecError: with the places in the text.
    """
    bag = Bag(Source(_OPTION, text))
    tree = parse_expression(text, Span, bag)
    if tree is not None:
        outputs = {output.name: output.value for output in spec.outputs}

        def visit(node: Syntax, parts: tuple[Syntax, ...]) -> Syntax:
            return outputs.get(node.name, node) if isinstance(node, Name) else rebuild(node, parts)

        tree = fold_tree(tree, visit)
        scope = Scope(bag)
        for kind, entries in (
            ("coordinate", spec.coordinates),
            ("parameter", spec.parameters),
            ("define", spec.definitions),
            ("quasi", spec.quasi_velocities),
        ):
            scope.names.update((entry.name, Declared(kind, entry.span)) for entry in entries)
        tree = scope.resolve(tree, "output")
        held: dict[str, bool] = {}
        for name, value in spec.named_values:
            held[name] = scope.holds_velocities(value, held, report=False)
        scope.holds_velocities(tree, held)
    bag.raise_if_errors()
    assert tree is not None
    return tree
