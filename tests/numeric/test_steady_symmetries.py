"""Steady motions that go along a symmetry: bends, circular orbits, turns in every formulation, against closed forms."""

from __future__ import annotations

import cmath
import json
import math
from collections.abc import Mapping
from pathlib import Path

import pytest

from nhc.algebra.exact.families import find_families
from nhc.algebra.exact.modular import FieldPoint, is_zero, rank
from nhc.algebra.exact.residues import PRIMES
from nhc.algebra.graph import Graph
from nhc.cli import main
from nhc.language import Source, read
from nhc.pipeline import Options, linearize
from nhc.study.linearization.field import SteadyModel
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import eigenvalues, verdict
from nhc.study.linearization.motion import Findings, Request
from nhc.study.linearization.turns import list_rates
from tests.numeric.test_linearize import IN_A_CYLINDER, matches
from tests.support import spec_path


def find(text: str, about: str, formulation: str = "") -> Findings:
    return linearize(Source("s.yaml", text), Request(about), Options(formulation=formulation))


def gallery(name: str, about: str, formulation: str = "") -> Findings:
    return linearize(read(str(spec_path(name))), Request(about), Options(formulation=formulation))


def along(found: Findings) -> dict[tuple[str, ...], float]:
    return dict(list_rates(found.linearisation.steady.turning, found.flow))


def state(found: Findings) -> dict[str, float]:
    return dict(zip(found.flow.names, found.linearisation.steady.y, strict=True))


@pytest.mark.parametrize("formulation", ["", "multipliers"])
def test_a_car_with_trailers_goes_round_a_bend(formulation: str) -> None:
    """The speed of an axle falls by cos a at each hitch, and all turn alike: w L = v_k sin a_k on links of length L."""
    found = gallery("n_trailer3", "v=1, w=0.3", formulation)
    here, speed = state(found), 1.0
    for k in range(3):
        angle = here[f"theta{k}"] - here[f"theta{k + 1}"]
        assert math.sin(angle) == pytest.approx(0.3 * 0.8 / speed, rel=1e-9)
        speed *= math.cos(angle)
    assert {names: rate for names, rate in along(found).items() if len(names) == 1} == pytest.approx(
        {(f"theta{k}",): 0.3 for k in range(4)}
    )
    assert found.linearisation.turns == 1 and verdict(found.linearisation) == "stable"
    assert not found.linearisation.steady.equilibrium


def test_a_car_with_trailers_straight_on_is_stable_whatever_its_heading() -> None:
    found = gallery("n_trailer3", "v=1")
    # a triple root: its digits are the third root of the rounding
    assert matches(eigenvalues(found.linearisation), [-1.25] * 3, 1e-4)
    assert verdict(found.linearisation) == "stable"


def baggage_train(carts: int) -> str:
    """A tug with carts, each hooked at M behind the axle of the one before and with its own axle at L behind the hook."""
    of = range(1, carts + 1)
    lines = ["nhc: 1", "system: train", f"coordinates: [x, y, th0, {', '.join(f'th{i}' for i in of)}]"]
    lines += ["parameters: {m: 1, J: 0.1, L: 0.7, M: 0.25}", "define:", "  x0: x", "  y0: y"]
    lines += [f"  x{i}: x{i - 1} - M*cos(th{i - 1}) - L*cos(th{i})" for i in of]
    lines += [f"  y{i}: y{i - 1} - M*sin(th{i - 1}) - L*sin(th{i})" for i in of]
    lines.append("T: " + " + ".join(f"m/2*(x{i}'^2 + y{i}'^2) + J/2*th{i}'^2" for i in (0, *of)))
    lines += ["constraints:", *(f"  - axle{i}: -sin(th{i})*x{i}' + cos(th{i})*y{i}' = 0" for i in (0, *of))]
    lines += ["quasi_velocities: {v: cos(th0)*x' + sin(th0)*y', w: th0'}"]
    lines += ["scenes: {bend: {initial: {v: 1, w: 0.2}, time: [0, 1]}}"]
    return "\n".join(lines) + "\n"


def test_a_long_train_is_found_in_its_bend_from_straight_on() -> None:
    """All hooks and axles go on circles: R_k^2 = R_(k-1)^2 + M^2 - L^2.  The angles add up to two radians."""
    source, request = Source("s.yaml", baggage_train(12)), Request("bend", holds=("v,w",))
    here, radius = state(linearize(source, request, Options())), 5.0
    for k in range(12):
        further = math.sqrt(radius**2 + 0.25**2 - 0.7**2)
        angle = math.atan(0.25 / radius) + math.atan(0.7 / further)
        assert here[f"th{k}"] - here[f"th{k + 1}"] == pytest.approx(angle, rel=1e-9)
        radius = further


def test_what_was_given_and_is_not_kept_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "train.yaml"
    spec.write_text(baggage_train(4))
    assert main(["linearize", str(spec), "--about", "bend"]) == 0
    assert "note: taken for a disturbance: w = 0.2 has become " in capsys.readouterr().out
    assert main(["linearize", str(spec), "--about", "bend", "--hold", "w"]) == 0
    assert "note: taken" not in capsys.readouterr().out


KEPLER = "nhc: 1\nsystem: s\ncoordinates: [x, y]\nparameters: {k: 2}\nT: (x'^2 + y'^2)/2\nV: -k/(x^2 + y^2)^(N/2)\n"


@pytest.mark.parametrize("power", [-2.0, 0.5, 1.0, 1.5])
def test_a_circular_orbit_sways_at_the_root_of_two_minus_the_power(power: float) -> None:
    """V = -k/r^n: the radius sways at sqrt(2 - n) of the angular velocity (Bertrand 1873)."""
    sign = 1 if power > 0 else -1
    found = find(KEPLER.replace("N", str(power)).replace("k: 2", f"k: {2 * sign}"), "x=1, y'=1.2")
    here = state(found)
    turning = here["y'"] / math.hypot(here["x"], here["y"])
    assert here["y'"] == pytest.approx(1.2, rel=1e-12) and along(found)[("x", "y")] == pytest.approx(turning)
    if power == -2.0:  # an isotropic spring also turns x against x'
        assert verdict(found.linearisation) in ("marginal", "none")
        return
    pair = turning * cmath.sqrt(power - 2)
    assert matches(eigenvalues(found.linearisation), [pair, -pair], 1e-9)


TRIANGLE = """nhc: 1
system: triangle
coordinates: [x1, y1, x2, y2, x3, y3]
parameters: {m1: 1, m2: 1, m3: 1, G: 1}
define:
  r12: sqrt((x1 - x2)^2 + (y1 - y2)^2)
  r13: sqrt((x1 - x3)^2 + (y1 - y3)^2)
  r23: sqrt((x2 - x3)^2 + (y2 - y3)^2)
T: m1/2*(x1'^2 + y1'^2) + m2/2*(x2'^2 + y2'^2) + m3/2*(x3'^2 + y3'^2)
V: -G*(m1*m2/r12 + m1*m3/r13 + m2*m3/r23)
"""


def test_lagranges_triangle_is_unstable_at_equal_masses() -> None:
    """Gascheau 1843: (l/w)^4 + (l/w)^2 + 27/4 s = 0 with s = (m1 m2 + m1 m3 + m2 m3)/(m1 + m2 + m3)^2; beside it +-i w, of the
    size of the triangle and of the centre of mass in axes that turn.
    """
    start = "x1=1, x2=-0.5, y2=0.87, x3=-0.5, y3=-0.87, y1'=0.76, x2'=-0.66, y2'=-0.38, x3'=0.66, y3'=-0.38"
    found = find(TRIANGLE, start)
    turning = along(found)[("x1", "y1")]
    squares = [turning**2 * (-1 + sign * cmath.sqrt(1 - 9)) / 2 for sign in (1, -1)]
    roots = [sign * cmath.sqrt(square) for square in squares for sign in (1, -1)]
    roots += [complex(0, sign * turning) for sign in (1, 1, -1, -1)]
    assert matches(eigenvalues(found.linearisation), roots, 1e-6)
    assert found.linearisation.turns == 3 and found.linearisation.family == 1


@pytest.mark.parametrize(("name", "about"), [("rolling_disk", "theta=1.2, w_u=0.65, w_n=-2.75")])
def test_multipliers_find_the_turn_that_the_others_find(name: str, about: str) -> None:
    kept, whole = gallery(name, about), gallery(name, about, "multipliers")
    assert matches(eigenvalues(whole.linearisation), eigenvalues(kept.linearisation), 1e-8)
    assert state(whole)["theta"] == pytest.approx(state(kept)["theta"], rel=1e-9)
    assert whole.linearisation.family == kept.linearisation.family and whole.linearisation.turns == 1
    assert ("x'", "y'") in along(whole)


def test_multipliers_find_the_sleeping_top_by_the_rates_of_its_quaternion() -> None:
    kept = gallery("heavy_top_quaternion", "w3=3")
    whole = gallery("heavy_top_quaternion", "w3=3", "multipliers")
    assert matches(eigenvalues(whole.linearisation), eigenvalues(kept.linearisation), 1e-8)
    assert verdict(whole.linearisation) == verdict(kept.linearisation) == "marginal"


def test_angular_velocities_in_space_turn_with_the_body_that_goes_round() -> None:
    """The ball in the cylinder of test_linearize where the spec keeps its angular velocity: wx and wy turn with phi.

    Else the spin about the normal is kept, and nothing turns with phi.
    """
    bare = IN_A_CYLINDER.split("quasi_velocities")[0]
    text = f"{bare}quasi_velocities: {{p: wx, q: wy, r: wz}}\n"
    found = find(text, "phi'=3")
    pair = cmath.sqrt(-2 / 7) * 3
    assert matches(eigenvalues(found.linearisation), [pair, -pair], 1e-9)
    assert along(found) == pytest.approx({("phi",): 3.0, ("wx", "wy"): 3.0})
    spun = find(bare, "phi'=3")
    assert matches(eigenvalues(spun.linearisation), [pair, -pair], 1e-9)
    assert along(spun) == {} and state(spun)["phi'"] == pytest.approx(3.0, rel=1e-12)


def test_what_goes_along_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["linearize", "n_trailer3", "--about", "v=1, w=0.3"]) == 0
    told = capsys.readouterr().out
    assert "at rest in axes that move with it: theta0, theta1, theta2, theta3 at 0.3\n" in told
    assert "1 direction left out: turns or shifts of the whole motion" in told
    assert main(["linearize", "n_trailer3", "--about", "v=1, w=0.3", "--json"]) == 0
    tree = json.loads(capsys.readouterr().out)
    assert [entry["entries"] for entry in tree["along"]] == [[f"theta{k}"] for k in range(4)]


def test_a_force_in_a_fixed_direction_leaves_no_circle() -> None:
    """None is made up where the equations are not those of all directions."""
    text = KEPLER.replace("N", "1.0").rstrip() + " + 0.3*x\n"
    with pytest.raises(NotSteady, match="steady"):
        linearize(Source("s.yaml", text), Request("x=1, y'=1.4", holds=("y'",)))


BOWL = "nhc: 1\nsystem: bowl\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nV: (x^2 + y^2)/2 - (x^2 + y^2)^2/8\n"


def test_who_asks_about_rest_gets_an_equilibrium() -> None:
    """Circles are near every place of a bowl; from rest the bottom is found, with speed the circle."""
    still = find(BOWL, "x=0.3, y=0.2")
    assert still.linearisation.steady.equilibrium and state(still)["x"] == pytest.approx(0, abs=1e-12)
    circle = find(BOWL, "x=0.6, y'=0.5")
    here = state(circle)
    radius = math.hypot(here["x"], here["y"])
    assert here["y'"] == pytest.approx(0.5, rel=1e-12) and not circle.linearisation.steady.equilibrium
    assert along(circle)[("x", "y")] ** 2 == pytest.approx(1 - radius**2 / 2, rel=1e-9)


def test_a_train_at_rest_is_undecided_to_first_order() -> None:
    """Wherever it stands it may stay, and what the matrix has is nilpotent: no rounding of it grows."""
    found = gallery("n_trailer3", "theta1=0.1, theta2=-0.2, theta3=0.3")
    assert found.linearisation.steady.equilibrium and found.linearisation.turns == 1
    assert eigenvalues(found.linearisation) == [0, 0] and verdict(found.linearisation) == "marginal"


def test_a_small_speed_that_was_set_by_hand_is_no_disturbance() -> None:
    """Of the scene's own velocities one with so little of the energy would be."""
    request = Request("reference", settings=("w=0.02",))
    found = linearize(read(str(spec_path("n_trailer3"))), request)
    assert state(found)["w"] == pytest.approx(0.02, rel=1e-11)


DRAG = "forces: {x: -v*x'/9, y: -v*y'/9, z: -v*z'/9}\n"


@pytest.mark.parametrize(
    ("start", "side", "drag"),
    [("z=-1, x=0.1", -1, ""), ("z=-1", -1, ""), ("z=1, x=1e-3, y=1e-4", 1, ""), ("z=-1, x=0.1, y'=0.1", -1, DRAG)],
)
def test_on_the_axis_of_a_turn_it_is_no_direction(start: str, side: int, drag: str) -> None:
    """A weight on a spring hangs or stands: two planes swing alike, although the start was beside the axis or went round it.

    A drag v sqrt(v^2) does nothing to first order, although its derivative as it is written is 0/0 at rest.
    """
    text = "nhc: 1\nsystem: spring\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nV: 25*(r - 1)^2 + 10*z\n" + drag
    found = find(text + "define: {r: sqrt(x^2 + y^2 + z^2), v: sqrt(x'^2 + y'^2 + z'^2)}\n", start)
    length = 1 - side * 10 / 50
    swing = cmath.sqrt(side * 10 / length)
    up = 1j * math.sqrt(50)
    assert found.linearisation.turns == 0 and along(found) == {}
    assert matches(eigenvalues(found.linearisation), [swing, swing, -swing, -swing, up, -up], 1e-9)


GEARS = """nhc: 1
system: gears
coordinates: [a, b, c, x]
parameters: {r1: 0.3, r2: 0.5, r3: 0.2, k: 20, J: 0.1, W: 1}
T: J/2*(a'^2 + 2*b'^2 + 3*c'^2 + x'^2)
V: k/2*((r1*a - r2*b)^2*(1 + x^2) + (r2*b - r3*c)^2 + x^2)
"""


def test_gears_turn_by_their_radii() -> None:
    """No coordinate is cyclic; what leaves the field alone is (1/r1, 1/r2, 1/r3), and so on paper and along a sweep."""
    found = find(GEARS, "a'=W/r1, b'=W/r2, c'=W/r3")
    assert found.linearisation.turns == 1 and not found.linearisation.steady.equilibrium
    assert along(found) == pytest.approx({("a",): 1 / 0.3, ("b",): 2.0, ("c",): 5.0}, rel=1e-12)
    assert "k*r1*r2/J" in {entry.replace(" ", "") for row in found.paper for entry in row}
    swept = linearize(Source("s.yaml", GEARS), Request("a'=1", holds=("a'=1",), sweep=("r1", 0.2, 0.8, 3))).swept
    assert swept is not None
    for r1, point in zip(swept.values, swept.points, strict=True):
        assert point.steady.y[4:7] == pytest.approx([1.0, r1 / 0.5, r1 / 0.2], rel=1e-9)
    still = find(GEARS.replace("r3*c)^2", "r3*c)^2 + a^2"), "a'=W/r1, b'=W/r2, c'=W/r3")
    assert still.linearisation.turns == 0 and still.linearisation.steady.equilibrium


def test_relations_by_rational_functions_of_parameters() -> None:
    """Their ratios are those of the sheet; what has a degree beyond two is not made up."""
    g = Graph()
    r, s, x, y = (g.symbol(name, "any") for name in "rsxy")
    prime = PRIMES[0]

    def find_of(nodes: list[int]) -> list[list[int] | None]:
        def sample(fixed: Mapping[int, int]) -> list[list[int]]:
            return [FieldPoint(g, seed, prime).evaluate(nodes, fixed) for seed in range(len(nodes) + 4)]

        return find_families(g, [r, s], sample, len(nodes), prime)

    def times(*factors: int) -> int:
        return g.product(factors)

    def check(nodes: list[int], *expected: list[int]) -> None:
        found = find_of(nodes)
        rows = [row for row in found if row is not None]
        assert len(found) == len(rows) == len(expected)
        assert all(is_zero(g, g.dot(row, nodes)) for row in rows)
        assert rank(g, [*rows, *expected]) == rank(g, expected) == len(rows)

    one, minus, none = g.one, g.number(-1), g.zero
    check([times(r, x), times(s, x)], [s, g.neg(r)])
    wide = [times(g.add(r, s), x), times(x, y), times(s, s, x), times(x, y, r, s)]
    check(wide, [times(s, s), none, g.neg(g.add(r, s)), none], [none, times(r, s), none, minus])
    check([x, y, g.add(x, times(r, y))], [one, r, minus])
    assert find_of([x, times(r, r, r, x)]) == [None]
    assert find_of([x, times(g.function("sin", r), y)]) == []


BALLS = """nhc: 1
system: two_balls
coordinates: [x, y, th, ph]
rotation:
  R: {velocities: [w1, w2, w3], frame: space}
  S: {velocities: [u1, u2, u3], frame: space}
parameters: {a: 1, m: 1, M: 2, g: 9.81, b: 0.5}
define: {nx: sin(th)*cos(ph), ny: sin(th)*sin(ph), nz: cos(th), X: x + (a + b)*nx, Y: y + (a + b)*ny, Z: (a + b)*nz}
T: m/2*(x'^2 + y'^2) + m*a^2/5*(w1^2 + w2^2 + w3^2) + M/2*(X'^2 + Y'^2 + Z'^2) + M*b^2/5*(u1^2 + u2^2 + u3^2)
V: M*g*Z
constraints:
  - x' - a*w2 = 0
  - y' + a*w1 = 0
  - X' - (x' + (a*w2 + b*u2)*nz - (a*w3 + b*u3)*ny) = 0
  - Y' - (y' + (a*w3 + b*u3)*nx - (a*w1 + b*u1)*nz) = 0
"""


@pytest.mark.parametrize(
    ("about", "where"), [("th=0", "where the search begins"), ("th=0.001", "at the steady motion")]
)
def test_an_azimuth_at_its_pole_is_named(about: str, where: str) -> None:
    """The balls' orientations are rotations, and no orientation is to blame where the place of contact has lost its azimuth."""
    with pytest.raises(NotSteady, match=f"{where}.*: `ph'` moves nothing there, as an azimuth at its pole") as told:
        find(BALLS, about)
    assert "rotation" not in told.value.advice


def test_a_search_that_runs_off_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """Not with the words of the C library."""

    def overflow(*_: object) -> None:
        raise OverflowError(34, "Numerical result out of range")

    monkeypatch.setattr(SteadyModel, "field", overflow)
    with pytest.raises(NotSteady, match=r"^the search for a steady motion runs off$"):
        find(GEARS, "a'=1")
