"""Compiled models in a cache: the same sources, flags and compiler give the same file, and it is made once.

The cache is ``$NHC_CACHE``, else ``nhc`` in the user's cache folder (``$XDG_CACHE_HOME`` or ``~/.cache``).  An
entry is a folder named by the hash of everything that went into it; it appears by a rename, so that it is whole or
not there, and its library is loaded only where its hash is the one that the entry has beside it.  Where the user's cache folder
cannot be used, as in a container, models are compiled for one process each; a folder that ``$NHC_CACHE`` names must do.
"""

from __future__ import annotations

import atexit
import hashlib
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

from nhc.kept import clear, hash_of, keep, recall
from nhc.resources import cache_folder

FAST_FLAGS = ("-O2", "-fno-math-errno", "-fno-trapping-math")
FLAGS = ("-std=c99", "-fPIC", "-shared", "-fvisibility=hidden", *FAST_FLAGS)
HASTY_FLAGS = ("-O0", "-ffp-contract=off")
"""After FLAGS: code as it is written, in a fifth of the time; the second is gcc's own default there, and not clang's."""
TIME_LIMIT = 600.0  # seconds


class CompileError(Exception):
    """There is no compiler, or it refuses the emitted source; ``missing`` says which."""

    def __init__(self, message: str, missing: bool = False) -> None:
        super().__init__(message)
        self.missing = missing


class CacheError(CompileError):
    """There is no place for what the compiler would make."""


def tell_why(error: CompileError) -> str:
    """The reason for a note, which has no line of help."""
    return f"{error} (`NHC_CACHE` may name another folder)" if isinstance(error, CacheError) else str(error)


def find_compiler() -> tuple[str, ...]:
    """The compiler's path and the arguments that ``$CC`` has behind it, as in ``ccache gcc``; empty where there is none.

    Where ``$CC`` is set nothing else is looked for: who names a compiler does not want another one's code.
    """
    named = os.environ.get("CC", "").strip()
    for name in (named,) if named else ("cc", "gcc", "clang"):
        for words in ([name], _split(name)):
            found = shutil.which(words[0]) if words else None
            if found:  # by its whole path, since it is called from other folders
                return os.path.abspath(found), *words[1:]
    return ()


def _split(command: str) -> list[str]:
    try:
        return shlex.split(command)
    except ValueError:  # a quote that is not closed
        return []


def _tell_missing() -> str:
    named = os.environ.get("CC", "").strip()
    return (
        f"no C compiler: `CC` names `{named}`, which is not found"
        if named
        else "no C compiler (looked for cc, gcc, clang)"
    )


@cache
def compiler_version(compiler: tuple[str, ...]) -> str:
    """What the compiler says of itself."""
    try:
        done = subprocess.run(
            [*compiler, "--version"], capture_output=True, text=True, errors="replace", timeout=30, check=False
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise CompileError(f"`{shlex.join(compiler)} --version` fails: {_tell(error)}", missing=True) from error
    return done.stdout + done.stderr


def _tell(error: Exception) -> str:
    return (error.strerror or str(error)) if isinstance(error, OSError) else "it does not end"


@cache
def machine_flags() -> tuple[str, ...]:
    """Flags for what this processor has; 128-bit vectors, for wider ones stall on the stages' small loops."""
    if {"avx2", "bmi1", "bmi2", "fma", "movbe", "f16c"} <= _list_features():
        return ("-march=x86-64-v3", "-mprefer-vector-width=128")
    return ()


@cache
def _list_features() -> frozenset[str]:
    if platform.machine() != "x86_64":
        return frozenset()
    try:
        return frozenset(Path("/proc/cpuinfo").read_text().split("flags", 1)[1].split("\n", 1)[0].split())
    except (OSError, IndexError):
        return frozenset()


def build(sources: Mapping[str, str], unit: str, flags: Sequence[str] = ()) -> Path:
    """The shared library of the translation unit ``unit``, one of ``sources`` (file name -> text).

    Raises:
        CompileError: no compiler, or the source does not compile.
    """
    compiler = find_compiler()
    if not compiler:
        raise CompileError(_tell_missing(), missing=True)
    options = (*FLAGS, *_accepted(compiler, machine_flags()), *flags)
    entry = Path(_key(sources, unit, options, compiler)) / f"{Path(unit).stem}.so"
    try:
        return _made(sources, unit, (*compiler, *options), _own_cache() / entry)
    except CacheError as error:
        if os.environ.get("NHC_CACHE"):
            raise
        return _made(sources, unit, (*compiler, *options), _passing_folder(error) / entry)


def tell_passing(library: Path) -> tuple[str, ...]:
    """A note where a library is there for this process only."""
    reason = _passing.get(library.parents[1])
    return (f"{tell_why(reason)}; compiled for this run only",) if reason else ()


def _own_cache() -> Path:
    try:
        return cache_folder()
    except OSError as error:
        raise CacheError(f"no place for a cache: {error.strerror}") from error


def _made(sources: Mapping[str, str], unit: str, command: Sequence[str], library: Path) -> Path:
    """The library, compiled unless it is there."""
    if not _is_whole(library):
        _compile(sources, unit, command, library)
    if not runs_from(library):
        raise CacheError(f"nothing can be run from the cache `{library.parents[1]}`: it is mounted `noexec`")
    return library


def runs_from(place: Path) -> bool:
    """Whether libraries of the file system of ``place``, which is there, can be loaded, as far as can be told."""
    return not (hasattr(os, "ST_NOEXEC") and os.statvfs(place).f_flag & os.ST_NOEXEC)


_passing: dict[Path, CacheError] = {}
"""The folder for models of this process, once there is one, and why there is one."""


def _passing_folder(reason: CacheError) -> Path:
    """A folder that is removed when this process ends."""
    if not _passing:
        try:
            _passing[Path(tempfile.mkdtemp(prefix="nhc-"))] = reason
        except OSError:
            raise reason from None
        atexit.register(_remove_passing, os.getpid())
    return next(iter(_passing))


def _remove_passing(process: int) -> None:
    """Not by a child, which has the same list."""
    if os.getpid() == process:
        shutil.rmtree(next(iter(_passing)), ignore_errors=True)


def try_out() -> None:
    """Compile a small unit as models are compiled, and keep nothing of it.

    Raises:
        CompileError: no compiler, or it makes no library.
    """
    compiler = find_compiler()
    if not compiler:
        raise CompileError(_tell_missing(), missing=True)
    with tempfile.TemporaryDirectory() as folder:
        unit = {"one.c": "int one(void);\nint one(void) { return 1; }\n"}
        _compile(unit, "one.c", (*compiler, *FLAGS), Path(folder) / "entry" / "one.so")


def _is_whole(library: Path) -> bool:
    """Whether a library is what the compiler made.

    A crash of the machine may leave a part of it, of which the loader may make a crash or other numbers, and what clears old files
    away may leave its folder without it.
    """
    try:
        return recall(_mark(library)) == hash_of(library.read_bytes())
    except OSError:
        return False


def _mark(library: Path) -> Path:
    """The file that holds the library's hash."""
    return library.with_suffix(".sha256")


def loop_flags(states: int) -> tuple[str, ...]:
    """Flags for a run with one state of this size: the loops over its entries are unrolled; only long ones get vectors.

    The right-hand side stores single numbers, and a load of two of them right after that waits.  Measured on five systems with
    gcc 12 and dop853: 1.0 to 1.15 times as fast as -O3 with 5 to 10 entries, and less to compile.
    """
    if not machine_flags():
        return ()
    return (
        ("-fno-tree-vectorize", "-fpeel-loops", "-frename-registers")
        if states < 12
        else ("-O3", "-fno-tree-slp-vectorize")
    )


@cache
def lane_flags(states: int) -> tuple[str, ...]:
    """Flags for a run with many starts of this size side by side: eight lanes where the processor has the vectors for them."""
    wide = ("-march=x86-64-v4", "-mprefer-vector-width=128")
    known = {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"} <= _list_features()
    return (
        *(_accepted(find_compiler(), wide) if known else ()),
        *(("-fpeel-loops",) if machine_flags() and states < 12 else ()),
    )


@cache
def _accepted(compiler: tuple[str, ...], wanted: tuple[str, ...]) -> tuple[str, ...]:
    """The flags where the compiler takes them."""
    if not wanted:
        return ()
    try:
        done = subprocess.run(
            [*compiler, *wanted, "-Werror", "-E", "-x", "c", os.devnull], capture_output=True, timeout=30, check=False
        )
    except (OSError, subprocess.TimeoutExpired):
        return ()
    return wanted if done.returncode == 0 else ()


def _key(sources: Mapping[str, str], unit: str, options: Sequence[str], compiler: tuple[str, ...]) -> str:
    digest = hashlib.sha256()
    parts = [unit, *compiler[1:], *options, compiler_version(compiler), sys.platform, platform.machine()]
    for name in sorted(sources):
        parts += [name, sources[name]]
    for part in parts:
        digest.update(f"{len(part)}:{part}".encode())
    return digest.hexdigest()[:32]


def _compile(sources: Mapping[str, str], unit: str, command: Sequence[str], library: Path) -> None:
    """Compile in a folder beside the entry and rename it into place; who comes second keeps the first one's."""
    entry = library.parent
    try:
        entry.parent.mkdir(parents=True, exist_ok=True)
        work = Path(tempfile.mkdtemp(prefix=f".{entry.name}.", dir=entry.parent))
    except OSError as error:
        raise _no_place(entry.parent, error) from error
    try:
        try:
            for name, text in sources.items():
                (work / name).write_text(text, encoding="utf-8")
        except OSError as error:
            raise _no_place(entry.parent, error) from error
        done = subprocess.run(
            [*command, unit, "-lm", "-o", library.name],
            cwd=work,
            env={**os.environ, "TMPDIR": str(work)},  # a compiler that is interrupted leaves files
            capture_output=True,
            text=True,
            errors="replace",
            timeout=TIME_LIMIT,
            check=False,
        )
        if done.returncode != 0 or not (work / library.name).exists():
            raise CompileError(f"`{Path(command[0]).name}` does not compile the emitted source: {_tell_failure(done)}")
        try:
            keep(_mark(work / library.name), hash_of((work / library.name).read_bytes()))
            _place(work, library)
            clear(entry.parent)
        except OSError as error:
            raise _no_place(entry.parent, error) from error
    except OSError as error:
        raise CompileError(f"`{command[0]}` does not run: {error.strerror}") from error
    except subprocess.TimeoutExpired as error:
        raise CompileError(f"the compiler takes longer than {TIME_LIMIT:.0f} s") from error
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _place(work: Path, library: Path) -> None:
    """Rename the folder ``work`` to the library's entry; an entry that is not whole makes room for it."""
    try:
        os.rename(work, library.parent)
    except OSError:
        if _is_whole(library):
            return
        broken = Path(tempfile.mkdtemp(prefix=work.name, dir=work.parent))
        try:
            os.rename(library.parent, broken)
            os.rename(work, library.parent)
        finally:
            shutil.rmtree(broken, ignore_errors=True)


def _no_place(folder: Path, error: OSError) -> CacheError:
    return CacheError(f"cannot write into the cache `{folder}`: {error.strerror}")


def _tell_failure(done: subprocess.CompletedProcess[str]) -> str:
    """What a compiler that made no library says, else how it ended."""
    lines = [line.strip() for line in done.stderr.splitlines() if line.strip()]
    said = next((line for line in lines if "error" in line), lines[0][:200] if lines else "")
    if said:
        return said
    if done.returncode < 0:
        return f"it was killed by signal {-done.returncode}"
    return f"it ends with status {done.returncode} and without a word" if done.returncode else "it writes no library"
