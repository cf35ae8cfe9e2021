"""How the work of a derivation grows with the number of bodies: counted in calls of functions, which no other load changes."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from itertools import pairwise
from math import log2
from random import Random
from types import FrameType

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.choosing.independence import independence
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.properties.integrability import classify
from nhc.mechanics.regular.trials import ordinary_points
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, check, program
from nhc.program.model import build_program
from nhc.program.plan import factor, solve_factored


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


def steered(count: int) -> str:
    """A snake whose links stand on wheels that are steered: the steering rates are free, each joined to the same two others."""
    every, define, rows = range(1, count + 1), ["x1: x", "y1: y"], []
    for i in every:
        before = i - 1
        if before:
            define.append(f"x{i}: x{before} - a*cos(b{before}) - a*cos(b{i})")
            define.append(f"y{i}: y{before} - a*sin(b{before}) - a*sin(b{i})")
        rows.append(f"- -sin(b{i} + s{i})*x{i}' + cos(b{i} + s{i})*y{i}' = 0")
    squares = " + ".join(f"x{i}'^2 + y{i}'^2 + J*b{i}'^2 + S*(b{i}' + s{i}')^2" for i in every)
    return assemble(
        ["x", "y", *(f"b{i}" for i in every), *(f"s{i}" for i in every)],
        {
            "parameters": "{a: 0.5, J: 0.1, S: 0.01}",
            "define": define,
            "T": f"({squares})/2",
            "constraints": rows,
            "quasi_velocities": ["v: cos(b1 + s1)*x' + sin(b1 + s1)*y'", "w: b1'", *(f"u{i}: s{i}'" for i in every)],
        },
    )


def hung(count: int) -> str:
    """A chain of rods that hangs at both ends."""
    every, define = range(1, count + 1), []
    for i in every:
        x, y = (f"x{i - 1} + ", f"y{i - 1}") if i > 1 else ("", "")
        define += [f"x{i}: {x}l*sin(b{i})", f"y{i}: {y}-l*cos(b{i})"]
    return assemble(
        [f"b{i}" for i in every],
        {
            "parameters": "{m: 0.5, l: 0.7, g: 9.81}",
            "define": define,
            "T": "m/2*(" + " + ".join(f"x{i}'^2 + y{i}'^2" for i in every) + ")",
            "V": "m*g*(" + " + ".join(f"y{i}" for i in every) + ")",
            "holonomic": [f"- x{count} = {0.5 * count}", f"- y{count} = 0"],
        },
    )


def ends(count: int) -> str:
    """Rods by the coordinates of their ends, one after the other, with masses there."""
    every, rows = range(1, count + 1), ["- x1^2 + y1^2 = l^2"]
    rows += [f"- (x{i} - x{i - 1})^2 + (y{i} - y{i - 1})^2 = l^2" for i in every[1:]]
    return assemble(
        [f"{name}{i}" for i in every for name in "xy"],
        {
            "parameters": "{m: 0.5, l: 0.7, g: 9.81}",
            "T": "m/2*(" + " + ".join(f"x{i}'^2 + y{i}'^2" for i in every) + ")",
            "V": "m*g*(" + " + ".join(f"y{i}" for i in every) + ")",
            "holonomic": rows,
        },
    )


def operations(text: str, name: str = "rhs") -> int:
    made = program(Source("many.yaml", text), Options(only=(name,))).functions
    return sum(f.adds + f.multiplications + f.divisions for f in made if f.name == name)


@pytest.mark.slow
def test_steered_links_cost_the_same_each() -> None:
    """Two velocities meet all others, and these meet nothing else: taken last they leave no entries behind.

    Written out, the sums along such a chain would double with every link.
    """
    four, eight, sixteen = (operations(steered(n)) for n in (4, 8, 16))
    assert sixteen - eight <= 2.1 * (eight - four)
    assert growth(steered, 8) < 1.4


def without_velocities(text: Callable[[int], str]) -> Callable[[int], str]:
    """The same system, with velocities that nhc has to choose."""
    return lambda count: re.sub(r"(?m)^quasi_velocities:\n(?:  .*\n)*", "", text(count))


def snake(count: int, rows: list[str], parameters: str) -> str:
    """Links behind one another, b_i their directions, with the constraints ``rows``."""
    every, define = range(1, count + 1), ["x1: x", "y1: y"]
    for i in every[1:]:
        define.append(f"x{i}: x{i - 1} - a*cos(b{i - 1}) - a*cos(b{i})")
        define.append(f"y{i}: y{i - 1} - a*sin(b{i - 1}) - a*sin(b{i})")
    return assemble(
        ["x", "y", *(f"b{i}" for i in every)],
        {
            "parameters": parameters,
            "define": define,
            "T": "(" + " + ".join(f"x{i}'^2 + y{i}'^2 + J*b{i}'^2" for i in every) + ")/2",
            "constraints": rows,
        },
    )


def apart(count: int, sign: str = "-") -> str:
    """A snake whose wheels stand behind the middles of their links, or before them: its tail then swings out ever more."""
    rows = [
        f"- -sin(b{i})*(x{i} {sign} e*cos(b{i}))' + cos(b{i})*(y{i} {sign} e*sin(b{i}))' = 0"
        for i in range(1, count + 1)
    ]
    return snake(count, rows, "{a: 0.5, J: 0.1, e: 0.2}")


def seldom(count: int) -> str:
    """A snake with wheels under every third link: constraints leave many velocities, each on what is behind it."""
    rows = [f"- -sin(b{i})*x{i}' + cos(b{i})*y{i}' = 0" for i in range(1, count + 1, 3)]
    return snake(count, rows, "{a: 0.5, J: 0.1}")


@pytest.mark.slow
def test_recursions_side_by_side_stay_linear() -> None:
    """Velocities, and what constraints make of them, go from the leaves to the root together, not one after the other."""
    sixteen, thirty_one, forty_six = (operations(seldom(n)) for n in (16, 31, 46))
    assert forty_six - thirty_one <= 1.1 * (thirty_one - sixteen)


@pytest.mark.sample(2)
@pytest.mark.parametrize("text", [ends, seldom], ids=lambda text: text.__name__)
def test_reactions_are_solved_backwards_along_the_constraints(text: Callable[[int], str]) -> None:
    """One vector for each constraint meets all that hangs on it, and 20 rods took 14801 operations."""
    ten, twenty, thirty = (operations(text(n), "reactions") for n in (10, 19, 28))
    assert thirty - twenty <= 1.1 * (twenty - ten)


@pytest.mark.sample(2)
@pytest.mark.parametrize("text", [without_velocities(steered), apart], ids=["steered", "apart"])
def test_velocities_are_chosen_along_the_chain(text: Callable[[int], str]) -> None:
    """The determinant of other velocities may be larger, but they lie at both ends, and nothing is short in them."""
    sizes = [10, 15, 20, 25]
    found = [operations(text(n)) for n in sizes]
    steps = [after - before for before, after in pairwise(found)]
    assert max(steps) <= 1.1 * min(steps), found


@pytest.mark.parametrize("count", [9, 20, 30])
def test_velocities_that_say_what_the_tail_does(count: int) -> None:
    """Those of the head alone leave no digit of a tail that moves 10^7 times as fast: the accelerations had five, or none."""
    system = resolve(decode(Source("many.yaml", apart(count, "+"))))
    frame = formulate(system).frame
    assert frame is not None
    assert independence(system, frame.forms[system.l :], ordinary_points(system)) > 1e-5


@pytest.mark.parametrize("seed", range(20))
def test_any_order_of_pivots_solves_the_same(seed: int) -> None:
    """Matrices with random zeros, and arrows: L D L^T in another order is the solution as a rational function."""
    draw, g = Random(seed), Graph()
    size = draw.randrange(2, 7)
    entry = {(i, j): g.symbol(f"m{i}{j}") for i in range(size) for j in range(i + 1)}
    arrow = seed % 2 == 0
    gone = {(i, j) for i, j in entry if i != j and (j > 0 if arrow else draw.random() < 0.6)}
    matrix = [
        [g.zero if (max(i, j), min(i, j)) in gone else entry[max(i, j), min(i, j)] for j in range(size)]
        for i in range(size)
    ]
    right = [g.symbol(f"r{i}") for i in range(size)]
    factors = factor(g, matrix)
    assert sorted(factors.order) == list(range(size))
    assert not arrow or size < 3 or factors.order[0] != 0
    found = solve_factored(g, factors, right)
    assert are_equal(g, [g.dot(row, found) for row in matrix], right)


def trailers(count: int) -> str:
    """A car and trailers that hang behind the axles: at every level all brackets are independent."""
    every, define, rows = range(1, count + 1), ["x0: x", "y0: y"], ["- -sin(b0)*x' + cos(b0)*y' = 0"]
    for i in every:
        define.append(f"x{i}: x{i - 1} - h*cos(b{i - 1}) - l*cos(b{i})")
        define.append(f"y{i}: y{i - 1} - h*sin(b{i - 1}) - l*sin(b{i})")
        rows.append(f"- -sin(b{i})*x{i}' + cos(b{i})*y{i}' = 0")
    return assemble(
        ["x", "y", "b0", *(f"b{i}" for i in every)],
        {
            "parameters": "{h: 0.3, l: 0.8}",
            "define": define,
            "T": "(" + " + ".join(f"x{i}'^2 + y{i}'^2 + b{i}'^2" for i in (0, *every)) + ")/2",
            "constraints": rows,
            "quasi_velocities": ["v: cos(b0)*x' + sin(b0)*y'", "w: b0'"],
        },
    )


def test_growth_vectors_of_long_trains() -> None:
    """n coordinates with n^2 slopes; each more level of brackets once cost a multiple (an exponent of 2.9)."""

    def study(text: str) -> None:
        system = resolve(decode(Source("many.yaml", text)))
        assert classify(system, formulate(system).frame).growth[:4] == (2, 3, 5, 8)

    assert growth(trailers, 8, study) < 2.2


def four_bars(count: int) -> str:
    """Two cranks and a coupler each, closed over the ground, with springs from one to the next."""
    every, energy, rows = range(1, count + 1), [], []
    for i in every:
        energy.append(f"a{i}'^2 + b{i}'^2/2 + c{i}'^2 + a{i}'*b{i}'*cos(a{i} - b{i})")
        rows.append(f"- cos(a{i}) + 2*cos(b{i}) - cos(c{i}) = 2.5")
        rows.append(f"- sin(a{i}) + 2*sin(b{i}) - sin(c{i}) = 0")
    potential = [*(f"sin(a{i})" for i in every), *(f"(a{i + 1} - a{i})^2/2" for i in every[:-1])]
    return assemble(
        [f"{name}{i}" for i in every for name in "abc"],
        {"T": " + ".join(energy), "V": " + ".join(potential), "holonomic": rows},
    )


@pytest.mark.slow
def test_what_check_asks_of_closed_loops() -> None:
    """Positions where they close took steps with full matrices, and each loop's integral was held against all before it."""

    def examine(text: str) -> None:
        assert not check(Source("many.yaml", text), explain=False).diagnostics

    assert growth(four_bars, 8, examine) < 1.6


@pytest.mark.slow
def test_coframes_are_sought_among_few_sets_of_columns() -> None:
    """Two rows on n columns have n^3/6 sets of minors."""
    assert growth(hung, 12) < 1.6


@pytest.mark.slow
@pytest.mark.parametrize("text", [discs, balls], ids=lambda text: text.__name__)
def test_the_derivation_of_many_bodies_is_about_linear(text: Callable[[int], str]) -> None:
    """What one body's equations need is not asked of every other body's forms."""
    assert growth(text, 6) < 1.35
