"""The Spec: what decode makes of a valid spec."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
import sympy.physics.units
import sympy.physics.units.systems.si
import yaml

from nhc.diagnostics import Source, SpecError
from nhc.language import Differential, Name, Number, Prime, Spec, decode, walk
from nhc.language.expressions.unparse import unparse
from nhc.language.keys import COORDINATE_KEYS, PARAMETER_KEYS, SCENE_KEYS, SPEC_KEYS
from nhc.language.schema import reference_table, schema
from nhc.language.template import template
from nhc.language.units.dimensions import UnitError, parse_unit, show
from nhc.resources import find_specs

FULL = """\
nhc: 1
system: chaplygin_sleigh
about: A rigid body
  on a knife edge.
source: ["Chaplygin 1911", "Neimark and Fufaev 1972, ch. III"]
coordinates:
  x: {unit: m, about: "place, along", range: [-1, 2*pi]}
  y: {}
  \u03b8: {unit: rad}
parameters:
  m: {value: 1.0, unit: kg, about: mass}
  I: 0.3
  a: pi/10
  k: {about: no value}
define:
  vy: Ydot
  vx: x' - a*sin(theta)*thetadot
  Y: y + a*sin(\u03b8)
T: m/2*(vx^2 + vy^2) + I/2*w^2
V: k*x^2
forces:
  theta: -0.1*w
constraints:
  - -sin(theta)*dx + cos(theta)*dy - k*dt = 0
  - slip: -sin(theta)*x' + cos(theta)*y' = 0
holonomic:
  - x^2 + y^2 = 1
quasi_velocities:
  v: cos(theta)*x' + sin(theta)*y'
  w: theta'
dependent: [y, x', theta]
formulation: multipliers
outputs:
  speed: v
  work: T - V + energy
  Y: Y
scenes:
  glide:
    about: starts straight
    parameters: {k: 2, a: 2/5}
    initial: {\u03b8: 0.1, x': -1e-3, v: 2*pi*m, w: +0.5}
    time: [0, 6*pi]
    need: [x, theta', v, work, Y, energy, reactions]
    tolerance: 1e-6
  rest: {time: [0, 1], parameters: {k: 1}}
"""


def make(text: str) -> Spec:
    return decode(Source("a.yaml", text))


def test_everything_arrives() -> None:
    spec = make(FULL)
    assert (spec.version, spec.system, spec.about) == (1, "chaplygin_sleigh", "A rigid body on a knife edge.")
    assert spec.sources == ("Chaplygin 1911", "Neimark and Fufaev 1972, ch. III")
    assert [c.name for c in spec.coordinates] == ["x", "y", "theta"]
    assert spec.coordinates[0].about == "place, along"
    assert spec.coordinates[0].range is not None
    assert float(spec.coordinates[0].range[1]) == pytest.approx(6.283185307179586, abs=0)
    values = [p.value for p in spec.parameters]
    assert values[:2] == [1, Fraction(3, 10)]
    assert values[3] is None
    assert unparse(values[2]) == "pi/10"  # type: ignore[arg-type]
    assert [d.name for d in spec.definitions] == ["Y", "vy", "vx"]
    assert unparse(spec.definitions[1].value) == "Y'"
    assert unparse(spec.definitions[2].value) == "x' - a*sin(theta)*theta'"
    order = spec.named_order
    assert sorted(order) == ["Y", "v", "vx", "vy", "w"]
    assert order.index("Y") < order.index("vy")
    assert unparse(spec.kinetic) == "m/2*(vx^2 + vy^2) + I/2*w^2"
    assert (spec.potential_kind, [f.name for f in spec.forces]) == ("V", ["theta"])
    assert [(c.name, c.form) for c in spec.constraints] == [("c1", "differential"), ("slip", "velocity")]
    forms = [node.name for node in walk(spec.constraints[0].left) if isinstance(node, Differential)]
    assert forms == ["x", "y", "t"]
    assert [(h.name, unparse(h.left), unparse(h.right)) for h in spec.holonomic] == [("h1", "x^2 + y^2", "1")]
    assert [q.name for q in spec.quasi_velocities] == ["v", "w"]
    assert (spec.dependent, spec.formulation) == (("y", "x", "theta"), "multipliers")
    assert [o.name for o in spec.outputs] == ["speed", "work", "Y"]


def test_scenes_arrive() -> None:
    glide, rest = make(FULL).scenes
    assert (glide.name, glide.about, glide.tolerance) == ("glide", "starts straight", Fraction(1, 10**6))
    assert [p.name for p in glide.parameters] == ["k", "a"]
    assert glide.parameters[0].value == 2
    assert [(i.kind, i.name, unparse(i.value)) for i in glide.initial] == [
        ("coordinate", "theta", "0.1"),
        ("velocity", "x", "-0.001"),
        ("quasi", "v", "2*pi*m"),
        ("quasi", "w", "0.5"),
    ]
    assert [float(time) for time in glide.time] == [0, pytest.approx(18.84955592153876)]
    assert [(n.kind, n.name) for n in glide.need] == [
        ("coordinate", "x"),
        ("velocity", "theta'"),
        ("quasi", "v"),
        ("output", "work"),
        ("output", "Y"),
        ("energy", "energy"),
        ("reactions", "reactions"),
    ]
    assert [n.name for n in rest.need] == ["x", "y", "theta"]
    assert (rest.tolerance, rest.initial, rest.time) == (Fraction(1, 10**8), (), (0, 1))


def test_places_arrive() -> None:
    spec = make(FULL)
    text = spec.origin.text
    assert text[spec.key_span("V").start :].startswith("V: k")
    assert spec.origin.position(spec.constraints[1].span.start) == (25, 5)
    assert spec.key_span("U").end == 0


def test_a_declared_name_wins() -> None:
    spec = make(
        "nhc: 1\nsystem: s\ncoordinates: [x, dy, y]\nparameters: {xdot: 2, T: 3}\nT: xdot*x'^2\n"
        "constraints: [dy*dx + xdot*dt = 0]\noutputs: {energy: T, e: T^2}\n"
        "scenes: {s: {time: [0, 1], need: [energy]}}\n"
    )
    assert not any(isinstance(node, Prime) and unparse(node) == "xdot'" for node in walk(spec.kinetic))
    assert unparse(spec.kinetic) == "xdot*x'^2"
    assert unparse(spec.constraints[0].left) == "dy*dx + xdot*dt"
    assert [type(n).__name__ for n in walk(spec.constraints[0].left) if not isinstance(n, Number)][3:5] == [
        "Differential",
        "Binary",
    ]
    assert isinstance(spec.outputs[0].value, Name)
    assert spec.scenes[0].need[0].kind == "output"


@pytest.mark.parametrize("path", sorted(find_specs().glob("*.yaml")), ids=lambda path: path.stem)
def test_the_gallery_fits_the_schema(path: object) -> None:

    text = path.read_text(encoding="utf-8")  # type: ignore[attr-defined]
    make(text)
    jsonschema.Draft202012Validator(schema()).validate(yaml.safe_load(text))


def test_the_schema_is_made_of_the_table() -> None:
    tree = schema()
    jsonschema.Draft202012Validator.check_schema(tree)
    assert list(tree["properties"]) == [key.name for key in SPEC_KEYS]
    assert tree["required"] == ["nhc"]
    ways = [["nhc", "system", placed, energy] for placed in ("coordinates", "rotation") for energy in ("T", "bodies")]
    assert tree["anyOf"] == [{"required": keys} for keys in (["extends"], *ways)]
    validator = jsonschema.Draft202012Validator(tree)
    good = {"nhc": 1, "system": "s", "coordinates": ["x"], "T": "x'^2"}
    assert validator.is_valid(good)
    for rotation in (["R"], {"R": {}}, {"R": {"velocities": ["a", "b", "c"], "frame": "space"}}):
        assert validator.is_valid({"nhc": 1, "system": "s", "rotation": rotation, "T": "a^2"})
    body = {"at": ["x", 0], "turns": [{"z": "x"}, {"x": 1}], "mass": 1, "inertia": [1, 2, "a"]}
    heavy = {"nhc": 1, "system": "s", "coordinates": ["x"], "bodies": {"b": body}, "gravity": [0, -9.81]}
    assert validator.is_valid({**heavy, "points": {"p": {"parent": "b", "at": [0, 0, 1], "of": "b"}}})
    for wrong in (
        {"turns": {"z": "x"}},
        {"turns": [{"z": 1, "x": 2}]},
        {"turns": [{"w": 1}]},
        {"inertia": [1, 2]},
        {"at": 0},
    ):
        assert not validator.is_valid({**heavy, "bodies": {"b": {**body, **wrong}}})
    for path in (Path(__file__).resolve().parents[2] / "specs" / "bodies").glob("*.yaml"):
        assert validator.is_valid(yaml.safe_load(path.read_text())), path
    for start in ([1, 0, 0, "a"], {"axis": [0, 0, 1], "angle": "pi"}, {"yaw": 1}):
        assert validator.is_valid({**good, "scenes": {"s": {"time": [0, 1], "initial": {"R": start}}}})
    for rotation in ([], {}, {"R": {"velocities": ["a", "b"]}}, {"R": {"frame": "inertial"}}):
        assert not validator.is_valid({**good, "rotation": rotation})
    for change in (
        {"nhc": 2},
        {"system": "S"},
        {"coordinates": []},
        {"U": 0, "V": 0},
        {"extra": 1},
        {"constraints": ["x"]},
    ):
        assert not validator.is_valid({**good, **change})
    table = reference_table()
    for key in (*SPEC_KEYS, *COORDINATE_KEYS, *PARAMETER_KEYS, *SCENE_KEYS):
        assert f"| `{key.name}` |" in table


def test_the_template_decodes() -> None:
    text = template("My-Sleigh")
    assert text.startswith("# yaml-language-server: $schema=./nhc.schema.json\n")
    spec = make(text)
    assert (spec.system, [scene.name for scene in spec.scenes]) == ("my_sleigh", ["glide"])
    with pytest.raises(ValueError, match="is no name"):
        template("123")


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        *(("kg", "kg"), ("m/s^2", "m/s^2"), ("N*m", "kg*m^2/s^2"), ("kg m^2", "kg*m^2"), ("rad", "1"), ("deg", "1")),
        *(("1", "1"), ("1/s", "1/s"), ("km/h", "m/s"), ("W/(m^2*K)", "kg/s^3/K"), ("m\u00b2\u00b7s^-1", "m^2/s")),
        *(("\u03a9", "kg*m^2/s^3/A^2"), ("mN", "kg*m/s^2"), ("cm", "m"), ("1/(m s)^2", "1/m^2/s^2"), ("m**2", "m^2")),
    ],
)
def test_a_unit_has_its_dimension(text: str, dimension: str) -> None:
    assert show(parse_unit(text)) == dimension


def test_derived_units_are_those_of_the_international_system() -> None:
    """Each named unit, and with a prefix, by SymPy's tables; minutes, hours and degrees take none."""
    names = {
        "N": "newton",
        "J": "joule",
        "eV": "electronvolt",
        "W": "watt",
        "Pa": "pascal",
        "bar": "bar",
        "Hz": "hertz",
    }
    names |= {"C": "coulomb", "V": "volt", "F": "farad", "ohm": "ohm", "S": "siemens", "Wb": "weber", "T": "tesla"}
    names |= {
        "H": "henry",
        "L": "liter",
        "l": "liter",
        "t": "tonne",
        "g": "gram",
        "m": "meter",
        "s": "second",
        "A": "ampere",
    }
    names |= {"K": "kelvin", "mol": "mole", "cd": "candela", "min": "minute", "h": "hour"}
    base = {"mass": "kg", "length": "m", "time": "s", "current": "A", "temperature": "K", "amount_of_substance": "mol"}
    base["luminous_intensity"] = "cd"
    system = sympy.physics.units.systems.si
    for name, word in names.items():
        whole = system.SI.get_quantity_dimension(getattr(sympy.physics.units, word))
        powers = system.dimsys_SI.get_dimensional_dependencies(whole)
        wanted = {base[str(dimension.name)]: power for dimension, power in powers.items()}
        product = "*".join(f"{unit}^{power}" for unit, power in wanted.items())
        assert parse_unit(name) == parse_unit(product), name
        prefixes = {"min": (), "h": (), "t": ("k", "M")}.get(name, ("k", "m", "da", "\u00b5"))
        for prefix in prefixes:
            assert parse_unit(prefix + name) == parse_unit(name)


@pytest.mark.parametrize(
    "text",
    ["ft", "mt", "kmin", "mh", "mdeg", "k1", "metre", "", "kg*", "/s", "m^x", "m^", "(m", "m)", "2", "m^0.5", "m?"],
)
def test_texts_that_are_no_units(text: str) -> None:
    with pytest.raises(UnitError) as caught:
        parse_unit(text)
    assert 0 <= caught.value.start <= caught.value.end <= len(text)


UNITS = (
    "nhc: 1\nsystem: s\ncoordinates: {x: {unit: m}}\nparameters: {m: {value: 1, unit: kg}, w: {value: 1, unit: 1/s}}\n"
)


@pytest.mark.parametrize(
    "line",
    [
        "T: m/2*x'^2",
        "T: m/2*x'^2 + 0",
        "T: x'^2/2",
        "T: m/2*x'^2 + m*(x*w)^2*cos(w*t)^2 + m*abs(x)*sqrt(x^2)*w^2",
        "T: m*x'^2*exp(0)*min(1, sin(w*t))",
        "T: m/2*x'^2\nV: m*(w*x)^(4/2)",
    ],
)
def test_units_that_fit(line: str) -> None:
    make(UNITS + line + "\n")


@pytest.mark.parametrize(
    "line", ["T: m*x'", "T: m*x'^2 + x", "T: m*x'^2\nV: m*x", "T: m*x'^2*sin(t)", "T: m*x'^2 - m*w^t", "T: m*x'^2*x^w"]
)
def test_units_that_do_not_fit(line: str) -> None:
    with pytest.raises(SpecError) as caught:
        make(UNITS + line + "\n")
    assert {found.code for found in caught.value.diagnostics} == {"E0413"}


PARTIAL = UNITS.replace(", w: {value: 1, unit: 1/s}", ", w: 1")


@pytest.mark.parametrize(
    "line",
    [
        "T: m*x'^2 + w*m + w*x",
        "T: m/2*x'^2*sin(x)\nV: m*9.81*x",
        "T: m*x'",
        "T: m/2*x'^2*m^t\nV: (x - 1)^2 + w*m + 4*x",
        "T: m/2*x'^2*max(x, 1)\nV: m*(3*x)*t + m",
        "T: m/2*x'^2\nconstraints: [\"x' = 2\"]",
        "T: m/2*x'^2 + x'^2/2\nV: w*(x^2 - x)",  # a length and a mass with the value 1 are left out
        "T: m/2*x'^2\nconstraints: [\"x' = x\"]",
        "T: m/2*x'^2\nV: w*max(x, x^2)",
    ],
)
def test_where_units_lack_what_may_be_left_out_is_no_error(line: str) -> None:
    make(PARTIAL + line + "\n")


@pytest.mark.parametrize(
    "line",
    [
        "T: m*x'^2 + m",
        "T: m/2*x'^2\nV: w*(x - m)",
        "T: m/2*x'^2\nV: w*max(x, m)",
        "T: m/2*x'^2\nforces: {x: w - m + x}",
        "T: m/2*x'^2\noutputs: {o: x*x'/m - m}",
        "T: m/2*x'^2\nconstraints: [\"x' = x*m\"]",
    ],
)
def test_where_units_lack_sums_of_what_has_them_are_checked(line: str) -> None:
    with pytest.raises(SpecError) as caught:
        make(PARTIAL + line + "\n")
    assert [found.code for found in caught.value.diagnostics] == ["E0413"]


def test_no_units_no_analysis() -> None:
    make("nhc: 1\nsystem: s\ncoordinates: [x]\nparameters: {m: 1}\nT: m*x'^2 + m + x\n")
