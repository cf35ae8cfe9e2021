"""A spec that extends another."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import jsonschema
import pytest
import yaml

from nhc.diagnostics import Source, SpecError, render_concise, render_text, to_json
from nhc.language import decode, read
from nhc.language.expressions.unparse import unparse
from nhc.language.schema import schema
from nhc.pipeline import check, emit
from tests.support import python_model

BASE = """nhc: 1
system: cart
about: a cart
coordinates: [x, y]
parameters:
  m: {value: 2, about: mass}
  k: 3
define: {s: x + y}
T: m/2*(x'^2 + y'^2)
V: k/2*s^2
outputs: {sum: s}
scenes:
  go: {initial: {x: 1}, time: [0, 1], need: [sum]}
"""


def put(folder: Path, **texts: str) -> Path:
    for name, text in texts.items():
        (folder / f"{name}.yaml").write_text(text)
    return folder


def messages(path: Path) -> list[tuple[str, str]]:
    with pytest.raises(SpecError) as caught:
        decode(read(path))
    lines = render_concise(caught.value.source, caught.value.diagnostics).splitlines()
    assert render_text(caught.value.source, caught.value.diagnostics)
    return [(Path(line.split(": ")[0]).name, line.split(": ", 2)[2]) for line in lines]


def test_mappings_merge_by_name_and_the_rest_is_replaced(tmp_path: Path) -> None:
    own = "nhc: 1\nextends: base.yaml\nsystem: heavy\nparameters: {k: 5, c: 1, m: {value: 7}}\n"
    own += "forces: {x: -c*x'}\nscenes: {go: {time: [0, 9]}, stay: {time: [0, 2]}}\n"
    spec = decode(read(put(tmp_path, base=BASE, own=own) / "own.yaml"))
    assert spec.system == "heavy"
    assert spec.about == "a cart"
    values = {p.name: (p.value, p.about) for p in spec.parameters}
    assert values == {"m": (Fraction(7), "mass"), "k": (Fraction(5), ""), "c": (Fraction(1), "")}
    go, stay = spec.scenes
    assert (go.time, [need.name for need in go.need]) == ((0, 9), ["sum"])
    assert [need.name for need in stay.need] == ["x", "y"]


def test_the_models_are_what_the_merged_text_says(tmp_path: Path) -> None:
    own = "nhc: 1\nextends: base.yaml\nsystem: cart\nparameters: {k: 5}\n"
    merged = BASE.replace("k: 3", "k: 5")
    put(tmp_path, base=BASE, own=own, cart=merged)

    models = [
        python_model(emit(read(tmp_path / name), "python")["cart.py"], "cart") for name in ("own.yaml", "cart.yaml")
    ]
    ours, theirs = models
    assert ours.DEFAULTS == theirs.DEFAULTS
    y = [0.3, 0.2, -0.1, 0.7]
    assert ours.rhs(0.0, y) == theirs.rhs(0.0, y)
    assert "base.yaml:9:4" in emit(read(tmp_path / "own.yaml"), "python")["cart.py"]


def test_one_potential_replaces_the_other(tmp_path: Path) -> None:
    own = "nhc: 1\nextends: base.yaml\nU: -k*x^2\n"
    spec = decode(read(put(tmp_path, base=BASE, own=own) / "own.yaml"))
    assert spec.potential_kind == "U"


def test_null_leaves_out_what_the_base_has(tmp_path: Path) -> None:
    base = BASE + "  stay: {initial: {x: 2, y: 1}, time: [0, 2]}\nforces: {x: -x'}\n"
    middle = "nhc: 1\nextends: base.yaml\nV: null\nforces: null\n"
    own = "nhc: 1\nextends: middle.yaml\nscenes: {go: ~, stay: {initial: {x: Null}}}\nparameters: {k: null}\n"
    own += "define: {s: x}\noutputs: {sum: null}\n"
    own += "bodies: {wheel: null}\n"  # with the last one goes what they stand in
    base += "bodies: {wheel: {mass: m, at: [x, y]}}\n"
    spec = decode(read(put(tmp_path, base=base, middle=middle, own=own) / "own.yaml"))
    assert spec.potential is None
    assert not spec.forces
    assert not spec.outputs
    assert [p.name for p in spec.parameters] == ["m"]
    (stay,) = spec.scenes
    assert stay.name == "stay"
    assert [start.name for start in stay.initial] == ["y"]
    validator = jsonschema.Draft202012Validator(schema())
    assert all(validator.is_valid(yaml.safe_load(text)) for text in (base, middle, own))
    for text in (base.replace("V: k/2*s^2", "V: null"), base.replace("k: 3", "k: null")):
        assert not validator.is_valid(yaml.safe_load(text))


def test_a_key_that_is_needed_is_missed_where_it_is_left_out(tmp_path: Path) -> None:
    path = put(tmp_path, base=BASE, own="nhc: 1\nextends: base.yaml\nT: ~\n") / "own.yaml"
    assert messages(path) == [("own.yaml:3:1", "missing key `T` in the spec")]
    with pytest.raises(SpecError) as caught:
        decode(read(path))
    assert "it is left out here; give it a value: kinetic energy" in caught.value.diagnostics[0].help[0]


def test_a_name_that_is_needed_is_missed_where_it_is_left_out(tmp_path: Path) -> None:
    path = put(tmp_path, base=BASE, own="nhc: 1\nextends: base.yaml\nparameters: {m: 2, k: ~}\n") / "own.yaml"
    with pytest.raises(SpecError) as caught:
        decode(read(path))
    (found,) = caught.value.diagnostics
    assert found.message == "unknown name `k`" and found.labels[1].text == "left out here"
    assert [*map(caught.value.source.position, (label.span.start for label in found.labels))] == [(10, 4), (3, 20)]


def test_what_no_base_has_cannot_be_left_out(tmp_path: Path) -> None:
    middle = "nhc: 1\nextends: base.yaml\nV: null\n"
    own = "nhc: 1\nextends: middle.yaml\nV: null\nscenes: {go: {initial: {y: ~}}, new: {time: [0, 1], initial: {x: null}}}\n"
    own += "outputs: {sum: }\n"
    found = messages(put(tmp_path, base=BASE, middle=middle, own=own) / "own.yaml")
    missing = [f"no base has `{name}` here, so that it cannot be left out" for name in "Vyx"]
    assert [text for _, text in found] == [*missing, "empty value of `sum`"]
    assert [place for place, _ in found] == ["own.yaml:3:4", "own.yaml:4:28", "own.yaml:4:66", "own.yaml:5:11"]
    other = "nhc: 1\nextends: middle.yaml\nV: null\nU: x^2\nconstraints: [null]\n"  # only what is given is another form
    found = messages(put(tmp_path, other=other) / "other.yaml")
    assert [text for _, text in found] == [
        "no base has `V` here, so that it cannot be left out",
        "empty entry of a list",
    ]
    alone = BASE.replace("k: 3", "k: null").replace("[sum]", "[sum, null]")
    found = messages(put(tmp_path, alone=alone) / "alone.yaml")
    assert [text for _, text in found] == ["empty value of `k`", "empty entry of a list"]


BODIES = """nhc: 1
system: wheel
rotation: {R: {frame: body}, S: {frame: body}}
coordinates: [turns]
parameters: {axis: 1, angle: 2}
bodies:
  disc: {rotation: R, mass: axis, inertia: angle}
  rod: {turns: [z: turns], inertia: 1}
T: S_w1^2 + S_w2^2 + S_w3^2
define: {rotation: turns^2}
scenes:
  go: {initial: {R: {yaw: 0.1, roll: 0.2}, S: {order: zxz, angles: [1, 2, 3]}}, time: [0, 1]}
"""


def test_one_way_to_say_a_thing_replaces_another(tmp_path: Path) -> None:
    """A joint and a start of a rotation have one form each; names that are spelled like their keys are no such forms."""
    own = "nhc: 1\nextends: base.yaml\nparameters: {yaw: 3}\ndefine: {turns2: 2*turns}\n"
    own += "bodies: {disc: {turns: [x: turns, z: 0.3]}, rod: {rotation: R}}\n"
    own += "scenes: {go: {initial: {R: {axis: [0, 0, 1], angle: 0.4}, S: {yaw: 0.5}}}}\n"
    merged = BODIES.replace("axis: 1, angle: 2", "axis: 1, angle: 2, yaw: 3")
    merged = merged.replace("rotation: R, mass", "turns: [x: turns, z: 0.3], mass").replace(
        "turns: [z: turns]", "rotation: R"
    )
    merged = merged.replace("{yaw: 0.1, roll: 0.2}", "{axis: [0, 0, 1], angle: 0.4}")
    merged = merged.replace("{order: zxz, angles: [1, 2, 3]}", "{yaw: 0.5}").replace(
        "turns^2", "turns^2, turns2: 2*turns"
    )
    put(tmp_path, base=BODIES, own=own, merged=merged)
    ours, theirs = (decode(read(tmp_path / name)) for name in ("own.yaml", "merged.yaml"))
    assert [(d.name, unparse(d.value)) for d in ours.definitions] == [
        (d.name, unparse(d.value)) for d in theirs.definitions
    ]
    starts = [[(i.name, unparse(i.value)) for i in spec.scenes[0].initial] for spec in (ours, theirs)]
    assert starts[0] == starts[1]
    assert [p.name for p in ours.parameters] == ["axis", "angle", "yaw"]


def test_what_a_form_lacks_is_the_base_s(tmp_path: Path) -> None:
    own = "nhc: 1\nextends: base.yaml\nscenes: {go: {initial: {R: {roll: 0.7}}}}\n"
    merged = BODIES.replace("roll: 0.2", "roll: 0.7")
    put(tmp_path, base=BODIES, own=own, merged=merged)
    ours, theirs = (decode(read(tmp_path / name)) for name in ("own.yaml", "merged.yaml"))
    starts = [[(i.name, unparse(i.value)) for i in spec.scenes[0].initial] for spec in (ours, theirs)]
    assert starts[0] == starts[1]


def test_two_forms_in_one_file_are_refused_there(tmp_path: Path) -> None:
    own = "nhc: 1\nextends: base.yaml\nbodies: {disc: {turns: [x: turns], rotation: S}}\n"
    ((place, message),) = messages(put(tmp_path, base=BODIES, own=own) / "own.yaml")
    assert place.startswith("own.yaml:3:")
    assert "both `rotation` and `turns`" in message


def test_a_chain_through_a_folder(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    put(tmp_path / "parts", base=BASE, middle="nhc: 1\nextends: base.yaml\nparameters: {k: 4}\nabout: middle\n")
    own = put(tmp_path, own="nhc: 1\nextends: parts/middle.yaml\nparameters: {m: 1}\n") / "own.yaml"
    spec = decode(read(own))
    assert spec.about == "middle"
    assert [p.value for p in spec.parameters] == [1, 4]
    assert check(read(own)).facts


def test_errors_point_into_the_file_that_holds_them(tmp_path: Path) -> None:
    put(
        tmp_path,
        base=BASE.replace("k/2*s^2", "k/2*s^2 + oops"),
        own="nhc: 1\nextends: base.yaml\nparameters: {m: mm}\n",
    )
    found = dict(messages(tmp_path / "own.yaml"))
    assert "`mm`" in found["own.yaml:3:17"]
    assert "`oops`" in found["base.yaml:10:14"]


def test_places_in_two_files(tmp_path: Path) -> None:
    put(tmp_path, base=BASE, own="nhc: 1\nextends: base.yaml\nforces: {x: 1}\nquasi_velocities: {s: x'}\n")
    with pytest.raises(SpecError) as caught:
        decode(read(tmp_path / "own.yaml"))
    text = render_text(caught.value.source, caught.value.diagnostics)
    assert "own.yaml:4:20" in text or "base.yaml:8:10" in text
    assert "base.yaml:8:10" in text and "own.yaml:4:20" in text
    files = {item.get("file", "own") for item in to_json(caught.value.source, caught.value.diagnostics)["diagnostics"]}
    assert len(files) == 1


@pytest.mark.parametrize(
    ("own", "message"),
    [
        ("/etc/passwd", "`/etc/passwd` is not a path from the spec's own folder"),
        ("C:\\base.yaml", "is not a path"),
        ("a/../../base.yaml", "leads out of the spec's own folder"),
        ("base.txt", "is not the name of a .yaml file"),
        ("none.yaml", "there is no file"),
        ("own.yaml", "extends this spec itself"),
    ],
)
def test_bases_that_are_refused(tmp_path: Path, own: str, message: str) -> None:
    put(tmp_path, base=BASE, own=f"nhc: 1\nextends: '{own}'\n")
    ((place, text),) = messages(tmp_path / "own.yaml")
    assert place.startswith("own.yaml:2:")
    assert message in text


def test_a_cycle_of_two_and_a_chain_that_is_too_long(tmp_path: Path) -> None:
    put(tmp_path, a="nhc: 1\nextends: b.yaml\n", b="nhc: 1\nextends: a.yaml\n")
    assert "itself, directly or through others" in messages(tmp_path / "a.yaml")[0][1]
    put(tmp_path, **{f"c{k}": f"nhc: 1\nextends: c{k + 1}.yaml\n" for k in range(12)}, c12=BASE)
    assert "more than 8 specs" in messages(tmp_path / "c0.yaml")[0][1]
    assert "more than 8 specs" in messages(tmp_path / "c4.yaml")[0][1]
    assert decode(read(tmp_path / "c5.yaml")).system == decode(Source("c12.yaml", BASE)).system  # c5 to c12


def test_a_base_that_is_no_yaml_and_a_spec_without_a_folder(tmp_path: Path) -> None:
    put(tmp_path, base="x: [1\n", own="nhc: 1\nextends: base.yaml\n", list="- 1\n", two="nhc: 1\nextends: list.yaml\n")
    assert messages(tmp_path / "own.yaml")[0][0].startswith("base.yaml:")
    assert "is not a spec" in messages(tmp_path / "two.yaml")[0][1]
    with pytest.raises(SpecError, match="this spec has no folder"):
        decode(Source("<stdin>", "nhc: 1\nextends: base.yaml\n"))
    with pytest.raises(SpecError, match="names one file"):
        decode(Source("<stdin>", "nhc: 1\nextends: [a, b]\n"))


def test_names_merge_however_they_are_spelled(tmp_path: Path) -> None:
    base = BASE.replace("k: 3", "θ0: 3").replace("k/2", "theta0/2").replace("{x: 1}", "{x: 1, xdot: 1}")
    own = "nhc: 1\nextends: base.yaml\nparameters: {theta0: 5}\nscenes: {go: {initial: {x': 7}}}\n"
    put(tmp_path, base=base, own=own)
    made = decode(read(tmp_path / "own.yaml"))
    assert {p.name: p.value for p in made.parameters} == {"m": 2, "theta0": 5}
    assert {(e.kind, e.name) for e in made.scenes[0].initial} == {("coordinate", "x"), ("velocity", "x")}
    put(tmp_path, own=own.replace("{theta0: 5}", "{theta0: 5, θ0: 6}"))
    assert "`theta0` is declared twice" in messages(tmp_path / "own.yaml")[0][1]


@pytest.mark.parametrize(
    "own", ["{extends: base.yaml, nhc: 1}", "? extends\n: base.yaml", "  nhc: 1\n  extends: base.yaml"]
)
def test_the_key_stands_wherever_yaml_lets_it(tmp_path: Path, own: str) -> None:
    put(tmp_path, base=BASE, own=own)
    assert decode(read(tmp_path / "own.yaml")).system == decode(read(tmp_path / "base.yaml")).system
