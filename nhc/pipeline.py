"""The compiler in one page: each stage with what it takes and what it gives.

    read       file -> Source -> YAML nodes with positions
    decode     nodes -> Spec
    resolve    Spec -> System
    choose     System -> Formulation
    form       System, Formulation -> Omega on paper
    associate  System, Formulation -> Equations
    lower      Equations -> Program
    render     Program (LaTeX: the derivation) -> files as text

Stages are pure; the names below are those of ``--dump``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from nhc.diagnostics import Bag, Diagnostic, Source, SpecError
from nhc.language import Spec, decode
from nhc.language.units.warnings import warn_of_units
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation, formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import check_scene_name
from nhc.mechanics.system import System
from nhc.program.build import FUNCTIONS
from nhc.program.ir import Program
from nhc.program.model import build_program
from nhc.program.planning.planner import Planner
from nhc.program.runs.starting import check_starts, warn_as_given
from nhc.records import record
from nhc.stamp import stamp

if TYPE_CHECKING:
    from nhc.mechanics.certificates.certificate import Certificate
    from nhc.program.paper import Derivation
    from nhc.program.scene_model import SceneModel
    from nhc.program.validation.validate import Kept
    from nhc.simulate.changes import Changes
    from nhc.study.chart.ahead import Show
    from nhc.study.chart.case import Study
    from nhc.study.chart.fidelity import Comparison
    from nhc.study.chart.grid import Grid
    from nhc.study.linearization.motion import Findings, Request
    from nhc.study.simplify.elimination import Show as ShowTrial
    from nhc.study.simplify.ladder import Ladder
    from nhc.study.stability.laboratory import Laboratory, Question


@record
class Stage:
    """A stage's name and what its dump shows."""

    name: str
    about: str


STAGES = (
    Stage("read", "the YAML nodes with their positions"),
    Stage("decode", "the spec: declarations and expressions, names resolved"),
    Stage("resolve", "the system: T, U, Q and the constraint rows over the graph"),
    Stage("choose", "the formulation, its coframe, and why"),
    Stage("form", "the 2-form Omega in its coframe"),
    Stage("associate", "the associated system: automatic rows, equations of motion, energy"),
    Stage("lower", "the program: functions of let, guard, solve, store"),
    Stage("render", "the names and sizes of the emitted files"),
)


@record
class Options:
    """``formulation``, ``scene``: names or empty; ``to``: text, latex or json; ``only``: functions; ``array``: numpy or jax.

    ``reduce``: the scene's smallest model in place of the full one; ``fold``: with its parameter values put in; ``changes``: of the
    scene, in its smallest model.  ``width``: of the lines of a text; 0 for the usual one.
    """

    formulation: str = ""
    scene: str = ""
    to: str = "text"
    only: tuple[str, ...] = ()
    driver: bool = False
    array: str = ""
    simplify: float = 0.0
    trig: str = ""
    reduce: bool = False
    fold: bool = False
    changes: Changes | None = None
    width: int = 0


DEFAULT = Options()


@record
class Report:
    """What a check found: warnings, facts as lines, and the same as data."""

    diagnostics: tuple[Diagnostic, ...]
    facts: tuple[str, ...]
    data: dict[str, Any]


@record
class Model:
    """A spec that has been carried as far as its equations."""

    spec: Spec
    system: System
    formulation: Formulation
    equations: Equations


def model(source: Source, options: Options = DEFAULT) -> Model:
    """decode, resolve, choose, associate.

    Raises:
        SpecError: everything that is wrong with the spec.
    """
    spec = decode(source)
    check_scene_name(spec, options.scene)
    system = resolve(spec)
    formulation = formulate(system, options.formulation)
    return Model(spec, system, formulation, equations_of(system, formulation))


def program(source: Source, options: Options = DEFAULT) -> Program:
    """The program of a spec, as the emitters read it; with ``reduce`` the smallest one that delivers what the scene needs.

    The starts of the spec's scenes are part of it where it is the whole program, or for a driver.

    Raises:
        SpecError: everything that is wrong with the spec.
    """
    if options.reduce and options.scene:
        from nhc.program.reduced import build_scene_program

        notes = options.changes.notes if options.changes else ()
        return build_scene_program(reduce_scene(source, options), options.only, options.driver, notes)
    made, driver = model(source, options), options.driver
    scenes = driver or not options.only
    return build_program(made.system, made.formulation, made.equations, options.only, options.scene, scenes, driver)


def reduce_scene(source: Source, options: Options) -> SceneModel:
    """The smallest model that delivers what a scene needs, with all that was tried for it.

    Raises:
        SpecError: everything that is wrong with the spec, or with the changes.
    """
    from nhc.program.scene_model import scene_model

    spec = decode(source)
    check_scene_name(spec, options.scene)
    scene = next(s for s in spec.scenes if s.name == options.scene)
    if options.changes is not None:
        from nhc.simulate.changes import changed

        spec, scene = changed(spec, scene, options.changes)
    system = resolve(spec)
    fixed = (options.formulation or spec.formulation or "auto") != "auto"
    return scene_model(system, formulate(system, options.formulation), scene, only_base=fixed, fold=options.fold)


def check(source: Source, *, explain: bool = True) -> Report:
    """All errors (raised) or all warnings and facts of a spec; without ``explain`` those that take time are left out.

    Raises:
        SpecError: the spec has errors.
    """
    from nhc.mechanics.properties.facts import describe

    spec, bag = decode(source), Bag(source)
    try:
        system = resolve(spec, drawn=True)
        formulation = formulate(system)
        planner = Planner(equations_of(system, formulation), formulation)  # refuses what the forces do not determine
        check_starts(planner, bag)
    except SpecError as error:
        bag.extend(error.diagnostics)
    warn_of_units(spec, bag)
    bag.raise_if_errors()
    warn_as_given(planner, bag)
    facts = describe(system, formulation, bag, explain=explain)
    return Report(bag.diagnostics, facts.lines, facts.data)


def compare(source: Source, show: Show | None = None) -> tuple[Certificate, dict[str, Kept]]:
    """Whether all formulations agree on a spec, and whether the functions of their programs keep what they promise: exactly.

    Raises:
        SpecError: the spec has errors.
    """
    from nhc.program.validation.validate import certify_programs

    return certify_programs(resolve(decode(source)), show)


def check_certificate(source: Source, text: str) -> list[str]:
    """What is wrong with a certificate that was written for this spec; nothing where it holds.

    Raises:
        SpecError: the spec has errors.
    """
    from nhc.mechanics.certificates.file import verify

    return verify(text, resolve(decode(source)), source.text)[0]


def derivation(source: Source, options: Options) -> Derivation:
    """The derivation on paper.

    Raises:
        SpecError: the spec has errors.
    """
    from nhc.program import paper

    made = model(source, options)
    scene = next((s for s in made.spec.scenes if s.name == options.scene), None)
    return paper.derivation(made.system, made.formulation, made.equations, scene, options.simplify)


def derive(source: Source, options: Options = DEFAULT) -> str:
    """The derivation as text, LaTeX or JSON."""
    made = derivation(source, options)
    if options.to == "latex":
        from nhc.emit import latex

        return stamp(latex.render(made))
    from nhc.emit import text

    if options.to == "json":
        import json

        return json.dumps(text.derivation_json(made), indent=2, ensure_ascii=False) + "\n"
    return text.print_derivation(made, options.width)


def emit(
    source: Source, language: str, options: Options = DEFAULT, warn: Callable[[str], None] | None = None
) -> dict[str, str]:
    """File name -> text, stamped; ``warn`` is told what the functions cannot do.

    Raises:
        SpecError: the spec has errors.
        nhc.emit.EmitError: an option that this spec has no answer for.
    """
    if language == "latex":
        from nhc.emit import latex

        made = derivation(source, options)
        return {f"{made.system.name}.tex": stamp(latex.render(made))}
    from nhc.emit import EmitOptions, render

    wanted = EmitOptions(options.only, options.driver, options.array, options.scene, options.trig)
    needed = () if options.driver else _functions(options.only)
    if not (options.driver or options.scene or needed):
        needed = FUNCTIONS  # all of them, but no starts of scenes
    made_program = program(source, replace(options, only=needed, reduce=bool(options.scene)))
    files = {name: stamp(text) for name, text in render(made_program, language, wanted).items()}
    if warn is not None:
        for line in made_program.warnings:
            warn(line)
    return files


def _functions(only: tuple[str, ...]) -> tuple[str, ...]:
    """The IR's functions behind the emitted ones that are asked for; all of them when a name is wrong (the emitter says so)."""
    wanted = tuple(dict.fromkeys("rhs" if name == "rhs_batch" else name for name in only))
    return wanted if all(name in FUNCTIONS for name in wanted) else ()


def linearize(source: Source, request: Request, options: Options = DEFAULT) -> Findings:
    """A steady motion, the matrix and the eigenvalues about it (needs numpy: the extra ``sim``).

    Raises:
        SpecError: the spec or the request has errors.
        nhc.study.linearization.found.NotSteady: no steady motion is found.
    """
    from nhc.study.linearization.absent import linearise_at_values

    made = model(source, options)
    return linearise_at_values(made.equations, made.formulation, request, fixed=bool(options.formulation))


def stability(source: Source, question: Question, options: Options = DEFAULT, show: Show | None = None) -> Laboratory:
    """Every stability study of a scene (needs numpy: the extra ``sim``); ``show`` is told the part that is done, and of what.

    Raises:
        SpecError: the spec or the question has errors.
        nhc.simulate.requests.RunError: no such scene.
    """
    from nhc.mechanics.about import scene_about
    from nhc.simulate.changes import Changes, changed
    from nhc.simulate.requests import find_scene
    from nhc.study.stability.laboratory import examine, examine_whole

    spec, changes = decode(source), Changes(question.settings)
    spec, _ = changed(spec, find_scene(spec, question.scene), changes)
    scene_about(spec, question.about, question.settings)  # before anything is compiled
    system = resolve(spec)
    form = formulate(system, options.formulation)
    study = examine if (options.formulation or spec.formulation) not in ("", "auto") else examine_whole
    return replace(study(equations_of(system, form), form, question, *([show] if show else [])), changes=changes.notes)


def chart(source: Source, grid: Grid, show: Show | None = None) -> Study:
    """The work-precision study of a scene.

    Raises:
        SpecError: the spec has errors.
        nhc.simulate.requests.RunError: no such scene or quantity.
        nhc.study.chart.reference.NoReference: no method comes to the end of the scene.
    """
    from nhc.study.chart.study import chart as make

    return make(source, grid, show)


def compare_models(sources: Sequence[Source], finest: Source, grid: Grid, show: Show | None = None) -> Comparison:
    """The error of models against the finest of them on one scene, and what their runs cost; raises like ``chart``."""
    from nhc.study.chart.fidelity import compare_models as compare

    return compare(sources, finest, grid, show)


def simplify(source: Source, tolerance: float, options: Options, show: ShowTrial | None = None) -> Ladder:
    """Models of a scene with less and less in them, by measured errors, down to the smallest within ``tolerance``.

    Raises:
        SpecError: the spec has errors.
        nhc.study.simplify.measure.NotMeasured: the full model's run is no reference.
    """
    from nhc.simulate.changes import UNCHANGED
    from nhc.study.simplify.search import simplify as search

    check_scene_name(decode(source), options.scene)
    return search(source, options.scene, tolerance, options.formulation, show, options.changes or UNCHANGED)


def cite(source: Source) -> str:
    """What to cite for a spec: its own sources, and the sources of the formulation used."""
    from nhc.mechanics.citations import citation

    made = model(source)
    return citation(made.system, made.formulation)
