"""What is copied from a textbook, a manual or another program: the help, when it is followed, leads to a spec that holds."""

from __future__ import annotations

import pytest

from tests.unit.slips import Slip, assert_helps, find

SPEC = """nhc: 1
system: sleigh
coordinates: [x, y, theta]
parameters: {m: 1, I: 0.3, a: 0.25}
T: m/2*(x'^2 + y'^2) + I/2*theta'^2
V: m*a*cos(theta)
constraints:
  - slip: -sin(theta)*x' + cos(theta)*y' = 0
scenes:
  go: {initial: {theta: 0.1, theta': 1}, time: [0, 10], need: [x, y]}
"""
V, SLIP = "V: m*a*cos(theta)", "- slip: -sin(theta)*x' + cos(theta)*y' = 0"
SLIPS: list[Slip] = [
    (V, "V: m*a*cos^2(theta)", "E0203", "write `cos(theta)^2`", "V: m*a*cos(theta)^2"),
    (V, "V: m*a*cos^2(theta - (x + y))", "E0203", "write `cos(theta - (x + y))^2`", "V: m*a*cos(theta - (x + y))^2"),
    (V, "V: m*a*cos^-1(theta)", "E0203", "write `acos(theta)`, or `1/cos(theta)`", "V: m*a*acos(theta)"),
    (V, "V: m*a*costheta", "E0302", "write `cos(theta)`", V),
    (V, "V: m*a*cos(theta) // height", "E0202", "a comment begins with a blank and `#`", V + " # height"),
    (V, "V: m*a*cos(theta),", "E0202", "leave the `,` out", V),
    (V, "V: V = m*a*cos(theta)", "E0208", "leave `V =` out", V),
    (V, "V: m*a\u00a0*cos(theta)", "E0201", "a plain blank", V),
    (V, "V: m*a*cos\uff08theta)", "E0201", "write `(`", V),
    (V, "V: m*a*x[1]", "E0201", "write `x1`", "V: m*a*x"),
    (V, "V: 1_000*x", "E0210", "`1000`", "V: 1000*x"),
    (V, "V: |x|", "E0104", "write `abs(...)`", "V: abs(x^2)"),
    (V, "V:m*a*cos(theta)", "E0104", "put a blank after `V:`", V),
    (V, "Q: {x: 1}", "E0303", "write `forces`", "forces: {x: 1}"),
    ("theta'^2", "theta'(t)^2", "E0203", "write `theta'`", "theta'^2"),
    ("y' = 0", "y' := 0", "E0201", "write `=`", "y' = 0"),
    ("y' = 0", "y' <= 0", "E0201", "write a constraint with `=`", "y' = 0"),
    ("-sin(theta)*x' + cos(theta)*y'", "dx/dt", "E0209", "write `x'` in place of `dx/dt`", "x'"),
    (SLIP, SLIP.replace("- slip", "-slip"), "E0301", "put a blank after the `-`: `- slip", SLIP),
    ("m: 1,", "m: 1*kg,", "E0314", "`{value: ..., unit: kg}`", "m: {value: 1, unit: kg},"),
    ("m: 1, ", "m: 1 ", "E0104", "separate its entries by commas", "m: 1, "),
    ("a: 0.25}", "a: 0.25", "E0104", "close the `{`", "a: 0.25}"),
    ("[x, y, theta]", "[x; y; theta]", "E0307", "write `x, y, theta`", "[x, y, theta]"),
    ("[x, y, theta]", "[x, y,, theta]", "E0104", "leave the `,` out", "[x, y, theta]"),
    ("system: sleigh", "system: Čaplygin Sleigh", "E0310", "write `caplygin_sleigh`", "system: caplygin_sleigh"),
    ("system: sleigh", "% a sleigh\nsystem: sleigh", "E0104", "a comment begins with `#`", "# a sleigh\nsystem: sleigh"),
    ("theta: 0.1", "theta: near 1", "E0203", "write `{near: 1}`", "theta: 1"),
    ("time: [0, 10]", "time: 0..10", "E0301", "write `[0, 10]`", "time: [0, 10]"),
    ("time: [0, 10]", "time: [0, 2,5]", "E0301", "decimal numbers are written with `.`", "time: [0, 2.5]"),
    ("need: [x, y]", "need: [x, theta'']", "E0419", "accelerations are what nhc derives", "need: [x, theta']"),
    ("need: [x, y]", "need: x y", "E0419", "write `need: [x, y]`", "need: [x, y]"),
    ("scenes:\n  go: {", "scenes: {", "E0301", "give the scene a name", "scenes:\n  go: {"),
    ("scenes:\n  go", "scenes:\n\u00a0\u00a0go", "E0104", "indent with plain blanks", "scenes:\n  go"),
    ("constraints:", "nonholonomic_constraints:", "E0303", "write `constraints`", "constraints:"),
]  # fmt: skip


@pytest.mark.parametrize("slip", SLIPS, ids=[slip[1] for slip in SLIPS])
def test_one_slip_one_diagnostic_and_a_help_that_helps(slip: Slip) -> None:
    assert_helps(SPEC, slip)


def test_a_key_without_its_colon_is_shown_where_it_stands() -> None:
    (found,) = find(SPEC.replace(V, "V = m*a*cos(theta)"))
    assert found.code == "E0104" and found.span.start == SPEC.index(V)


def test_parameters_that_are_assigned() -> None:
    found = find(SPEC.replace("{m: 1, I: 0.3, a: 0.25}", "\n  - m = 1\n  - I = 0.3\n  - a = 0.25"))
    assert [one.help[0] for one in found][:2] == [
        f"write `{pair}`, without a `-` before it" for pair in ("m: 1", "I: 0.3")
    ]


def test_a_differential_under_holonomic_belongs_elsewhere() -> None:
    found = find(SPEC.replace("constraints:", "holonomic:").replace("x' + cos(theta)*y'", "dx + cos(theta)*dy"))
    assert [one.code for one in found] == ["E0209", "E0209"]
    assert found[0].help[0].startswith("move the equation to `constraints`")


def test_a_prime_that_was_forgotten_in_the_energy() -> None:
    (found,) = find(SPEC.replace("theta'^2", "theta^2").replace(SLIP, "- x' = y'"))
    assert found.code == "E0404"
    assert found.help == ("write `theta'` where a velocity is meant: `T` contains `theta` without a prime only",)


@pytest.mark.parametrize("key", ["constraints", "holonomic"])
def test_no_equations_between_braces(key: str) -> None:
    found = find(SPEC.replace(f"constraints:\n  {SLIP}", f"{key}: {{}}"))
    assert [one.code for one in found if one.code[0] == "E"] in ([], ["E0301"])
