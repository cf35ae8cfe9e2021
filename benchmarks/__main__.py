"""Run every benchmark and write ``docs/performance.md``: ``python -m benchmarks`` (or ``make bench``)."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

from benchmarks import batch, derivation, gallery, instructions, process, rules, simulation
from benchmarks.capped import CAP
from benchmarks.chart import draw_scaling
from benchmarks.models import COMPILER
from benchmarks.systems import ROOT, split_name
from benchmarks.table import PAGE, Row, describe_machine, print_rows, print_section

CHART = ROOT / "docs" / "derivation.svg"
_TIGHT = 1.10
_LOOSE = 1.30

_HEAD = """\
# Performance

How fast nhc derives equations and starts, and how fast its code and its simulations run, beside other tools (the
*peers*) and hand-written C.  `make bench` (`python -m benchmarks`) measures all of it and writes this page.  In each
row nhc and the peer took turns in the same run, or were counted in the same way.  Times are medians; instructions are
counted by callgrind and repeat to within a percent.  The targets were set beforehand; **no** marks those that are
missed.

Machine: {machine}.
"""

_DERIVATION = """\
## From spec to program

For nhc this is the time from the decoded spec in memory, and from the YAML text, to the program of the right-hand
side, solved for the rates of the velocities.  The peer is SymPy in the same process: from frames and points in memory,
with the speeds that its users choose, through `KanesMethod` to `cse` of mass matrix and forcing, which are not solved;
its import does not count.  It is stopped after {cap:.0f} s.  The ratio is peer / nhc.  SymPy's bicycle leaves out the
wheels' positions and angles, nhc's keeps them.
"""

_SCALING = """\
Time against the number of bodies, for specs that give positions ([chart](derivation.svg)).  The exponent is the slope
of a line through all points in logarithmic scales; 1 is linear growth.
"""

_PROCESS = """\
## Whole processes

Wall time of a command from start to end, against `python -c "{command}"`, run in turn, both with compiled bytecode as
an installed package has it.  Derived: with `--anew`, as for a spec that nhc has not seen; again: from the cache
([decision 14](decisions/0014-answers-are-kept.md)).
"""

_INSTRUCTIONS = """\
## Instructions per right-hand side

Counted by callgrind, libm included, averaged over 8 random states; `-O3` for x86-64 without further options.  The specs
give positions and quasi-velocities.  The peers:

- By hand: `benchmarks/hand/`, the recursion that an expert writes, checked against nhc's C in the tests to 1e-12.
- CasADi: Kane's form assembled with CasADi's derivatives, the same state, its own unrolled LDL^T and cse.
- PyDy: mass matrix and forcing from its C generator and an LU solve in C, which is faster than its own call of numpy's.
"""

_VARIANTS = """\
The same systems from other specs, as ratios to the hand-written C: with the energy and constraints expanded in full,
and without quasi-velocities (nhc then chooses, and the state is a different one).
"""

_GALLERY = """\
The whole gallery against CasADi; {alike} of {all} systems take at most 0.8 of its instructions.  CasADi is given T, U, forces and
constraints as the spec has them; it differentiates them and solves for the rates of nhc's own state, by elimination that
takes constant pivots first, its LDL^T and cse.  The values agree to 1e-9, which also confirms the derivation independently.
Ratios above 0.8 occur where nearly all the work is sines, cosines and the final test for infinities, which CasADi's C does
not have, and in systems without structure, with a T of arbitrary functions.
"""

_BATCH = """\
## Batches

`rhs_batch` with `--trig inline`, per state (`{flags}`), against the scalar `rhs` (`-O3`), first with
libm's sine and cosine, then with the inlined ones.  One C program runs both in turn; the quickest of many short rounds counts.
"""

_COMPILE = """\
## Compile time

Processor time of `{compiler} -O2 -c` for whole files with every function, the least of three.  Chains in space take longer:
two seconds for five universal joints, and more with their number ([decision 23](decisions/0023-loops-along-chains.md)).
"""


def main() -> None:
    sections = [
        _HEAD.format(machine=describe_machine()),
        *print_section(_DERIVATION.format(cap=CAP), derivation_rows()),
        *_scaling(),
        *print_section(_PROCESS.format(command=process.IMPORT.replace('"', "'")), process_rows()),
        *_instructions(),
        *_gallery(),
        *print_section(_BATCH.format(flags=" ".join(batch.WIDE)), batch_rows()),
        *print_section(_COMPILE.format(compiler=Path(COMPILER).name), compile_rows()),
        *simulation.write_section(simulation.SYSTEMS),
    ]
    PAGE.write_text("\n".join(sections) + "\n", encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}", file=sys.stderr)
    rules.main()


def derivation_rows() -> Iterator[Row]:
    for system in derivation.SYSTEMS:
        made = derivation.measure(system)
        mark = "> " if made.capped else ""
        yield Row(
            system,
            f"{made.nhc * 1e3:.2f} ms",
            f"{mark}{made.kane * 1e3:.0f} ms",
            made.ratio,
            200,
            at_least=True,
            bound=made.capped,
        )
        from_text = Row(
            f"{system}, from the text",
            f"{made.text * 1e3:.2f} ms",
            f"{mark}{made.kane * 1e3:.0f} ms",
            made.kane / made.text,
            bound=made.capped,
        )
        yield from_text


def _scaling() -> list[str]:
    times = {family: derivation.measure_scaling(family) for family in ("trailers", "snake")}
    CHART.write_text(draw_scaling(times), encoding="utf-8")
    lines = ["| | " + " | ".join(str(n) for n in derivation.SCALING) + " | exponent |"]
    lines.append("|---" * (len(derivation.SCALING) + 2) + "|")
    for family, found in times.items():
        cells = " | ".join(f"{seconds * 1e3:.1f} ms" for seconds in found.values())
        lines.append(f"| {family} | {cells} | {derivation.slope(found):.2f} |")
    print("\n".join(lines), file=sys.stderr, flush=True)
    return [_SCALING, *lines, ""]


def process_rows() -> Iterator[Row]:
    walls = process.measure()
    peer = f"{walls.imported * 1e3:.0f} ms"
    for what, seconds, target in (
        ("`nhc --help`", walls.help, 0.3),
        ("`nhc emit specs/bicycle.yaml --lang c`, derived", walls.emit_c, 0.35),
        ("the same again, from the cache", walls.emit_again, 0.35),
        ("`nhc emit specs/bicycle.yaml --lang c --only rhs`, derived", walls.emit_rhs, None),
        ("`nhc run specs/bicycle.yaml`, compiling the model", walls.run_first, None),
        ("the same again, with the model from the cache", walls.run_again, None),
    ):
        yield Row(what, f"{seconds * 1e3:.0f} ms", peer, seconds / walls.imported, target)
    yield Row("LaTeX of the bicycle, seconds", f"{walls.emit_latex:.2f} s", "2 s", walls.emit_latex / 2, 1)
    size = walls.latex_bytes / 1e3
    yield Row("LaTeX of the bicycle, size", f"{size:.0f} kB", "300 kB", size / 300, 1)


def _instructions() -> list[str]:
    found = []
    for system in instructions.SYSTEMS:
        found.append(instructions.measure(system))
        print("\n".join(print_rows(instruction_rows(found[-1]))[2:]), file=sys.stderr, flush=True)
    heads = [f"{style}{'' if given else ', no quasi-velocities'}" for style, given in instructions.VARIANTS]
    lines = ["| | " + " | ".join(heads) + " |", "|---" * (len(heads) + 1) + "|"]
    for counts in found:
        if counts.hand:
            cells = " | ".join(f"{counts.nhc[variant] / counts.hand:.3f}" for variant in instructions.VARIANTS)
            lines.append(f"| {counts.system} | {cells} |")
    rows = [row for counts in found for row in instruction_rows(counts)]
    return [_INSTRUCTIONS, *print_rows(rows), "", _describe_missing(found), "", _VARIANTS, *lines, ""]


def _gallery() -> list[str]:
    if find_spec("casadi") is None:
        return []
    found = []
    for made in gallery.measure():
        found.append(made)
        print(f"{made.name} {made.ratio:.3f}", file=sys.stderr, flush=True)
    lines = ["| | nhc | CasADi | ratio |", "|---|---|---|---|"]
    lines += [f"| {made.name} | {made.nhc:.0f} | {made.casadi:.0f} | {made.ratio:.3f} |" for made in found]
    alike = sum(made.ratio <= 0.8 for made in found)
    return [_GALLERY.format(alike=alike, all=len(found)), *lines, ""]


def _describe_missing(found: list[instructions.Counts]) -> str:
    """Which peers have no row, and why."""
    said = []
    for label, package in (("CasADi", "casadi"), ("PyDy", "pydy")):
        missing = [counts.system for counts in found if getattr(counts, package) is None]
        if find_spec(package) is None:
            said.append(f"{label} was not installed for this run.")
        elif missing:
            said.append(f"{label} was stopped after {CAP:.0f} s on {', '.join(missing)}.")
    return " ".join(said)


def instruction_rows(counts: instructions.Counts) -> list[Row]:
    loose = split_name(counts.system)[0] in ("pendulum", "bicycle")
    peers = (
        ("by hand", counts.hand, _LOOSE if loose else _TIGHT),
        ("CasADi", counts.casadi, 0.8),
        ("PyDy", counts.pydy, 0.5),
    )
    return [
        Row(f"{counts.system}, {label}", f"{counts.main:.0f}", f"{value:.0f}", counts.main / value, target)
        for label, value, target in peers
        if value is not None
    ]


def batch_rows() -> Iterator[Row]:
    for system in batch.SYSTEMS:
        made = batch.measure(system)
        what = f"{system}, {made.lanes} states per call"
        yield Row(what, f"{made.batch:.2f} ns", f"{made.plain:.2f} ns", made.ratio, 0.15)
        yield Row(f"{what}, inlined", f"{made.batch:.2f} ns", f"{made.inline:.2f} ns", made.batch / made.inline)


def compile_rows() -> Iterator[Row]:
    for system in process.COMPILED:
        seconds = process.compile_seconds(system)
        yield Row(system, f"{seconds:.3f} s", "1 s", seconds, 1)


if __name__ == "__main__":
    main()
