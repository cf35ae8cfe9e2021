"""``rhs_batch`` per state beside the scalar ``rhs`` of the same emitted file, in one C program, interleaved.

``python -m benchmarks.batch [SYSTEM...]``.  The scalar function is compiled with plain ``-O3`` (what a user gets without
thinking); the batch with ``-O3`` and the machine's own vectors.  The scalar function with the batch's flags stands beside.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from benchmarks.models import COMPILER, compile_c, names, nhc_sources, parameters, states, write

SYSTEMS = ("sleigh", "disk", "trailers5", "trailers20", "snake5", "snake20", "pendulum5", "bicycle")
LANES = (8, 256)
WIDE = ("-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math")

_MAIN = """\
#define _POSIX_C_SOURCE 199309L
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#define SIZE {size}
#define STATES {states}
int plain_rhs(double t, const double *y, const double *p, double *dydt);
int wide_rhs(double t, const double *y, const double *p, double *dydt);
int wide_rhs_batch(size_t count, const double *t, const double *y, const double *p, double *dydt);
static const double Y[STATES][SIZE] = {{
{rows}
}};
static const double P[] = {{{parameters}}};
static double time_s[{most}], in[SIZE * {most}], out[SIZE * {most}], single[SIZE * {most}];

static double now(void)
{{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}}

int main(int argc, char **argv)
{{
    const size_t count = (size_t)atoi(argv[1]);
    const int rounds = atoi(argv[2]), calls = atoi(argv[3]);
    int bad = argc != 4;
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < SIZE; k++) {{
            in[k * count + i] = Y[i % STATES][k];
            single[i * SIZE + k] = Y[i % STATES][k];
        }}
    for (int r = 0; r < rounds; r++) {{
        double start[4];
        start[0] = now();
        for (int c = 0; c < calls; c++)
            for (size_t i = 0; i < count; i++)
                bad |= plain_rhs(0.0, single + i * SIZE, P, out + i * SIZE);
        start[1] = now();
        for (int c = 0; c < calls; c++)
            for (size_t i = 0; i < count; i++)
                bad |= wide_rhs(0.0, single + i * SIZE, P, out + i * SIZE);
        start[2] = now();
        for (int c = 0; c < calls; c++)
            bad |= wide_rhs_batch(count, time_s, in, P, out);
        start[3] = now();
        for (int k = 0; k < 3; k++)
            printf("%.4f ", (start[k + 1] - start[k]) / ((double)calls * (double)count));
        printf("\\n");
    }}
    return bad;
}}
"""


@dataclass(frozen=True)
class Batch:
    """Nanoseconds per state: scalar at -O3, scalar with the batch's flags, batch; and the median of batch / scalar."""

    system: str
    lanes: int
    plain: float
    wide: float
    batch: float
    ratio: float


def measure(system: str, lanes: int = 8, rounds: int = 15, seconds: float = 1.0) -> Batch:
    """Raises RuntimeError if it does not compile or a state is singular."""
    with tempfile.TemporaryDirectory() as name:
        program = _build(system, Path(name))
        first = _run(program, lanes, 1, 20)[0]
        calls = max(1, int(seconds * 1e9 / (rounds * lanes * sum(first))))
        rows = _run(program, lanes, rounds, calls)
    plain, wide, batch = (statistics.median(column) for column in zip(*rows, strict=True))
    return Batch(system, lanes, plain, wide, batch, statistics.median(row[2] / row[0] for row in rows))


def _build(system: str, folder: Path) -> Path:
    sources = nhc_sources(system, only=("rhs", "rhs_batch"), trig="inline")
    model = [path for path in write(sources, folder) if path.endswith(".c")]
    sizes = names(system)
    given = states(system, sum(map(len, sizes)))
    main = folder / "batch_main.c"
    main.write_text(
        _MAIN.format(
            size=len(given[0]),
            states=len(given),
            most=max(LANES),
            rows=",\n".join("{" + ", ".join(map(repr, state)) + "}" for state in given),
            parameters=", ".join(map(repr, parameters(system))),
        )
    )
    objects = []
    for label, flags in (("plain", ("-O3",)), ("wide", WIDE)):
        target = folder / f"{label}.o"
        renames = [f"-D{system}_{function}={label}_{function}" for function in ("rhs", "rhs_batch")]
        tables = [f"-D{system}_{table}_names={label}_{table}_names" for table in ("coordinate", "state", "parameter")]
        tables.append(f"-D{system}_parameter_defaults={label}_parameter_defaults")
        command = [COMPILER, "-std=c99", *flags, *renames, *tables, "-c", *model, "-o", str(target)]
        subprocess.run(command, check=True, capture_output=True)
        objects.append(str(target))
    return compile_c([str(main), *objects], folder / "batch", ("-std=c99", "-O2"))


def _run(program: Path, lanes: int, rounds: int, calls: int) -> list[list[float]]:
    done = subprocess.run([str(program), str(lanes), str(rounds), str(calls)], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"a state of {program} is singular")
    return [[float(word) for word in line.split()] for line in done.stdout.splitlines()]


def main(systems: tuple[str, ...] = ()) -> None:
    print(f"{'system':12}{'lanes':>6}{'rhs -O3 ns':>12}{'rhs wide ns':>12}{'batch ns':>12}{'batch/rhs':>11}")
    for system in systems or SYSTEMS:
        for lanes in LANES:
            made = measure(system, lanes)
            print(
                f"{system:12}{lanes:6}{made.plain:12.2f}{made.wide:12.2f}{made.batch:12.2f}{made.ratio:11.3f}",
                flush=True,
            )


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
