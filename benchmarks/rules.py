"""Operations of the right-hand side with all rewriting rules and without each of them; writes docs/rewriting.md.

``python -m benchmarks.rules``.  Counts are exact and the same on every machine.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from benchmarks.counting import count_instructions
from benchmarks.models import FLAGS, names, nhc_sources, parameters, source, states
from benchmarks.systems import ROOT
from nhc.algebra.rewriting.rules import RULES, WithoutRules
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.ir import Program
from nhc.program.model import build_program
from nhc.program.planning.planner import CALLED

PAGE = ROOT / "docs" / "rewriting.md"
SYSTEMS = (
    *("sleigh", "disk", "trailers5", "snake5", "pendulum5", "bicycle"),
    *("snakeboard", "smooth_tippe_top", "voronec_particle", "atoms3", "ball_arm3", "satellite3", "written_out_top"),
    *("chaplygin_ball_quaternion", "bowl", "arm6", "belt_egg", "submarine", "written_out_arm4", "flat_arm2"),
    *("spherical2", "turned_top", "dome", "turret"),
)
COUNTED = ("rhs", "velocities", "accelerations", "residuals", "reactions", "energy", "jacobian")


@dataclass(frozen=True)
class Operations:
    """Of one call of ``rhs``: additions, multiplications and divisions together; divisions alone; calls of functions."""

    all: int
    divisions: int
    calls: int


def compile_without(
    system: str, off: Iterable[str], style: str = "positions", only: tuple[str, ...] = ("rhs",)
) -> Program:
    """The program of ``rhs``, or of other functions, derived without some rules."""
    made = resolve(decode(source(system, style)), WithoutRules(off))
    formulation = formulate(made)
    return build_program(made, formulation, equations_of(made, formulation), only=only)


def count(system: str, off: Iterable[str] = (), style: str = "positions") -> Operations:
    """Operations of the right-hand side derived without some rules."""
    (rhs,) = compile_without(system, off, style).functions
    return Operations(rhs.adds + rhs.multiplications + rhs.divisions, rhs.divisions, rhs.calls)


def count_functions(off: Iterable[str] = ()) -> dict[str, int]:
    """Operations of one call of each function of all systems together, a call of sine and the like as twenty."""
    found = dict.fromkeys(COUNTED, 0)
    for system in SYSTEMS:
        for function in compile_without(system, off, only=()).functions:
            if function.name in found:
                operations = function.adds + function.multiplications + function.divisions
                found[function.name] += operations + _CALL * function.calls
    return found


def count_trig(system: str) -> tuple[float, ...]:
    """Machine instructions per call with libm's sine and cosine and with ``--trig inline``: plain, then with fused operations."""
    points = states(system, sum(map(len, names(system))))
    return tuple(
        count_instructions(nhc_sources(system, trig=trig), points, parameters(system), flags)
        for flags in (FLAGS, FUSED)
        for trig in ("", "inline")
    )


_CALL = 20
FUSED = (*FLAGS, "-march=x86-64-v3", "-ffp-contract=fast")

_HEAD = """\
# Rewriting rules

nhc shortens the expressions that it derives by the rules on this page, none of which changes a value.  The first table shows what
each rule is worth; the second says what it does and where it is implemented.  The page is written by `python -m benchmarks.rules`.

The numbers are additions, multiplications and divisions of one right-hand side (in parentheses the divisions, then calls of
sine, cosine and the like), from specs that give positions: with all rules, then without one of them at a time.  A rule may gain
nothing on one system and much on another, and several rules may lead to the same shorter form, so that the table understates
each.  `tests/property/test_rules.py` compares each rule with the unrewritten expression modulo primes, and the compiled
right-hand sides with and without it.
"""

_TRIG = """\

Sine and cosine take half of the instructions of a small model; `--trig inline` puts them into the file
([accuracy](emitted-code.md#sine-and-cosine)).  The next table has the instructions per right-hand side, counted by callgrind:
`-O3` for x86-64 without further options, and with fused multiply-add (`{fused}`); in parentheses the ratio to the first column.

| | libm | inlined | libm, fused | inlined, fused |
|---|---|---|---|---|
"""


def write_page() -> str:
    """The page: what each rule does, and the counts with and without it."""
    lines = [_HEAD, "| without | " + " | ".join(SYSTEMS) + " |", "|---" * (len(SYSTEMS) + 1) + "|"]
    lines.append("| (all rules) | " + " | ".join(_cell(count(system)) for system in SYSTEMS) + " |")
    for rule in RULES:
        cells = [_cell(count(system, (rule.name,))) for system in SYSTEMS]
        lines.append(f"| {rule.name} | {' | '.join(cells)} |")
        print(lines[-1], file=sys.stderr, flush=True)
    lines.append("| all of these | " + " | ".join(_cell(count(s, (r.name for r in RULES))) for s in SYSTEMS) + " |")
    lines += ["", "| rule | what becomes what | where |", "|---|---|---|"]
    lines += [f"| {rule.name} | {rule.about} | `nhc/{rule.where}` |" for rule in RULES]
    return "\n".join(lines) + "\n"


_FUNCTIONS = """\

The same for every emitted function: operations of all these systems together, a call of sine, cosine and the like as {call}, and
in percent what they are without a rule.  Where a function takes more than {late} operations of the rates, it calls `rhs` for them,
and they are not in it.

"""


def write_functions() -> str:
    """The table of all functions."""
    lines = ["| without | " + " | ".join(COUNTED) + " |", "|---" * (len(COUNTED) + 1) + "|"]
    whole = count_functions()
    lines.append("| (all rules) | " + " | ".join(str(whole[name]) for name in COUNTED) + " |")
    for rule in RULES:
        without = count_functions((rule.name,))
        cells = [f"{100 * without[name] / whole[name]:.1f}" for name in COUNTED]
        lines.append(f"| no {rule.name} | {' | '.join(cells)} |")
        print(lines[-1], file=sys.stderr, flush=True)
    return _FUNCTIONS.format(call=_CALL, late=CALLED) + "\n".join(lines) + "\n"


def write_trig() -> str:
    """The table of inlined sine and cosine."""
    rows = []
    for system in SYSTEMS:
        libm, *others = count_trig(system)
        cells = [f"{libm:.0f}", *(f"{count:.0f} ({count / libm:.2f})" for count in others)]
        rows.append(f"| {system} | {' | '.join(cells)} |")
    return _TRIG.format(fused=" ".join(FUSED[2:])) + "\n".join(rows) + "\n"


def _cell(operations: Operations) -> str:
    return f"{operations.all} ({operations.divisions}, {operations.calls})"


def main(page: Path = PAGE) -> None:
    page.write_text(write_page() + write_functions() + write_trig(), encoding="utf-8")
    print(f"wrote {page.relative_to(ROOT)}", file=sys.stderr)


if __name__ == "__main__":
    main()
