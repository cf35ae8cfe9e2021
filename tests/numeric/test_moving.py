"""Moving axes: T, the constraints and the reactions on them have the same values, exactly, as on the spec's own axes."""

from __future__ import annotations

import random
from functools import cache

import pytest
import yaml

from nhc.algebra.calculus import tangent
from nhc.algebra.exact.modular import are_equal, are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.gather import gather, split
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.associate import Row
from nhc.mechanics.choosing.choose import applicable, formulate
from nhc.mechanics.energies.kinetic import kinetic_structure
from nhc.mechanics.formulate import _route, equations_of
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.moving.move import move
from nhc.mechanics.moving.on_body import move_on_bodies
from nhc.mechanics.moving.vectors import Reader
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.rotations.turns import Turn, add_spin, change_axes, cross
from nhc.mechanics.row_factors import strip_factor
from nhc.mechanics.system import System
from nhc.pipeline import Options, emit
from nhc.program.build import build_functions
from nhc.program.model import build_program
from nhc.program.planning.planner import Planner
from tests.support import ROOT, python_model, spec_path
from tests.trees import planar_tree, robot_arm, spatial_pair


def system_of(text: str) -> System:
    return resolve(decode(Source("tree.yaml", text)))


def entries(rows: list[Row] | tuple[Row, ...]) -> list[Node]:
    return [node for row in rows for node in (*row.mass, row.force)]


def assert_same(system: System) -> int:
    """Both routes agree in every formulation with a frame; how many of these moved."""
    kinetic, moved_count = kinetic_structure(system), 0
    for formulation in applicable(system):
        frame = formulation.frame
        if frame is None and formulation.name == "lagrange":
            frame = coordinate_frame(system, ())
        way = move_on_bodies if system.rotations else move
        moved = None if frame is None else way(system, kinetic, frame)
        if moved is None:
            continue
        moved_count += 1
        here, there = _route(system, formulation, kinetic), _route(system, formulation, kinetic, moved)
        g = system.graph
        assert are_equal(g, here.motion.velocities, there.motion.velocities)
        assert are_equal(g, entries(here.rows), entries(there.rows))
        assert are_equal(g, entries(here.react()), entries(there.react()))
        kinetic_energy = there.kinetic()
        assert kinetic_energy is not None
        assert are_equal(g, substitute(g, [system.T], moving(system, here.motion.velocities)), [kinetic_energy])
    return moved_count


@pytest.mark.parametrize("seed", range(12))
def test_planar_trees(seed: int) -> None:
    assert assert_same(system_of(planar_tree(seed))) > 0


@pytest.mark.parametrize("seed", range(6))
def test_spatial_pairs(seed: int) -> None:
    assert assert_same(system_of(spatial_pair(seed))) > 0


@pytest.mark.parametrize("seed", range(4))
def test_arms_without_constraints(seed: int) -> None:
    assert assert_same(system_of(robot_arm(seed))) > 0


def count_arm(joints: int) -> tuple[int, int]:
    """Operations of an arm's right-hand side in space, and without moving axes."""
    made = []
    others = {"own axes", "composite inertias"}
    for graph in (WithoutRules(others), WithoutRules({*others, "moving axes"})):
        system = resolve(decode(Source("arm.yaml", robot_arm(1, joints=joints))), graph)
        formulation = formulate(system)
        (rhs,) = build_program(system, formulation, equations_of(system, formulation), ("rhs",)).functions
        made.append(rhs.adds + rhs.multiplications)
    return made[0], made[1]


def test_arms_take_fewer_operations() -> None:
    moved, plain = count_arm(5)
    assert moved < 0.85 * plain
    moved, plain = count_arm(4)
    assert moved <= 617 and plain - moved > 100


@pytest.mark.parametrize("name", ["n_trailer3", "n_snake3", "roller_racer", "rolling_disk", "bicycle", "rattleback"])
def test_moving_axes_change_no_rate_of_the_gallery(name: str) -> None:
    assert assert_same(system_of(spec_path(name).read_text())) > 0


@pytest.mark.parametrize(
    ("old", "new"),
    [("(k)", "(k)"), ("(k)", "(0.5)"), ("(k)", "(0.2 + k)"), ("sin(k)", "(-sin(k))"), ("(c)", "(c - k)")],
    ids=["parameter", "number", "sum", "other way", "shifted"],
)
def test_a_joint_that_leans_stands_straight(old: str, new: str) -> None:
    """Whatever its angle is written like: the same values, exactly, in the same number of operations."""
    text = spatial_pair(3).replace(old, new)
    assert assert_same(system_of(text)) > 0
    straight, leaning = system_of(spatial_pair(3)), WithoutRules({"leaning joints"})
    assert abs(cost(system_of(text), moving=True) - cost(straight, moving=True)) < 5
    assert cost(straight, moving=True) < cost(
        resolve(decode(Source("tree.yaml", spatial_pair(3))), leaning), moving=True
    )


def cost(system: System, *, moving: bool) -> int:
    formulation, kinetic = formulate(system), kinetic_structure(system)
    assert formulation.frame is not None
    moved = move(system, kinetic, formulation.frame) if moving else None
    return _route(system, formulation, kinetic, moved).cost(system.graph)


@cache
def gallery_cost(name: str, *, moving: bool = True) -> int:
    """That of a gallery system as it is written."""
    return cost(system_of(spec_path(name).read_text()), moving=moving)


@pytest.mark.parametrize(
    ("name", "most"), [("n_trailer3", 0.6), ("n_snake3", 0.75), ("bicycle", 0.5), ("rattleback", 0.65)]
)
def test_operations_are_saved(name: str, most: float) -> None:
    assert gallery_cost(name) < most * gallery_cost(name, moving=False)


@pytest.mark.parametrize(
    ("name", "most"),
    [("n_trailer3", 24), ("n_snake3", 37), ("bicycle", 326), ("rattleback", 50), ("ladder/rigid_bicycle", 34)],
)
def test_the_energy_is_written_on_the_axes_of_the_rows(name: str, most: int) -> None:
    """As the spec writes T it takes 69, 68, 454, 68; the last is shorter as it is, and its rows are not on moving axes.

    The two bicycles also measure the determinant that they divide by, with 14 and 8 operations.
    """
    system = resolve(decode(read(str(spec_path(name)))))
    formulation = formulate(system)
    planner = Planner(equations_of(system, formulation), formulation)
    (energy,) = build_functions(planner, ("energy",))
    assert energy.adds + energy.multiplications + energy.divisions <= most
    plain = substitute(system.graph, [system.energy], moving(system, planner.equations.motion.velocities))
    assert are_equal(system.graph, planner.on_motion([system.energy]), plain)


def test_a_pair_of_the_kinetic_energy_keeps_its_plane() -> None:
    """On axes that turn in space the base's velocity would have a third component, which is no form of T."""
    system = system_of((ROOT / "tests" / "specs" / "gantry.yaml").read_text())
    assert assert_same(system) > 0


def rewritten(name: str, way: str) -> str:
    """A gallery system with its rows or its coordinates in another order, or with the sides of its rows exchanged."""
    data = yaml.safe_load(spec_path(name).read_text())
    data = {key: x for key, x in data.items() if key not in ("outputs", "scenes", "draw", "source")}
    rows: list[dict[str, str]] = data["constraints"]
    if way == "backwards":
        data["constraints"] = rows[::-1]
    elif way == "scattered":
        data["constraints"] = rows[::2] + rows[1::2]
    elif way in ("other side", "some on the other side"):
        for row in rows if way == "other side" else rows[::2]:
            row |= {label: " = ".join(reversed(text.split("="))) for label, text in row.items()}
    else:
        names = list(data["coordinates"])
        first, second = names.index("x"), names.index("y")
        names[first], names[second] = names[second], names[first]
        data["coordinates"] = names
    return yaml.safe_dump(data, sort_keys=False)


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", ["bicycle", "rattleback", "roller_racer", "n_trailer3", "n_snake3"])
@pytest.mark.parametrize("way", ["backwards", "scattered", "other side", "some on the other side", "y before x"])
def test_the_order_and_the_signs_of_rows_are_all_the_same(name: str, way: str) -> None:
    if (name, way) == ("bicycle", "y before x"):
        way = "other side"  # its free velocities are those that come first
    system = system_of(rewritten(name, way))
    assert cost(system, moving=True) <= 1.03 * gallery_cost(name)
    assert assert_same(system) > 0


FACTORS = {"doubled": "2*({})", "by a parameter": "K*({})", "over a length": "({})/K", "by a sum": "(K + 1)*({})"}


def with_factor(name: str, way: str, *, every: int = 1) -> str:
    """A gallery system whose rows have a factor in front, or each ``every``-th of them."""
    data = yaml.safe_load(spec_path(name).read_text())
    data = {key: x for key, x in data.items() if key not in ("outputs", "scenes", "draw", "source")}
    data["parameters"] |= {"K": 1.5}
    for row in data["constraints"][::every]:
        row |= {label: FACTORS[way].format(text.replace(" = 0", "")) + " = 0" for label, text in row.items()}
    return yaml.safe_dump(data, sort_keys=False)


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", ["bicycle", "rattleback", "roller_racer", "n_trailer3", "n_snake3"])
@pytest.mark.parametrize("way", FACTORS)
def test_a_factor_of_a_row_is_all_the_same(name: str, way: str) -> None:
    for every in (1, 2):
        system = system_of(with_factor(name, way, every=every))
        assert cost(system, moving=True) <= gallery_cost(name) + 2  # the parameter itself
        assert assert_same(system) > 0


def test_factors_of_rows_are_taken_off() -> None:
    """Numbers, parameters, denominators; not what may vanish somewhere on the motion's way, and nothing from part of a row."""
    g = Graph()
    x, y, a, k, n, m = (g.symbol(name) for name in ("x'", "y'", "a", "k", "n", "m"))
    s, c, constants = g.function("sin", a), g.function("cos", a), g.mask([k, n, m])
    row = g.sub(g.mul(c, y), g.mul(s, x))

    def stripped(written: Node) -> Node:
        bare = strip_factor(g, written, constants, (x, y))
        assert are_equal(g, [written], [g.mul(bare.factor, bare.row)])
        return bare.row

    by_k = [g.product((k, turn, v)) for turn, v in ((c, y), (g.neg(s), x))]
    writings = [
        g.mul(g.number(2), row),
        g.product((k, n, row)),
        g.div(row, g.mul(n, g.number(3))),
        g.mul(g.add(k, n), row),
        g.sum(by_k),
        g.div(g.sum(by_k), m),
        g.sub(y, g.mul(g.div(s, c), x)),
        g.sub(g.div(y, s), g.div(x, c)),
    ]
    for written in writings:
        assert are_equal(g, [stripped(written)], [row]) or are_equal(g, [stripped(written)], [g.neg(row)])
    for written in (row, g.mul(x, row), g.add(row, g.product((k, n, x))), g.sub(y, g.product((k, g.div(s, c), x)))):
        assert strip_factor(g, written, constants, (x, y)).factor == g.one
    with_k = strip_factor(g, g.div(g.mul(k, row), n), constants, (x, y))
    assert with_k.divisors == (k,)  # where k is zero there is no constraint, and 1/n is never zero


@pytest.mark.parametrize("name", ["n_trailer3", "roller_racer"])
def test_a_row_whose_factor_is_zero_is_refused(name: str) -> None:
    """There is no such constraint then: results would be those of another system."""
    (text,) = emit(
        Source(f"{name}.yaml", with_factor(name, "by a parameter")), "python", Options(only=("rhs",))
    ).values()
    made = python_model(text, name)
    state = [0.3] * len(made.STATE)
    made.rhs(0.0, state, made.DEFAULTS)
    with pytest.raises(made.SingularModelError):
        made.rhs(0.0, state, (*made.DEFAULTS[:-1], 0.0))


@pytest.mark.parametrize("seed", range(6))
def test_sums_that_are_written_out_cost_about_the_same(seed: int) -> None:
    named, written = (system_of(planar_tree(seed, written=flag)) for flag in (False, True))
    assert cost(written, moving=True) <= 1.1 * cost(named, moving=True)


# --- vectors and axes ---------------------------------------------------------------------------------------


def test_a_chain_of_turns_is_read_from_its_components() -> None:
    g = Graph()
    a, b, x, p, q = (g.symbol(name, "coordinate") for name in "abxpq")
    inner = change_axes(g, (p, q, g.one), (Turn((0, 1), a), Turn((1, 2), b)), ())
    parts = Reader(g, g.mask((a, b, x))).peel((g.add(inner[0], x), inner[1], inner[2]))
    assert {part.path for part in parts} == {(), (Turn((0, 1), a), Turn((1, 2), b))}
    total = [g.zero] * 3
    for part in parts:
        total = [g.add(s, y) for s, y in zip(total, change_axes(g, part.local, part.path, ()), strict=True)]
    assert are_equal(g, total, [g.add(inner[0], x), inner[1], inner[2]])


def test_what_does_not_turn_is_not_read_as_turning() -> None:
    g = Graph()
    a, p = g.symbol("a", "coordinate"), g.symbol("p", "coordinate")
    stretched = (g.mul(p, g.function("cos", a)), g.mul(g.number(2), g.mul(p, g.function("sin", a))), g.zero)
    assert [part.path for part in Reader(g, g.mask((a,))).peel(stretched)] == [()]


@pytest.mark.parametrize("seed", range(4))
def test_axes_there_and_back(seed: int) -> None:
    g, draw = Graph(), random.Random(seed)
    planes = ((0, 1), (1, 2), (2, 0), (1, 0))
    turns = [Turn(draw.choice(planes), g.symbol(f"a{k}", "coordinate")) for k in range(6)]
    one, two = tuple(turns[:3]), (turns[0], *turns[3:])
    vector = tuple(g.symbol(f"v{k}", "other") for k in range(3))
    there = change_axes(g, (vector[0], vector[1], vector[2]), one, two)
    assert are_equal(g, change_axes(g, there, two, one), vector)


def test_spin_is_the_rate_of_the_axes() -> None:
    """d/dt of a vector fixed to the axes is Omega x vector, on any chain of turns."""
    g = Graph()
    angles = [g.symbol(f"a{k}", "coordinate") for k in range(3)]
    rates = dict(zip(angles, (g.symbol(f"r{k}", "velocity") for k in range(3)), strict=True))
    path = tuple(Turn(plane, angle) for plane, angle in zip(((0, 1), (2, 1), (0, 2)), angles, strict=True))
    spin = (g.zero, g.zero, g.zero)
    for turn in path:
        spin = add_spin(g, turn, spin, rates[turn.angle])
    x, y, z = (g.symbol(f"v{k}", "other") for k in range(3))
    moved = tangent(g, change_axes(g, (x, y, z), path, ()), rates)
    assert are_equal(g, change_axes(g, (moved[0], moved[1], moved[2]), (), path), cross(g, spin, (x, y, z)))


def test_gathered_sums_keep_their_value_and_their_operands() -> None:
    g = Graph()
    m, a = (g.symbol(name, "parameter") for name in "ma")
    v, w = (g.symbol(name, "quasi") for name in "vw")
    x, y = g.function("sin", g.symbol("x", "coordinate")), g.function("cos", g.symbol("y", "coordinate"))
    products = [(g.mul(m, x), g.mul(v, y)), (g.neg(g.mul(a, g.mul(m, y))), g.mul(w, x)), (g.mul(m, y), g.mul(v, x))]
    total = gather(g, products, g.mask((m, a)), g.mask((v, w)))
    plain = g.sum(g.mul(a, b) for a, b in products)
    assert are_zero(g, [g.sub(total, plain)]) == [True]
    assert count(g, [total]) < count(g, [plain])
    shared = g.mul(x, g.mul(m, y))  # m is inside: taking it out would make x*y a new product
    assert split(g, shared, g.mask((m,)), 0) == (g.one, g.one, shared)


GALLERY = ("bicycle", "snakeboard", "rattleback", "affine_voronec", "cvt", "rolling_disk")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "text", [*(planar_tree(seed) for seed in range(8)), *(spec_path(name).read_text() for name in GALLERY)]
)
def test_reactions_by_one_sweep(text: str) -> None:
    """What one reverse sweep of the virtual power gives is what the rows of the constraints' own vectors give, on all axes."""
    system = system_of(text)
    g, kinetic, swept_count = system.graph, kinetic_structure(system), [0, 0]
    for formulation in applicable(system):
        if formulation.frame is None:
            continue
        for moved in (move(system, kinetic, formulation.frame), None):
            route = _route(system, formulation, kinetic, moved)
            rates = route.motion.rates
            rows = [
                g.sub(g.sum(g.mul(m, rate) for m, rate in zip(row.mass, rates, strict=True)), row.force)
                for row in route.react()
            ]
            for swept in route.sweeps():
                swept_count[moved is None] += 1
                assert are_equal(g, swept, rows)
    assert swept_count[True] > 0


SIGNED = """nhc: 1
system: signed
coordinates: [x, y, theta, phi]
parameters: {m: 2, I: 3, a: 0.5, l: 0.7, K: -1.5, g: 1}
define:
  X: x + a*cos(theta)
  Y: y + a*sin(theta)
  P: x - l*cos(theta) - l*cos(phi)
  Q: y - l*sin(theta) - l*sin(phi)
T: m/2*(X'^2 + Y'^2) + I/2*theta'^2 + m/2*(P'^2 + Q'^2) + I/2*phi'^2
V: g*x^2 + g*y
quasi_velocities:
  v: cos(theta)*x' + sin(theta)*y'
  u: SIGN*(cos(theta)*y' - sin(theta)*x')
  w: theta'
  z: phi'
"""


@pytest.mark.sample(3)
@pytest.mark.parametrize("sign", ["sign(K)", "abs(K)/K", "sqrt(K^2)/K"])
@pytest.mark.parametrize("name", ["q1", "p", "r", "b", "kk"])
def test_a_quasi_velocity_with_a_sign_is_not_taken_for_the_component_without_it(name: str, sign: str) -> None:
    """In a prime field a sign is 1 at every second point: one name in four lost it, and the velocities came out wrong."""
    text = SIGNED.replace("SIGN", sign).replace("K", name)
    files = emit(Source("signed.yaml", text), "python", Options(formulation="euler-lagrange"))
    model = python_model(files["signed.py"], "signed")
    plain = python_model(
        emit(Source("signed.yaml", text), "python", Options(formulation="lagrange"))["signed.py"], "plain"
    )
    q, qdot, p = [0.3, -0.4, 0.7, 0.2], [0.5, 0.6, -0.8, 0.3], list(model.DEFAULTS)
    y = model.state(0.0, q, qdot, p)
    assert model.velocities(0.0, y, p) == pytest.approx(qdot, rel=1e-12)
    expected = plain.accelerations(0.0, plain.state(0.0, q, qdot, p), p)
    assert model.accelerations(0.0, y, p) == pytest.approx(expected, rel=1e-10)
