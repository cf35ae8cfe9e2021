"""Chains and trees solved from their leaves: equal to the dense solution as rational functions, and to other equations in value."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Node
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.mechanics.energies.whole_forms import whole_kinetic
from nhc.mechanics.trees.choice import tree_of
from nhc.mechanics.trees.tree import Elimination
from nhc.pipeline import Model, Options, emit, model, reduce_scene
from nhc.program.plan import factor, solve_factored
from nhc.program.planning.held_tree import held_tree
from nhc.program.planning.planner import Planner
from tests.support import error, python_model


class Tree:
    """A random tree as spec text: body i hangs on ``parent[i]`` (0: the base)."""

    def __init__(self, seed: int, bodies: int) -> None:
        self.draw = random.Random(f"chain {seed}")
        self.parent = [0, *(self.draw.choice((i - 1, i - 1, self.draw.randrange(i))) for i in range(1, bodies + 1))]
        self.coordinates: list[str] = []
        self.parameters = {"g": 9.81, "k": 2.0, "c": 0.3}
        self.define: list[str] = []
        self.kinetic: list[str] = []
        self.potential: list[str] = []
        self.forces: dict[str, str] = {}

    def number(self, name: str) -> str:
        self.parameters[name] = round(self.draw.uniform(0.4, 1.6), 2)
        return name

    def text(self, **sections: str) -> str:
        parameters = ", ".join(f"{name}: {value}" for name, value in self.parameters.items())
        lines = ["nhc: 1", "system: tree", f"coordinates: [{', '.join(self.coordinates)}]"]
        lines += [f"parameters: {{{parameters}}}", "define:", *(f"  {line}" for line in self.define)]
        lines += [f"T: 1/2*({' + '.join(self.kinetic)})", f"V: {' + '.join(self.potential)}"]
        if self.forces:
            lines += ["forces:", *(f"  {name}: {value}" for name, value in self.forces.items())]
        lines += [f"{key}: {value}" for key, value in sections.items()]
        return "\n".join(lines) + "\n"

    def base(self, kind: str) -> tuple[str, str]:
        """Where the first body hangs: fixed, on a cart, on a moving point, or on a free body."""
        if kind == "fixed":
            return "", ""
        if kind == "driven":
            self.define += [f"x0: {self.number('A')}*sin(3*t)", "y0: t^2/2"]
            return "x0", "y0"
        self.coordinates += ["x"] if kind == "cart" else ["x", "y"]
        self.kinetic.append(f"{self.number('M')}*x'^2" if kind == "cart" else f"{self.number('M')}*(x'^2 + y'^2)")
        return ("x", "") if kind == "cart" else ("x", "y")


def join(*terms: str) -> str:
    return " + ".join(term for term in terms if term)


def rods(seed: int, bodies: int, base: str, one_mass: bool = False) -> str:
    """Point masses on massless rods; some bodies have springs or torques."""
    tree = Tree(seed, bodies)
    foot = {0: tree.base(base)}
    turned = tree.draw.random() < 0.5
    for i in range(1, bodies + 1):
        parent = tree.parent[i]
        tree.coordinates.append(f"th{i}")
        rod, m = (tree.number(name) if not one_mass else tree.number(name[0]) for name in (f"l{i}", f"m{i}"))
        x, y = (f"{rod}*cos(th{i})", f"{rod}*sin(th{i})") if turned else (f"{rod}*sin(th{i})", f"-{rod}*cos(th{i})")
        tree.define += [f"x{i}: {join(foot[parent][0], x)}", f"y{i}: {join(foot[parent][1], y)}"]
        foot[i] = f"x{i}", f"y{i}"
        tree.kinetic.append(f"{m}*(x{i}'^2 + y{i}'^2)")
        tree.potential.append(f"{m}*g*y{i}")
        if tree.draw.random() < 0.3:
            tree.potential.append(f"k/2*(th{i} - {f'th{parent}' if parent else '0.3'})^2")
        if tree.draw.random() < 0.3:
            tree.forces[f"th{i}"] = f"-c*th{i}' + x{i}*cos(t)"
    return tree.text()


def links(seed: int, bodies: int, base: str) -> str:
    """Links with inertia, a centre of mass off the middle, springs and dampers; some without inertia."""
    tree = Tree(seed, bodies)
    foot = {0: tree.base(base)}
    for i in range(1, bodies + 1):
        parent = tree.parent[i]
        tree.coordinates.append(f"th{i}")
        rod, a, m = tree.number(f"l{i}"), tree.number(f"a{i}"), tree.number(f"m{i}")
        for name, arm in ((f"c{i}", a), (f"e{i}", rod)):
            tree.define.append(f"x{name}: {join(foot[parent][0], f'{arm}*sin(th{i})')}")
            tree.define.append(f"y{name}: {join(foot[parent][1], f'-{arm}*cos(th{i})')}")
        foot[i] = f"xe{i}", f"ye{i}"
        tree.kinetic.append(f"{m}*(xc{i}'^2 + yc{i}'^2)")
        if tree.draw.random() < 0.8:
            tree.kinetic.append(f"{tree.number(f'J{i}')}*th{i}'^2")
        tree.potential += [f"{m}*g*yc{i}", f"k/2*(th{i} - {f'th{parent}' if parent else '0'})^2"]
        tree.forces[f"th{i}"] = f"-c*th{i}'"
    return tree.text()


def hinges(seed: int, bodies: int, base: str) -> str:
    """Relative angles: the rate of a joint turns all that comes after it."""
    tree = Tree(seed, bodies)
    foot, angle = {0: tree.base(base)}, {0: ""}
    for i in range(1, bodies + 1):
        parent = tree.parent[i]
        tree.coordinates.append(f"q{i}")
        rod, m, J = tree.number("l"), tree.number("m"), tree.number("J")
        tree.define.append(f"a{i}: {join(angle[parent], f'q{i}')}")
        angle[i] = f"a{i}"
        for name, arm in ((f"c{i}", f"{rod}/2"), (f"e{i}", rod)):
            tree.define.append(f"x{name}: {join(foot[parent][0], f'{arm}*cos(a{i})')}")
            tree.define.append(f"y{name}: {join(foot[parent][1], f'{arm}*sin(a{i})')}")
        foot[i] = f"xe{i}", f"ye{i}"
        tree.kinetic += [f"{m}*(xc{i}'^2 + yc{i}'^2)", f"{J}*a{i}'^2"]
        tree.potential += [f"{m}*g*yc{i}", f"k/2*q{i}^2"]
    return tree.text()


def spherical(seed: int, bodies: int, base: str) -> str:
    """Point masses on rods that swing in space, with a slider between some."""
    tree = Tree(seed, bodies)
    foot = {0: (*tree.base(base), "")}
    for i in range(1, bodies + 1):
        parent = tree.parent[i]
        tree.coordinates += [f"th{i}", f"ph{i}"]
        rod, m = tree.number(f"l{i}"), tree.number("m")
        if tree.draw.random() < 0.4:
            tree.coordinates.append(f"s{i}")
            tree.potential.append(f"k/2*s{i}^2")
            rod = f"({rod} + s{i})"
        arms = (f"{rod}*sin(th{i})*cos(ph{i})", f"{rod}*sin(th{i})*sin(ph{i})", f"-{rod}*cos(th{i})")
        for axis, start, arm in zip("xyz", foot[parent], arms, strict=True):
            tree.define.append(f"{axis}{i}: {join(start, arm)}")
        foot[i] = f"x{i}", f"y{i}", f"z{i}"
        tree.kinetic.append(f"{m}*(x{i}'^2 + y{i}'^2 + z{i}'^2)")
        tree.potential.append(f"{m}*g*z{i}")
    return tree.text()


def ball_joints(seed: int, bodies: int, base: str) -> str:
    """Rigid bodies in space on ball joints, by Euler's angles; their angular velocities are not exact."""
    tree = Tree(seed, bodies)
    foot = {0: (*tree.base(base), "")}
    for i in range(1, bodies + 1):
        parent = tree.parent[i]
        phi, th, psi = names = (f"phi{i}", f"th{i}", f"psi{i}")
        tree.coordinates += names
        m, rod, c = tree.number("m"), tree.number(f"l{i}"), tree.number("c")
        arms = (f"sin({th})*sin({phi})", f"-sin({th})*cos({phi})", f"-cos({th})")
        for end, part in ((f"c{i}", f"{rod}*{c}"), (f"e{i}", rod)):
            for axis, start, arm in zip("xyz", foot[parent], arms, strict=True):
                tree.define.append(f"{axis}{end}: {join(start, f'{part}*({arm})')}")
        foot[i] = f"xe{i}", f"ye{i}", f"ze{i}"
        tree.kinetic.append(f"{m}*(xc{i}'^2 + yc{i}'^2 + zc{i}'^2)")
        tree.kinetic.append(f"{tree.number('A')}*({phi}'*sin({th})*sin({psi}) + {th}'*cos({psi}))^2")
        tree.kinetic.append(f"{tree.number('B')}*({phi}'*sin({th})*cos({psi}) - {th}'*sin({psi}))^2")
        tree.kinetic.append(f"{tree.number('C')}*({phi}'*cos({th}) + {psi}')^2")
        tree.potential.append(f"{m}*g*zc{i}")
    return tree.text()


def written_out(seed: int, bodies: int, backwards: bool) -> str:
    """A chain whose velocities the user wrote out, from the near or the far end."""
    tree = Tree(seed, bodies)
    tree.coordinates = ["x", *(f"th{i}" for i in range(1, bodies + 1))]
    tree.define = ["unused: x"]
    tree.kinetic.append(f"{tree.number('M')}*x'^2")
    rod, m = tree.number("l"), tree.number("m")
    for i in range(1, bodies + 1):
        order = range(i, 0, -1) if backwards else range(1, i + 1)
        across = "".join(f" + {rod}*cos(th{j})*th{j}'" for j in order)
        down = " + ".join(f"{rod}*sin(th{j})*th{j}'" for j in order)
        tree.kinetic.append(f"{m}*((x'{across})^2 + ({down})^2)")
        tree.potential.append(f"-{m}*g*{rod}*{bodies - i + 1}*cos(th{i})")
    return tree.text()


def specs() -> Iterator[tuple[str, str]]:
    bases = ("fixed", "cart", "driven", "free")
    for seed in range(4):
        base = bases[seed]
        yield f"rods-{base}", rods(seed, 6 + seed, base)
        yield f"equal-rods-{base}", rods(seed + 10, 5, base, one_mass=True)
        yield f"links-{base}", links(seed, 4 + seed, base)
        yield f"hinges-{base}", hinges(seed, 3 + seed, base)
        yield f"spherical-{base}", spherical(seed, 2 + seed // 2, base)
        yield f"bodies-{base}", ball_joints(seed, 2 + seed % 2, base)
    yield "written-out", written_out(0, 6, False)
    yield "written-out-backwards", written_out(1, 6, True)
    yield "quasi-velocities", in_quasi_velocities()
    yield from ((f"almost rods, {kind}", almost_rods(kind)) for kind in ALMOST_RODS)


def in_a_row(bodies: int, kind: str) -> str:
    """Equal rods under a cart, or equal links with inertia."""
    tree = Tree(0, bodies)
    foot = tree.base("cart" if kind == "rods" else "fixed")
    arms = [("e", tree.number("l"))] if kind == "rods" else [("c", tree.number("a")), ("e", tree.number("l"))]
    m, J = tree.number("m"), tree.number("J")
    for i in range(1, bodies + 1):
        tree.coordinates.append(f"th{i}")
        for name, arm in arms:
            tree.define.append(f"x{name}{i}: {join(foot[0], f'{arm}*sin(th{i})')}")
            tree.define.append(f"y{name}{i}: {join(foot[1], f'-{arm}*cos(th{i})')}")
        foot = f"xe{i}", f"ye{i}"
        body = f"{arms[0][0]}{i}"
        tree.kinetic.append(f"{m}*(x{body}'^2 + y{body}'^2)" + (f" + {J}*th{i}'^2" if kind == "links" else ""))
        tree.potential.append(f"{m}*g*y{body}")
    return tree.text()


ALMOST_RODS = {  # what makes the first of equal rods none
    "two carts": ("x + u", "sin(th1)", "cos(th1)", "u'^2"),
    "a geared cart": ("k*x", "sin(th1)", "cos(th1)", ""),
    "another angle": ("x", "sin(th1)", "cos(th1 + 1)", ""),
    "one function": ("x", "sin(th1)", "sin(th1)", ""),
    "unequal masses": ("x", "sin(th1)", "cos(th1)", "2*y1'^2"),
    "inertia": ("x", "sin(th1)", "cos(th1)", "k*th1'^2"),
    "a coupled rate": ("x", "sin(th1)", "cos(th1)", "k*th1'^2/2 + k*(th1' + th2')^2"),
    "a coupled foot": ("x", "sin(th1)", "cos(th1)", "0.3*x'*th1'"),
}


def almost_rods(kind: str) -> str:
    """Five equal rods under a cart, the first of which is none: what is solved for a rod must not be taken for it."""
    foot, across, down, more = ALMOST_RODS[kind]
    tree = Tree(0, 5)
    tree.coordinates = ["x", *(["u"] if "u" in foot else []), *(f"th{i}" for i in range(1, 6))]
    tree.define += [f"x1: {foot} + l*{across}", f"y1: -l*{down}"]
    tree.define += [
        f"{q}{i}: {q}{i - 1} {f}(th{i})" for i in range(2, 6) for q, f in (("x", "+ l*sin"), ("y", "- l*cos"))
    ]
    tree.kinetic = [f"{tree.number('M')}*x'^2", *(f"{tree.number('m')}*(x{i}'^2 + y{i}'^2)" for i in range(1, 6))]
    tree.kinetic += [more] if more else []
    tree.potential.append(f"k/2*th1^2 + {tree.number('l')}*x")
    return tree.text()


def in_quasi_velocities() -> str:
    """A chain whose kept velocities are the cart's and the relative rates."""
    rates = ["  u0: cos(th1)*x'", "  u1: th1'", *(f"  u{i}: th{i}' - th{i - 1}'" for i in range(2, 6))]
    return in_a_row(5, "rods") + "\n".join(["quasi_velocities:", *rates]) + "\n"


CASES = [pytest.param(text, id=name) for name, text in specs()]


def made(text: str) -> tuple[Model, Elimination]:
    found = model(Source("tree.yaml", text))
    kinetic = whole_kinetic(found.system)
    assert kinetic is not None
    tree = tree_of(found.system, found.equations.motion, kinetic)
    assert tree is not None
    return found, tree


def dense(found: Model, right: list[Node]) -> list[Node]:
    g = found.system.graph
    return solve_factored(g, factor(g, found.equations.mass), right)


@pytest.mark.sample(3)
@pytest.mark.parametrize("text", CASES)
def test_the_rates_are_the_dense_ones(text: str) -> None:
    found, tree = made(text)
    assert are_equal(found.system.graph, tree.rates, dense(found, list(found.equations.force)))


@pytest.mark.sample(3)
@pytest.mark.parametrize("text", CASES)
def test_any_right_side_is_solved(text: str) -> None:
    found, tree = made(text)
    g = found.system.graph
    right = [g.symbol(f"r{i}", "test") for i in range(found.system.n)]
    assert are_equal(g, tree.solve(right), dense(found, right))


@pytest.mark.sample(3)
@pytest.mark.parametrize("text", CASES)
def test_the_residual_is_the_force_without_that_of_the_mass_matrix(text: str) -> None:
    found, tree = made(text)
    assert are_equal(found.system.graph, *residuals(found, tree))


def residuals(found: Model, tree: Elimination) -> tuple[list[Node], list[Node]]:
    """force - M rates for any rates: along the tree, and by the matrix."""
    g, equations = found.system.graph, found.equations
    rates = [g.symbol(f"r{i}", "test") for i in range(len(equations.motion.w))]
    by_matrix = [g.sub(f, g.dot(row, rates)) for f, row in zip(equations.force, equations.mass, strict=True)]
    return tree.residual(rates), by_matrix


def test_a_wrong_tree_is_noticed() -> None:
    found, tree = made(rods(1, 5, "cart"))
    rates = tree.rates
    rates[2] = found.system.graph.add(rates[2], tree.chain.scale[2])
    assert not are_equal(found.system.graph, rates, dense(found, list(found.equations.force)))


def held(kind: str) -> str:
    """Chains that hang at both ends, or drag a skate, or a blade and a pin."""
    hung = "holonomic:\n  - across: {x} = d\n  - down: {y} = -0.3\n"
    skate = "constraints:\n  - edge: -sin(th{n})*{x}' + cos(th{n})*{y}' = 0\n"
    text, n, tip = {
        "rods": (in_a_row(6, "rods"), 6, "e6"),
        "links": (in_a_row(7, "links"), 7, "e7"),
        "driven": (links(21, 6, "driven"), 6, "e6"),
        "tree": (links(23, 6, "free"), 6, "e6"),
    }[kind.split("-")[0]]
    text = text.replace("parameters: {", "parameters: {d: 1.3, ")
    return text + (hung if kind.endswith("hung") else skate).format(n=n, x=f"x{tip}", y=f"y{tip}")


@pytest.mark.parametrize("kind", ["rods-hung", "rods-skate", "links-hung", "driven-skate", "tree-hung", "tree-skate"])
def test_a_held_tree_is_the_dense_one(kind: str) -> None:
    found = model(Source("held.yaml", held(kind)), Options(formulation="euler-lagrange"))
    g, frame = found.system.graph, found.formulation.frame
    assert frame is not None
    made = held_tree(found.equations, frame.forms[found.system.l :])
    assert made is not None
    assert are_equal(g, made.rates, dense(found, list(found.equations.force)))
    right = [g.symbol(f"r{i}", "test") for i in range(len(found.equations.motion.w))]
    assert are_equal(g, made.solve(right), dense(found, right))


def test_many_links_that_are_held_take_the_tree() -> None:
    text = in_a_row(9, "links").replace("parameters: {", "parameters: {d: 2.3, ")
    made = model(Source("held.yaml", text + "holonomic:\n  - across: xe9 = d\n"))
    planner = Planner(made.equations, made.formulation)
    g, motion = made.system.graph, made.equations.motion
    values = solve_factored(g, factor(g, made.equations.mass), made.equations.force)
    assert count(g, planner.route.values) < 0.6 * count(g, values)
    assert motion.velocities != motion.w


def operations(text: str) -> int:
    found = model(Source("tree.yaml", text))
    return count(found.system.graph, Planner(found.equations, found.formulation).route.values)


@pytest.mark.parametrize(("kind", "each"), [("rods", 30), ("written out", 30), ("links", 80)])
def test_the_work_is_linear(kind: str, each: int) -> None:
    """Operations grow by the same amount with every body."""
    texts = {n: written_out(3, n, True) if kind == "written out" else in_a_row(n, kind) for n in (8, 12, 16)}
    sizes = {n: operations(text) for n, text in texts.items()}
    assert sizes[16] - sizes[12] == sizes[12] - sizes[8] <= 4 * each


def test_small_and_dense_systems_stay_dense() -> None:
    text = "nhc: 1\nsystem: dense\ncoordinates: [a, b, c]\nparameters: {m: 1}\n"
    text += "T: m/2*(a'^2 + b'^2 + c'^2 + a'*b' + b'*c')\nV: a^2\n"
    found = model(Source("dense.yaml", text))
    assert not Planner(found.equations, found.formulation).route.chained


def points(tree: Tree) -> str:
    """The same rods as points held at their distances, for the multiplier equations."""
    other = Tree(0, 0)
    other.parameters, other.define = tree.parameters, ["ground: 0"]
    held = ["holonomic:"]
    for i in range(1, len(tree.parent)):
        other.coordinates += [f"x{i}", f"y{i}"]
        other.kinetic.append(f"m{i}*(x{i}'^2 + y{i}'^2)")
        other.potential.append(f"m{i}*g*y{i}")
        parent = tree.parent[i]
        dx, dy = (f"({axis}{i} - {axis}{parent})" if parent else f"{axis}{i}" for axis in "xy")
        held.append(f"  - rod{i}: {dx}^2 + {dy}^2 = l{i}^2")
    return other.text() + "\n".join(held) + "\n"


def hanging(tree: Tree) -> str:
    for i in range(1, len(tree.parent)):
        parent = tree.parent[i]
        tree.coordinates.append(f"th{i}")
        rod, m = tree.number(f"l{i}"), tree.number(f"m{i}")
        tree.define.append(f"x{i}: {join(f'x{parent}' if parent else '', f'{rod}*sin(th{i})')}")
        tree.define.append(f"y{i}: {join(f'y{parent}' if parent else '', f'-{rod}*cos(th{i})')}")
        tree.kinetic.append(f"{m}*(x{i}'^2 + y{i}'^2)")
        tree.potential.append(f"{m}*g*y{i}")
    return tree.text()


@pytest.mark.parametrize("seed", range(3))
def test_accelerations_are_those_of_the_multiplier_equations(seed: int) -> None:
    """A tree of rods by its angles, and as free points with the rods' tensions."""
    tree = Tree(100 + seed, 6)
    angles = python_model(next(iter(emit(Source("a.yaml", hanging(tree)), "python").values())), f"angles_{seed}")
    options = Options(formulation="multipliers")
    text = next(iter(emit(Source("p.yaml", points(tree)), "python", options).values()))
    cartesian = python_model(text, f"points_{seed}")
    draw = random.Random(seed)
    th, w = ([draw.uniform(-1, 1) for _ in range(6)] for _ in range(2))
    rates = angles.accelerations(0.0, [*th, *w])
    place, speed, wanted = [[0.0, 0.0]], [[0.0, 0.0]], [[0.0, 0.0]]
    for i, (q, v, a) in enumerate(zip(th, w, rates, strict=True), 1):
        parent, rod = tree.parent[i], tree.parameters[f"l{i}"]
        s, c = rod * math.sin(q), rod * math.cos(q)
        place.append([place[parent][0] + s, place[parent][1] - c])
        speed.append([speed[parent][0] + c * v, speed[parent][1] + s * v])
        wanted.append([wanted[parent][0] + c * a - s * v * v, wanted[parent][1] + s * a + c * v * v])
    y = [x for pairs in (place[1:], speed[1:]) for pair in pairs for x in pair]
    assert error(cartesian.accelerations(0.0, y), [x for pair in wanted[1:] for x in pair]) < 1e-11


def test_the_jacobian_is_that_of_the_right_hand_side() -> None:
    found = python_model(next(iter(emit(Source("t.yaml", links(7, 5, "driven")), "python").values())), "links_jacobian")
    draw = random.Random(5)
    t, y, h = 0.4, [draw.uniform(-1, 1) for _ in range(10)], 1e-5
    columns = []
    for k in range(len(y)):
        ahead, behind = list(y), list(y)
        ahead[k], behind[k] = y[k] + h, y[k] - h
        pair = zip(found.rhs(t, ahead), found.rhs(t, behind), strict=True)
        columns.append([(a - b) / (2 * h) for a, b in pair])
    expected = [x for row in zip(*columns, strict=True) for x in row]
    assert error([x for row in found.jacobian(t, y) for x in row], expected) < 1e-7


def test_a_scene_is_solved_from_the_leaves_too() -> None:
    scenes = "scenes:\n  swing:\n    initial: {th1: 0.3, th4: -0.2}\n    time: [0, 1]\n    need: [th5]\n"
    made = reduce_scene(Source("t.yaml", in_a_row(5, "rods") + scenes), Options(scene="swing"))
    assert "x" not in made.reduction.state
    assert made.planner.route.chained


def test_a_singular_state_is_refused() -> None:
    """A joint without mass between two rods in line: nothing holds it across."""
    text = "nhc: 1\nsystem: limp\ncoordinates: [a, b, c, d]\nparameters: {m: 1, l: 1}\ndefine:\n"
    text += "  x1: l*sin(a)\n  y1: l*cos(a)\n"
    text += "".join(
        f"  {v}{i}: {v}{i - 1} + l*{f}({q})\n"
        for i, q in ((2, "b"), (3, "c"), (4, "d"))
        for v, f in (("x", "sin"), ("y", "cos"))
    )
    text += "T: m/2*(x2'^2 + y2'^2 + x3'^2 + y3'^2 + x4'^2 + y4'^2)\nV: m*y2\n"
    found = python_model(next(iter(emit(Source("limp.yaml", text), "python").values())), "limp")
    assert all(map(math.isfinite, found.rhs(0.0, [0.3, 0.9, 0.1, 0.2, 0.1, 0.2, 0.3, 0.4])))
    with pytest.raises(ArithmeticError):
        found.rhs(0.0, [0.3, 0.3, 0.1, 0.2, 0.1, 0.2, 0.3, 0.4])
