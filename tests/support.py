"""Emitted models, compiled and loaded, for tests."""

from __future__ import annotations

import contextlib
import ctypes
import importlib.util
import json
import os
import pty
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from nhc import pipeline
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options

ROOT = Path(__file__).resolve().parent.parent
SPECS = ROOT / "specs"
GALLERY = tuple(sorted(path.stem for path in SPECS.glob("*.yaml")))
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")
# nhc as somebody at a terminal has it: a shell starts background jobs with interrupts ignored, and children inherit that
_RESTORE = (
    "import os, signal, sys; signal.signal(signal.SIGINT, signal.SIG_DFL); os.execv(sys.executable, sys.argv[1:])"
)
INTERRUPTIBLE = (sys.executable, "-c", _RESTORE, sys.executable, "-m", "nhc")
MOVED = re.compile(rb"\r\[#+\.+\] ")
COMPILER = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang") or "cc"
# What compiles soonest, where nothing depends on how: IEEE arithmetic as it is written; clang takes half of gcc's time.
QUICK = shutil.which("clang") or COMPILER
UNOPTIMISED = ("-O0", "-ffp-contract=off")


needs_full = pytest.mark.skipif(sys.platform != "linux", reason="/dev/full, which takes nothing, is Linux's")


def seldom(*values: Any) -> Any:
    """A case of a parametrised test that is one of many and takes long."""
    return pytest.param(*values, marks=pytest.mark.slow)


def both_ways(*cases: Any) -> list[Any]:
    """Each case of a method, or of a method and more, compiled and in plain Python, where radau5 is slow."""
    found = []
    for case in cases:
        values = case if isinstance(case, tuple) else (case,)
        plain = seldom if values[0] == "radau5" else pytest.param
        found += [pytest.param(*values, True), plain(*values, False)]
    return found


def interrupt(*arguments: str) -> tuple[int, str]:
    """(exit code, what the terminal shows) of nhc, interrupted by a SIGINT as soon as its bar has moved."""
    screen, terminal = pty.openpty()
    with subprocess.Popen([*INTERRUPTIBLE, *arguments], cwd=ROOT, stderr=terminal) as process:
        os.close(terminal)
        seen = b""
        while not MOVED.search(seen):
            seen += os.read(screen, 4096)  # ends with an error if the run ends first
        process.send_signal(signal.SIGINT)
        with contextlib.suppress(OSError):  # the terminal's end
            while more := os.read(screen, 4096):
                seen += more
        code = process.wait(timeout=60)
    os.close(screen)
    return code, seen.decode()


def hide_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    """As where NumPy is not installed: studies are imported anew, and later tests get back the modules that they had."""
    import nhc
    import nhc.study

    for name in [name for name in sys.modules if name.startswith("nhc.study")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr(nhc, "study", nhc.study)  # an import puts the new module there, too
    monkeypatch.setitem(sys.modules, "numpy", None)


def reference(name: str) -> list[dict[str, Any]]:
    return json.loads((ROOT / "tests" / "reference" / f"{name}.json").read_text())


def spec_path(name: str) -> Path:
    return SPECS / f"{name}.yaml"


@cache
def formulations(name: str) -> tuple[str, ...]:
    """The formulations that apply to a gallery system."""
    return tuple(f.name for f in applicable(resolve(decode(read(str(spec_path(name)))))))


def cases(names: tuple[str, ...] | list[str]) -> list[Any]:
    return [pytest.param(n, f, id=f"{n}-{f}") for n in names for f in formulations(n)]


def python_model(text: str, name: str) -> ModuleType:
    """A module from emitted Python text."""
    spec = importlib.util.spec_from_loader(f"emitted_{name}", loader=None)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[module.__name__] = module
    exec(compile(text, f"{name}.py", "exec"), module.__dict__)
    return module


@dataclass
class CModel:
    """Emitted C through ctypes; functions take and return lists, a nonzero status raises."""

    name: str
    library: ctypes.CDLL
    sizes: dict[str, int]

    def __call__(self, function: str, size: int, t: float, *arrays: Any) -> list[float]:
        out = (ctypes.c_double * max(size, 1))()
        call = getattr(self.library, f"{self.name}_{function}")
        call.restype = ctypes.c_int
        status = call(ctypes.c_double(t), *(doubles(a) for a in arrays), out)
        if status:
            raise ArithmeticError(status)
        return list(out[:size])

    def energy(self, t: float, y: Any, p: Any) -> float:
        call = getattr(self.library, f"{self.name}_energy")
        call.restype = ctypes.c_double
        return float(call(ctypes.c_double(t), doubles(y), doubles(p)))

    def defaults(self, count: int) -> list[float]:
        return list((ctypes.c_double * max(count, 1)).in_dll(self.library, f"{self.name}_parameter_defaults"))[:count]


def doubles(values: Any) -> Any:
    values = [float(x) for x in values]
    return (ctypes.c_double * max(len(values), 1))(*values)


def compile_c(
    files: dict[str, str], folder: Path, name: str, flags: tuple[str, ...] = (), *, library: bool = True
) -> Path:
    """Compile emitted C strictly; returns the shared library, or the program with the driver.

    Flags that ask for no level mean the quickest.  What a compiler warns of when it optimises is seen in the golden files, which
    are compiled with -O2, and in ``test_emit_c`` and ``test_emit_driver``, where each compiler takes every kind of program.
    """
    levels = any(flag.startswith("-O") for flag in flags)
    command = (COMPILER, *flags) if levels else (QUICK, *UNOPTIMISED, *flags)
    for file, text in files.items():
        (folder / file).write_text(text)
    target = folder / (f"lib{name}.so" if library else name)
    sources = [str(folder / f) for f in files if f.endswith(".c") and not (library and f.endswith("_main.c"))]
    shared = ("-shared", "-fPIC") if library else ()
    done = subprocess.run(
        [*command, *STRICT, *shared, *sources, "-lm", "-o", str(target)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return target


# Derivations and programs of the last specs: what is printed of them reads nothing else, and these options are for printers only.
_MADE = {stage: lru_cache(kept)(getattr(pipeline, stage)) for stage, kept in (("derivation", 4), ("program", 128))}


@contextlib.contextmanager
def made_once() -> Iterator[None]:
    """Within, what is printed of one spec in several languages is derived once."""
    with pytest.MonkeyPatch.context() as patch:
        for stage, make in _MADE.items():
            patch.setattr(
                pipeline,
                stage,
                lambda source, options, make=make: make(source, replace(options, to="text", array="", trig="")),
            )
        yield


@cache
def emitted(name: str, language: str, options: Options) -> dict[str, str]:
    """File name -> text of a gallery system."""
    with made_once():
        return pipeline.emit(read(str(spec_path(name))), language, options)


def c_model(name: str, formulation: str, folder: Path, flags: tuple[str, ...] = ()) -> CModel:
    """A gallery system through emitted C."""
    files = emitted(name, "c", Options(formulation=formulation))
    path = compile_c(files, folder, name, flags)
    return CModel(name, ctypes.CDLL(str(path)), {})


def emitted_python(name: str, formulation: str = "", array: str = "") -> ModuleType:
    (text,) = emitted(name, "python", Options(formulation=formulation, array=array)).values()
    return python_model(text, name)


def error(found: Any, expected: Any) -> float:
    """Largest difference, relative to the larger of 1 and the largest expected entry."""
    found, expected = [float(x) for x in found], [float(x) for x in expected]
    assert len(found) == len(expected)
    scale = max([1.0, *(abs(x) for x in expected)])
    return max([abs(a - b) / scale for a, b in zip(found, expected, strict=True)], default=0.0)
