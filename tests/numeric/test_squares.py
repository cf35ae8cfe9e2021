"""Energies that were multiplied out: the same rates as of the named positions, in about as many operations."""

from __future__ import annotations

import random
import re
from collections.abc import Callable

import pytest
import sympy

from benchmarks.models import source
from nhc.algebra.bridge import to_sympy
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.energies.kinetic import energy_as_squares, kinetic_structure
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.program.ir import Program
from nhc.program.model import build_program
from tests.support import python_model, spec_path

CRANE = """nhc: 1
system: crane
coordinates: [x, y, l, a, b]
parameters: {M: 5, N: 3, m: 2, J: 0.3, g: 9.81, F: 1}
define:
  px: x + l*sin(a)*cos(b)
  py: y + l*sin(b)
  pz: -l*cos(a)*cos(b)
T: M/2*(x'^2 + y'^2) + N/2*x'^2 + m/2*(px'^2 + py'^2 + pz'^2) + J/2*l'^2
V: m*g*pz
forces: {x: F}
"""
"""A rope of changing length in space: its unit vector holds two other coordinates."""

WALKER = """nhc: 1
system: walker
coordinates: [q1, q2, q3, q4, q5]
parameters: {l: 0.4, c: 0.2, L: 0.3, m: 2, M: 10, I: 0.03, J: 0.3, g: 9.81}
define:
  A2: q1 + q2
  A3: A2 + q3
  A4: A2 + q4
  A5: A4 + q5
  x2: l*sin(q1) + c*sin(A2)
  y2: l*cos(q1) + c*cos(A2)
  hx: l*sin(q1) + l*sin(A2)
  hy: l*cos(q1) + l*cos(A2)
  x3: hx + L*sin(A3)
  y3: hy + L*cos(A3)
  x4: hx - c*sin(A4)
  y4: hy - c*cos(A4)
  x5: hx - l*sin(A4) - c*sin(A5)
  y5: hy - l*cos(A4) - c*cos(A5)
  turning: I*(q1'^2 + A2'^2 + A4'^2 + A5'^2) + J*A3'^2
T: (m*(c^2*q1'^2 + x2'^2 + y2'^2 + x4'^2 + y4'^2 + x5'^2 + y5'^2) + M*(x3'^2 + y3'^2) + turning)/2
V: g*(m*(y2 + y4 + y5) + M*y3)
"""
"""A tree by relative angles: several coordinates turn each link."""


def spherical(count: int) -> str:
    """Spherical pendulums hung on one another."""
    define, squares = [], []
    for k in range(1, count + 1):
        before = [f"{axis}{k - 1} + " if k > 1 else "" for axis in "xyz"]
        turned = (f"l*sin(a{k})*cos(b{k})", f"l*sin(a{k})*sin(b{k})", f"l*cos(a{k})")
        define += [f"  {axis}{k}: {old}{new}" for axis, old, new in zip("xyz", before, turned, strict=True)]
        squares.append(f"x{k}'^2 + y{k}'^2 + z{k}'^2")
    names = ", ".join(f"a{k}, b{k}" for k in range(1, count + 1))
    heights = " + ".join(f"z{k}" for k in range(1, count + 1))
    return "\n".join(
        [
            *("nhc: 1", "system: spherical", f"coordinates: [{names}]", "parameters: {m: 0.7, l: 0.6, g: 9.81}"),
            *("define:", *define, f"T: m/2*({' + '.join(squares)})", f"V: -m*g*({heights})", ""),
        ]
    )


def text_of(name: str) -> str:
    made = {"crane": CRANE, "walker": WALKER, "spherical3": spherical(3)}
    return made[name] if name in made else spec_path(name).read_text(encoding="utf-8")


def multiplied_out(text: str) -> str:
    """The spec with T as a sum of products."""
    return rewritten(text, sympy.expand)


def rewritten(text: str, how: Callable[[sympy.Expr], sympy.Expr]) -> str:
    """The spec with T as SymPy prints it after a rewriting."""
    system = system_of(text)
    energy = how(to_sympy(system.graph, system.T))
    names = {}
    for k, symbol in enumerate(system.graph.symbols):
        own = f"rate_of_{symbol.name}" if symbol.kind == "velocity" else f"name_{symbol.name}"
        names[sympy.Symbol(f"s{k}", real=True)] = sympy.Symbol(own)
    printed = sympy.sstr(energy.xreplace(names)).replace("**", "^")
    printed = re.sub(r"\bname_(\w+)", r"\1", re.sub(r"\brate_of_(\w+)", r"\1'", printed))
    return re.sub(r"(?m)^T:.*\n(?:[ ].*\n)*", f"T: {printed}\n", text)


def system_of(text: str, graph: Graph | None = None) -> System:
    return resolve(decode(Source("spec.yaml", text)), graph)


def program_of(system: System) -> Program:
    formulation = formulate(system)
    return build_program(system, formulation, equations_of(system, formulation), ("rhs",))


def operations(program: Program) -> int:
    (rhs,) = program.functions
    return rhs.adds + rhs.multiplications + rhs.divisions


SUMS, PIECES = ("shared sums",), ("shared sums", "pieces")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "most", "longer", "others"),
    [
        ("n_trailer3", 0.16, 1.0, PIECES),
        ("n_snake3", 0.33, 1.0, PIECES),
        ("suslov", 0.07, 1.0, PIECES),
        ("veselova", 0.29, 1.0, PIECES),
        ("rattleback", 0.46, 1.0, PIECES),
        ("heavy_top", 0.65, 1.0, PIECES),
        ("walker", 0.34, 1.14, SUMS),
        ("spherical3", 0.46, 1.03, SUMS),
    ],
)
def test_the_rates_are_those_of_the_positions_and_as_short(
    name: str, most: float, longer: float, others: tuple[str, ...]
) -> None:
    """``most``: operations against what they are without the rule; ``longer``: against those of the positions.

    The first is counted without ``others``: shared sums and pieces, of which what is multiplied out has more, are other rules'.
    Of pendulums by relative angles pieces are needed either way, as their energy comes back with numbers.
    """
    plain, long = text_of(name), multiplied_out(text_of(name))
    system = system_of(long)
    assert energy_as_squares(system) != system.T
    assert are_equal(system.graph, [energy_as_squares(system)], [system.T])
    expected, found = program_of(system_of(plain)), program_of(system)
    assert operations(found) <= longer * operations(expected)
    alone, before = (
        program_of(system_of(long, WithoutRules([*others, *more]))) for more in ([], ["completed squares"])
    )
    assert operations(alone) <= most * operations(before)
    assert operations(found) < operations(program_of(system_of(long, WithoutRules(["completed squares"]))))
    draw = random.Random(name)
    first, second = (
        python_model(render(program, "python", EmitOptions())[f"{system.name}.py"], system.name)
        for program in (expected, found)
    )
    for _ in range(3):
        y = [draw.uniform(0.3, 1.1) for _ in first.STATE]
        assert second.rhs(0.3, y) == pytest.approx(first.rhs(0.3, y), rel=1e-10, abs=1e-10)


def cart_and_pendulums(count: int) -> str:
    """As books print it, by cosines of differences."""
    bobs = range(1, count + 1)
    terms = [f"(M + {count}*m)/2*x'^2"]
    for i in bobs:
        terms.append(f"{count - i + 1}*m*l^2/2*theta{i}'^2 + {count - i + 1}*m*l*cos(theta{i})*x'*theta{i}'")
        terms += [
            f"{count - j + 1}*m*l^2*cos(theta{i} - theta{j})*theta{i}'*theta{j}'" for j in range(i + 1, count + 1)
        ]
    names = ", ".join(f"theta{i}" for i in bobs)
    heights = " + ".join(f"{count - i + 1}*cos(theta{i})" for i in bobs)
    return (
        f"nhc: 1\nsystem: pendulum{count}\ncoordinates: [x, {names}]\nparameters: {{M: 1.5, m: 0.5, l: 0.7, g: 9.81}}\n"
        f"T: {' + '.join(terms)}\nV: -m*g*l*({heights})\n"
    )


@pytest.mark.parametrize("count", [3, 6])
def test_a_chain_by_cosines_of_differences_is_the_chain_of_its_positions(count: int) -> None:
    expected = program_of(resolve(decode(source(f"pendulum{count}"))))
    found = program_of(system_of(cart_and_pendulums(count)))
    assert operations(found) <= operations(expected)
    first, second = (
        python_model(render(made, "python", EmitOptions())[f"pendulum{count}.py"], f"pendulum{count}")
        for made in (expected, found)
    )
    y = [0.2 + 0.1 * k for k in range(2 * count + 2)]
    assert second.rhs(0.0, y) == pytest.approx(first.rhs(0.0, y), rel=1e-11, abs=1e-11)


def arm(count: int, *, by: str) -> str:
    """An arm in the plane: by its points, or by a matrix as books on robots have it, each entry by masses or by cosines."""
    joints = range(1, count + 1)
    values = {f"{name}{k}": round(0.3 + 0.1 * k + i, 2) for k in joints for i, name in enumerate("mIls")}
    head = (
        f"nhc: 1\nsystem: arm\ncoordinates: [{', '.join(f'q{k}' for k in joints)}]\n"
        f"parameters: {{{', '.join(f'{name}: {value}' for name, value in values.items())}}}\n"
    )

    def turned(i: int, j: int) -> str:
        return "cos(" + " + ".join(f"q{k}" for k in range(i + 1, j + 1)) + ")" if i != j else "1"

    def rate(i: int) -> str:
        return "(" + " + ".join(f"q{k}'" for k in range(1, i + 1)) + ")"

    if by == "points":
        define, squares = ["  A1: q1"], []
        for k in joints:
            define += [f"  A{k}: A{k - 1} + q{k}"] if k > 1 else []
            for axis, name in (("x", "cos"), ("y", "sin")):
                links = " + ".join(f"l{i}*{name}(A{i})" for i in range(1, k))
                define.append(f"  {axis}{k}: {links + ' + ' if links else ''}s{k}*{name}(A{k})")
            squares.append(f"m{k}*(x{k}'^2 + y{k}'^2) + I{k}*A{k}'^2")
        return head + "define:\n" + "\n".join(define) + f"\nT: ({' + '.join(squares)})/2\n"
    terms = [f"I{k}/2*{rate(k)}^2" for k in joints]
    pairs = [(k, i, j) for k in joints for i in range(1, k + 1) for j in range(i, k + 1)]
    sizes = {
        (k, i, j): f"{1 + (i != j)}*m{k}*{'s' if i == k else 'l'}{i}*{'s' if j == k else 'l'}{j}/2*{turned(i, j)}"
        for k, i, j in pairs
    }
    if by == "cosines":
        terms += [f"{size}*{rate(i)}*{rate(j)}" for (_, i, j), size in sizes.items()]
    else:  # half of what is symmetric stands at each of both joints
        entries = {
            (a, b): [size for (_, i, j), size in sizes.items() if a <= i and b <= j] for a in joints for b in joints
        }
        terms += [f"({' + '.join(own)})*q{a}'*q{b}'" for (a, b), own in entries.items() if own]
    return head + "T: " + " + ".join(terms) + "\n"


@pytest.mark.sample(2)
@pytest.mark.parametrize("by", ["masses", "cosines"])
@pytest.mark.parametrize("count", [2, 4, 6])
def test_an_arm_by_the_angles_of_its_joints_is_the_arm_of_its_points(count: int, by: str) -> None:
    expected, found = program_of(system_of(arm(count, by="points"))), program_of(system_of(arm(count, by=by)))
    assert operations(found) <= 1.3 * operations(expected)
    first, second = (python_model(render(made, "python", EmitOptions())["arm.py"], "arm") for made in (expected, found))
    draw = random.Random(count)
    y = [draw.uniform(0.3, 1.1) for _ in first.STATE]
    assert second.rhs(0.0, y) == pytest.approx(first.rhs(0.0, y), rel=1e-10, abs=1e-10)


def test_a_rope_of_changing_length_is_one_point() -> None:
    """Three squares of the load, and nothing is multiplied with anything else."""
    system = system_of(multiplied_out(CRANE))
    kinetic = kinetic_structure(system)
    assert are_equal(system.graph, [energy_as_squares(system)], [system.T])
    assert len(kinetic.atoms) == 3 + 3
    zero = system.graph.zero
    assert all(h == zero for i, row in enumerate(kinetic.hessian) for h in row[:i])


@pytest.mark.parametrize(
    "energy",
    [
        "(x'^2 + y'^2)/2 + sin(x)*x'*y'/3",
        "(2 + sin(a))*x'*y' + (x'^2 + y'^2 + a'^2)*exp(x + y)",
        "x'^2/2 + y'^2/2 + a'^2/2 + cos(a)*x'*y'/4 + t*x'*a'/5",
        "(x'^2 + y'^2 + a'^2)/2 + x*y*x'*y'*x'",
        "m*(x'^2 + y'^2)/2 - m*cos(a)*x'*a' + m*a'^2",
    ],
)
def test_what_is_no_sum_of_squares_keeps_its_value(energy: str) -> None:
    system = system_of(f"nhc: 1\nsystem: other\ncoordinates: [x, y, a]\nparameters: {{m: 2}}\nT: {energy}\n")
    assert are_equal(system.graph, [energy_as_squares(system)], [system.T])
