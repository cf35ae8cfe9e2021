"""Whole processes: wall time of nhc beside Python importing sympy.physics.mechanics; compile times of emitted C.

``python -m benchmarks.process``.  Everything runs from compiled bytecode in a folder of its own, as installed packages do, whatever
the surroundings say about writing it.  Commands are run in turn, round by round, so that a busy machine slows all of them.
"""

from __future__ import annotations

import os
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from benchmarks.models import COMPILER, nhc_sources, write
from benchmarks.systems import ROOT

PYTHON = sys.executable
IMPORT = "import sympy.physics.mechanics"
BICYCLE = str(ROOT / "specs" / "bicycle.yaml")
COMPILED = (
    "sleigh", "disk", *(f"{family}{n}" for family in ("trailers", "snake", "pendulum") for n in (5, 10, 15, 20)), "bicycle",
)  # fmt: skip


@dataclass(frozen=True)
class Walls:
    """Median seconds of each command, derived anew but for ``emit_again``; the size of the bicycle's LaTeX in bytes.

    ``run_first`` compiles the model, ``run_again`` finds it in the cache.
    """

    imported: float
    help: float
    emit_c: float
    emit_again: float
    emit_rhs: float
    emit_latex: float
    run_first: float
    run_again: float
    latex_bytes: int


def measure(rounds: int = 7) -> Walls:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        nhc = [PYTHON, "-m", "nhc"]
        emit = [*nhc, "emit", BICYCLE, "--lang"]
        commands = {
            "imported": [PYTHON, "-c", IMPORT],
            "help": [*nhc, "--help"],
            "emit_c": [*emit, "c", "-o", str(folder / "c"), "--anew"],
            "emit_again": [*emit, "c", "-o", str(folder / "c")],
            "emit_rhs": [*emit, "c", "--only", "rhs", "-o", str(folder / "rhs"), "--anew"],
            "emit_latex": [*emit, "latex", "-o", str(folder / "latex"), "--anew"],
            "run_first": [*nhc, "run", BICYCLE, "-o", str(folder / "run.csv"), "--force"],
            "run_again": [*nhc, "run", BICYCLE, "-o", str(folder / "run.csv"), "--force"],
        }
        walls: dict[str, list[float]] = {key: [] for key in commands}
        for command in commands.values():
            _wall(command, folder)  # warm: bytecode and disk
        for _ in range(rounds):
            for key, command in commands.items():
                if key == "run_first":
                    for library in list((folder / "cache").rglob("*.so")):
                        shutil.rmtree(library.parent)
                walls[key].append(_wall(command, folder))
        latex = sum(path.stat().st_size for path in (folder / "latex").glob("*.tex"))
        return Walls(**{key: statistics.median(values) for key, values in walls.items()}, latex_bytes=latex)


def _wall(command: list[str], folder: Path) -> float:
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    kept = {"PYTHONPYCACHEPREFIX": str(folder / "bytecode"), "NHC_CACHE": str(folder / "cache")}
    environment |= {"PYTHONPATH": str(ROOT), **kept}
    start = time.perf_counter()
    done = subprocess.run(command, capture_output=True, env=environment, text=True)
    spent = time.perf_counter() - start
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}: {done.stderr}")
    return spent


def compile_seconds(system: str, rounds: int = 3) -> float:
    """Least processor seconds of ``cc -O2 -c`` on the emitted C with every function: other work on the machine does not count."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        paths = write(nhc_sources(system, only=()), folder)
        command = [COMPILER, "-std=c99", "-O2", "-c", *paths, "-o", str(folder / "model.o")]
        return min(_processor(command) for _ in range(rounds))


def _processor(command: list[str]) -> float:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    walls = measure()
    print(f"python -c '{IMPORT}' {walls.imported * 1e3:.0f} ms")
    for label, value in (
        ("nhc --help", walls.help),
        ("nhc emit bicycle --lang c", walls.emit_c),
        ("nhc emit bicycle --lang c, again", walls.emit_again),
        ("nhc emit bicycle --lang c --only rhs", walls.emit_rhs),
        ("nhc emit bicycle --lang latex", walls.emit_latex),
        ("nhc run bicycle, compiling", walls.run_first),
        ("nhc run bicycle, again", walls.run_again),
    ):
        print(f"{label:40}{value * 1e3:8.0f} ms{value / walls.imported:8.3f}")
    print(f"LaTeX of the bicycle: {walls.latex_bytes} bytes")
    for system in COMPILED:
        print(f"cc -O2 {system:12}{compile_seconds(system):8.3f} s", flush=True)


if __name__ == "__main__":
    main()
