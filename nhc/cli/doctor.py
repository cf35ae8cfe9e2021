"""``nhc doctor``: what is there, and what is missing for which verb."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from nhc.cli.options import json_option, verb
from nhc.cli.specs import gallery_paths
from nhc.cli.terminal import Exit, put_json, put_text
from nhc.version import __version__

REQUIRED = ("sympy", "click", "pyyaml", "jinja2")
# extra -> package -> what needs it
EXTRAS = {
    "sim": {"numpy": "`nhc linearize`, `nhc stability`", "scipy": "`nhc stability`, SciPy's methods of `nhc run`"},
    "reference": {"heyoka": "a peer in `nhc chart`"},
    "jax": {"jax": "`nhc emit --lang python --array jax`", "diffrax": "a peer in `nhc chart`"},
    "sundials": {"scikit-sundae": "SUNDIALS's methods of `nhc run`"},
    "bench": {"pydy": "a peer of `make bench`", "casadi": "a peer of `make bench`"},
}
TOOLS = {"cc": "compiles emitted C", "clang": "a second opinion on emitted C", "pdflatex": "typesets emitted LaTeX"}

Row = tuple[str, bool, str]  # name, found, detail


@verb("doctor", "nhc doctor")
@json_option
def command(as_json: bool) -> int:
    """Say what nhc finds on this machine.

    The exit code is 1 when something is missing that nhc cannot do without.
    """
    needed = [
        ("python", True, f"{platform.python_version()} ({sys.executable})"),
        *map(_package, REQUIRED),
        *_folders(),
    ]
    optional = [_tool(name, purpose) for name, purpose in TOOLS.items()] + _runs()
    for extra, packages in EXTRAS.items():
        for package, purpose in packages.items():
            _, found, detail = _package(package)
            optional.append((f"{extra}: {package}", found, detail if found else f"for {purpose}"))
    well = all(found for _, found, _ in needed)
    if as_json:
        rows = {"needed": needed, "optional": optional}
        tree = {key: [{"name": n, "found": f, "detail": d} for n, f, d in value] for key, value in rows.items()}
        put_json("nhc.doctor/1", {"ok": well, **tree})
    else:
        put_text(f"nhc {__version__}")
        for title, rows_ in (("needed", needed), ("optional", optional)):
            put_text(f"\n{title}")
            width = max(len(name) for name, _, _ in rows_)
            for name, found, detail in rows_:
                put_text(f"  {'ok     ' if found else 'missing'}  {name:<{width}}  {detail}".rstrip())
    return Exit.DONE if well else Exit.FAILED


def _package(name: str) -> Row:
    try:
        return name, True, version(name)
    except PackageNotFoundError:
        return name, False, ""


def _folders() -> list[Row]:
    from nhc.resources import find_specs, find_templates

    folders: list[Row] = []
    for name, find in (("templates", find_templates), ("specs", find_specs)):
        try:
            folder: Path = find()
        except FileNotFoundError as error:
            folders.append((name, False, str(error)))
            continue
        detail = f"{folder} ({len(gallery_paths())} specs)" if name == "specs" else str(folder)
        folders.append((name, folder.is_dir(), detail))
    return folders


def _runs() -> list[Row]:
    """The compiler that ``nhc run`` takes, with its flags, and the folder of what is kept with its size."""
    from nhc.simulate.c.compile import CompileError, find_compiler, lane_flags, machine_flags, try_out

    compiler = find_compiler()
    flags = " ".join(machine_flags()) or "no flags for this processor"
    lanes = 8 if any("v4" in flag for flag in lane_flags(0)) else 4
    works, found = True, f"{' '.join(compiler)}; {flags}; {lanes} lanes"
    try:
        try_out()
    except CompileError as error:
        works, found = False, f"{error}; runs are in Python, some hundred times slower"
    return [("compiler of runs", works, found), _cache()]


def _cache() -> Row:
    """Where nhc keeps what it has made, and how much that is."""
    import tempfile

    from nhc.resources import cache_folder
    from nhc.simulate.c.compile import runs_from

    try:
        folder = cache_folder()
    except OSError as error:
        return "cache", False, f"{error.strerror}; `NHC_CACHE` may name a folder"
    models, answers, size_in_bytes = _measure(folder)
    size = f"{models} compiled models, {answers} answers, {size_in_bytes / 1e6:.1f} MB"
    place = next(path for path in (folder, *folder.parents) if path.exists())
    try:
        tempfile.TemporaryFile(dir=place).close()
        trouble = "" if runs_from(place) else "is mounted `noexec`"
    except OSError:
        trouble = "cannot be written"
    if trouble and not os.environ.get("NHC_CACHE"):
        trouble += "; models are compiled for one run each"
    return "cache", not trouble, f"{folder} ({trouble or size})"


def _measure(folder: Path) -> tuple[int, int, int]:
    """(libraries, answers, bytes) below a folder that others may change meanwhile: what has gone does not count."""
    models = answers = size = 0
    for place, _, names in os.walk(folder):
        for name in names:
            try:
                size += os.stat(os.path.join(place, name)).st_size
            except OSError:
                continue
            models += name.endswith(".so")
            answers += name.endswith(".json")
    return models, answers, size


def _tool(name: str, purpose: str) -> Row:
    """Find a program and the first line in which it names its version; ``CC`` takes the place of ``cc``."""
    from nhc.simulate.c.compile import find_compiler

    named = os.environ.get("CC") if name == "cc" else None
    path = shutil.which(name)
    command = find_compiler() if named else (path,) if path else ()
    if not command:
        return name, False, f"{purpose}; no `{named or name}` on the path"
    try:
        done = subprocess.run(
            [*command, "--version"], capture_output=True, text=True, errors="replace", timeout=20, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return name, False, f"{' '.join(command)} does not run"
    if done.returncode:
        return name, False, f"`{' '.join(command)} --version` fails"
    return name, True, (done.stdout.splitlines() or [" ".join(command)])[0]
