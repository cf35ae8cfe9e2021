"""Right-hand sides in C: emitted by nhc and written by hand, compiled, called and counted."""

from __future__ import annotations

import ctypes
import math
import random
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from benchmarks.systems import spec, split_name
from nhc.diagnostics import Source
from nhc.mechanics.values import parameter_value
from nhc.pipeline import Options, emit, model, program

HAND = Path(__file__).resolve().parent / "hand"
COMPILER = shutil.which("gcc") or shutil.which("cc") or "cc"
FLAGS = ("-std=c99", "-O3")
_STATES = 8


@dataclass(frozen=True)
class Sources:
    """C files of one right-hand side ``int <function>(double t, const double *y, const double *p, double *dydt)``."""

    function: str
    files: dict[str, str]
    flags: tuple[str, ...] = ()


def nhc_sources(
    name: str,
    style: str = "positions",
    *,
    velocities: bool = True,
    only: tuple[str, ...] = ("rhs",),
    trig: str = "",
) -> Sources:
    """What ``nhc emit --lang c --only rhs`` writes, or another choice of functions (empty: all) and of sine and cosine."""
    files = emit(source(name, style, velocities=velocities), "c", Options(only=only, trig=trig))
    return Sources(f"{name}_rhs", files)


def hand_sources(name: str) -> Sources | None:
    """The hand-written right-hand side, if there is one."""
    family, count = split_name(name)
    path = HAND / f"{family}.c"
    if not path.exists():
        return None
    return Sources("hand_rhs", {f"hand_{family}.c": path.read_text(encoding="utf-8")}, (f"-DN={count}",))


def source(name: str, style: str = "positions", *, velocities: bool = True) -> Source:
    return Source(f"{name}.yaml", spec(name, style, velocities=velocities))


def write(sources: Sources, folder: Path) -> list[str]:
    """Write the files; the paths of the C files."""
    folder.mkdir(parents=True, exist_ok=True)
    for file, text in sources.files.items():
        (folder / file).write_text(text, encoding="utf-8")
    return [str(folder / file) for file in sources.files if file.endswith(".c")]


def compile_c(paths: list[str], target: Path, flags: tuple[str, ...]) -> Path:
    done = subprocess.run([COMPILER, *flags, *paths, "-lm", "-o", str(target)], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr)
    return target


class Compiled:
    """A right-hand side through ctypes."""

    def __init__(self, sources: Sources, folder: Path, flags: tuple[str, ...] = FLAGS) -> None:
        paths = write(sources, folder)
        shared = compile_c(paths, folder / f"lib{sources.function}.so", (*flags, *sources.flags, "-shared", "-fPIC"))
        self._call = getattr(ctypes.CDLL(str(shared)), sources.function)

    def __call__(self, t: float, y: list[float], p: list[float]) -> list[float]:
        out = (ctypes.c_double * len(y))()
        status = self._call(ctypes.c_double(t), (ctypes.c_double * len(y))(*y), (ctypes.c_double * len(p))(*p), out)
        if status:
            raise ArithmeticError(status)
        return list(out)


def names(name: str, style: str = "positions", *, velocities: bool = True) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Coordinates and kept velocities of nhc's model, in the state's order."""
    made = program(source(name, style, velocities=velocities), Options(only=("rhs",)))
    count = len(made.coordinates)
    return tuple(q.name for q in made.coordinates), tuple(q.name for q in made.state[count:])


def parameters(name: str) -> list[float]:
    """The spec's parameter values."""
    return [parameter_value(p.value) for p in model(source(name)).spec.parameters]


def states(name: str, size: int, count: int = _STATES) -> list[list[float]]:
    """Random states at which every system here is regular: angles up to 0.8, rates up to 1; the disk leans near 1.2."""
    draw = random.Random(f"nhc {name}")
    family, links = split_name(name)
    coordinates = {"sleigh": 3, "disk": 5, "trailers": links + 4, "snake": links + 2, "pendulum": links + 1}
    half = coordinates.get(family, 9)
    made = []
    for _ in range(count):
        y = [draw.uniform(-0.8, 0.8) if i < half else draw.uniform(-1, 1) for i in range(size)]
        if family == "disk":
            y[3] = draw.uniform(0.8, 1.6)
        if family == "bicycle":
            y[2], y[5], y[6] = draw.uniform(-0.35, -0.25), draw.uniform(-0.1, 0.1), draw.uniform(-0.6, 0.6)
        made.append(y)
    return made


def difference(found: list[float], expected: list[float]) -> float:
    """Largest difference, relative to the larger of 1 and the largest expected entry."""
    if not all(map(math.isfinite, found)):
        return math.inf
    scale = max(1.0, *(abs(x) for x in expected))
    return max(abs(a - b) / scale for a, b in zip(found, expected, strict=True))
