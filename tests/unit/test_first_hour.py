"""What a student writes in the first hour: the help that nhc gives, when it is followed, leads to a spec that holds."""

from __future__ import annotations

import pytest

from tests.unit.slips import Slip, assert_helps, find

SPEC = """nhc: 1
system: first
coordinates: [x, θ]
parameters: {m: 2, l: 0.5, g: 9.81}
define: {X: x + l*sin(θ)}
T: m/2*X'^2 + m/2*(l*cos(θ))'^2 + x'^2
V: -m*g*l*cos(θ)
scenes:
  go: {initial: {θ: 0.1, x': 1}, time: [0, 10], need: [x, θ']}
"""
SLIPS: list[Slip] = [
    ("+ x'^2", "+ ẋ^2", "E0302", "the velocity is written `x'`", "+ x'^2"),
    ("+ x'^2", "+ θ̇^2", "E0302", "the velocity is written `theta'`", "+ θ'^2"),
    ("+ x'^2", "+ ẍ^2", "E0302", "accelerations are what nhc derives", "+ x'^2"),
    ("+ x'^2", "+ x_dot^2", "E0302", "the velocity is written `x'`", "+ x'^2"),
    ("+ x'^2", "+ (dx/dt)^2", "E0209", "write `x'`", "+ x'^2"),
    ("+ x'^2", "+ m*dtheta/dt*l*x'", "E0209", "write `theta'`", "+ m*theta'*l*x'"),
    ("+ x'^2", "+ m/dt", "E0209", "a velocity is written with a prime", "+ m*x'"),
    ("+ x'^2", "+ ½*x'^2", "E0201", "write `1/2`", "+ 1/2*x'^2"),
    ("+ x'^2", "+ x'⁴", "E0201", "write `^4`", "+ x'^4"),
    ("+ x'^2", "+ x`^2", "E0201", "the plain prime", "+ x'^2"),
    ("+ x'^2", "+ √(m)*x'^2", "E0201", "write `sqrt(...)`", "+ sqrt(m)*x'^2"),
    ("+ x'^2", "+ 1 000*x'^2", "E0203", "`1000`", "+ 1000*x'^2"),
    ("coordinates: [x, θ]", "coordinates: [x, θ, X]", "E0305", "leave `X` out of `coordinates`", "coordinates: [x, θ]"),
    ("l: 0.5", "l: m/4", "E0314", "move the expression to `define`", "l: 0.5"),
    ("l: 0.5", "l: .inf", "E0313", "write a finite number", "l: 0.5"),
    ("l: 0.5", "l: 1 000", "E0203", "`1000`", "l: 1000"),
    ("l: 0.5", "l: '1,5'", "E0202", "decimal numbers are written with `.`", "l: 1.5"),
    ("θ: 0.1", "θ: nan", "E0313", "write a finite number", "θ: 0"),
    ("x': 1", "dx: 1", "E0419", "the velocity is written `x'`", "x': 1"),
    ("x': 1", "vx: 1", "E0419", "the velocity is written `x'`", "x': 1"),
    ("x': 1", "dtheta_dt: 1", "E0419", "the velocity is written `theta'`", "theta': 1"),
    ("+ x'^2", "+ diff(x, t)^2", "E0206", "write `x'`", "+ x'^2"),
    ("+ x'^2", "+ diff(θ)^2", "E0206", "write `θ'`", "+ theta'^2"),
    ("+ x'^2", "+ diff(2*x, t)^2", "E0206", "write `dot(x)`", "+ dot(2*x)^2"),
    ("l: 0.5", "l: 0,5", "E0109", "decimal numbers are written with `.`: `0.5`", "l: 0.5"),
    ("l: 0.5", "l", "E0109", "write `l: ...` with its value, or `l: {}`", "l: 0.5"),
    ("l: 0.5", "l: 50%", "E0201", "write `50/100`", "l: 50/100"),
    ("need: [x, θ']", 'need: "x, θ"', "E0419", "write `need: [x, θ]`", "need: [x, θ]"),
    ("x': 1}", "m: 3}", "E0419", "`parameters: {m: ...}`", "x': 1}, parameters: {m: 3}"),
    ("V: -m*g*l*cos(θ)", "formulation: Hamel", "E0312", "write `euler-lagrange`", "formulation: euler-lagrange"),
    ("V: -m*g*l*cos(θ)", "formulation: d'Alembert", "E0312", "write `multipliers`", "formulation: multipliers"),
    ("V: -m*g*l*cos(θ)", "formulation: Voronets", "E0312", "write `voronec`", "formulation: auto"),
    ("x': 1", "X: 1", "E0419", "`X` follows from others", "x: 1"),
    ("need: [x, θ']", "need: [x, theta_dot]", "E0419", "the velocity is written `theta'`", "need: [x, theta']"),
    ("time: [0, 10]", "time: 10", "E0301", "write `[0, 10]`", "time: [0, 10]"),
    ("coordinates: [x, θ]", "coordinates: {x: m, θ: {}}", "E0301", "`x: {unit: m}`", "coordinates: {x: {unit: m}, θ: {}}"),
    ("V: -m*g*l*cos(θ)", "potential: -m*g*l*cos(θ)", "E0303", "write `V: ...`", "V: -m*g*l*cos(θ)"),
    ("define:", "where:", "E0303", "write `define`", "define:"),
    ("V: -m*g*l*cos(θ)", "V: 0\nforces:\n  - x: -x\n  - θ: 1", "E0301", "leave out the `-`", "V: 0\nforces:\n  x: -x\n  θ: 1"),
    ("define: {X: x + l*sin(θ)}", "define: {X: x, P: [x, 1]}", "E0301", "one name for each", "define: {X: x, P1: x, P2: 1}"),
    ("scenes:", "time: [0, 1]\nscenes:", "E0303", "it belongs in a scene", "scenes:"),
    ("+ x'^2", "+ e^(-x/l)*x'^2", "E0302", "a power of e is written `exp(...)`", "+ exp(-x/l)*x'^2"),
    ("+ x'^2", "+ x'^2 if x > 0", "E0203", "the language has no conditions: write them with", "+ x'^2*(1 + sign(x))/2"),
    ("+ x'^2", "+ x'^2*(x > 0)", "E0201", "the language has no conditions: write them with", "+ x'^2*(1 + sign(x))/2"),
    ("time: [0, 10]", "t: [0, 10]", "E0303", "write `time`", "time: [0, 10]"),
    ("time: [0, 10]", "tspan: [0, 10]", "E0303", "write `time`", "time: [0, 10]"),
    ("initial: {θ", "initial_conditions: {θ", "E0303", "write `initial`", "initial: {θ"),
    ("time: [0, 10]", "time: [0 10]", "E0301", "write `[0, 10]`", "time: [0, 10]"),
    ("initial: {θ: 0.1, x': 1}", "initial: [0, 0.1]", "E0301", "write `{x: 1}`", "initial: {x: 1}"),
    ("initial: {θ: 0.1,", "initial: {θ = 0.1,", "E0109", "write `θ: 0.1`", "initial: {θ: 0.1,"),
    ("need: [x, θ']", "need: x, θ'", "E0109", "write a list as `[a, b]`", "need: [x, θ']"),
    ("V: -m*g*l*cos(θ)", "forces: [1, 2]", "E0301", "write `x: ...`", "forces: {x: 1, θ: 2}"),
    ("+ x'^2", "+ x.diff(t)^2", "E0201", "write `x'`", "+ x'^2"),
    ("+ x'^2", "+ sin 2*x*x'^2", "E0203", "write `sin(...)`", "+ sin(2*x)*x'^2"),
    ("define: {X: x", "define: {P: max(x, l), X: x", "E0109", "a text with commas in quotes", 'define: {P: "max(x, l)", X: x'),
    ("V: -m*g*l*cos(θ)", 'constraints: ["c: x\' = 1"]', "E0201", "write `c:", 'constraints: [c: "x\' = 1"]'),
    ("+ x'^2", "+ x'.^2", "E0201", "there are no arrays here: write `^`", "+ x'^2"),
    ("+ x'^2", "+ np.cos(x)*x'^2", "E0201", "write `cos`, without `np.`", "+ cos(x)*x'^2"),
    ("+ x'^2", "+ x(t)'^2", "E0206", "write `x`: nhc knows", "+ x'^2"),
    ("+ x'^2", "+ Rational(1, 2)*x'^2", "E0206", "write `a/b`", "+ 1/2*x'^2"),
    ("+ x'^2", "+ f(x, m)*x'^2", "E0206", "`nhc explain E0206` lists", "+ exp(x*m)*x'^2"),
    ("+ x'^2", "+ \\frac{1}{2}*x'^2", "E0201", "write `a/b`", "+ 1/2*x'^2"),
    ("+ x'^2", "+ \\dot{x}^2", "E0201", "write `x'`", "+ x'^2"),
    ("+ x'^2", "+ \\dot \\theta^2 + x'^2", "E0201", "write `theta'`", "+ theta'^2 + x'^2"),
    ("+ x'^2", "+ \\cos(x)*x'^2", "E0201", "write `cos`, without the `\\`", "+ cos(x)*x'^2"),
    ("+ x'^2", "+ lambda_1*x'^2", "E0302", "`need: [reactions]`", "+ x'^2"),
    ("+ x'^2", "+ x'^2;", "E0201", "leave the `;` out", "+ x'^2"),
    ("+ x'^2", "+ x'^2#half", "E0201", "a blank and `#`", "+ x'^2 #half"),
    ("θ: 0.1", "θ: radians(6)", "E0206", "write `x*pi/180`", "θ: 6*pi/180"),
    ("T: m/2*X'^2", "T: 'm/2*X'^2", "E0104", "leave the quotes out", "T: m/2*X'^2"),
    ("{θ: 0.1, x': 1}", "{θ:0.1, x': 1}", "E0109", "write `θ: 0.1`", "{θ: 0.1, x': 1}"),
    ("nhc: 1", "nhc:1", "E0104", "put a blank after `nhc:`", "nhc: 1"),
    ("V: -m*g", "V:-m*g", "E0104", "put a blank after `V:`", "V: -m*g"),
    ("V: -m*g*l*cos(θ)", 'V: "-m*g*l*cos(θ)', "E0104", 'close the text with `"`', 'V: "-m*g*l*cos(θ)"'),
    ("  go: {", "\tgo: {", "E0104", "indent with spaces", "  go: {"),
    ("+ x'^2", "+ x'*x^2'", "E0212", "the prime binds tighter than `^`: write `(x^2)'`", "+ x'*(x^2)'"),
    ("+ x'^2", "+ x'^2'", "E0212", "leave the prime of the exponent out: write `x'^2`", "+ x'^2"),
    ("+ x'^2", "+ xddot*x'^2", "E0302", "accelerations are what nhc derives", "+ x'^2"),
    ("{m: 2,", "{k₁: 1, m: 2,", "E0307", "write `k1`", "{k1: 1, m: 2,"),
    ("{m: 2,", "{k-1: 1, m: 2,", "E0307", "write `k_1`", "{k_1: 1, m: 2,"),
    ("+ x'^2", "+ xdotdot*x'^2", "E0302", "accelerations are what nhc derives", "+ x'^2"),
    ("+ x'^2", "+ (x dot)^2", "E0203", "write `x'`", "+ x'^2"),
    ("+ x'^2", "+ x₁*x'^2", "E0201", "as in `x1`", "+ x*x'^2"),
    ("+ x'^2", "+ ddx*x'^2", "E0302", "accelerations are what nhc derives", "+ x'^2"),
    ("+ x'^2", "+ ddot(x)*x'^2", "E0206", "accelerations are what nhc derives", "+ x'^2"),
    ("+ x'^2", "+ (d(x)/dt)^2", "E0206", "the velocity `x'`", "+ x'^2"),
    ("V: -m*g*l*cos(θ)", "V: -m*g*l*cos(30*deg)", "E0302", "write `*pi/180`", "V: -m*g*l*cos(30*pi/180)"),
    ("V: -m*g*l*cos(θ)", "V: -m*g*l*cos(30 deg)", "E0203", "write `30*pi/180`", "V: -m*g*l*cos(30*pi/180)"),
    ("coordinates: [x, θ]", "coordinates: [x θ]", "E0307", "`x, θ` for several names", "coordinates: [x, θ]"),
    ("need: [x, θ']", "need: [x, T]", "E0419", "`T_shown: T`", "need: x"),
    ("need: [x, θ']", "need: [x, X]", "E0419", "`X: X`", "need: x"),
]  # fmt: skip


def test_the_spec_holds() -> None:
    assert find(SPEC) == ()


@pytest.mark.parametrize("slip", SLIPS, ids=[slip[1] for slip in SLIPS])
def test_one_slip_one_diagnostic_and_a_help_that_helps(slip: Slip) -> None:
    assert_helps(SPEC, slip)


@pytest.mark.parametrize(
    ("right", "wrong", "help"),
    [
        ("T: m/2*X'^2 + m/2*(l*cos(θ))'^2 + x'^2\nV:", "L:", "a Lagrangian is given by its energies"),
        ("coordinates: [x, θ]", "coordinates: x", "write `[x]`"),
        ("coordinates: [x, θ]", "coordinates: [x, θ]\nunits: {x: m}", "a unit stands beside what has it"),
        ("coordinates: [x, θ]", "coordinates:\n  - x: {unit: m}\n  - θ: {}", "leave out the `-`"),
        ("coordinates: [x, θ]", "coordinates:\n  - name: x\n    unit: m\n  - name: θ", "write `x:` in place of `- name: x`"),
        ("parameters: {m: 2,", "parameters:\n  - {name: m, value: 2}\n  - {name: g, v: 2,", "write `m:` in place of `- name: m`"),
        ("parameters: {m: 2, l: 0.5, g: 9.81}", "parameters: [m: 2, l: 0.5, g: 9.81]", "in braces: `{m: 1, l: 2}`"),
        ("parameters: {m: 2, l: 0.5, g: 9.81}", "parameters:\n  m = 2", "write one name per line with its value: `m: 1`"),
    ],
)  # fmt: skip
def test_the_first_of_several(right: str, wrong: str, help: str) -> None:
    assert any(help in d.help[0] for d in find(SPEC.replace(right, wrong)))


ARM = """nhc: 1
system: arm
coordinates: {x: {unit: m}, phi: {unit: rad}}
rotation: {R: {velocities: [p, q, r]}}
parameters: {m: {value: 2, unit: kg}, l: {value: 0.5, unit: m}, g: {value: 9.81, unit: m/s^2}, F: {value: 1, unit: N}}
bodies:
  cart: {at: [x, 0, 0], mass: m}
  arm: {parent: cart, turns: [y: phi], mass: m, centre: [l, 0, 0]}
  top: {at: [x, 0, 0], rotation: R, mass: m, inertia: m*l^2}
points: {tip: {parent: arm, at: [l, 0, 0]}}
V: m*g*l*R_z3
forces: {tip_z: F}
scenes: {go: {initial: {phi: 0.1, R: [1, 0, 0, 0]}, time: [0, 1]}}
"""


def test_the_other_spec_holds() -> None:
    assert find(ARM) == ()


@pytest.mark.parametrize(
    ("right", "wrong", "code", "help", "followed"),
    [
        ("unit: m/s^2", "unit: m/sec^2", "E0316", "write `s`", "unit: m/s^2"),
        ("unit: N", "unit: Newton", "E0316", "write `N`", "unit: N"),
        ("unit: N", "unit: kgm/s^2", "E0316", "write `kg*m`", "unit: kg*m/s^2"),
        ("unit: N", "unit: furlong", "E0316", "units are written like", "unit: N"),
        ("m*g*l*R_z3", "m*g*l*R_33", "E0302", "did you mean `R_z3`?", "m*g*l*R_z3"),
        ("m*g*l*R_z3", "m*g*l*R33", "E0302", "did you mean `R_z3`?", "m*g*l*R_z3"),
        ("tip_z: F", "tip: F", "E0302", "as `tip_x: ...`", "tip_x: F"),
        (
            "{parent: arm, at: [l, 0, 0]}}\n",
            "{at: [x, l, x]}}\noutputs: {speed: tip_v1}\n",
            "E0302",
            "only the rates `tip_x'`, `tip_y'`, `tip_z'`",
            "{at: [x, l, x]}}\noutputs: {speed: tip_x'}\n",
        ),
        (
            "{parent: arm, at: [l, 0, 0]}}\n",
            "{of: arm, at: [x, l, x]}}\noutputs: {speed: tip_v1}\n",
            "E0302",
            "in space its velocity is `tip_vx`, `tip_vy`, `tip_vz`",
            "{of: arm, at: [x, l, x]}}\noutputs: {speed: tip_vx}\n",
        ),
        ("tip_z: F", "arm: F", "E0302", "as `arm_x: ...` at its origin, a torque as `arm_w1`, `arm_w2`", "arm_x: F"),
        (
            "tip_z: F",
            "arm: F*l",
            "E0302",
            "as `arm_x: ...` at its origin, a torque as `arm_w1`, `arm_w2`",
            "arm_w2: F*l",
        ),
        ("tip_z: F", "arm_w4: F*l", "E0302", "did you mean `arm_w3`?", "arm_w2: F*l"),
        ("tip_z: F", "R_33: F*l", "E0302", "did you mean `R_z3`?", "R_z3: F*l"),
        ("tip_z: F", "x': F", "E0302", "write `x`: the force on a coordinate", "x: F"),
        ("tip_z: F", "s: F*l", "E0302", "are `x`, `phi`; the velocities are `p`, `q`, `r`", "r: F*l"),
        ("phi: 0.1", "psi: 0.1", "E0419", "did you mean `phi`?", "phi: 0.1"),
        ("R: [1, 0, 0, 0]", "turned: 1", "E0419", "known: `R`, `x`, `phi`", "R: [0, 1, 0, 0]"),
        ("m*g*l*R_z3", "m*g + m*g*l*R_z3", "E0413", "the unit m is missing on the left, or", "m*g*l + m*g*l*R_z3"),
        ("m*g*l*R_z3", "m*g*l*R_z3 + m*g", "E0413", "or one with m on the right", "m*g*l*R_z3 + m*g*l"),
    ],
)
def test_slips_with_bodies_rotations_and_units(right: str, wrong: str, code: str, help: str, followed: str) -> None:
    (found,) = find(ARM.replace(right, wrong, 1))
    assert (found.code, help in found.help[0]) == (code, True), found
    assert find(ARM.replace(right, followed, 1)) == ()


@pytest.mark.parametrize(
    ("wrong", "code", "help", "followed"),
    [
        ("constraints: [dx - l*dθ + dm = 0]", "E0302", "`m` is constant", "constraints: [dx - l*dθ = 0]"),
        (
            "quasi_velocities: {u: x'}\nconstraints: [du - l*dθ = 0]",
            "E0302",
            "write the whole constraint with velocities",
            "quasi_velocities: {u: x'}\nconstraints: [x' - l*θ' = 0]",
        ),
        ("constraints: [d(x) - l*dθ = 0]", "E0206", "is written `dx`", "constraints: [dx - l*dθ = 0]"),
        ("constraints: [dx - l*dθ = 0]\ndependent: x", "E0301", "write `[x]`", "constraints: [dx - l*dθ = 0]\ndependent: [x]"),
        ("constraints: [dx - l*dθ = 0]\nholonomic: [m = 3]", "E0403", "no coordinate is left", "constraints: [dx - l*dθ = 0]"),
    ],
)  # fmt: skip
def test_slips_in_constraints(wrong: str, code: str, help: str, followed: str) -> None:
    (found,) = [d for d in find(f"{SPEC}{wrong}\n") if d.code.startswith("E")]
    assert (found.code, help in found.help[0]) == (code, True), found
    assert not [d for d in find(f"{SPEC}{followed}\n") if d.code.startswith("E")]


def test_a_defined_position_has_a_differential() -> None:
    assert not [d for d in find(f"{SPEC}constraints: [cos(θ)*dX - l*dθ = 0]\n") if d.code.startswith("E")]
    (found,) = find(SPEC.replace("{X:", "{W: x', X:") + "constraints: [dW - l*dθ = 0]\n")
    assert (found.code, found.message) == ("E0414", "differential of `W`, which holds velocities")


@pytest.mark.parametrize("entry", ["x' == l*θ'", "x' - l*θ' ==0"])
def test_equality_as_programs_write_it(entry: str) -> None:
    (found,) = find(SPEC + f"constraints:\n  - {entry}\n")
    assert (found.code, found.help) == ("E0208", ("write a single `=`",))


@pytest.mark.parametrize(
    ("sign", "help"),
    [
        ("<", "the language has no conditions"),
        (">=", "write a constraint with `=`; the language has no conditions"),
        ("\u2264", "write a constraint with `=`; the language has no conditions"),
    ],
)
def test_a_constraint_is_no_inequality(sign: str, help: str) -> None:
    (found,) = find(SPEC + f"constraints:\n  - x' {sign} l*θ'\n")
    assert (found.code, found.message) == ("E0201", f"unexpected character `{sign[0]}`")
    assert found.help[0].startswith(help)


def test_two_equations_in_one_entry() -> None:
    (found,) = find(SPEC + "constraints:\n  - x' = l*θ', θ' = 0\n")
    assert found.code == "E0202"
    assert found.help == ("write one equation per entry of the list",)


def test_a_name_that_is_unknown_at_many_places_is_one_mistake() -> None:
    text = SPEC.replace("parameters: {m: 2, ", "parameters: {")
    (found,) = find(text)
    places = [text[label.span.start : label.span.end] for label in found.labels]
    assert (found.code, found.message, places) == ("E0302", "unknown name `m`", ["m", "m", "m"])
    starts = [label.span.start for label in found.labels]
    assert starts == sorted(starts)
    many = SPEC + "outputs: {" + ", ".join(f"o{k}: zz + zz" for k in range(9)) + "}\n"
    (found,) = find(many)
    assert (len(found.labels), found.notes) == (4, ("and at 14 more places",))


def test_an_output_is_no_start() -> None:
    outputs = SPEC + "outputs: {speed: sqrt(x'^2)}\n"
    (found,) = find(outputs.replace("x': 1", "speed: 1"))
    assert found.code == "E0419"
    assert found.help[0].startswith("`speed` follows from others: give the values of these")


def test_quotients_that_are_no_derivatives() -> None:
    names = SPEC.replace("m: 2", "m: 2, dx: 3, dt: 4")  # declared names are themselves
    assert find(names.replace("+ x'^2", "+ dx/dt*x'^2")) == ()
    (found,) = find(SPEC.replace("+ x'^2", "+ dq/dt"))[:1]
    assert found.message == "unknown name `dq`"


SKATE = """nhc: 1
system: skate
coordinates: [x, y, θ]
rotation: {R: {velocities: [w1, w2, w3]}}
parameters:
  m: {value: 2}
  k: {value: 1}
define:
  s: sin(θ)
T: m/2*(x'^2 + y'^2) + θ'^2/2 + (w1^2 + 2*w2^2 + 3*w3^2)/2
V: k*x^2
constraints:
  - blade: s*dx - cos(θ)*dy = 0
dependent: [y, R_0]
scenes:
  a: {initial: {x: 1, R: {order: zxz, angles: [0, 1, 0]}}, time: [0, 1], need: [x, y, x']}
  b: {initial: {x: 2}, time: [0, 1], need: [x]}
"""


@pytest.mark.parametrize(
    ("right", "wrong", "code"),
    [
        ("coordinates: [x, y, θ]", "coordinats: [x, y, θ]", "E0303"),
        ("coordinates: [x, y, θ]", "coordinates: [x, y, 1θ]", "E0307"),
        ("coordinates: [x, y, θ]", "coordinates: [z, y, θ]", "E0302"),  # one mistake at nine places
        ("rotation:", "rotaion:", "E0303"),
        ("rotation: {R:", "rotation: {R-1:", "E0307"),
        ("parameters:", "konstanten:", "E0303"),
        ("parameters:", "define:\nparameters:", "E0105"),
        ("  m: {value: 2}", "  m: {vlue: 2}", "E0303"),
        ("  m: {value: 2}", "  m: {value:2}", "E0109"),
        ("  - blade:", "  - blade: dθ = 0\n  - blade:", "E0305"),
        ("constraints:", "constraint:", "E0303"),
        ("constraints:", "zwang:", "E0303"),
        ("s*dx - cos(θ)*dy = 0", "sdx - cos(θ)*dy = 0", "E0302"),
        ("order: zxz", "ordr: zxz", "E0303"),
        ("{x: 2}", "{x2}", "E0109"),
    ],
)
def test_one_mistake_is_said_once(right: str, wrong: str, code: str) -> None:
    """What follows from a mistake is none of its own."""
    assert SKATE.count(right) == 1
    assert not [d for d in find(SKATE) if d.code.startswith("E")]
    assert [d.code for d in find(SKATE.replace(right, wrong)) if d.code.startswith("E")] == [code]


def test_parameters_among_the_coordinates() -> None:
    found = find(SKATE.replace("[x, y, θ]", "\n  x: {unit: m}\n  y: {value: 2}\n  θ: {unit: rad}"))
    assert [(d.code, d.help) for d in found if d.code.startswith("E")] == [
        ("E0303", ("a coordinate has none: parameters belong under `parameters:`, starts in scenes",))
    ]


@pytest.mark.parametrize(("potential", "inertia"), [("-1/r", "r^2"), ("0", "r^2"), ("-1/r", "1")])
def test_a_start_that_was_forgotten(potential: str, inertia: str) -> None:
    text = f"nhc: 1\nsystem: kepler\ncoordinates: [r, phi]\nT: (r'^2 + {inertia}*phi'^2)/2\nV: {potential}\n"
    (found,) = find(text + "scenes: {go: {initial: {phi': 1}, time: [0, 1]}}\n")
    assert (found.code, found.help) == ("W0421", ("say in `initial` where `r` starts",))
    assert not find(text + "scenes: {go: {initial: {phi': 1, r: 1}, time: [0, 1]}}\n")
    (found,) = find(text + "scenes: {go: {initial: {phi': 1, r: 0}, time: [0, 1]}}\n")
    assert found.help == ("let it start elsewhere",)


@pytest.mark.parametrize(
    ("potential", "advice"),
    [
        ("x^0.5 + y", "say in `initial` where `x` starts"),  # y is as well left out, and has nothing to do with it
        ("1/x + y", "say in `initial` where `x` starts"),
        ("x/(k - 1)", "give `k` another value, under `parameters:` or in the scene"),
        ("sqrt(-k)*x", "give `k` another value, under `parameters:` or in the scene"),
        ("asin(k + l)*x", "give `k`, `l` other values, under `parameters:` or in the scene"),
    ],
)
def test_what_has_no_value_at_a_start(potential: str, advice: str) -> None:
    """The advice is about what the expression without a value depends on, not about whatever else was left out."""
    head = "nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nparameters: {k: 1, l: 2}\nT: (x'^2 + y'^2 + exp(x)*z'^2)/2\n"
    (found,) = find(f"{head}V: {potential}\nscenes: {{go: {{initial: {{z: 1}}, time: [0, 1]}}}}\n")
    assert (found.code, found.help) == ("W0421", (advice,))


def test_dissipation_is_a_force() -> None:
    (found,) = find(SPEC + "D: m*x'^2\n")
    assert found.help == ("friction is given as forces: `forces: {x: -c*x'}`",)
    assert "known keys" in find(SPEC + "d: 0.3\n")[0].help[0]  # a parameter that was not indented


def test_positions_that_were_forgotten() -> None:
    text = "nhc: 1\nsystem: rod\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nholonomic: [x^2 + y^2 = 1]\n"
    (found,) = find(text + "scenes: {go: {initial: {x': 1}, time: [0, 1]}}\n")
    assert (found.code, found.notes) == ("E0409", ("`x`, `y` start at 0, since `initial` does not give a value",))
    (found,) = find(text + "scenes: {go: {initial: {x: 0, y: 2}, time: [0, 1]}}\n")
    assert (found.code, found.notes) == ("E0409", ())


@pytest.mark.parametrize(
    ("right", "wrong", "message", "help"),
    [
        ("  k: {value: 1}", "    k: {value: 1}", "this does not continue what stands above", "indent the entries"),
        ("dependent: [y, R_0]", "dependent [y, R_0]", "a key without its `:`", "write `key: value`"),
        ("m: {value: 2}", "m: {value: 2", "expected ',' or '}'", "separate its entries by commas"),
        ("[y, R_0]", "[y, R_0", "expected ',' or ']'", "close the `["),
        ("V: k*x^2", "V: k*x^2: 1", "mapping values are not allowed here", "in quotes"),
        ("nhc: 1", "%YAML 9.0\n---\nnhc: 1", "incompatible YAML document", "leave the line out"),
    ],
)
def test_yaml_that_is_none(right: str, wrong: str, message: str, help: str) -> None:
    (found,) = find(SKATE.replace(right, wrong))
    assert found.code == "E0104"
    assert message in found.message and help in found.help[0]
