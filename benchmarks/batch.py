"""``rhs_batch`` (``--trig inline``) per state beside the scalar ``rhs``, with libm's sine and cosine and with the inlined ones.

``python -m benchmarks.batch [SYSTEM...]``.  One C program, all three interleaved; of many short rounds the quickest counts,
since other work on the machine only adds.  The scalar functions are compiled with plain ``-O3`` (what a user gets without
thinking); the batch with ``-O3`` and the machine's own vectors.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

from benchmarks.models import COMPILER, compile_c, names, nhc_sources, parameters, states, write

SYSTEMS = ("sleigh", "disk", "trailers5", "trailers20", "snake5", "snake20", "pendulum5", "bicycle")
LANES = (8, 256)
WIDE = ("-O3", "-march=native", "-ffp-contract=fast", "-fno-math-errno", "-fno-trapping-math")

_MAIN = """\
#define _POSIX_C_SOURCE 199309L
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#define SIZE {size}
#define STATES {states}
int plain_rhs(double t, const double *y, const double *p, double *dydt);
int inline_rhs(double t, const double *y, const double *p, double *dydt);
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
                bad |= inline_rhs(0.0, single + i * SIZE, P, out + i * SIZE);
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
    """Nanoseconds per state: scalar with libm, scalar with inlined sine and cosine, batch of ``lanes`` states."""

    system: str
    lanes: int
    plain: float
    inline: float
    batch: float

    @property
    def ratio(self) -> float:
        """Batch against scalar with libm."""
        return self.batch / self.plain


def measure(system: str, lanes: int = 8, rounds: int = 200, seconds: float = 1.0) -> Batch:
    """Raises RuntimeError if it does not compile or a state is singular."""
    with tempfile.TemporaryDirectory() as name:
        program = _build(system, Path(name))
        first = _run(program, lanes, 1, 20)[0]
        calls = max(1, int(seconds * 1e9 / (rounds * lanes * sum(first))))
        rows = _run(program, lanes, rounds, calls)
    plain, inline, batch = (min(column) for column in zip(*rows, strict=True))
    return Batch(system, lanes, plain, inline, batch)


def _build(system: str, folder: Path) -> Path:
    models = {}
    for trig in ("", "inline"):
        paths = write(nhc_sources(system, only=("rhs", "rhs_batch"), trig=trig), folder / f"trig_{trig}")
        models[trig] = [path for path in paths if path.endswith(".c")]
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
    for label, trig, flags in (("plain", "", ("-O3",)), ("inline", "inline", ("-O3",)), ("wide", "inline", WIDE)):
        target = folder / f"{label}.o"
        renames = [f"-D{system}_{function}={label}_{function}" for function in ("rhs", "rhs_batch")]
        tables = [f"-D{system}_{table}_names={label}_{table}_names" for table in ("coordinate", "state", "parameter")]
        tables.append(f"-D{system}_parameter_defaults={label}_parameter_defaults")
        command = [COMPILER, "-std=c99", *flags, *renames, *tables, "-c", *models[trig], "-o", str(target)]
        subprocess.run(command, check=True, capture_output=True)
        objects.append(str(target))
    return compile_c([str(main), *objects], folder / "batch", ("-std=c99", "-O2"))


def _run(program: Path, lanes: int, rounds: int, calls: int) -> list[list[float]]:
    done = subprocess.run([str(program), str(lanes), str(rounds), str(calls)], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"a state of {program} is singular")
    return [[float(word) for word in line.split()] for line in done.stdout.splitlines()]


def main(systems: tuple[str, ...] = ()) -> None:
    heads = f"{'libm ns':>12}{'inline ns':>12}{'batch ns':>12}{'batch/libm':>11}{'batch/inline':>13}"
    print(f"{'system':12}{'states':>7}{heads}")
    for system in systems or SYSTEMS:
        for lanes in LANES:
            made = measure(system, lanes)
            times = f"{made.plain:12.2f}{made.inline:12.2f}{made.batch:12.2f}"
            print(f"{system:12}{lanes:7}{times}{made.ratio:11.3f}{made.batch / made.inline:13.3f}", flush=True)


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
