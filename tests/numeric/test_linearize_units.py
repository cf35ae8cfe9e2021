"""What a linearisation finds is the same in every unit of length and time, and beside something much faster.

The eigenvalues of a gallery motion are compared with themselves after lengths and times are counted in other units; the orbit of a
planet, resonators and slow instabilities with their closed forms.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence

import numpy as np
import pytest

from nhc.language import Source
from nhc.pipeline import linearize
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import eigenvalues, verdict
from nhc.study.linearization.motion import Findings, Request
from tests.numeric.test_linearize import find, matches
from tests.support import seldom


def study(text: str, about: str, sweep: tuple[str, float, float, int] | None = None) -> Findings:
    return linearize(Source("made.yaml", f"nhc: 1\nsystem: made\n{text}"), Request(about, sweep=sweep))


def agree(found: Findings, expected: Sequence[complex], tolerance: float = 1e-9) -> bool:
    """Each relative to its own size."""
    values = eigenvalues(found.linearisation)
    return len(values) == len(expected) and all(
        min(abs(x - y) for y in values) <= tolerance * max(abs(x), 1e-300) for x in expected
    )


TWO = """
coordinates: [x, y]
parameters: {k1: 1, k2: 1, c1: 0, c2: 0}
T: (x'^2 + y'^2)/2
V: k1*x^2/2 + k2*y^2/2
forces: {x: -c1*x', y: -c2*y'}
"""


@pytest.mark.parametrize("k", [1e-24, 1e-18, 1e-9, 1.0, 1e9, 1e12, 1e18])
@pytest.mark.parametrize("sign", [1, -1])
def test_an_oscillator_of_any_frequency(k: float, sign: int) -> None:
    found = study("coordinates: [x]\nparameters: {k: 1}\nT: x'^2/2\nV: k*x^2/2\n", f"x=0.3, k={sign * k!r}")
    root = cmath.sqrt(-sign * k)
    assert found.linearisation.family == 0 and agree(found, [root, -root])
    assert abs(found.linearisation.steady.y[0]) < 1e-9
    assert verdict(found.linearisation) == ("marginal" if sign > 0 else "unstable")


def test_a_slow_mode_beside_a_fast_one() -> None:
    found = study(TWO, "k1=1e12, k2=1")
    assert found.linearisation.family == 0 and agree(found, [1e6j, -1e6j, 1j, -1j])


@pytest.mark.parametrize("k", [1.0, 1e8, 1e12])
@pytest.mark.parametrize(("c", "expected"), [(0.01, "stable"), (-0.01, "unstable"), (0.0, "marginal")])
def test_a_small_damping_beside_a_fast_mode_decides(k: float, c: float, expected: str) -> None:
    """Real parts of 0.005 are no rounding beside 1e6 rad/s, for they are those of another mode."""
    found = study(TWO, f"k1={k!r}, c1=0.02, k2=1, c2={c!r}")
    assert verdict(found.linearisation) == expected
    slow = cmath.sqrt(c * c / 4 - 1)
    fast = cmath.sqrt(1e-4 - k)
    assert agree(found, [-c / 2 + slow, -c / 2 - slow, -0.01 + fast, -0.01 - fast])


@pytest.mark.parametrize("force", ["1e-10*x", "100*y + 1e12*x^2/2", "1e-3*y + x^2/2"])
def test_nothing_stands_still_under_a_constant_force(force: str) -> None:
    """However small the rate, and however fast the rest: no equilibrium, and no verdict about one."""
    with pytest.raises(NotSteady):
        study(f"coordinates: [x, y]\nT: (x'^2 + y'^2)/2\nV: {force}\n", "x=0.1")


def test_the_orbit_of_a_planet_in_metres_and_seconds() -> None:
    """A circle has r^3 phi'^2 = G M; what is near it swings with the same frequency (Kepler)."""
    text = "coordinates: [r, phi]\nparameters: {GM: 1.32712440018e20}\nT: (r'^2 + r^2*phi'^2)/2\nV: -GM/r\n"
    found = study(text, "r=1.495978707e11, phi'=1.99e-7")
    steady = found.linearisation.steady
    r, rate = steady.y[0], steady.y[3]
    assert not steady.equilibrium and r == pytest.approx(1.496e11, rel=1e-3)
    assert r**3 * rate**2 == pytest.approx(1.32712440018e20, rel=1e-12)
    assert found.linearisation.family == 1 and agree(found, [1j * rate, -1j * rate])


def test_a_swept_instability_of_a_slow_system() -> None:
    """A bead on a hoop of a kilometre that turns once in weeks leaves the bottom at W^2 = g/R."""
    text = "coordinates: [x]\nparameters: {W: 1e-6, g: 1e-9, R: 1000}\nT: R^2*(x'^2 + W^2*sin(x)^2)/2\nU: g*R*cos(x)\n"
    found = study(text, "x=0", ("W", 5e-7, 1.4e-6, 4))
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(1e-6, rel=1e-9) and crossing.unstable_above


@pytest.mark.sample(2)
@pytest.mark.parametrize("count", [2, 3, 5, 6])
def test_a_crossing_is_found_also_where_a_value_of_the_sweep_meets_it(count: int) -> None:
    """k = 0 is the third of five values, and the middle of three: an exact zero is on neither side."""
    text = "coordinates: [x]\nparameters: {k: 1}\nT: x'^2/2\nV: k*x^2/2\n"
    found = study(text, "x=0", ("k", -1.0, 1.0, count))
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    assert abs(crossing.value) < 1e-12 and not crossing.unstable_above
    hoop = "coordinates: [x]\nparameters: {W: 1}\nT: (x'^2 + W^2*sin(x)^2)/2\nU: cos(x)\n"
    swept = study(hoop, "x=0", ("W", 0.0, 2.0, count)).swept
    assert swept is not None and [c.value for c in swept.crossings] == pytest.approx([1.0], abs=1e-9)


def test_a_frequency_that_touches_zero_at_a_value_of_the_sweep_is_no_crossing() -> None:
    """In axes that turn with the top one frequency is zero at w3 = 2 and comes back: the determinant does not change its sign."""
    found = find("heavy_top_quaternion", "w3=1.5", sweep=("w3", 1.5, 2.5, 5))
    assert found.swept is not None
    assert [c.value for c in found.swept.crossings] == pytest.approx([math.sqrt(32) / 3], abs=1e-7)


@pytest.mark.parametrize("k", [1e300, -1e150, 1e-300])
def test_numbers_near_the_ends_of_what_a_double_holds(k: float) -> None:
    found = study("coordinates: [x]\nparameters: {k: 1}\nT: x'^2/2\nV: k*x^2/2\n", f"x=0, k={k!r}")
    assert agree(found, [cmath.sqrt(-k), -cmath.sqrt(-k)])


@pytest.mark.parametrize("length", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("time", [1e-9, 1.0, 1e9])
def test_the_disk_in_other_units(length: float, time: float) -> None:
    """m = 1 kg; lengths are R = 0.5 and times 1 s, counted in other units."""
    l2, rate = length**2, 1.0 / time
    pairs = {"R": 0.5 * length, "A": 0.0625 * l2, "C": 0.125 * l2, "g": 9.81 * length * rate**2}
    settings = ", ".join(f"{name}={value!r}" for name, value in pairs.items())
    for speed, expected in ((3.0, "marginal"), (2.0, "unstable")):
        found = find("rolling_disk", f"theta=pi/2, w_n={speed * rate!r}", settings=(settings,))
        made, same = found.linearisation, find("rolling_disk", f"theta=pi/2, w_n={speed!r}").linearisation
        assert verdict(made) == verdict(same) == expected
        assert made.family == same.family and len(made.basis) == len(same.basis)
        assert matches([x * time for x in eigenvalues(made)], eigenvalues(same), 1e-9)
        assert np.all(np.isfinite(made.full)) and made.steady.y[3] == pytest.approx(math.pi / 2, abs=1e-9)


@pytest.mark.parametrize("time", [1e-7, seldom(1e7)])
def test_the_bicycle_in_another_unit_of_time(time: float) -> None:
    rate = 1.0 / time
    about = f"z=-0.3, thR'={-5 * rate!r}/r_R"
    found = find("bicycle", about, "voronec", settings=(f"g={9.81 * rate**2!r}",)).linearisation
    same = find("bicycle", "z=-0.3, thR'=-5/r_R", "voronec").linearisation
    assert verdict(found) == "stable" and found.family == same.family
    assert matches([x * time for x in eigenvalues(found)], eigenvalues(same), 1e-8)


@pytest.mark.parametrize(
    "forces", ["-x - sign(x')/10", "-max(x, 0) - x'", "-x - x'*abs(x)/x'^2*x'", "-abs(x) - x", "-x - 3*max(x', 2*x')"]
)
def test_no_matrix_where_the_field_jumps_or_bends(forces: str) -> None:
    """Dry friction, a stop: the derivative by convention is that of neither side, and no verdict rests on it."""
    with pytest.raises(NotSteady, match=r"jump or a kink|singular"):
        study(f'coordinates: [x]\nT: x\'^2/2\nforces: {{x: "{forces}"}}\n', "x=0")


def test_rounded_friction_and_short_lengths_have_a_matrix() -> None:
    found = study("coordinates: [x]\nT: x'^2/2\nforces: {x: -x - tanh(x'/1e-3)}\n", "x=0")
    assert verdict(found.linearisation) == "stable"
    atoms = "coordinates: [x]\nparameters: {s: 3e-10}\nT: x'^2/2\nV: ((s/(s + x))^12 - 2*(s/(s + x))^6)\n"
    near = study(atoms, "x=0")
    assert agree(near, [1j * math.sqrt(72) / 3e-10, -1j * math.sqrt(72) / 3e-10])


@pytest.mark.parametrize("length", [1e-9, 1e-6, 1.0, 1e6, 1e9])
def test_a_pendulum_on_a_circle_of_any_size(length: float) -> None:
    """A holonomic constraint: x^2 + y^2 is 1e-18 or 1e18 of the spec's units."""
    about = f"x={0.6 * length!r}, y={-0.8 * length!r}, l={length!r}"
    made = find("holonomic_pendulum", about, "multipliers").linearisation
    root = 1j * math.sqrt(9.81 / length)
    assert made.steady.y[1] == pytest.approx(-length, rel=1e-9) and len(made.basis) == 2 and made.family == 0
    assert matches([x / abs(root) for x in eigenvalues(made)], [1j, -1j], 1e-8)
