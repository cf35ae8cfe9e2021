"""What a derivation does for who reads it: few names, each of them explained before it is used."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from nhc.emit.latex.document import render
from nhc.emit.text import print_derivation
from nhc.language import Source, decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.paper import Derivation, derivation

SPECS = Path(__file__).resolve().parents[2] / "specs"


def derive(text: str, formulation: str = "") -> Derivation:
    system = resolve(decode(Source("case.yaml", text)))
    chosen = formulate(system, formulation)
    return derivation(system, chosen, equations_of(system, chosen))


@pytest.mark.parametrize("name", ["veselova", "n_trailer3", "roller_racer"])
def test_what_is_named_once_and_used_once_is_long(name: str) -> None:
    """To look up a name costs a reader more than to read on for a line or two."""
    text = re.sub(r"\n      +", " ", print_derivation(derive((SPECS / f"{name}.yaml").read_text())))
    named = dict(re.findall(r"^  (z\d+) = (.*)$", text, re.MULTILINE))
    once = [value for key, value in named.items() if len(re.findall(rf"\b{key}\b", text)) == 2]
    assert len(named) > 5 and all(len(value) > 250 for value in once)


HEAD = "nhc: 1\nsystem: case\nparameters: {m: 1, a: 0.5}\n"
SLED = (
    HEAD
    + """coordinates:
  x: {range: [-2, 0.5]}
  y: {about: across}
  θ: {range: [0, pi/2]}
bodies: {sled: {at: [x, y], turns: [z: θ], mass: m, centre: [a*cos(θ), 0], inertia: m*a^2}}
points: {edge: {parent: sled, at: [-a, 0], about: where it cuts}}
constraints: [blade_x: edge_v2 = 0]
"""
)


def test_points_are_told_and_only_names_that_occur_are_explained() -> None:
    text = " ".join(print_derivation(derive(SLED)).split())
    assert "- `edge` on `sled` at (-a, 0) (where it cuts)." in text and "turned by theta about z" in text
    assert "Indices at the name of a body: cx, cy are the coordinates of its centre of mass in space. With" in text
    assert "at the name of a point" not in text


def test_bodies_are_told_before_their_names_are_used() -> None:
    text = print_derivation(derive(SLED))
    assert text.index("- `sled` in space") < text.index("sled_cx' =") < text.index("The kinetic energy is")


def test_matter_of_another_body_at_a_point() -> None:
    spec = SLED.replace("points: {edge: {parent: sled,", "points: {edge: {parent: yaw, of: sled,").replace(
        "bodies: {", "bodies: {yaw: {at: [x, y]}, "
    )
    text = " ".join(print_derivation(derive(spec.replace("blade_x: edge_v2", "blade_x: edge_vy"))).split())
    assert "- `edge` on `yaw` at (-a, 0), with the matter of `sled` (where it cuts)." in text


def test_tables_of_coordinates_and_parameters_have_one_order() -> None:
    latex = render(derive(SLED))
    assert r"\emph{coordinate} & \emph{meaning} & \emph{range} \\" in latex
    assert r"$x$ &  & -2 to 0.5 \\" in latex and r"$\theta$ &  & 0 to pi/2 \\" in latex
    car = render(derive((SPECS / "diff_drive.yaml").read_text()))
    assert r"\emph{parameter} & \emph{meaning} & \emph{unit} & \emph{value} \\" in car


def test_names_of_constraints_look_alike_everywhere() -> None:
    latex = render(derive(SLED))
    assert (
        r"\text{($\mathit{blade}\,x$)}" in latex and r"d\pi_{\mathit{blade}\,x}" in latex and r"blade\_x" not in latex
    )


def test_both_signs_of_the_potential_are_defined() -> None:
    assert "force function U = -V, whose" in print_derivation(derive(HEAD + "coordinates: [x]\nT: m*x'^2\nU: -x^2\n"))
    free = " ".join(print_derivation(derive(HEAD + "coordinates: [x]\nT: m*x'^2\n")).split())
    assert "the force function U and the potential energy V = -U are zero." in free


def test_rates_of_what_is_defined_come_with_it() -> None:
    spec = HEAD + "coordinates: [u, v]\ndefine: {X: a*cos(u)*cos(v), Y: a*sin(u)}\nT: m*(X'^2 + Y'^2)\n"
    text = print_derivation(derive(spec))
    assert text.index("  Y = a*sin(u)") < text.index("  Y' = ")


def test_names_that_a_derivation_made_are_numbers_on_paper() -> None:
    """Components of velocities on axes that turn have names in emitted code, after bodies, with no word on what they are."""
    made = derive((SPECS / "bodies" / "car_trailer.yaml").read_text())
    system = made.system
    own = {entry.name for entry in (*system.spec.definitions, *system.spec.quasi_velocities)}
    lets = {name for name in made.lets if not re.fullmatch(r"z\d+", name)}
    assert {name.removesuffix("_dot") for name in lets} <= own


TYRE = """nhc: 1
system: tyre
coordinates: {x: {}, y: {}, phi: {}, theta: {range: [-1.5, 1.5]}, psi: {}}
parameters: {m: 3, R: 0.3, r: 0.05, A: 0.14, C: 0.27, g: 9.81}
bodies:
  yawed: {at: [x, y, R*cos(theta) + r], turns: [z: phi]}
  tilted: {parent: yawed, turns: [x: theta]}
  tyre: {parent: tilted, turns: [y: psi], mass: m, inertia: [A, C, A]}
points: {contact: {parent: yawed, of: tyre, at: [0, R*sin(theta), -R*cos(theta) - r]}}
gravity: [0, 0, -g]
constraints: [contact_v1 = 0, contact_v2 = 0]
"""


def test_a_coordinate_in_the_reason_is_set_as_one_and_a_determinant_as_a_product() -> None:
    latex = render(derive(TYRE))
    assert r"on axes that turn with $\varphi$, which" in latex
    text = print_derivation(derive(TYRE, "voronec"))
    assert "determinant (r + R*cos(theta))*(R + r*cos(theta))" in " ".join(text.split())
    assert "Delta = (r + R*cos(theta))*(R + r*cos(theta))" in text
    assert "yawed_z" not in text  # it is as long, and no height in what moves along the ground


SOLVED = (
    "Solved for the rates:",
    "Solved for the rates the equations are too long",
    "completed by the rates of the constraints",
)
GALLERY = sorted((Path(__file__).resolve().parents[1] / "golden").glob("*/derivation.tex"))


@pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.parent.name)
def test_equations_are_solved_for_the_rates_or_it_is_said_why_not(path: Path) -> None:
    text = path.read_text()
    section = text.partition(r"\section{The equations of motion}")[2].partition(r"\section")[0]
    lefts = re.findall(r"^  (.*?) &?= ", section, re.MULTILINE)
    plain = [left.lstrip("& ") for left in lefts]
    solved = all(re.fullmatch(r"\\d?dot\{\S*\}(_\S+)?", left) for left in plain)
    assert any(said in section for said in SOLVED) or solved, plain


@pytest.mark.parametrize(
    ("name", "formulation", "wanted"),
    [
        ("routh_sphere", "chaplygin", "Omega = Omega_c + Omega_d   (III.3)"),
        ("routh_sphere", "multipliers", "Omega = Omega_c + Omega_d + Omega_r   (II.3)"),
        ("pendulum", "lagrange", "Omega = -m*l^2 dtheta ^ dtheta'"),
    ],
)
def test_a_long_form_is_the_sum_of_its_parts(name: str, formulation: str, wanted: str) -> None:
    assert wanted in print_derivation(derive((SPECS / f"{name}.yaml").read_text(), formulation))


def test_energies_on_paper_are_as_short_as_in_emitted_code() -> None:
    """The speed of a point is v^2 + v2^2 on axes that turn, whatever it is in space."""
    text = print_derivation(derive(TYRE))
    for left in ("T*", "E"):
        shown = " ".join(re.findall(rf"^  {re.escape(left)} = (.*(?:\n      .*)*)", text, re.MULTILINE)[0].split())
        assert shown.startswith("(m*(v^2 + v2^2 + ") and "sin(phi)" not in shown
