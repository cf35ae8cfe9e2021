"""The coefficients of Runge-Kutta methods as text of C, in the shapes that their templates place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from nhc.records import record
from nhc.simulate.c.groups import Waiting, plan_waiting
from nhc.simulate.c.kernel import Kernel
from nhc.simulate.methods.tableau import Collocation, Explicit, Tableau

CUBIC = 3  # terms of an interpolant that every method has


@dataclass(frozen=True, slots=True)
class Line:
    """An entry of a generated switch or table."""

    index: int
    sum: str


@dataclass(frozen=True, slots=True)
class StageLine(Line):
    """A stage: ``state`` is its state, by a sum that waits least for the youngest slope."""

    state: str


@record
class ExplicitText:
    """What ``explicit.c.jinja`` places; ``extra`` is the last slope that only the interpolant needs, or 0; ``hidden`` adds up the
    slopes that are not in the step itself.
    """

    name: str
    template: str
    nodes: str
    stages: tuple[StageLine, ...]
    end: int
    extra: int
    errors: tuple[str, ...]
    hidden: str
    dense: tuple[Line, ...]
    exponent: int
    trust: float
    turn: float
    waiting: Waiting
    paced: bool = True


@record
class CollocationText:
    """What ``collocation.c.jinja`` places."""

    name: str
    template: str
    count: int
    nodes: str
    rows: str
    advance: str
    errors: str
    pole: str
    stiff: bool
    exponent: int
    trust: float
    turn: float
    paced: bool = False


def print_sum(row: Sequence[float]) -> str:
    """``a0 * s->k[0][i] + ...`` without the terms that are zero."""
    terms = [f"{weight!r} * s->k[{j}][i]" for j, weight in enumerate(row) if weight]
    return " + ".join(terms).replace("+ -", "- ")


def print_state(row: Sequence[float]) -> str:
    """``s->y[i]`` and the slopes by ``row``; one product and one sum are left to do once the last of them is there."""
    *first, weight = row
    known = f"(s->y[i] + s->h * ({print_sum(first)}))" if any(first) else "s->y[i]"
    return f"{known} + (s->h * {weight!r}) * s->k[{len(first)}][i]"


def print_row(row: Sequence[float]) -> str:
    """Numbers between commas."""
    return ", ".join(repr(value) for value in row)


def describe_explicit(method: Explicit, kernel: Kernel | None) -> ExplicitText:
    """An explicit method's tableau as text."""
    last = len(method.rows)
    weights = method.rows[method.stages - 1]
    hidden = [j for j in range(method.stages + 1) if j >= len(weights) or not weights[j]]
    return ExplicitText(
        name=method.name,
        template=f"c/methods/{method.name}.c.jinja",
        nodes=print_row(method.nodes),
        stages=tuple(StageLine(j + 1, print_sum(row), print_state(row)) for j, row in enumerate(method.rows)),
        end=method.stages,
        extra=last if last > method.stages else 0,
        errors=tuple(print_sum(row) for row in method.errors),
        hidden=" + ".join(f"s->k[{j}][i]" for j in hidden),
        dense=tuple(Line(CUBIC + j, print_sum(row)) for j, row in enumerate(method.dense)),
        exponent=max(method.exponent, 1),
        trust=method.trust,
        turn=method.turn,
        waiting=plan_waiting(method, kernel) if kernel else Waiting(),
    )


def describe_collocation(method: Collocation) -> CollocationText:
    """An implicit method's tableau as text."""
    return CollocationText(
        name=method.name,
        template=f"c/methods/{method.name}.c.jinja",
        count=len(method.nodes),
        nodes=print_row(method.nodes),
        rows=", ".join("{" + print_row(row) + "}" for row in method.rows),
        advance=print_row(method.advance),
        errors=print_row(method.errors),
        pole=repr(method.pole),
        stiff=method.adaptive,
        exponent=max(method.exponent, 1),
        trust=method.trust,
        turn=method.turn,
    )


def describe_tableau(method: Tableau, kernel: Kernel | None) -> ExplicitText | CollocationText:
    """A method's tableau as text."""
    return describe_explicit(method, kernel) if isinstance(method, Explicit) else describe_collocation(method)
