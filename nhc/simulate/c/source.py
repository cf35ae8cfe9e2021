"""The C of a run: the emitted model with integrators beside it, as one translation unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from nhc.emit import EmitOptions, render
from nhc.emit.environment import File, render_file
from nhc.program.ir import Beats, Function, Load, Program
from nhc.program.runs.hold import SINGULAR_HOLD, TORN_HOLD
from nhc.program.runs.limits import LIMITS
from nhc.program.runs.watch import WEAK
from nhc.records import record
from nhc.simulate.c.groups import FOUR, Waiting, count_slots, plan_waiting
from nhc.simulate.c.kernel import Kernel, print_kernel
from nhc.simulate.methods.natural import Scheme
from nhc.simulate.methods.step import ASIDE
from nhc.simulate.methods.tableau import Collocation, Explicit, Tableau
from nhc.simulate.stepping.watching import LOW, MOST_HALVINGS
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

NATURAL = ("mass", "slope", "rows", "total", "velocities", "state", "needed")
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


@record
class Named:
    """A method that its template says in full."""

    name: str
    template: str


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


def describe(method: Tableau, kernel: Kernel | None) -> ExplicitText | CollocationText:
    """A method's tableau as text."""
    return describe_explicit(method, kernel) if isinstance(method, Explicit) else describe_collocation(method)


_HOLD_STATUSES = {"singular_hold": SINGULAR_HOLD, "torn_hold": TORN_HOLD}


def write_source(
    program: Program,
    methods: Sequence[Tableau],
    events: int,
    holds: Sequence[Sequence[str]] = (),
    trig: str = "inline",
    dips: int | None = None,
    lanes: bool = False,
    frames: tuple[int, int] = (0, 0),
) -> dict[str, str]:
    """File name -> text of ``<s>.h``, ``<s>.c`` and ``<s>_run.c``; the last one includes the others.

    ``program`` has rhs and needed, jacobian for an implicit method, and watch where something is watched, the first ``events`` of
    its values being the user's, those from ``dips`` on being sought where they only touch zero; ``frames``: the first value that
    tells how weak a coframe is, and the number of coframes; ``holds`` are called in this order after each step, each with what
    stands in for it.  ``trig``: the inlined sine and cosine were faster in every run, but are for doubles only.  ``lanes``: many
    starts side by side, where an explicit method without ``holds`` and linear systems allows it.
    """
    functions = {function.name: function for function in program.functions}
    model = render(program, "c", EmitOptions(only=tuple(functions), trig=trig))
    implicit = [method for method in methods if isinstance(method, Collocation)]
    explicit = [method for method in methods if isinstance(method, Explicit)]
    parts, watch, beats = list_parts(program), functions.get("watch"), program.beats
    kernel = print_kernel(program, functions["rhs"]) if explicit and trig == "inline" else None
    watching = print_kernel(program, watch) if watch is not None and lanes else None
    side = kernel is not None and not holds and not parts and (beats is None or beats.steady)
    lanes = lanes and side and (watch is None or watching is not None)
    known = [one for one in (kernel, watching if lanes else None) if one is not None]
    context: dict[str, object] = {
        **_name(program),
        "declarations": tuple(declare(program.system, function) for function in program.functions),
        "kernels": tuple(known),
        "lanes": lanes,
        "called": tuple(sorted({name for k in known for name in k.calls[i]}) for i in (0, 1)),
        **_describe_split(kernel),
        "slots": max(count_slots(method) for method in explicit) if kernel else 0,
        "pieces": list_pieces(kernel.reads, len(program.state)) if kernel else (),
        "packs": count_packs(len(program.state)),
        "fixed": max(1, sum(kernel.count for kernel in known)),
        "fixed_watch": known[0].count if known else 0,
        "paced": bool(explicit),
        "slopes": max(3, *(len(m.rows) + 1 for m in explicit)) if explicit else 3,
        "shapes": max([5, *(CUBIC + len(m.dense) for m in explicit)]),
        **_describe_watch(size(watch), events, dips, *frames),
        "parts": parts,
        **_describe_beats(beats, functions, methods),
        "holds": tuple(holds),
        "needed": size(functions["needed"]),
        **_HOLD_STATUSES,
        "collocations": bool(implicit),
        "hermite": bool(explicit) or any(not method.adaptive for method in implicit),
        "adaptive": any(method.adaptive for method in methods),
        "counted": True,
        "allowed": any(method.adaptive for method in methods) or bool(implicit),
        "timed": any(isinstance(s, Load) and s.index < 0 for s in functions["rhs"].body),
        "methods": tuple(describe(method, kernel) for method in methods),
        "limits": LIMITS,
        "aside": ASIDE,
    }
    return model | {f"{program.system}_run.c": render_file(File("run.c", "c/run.c.jinja", context))}


def _describe_watch(watched: int, events: int, dips: int | None, weak: int, frames: int) -> dict[str, object]:
    """The watched values in their order, and what those are made of that tell how weak coframes are."""
    return {
        "watched": watched,
        "events": events,
        "dips": dips is not None and dips < watched,
        "first_dip": dips,
        "weak": weak,
        "frames": frames,
        "levels": len(WEAK),
        "deepest": float(WEAK[0] ** 2),
        "between": float(WEAK[0] ** 2 - WEAK[1] ** 2),
        "low": LOW**2,
        "most_halvings": MOST_HALVINGS,
    }


def _describe_beats(
    beats: Beats | None, functions: Mapping[str, Function], methods: Sequence[Tableau]
) -> dict[str, object]:
    """How many clocks are asked, by adaptive steps only, and whether their rates stay what they are."""
    asked = any(method.adaptive for method in methods)
    return {"beats": size(functions.get("beats")) if asked else 0, "steady": beats is not None and beats.steady}


def _describe_split(kernel: Kernel | None) -> dict[str, object]:
    """What of a right-hand side waits for other values, and how many it hands on."""
    if kernel is None:
        return {"reads": (), "waiting": (), "kept": 0, "handed": 0, "packed": ((), ())}
    return {
        "reads": kernel.reads,
        "waiting": kernel.waiting,
        "kept": kernel.kept,
        "handed": kernel.handed,
        "packed": kernel.packed,
    }


def write_natural(program: Program, method: Scheme) -> dict[str, str]:
    """The same for a structure-preserving method: ``program`` has mass, slope, rows, total, velocities, state and needed."""
    used = tuple(f for f in program.functions if f.name in NATURAL and (f.name != "rows" or size(f)))
    used = tuple(f for f in used if f.name != "total" or method.name == "energy")
    model = render(program, "c", EmitOptions(only=tuple(f.name for f in used)))
    context: dict[str, object] = {
        **_name(program),
        "declarations": tuple(declare(program.system, function) for function in used),
        "needed": size(next(function for function in used if function.name == "needed")),
        "method": Named(method.name, f"c/methods/{method.name}.c.jinja"),
        "constrained": any(function.name == "rows" for function in used),
    }
    return model | {f"{program.system}_run.c": render_file(File("run.c", "c/natural.c.jinja", context))}


def _name(program: Program) -> dict[str, object]:
    head = f"{program.system}_run.c: integrates {program.system}, emitted by nhc {__version__} ({PLACEHOLDER})"
    return {"name": program.system, "capitals": program.system.upper(), "head": head}


def list_parts(program: Program) -> tuple[tuple[float, float], ...]:
    """Those of the arguments that a step must not leap over, where the program has their function."""
    known = any(function.name == "places" for function in program.functions)
    return program.leaps.parts if program.leaps is not None and known else ()


def count_packs(states: int) -> int:
    """How many groups of four doubles hold a state of so many entries."""
    return -(-states // FOUR)


def list_pieces(entries: Sequence[int], states: int) -> tuple[int, ...]:
    """Where fours begin that hold these entries, as few as there can be."""
    found: list[int] = []
    for entry in sorted(entries):
        if not found or entry >= found[-1] + FOUR:
            found.append(min(entry, FOUR * count_packs(states) - FOUR))
    return tuple(found)


def size(function: Function | None) -> int:
    """Entries of a function's output."""
    return function.output.size if function is not None and function.output is not None else 0


def declare(system: str, function: Function) -> str:
    """The declaration that makes a function of the model internal."""
    arguments = ["double t" if a.size < 0 else f"const double *{a.name}" for a in function.inputs]
    assert function.output is not None
    return f"static int {system}_{function.name}({', '.join(arguments)}, double *{function.output.name});"
