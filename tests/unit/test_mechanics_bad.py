"""Every spec that is bad as mechanics carries the diagnostics that `nhc check` must give, and gives no others."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.diagnostics import Diagnostic, Source, SpecError, render_text
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import check
from tests.unit.test_language_bad import expectations

BAD = sorted((Path(__file__).resolve().parents[1] / "bad" / "mechanics").glob("*.yaml"))
CODES = {f"E04{k:02}" for k in (1, 2, 3, 4, 5, 6, 7, 9, 11, 12, 15, 17, 20)} | {
    "W0408",
    "W0410",
    "W0416",
    "W0421",
    "W0422",
    "W0423",
    "E0424",
    "W0425",
    "W0426",
    "W0427",
    "W0428",
    "W0429",
    "W0430",
    "W0431",
}


def diagnose(source: Source) -> tuple[Diagnostic, ...]:
    try:
        return check(source).diagnostics
    except SpecError as error:
        return error.diagnostics


@pytest.mark.parametrize("path", BAD, ids=lambda path: path.stem)
def test_bad_mechanics(path: Path) -> None:
    expected, source = expectations(path), read(path)
    assert expected, "a bad spec starts with what is expected of it"
    found = diagnose(source)
    assert [(d.code, *source.position(d.span.start), d.message) for d in found] == expected
    assert all(d.help for d in found), "every diagnostic says what to do"
    assert render_text(source, found)


def test_every_code_of_the_mechanics_is_met() -> None:
    met = {code for path in BAD for code, *_ in expectations(path)}
    assert met >= CODES


@pytest.mark.parametrize(
    ("forms", "more", "notes"),
    [
        ("{u: th, w: x'}", "", ["`u` contains no velocity"]),
        ("{u: sin(th)*x' - cos(th)*y', w: th'}", "", ["`u` follows from the constraint `edge`"]),
        ("{u: th', w: 2*th' + 1}", "", ["`w` follows from `u`"]),
        (
            "{u: x', w: th', s: y'}",
            "",
            [
                "`s` follows from the constraint `edge` and `u`",
                "the constraint leaves 2 of the 3 velocities free, and 3 quasi-velocities are given",
            ],
        ),
        (
            "{u: x', w: th'}",
            "holonomic: [rod: x = 1]",
            [
                "`u` follows from the constraint `rod`",
                "the 2 constraints leave 1 of the 3 velocities free, and 2 quasi-velocities are given",
            ],
        ),
    ],
)
def test_it_is_said_why_quasi_velocities_are_no_basis(forms: str, more: str, notes: list[str]) -> None:
    text = f"""nhc: 1
system: none
coordinates: [x, y, th]
T: (x'^2 + y'^2 + th'^2)/2
constraints: [edge: "-sin(th)*x' + cos(th)*y' = 0"]
{more}
quasi_velocities: {forms}
"""
    (found,) = diagnose(Source("none.yaml", text))
    assert (found.code, list(found.notes)) == ("E0406", notes)


def test_the_missing_component_of_an_angular_velocity_is_named() -> None:
    """T need not lack a whole rotation: the spin about one axis is enough."""
    text = "nhc: 1\nsystem: spin\nrotation: {R: {velocities: [p, q, r]}}\nT: (2*p^2 + (q + p)^2)/2\nV: R_z3\n"
    (found,) = diagnose(Source("spin.yaml", text))
    assert found.message == "`T` has no second-order part in `r`"


def test_a_coordinate_that_moves_no_body_is_shown() -> None:
    text = """nhc: 1
system: idle
coordinates: [x, phi, chi]
bodies:
  cart: {at: [x, 0], mass: 1}
  arm: {parent: cart, turns: [z: phi], inertia: 2}
"""
    source = Source("idle.yaml", text)
    (found,) = diagnose(source)
    assert (found.code, found.message) == ("E0404", "`T` has no second-order part in `chi'`")
    assert source.text[found.span.start : found.span.end] == "chi"


@pytest.mark.parametrize("formulation", ["auto", "lagrange", "multipliers", "voronec"])
@pytest.mark.parametrize(
    ("K", "a", "warned"), [(1.0, 0.9, False), (1.0, 1.1, True), (1e9, 3e4, False), (1e9, 3.2e4, True), (-1e-9, 0, True)]
)
def test_negative_energies_are_seen_in_any_units(formulation: str, K: float, a: float, warned: bool) -> None:
    """T = x'^2/2 + a x' y' + K y'^2/2 is positive for a^2 < K; a constraint on z leaves that as it is."""
    held = formulation in ("multipliers", "voronec")
    text = f"""nhc: 1
system: units
coordinates: [x, y{", z" if held else ""}]
parameters: {{K: {K}, a: {a}}}
T: x'^2/2 + a*x'*y' + K/2*y'^2*(1 + x^2*0){" + z'^2*x^2/2" if held else ""}
{"constraints: [z' = 0]" if held else ""}
formulation: {formulation}
scenes: {{go: {{time: [0, 1], initial: {{x: 0.5}}}}}}
"""
    found = [d.code for d in diagnose(Source("units.yaml", text)) if d.code != "W0410"]
    assert found == (["W0423"] if warned else [])


@pytest.mark.parametrize(
    ("row", "flat"), [("holonomic: ['(x - y)^2 = 0']", True), ("constraints: [\"(x - y)*x' = (x - y)*y'\"]", False)]
)
def test_an_equation_whose_slopes_vanish_has_advice_of_its_own(row: str, flat: bool) -> None:
    text = f"nhc: 1\nsystem: flat\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\n{row}\n"
    text += "scenes: {go: {initial: {x: 1, y: 1}, time: [0, 1]}}\n"
    (found,) = (d for d in diagnose(Source("flat.yaml", text)) if d.code == "W0421")
    advice = "if the slopes of `h1` vanish wherever it holds, write `x = y` for `(x - y)^2 = 0`"
    assert found.message.endswith("restricts no velocity at its start")
    assert found.help == ("let it start elsewhere", *([advice] if flat else []))


@pytest.mark.parametrize(
    ("more", "place"),
    [("", "x'^2 + y'^2"), ("holonomic: [x = y^2]\n", "holonomic"), ("constraints: [y*x' = y']\n", "constraints")],
)
def test_where_a_formulation_that_is_asked_for_does_not_apply(more: str, place: str) -> None:
    source = Source("free.yaml", f"nhc: 1\nsystem: free\ncoordinates: [x, y]\nT: x'^2 + y'^2\n{more}")
    with pytest.raises(SpecError) as caught:
        formulate(resolve(decode(source)), "lagrange" if more else "chaplygin")
    (found,) = caught.value.diagnostics
    assert (found.code, source.text[found.span.start : found.span.end]) == ("E0411", place)
