"""How the work of a derivation grows with the number of bodies: counted in calls of functions, which no other load changes."""

from __future__ import annotations

import sys
from collections.abc import Callable
from math import log2
from types import FrameType

import pytest

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolve import resolve
from nhc.program.model import build_program


def count_calls(run: Callable[[], object]) -> int:
    """Calls of Python functions while it runs."""
    found = 0

    def step(_: FrameType, event: str, __: object) -> None:
        nonlocal found
        found += event == "call"

    before = sys.getprofile()
    sys.setprofile(step)
    try:
        run()
    finally:
        sys.setprofile(before)
    return found


def derive(text: str) -> None:
    """From the text to the program of the right-hand side."""
    system = resolve(decode(Source("many.yaml", text)))
    formulation = formulate(system)
    build_program(system, formulation, equations_of(system, formulation), ("rhs",), scenes=False)


def growth(text: Callable[[int], str], size: int, run: Callable[[str], None] = derive) -> float:
    """The exponent with which calls grow from ``size`` bodies to twice as many."""
    return log2(count_calls(lambda: run(text(2 * size))) / count_calls(lambda: run(text(size))))


def assemble(coordinates: list[str], sections: dict[str, list[str] | str]) -> str:
    lines = ["nhc: 1", "system: many"]
    if coordinates:
        lines.append(f"coordinates: [{', '.join(coordinates)}]")
    for key, body in sections.items():
        lines += [f"{key}: {body}"] if isinstance(body, str) else [f"{key}:", *(f"  {line}" for line in body)]
    return "\n".join(lines) + "\n"


def discs(count: int) -> str:
    """Discs that roll on a plane, each joined to the next by a spring between their centres."""
    every, energy, potential, rows, kept = range(1, count + 1), [], [], [], []
    for i in every:
        spin = f"(p{i}' + cos(b{i})*a{i}')"
        energy.append(f"(x{i}'^2 + y{i}'^2 + (R*sin(b{i}))'^2 + A*(b{i}'^2 + (sin(b{i})*a{i}')^2) + C*{spin}^2)/2")
        potential.append(f"g*R*sin(b{i})")
        rows.append(f"- x{i}' + R*cos(a{i})*{spin} - R*sin(b{i})*sin(a{i})*b{i}' = 0")
        rows.append(f"- y{i}' + R*sin(a{i})*{spin} + R*sin(b{i})*cos(a{i})*b{i}' = 0")
        kept += [f"u{i}: b{i}'", f"v{i}: sin(b{i})*a{i}'", f"w{i}: p{i}' + cos(b{i})*a{i}'"]
    potential += [f"k/2*((x{i + 1} - x{i})^2 + (y{i + 1} - y{i})^2)" for i in every[:-1]]
    return assemble(
        [f"{name}{i}" for i in every for name in "xyabp"],
        {
            "parameters": "{R: 0.5, A: 0.06, C: 0.1, g: 9.81, k: 1}",
            "T": " + ".join(energy),
            "V": " + ".join(potential),
            "constraints": rows,
            "quasi_velocities": kept,
        },
    )


def balls(count: int) -> str:
    """Balls that roll on a plane, their orientations as rotations."""
    every, energy, rows = range(1, count + 1), [], []
    for i in every:
        energy.append(f"m/2*(x{i}'^2 + y{i}'^2) + m*a^2/5*(p{i}^2 + q{i}^2 + r{i}^2)")
        rows.append(f"- x{i}' - a*(R{i}_y1*p{i} + R{i}_y2*q{i} + R{i}_y3*r{i}) = 0")
        rows.append(f"- y{i}' + a*(R{i}_x1*p{i} + R{i}_x2*q{i} + R{i}_x3*r{i}) = 0")
    return assemble(
        [f"{name}{i}" for i in every for name in "xy"],
        {
            "rotation": [f"R{i}: {{velocities: [p{i}, q{i}, r{i}]}}" for i in every],
            "parameters": "{m: 0.5, a: 0.1}",
            "T": " + ".join(energy),
            "constraints": rows,
        },
    )


@pytest.mark.parametrize("text", [discs, balls], ids=lambda text: text.__name__)
def test_the_derivation_of_many_bodies_is_about_linear(text: Callable[[int], str]) -> None:
    """What one body's equations need is not asked of every other body's forms."""
    assert growth(text, 6) < 1.35
