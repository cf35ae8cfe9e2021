"""Velocities and energies that were written out cost what positions do, and move the system as these do."""

from __future__ import annotations

import random

import pytest

from benchmarks.systems import spec
from nhc.algebra.calculus import tangent
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.emit import EmitOptions, render
from nhc.mechanics.energies.kinetic import velocity_forms
from nhc.mechanics.energies.positions import find_positions, position_of
from nhc.mechanics.rotations.turning import along
from nhc.mechanics.trees.triples import place_of
from nhc.program.ir import Program
from tests.numeric.test_squares import operations, program_of, system_of
from tests.support import python_model


def with_form(form: str) -> str:
    """A system whose T has one form of several velocities, and its coordinates."""
    return (
        "nhc: 1\nsystem: one\ncoordinates: [x, a, b, r]\nparameters: {l: 0.7, k: 2, w: 3}\n"
        f"T: (x'^2 + a'^2 + b'^2 + r'^2)/2 + ({form})^2/2\n"
    )


@pytest.mark.parametrize(
    "form",
    [
        "x' + l*cos(a)*a'",
        "l*cos(a)*cos(b)*a' - l*sin(a)*sin(b)*b'",
        "x' + r'*sin(a) + r*cos(a)*a'",
        "x' - l*sin(a + b)*(a' + b') - r*sin(b)*b' + cos(b)*r'",
        "l*cos(2*a - b)*(2*a' - b') + 3*x^2*x'",
        "x' + l*cos(w*t)*w + cos(a)*a'",
        "2*r*r'*cos(a) - r^2*sin(a)*a'",
        "x'*t + x + sin(b)*b'",
    ],
)
def test_an_exact_form_is_the_rate_of_what_it_integrates_to(form: str) -> None:
    system = system_of(with_form(form))
    g = system.graph
    (own,) = (atom for atom in velocity_forms(system) if atom not in system.v)
    find_positions(system, [own])
    place, sign = place_of(g, own)
    assert place != g.zero
    (rate,) = tangent(g, [place], {**along(system, system.v), system.t: g.one})
    assert are_equal(g, [rate], [g.scale(sign, own)])


@pytest.mark.parametrize(
    "form",
    [
        "cos(a)*x' + sin(a)*b'",  # along a direction that turns
        "sin(a)*b' + cos(b)*a'",
        "r*a' + x'*cos(b)",
        "a'*cos(b) + b'*cos(a)",
        "x'*exp(a)*a + a'*x",
        "x' + l*cos(w*t)*a'",
        "x'/r + a'*cos(a)",
        "x' + cos(k*a)*a'",  # no position without a division by k, which may be zero
        "x' + sin(a)*cos(a)*a'",  # exact, but of no point on a link
    ],
)
def test_other_forms_have_no_position(form: str) -> None:
    system = system_of(with_form(form))
    g = system.graph
    (own,) = (atom for atom in velocity_forms(system) if atom not in system.v)
    find_positions(system, [own])
    assert place_of(g, own) == (g.zero, 1)


def test_of_what_is_not_integrated_nothing_is_kept() -> None:
    system = system_of(with_form("a'*cos(b) + b'*cos(a)"))
    (own,) = (atom for atom in velocity_forms(system) if atom not in system.v)
    assert position_of(system, own) is None


# --- systems -------------------------------------------------------------------------------------------------------


def _values(count: int) -> str:
    values = {f"{name}{k}": round(0.4 + 0.1 * k + i, 2) for k in range(1, count + 1) for i, name in enumerate("ml")}
    return ", ".join(f"{name}: {value}" for name, value in values.items())


def spherical(count: int, by: str) -> str:
    """Point masses on rods in space: by positions, by velocities, or with both energies as sums over pairs of rods."""
    rods = range(1, count + 1)
    head = (
        f"nhc: 1\nsystem: rods\ncoordinates: [{', '.join(f'a{k}, b{k}' for k in rods)}]\n"
        f"parameters: {{g: 9.81, {_values(count)}}}\n"
    )
    beyond = {k: "(" + " + ".join(f"m{i}" for i in range(k, count + 1)) + ")" for k in rods}
    weight = " ".join(f"- {beyond[k]}*g*l{k}*cos(b{k})" for k in rods)
    if by == "energies":
        terms = []
        for j in rods:
            terms.append(f"{beyond[j]}*l{j}^2/2*(b{j}'^2 + sin(b{j})^2*a{j}'^2)")
            for i in range(1, j):
                near, turned = f"cos(a{i} - a{j})", f"sin(a{i} - a{j})"
                terms.append(
                    f"{beyond[j]}*l{i}*l{j}*(b{i}'*b{j}'*(cos(b{i})*cos(b{j})*{near} + sin(b{i})*sin(b{j}))"
                    f" + a{i}'*a{j}'*sin(b{i})*sin(b{j})*{near} + b{i}'*a{j}'*cos(b{i})*sin(b{j})*{turned}"
                    f" - a{i}'*b{j}'*sin(b{i})*cos(b{j})*{turned})"
                )
        return f"{head}T: {' + '.join(terms)}\nV: '{weight}'\n"
    define = []
    for k in rods:
        before = {axis: f"{axis}{k - 1} + " if k > 1 else "" for axis in "xyz"}
        own = {"x": f"l{k}*sin(b{k})*cos(a{k})", "y": f"l{k}*sin(b{k})*sin(a{k})", "z": f"(-l{k}*cos(b{k}))"}
        if by == "velocities":
            own = {
                "x": f"l{k}*(cos(b{k})*cos(a{k})*b{k}' - sin(b{k})*sin(a{k})*a{k}')",
                "y": f"l{k}*(cos(b{k})*sin(a{k})*b{k}' + sin(b{k})*cos(a{k})*a{k}')",
                "z": f"l{k}*sin(b{k})*b{k}'",
            }
        define += [f"  {axis}{k}: {before[axis]}{own[axis]}" for axis in "xyz"]
    prime = "'" if by == "positions" else ""
    squares = " + ".join(f"m{k}/2*(x{k}{prime}^2 + y{k}{prime}^2 + z{k}{prime}^2)" for k in rods)
    potential = " + ".join(f"m{k}*g*z{k}" for k in rods) if by == "positions" else weight
    return head + "define:\n" + "\n".join(define) + f"\nT: {squares}\nV: '{potential}'\n"


def hanging(count: int, by: str) -> str:
    """Pendulums on one another in a plane, as books have them."""
    rods = range(1, count + 1)
    head = (
        f"nhc: 1\nsystem: rods\ncoordinates: [{', '.join(f'a{k}' for k in rods)}]\n"
        f"parameters: {{g: 9.81, {_values(count)}}}\n"
    )
    if by == "positions":
        define, squares = list[str](), list[str]()
        for k in rods:
            before = [f"{axis}{k - 1} + " if k > 1 else "" for axis in "xy"]
            define += [f"  x{k}: {before[0]}l{k}*sin(a{k})", f"  y{k}: {before[1]}(-l{k}*cos(a{k}))"]
            squares.append(f"m{k}/2*(x{k}'^2 + y{k}'^2)")
        heights = " + ".join(f"m{k}*g*y{k}" for k in rods)
        return head + "define:\n" + "\n".join(define) + f"\nT: {' + '.join(squares)}\nV: {heights}\n"
    beyond = {k: "(" + " + ".join(f"m{i}" for i in range(k, count + 1)) + ")" for k in rods}
    terms = [f"{beyond[k]}*l{k}^2/2*a{k}'^2" for k in rods]
    terms += [f"{beyond[j]}*l{i}*l{j}*a{i}'*a{j}'*cos(a{i} - a{j})" for j in rods for i in range(1, j)]
    return f"{head}T: {' + '.join(terms)}\nV: -({' + '.join(f'{beyond[k]}*g*l{k}*cos(a{k})' for k in rods)})\n"


def arm(count: int, by: str) -> str:
    """Of links, by the angles of their joints."""
    text = spec(f"written_out_arm{count}").replace(f"written_out_arm{count}", "rods")
    if by == "energies":
        return text
    links = range(1, count + 1)
    define, kinetic = list[str](), list[str]()
    for k in links:
        turn = " + ".join(f"q{i}" for i in range(1, k + 1))
        rate = " + ".join(f"q{i}'" for i in range(1, k + 1))
        for axis, name in (("x", "cos"), ("y", "sin")):
            before = f"{axis}{k - 1} + " if k > 1 else ""
            define += [f"  {end}{axis}{k}: {before}{size}{k}*{name}({turn})" for end, size in (("", "l"), ("c", "s"))]
        kinetic.append(f"m{k}/2*(cx{k}'^2 + cy{k}'^2) + I{k}/2*({rate})^2")
    head = text[: text.index("T:")]
    potential = " + ".join(f"m{k}*g*cy{k}" for k in links)
    return head + "define:\n" + "\n".join(define) + f"\nT: {' + '.join(kinetic)}\nV: {potential}\n"


def crane(_: int, by: str) -> str:
    """A trolley on a bridge, and a load on a rope of changing length."""
    head = "nhc: 1\nsystem: rods\ncoordinates: [x, y, l, a, b]\nparameters: {M: 2, N: 1, m: 1.5, g: 9.81, k: 30}\n"
    if by == "positions":
        return head + (
            "define:\n  X: x + l*sin(a)*cos(b)\n  Y: y + l*sin(b)\n  Z: -l*cos(a)*cos(b)\n"
            "T: M/2*x'^2 + N/2*y'^2 + m/2*(X'^2 + Y'^2 + Z'^2)\nV: m*g*Z + k*(l - 1)^2\n"
        )
    return head + (
        "T: M/2*x'^2 + N/2*y'^2 + m/2*(x'^2 + y'^2 + l'^2 + l^2*cos(b)^2*a'^2 + l^2*b'^2)"
        " + m*x'*(l'*sin(a)*cos(b) + l*a'*cos(a)*cos(b) - l*b'*sin(a)*sin(b)) + m*y'*(l'*sin(b) + l*b'*cos(b))\n"
        "V: -m*g*l*cos(a)*cos(b) + k*(l - 1)^2\n"
    )


SYSTEMS = {"spherical": spherical, "hanging": hanging, "arm": arm, "crane": crane}
CASES = [
    *(("spherical", n, "velocities", 1.0) for n in (2, 5)),
    *(("spherical", n, "energies", 1.01) for n in (3, 5)),
    *(("hanging", n, "energies", 1.0) for n in (3, 6)),
    *(("arm", n, "energies", 1.05) for n in (3, 4, 6)),
    ("crane", 0, "energies", 1.0),
]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("family", "count", "by", "longer"), CASES)
def test_it_is_the_system_of_its_positions_and_as_short(family: str, count: int, by: str, longer: float) -> None:
    """``longer``: operations against those of the positions."""
    plain, written = (program_of(system_of(SYSTEMS[family](count, way))) for way in ("positions", by))
    assert operations(written) <= longer * operations(plain)
    first, second = (_model(program) for program in (plain, written))
    draw = random.Random(f"{family} {count}")
    for _ in range(3):
        y = [draw.uniform(0.3, 1.1) for _ in first.STATE]
        assert second.rhs(0.3, y) == pytest.approx(first.rhs(0.3, y), rel=1e-10, abs=1e-10)


@pytest.mark.parametrize(("family", "count", "by"), [("spherical", 4, "velocities"), ("arm", 4, "energies")])
def test_without_the_rule_it_is_longer_and_the_same(family: str, count: int, by: str) -> None:
    text = SYSTEMS[family](count, by)
    found, without = program_of(system_of(text)), program_of(system_of(text, WithoutRules(["found positions"])))
    assert operations(found) < 0.95 * operations(without)
    first, second = _model(found), _model(without)
    y = [0.3 + 0.1 * k for k in range(len(first.STATE))]
    assert second.rhs(0.3, y) == pytest.approx(first.rhs(0.3, y), rel=1e-10, abs=1e-10)


def test_elastic_pendulums_are_solved_for_the_accelerations_of_their_points() -> None:
    """As many forms as coordinates, all rates of positions: T is diagonal in them."""
    text = (
        "nhc: 1\nsystem: rods\ncoordinates: [r, a, s, b]\nparameters: {g: 9.81, k: 30, m: 1.1, M: 1.2}\n"
        "define:\n  x1: r*sin(a)\n  y1: -r*cos(a)\n  x2: x1 + s*sin(b)\n  y2: y1 - s*cos(b)\n"
        "T: m/2*(x1'^2 + y1'^2) + M/2*(x2'^2 + y2'^2)\nV: m*g*y1 + M*g*y2 + k/2*((r - 1)^2 + (s - 1)^2)\n"
    )
    found, without = program_of(system_of(text)), program_of(system_of(text, WithoutRules(["detours"])))
    assert operations(found) < 0.6 * operations(without)
    first, second = _model(found), _model(without)
    y = [0.9, 0.4, 1.2, -0.3, 0.5, 0.7, -0.4, 1.1]
    assert second.rhs(0.3, y) == pytest.approx(first.rhs(0.3, y), rel=1e-11, abs=1e-11)


def _model(program: Program):  # type: ignore[no-untyped-def]
    return python_model(render(program, "python", EmitOptions())["rods.py"], "rods")
