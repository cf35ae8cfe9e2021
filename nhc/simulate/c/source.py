"""The C of a run: the emitted model with integrators beside it, as one translation unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.emit import EmitOptions, render
from nhc.emit.environment import File, render_file
from nhc.program.ir import CORNER, Beats, Function, Load, Program
from nhc.program.runs.hold import SINGULAR_HOLD, TORN_HOLD
from nhc.program.runs.limits import LIMITS
from nhc.program.runs.watch import WEAK
from nhc.records import record
from nhc.simulate.c.coefficients import CUBIC, describe_tableau
from nhc.simulate.c.groups import FOUR, count_slots
from nhc.simulate.c.kernel import Kernel, print_kernel
from nhc.simulate.methods.natural import Scheme
from nhc.simulate.methods.step import ASIDE
from nhc.simulate.methods.tableau import Collocation, Explicit, Tableau
from nhc.simulate.stepping.watching import LOW, MOST_HALVINGS
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

NATURAL = ("mass", "slope", "rows", "total", "velocities", "state", "needed")


@record
class Named:
    """A method that its template says in full."""

    name: str
    template: str


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
    parts, watch, beats = list_parts(program), functions.get("watch"), program.driving.beats
    explicit = any(isinstance(method, Explicit) for method in methods)
    kernel = print_kernel(program, functions["rhs"]) if explicit and trig == "inline" else None
    watching = print_kernel(program, watch) if watch is not None and lanes else None
    side = kernel is not None and not holds and not parts and (beats is None or beats.steady)
    lanes = lanes and side and (watch is None or watching is not None)
    context: dict[str, object] = {
        **_name(program),
        "declarations": tuple(declare(program.system, function) for function in program.functions),
        "lanes": lanes,
        **_describe_kernels(kernel, watching if lanes else None, len(program.state), methods),
        **_describe_watch(size(watch), events, dips, *frames),
        "parts": parts,
        "lands": CORNER in parts,
        **_describe_beats(beats, functions, methods),
        "holds": tuple(holds),
        "needed": size(functions["needed"]),
        **_HOLD_STATUSES,
        **_describe_steps(methods),
        "counted": True,
        "timed": any(isinstance(s, Load) and s.index < 0 for s in functions["rhs"].body),
        "methods": tuple(describe_tableau(method, kernel) for method in methods),
        "limits": LIMITS,
        "aside": ASIDE,
    }
    return model | {f"{program.system}_run.c": render_file(File("run.c", "c/run.c.jinja", context))}


def _describe_kernels(
    kernel: Kernel | None, watching: Kernel | None, states: int, methods: Sequence[Tableau]
) -> dict[str, object]:
    """The functions inside the loop, that of the right-hand side first, and the room that they need."""
    known = [one for one in (kernel, watching) if one is not None]
    explicit = [method for method in methods if isinstance(method, Explicit)]
    return {
        "kernels": tuple(known),
        "called": tuple(sorted({name for k in known for name in k.calls[i]}) for i in (0, 1)),
        **_describe_split(kernel),
        "slots": max(count_slots(method) for method in explicit) if kernel else 0,
        "pieces": list_pieces(kernel.reads, states) if kernel else (),
        "packs": count_packs(states),
        "fixed": max(1, sum(one.count for one in known)),
        "fixed_watch": known[0].count if known else 0,
    }


def _describe_steps(methods: Sequence[Tableau]) -> dict[str, object]:
    """Which parts of the loop the methods need, and how many slopes and terms of interpolants they keep."""
    implicit = [method for method in methods if isinstance(method, Collocation)]
    explicit = [method for method in methods if isinstance(method, Explicit)]
    adaptive = any(method.adaptive for method in methods)
    return {
        "paced": bool(explicit),
        "slopes": max([3, *(len(method.rows) + 1 for method in explicit)]),
        "shapes": max([5, *(CUBIC + len(method.dense) for method in explicit)]),
        "collocations": bool(implicit),
        "hermite": bool(explicit) or any(not method.adaptive for method in implicit),
        "adaptive": adaptive,
        "allowed": adaptive or bool(implicit),
    }


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
    return program.driving.leaps.parts if program.driving.leaps is not None and known else ()


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
