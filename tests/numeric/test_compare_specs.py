"""Two specs side by side: pairs that are the same motion in other writing, and near misses with what is known of them."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.diagnostics import Source, SpecError
from nhc.language import decode, read
from nhc.mechanics.pairs.verdict import Comparison, compare_systems
from nhc.mechanics.resolving.resolve import resolve
from tests.support import spec_path

SLEIGH = """
coordinates: [x, y, theta]
parameters: {m: 1, I: 0.3, a: 0.25, c: 0.1}
define: {X: "x + a*cos(theta)", Y: "y + a*sin(theta)"}
T: m/2*(X'^2 + Y'^2) + I/2*theta'^2
forces: {theta: -c*theta'}
constraints: [{slip: "-sin(theta)*x' + cos(theta)*y' = 0"}]
scenes: {go: {initial: {theta: 0.1, x': 1, theta': 0.5}, time: [0, 5]}}
"""
CENTRED = """
coordinates: [X, Y, theta]
parameters: {m: 1, I: 0.3, a: 0.25, c: 0.1}
define: {edge_x: "X - a*cos(theta)", edge_y: "Y - a*sin(theta)"}
T: m/2*(X'^2 + Y'^2) + I/2*theta'^2
forces: {theta: -c*theta'}
constraints: [{slip: "-sin(theta)*edge_x' + cos(theta)*edge_y' = 0"}]
scenes: {go: {initial: {theta: 0.1, X': 1, Y': 0.2, theta': 0.5}, time: [0, 5]}}
"""
SPHERE = """
coordinates: [x, y, z]
parameters: {m: 1, k: 2}
T: m/2*(x'^2 + y'^2 + z'^2)
V: k*z
holonomic: [{s: x^2 + y^2 + z^2 = 1}]
scenes: {go: {initial: {x: 1, y': 1}, time: [0, 5]}}
"""
PARTICLE = """
coordinates: [x, y, z]
parameters: {m: 1}
T: m/2*(x'^2 + y'^2 + z'^2)
constraints: [{one: "z' = y*x'"}]
"""
KEPLER = "coordinates: [x, y]\nparameters: {mu: 1}\nT: (x'^2 + y'^2)/2\nU: mu/sqrt(x^2 + y^2)\n"
POLAR = "coordinates: {r: {}, f: {}}\nparameters: {mu: 1}\nT: (r'^2 + r^2*f'^2)/2\nU: mu/r\n"
PENDULUM = """
coordinates: [theta]
parameters: {m: 2, l: 0.5, g: 9.81}
T: m*l^2/2*theta'^2
V: -m*g*l*cos(theta)
scenes: {swing: {initial: {theta: 1}, time: [0, 5]}}
"""
WHEEL = """
coordinates: [x, y, theta, psi]
parameters: {m: 1, I: 0.3, a: 0.25, c: 0.1, r: 0.2}
define: {X: "x + a*cos(theta)", Y: "y + a*sin(theta)"}
T: m/2*(X'^2 + Y'^2) + I/2*theta'^2
forces: {theta: -c*theta'}
constraints: [{slip: "-sin(theta)*x' + cos(theta)*y' = 0"}, {roll: "r*psi' = cos(theta)*x' + sin(theta)*y'"}]
"""


def compare(first: str, second: str, *maps: str) -> Comparison:
    texts = [f"nhc: 1\nsystem: s\n{text}" for text in (first, second)]
    systems = [resolve(decode(Source("s.yaml", text))) for text in texts]
    return compare_systems(systems[0], systems[1], maps, ("A", "B"))


def changed(text: str, *pairs: tuple[str, str]) -> str:
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    return text


BY_HAND = "m/2*(x'^2 + y'^2) + m*a*theta'*(cos(theta)*y' - sin(theta)*x') + (I + m*a^2)/2*theta'^2"
SAME = [
    (SLEIGH, SLEIGH, ()),
    (SLEIGH, changed(SLEIGH, ("m/2*(X'^2 + Y'^2) + I/2*theta'^2", BY_HAND)), ()),
    (SLEIGH, SLEIGH + 'quasi_velocities: {v: "cos(theta)*x\' + sin(theta)*y\'", w: "theta\'"}\n', ()),
    (SLEIGH, changed(SLEIGH, ("theta", "phi"), ("x", "u")), ("theta=phi, x=u",)),
    (SLEIGH, changed(SLEIGH, ("x", "@"), ("y", "x"), ("@", "y")), ("x=y", "y=x")),
    (SLEIGH, changed(SLEIGH, ("{m: 1", "{M: 1"), ("T: m", "T: M")), ("m=M",)),
    (SLEIGH, changed(SLEIGH, ("{m: 1", "{M: 1"), ("T: m/2", "T: M"), ("I/2", "I/2")), ("m=2*M",)),
    (SLEIGH, CENTRED, ("x=edge_x, y=edge_y",)),  # by what the second spec defines
    # the same plane of velocities, by other forms
    (
        PARTICLE,
        changed(PARTICLE, ("z' = y*x'", "(1 + x^2)*(dz - y*dx) = 0")),
        (),
    ),
    (
        changed(WHEEL, ("r*psi' = cos(theta)*x' + sin(theta)*y'", "r*psi' - cos(theta)*x' = sin(theta)*y'")),
        changed(
            WHEEL,
            ("-sin(theta)*x' + cos(theta)*y' = 0", "x' = r*cos(theta)*psi'"),
            ("r*psi' = cos(theta)*x' + sin(theta)*y'", "y' = r*sin(theta)*psi'"),
        ),
        (),
    ),
    # T in a steadily turning frame, and in one at rest
    (
        "coordinates: [x, y]\nparameters: {m: 1, k: 2, w: 3}\nT: m/2*(x'^2 + y'^2)\nV: k/2*(x^2 + y^2)\nforces: {x: -m*y'}\n",
        "coordinates: [u, v]\nparameters: {m: 1, k: 2, w: 3}\nT: m/2*((u' - w*v)^2 + (v' + w*u)^2)\nV: k/2*(u^2 + v^2)\n"
        "forces: {u: -m*cos(w*t)*(sin(w*t)*(u' - w*v) + cos(w*t)*(v' + w*u)), "
        "v: m*sin(w*t)*(sin(w*t)*(u' - w*v) + cos(w*t)*(v' + w*u))}\n",
        ("x=u*cos(w*t) - v*sin(w*t), y=u*sin(w*t) + v*cos(w*t)",),
    ),
    # energies that differ by what does no work, or by a constant factor
    (PENDULUM, changed(PENDULUM, ("m*l^2/2", "l^2"), ("-m*g*l", "-2*g*l")), ()),
    (PENDULUM, changed(PENDULUM, ("-m*g*l*cos(theta)", "m*g*l*(1 - cos(theta))")), ()),
    # on the sphere only: the force has another component across it
    (SPHERE, changed(SPHERE, ("V: k*z", "V: k*z*(x^2 + y^2 + z^2)")), ()),
    (SPHERE, changed(SPHERE, ("x^2 + y^2 + z^2 = 1", "1 = z^2 + y^2 + x^2")), ()),
    ("coordinates: [x]\nT: x'^2/2\nV: abs(x)\n", "coordinates: [x]\nT: x'^2/2\nV: sqrt(x^2)\n", ()),
    # a root is the radius where that has no other sign
    (KEPLER, POLAR.replace("{}", "{range: [0, 9]}"), ("x=r*cos(f), y=r*sin(f)",)),
    ("coordinates: [x]\nT: x'^2/2\nV: max(x, 0)\n", "coordinates: [x]\nT: x'^2/2\nV: (x + abs(x))/2\n", ()),
]


@pytest.mark.parametrize(("first", "second", "maps"), SAME, ids=range(len(SAME)))
def test_the_same_motion_in_other_writing(first: str, second: str, maps: tuple[str, ...]) -> None:
    made = compare(first, second, *maps)
    assert made.agrees
    assert made.is_sure
    assert not made.by_states
    assert made.measured.states >= 8
    assert made.largest < 1e-9


# specs, the coordinates whose accelerations differ, and whether they differ without potential and forces as well
NEAR = [
    (SLEIGH, changed(SLEIGH, ("y + a*sin", "y - a*sin")), "x y theta", True),
    (SLEIGH, changed(SLEIGH, ("I/2", "I")), "theta", True),
    (SLEIGH, changed(SLEIGH, ("forces: {theta: -c*theta'}\n", "")), "theta", False),
    (SLEIGH, changed(SLEIGH, ("-c*theta'", "c*theta'")), "theta", False),
    (SLEIGH, changed(SLEIGH, ("X'^2 + Y'^2", "x'^2 + y'^2 + a^2*theta'^2")), "x y theta", True),
    # constraints put into T before it is varied
    (PARTICLE, changed(PARTICLE, ("y'^2 + z'^2", "y'^2 + (y*x')^2")), "x y z", None),
    (PENDULUM, changed(PENDULUM, ("/2*theta", "*theta")), "theta", False),
    (SPHERE, changed(SPHERE, ("V: k*z", "V: k*z*(x^2 + y^2 + 2*z^2)")), "x y z", False),
    ("coordinates: [x]\nT: x'^2/2\nV: x\n", "coordinates: [x]\nT: x'^2/2\nV: abs(x)\n", "x", False),
    ("coordinates: [x]\nT: x'^2/2\n", "coordinates: [x]\nT: x'^2/2\nV: 1e-3*t*x\n", "x", False),
]


@pytest.mark.parametrize(("first", "second", "where", "in_t"), NEAR, ids=range(len(NEAR)))
def test_a_near_miss_is_told_by_its_coordinate(first: str, second: str, where: str, in_t: bool | None) -> None:
    made = compare(first, second)
    assert not made.agrees
    names = made.pairing.first.q_names
    assert [name for name, equal in zip(names, made.found.equal, strict=True) if not equal] == where.split()
    assert made.largest > 1e-4
    assert (None if made.bare is None else not made.bare.agrees) == in_t
    for equal, off in zip(made.found.equal, made.measured.differences, strict=True):
        assert equal == (off < 1e-12)


def test_the_state_that_is_shown_has_the_accelerations_that_are_shown() -> None:
    """theta'' = -g sin(theta)/l, and half of it where T lacks its half."""
    made = compare(PENDULUM, changed(PENDULUM, ("/2*theta", "*theta")))
    worst = made.measured.worst
    assert worst is not None
    at = dict(worst.values)
    truth = -at["g"] * math.sin(at["theta"]) / at["l"]
    assert worst.first == pytest.approx((truth,), rel=1e-12)
    assert worst.second == pytest.approx((truth / 2,), rel=1e-12)
    assert made.largest == pytest.approx(abs(truth / 2) / max(1.0, abs(truth)), rel=1e-12)


def test_the_sleigh_by_a_closed_form() -> None:
    """(I + m a^2) w' = -m a v w - c w on v = (cos, sin) . (x', y'); without friction its last term is missing."""
    made = compare(SLEIGH, changed(SLEIGH, ("forces: {theta: -c*theta'}\n", "")))
    worst = made.measured.worst
    assert worst is not None
    at = dict(worst.values)
    v = math.cos(at["theta"]) * at["x'"] + math.sin(at["theta"]) * at["y'"]
    inertia = at["I"] + at["m"] * at["a"] ** 2
    turn = -at["m"] * at["a"] * v * at["theta'"] / inertia
    assert worst.second[2] == pytest.approx(turn, rel=1e-10)
    assert worst.first[2] == pytest.approx(turn - at["c"] * at["theta'"] / inertia, rel=1e-10)


def test_velocities_that_differ() -> None:
    slow = changed(SLEIGH, ("y' = 0", "y' = c"))
    made = compare(SLEIGH, slow)
    assert not made.agrees
    assert made.found.violated == (("slip",), ())
    assert made.found.freedom == (2, 2)
    free = changed(SLEIGH, ("constraints: [{slip: \"-sin(theta)*x' + cos(theta)*y' = 0\"}]\n", ""))
    assert compare(SLEIGH, free).found.violated == (("slip",), ())
    assert compare(free, SLEIGH).found.violated == ((), ("slip",))
    assert compare(free, SLEIGH).found.freedom == (3, 2)
    for pair in ((SLEIGH, slow), (SLEIGH, free), (free, SLEIGH)):
        assert compare(*pair).measured.worst is None


def test_a_constraint_that_follows_from_the_others() -> None:
    more = changed(SLEIGH, ("y' = 0\"}", "y' = 0\"}, {again: \"2*sin(theta)*x' - 2*cos(theta)*y' = 0\"}"))
    with pytest.raises(SpecError) as caught:
        compare(SLEIGH, more)
    assert [d.code for d in caught.value.diagnostics] == ["E0402"]


def test_coordinates_that_only_one_spec_has() -> None:
    for pair in ((SLEIGH, WHEEL), (WHEEL, SLEIGH)):
        made = compare(*pair)
        assert made.agrees
        assert made.measured.states > 8
        assert sorted(map(len, made.pairing.alone)) == [0, 1]
        assert ("r = 0.2",) in made.pairing.fixed
    made = compare(SLEIGH, changed(WHEEL, ("-c*theta'", "-c*theta' + sin(psi)")))
    assert not made.agrees
    assert made.suspects == ((), ("psi",))


def test_different_coordinates_of_one_body() -> None:
    flat = "coordinates: [x, y]\nparameters: {m: 1, l: 2, g: 9}\nT: m/2*(x'^2 + y'^2)\nV: m*g*y\nholonomic: [x^2 + y^2 = l^2]\n"
    assert compare(flat, PENDULUM, "x=l*sin(theta), y=-l*cos(theta)").agrees
    above = compare(flat, PENDULUM, "x=l*sin(theta), y=l*cos(theta)")
    assert above.found.equal == (False, False)
    longer = compare(flat, PENDULUM, "x=2*l*sin(theta), y=-2*l*cos(theta)")
    assert not longer.found.same_places
    assert not longer.agrees
    kept = changed(flat, ("holonomic: [x^2 + y^2 = l^2]", "constraints: [x*x' + y*y' = 0]"))
    assert compare(kept, flat).agrees
    assert compare(kept, flat).found.places == (2, 1)
    assert compare(flat, kept).agrees


def test_a_quaternion_and_euler_angles() -> None:
    half = "(phi {} psi)/2"
    turns = (
        f"R_0=cos(theta/2)*cos({half.format('+')}), R_1=sin(theta/2)*cos({half.format('-')}), "
        f"R_2={{}}sin(theta/2)*sin({half.format('-')}), R_3=cos(theta/2)*sin({half.format('+')})"
    )
    for sign, same in (("", True), ("-", False)):
        first, second = (resolve(decode(read(spec_path(n)))) for n in ("heavy_top_quaternion", "heavy_top"))
        assert compare_systems(first, second, (turns.format(sign),), ("A", "B")).agrees == same


ODD = changed(SPHERE, ("x^2 + y^2 + z^2 = 1", "x + x^3 + y + y^3 + sin(z) = 2"), ("{x: 1, y': 1}", "{x: 1}"))


def test_positions_that_cannot_be_solved_for() -> None:
    """Accelerations that are equal where the equation holds only are compared at states, and so are two such equations."""
    on = "(x + x^3 + y + y^3 + sin(z) - 2)"
    assert compare(ODD, ODD).agrees
    assert not compare(ODD, ODD).by_states
    across = compare(ODD, changed(ODD, ("V: k*z", f"V: k*z*(1 + {on})")))
    assert across.agrees
    assert across.by_states
    along = compare(ODD, changed(ODD, ("V: k*z", f"V: k*z*(2 + {on})")))
    assert not along.agrees
    other = compare(ODD, changed(ODD, ("x + x^3 + y + y^3 + sin(z) = 2", f"{on}*(1 + {on}^2) = 0")))
    assert other.agrees
    assert other.fitting > 8
    assert not compare(ODD, changed(ODD, ("= 2}", "= 2.01}"))).agrees


def test_what_else_differs_is_said() -> None:
    first = changed(PENDULUM, ("[theta]", "{theta: {unit: rad}}"), ("m: 2", "m: {value: 2, unit: kg}"))
    second = changed(PENDULUM, ("[theta]", "{theta: {unit: deg}}"), ("m: 2", "m: {value: 3, unit: g}"))
    made = compare(first, second)
    assert made.agrees
    assert made.notes == (
        "`m` is 2 in A and 3 in B: equal values were compared",
        "`theta` is in rad in A and in deg in B: the numbers were compared",
        "`m` is in kg in A and in g in B: the numbers were compared",
    )


@pytest.mark.parametrize(
    ("maps", "code", "message"),
    [
        ("k=q", "E0506", "no function of parameters"),
        ("k=q'", "E0506", "no function of coordinates"),
        ("q=q'", "E0506", "no function of coordinates"),
        ("k=nothing", "E0302", "unknown name `nothing`"),
        ("nothing=q", "E0506", "no coordinate or parameter of the first spec"),
        (",", "E0506", "maps nothing"),
        ("k=1/0", "E0417", "divides by zero"),
        ("k=", "E0202", ""),
        ("", "E0506", "maps nothing"),
    ],
)
def test_maps_that_say_nothing(maps: str, code: str, message: str) -> None:
    first = "coordinates: [q]\nparameters: {m: 1, k: 2}\nT: m/2*q'^2\nV: q/k\n"
    with pytest.raises(SpecError) as caught:
        compare(first, "coordinates: [q]\nparameters: {m: 1}\nT: m/2*q'^2\n", maps)
    assert [d.code for d in caught.value.diagnostics] == [code]
    assert message in caught.value.diagnostics[0].message


def test_specs_that_cannot_be_compared() -> None:
    first = "coordinates: [q]\nparameters: {m: 1, k: 0}\nT: m/2*q'^2\nV: q/k\n"
    for second in ("coordinates: [q]\nT: q'^2/2\n", "coordinates: [p]\nT: p'^2/2\n"):
        with pytest.raises(SpecError) as caught:
            compare(first, second)
        assert [d.code for d in caught.value.diagnostics] == ["E0506"]
    closed = "coordinates: [q, r]\nT: q'^2/2 + r'^2/2\nholonomic: [r = q^3 + q]\n"
    with pytest.raises(SpecError, match="E0506"):
        compare(closed, "coordinates: [q]\nT: (1 + (3*q^2 + 1)^2)*q'^2/2\n")
    assert compare(closed, "coordinates: [q]\nT: (1 + (3*q^2 + 1)^2)*q'^2/2\n", "r=q^3 + q").agrees
    assert compare("coordinates: [q]\nT: (1 + (3*q^2 + 1)^2)*q'^2/2\n", closed).agrees


def test_identities_that_the_field_does_not_know() -> None:
    """Nobody is told that two specs differ where double precision finds them equal."""
    first = "coordinates: [x, y]\nT: x'^2/2 + y'^2/2\nforces: {x: log((1 + x^2)*(1 + y^2))}\n"
    made = compare(first, changed(first, ("log((1 + x^2)*(1 + y^2))", "log(1 + x^2) + log(1 + y^2)")))
    assert made.is_open and not made.agrees
    assert not compare(first, changed(first, ("(1 + y^2)", "(2 + y^2)"))).is_open


def test_parameters_without_a_value() -> None:
    """One that no default fixes stands for any value."""
    first = "coordinates: [x]\nT: x'^2/2\nV: x^2\n"
    other = "coordinates: [x]\nparameters: [m]\nT: m*x'^2/2\nV: m*x^2\n"
    for made in (compare(first, other), compare(other, first)):
        assert made.agrees
        assert made.pairing.open_parameters == ("m",)
    assert not compare(first, changed(other, ("m*x^2", "x^2"))).agrees


@pytest.mark.slow
def test_many_signs() -> None:
    first = "coordinates: [x, y]\nT: x'^2/2 + y'^2/2\nforces: {x: abs(x)*abs(y)*sign(x + y)*sign(x - y)*abs(x')}\n"
    same = changed(first, ("sign(x + y)*sign(x - y)", "sign(x^2 - y^2)"), ("abs(x)*abs(y)", "abs(x*y)"))
    assert compare(first, same).agrees
    assert not compare(first, changed(same, ("x^2 - y^2", "y^2 - x^2"))).agrees
    assert not compare(first, changed(same, ("abs(x*y)", "x*abs(y)"))).agrees


def test_a_radius_that_may_be_negative_is_told_with_the_state() -> None:
    maps = ("x=r*cos(f), y=r*sin(f)",)
    made = compare(KEPLER, POLAR, *maps)
    assert not made.agrees and made.measured.worst is not None and dict(made.measured.worst.values)["r"] < 0
    assert any("a root is |r| here" in note for note in made.notes)
    within = compare(KEPLER, POLAR.replace("{}", "{range: [0, 9]}", 1), *maps)
    assert within.agrees and within.is_sure and any("in the range of `r`" in note for note in within.notes)
    below = compare(KEPLER, POLAR.replace("{}", "{range: [-9, 0]}", 1), *maps)
    assert not below.agrees and not below.is_open
    other = compare(KEPLER, POLAR.replace("{}", "{range: [0, 9]}", 1).replace("mu/r", "mu/r + r"), *maps)
    assert not other.agrees and not any("|r|" in note for note in other.notes)


def test_another_rotation_of_the_same_kind() -> None:
    text = spec_path("free_rigid_body_quaternion").read_text()
    first, second = (resolve(decode(Source("s.yaml", t))) for t in (text, text.replace("R_", "S_").replace("R:", "S:")))
    assert compare_systems(first, second, ("R_0=S_0, R_1=S_1", "R_2=S_2, R_3=S_3"), ("A", "B")).agrees
    first, second = (resolve(decode(Source("s.yaml", t))) for t in (text, text.replace("R_", "S_").replace("R:", "S:")))
    assert not compare_systems(first, second, ("R_0=S_0, R_1=S_1", "R_2=S_3, R_3=S_2"), ("A", "B")).agrees


def test_exit_codes_and_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, text in (("a", SLEIGH), ("b", changed(SLEIGH, ("I/2", "I")))):
        (tmp_path / f"{name}.yaml").write_text(f"nhc: 1\nsystem: {name}\n{text}")
    a, b = (str(tmp_path / f"{name}.yaml") for name in "ab")
    assert main(["compare", a, a, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["schema"], data["agree"], data["coordinates"]) == ("nhc.compare-specs/1", True, ["x", "y", "theta"])
    assert main(["compare", a, b, "--json"]) == 1
    data = json.loads(capsys.readouterr().out)
    assert [one["equal"] for one in data["accelerations"]] == [True, True, False]
    assert data["most_different"]["state"]["theta'"]
    assert len(data["most_different"]["accelerations"]["theta''"]) == 2
    assert main(["compare", a, b]) == 1
    assert "they DIFFER in theta''" in capsys.readouterr().out
    for wrong in (["-", "-"], [a, b, "--certificate", "-"], [a, "--map", "x=y"]):
        assert main(["compare", *wrong]) == 2
