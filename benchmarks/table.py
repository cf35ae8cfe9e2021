"""The published table: rows with a target and whether it is met, and the machine they were measured on."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from benchmarks.models import COMPILER
from benchmarks.systems import ROOT

PAGE = ROOT / "docs" / "performance.md"
_PACKAGES = ("sympy", "casadi", "pydy", "scipy", "heyoka")


@dataclass(frozen=True)
class Row:
    """``ratio`` against ``target``: at most it, or at least it where ``at_least``; no target, no verdict.

    ``bound`` says that the peer was stopped, so that the ratio is only a bound.
    """

    what: str
    nhc: str
    peer: str
    ratio: float
    target: float | None = None
    at_least: bool = False
    bound: bool = False

    @property
    def met(self) -> bool | None:
        if self.target is None:
            return None
        return self.ratio >= self.target if self.at_least else self.ratio <= self.target


def print_rows(rows: Iterable[Row]) -> list[str]:
    """A Markdown table."""
    lines = ["| what | nhc | peer | ratio | target | met |", "|---|---|---|---|---|---|"]
    for row in rows:
        sign = ">= " if row.at_least else "<= "
        target = "" if row.target is None else f"{sign}{row.target:g}"
        met = {None: "", True: "yes", False: "**no**"}[row.met]
        ratio = f"{'> ' if row.bound else ''}{row.ratio:.0f}" if row.ratio >= 20 else f"{row.ratio:.3f}"
        lines.append(f"| {row.what} | {row.nhc} | {row.peer} | {ratio} | {target} | {met} |")
    return lines


def describe_machine() -> str:
    """Processor, cores, compiler, C library and versions, in one line."""
    compiler = subprocess.run([COMPILER, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[
        0
    ]
    packages = ", ".join(f"{name} {found}" for name in _PACKAGES if (found := _version(name)))
    parts = [
        _processor(),
        f"{os.cpu_count()} cores",
        platform.system(),
        compiler,
        " ".join(platform.libc_ver()).strip(),
        f"Python {platform.python_version()}",
        packages,
    ]
    return "; ".join(part for part in parts if part)


def _processor() -> str:
    info = Path("/proc/cpuinfo")
    if info.exists():
        for line in info.read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return ""


def print_section(text: str, rows: Iterator[Row]) -> list[str]:
    """A section of the page, its rows told as they come."""
    found = []
    for row in rows:
        print(print_rows([row])[-1], file=sys.stderr, flush=True)
        found.append(row)
    return [text, *print_rows(found), ""]
