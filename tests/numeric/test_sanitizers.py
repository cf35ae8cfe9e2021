"""Emitted C under the address and undefined-behaviour sanitizers, and under both compilers' warnings.

Every function is called on arrays of exactly its sizes from the heap, at ordinary states and at zeros, infinities, NaN and huge
numbers; the driver runs every scene.  Where no compiler has the sanitizers' libraries, each array stands between marks that must
not change.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from nhc.language import decode, read
from nhc.pipeline import Options, emit
from tests.support import COMPILER, GALLERY, STRICT, spec_path

SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-O0", "-g")


def has_sanitizers(compiler: str) -> bool:
    """Whether the compiler is there with the run-time library of its sanitizers (clang's is a package of its own)."""
    if shutil.which(compiler) is None:
        return False
    command = [compiler, *SANITIZERS, "-x", "c", "-", "-o", os.devnull]
    return (
        subprocess.run(command, input=b"int main(void) { return 0; }", capture_output=True, check=False).returncode == 0
    )


FENCED = ("-DFENCED", "-O0", "-g")  # a build that needs no library
COMPILERS = [c for c in ("gcc", "clang", "clang-14") if has_sanitizers(c)][:2]
BUILDS = [(c, SANITIZERS) for c in COMPILERS] or [(COMPILER, FENCED)]
LARGE = ("bicycle", "rattleback")
SYSTEMS = [pytest.param(name, marks=pytest.mark.slow if name in LARGE else ()) for name in GALLERY]
ENVIRONMENT = {**os.environ, "ASAN_OPTIONS": "abort_on_error=0:detect_leaks=0", "UBSAN_OPTIONS": "print_stacktrace=1"}

HARNESS = """
#include "NAME.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NQ = CAPITALS_NQ, NY = CAPITALS_NY, NP = CAPITALS_NP, NC = CAPITALS_NC, NOUT = CAPITALS_NOUT, COUNT = 5, TRIALS = 400 };

static unsigned long long seed = 88172645463325252ULL;

static double draw(int trial)
{
    static const double odd[] = {0.0, -0.0, 1.0, -1.0, 1e-320, 1e-8, 1e8, 1e155, -1e155, 1e308, INFINITY, -INFINITY, NAN};
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    if (trial % 2 == 1 && seed % 3 == 0) {
        return odd[(seed >> 20) % (sizeof odd / sizeof odd[0])];
    }
    return (double)(seed >> 11) / 9007199254740992.0 * 4.0 - 2.0;
}

#ifdef FENCED
enum { FENCE = 1 };
#else
enum { FENCE = 0 };
#endif
static const double MARK = 6.02214076e23;

static double *take(int size, int trial)
{
    double *array = malloc(sizeof(double) * (size_t)(size + 2 * FENCE));
    if (array == NULL) {
        exit(9);
    }
    for (int i = 0; i < size + 2 * FENCE; ++i) {
        array[i] = MARK;
    }
    for (int i = 0; i < size; ++i) {
        array[i + FENCE] = draw(trial);
    }
    return array + FENCE;
}

static void give(double *array, int size)
{
    for (int i = 0; i < FENCE; ++i) {
        if (array[-1 - i] < MARK || array[-1 - i] > MARK || array[size + i] < MARK || array[size + i] > MARK) {
            printf("written beside an array of %d\\n", size);
            exit(6);
        }
    }
    free(array - FENCE);
}

/* A function that says 0 must have written a number to every place. */
static int check(const char *name, int status, const double *out, int size)
{
    for (int i = 0; i < size; ++i) {
        if (status == 0 && !isfinite(out[i])) {
            printf("%s says 0 and gives %g\\n", name, out[i]);
            exit(8);
        }
    }
    return status == 0;
}

int main(void)
{
    int good = 0;
    double sum = 0.0;
    for (int trial = 0; trial < TRIALS; ++trial) {
        double *q = take(NQ, trial), *qdot = take(NQ, trial), *y = take(NY, trial), *p = take(NP, trial);
        double *dydt = take(NY, 0), *rate = take(NQ, 0), *lambda = take(NC, 0), *J = take(NY * NY, 0), *out = take(NOUT, 0);
        double *times = take(COUNT, trial), *states = take(COUNT * NY, trial), *rates = take(COUNT * NY, 0);
        double *f = take(POSITIONS, 0);
        double t = draw(trial);
        if (trial % 4 < 2) {
            for (int i = 0; i < NP; ++i) {
                p[i] = NAME_parameter_defaults[i];
            }
        }
        good += check("rhs", NAME_rhs(t, y, p, dydt), dydt, NY);
        check("velocities", NAME_velocities(t, y, p, rate), rate, NQ);
        check("accelerations", NAME_accelerations(t, y, p, rate), rate, NQ);
        check("residuals", NAME_residuals(t, q, qdot, p, lambda), lambda, NC);
        check("reactions", NAME_reactions(t, y, p, lambda), lambda, NC);
        check("jacobian", NAME_jacobian(t, y, p, J), J, NY * NY);
        check("outputs", NAME_outputs(t, y, p, out), out, NOUT);
        check("state", NAME_state(t, q, qdot, p, y), y, NY);
        CALL_POSITIONS
        sum += NAME_energy(t, y, p);
        check("rhs_batch", NAME_rhs_batch(COUNT, times, states, p, rates), rates, COUNT * NY);
        check("rhs_batch", NAME_rhs_batch(0, times, states, p, rates), rates, 0);
        give(q, NQ), give(qdot, NQ), give(y, NY), give(p, NP), give(dydt, NY), give(rate, NQ), give(lambda, NC);
        give(J, NY * NY), give(out, NOUT), give(times, COUNT), give(states, COUNT * NY), give(rates, COUNT * NY);
        give(f, POSITIONS);
    }
    for (int i = 0; i < NY; ++i) {
        printf("%s ", NAME_state_names[i]);
    }
    for (int i = 0; i < NQ; ++i) {
        printf("%s ", NAME_coordinate_names[i]);
    }
    for (int i = 0; i < NP; ++i) {
        printf("%s ", NAME_parameter_names[i]);
    }
    printf("%d %d\\n", good, sum < 0.0);
    return good > TRIALS / 8 ? 0 : 7;
}
"""


def harness(name: str, header: str, positions: int) -> str:
    """The C program that calls every function of a model."""
    assert (f"{name}_positions" in header) == (positions > 0)
    call = f'check("positions", {name}_positions(t, q, p, f), f, {positions});' if positions else ""
    text = HARNESS.replace("CALL_POSITIONS", call).replace("POSITIONS", str(positions))
    return text.replace("CAPITALS", name.upper()).replace("NAME", name)


def run(command: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, capture_output=True, text=True, cwd=folder, env=ENVIRONMENT, timeout=300)


@pytest.mark.sample(5)
@pytest.mark.parametrize("name", SYSTEMS)
def test_emitted_c_is_clean_under_sanitizers(name: str, tmp_path: Path) -> None:
    source = read(str(spec_path(name)))
    spec = decode(source)
    files = emit(source, "c", Options(driver=bool(spec.scenes)))
    files["harness.c"] = harness(name, files[f"{name}.h"], len(spec.holonomic))
    for file, text in files.items():
        (tmp_path / file).write_text(text, encoding="ascii")
    compiler, flags = BUILDS[-1] if len(name) % 2 else BUILDS[0]  # each sees about half of the gallery
    build = [compiler, "-std=c99", *flags]
    done = run([*build, "-c", f"{name}.c"], tmp_path)
    assert done.returncode == 0, done.stderr
    done = run([*build, "harness.c", f"{name}.o", "-lm", "-o", "harness"], tmp_path)
    assert done.returncode == 0, done.stderr
    done = run(["./harness"], tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    if not spec.scenes:
        return
    done = run([*build, f"{name}_main.c", f"{name}.o", "-lm", "-o", "driver"], tmp_path)
    assert done.returncode == 0, done.stderr
    for scene in spec.scenes:
        done = run(["./driver", scene.name, "3", "1e-3"], tmp_path)
        assert done.returncode == 0, done.stderr
        assert len(done.stdout.splitlines()) == 4
    assert run(["./driver", "no such scene"], tmp_path).returncode == 2


@pytest.mark.parametrize("compiler", sorted({compiler for compiler, _ in BUILDS}))
def test_the_gallery_compiles_without_a_warning(compiler: str, tmp_path: Path) -> None:
    """All systems with their drivers, in one call."""
    sources = []
    for name in GALLERY:
        source = read(str(spec_path(name)))
        for file, text in emit(source, "c", Options(driver=bool(decode(source).scenes))).items():
            (tmp_path / file).write_text(text, encoding="ascii")
            sources += [file] if file.endswith(".c") else []
    done = run([compiler, *STRICT, "-O0", "-fsyntax-only", *sources], tmp_path)
    assert done.returncode == 0, done.stderr
    assert len(sources) >= len(GALLERY)


@pytest.mark.parametrize("place", [-1, 5])
@pytest.mark.parametrize(("compiler", "flags"), [*BUILDS[:1], (COMPILER, FENCED)], ids=["tests", "fenced"])
def test_a_write_beside_an_array_is_seen(compiler: str, flags: tuple[str, ...], place: int, tmp_path: Path) -> None:
    """An output one place too far must fail, else the test above proves nothing."""
    name = "chaplygin_sleigh"
    files = emit(read(str(spec_path(name))), "c")
    last = "    dydt[4] = "
    assert files[f"{name}.c"].count(last) == 1
    files[f"{name}.c"] = files[f"{name}.c"].replace(last, f"    dydt[{place}] = 0.0;\n{last}")
    files["harness.c"] = harness(name, files[f"{name}.h"], 0)
    for file, text in files.items():
        (tmp_path / file).write_text(text, encoding="ascii")
    done = run([compiler, "-std=c99", *flags, "harness.c", f"{name}.c", "-lm", "-o", "harness"], tmp_path)
    assert done.returncode == 0, done.stderr
    done = run(["./harness"], tmp_path)
    assert done.returncode != 0
    assert "written beside an array" in done.stdout if flags == FENCED else "AddressSanitizer" in done.stderr
