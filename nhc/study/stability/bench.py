"""A scene on the bench: its trajectory, and every quantity that the laboratory reads off it, through the emitted model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from nhc.algebra.exact.field import Unlucky
from nhc.algebra.graph import Node
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.dependence import find_dependence
from nhc.mechanics.flow import flow_of
from nhc.mechanics.frame import coordinate_frame, form_value
from nhc.mechanics.properties.conserved import Conserved, find_conserved, generalized_energy, power
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.rotations.turning import mass_matrix
from nhc.mechanics.starts.scenes import Start
from nhc.program.build import build_functions
from nhc.program.planning.planner import Planner
from nhc.program.runs.limits import LEAST_TOLERANCE, SAFETY
from nhc.program.runs.needed import Column, needed_function, reactions_of
from nhc.program.runs.structure import structure_of
from nhc.simulate.c.compile import CompileError, build, tell_why
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.c.source import write_natural, write_source
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.methods import RUNGE_KUTTA, STRUCTURE
from nhc.simulate.natural import NaturalModel
from nhc.simulate.outcomes import describe_outcome
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.run import list_times
from nhc.simulate.task import DONE, ModelError, Outcome, Task
from nhc.study.linearization.leaf import defined_at, leaf_integrals
from nhc.study.linearization.units import Matrix, cleaned, sizes_of, trials

ROWS = 201
MOST, MOST_INTERPRETED, MOST_NATURAL = 2_000_000, 20_000, (20_000, 500)
"""Steps that one run may take: in C, in Python, and by a structure-preserving method in C and in Python."""
_MOST_STATIONS = 20_000  # ends of steps that are looked at
_MOST_SCHEMES = 6  # coordinates up to which structure-preserving methods are tried
_MOST_MASS = 12  # coordinates up to which the mass matrix is looked at
_CANCELLED = 1e-8  # of what a column can be: one that is never larger is zero but for its rounding, or its integration


class NotRun(ArithmeticError):
    """The scene itself cannot be integrated."""


@dataclass(frozen=True)
class Bench:
    """``job`` computes all ``columns`` as its needed quantities; ``conserved`` is what the system was found to keep.

    ``schemes`` are the structure-preserving methods that the system has the structure for, each with its model.
    """

    equations: Equations
    formulation: Formulation
    start: Start
    job: Job
    model: CompiledModel | InterpretedModel
    columns: tuple[Column, ...]
    conserved: Conserved
    notes: tuple[str, ...]
    schemes: dict[str, CompiledModel | NaturalModel]

    @property
    def duration(self) -> float:
        return abs(self.job.time[1] - self.job.time[0])

    def most(self, method: str) -> int:
        """Steps that one run of a method may take."""
        if method in STRUCTURE:
            return MOST_NATURAL[0 if self.model.compiled else 1]
        return MOST if self.model.compiled else MOST_INTERPRETED

    def integrate(
        self,
        method: str,
        times: Sequence[float],
        y: Sequence[float] | None = None,
        step: float = 0.0,
        tolerance: float = 0.0,
        logged: bool = False,
    ) -> Outcome:
        """One run; ``tolerance`` 0 is what ``nhc run`` takes for the scene; ``logged``: with the ends of its steps."""
        task = self._task(method, times, self.job.y if y is None else y, step, tolerance)
        model = self.schemes.get(method, self.model)
        return model.integrate(replace(task, logged=logged), method, model.news())

    def states(self, method: str, times: Matrix, step: float = 0.0) -> Matrix:
        """The rows of a run by a Runge-Kutta method that are reached, shape (rows, NY), for many of them."""
        if not isinstance(self.model, CompiledModel):
            return np.array(self.integrate(method, times.tolist(), step=step).states, dtype=float)
        task = self._task(method, times, self.job.y, step, 0.0)
        many = self.model.integrate_many(task, method, list(task.y), list(task.p), self.model.news())
        return np.asarray(many.array()[0][: many.found[0].rows])

    def _task(self, method: str, times: Any, y: Sequence[float], step: float, tolerance: float) -> Task:
        wanted = tolerance or max(SAFETY * self.job.tolerance, LEAST_TOLERANCE)
        return Task(self.job.p, y, times, wanted, step, self.most(method), self.job.stops)

    def quantities(self, times: Sequence[float], states: Sequence[Sequence[float]] | Matrix) -> Matrix:
        """All columns, shape (rows, columns).

        Raises:
            nhc.simulate.task.ModelError: they have no value at a row.
        """
        if isinstance(self.model, CompiledModel):
            return np.asarray(self.model.quantities_array(times, states, self.job.p))
        found = self.model.quantities(times, np.asarray(states).tolist(), self.job.p)
        return np.array(found, dtype=float).reshape(len(times), -1)

    def group(self, name: str) -> list[int]:
        """The places of a group's columns."""
        return [k for k, column in enumerate(self.columns) if column.group == name]

    @cached_property
    def times(self) -> tuple[float, ...]:
        return list_times(*self.job.time, ROWS)

    @cached_property
    def reference(self) -> Matrix:
        """States along the scene, shape (ROWS, NY), by dop853 well below the scene's tolerance.

        Raises:
            NotRun: the scene does not reach its end.
        """
        outcome = self._run
        if outcome.kind != DONE:
            raise NotRun(f"the scene ends at t = {outcome.t:.9g} with {self.formulation.name}: {self.reason(outcome)}")
        return np.array(outcome.states)

    @cached_property
    def _run(self) -> Outcome:
        return self.follow(self.times, self.job.y)

    def follow(self, times: Sequence[float], y: Sequence[float]) -> Outcome:
        """A run by dop853 well below the scene's tolerance."""
        least = max(1e-3 * SAFETY * self.job.tolerance, 1e-13)
        return self.integrate("dop853", times, y, tolerance=least, logged=True)

    @property
    def ends(self) -> Sequence[float]:
        """The ends of the steps of the reference: they are close where the motion is fast."""
        return self._run.ends

    @cached_property
    def stations(self) -> tuple[Sequence[float], Sequence[Sequence[float]]]:
        """Times at the ends of the reference's steps, every one or as many as are looked at, and the states there."""
        times = (self.times[0], *self.ends[:: 1 + len(self.ends) // _MOST_STATIONS])
        return times, self.follow(times, self.job.y).states

    def reason(self, outcome: Outcome) -> str:
        """Why a run ended."""
        return describe_outcome(self.job, outcome)[1] or "it ends"

    @cached_property
    def table(self) -> Matrix:
        """All columns along the scene."""
        return self.quantities(self.times, self.reference.tolist())

    @cached_property
    def _slopes(self) -> InterpretedModel:
        only = tuple(f for f in self.job.program.functions if f.name == "jacobian")
        return InterpretedModel(replace(self.job.program, functions=only), 0)

    def jacobian(self, t: float, y: Sequence[float]) -> Matrix:
        """d rhs / d y of shape (NY, NY), the emitted one.

        Raises:
            ArithmeticError: the model is singular there.
        """
        size = len(self.job.y)
        return np.array(self._slopes.jacobian(t, list(y), self.job.p), dtype=float).reshape(size, size)

    def velocities(self, t: float, y: Sequence[float]) -> list[float]:
        """All q' at a state."""
        (row,) = self.quantities([t], [y])
        return [float(row[k]) for k in self.group("velocity")]

    @cached_property
    def sizes(self) -> Matrix:
        """The size of each component of the state in the scene; see :func:`nhc.study.linearization.units.sizes_of`."""
        found = [np.abs(slopes) for k in range(0, ROWS, ROWS // 8) if (slopes := self._slopes_at(k)) is not None]
        slopes = np.where(self._ties, np.max(found, axis=0), 0.0) if found else np.zeros((len(self.job.y),) * 2)
        largest = np.max(np.abs(np.concatenate([self.reference, self.stations[1]])), axis=0)
        return sizes_of(largest, slopes, self.duration, self.equations.system.n)

    @cached_property
    def _ties(self) -> Matrix:
        """Which rates depend on which entries, exactly; all of them where that is not decided."""
        size = len(self.job.y)
        try:
            rates = find_dependence(flow_of(self.equations), ()).rates
        except Unlucky:
            return np.ones((size, size), dtype=bool)
        return np.array([[k in entries for k in range(size)] for entries in rates])

    def jacobian_at(self, row: int) -> Matrix | None:
        """That at a row of the reference; None where it has no value, as a drag v*sqrt(v^2) has no slope at rest."""
        return self.slopes(self.times[row], self.reference[row].tolist())

    def slopes(self, t: float, y: Sequence[float]) -> Matrix | None:
        """The Jacobian at a state, if it has a value there."""
        try:
            return self.jacobian(t, y)
        except ArithmeticError:
            return None

    def _slopes_at(self, row: int) -> Matrix | None:
        """The same without what is no more than rounding: that would tie what has nothing to do."""
        here, t = self.jacobian_at(row), self.times[row]
        if here is None:
            return None
        try:
            return cleaned(here, [self.jacobian(t, near) for near, _ in trials(self.reference[row].tolist(), ())])
        except ArithmeticError:
            return here

    @cached_property
    def column_sizes(self) -> Matrix:
        """What each column can be in the scene: its slopes times the sizes of the state, or its own largest magnitude."""
        found: Matrix = np.max(np.abs(self.table), axis=0, initial=0.0)
        for k in range(0, ROWS, ROWS // 5):
            changes = [self._change(k, i, 1e-4 * float(size)) for i, size in enumerate(self.sizes)]
            found = np.asarray(np.maximum(found, np.sum(changes, axis=0) / 2e-4))
        return found

    @cached_property
    def typical_sizes(self) -> Matrix:
        """How large each column gets in the scene, an energy at least as its kinetic part; what is zero because its parts cancel
        is as large as :attr:`column_sizes` has it.
        """
        found: Matrix = np.max(np.abs(self.table), axis=0, initial=0.0)
        (kinetic,) = self.group("kinetic")
        for k in (*self.group("energy"), *self.group("jacobi")):
            found[k] = max(found[k], found[kinetic])
        return np.where(found > _CANCELLED * self.column_sizes, found, self.column_sizes)

    def _change(self, row: int, entry: int, move: float) -> Matrix:
        """By how much the columns differ on both sides of a row of the reference; 0 where one side is out of the model's domain."""
        moved = [self.reference[row].tolist() for _ in range(2)]
        moved[0][entry] -= move
        moved[1][entry] += move
        try:
            low, high = self.quantities([self.times[row]] * 2, moved)
        except ModelError:
            return np.zeros(len(self.columns))
        return np.asarray(np.abs(high - low))


def open_bench(equations: Equations, formulation: Formulation, start: Start, compiled: bool = True) -> Bench:
    """Build, compile and load what the laboratory needs of a scene."""
    job = prepare(Recipe(equations, jacobian=True), formulation, start)
    planner = Planner(equations, formulation)
    system = equations.system
    hidden = leaf_integrals(system, formulation)
    frame = coordinate_frame(system, choose_dependent(system).dependent) if system.l else None
    kept = find_conserved(system, frame, formulation.frame, [i.node for i in hidden])
    nonzero = {q.name for q, value in zip(system.spec.parameters, start.p, strict=True) if value != 0.0}
    watched = defined_at(system, hidden, start.values(system))
    columns = _list_columns(planner, kept, watched, nonzero)
    needed = needed_function(planner, columns)
    functions = tuple(needed if f.name == "needed" else f for f in job.program.functions)
    job = replace(job, program=replace(job.program, functions=functions), columns=tuple(columns), checks=())
    model, notes = _load(job, compiled)
    schemes = _schemes(planner, job, columns[:1], model.compiled)
    return Bench(equations, formulation, start, job, model, tuple(columns), kept, notes, schemes)


def _schemes(
    planner: Planner, job: Job, columns: Sequence[Column], compiled: bool
) -> dict[str, CompiledModel | NaturalModel]:
    """The structure-preserving methods, where the system is a natural one; their models give ``columns`` only."""
    if planner.system.n > _MOST_SCHEMES:
        return {}
    structure = structure_of(planner)
    if structure.lacking:
        return {}
    functions = (needed_function(planner, columns), *structure.functions)
    program = replace(job.program, functions=functions + build_functions(planner, ("velocities", "state")))
    schemes = [s for s in STRUCTURE.values() if structure.constant_mass or not s.constant_mass]
    if not compiled:
        slow = NaturalModel(program)
        return {scheme.name: slow for scheme in schemes}
    unit = f"{program.system}_run.c"
    return {
        scheme.name: CompiledModel(
            build(write_natural(program, scheme), unit), program.system, len(job.y), len(columns)
        )
        for scheme in schemes
    }


def _load(job: Job, compiled: bool) -> tuple[CompiledModel | InterpretedModel, tuple[str, ...]]:
    """All Runge-Kutta methods in one library, or the emitted Python."""
    notes: tuple[str, ...] = ()
    if compiled:
        try:
            sources = write_source(job.program, list(RUNGE_KUTTA.values()), job.events, job.holds, dips=job.watch.dips)
            path = build(sources, f"{job.program.system}_run.c")
            return CompiledModel(path, job.program.system, len(job.y), len(job.columns)), ()
        except CompileError as error:
            notes = (f"{tell_why(error)}; running the emitted Python with shorter runs",)
    return InterpretedModel(job.program, job.events, job.holds, job.watch.dips), notes


def _list_columns(
    planner: Planner, kept: Conserved, hidden: Sequence[tuple[str, Node]], nonzero: set[str]
) -> list[Column]:
    """Energy and its balance, constraints, integrals, determinants of frames, coefficients of the constraints, the mass matrix."""
    system = planner.system
    forms = [form_value(system, form) for form in system.constraints]
    integrals = [i for i in kept.integrals if not set(i.where) & nonzero]
    energy, general, kinetic, *rest = planner.on_motion(
        [system.energy, generalized_energy(system), system.T, *forms, *(i.node for i in integrals)]
    )
    found = [Column("T + V", "energy", energy), Column("p q' - T + V", "jacobi", general)]
    found.append(Column("T", "kinetic", kinetic))
    found.append(_power_column(planner))
    found += [Column(f.name, "residual", r) for f, r in zip(system.constraints, rest, strict=False)]
    found += [
        Column(f"{f.name}, position", "position", f.equation) for f in system.constraints if f.equation is not None
    ]
    found += [Column(i.text, "integral", r) for i, r in zip(integrals, rest[len(forms) :], strict=True)]
    found += [Column(text, "hidden", node) for text, node in hidden]
    for guard in planner.frame_determinants():
        found += [Column(guard.what, "guard", guard.value), Column("", "scale", guard.scale)]
    found += [Column(f.name, "row", a) for f in system.constraints for a in f.coefficients]
    found += [Column("", "velocity", v) for v in planner.equations.motion.velocities]
    if planner.formulation.frame is not None:
        free = planner.formulation.frame.forms[system.l :]
        found += [Column(f.name, "free", a) for f in free for a in f.direction]
    if system.n <= _MOST_MASS:
        found += [Column("", "mass", entry) for entry in planner.on_motion(mass_matrix(system))]
    return found


def _power_column(planner: Planner) -> Column:
    """The rate of p q' - T + V by (III.2.2); it holds reactions where a constraint moves."""
    system, g = planner.system, planner.graph
    moving = any(form.constant != g.zero for form in system.constraints)
    reactions = reactions_of(planner) if moving else [g.zero] * system.l
    value = planner.on_motion([power(system, reactions)])[0]
    return Column("power of lambda" if moving else "power", "power", value)
