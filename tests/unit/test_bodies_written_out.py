"""What ``bodies`` become: which names are made, to which energies they are added, and where mistakes in them are marked."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.language import decode, read
from nhc.language.expressions.unparse import unparse
from nhc.language.spec import Spec
from nhc.mechanics.pairs.verdict import compare_systems
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import derive

HEAD = "nhc: 1\nsystem: s\ncoordinates: [x, z, phi]\nparameters: {m: 2, I: 0.3, a: 0.5, g: 9.81, k: 4}\n"
ROD = "bodies: {rod: {at: [x, 0, z], turns: [y: phi], mass: m, centre: [a, 0, 0], inertia: I}}\n"
T = "T: m/2*((x + a*cos(phi))'^2 + (z - a*sin(phi))'^2) + I/2*phi'^2\n"
V = "m*g*(z - a*sin(phi))"


def spec(*parts: str) -> Spec:
    return decode(Source("s.yaml", HEAD + "".join(parts)))


def same(first: Spec, second: Spec) -> bool:
    made = compare_systems(resolve(first), resolve(second), (), ("A", "B"))
    return made.agrees and made.is_sure


@pytest.mark.parametrize(
    ("own", "whole"),
    [
        ("", f"V: {V}\n"),
        ("V: k/2*x^2\n", f"V: k/2*x^2 + {V}\n"),
        ("V: -k*x - k*z\n", f"V: -k*x - k*z + {V}\n"),
        ("U: -k/2*x^2\n", f"U: -k/2*x^2 - {V}\n"),
    ],
)
def test_gravity_adds_to_the_potential_that_is_given(own: str, whole: str) -> None:
    assert same(spec(ROD, "gravity: [0, 0, -g]\n", own), spec(T, whole))


@pytest.mark.parametrize("own", ["k*x'^2", "-k*x'*z' + k*(x'^2 + z'^2)", "-(k)*x'*z' + k*(x'^2 + z'^2)"])
def test_an_energy_of_ones_own_is_added(own: str) -> None:
    assert same(spec(ROD, f"T: {own}\n"), spec(T.rstrip(), f" + {own}\n"))


def test_only_what_is_used_is_made() -> None:
    assert {d.name for d in spec(ROD).definitions} == {"rod_x1", "rod_z1", "rod_cx", "rod_cz", "rod_T"}
    assert "rod_z" in {d.name for d in spec(ROD, "outputs: {height: rod_z}\n").definitions}


def test_a_position_that_only_its_differential_uses_is_made() -> None:
    tip = "points: {tip: {parent: rod, at: [a, 0, 0]}}\n"
    by_form = "constraints: ['sin(phi)*dtip_x + cos(phi)*dtip_z = 0']\n"
    by_rates = "constraints: [\"sin(phi)*tip_x' + cos(phi)*tip_z' = 0\"]\n"
    assert same(spec(ROD, tip, by_form), spec(ROD, tip, by_rates))


def test_a_body_in_the_plane_is_written_as_by_hand() -> None:
    made = {
        d.name: unparse(d.value)
        for d in spec("bodies: {b: {at: [x, z], turns: [z: phi], mass: m, inertia: I}}\n").definitions
    }
    assert made == {"b_T": "m/2*(x'^2 + z'^2) + I/2*phi'^2"}


def test_turns_about_one_axis_add_up_from_body_to_body() -> None:
    """What does not move stays apart: the axes before it are where the body before has its mass."""
    chain = (
        "bodies: {a: {turns: [x: k, y: x], mass: m}, b: {parent: a, at: [1, 0, 0], turns: [y: z, y: phi], mass: m}, "
        "c: {parent: b, turns: [y: k], mass: m, centre: [1, 0, 0]}, d: {parent: c, at: [1, 0, 0], turns: [y: x]}}\n"
    )
    shown = "outputs: {o1: a_angle, o2: b_angle, o3: c_angle, o4: d_angle, o5: b_x1, o6: d_w2}\n"
    made = {d.name: unparse(d.value) for d in spec(chain, shown, "T: x'^2 + z'^2 + phi'^2\n").definitions}
    assert made["a_angle"] == "x"
    assert made["b_angle"] == "x + z + phi"
    assert made["c_angle"] == "k"
    assert made["d_angle"] == "x"
    assert made["b_x1"] == "cos(b_angle)"
    assert made["d_w2"] == "b_w2 + x'"


DRAWN = """draw:
  - {parent: rod, point: [a, 0], name: tip}
  - {parent: rod, line: [[0, 0], [a, 1]]}
  - {parent: rod, circle: {centre: [a, 0], radius: 1}}
  - {parent: rod, body: {shape: [[0, 0], [1, 0], [0, 1]]}}
"""


def test_shapes_on_a_body_in_the_plane_stay_in_it() -> None:
    made = spec("bodies: {rod: {at: [x, z], turns: [z: phi, z: x], mass: m, inertia: I}}\n", DRAWN).draw
    assert [figure.kind for figure in made] == ["point", "line", "circle", "body"]
    assert not any(figure.spatial for figure in made)
    assert [unparse(tree) for tree in made[0].points[0]] == ["x + a*rod_x1", "z + a*rod_y1"]
    assert [unparse(tree) for tree in made[1].points[1]] == ["x + a*rod_x1 + rod_x2", "z + a*rod_y1 + rod_y2"]
    assert unparse(made[3].angle or made[3].at[0]) == "phi + x"
    assert made[0].name == "tip"


def test_shapes_on_a_body_in_space_move_with_all_of_its_axes() -> None:
    made = spec("bodies: {rod: {at: [x, 0, z], turns: [y: phi], mass: m, inertia: I}}\n", DRAWN).draw
    assert [figure.kind for figure in made] == ["point", "line", "circle", "line"]
    assert all(figure.spatial for figure in made)
    assert [unparse(tree) for tree in made[2].normal] == ["rod_x3", "0", "rod_z3"]
    assert len(made[3].points) == 4
    assert [unparse(tree) for tree in made[3].points[3]] == [unparse(tree) for tree in made[3].points[0]]


def test_a_round_body_is_written_without_its_spin() -> None:
    wheel = "bodies: {f: {turns: [z: x]}, w: {parent: f, turns: [y: phi], inertia: [I, k, I]}}\n"
    made = {d.name: unparse(d.value) for d in spec(wheel, "T: z'^2/2\n").definitions}
    assert made["w_T"] == "k/2*phi'^2 + I/2*f_w3^2"


def test_a_ball_that_turns_in_space_is_written_without_its_orientation() -> None:
    ball = "bodies: {B: {at: [x, z, a], rotation: R, mass: m, inertia: I}}\npoints: {c: {of: B, at: [x, z, 0]}}\n"
    rolling = ball + "constraints: [c_vx = 0, c_vy = 0]\nT: phi'^2\n"
    by_hand = "T: phi'^2 + m/2*(x'^2 + z'^2) + I/2*(R_wx^2 + R_wy^2 + R_wz^2)\n"
    by_hand += "constraints: [x' - a*R_wy = 0, z' + a*R_wx = 0]\n"
    made = spec("rotation: {R: {frame: space}}\n", rolling)
    assert not any("R_x1" in unparse(d.value) for d in made.definitions if d.name in ("B_T", "c_vx", "c_vy"))
    assert same(made, spec("rotation: {R: {frame: space}}\n", by_hand))


@pytest.mark.parametrize(("height", "kind"), [("0", "body"), ("a", "line")])
def test_a_box_on_a_body_that_stays_level(height: str, kind: str) -> None:
    """Corners above the plane are seen in space, though the body only turns about the vertical."""
    corners = f"[[0, 0, 0], [1, 0, 0], [1, 0, {height}]]"
    drawn = f"draw: [{{parent: rod, body: {{shape: {corners}}}}}]\n"
    (made,) = spec("bodies: {rod: {at: [x, z], turns: [z: phi], mass: m, inertia: I}}\n", drawn).draw
    assert made.kind == kind and made.spatial == (kind == "line")


def test_a_shape_on_a_body_may_show_velocities() -> None:
    """An arrow along the velocity of a point, on the body's axes."""
    tip = "points: {tip: {parent: rod, at: [a, 0, 0]}}\n"
    drawn = 'draw: [{parent: rod, line: [[a, 0, 0], [a + tip_v1, 0, tip_v3], ["x\'", 0, zdot]]}]\n'
    (made,) = spec(ROD, tip, drawn).draw
    assert unparse(made.points[1][0]) == "x + (a + tip_v1)*rod_x1 + tip_v3*rod_x3"
    assert unparse(made.points[2][0]) == "x + x'*rod_x1 + z'*rod_x3"


def test_a_minus_stands_before_the_whole_of_a_sum() -> None:
    """The matter of a wheel that turns with t, seen from space: -(z - a), not -z - a."""
    wheel = "bodies: {w: {at: [0, 0, a], turns: [x: t]}}\npoints: {s: {of: w, at: [x, phi, z]}}\noutputs: {o: s_vy}\n"
    made = {d.name: unparse(d.value) for d in spec(wheel, "T: x'^2 + z'^2 + phi'^2\n").definitions}
    assert made["s_vy"] == "-(z - a)"


def test_gravity_on_a_unit_mass_along_an_incline() -> None:
    """V = -(g X - k Y): both of its signs change."""
    tilted = "bodies: {b: {at: [x, z], mass: 1}}\ngravity: [g, -k]\n"
    assert same(spec(tilted, "T: phi'^2\n"), spec("T: phi'^2 + (x'^2 + z'^2)/2\nV: k*z - g*x\n"))


def test_a_body_may_have_the_name_of_its_rotation() -> None:
    parts = "rotation: [R]\nbodies: {R: {at: [x, 0, z], rotation: R, mass: m, centre: [a, 0, 0], inertia: I}}\n"
    by_hand = "rotation: [R]\nT: phi'^2 + m/2*((x + a*R_x1)'^2 + (a*R_y1)'^2 + (z + a*R_z1)'^2) + I/2*(R_w1^2 + R_w2^2 + R_w3^2)\n"
    assert same(spec(parts, "T: phi'^2\n"), spec(by_hand))


def test_a_spec_that_extends_another_changes_its_bodies(tmp_path: Path) -> None:
    (tmp_path / "base.yaml").write_text(HEAD + ROD + "gravity: [0, 0, -g]\n")
    (tmp_path / "other.yaml").write_text("nhc: 1\nextends: base.yaml\nsystem: other\nbodies: {rod: {mass: 3*m}}\n")
    other = decode(read(tmp_path / "other.yaml"))
    assert same(other, spec(T.replace("m/2", "3*m/2"), f"V: 3*{V}\n"))


@pytest.mark.parametrize(
    ("part", "place"),
    [("at: [x, 0, zz]", "zz"), ("turns: [y: phi + qq]", "qq"), ("mass: m*mm", "mm"), ("centre: [a, 1/0, 0]", "0")],
)
def test_mistakes_are_marked_where_they_stand(part: str, place: str) -> None:
    text = f"{HEAD}bodies:\n  rod: {{parent: base, mass: m, inertia: I, {part}}}\n  base: {{at: [x, 0, z], turns: [x: phi]}}\n"
    text = text.replace("mass: m, inertia: I, mass", "inertia: I, mass")
    with pytest.raises(SpecError) as caught:
        resolve(decode(Source("s.yaml", text)))
    (found,) = caught.value.diagnostics
    span = found.labels[0].span
    assert text[span.start : span.end] == place


def test_a_derivation_tells_of_the_bodies() -> None:
    text = (
        "nhc: 1\nsystem: s\ncoordinates: [x, phi]\nrotation: [R]\nparameters: {m: 2, I: 0.3, a: 0.5}\n"
        "bodies: {cart: {at: [x, 0], mass: m, about: It runs on rails.}, rod: {parent: cart, at: [0, a, -a], "
        "turns: [y: phi, x: a], mass: m, centre: [a, 0], inertia: I}, top: {parent: rod, rotation: R, inertia: [I, 2*I, a]}, "
        "skew: {turns: [z: phi], inertia: {xx: I, zz: I, xz: -a}}}\n"
    )
    shown = " ".join(derive(Source("s.yaml", text)).split())
    for said in (
        "- `cart` in space, its origin at (x, 0); mass m. It runs on rails.",
        "- `rod` on `cart`, its origin at (0, a, -a), turned by phi about y, by a about x; mass m with its centre at (a, 0); "
        "moment of inertia I.",
        "- `top` on `rod`, turned by `R`; moments of inertia (I, 2*I, a).",
        "- `skew` in space, turned by phi about z; inertia matrix I at xx, I at zz, -a at xz.",
    ):
        assert said in shown


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("on: base", "parent"),
        ("com: [a, 0]", "centre"),
        ("position: [x, 0]", "at"),
        ("joint: [y: phi]", "turns"),
        ("I: m", "inertia"),
    ],
)
def test_keys_of_bodies_as_others_call_them(written: str, meant: str) -> None:
    with pytest.raises(SpecError) as caught:
        spec(f"bodies: {{base: {{mass: m}}, rod: {{mass: m, {written}}}}}\n")
    assert [found.help for found in caught.value.diagnostics] == [(f"write `{meant}`",)]


def test_a_name_with_a_combining_mark_is_no_other_name() -> None:
    """x with a circumflex, which no letter stands for, moves; the parameter x does not."""
    text = "nhc: 1\nsystem: s\ncoordinates: [x\u0302]\nparameters: {x: 2, m: 3, l: 0.5}\n"
    rod = "bodies: {b: {turns: [z: x\u0302], mass: m, centre: [l, 0]}}\n"
    by_hand = "T: m*l^2/2*x\u0302'^2\n"
    assert same(decode(Source("s.yaml", text + rod)), decode(Source("s.yaml", text + by_hand)))


@pytest.mark.parametrize(
    "body", ["{turns: [z: phi], mass: m}", "{at: [a, x]}", "{inertia: I}", "{at: [0, a], mass: m}"]
)
def test_a_body_at_rest_or_without_mass_has_the_kinetic_energy_zero(body: str) -> None:
    made = spec(f"bodies: {{b: {body}}}\n", "outputs: {o: b_T}\n", "T: x'^2 + z'^2 + phi'^2\n")
    assert {d.name: unparse(d.value) for d in made.definitions}["b_T"] == "0"


def test_a_velocity_with_the_name_of_a_parameter_is_said_once() -> None:
    with pytest.raises(SpecError) as caught:
        spec("bodies: {rod: {turns: [y: a*sin(k*t)], inertia: I}}\nquasi_velocities: {k: phi'}\nT: phi'^2\n")
    assert [one.code for one in caught.value.diagnostics] == ["E0305"]
