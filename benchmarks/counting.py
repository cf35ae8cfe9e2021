"""Machine instructions of one call, counted by callgrind."""

from __future__ import annotations

import re
import subprocess
import tempfile
from pathlib import Path

from benchmarks.models import FLAGS, Sources, compile_c, write

_MAIN = """\
#include <stdlib.h>
int {function}(double t, const double *y, const double *p, double *dydt);
static const double Y[{states}][{size}] = {{
{rows}
}};
static const double P[] = {{{parameters}}};
int main(int argc, char **argv)
{{
    double out[{size}], sum = 0;
    int bad = 0;
    const int rounds = argc > 1 ? atoi(argv[1]) : 1;
    for (int k = 0; k < rounds; k++)
        for (int i = 0; i < {states}; i++) {{
            bad |= {function}(0.0, Y[i], P, out);
            sum += out[{size} - 1];
        }}
    return bad || sum != sum;
}}
"""


def count_instructions(
    sources: Sources, states: list[list[float]], parameters: list[float], flags: tuple[str, ...] = FLAGS
) -> float:
    """Instructions per call, libm's included, averaged over the states.

    Only what runs inside the function is counted, and the count of one round is the difference between 4 and 2
    rounds, so that neither the caller nor the start (dynamic linking) is in it.

    Raises:
        RuntimeError: it does not compile, does not run, or a state is singular.
    """
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        paths = write(sources, folder)
        rows = ",\n".join("{" + ", ".join(repr(x) for x in state) + "}" for state in states)
        text = _MAIN.format(
            function=sources.function,
            states=len(states),
            size=len(states[0]),
            rows=rows,
            parameters=", ".join(repr(x) for x in parameters) or "0",
        )
        main = folder / "count_main.c"
        main.write_text(text, encoding="utf-8")
        program = compile_c([*paths, str(main)], folder / "count", (*flags, *sources.flags))
        return (_collected(program, sources.function, 4) - _collected(program, sources.function, 2)) / (2 * len(states))


def _collected(program: Path, function: str, rounds: int) -> int:
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", f"--toggle-collect={function}"]
    done = subprocess.run([*command, str(program), str(rounds)], capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode or found is None:
        raise RuntimeError(f"callgrind failed on {function}: {done.stderr[-2000:]}")
    return int(found[1])
