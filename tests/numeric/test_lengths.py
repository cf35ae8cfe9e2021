"""T that holds the rate of a length: a form as it stands, in which springs, dampers and masses along it meet."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.energies.kinetic import kinetic_structure
from nhc.pipeline import Options, model, program

LEGS = ((0.5, 0.1), (0.5, -0.1), (-0.2, -0.5), (-0.3, -0.4), (-0.3, 0.4), (-0.2, 0.5))


def legs(count: int, *, turning: bool) -> Source:
    """A body on legs with springs and dampers, and a mass in each that moves along it as the leg grows longer."""
    places = range(count)
    at = {k: f"{LEGS[k][0]}, {LEGS[k][1]}".split(", ") for k in places}
    moved = {
        k: [f"{c} + R_{c}1*{a} + R_{c}2*{b}" if turning else f"{c} + {a}" for c in "xyz"] for k, (a, b) in at.items()
    }
    lines = [f"L{k}: sqrt({' + '.join(f'({x} - {2 * LEGS[k][0]})^2' for x in moved[k])})" for k in places]
    spins = "rotation: {R: {velocities: [p, q, r]}}\n" if turning else ""
    kinetic = "m/2*(x'^2 + y'^2 + z'^2)" + (" + (A*p^2 + B*q^2 + C*r^2)/2" if turning else "")
    text = f"""nhc: 1
system: legs
coordinates: [x, y, z]
{spins}parameters: {{m: 20, A: 2, B: 2.2, C: 4, ml: 1, k: 800, c: 30, l: 1.3, g: 9.81}}
define:
  {(chr(10) + "  ").join(lines)}
T: {kinetic}{"".join(f" + ml/2*L{k}'^2" for k in places)}
V: m*g*z{"".join(f" + k/2*(L{k} - l)^2" for k in places)}
forces: {{{", ".join(f"L{k}: -c*L{k}'" for k in places)}}}
"""
    return Source("legs.yaml", text)


@pytest.mark.parametrize("turning", [False, True])
def test_the_rate_of_a_length_is_a_form_of_constant_inertia(turning: bool) -> None:
    made = model(legs(2, turning=turning))
    system = made.system
    kinetic = kinetic_structure(system)
    assert all(kinetic.is_exact(k) for k, u in enumerate(kinetic.u) if k >= len(kinetic.u) - 2)
    assert not any(system.graph.depends(h, ~system.graph.mask(system.p)) for row in kinetic.hessian for h in row)
    assert all(agreement.accelerations for agreement in certify(system, points=1).agreements)


def test_a_platform_on_six_legs() -> None:
    """A form x x' + y y' + z z' over a moving inertia ml/L^2 would take a sixth more."""
    (rhs,) = program(legs(6, turning=True), Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications + rhs.divisions < 1250
