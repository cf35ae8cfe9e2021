"""Point masses on rods in space: solved by the tensions of the rods, exactly as by the mass matrix, in half of the operations."""

from __future__ import annotations

import random

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.mechanics.frame import kept_forms
from nhc.mechanics.trees.tree import Elimination
from nhc.pipeline import Options, model
from nhc.program.planning.held_tree import held_tree
from tests.numeric.test_chains import dense, made
from tests.numeric.test_squares import multiplied_out

ANGLES = {  # the direction of a rod by two angles
    "about y, then x": ("sin(a)*cos(b)", "sin(b)", "-cos(a)*cos(b)"),
    "about x, then y": ("-sin(b)", "sin(a)*cos(b)", "-cos(b)*cos(a)"),
    "polar": ("sin(a)*cos(b)", "sin(a)*sin(b)", "cos(a)"),
    "polar, upside down": ("-sin(b)*sin(a)", "cos(a)", "cos(b)*sin(a)"),
}
BASES = {  # (coordinates, rotation, where the first rod hangs, T)
    "fixed": ("", "", ("", "", ""), ""),
    "cart": ("x, y", "", ("x", "y", ""), "M*(x'^2 + y'^2)"),
    "rail": ("x", "", ("x", "", "h"), "M*x'^2"),
    "point": ("x, y, z", "", ("x", "y", "z"), "M*(x'^2 + y'^2 + z'^2)"),
    "drone": (
        "x, y, z",
        "{R: {velocities: [p, q, r]}}",
        ("x - h*R_x3 + e*R_x1", "y - h*R_y3 + e*R_y1", "z - h*R_z3 + e*R_z1"),
        "M*(x'^2 + y'^2 + z'^2) + A*p^2 + B*q^2 + C*r^2",
    ),
    "skew body": (
        "x, y, z",
        "{R: {velocities: [p, q, r]}}",
        ("x - h*R_x3", "y - h*R_y3", "z - h*R_z3"),
        "M*(x'^2 + y'^2 + z'^2) + A*p^2 + B*q^2 + C*r^2 + D*p*q",
    ),
}


def hanging(base: str, rods: int, seed: int = 0, *, forces: bool = False, more: str = "", fork: bool = False) -> str:
    """Rods on one another; a ``fork`` has its last two on one tip."""
    draw = random.Random(f"{base} {rods} {seed}")
    coordinates, rotation, (x, y, z), kinetic = BASES[base]
    names, define, potential = [coordinates] if coordinates else [], list[str](), list[str]()
    foot = (x, y, z)
    squares = [kinetic] if kinetic else []
    for k in range(1, rods + 1):
        arms = ANGLES[draw.choice(list(ANGLES))]
        names.append(f"a{k}, b{k}")
        for axis, start, arm in zip("xyz", foot, arms, strict=True):
            turned = arm.replace("(a)", f"(a{k})").replace("(b)", f"(b{k})")
            define.append(f"  {axis}{k}: {start or '0'} + l{k}*({turned})")
        squares.append(f"m{k}*(x{k}'^2 + y{k}'^2 + z{k}'^2)")
        potential.append(f"m{k}*g*z{k}")
        if not (fork and k == rods - 1):
            foot = f"x{k}", f"y{k}", f"z{k}"
    values = ", ".join(
        f"l{k}: {draw.uniform(0.3, 1):.2f}, m{k}: {draw.uniform(0.2, 2):.2f}" for k in range(1, rods + 1)
    )
    pushes = (
        "forces: {" + ", ".join(f"a{k}: -c*a{k}', x{k}: c*sin(t)" for k in range(1, rods + 1)) + f", b{rods}: c" + "}"
    )
    return f"""
nhc: 1
system: rods
coordinates: [{", ".join(names)}]
{f"rotation: {rotation}" if rotation else ""}
parameters: {{g: 9.81, c: 0.1, h: 0.2, e: 0.05, M: 1.5, A: 0.02, B: 0.03, C: 0.04, D: 0.01, {values}}}
define:
{chr(10).join(define)}
T: 1/2*({" + ".join(squares)}{more})
V: {" + ".join(potential)}
{pushes if forces else ""}
"""


def assert_same(text: str) -> Elimination:
    found, tree = made(text)
    assert are_equal(found.system.graph, tree.rates, dense(found, list(found.equations.force)))
    g = found.system.graph
    right = [g.symbol(f"right {k}") for k in range(len(found.equations.motion.w))]
    assert are_equal(g, tree.solve(right), dense(found, right))
    return tree


@pytest.mark.sample(3)
@pytest.mark.parametrize("base", BASES)
@pytest.mark.parametrize("forces", [False, True], ids=["free", "driven"])
@pytest.mark.parametrize("rods", [1, 3])
def test_rods_in_space(base: str, forces: bool, rods: int) -> None:
    tree = assert_same(hanging(base, rods, forces=forces))
    assert len(tree.spheres.rods) == rods
    (root,) = tree.spheres.roots
    assert root.free == (base in ("cart", "rail", "point", "drone"))


@pytest.mark.sample(3)
@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("base", ["cart", "drone"])
def test_all_angles_on_one_another(base: str, seed: int) -> None:
    """Some of T's forms have the other sign, so that a weight is an acceleration from the second rod on."""
    assert len(assert_same(hanging(base, 3, seed)).spheres.rods) == 3


def test_what_carries_two_rods_is_none() -> None:
    tree = assert_same(hanging("cart", 3, fork=True))
    assert len(tree.spheres.rods) == 2  # both stand on the first one's tip, which is a form like others
    assert len(tree.spheres.roots) == 2


@pytest.mark.parametrize(
    ("base", "more"),
    [
        ("fixed", "holonomic: [{across: x5 = 1.2}, {along: y5 = 0.1}]"),
        ("cart", "constraints: [{edge: \"cos(a5)*x5' - sin(a5)*y5' = 0\"}]"),
    ],
    ids=["at both ends", "on a skate"],
)
def test_rods_that_constraints_hold(base: str, more: str) -> None:
    source = Source("held.yaml", hanging(base, 5, 3) + more + "\n")
    found = model(source, Options(formulation="euler-lagrange"))
    tree = held_tree(found.equations, kept_forms(found.system, found.formulation.frame))
    assert tree is not None
    assert are_equal(found.system.graph, tree.rates, dense(found, list(found.equations.force)))


ALMOST = {
    "inertia about the joint": " + 0.1*a1'^2",
    "a coupled rate": " + 0.1*(a1' + a2')^2",
    "unequal masses": " + 0.1*z1'^2",
    "a coupled foot": " + 0.1*x1'*x'",
}


@pytest.mark.parametrize("more", ALMOST.values(), ids=ALMOST)
def test_what_is_almost_a_rod(more: str) -> None:
    tree = assert_same(hanging("cart", 2, 1, more=more))
    assert len(tree.spheres.rods) < 2


def test_the_work_of_each_rod_is_a_few_dozen_operations() -> None:
    few, many = (count(tree.graph, tree.rates) for _, tree in (made(hanging("cart", n)) for n in (4, 8)))
    assert (many - few) / 4 < 95


def test_what_carries_a_rod_is_not_multiplied_out() -> None:
    """The squares of a body's weights, which its rates need anyway, cost less than one polynomial in its quaternion."""
    _, tree = made(hanging("drone", 1))
    assert count(tree.graph, tree.rates) < 280


LENGTHS = [
    *(("2", "1", "3"), ("0.95", "1", "1"), ("2*l1", "l1", "l1"), ("l1", "l1/2", "2*l1")),
    *(("l1", "2", "1"), ("1", "2*m1", "m1")),
    *(("2", "1"), ("2", "3"), ("2*l1", "l1")),
]
"""Of rods: multiples of one another, which no unit of parameters makes equal."""


@pytest.mark.sample(3)
@pytest.mark.parametrize("lengths", LENGTHS, ids=" ".join)
@pytest.mark.parametrize("base", ["fixed", "cart"])
@pytest.mark.parametrize("by", ["positions", "energies"])
def test_lengths_that_are_multiples_of_one_another(lengths: tuple[str, ...], base: str, by: str) -> None:
    """Rods of unequal lengths must not be joined as if the forms of their tips were those of equal ones."""
    text = hanging(base, len(lengths), 5)
    for k, length in enumerate(lengths, 1):
        text = text.replace(f" l{k}*(", f" {length}*(")
    tree = assert_same(multiplied_out(text) if by == "energies" else text)
    assert len(tree.spheres.rods) == len(lengths) or by == "energies"
