"""What is said and chosen rests on all values that a spec gives its parameters, and on what never changes along a motion."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.properties.singular import find_rank_loss
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System
from nhc.mechanics.values import parameter_ranges, scene_values
from nhc.pipeline import Options, check, emit
from tests.support import python_model

COUPLED = """\
nhc: 1
system: coupled
coordinates: [x, y]
parameters: {m: 2, c: 0.5, M: 2}
T: m/2*x'^2 + c*x'*y' + M/2*y'^2
forces: {x: 0.3, y: 0.7}
scenes:
  usual: {time: [0, 1]}
"""
INDEFINITE = COUPLED + "  zero: {parameters: {m: 0, c: 1, M: 1}, time: [0, 1]}\n"
BLADE = """\
nhc: 1
system: blade
rotation: {R: {velocities: [p, q, r]}}
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2 + p^2 + 2*q^2 + 3*r^2)/2
"""
NO_SLIP = "x'*R_x2 + y'*R_y2 + z'*R_z2"
OTHER_AXIS = "x'*R_x3 + y'*R_y3 + z'*R_z3"


def system_of(text: str) -> System:
    return resolve(decode(Source("values.yaml", text)))


def test_a_mass_matrix_is_definite_only_where_all_scenes_say_so() -> None:
    for text, definite in ((COUPLED, True), (INDEFINITE, False)):
        system = system_of(text)
        assert equations_of(system, formulate(system)).definite is definite
    (text,) = emit(Source("coupled.yaml", INDEFINITE), "python", Options()).values()
    model = python_model(text, "coupled")
    for m, c, M in ((0.0, 1.0, 1.0), (1e-13, 1.0, 1.0), (1e-12, 1.0, 0.0), (2.0, 0.5, 2.0)):
        determinant = m * M - c * c
        wanted = [(0.3 * M - 0.7 * c) / determinant, (0.7 * m - 0.3 * c) / determinant]
        assert model.rhs(0.0, [0.0] * 4, [m, c, M])[2:] == pytest.approx(wanted, rel=1e-12)


def test_a_sum_of_squares_is_definite_only_where_all_scenes_make_it_positive() -> None:
    """M = [[A + B, B], [B, B]] has the inverse [[1, -1], [-1, (A + B)/B]]/A, for A = -B as well."""
    text = """\
nhc: 1
system: squares
coordinates: [x, y]
parameters: {A: 1, B: 1}
T: A/2*x'^2 + B/2*(x' + y')^2
forces: {x: 0.3, y: 0.7}
scenes:
  opposed: {parameters: {B: -1}, time: [0, 1]}
"""
    assert equations_of(system_of(text), formulate(system_of(text))).definite is False
    (module,) = emit(Source("squares.yaml", text), "python", Options()).values()
    model = python_model(module, "squares")
    for A, B in ((1.0, -1.0), (2.0, 0.5), (-3.0, 3.0)):
        wanted = [(0.3 - 0.7) / A, (-0.3 + 0.7 * (A + B) / B) / A]
        assert model.rhs(0.0, [0.0] * 4, [A, B])[2:] == pytest.approx(wanted, rel=1e-12)


SLED = """\
nhc: 1
system: sled
coordinates: [x, y, th]
T: (x'^2 + y'^2 + th'^2)/2
constraints:
  - sin(th)*x' - cos(th)*y' = 0
scenes:
  s: {initial: {x: 1, th: 0.3, x': SPEED, y': 0}, time: [0, 1]}
"""


@pytest.mark.parametrize(("speed", "refused"), [("1e-80", False), ("1e-17", False), ("1e-14", True), ("1", True)])
def test_velocities_that_no_coordinate_notices_are_rounding(speed: str, refused: bool) -> None:
    """In the whole scene they move x = 1 by less than its last digit, whatever the units."""
    for unit in (1.0, 1e12, 1e-12):
        spec = decode(
            Source("sled.yaml", SLED.replace("x: 1", f"x: {unit}").replace("SPEED", f"{float(speed) * unit!r}"))
        )
        system = resolve(spec)
        if refused:
            with pytest.raises(SpecError, match="violate the constraints"):
                start_of(system, spec.scenes[0])
        else:
            assert start_of(system, spec.scenes[0]).v[0] == float(speed) * unit


def test_values_come_from_the_spec_and_its_scenes() -> None:
    text = (
        COUPLED.replace("M: 2}", "M: 2, L: {about: no value}}") + "  long: {parameters: {L: 3, m: 1}, time: [0, 1]}\n"
    )
    system = system_of(text.replace("usual: {", "usual: {parameters: {L: 2}, "))
    m, c, _, length = system.p
    assert [values[length] for values in scene_values(system)] == [1.0, 2.0, 3.0]
    ranges = parameter_ranges(system)
    assert (ranges[m], ranges[c], ranges[length]) == ((1.0, 2.0), (0.5, 0.5), (2.0, 3.0))


def test_a_rank_is_full_only_where_the_scenes_lengths_leave_it_so() -> None:
    def says(length: str) -> bool | None:
        text = "nhc: 1\nsystem: held\ncoordinates: [x, y, theta]\nparameters: {L: {about: no value}}\n"
        text += "T: (x'^2 + y'^2 + theta'^2)/2\n"
        text += "constraints:\n  - (2 - L*sin(theta))*x' - y'*sin(theta)*(2 - L*sin(theta)) = 0\n"
        text += f"scenes: {{go: {{parameters: {{L: {length}}}, time: [0, 1]}}}}\n"
        return find_rank_loss(system_of(text)).regular

    assert says("1") is True and says("3") is False


@pytest.mark.parametrize("rows", [(NO_SLIP,), (NO_SLIP, OTHER_AXIS)])
def test_rows_along_axes_of_a_body_never_lose_their_rank(rows: tuple[str, ...]) -> None:
    text = BLADE + "constraints:\n" + "".join(f"  - {row} = 0\n" for row in rows)
    assert find_rank_loss(system_of(text)).regular is True


def test_velocities_on_the_axes_of_a_body_are_never_singular() -> None:
    forms = [f"  {name}: x'*R_x{k} + y'*R_y{k} + z'*R_z{k}\n" for k, name in enumerate("uvw", start=1)]
    assert [
        d.code for d in check(Source("blade.yaml", BLADE + "quasi_velocities:\n" + "".join(forms))).diagnostics
    ] == []
    flat = [form.replace("x'*R_x1", "2*x'*R_x2") for form in forms]  # not on the axes: singular somewhere
    assert [d.code for d in check(Source("blade.yaml", BLADE + "quasi_velocities:\n" + "".join(flat))).diagnostics] == [
        "W0408"
    ]
