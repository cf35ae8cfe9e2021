"""The right formulations agree with Lagrange's equations with multipliers, exactly and in doubles; the wrong ones differ.

Systems and dependent velocities are those of the table in which the project's theory was checked; the pattern of who errs where is
asserted, not the numbers.
"""

from __future__ import annotations

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.certificates import wrong
from nhc.mechanics.formulations import chaplygin, euler_lagrange, voronec
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from tests.thesis.scenery import (
    ROOT,
    any_states,
    error_of,
    generic_frame,
    projected_truth,
    random_states,
    rates_of,
    reduced_of,
    system_of,
)

# name, dependent velocities, whether Čaplygin's equations hold, the wrong variants that happen to be right here
TABLE = [
    ("chaplygin_sleigh", "x", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("skate_incline", "y", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("vertical_disk", "x y", True, {"lagrange_of_T_star", "boxed_I_3_sign", "I_4_9_mu_thrice", "noaffine"}),
    ("nh_particle", "z", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("voronec_particle", "z", False, {"noaffine"}),
    ("affine_voronec", "z", False, set()),
    ("contact_oscillator", "x", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("cvt", "y", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("chaotic", "x", True, {"I_4_9_mu_thrice", "noaffine"}),
    (
        "integrable",
        "x",
        True,
        {"lagrange_of_T_star", "boxed_I_3_sign", "I_4_9_mu_thrice", "noaffine", "III_2_6_as_printed"},
    ),
    ("charged_sleigh", "y", False, {"I_4_9_mu_thrice", "noaffine"}),
    ("snakeboard", "x y", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("roller_racer", "x y", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("diff_drive", "x y p_L", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("n_trailer3", "", False, {"noaffine"}),
    ("rolling_disk", "x y", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("ball_on_table", "x y", True, set()),
    ("chaplygin_ball", "x y", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("routh_sphere", "x y", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("veselova", "phi", True, {"I_4_9_mu_thrice", "noaffine"}),
    ("rattleback", "", None, {"I_4_9_mu_thrice", "noaffine"}),
]
IDS = [row[0] for row in TABLE]


def system(name: str) -> System:
    if name != "integrable":
        return system_of(name)
    source = read(ROOT / "specs" / "chaotic.yaml")  # x' + z.z' = 0 is the derivative of x + z.z/2
    text = source.text
    for k in (1, 2, 3):
        text = text.replace(f"y{k}*z{k}'", f"z{k}*z{k}'")
    assert text != source.text
    return resolve(decode(Source("integrable.yaml", text)))


@pytest.mark.parametrize(("name", "dependent", "_holds", "_right"), TABLE, ids=IDS)
def test_voronec_agrees(name: str, dependent: str, _holds: bool | None, _right: set[str]) -> None:
    reduced = reduced_of(system(name), dependent.split())
    rates = rates_of(reduced.graph, len(reduced.mu))
    rows = voronec.printed_rows(reduced, rates)
    assert are_equal(reduced.graph, rows, projected_truth(reduced.frame, rates))
    assert error_of(reduced.frame, rows, rates, random_states(reduced.frame, 3)) < 1e-12


@pytest.mark.parametrize(("name", "dependent", "_holds", "_right"), TABLE, ids=IDS)
def test_hamel_agrees(name: str, dependent: str, _holds: bool | None, _right: set[str]) -> None:
    frame = generic_frame(system(name))
    rates = rates_of(frame.graph, len(frame.free))
    rows = euler_lagrange.printed_rows(frame, rates)
    assert are_equal(frame.graph, rows, projected_truth(frame, rates))
    assert error_of(frame, rows, rates, random_states(frame, 3)) < (1e-11 if name == "roller_racer" else 1e-12)


@pytest.mark.parametrize(("name", "dependent", "holds", "_right"), TABLE, ids=IDS)
def test_chaplygin_agrees(name: str, dependent: str, holds: bool | None, _right: set[str]) -> None:
    """Where the hypotheses without which it cannot do are met, and only there."""
    reduced = reduced_of(system(name), dependent.split())
    fatal = chaplygin.hypotheses(reduced.frame, reduced.alpha).fatal
    rates = rates_of(reduced.graph, len(reduced.mu))
    agrees = are_equal(reduced.graph, chaplygin.printed_rows(reduced, rates), projected_truth(reduced.frame, rates))
    assert holds is None or holds == (not fatal)
    assert agrees if not fatal else not agrees


@pytest.mark.parametrize(("name", "dependent", "_holds", "right"), TABLE, ids=IDS)
def test_wrong_derivations_in_coordinates(name: str, dependent: str, _holds: bool | None, right: set[str]) -> None:
    reduced = reduced_of(system(name), dependent.split())
    rates = rates_of(reduced.graph, len(reduced.mu))
    states, expected = any_states(reduced.frame), projected_truth(reduced.frame, rates)
    for variant in wrong.REDUCED:
        rows = variant.rows(reduced, rates)
        assert are_equal(reduced.graph, rows, expected) == (variant.name in right), variant.name
        if variant.name not in right:
            assert error_of(reduced.frame, rows, rates, states) > 0.01, variant.name


@pytest.mark.parametrize(("name", "dependent", "_holds", "right"), TABLE, ids=IDS)
def test_wrong_derivations_in_quasi_velocities(name: str, dependent: str, _holds: bool | None, right: set[str]) -> None:
    frame = generic_frame(system(name))
    rates = rates_of(frame.graph, len(frame.free))
    states, expected = any_states(frame), projected_truth(frame, rates)
    for variant in wrong.FRAME:
        rows = variant.rows(frame, rates)
        assert are_equal(frame.graph, rows, expected) == (variant.name in right), variant.name
        if variant.name not in right:
            assert error_of(frame, rows, rates, states) > 0.005, variant.name


def test_suslov_has_two_faces() -> None:
    """Solved for psi' its T contains what it is solved for, and Čaplygin's equations do not apply; solved for phi' they do."""
    for dependent, holds in (("psi", False), ("phi", True)):
        reduced = reduced_of(system_of("suslov"), [dependent])
        assert (not chaplygin.hypotheses(reduced.frame, reduced.alpha).fatal) == holds
        rates = rates_of(reduced.graph, len(reduced.mu))
        assert are_equal(reduced.graph, voronec.printed_rows(reduced, rates), projected_truth(reduced.frame, rates))
