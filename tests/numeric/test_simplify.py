"""Approximate reductions: what goes, what stays, and that the errors said are those that a run finds again."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.language import Source, Spec, decode, read
from nhc.language.parser import parse_expression
from nhc.language.spec import Scene
from nhc.language.syntax import Syntax
from nhc.language.unparse import unparse
from nhc.report.ladder import draw_ladder, reduced_spec
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from nhc.study.simplify.draft import draft_of
from nhc.study.simplify.ladder import Ladder
from nhc.study.simplify.measure import NotMeasured
from nhc.study.simplify.search import simplify
from nhc.study.simplify.zero import list_terms, vanish
from tests.support import COMPILER, GALLERY, spec_path

pytestmark = pytest.mark.skipif(COMPILER is None, reason="no C compiler")
TOLERANCE = 1e-4
SPEC = """\
nhc: 1
system: stiff_pendulum
about: "a pendulum, with a weak drag: and a spring that is stiff far out"
coordinates: {theta: {unit: rad}}
parameters:
  m: {value: 1, unit: kg}
  l: {value: 1, unit: m}
  g: {value: 9.81, unit: m/s^2}
  c: {value: 1e-6, unit: kg*m^2/s}
  k: {value: 3, unit: kg*m^2/s^2}
T: m*l^2/2*theta'^2
U: m*g*l*cos(theta)
forces:
  theta: -c*theta' - k*theta^9   # the second term counts for large angles
scenes:
  small: {initial: {theta: 0.1}, time: [0, 5]}
  large: {initial: {theta: 1.2}, time: [0, 5]}
"""
COUPLED = """\
nhc: 1
system: two
coordinates: [x, y]
parameters: {e: 1e-7, k: 2}
define:
  bond: e*x*y + k*y^2/2
T: x'^2/2 + y'^2/2
V: x^2/2 + bond
scenes:
  one: {initial: {x: 1, y: 0.5}, time: [0, 6]}
"""


@pytest.fixture(autouse=True, scope="module")
def _cache(tmp_path_factory: pytest.TempPathFactory) -> object:
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NHC_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield


def source(text: str = SPEC) -> Source:
    return Source("spec.yaml", text)


def tree_of(text: str) -> Syntax:
    from nhc.diagnostics import Bag, Span

    tree = parse_expression(text, Span, Bag(source("")))
    assert tree is not None
    return tree


def distances(full: str, reduced: str, scene: str) -> dict[str, float]:
    """By runs of other accuracy and another method than those of the search."""
    a, b = (run(open_scene(source(t), scene), Settings("dopri5", 1e-10)) for t in (full, reduced))
    assert a.ended == b.ended == "done" and a.headings == b.headings
    columns = zip(a.headings, zip(*a.rows, strict=True), zip(*b.rows, strict=True), strict=True)
    return {name: max(abs(x - y) for x, y in zip(p, q, strict=True)) / max(abs(x) for x in p) for name, p, q in columns}


def check_last(ladder: Ladder, text: str) -> None:
    """The errors of the last rung again, from the written spec alone."""
    found = distances(text, reduced_spec(ladder), ladder.scene)
    last, own = ladder.rungs[-1], ladder.rungs[0]
    assert max(found.values()) <= ladder.tolerance
    for need, said, noise in zip(ladder.needs, last.errors, own.errors, strict=True):
        assert abs(found[need] - said) <= 3 * noise + 1e-9, need


def test_what_is_negligible_on_the_scene_goes() -> None:
    ladder = simplify(source(), "small", TOLERANCE)
    assert set(ladder.dropped) == {
        "term `-c*theta'` of `forces.theta`",
        "term `-k*theta^9` of `forces.theta`",
    }
    operations = [rung.size.operations for rung in ladder.rungs]
    assert operations == sorted(set(operations), reverse=True)
    assert all(rung.error <= TOLERANCE for rung in ladder.rungs)
    check_last(ladder, SPEC)
    assert ladder.rungs[-1].error > 10 * ladder.rungs[0].error  # the drag is measured, not lost in the noise


def test_the_written_spec_says_what_is_missing_and_where_it_holds() -> None:
    ladder = simplify(source(), "small", TOLERANCE)
    text = reduced_spec(ladder)
    comment = "\n".join(line for line in text.splitlines() if line.startswith("#"))
    for dropped in ladder.dropped:
        assert dropped in comment
    (said,) = re.findall(r"^#   theta: (\S+)$", comment, re.M)
    assert float(said) == pytest.approx(distances(SPEC, text, "small")["theta"], rel=0.1)
    assert "--scene small --tol 0.0001" in comment and "t = 0 to 5" in comment and "k = 3.0" in comment
    (low, high) = re.findall(r"^#   theta: (\S+) to (\S+) rad$", comment, re.M)[0]
    assert -0.1 <= float(low) < -0.0999 and float(high) == 0.1
    spec = decode(source(text))
    assert [scene.name for scene in spec.scenes] == ["small"] and not spec.forces
    assert [p.name for p in spec.parameters] == ["m", "l", "g"]
    assert "approximate" in spec.about and "scene small only" in spec.about
    assert text == reduced_spec(simplify(source(), "small", TOLERANCE))


def test_what_matters_outside_the_scene_only_stays_in_the_other_scene() -> None:
    ladder = simplify(source(), "large", TOLERANCE)
    assert ladder.dropped == ("term `-c*theta'` of `forces.theta`",)
    reasons = {kept.about: kept.reason for kept in ladder.kept}
    assert "without it the error is" in reasons["term `-k*theta^9` of `forces.theta`"]
    check_last(ladder, SPEC)
    small = reduced_spec(simplify(source(), "small", TOLERANCE))
    at_large = small.replace("theta: 0.1}", "theta: 1.2}")
    assert at_large != small
    full = SPEC.replace("theta: 0.1}", "theta: 1.2}")
    assert distances(full, at_large, "small")["theta"] > 100 * TOLERANCE


def test_where_nothing_may_go_nothing_goes() -> None:
    text = spec_path("pendulum").read_text()
    ladder = simplify(source(text), "reference", TOLERANCE)
    assert ladder.dropped == () and len(ladder.rungs) == 1 and ladder.kept
    made = reduced_spec(ladder)
    assert "Nothing could be left out" in made and "approximate:" not in decode(source(made)).about
    assert distances(text, made, "reference") == {"theta": 0.0}


def test_a_term_inside_a_definition_goes() -> None:
    ladder = simplify(source(COUPLED), "one", TOLERANCE)
    assert ladder.dropped == ("term `e*x*y` of `define.bond`",)
    check_last(ladder, COUPLED)
    assert unparse(decode(source(ladder.spec)).definitions[0].value) == "k*y^2/2"


def test_a_parameter_in_several_places_is_set_to_zero() -> None:
    text = COUPLED.replace("k*y^2/2", "k*y^2/2*(1 + sin(e*x))*cos(e*y)")
    ladder = simplify(source(text), "one", TOLERANCE)
    assert not {"e"} & {p.name for p in decode(source(ladder.spec)).parameters}
    check_last(ladder, text)


def test_outputs_and_constraints_are_not_touched() -> None:
    text = COUPLED.replace("scenes:", "outputs: {shown: bond}\nscenes:")
    draft = draft_of(source(text), decode(source(text)).scenes[0])
    abouts = [candidate.about for candidate in draft.candidates()]
    assert "term `bond` of `V`" in abouts and not any("define.bond" in about for about in abouts)
    assert not any(candidate.name for candidate in draft.candidates())  # e and k stand in what is shown
    disk = read(str(spec_path("rolling_disk")))
    locked = draft_of(disk, decode(disk).scenes[0]).locked
    assert {"R", "omega_n", "omega_u", "z"} <= locked and not {"m", "g", "A", "C"} & locked


def test_the_bound_on_runs_is_said() -> None:
    ladder = simplify(source(), "small", TOLERANCE, most=2)
    assert ladder.bounded and ladder.runs == 2
    assert "bound of 2 runs" in reduced_spec(ladder)
    assert any("not measured" in kept.reason for kept in ladder.kept)
    assert max(distances(SPEC, reduced_spec(ladder), "small").values()) <= TOLERANCE


def test_a_chaotic_scene_is_no_reference() -> None:
    text = spec_path("double_pendulum").read_text().replace("time: [0, 5]", "time: [0, 60]")
    with pytest.raises(NotMeasured, match="own runs differ"):
        simplify(source(text), "reference", TOLERANCE)


@pytest.mark.parametrize("name", GALLERY)
def test_a_spec_with_nothing_left_out_reads_back_the_same(name: str) -> None:
    original = read(str(spec_path(name)))
    spec = decode(original)
    for scene in spec.scenes:
        again = decode(source(draft_of(original, scene).without([])))
        assert content(again, scene) == content(spec, scene)


def content(spec: Spec, scene: Scene) -> list[object]:
    """All of a spec but places and other scenes."""
    own = next(s for s in spec.scenes if s.name == scene.name)
    pairs = [(e.name, unparse(e.left), unparse(e.right)) for e in spec.constraints]
    pairs += [(e.name, unparse(e.left), unparse(e.right)) for e in spec.holonomic]
    named = (*spec.definitions, *spec.forces, *spec.quasi_velocities, *spec.outputs)
    trees = [spec.kinetic, *([] if spec.potential is None else [spec.potential])]
    return [
        (spec.system, spec.about, spec.sources, spec.formulation, spec.dependent, spec.potential_kind),
        [(c.name, c.unit, c.about, c.range) for c in spec.coordinates],
        [(p.name, str_of(p.value), p.unit, p.about) for p in spec.parameters],
        [(o.name, str_of(o.value)) for o in own.parameters],
        [unparse(tree) for tree in trees],
        [(d.name, unparse(d.value)) for d in named],
        [(i.kind, i.name, unparse(i.value)) for i in own.initial],
        pairs,
        [(f.kind, f.name, f.trace, [unparse(tree) for tree in f.expressions]) for f in spec.draw],
        (own.name, own.about, own.time, own.tolerance, [(n.kind, n.name) for n in own.need]),
    ]


def str_of(value: object) -> str:
    return unparse(value) if isinstance(value, Syntax) else str(value)


@pytest.mark.parametrize(
    ("text", "terms"),
    [
        ("a - b*c", ["a", "-b*c"]),
        ("-(a - b)", ["-a", "b"]),
        ("m/2*(x'^2 + y'^2)", ["m/2*(x'^2 + y'^2)", "x'^2", "y'^2"]),
        ("(a + b)^2/(c + d)", ["(a + b)^2/(c + d)"]),
        ("0", []),
    ],
)
def test_terms(text: str, terms: list[str]) -> None:
    found = [f"{'-' if minus else ''}{unparse(node)}" for node, minus in list_terms(tree_of(text), True)]
    assert found == terms


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("a + e", "a"),
        ("e - a", "-a"),
        ("a*(b + e*c)", "a*b"),
        ("a^e + sin(e) + e'", "1"),
        ("a/e", "a/0"),
        ("e/a - b", "-b"),
        ("cos(e*a)*b", "1*b"),
        ("0*a + b", "0*a + b"),
    ],
)
def test_what_vanishes(text: str, left: str) -> None:
    made = vanish(tree_of(text), lambda node: getattr(node, "name", "") == "e")
    assert unparse(made) == left


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, out, chart = tmp_path / "stiff.yaml", tmp_path / "reduced.yaml", tmp_path / "ladder.svg"
    path.write_text(SPEC)
    asked = ["reduce", str(path), "--scene", "small", "--tol", "1e-4"]
    assert main([*asked, "-o", str(out), "--chart", str(chart)]) == 0
    table = capsys.readouterr().out
    assert "nothing: the full model" in table and "term `-k*theta^9` of `forces.theta`" in table
    assert chart.read_text().startswith("<svg") and chart.read_text() == draw_ladder(simplify(source(), "small", 1e-4))
    assert main(["check", str(out)]) == 0
    capsys.readouterr()
    assert main([*asked, "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["schema"] == "nhc.ladder/1" and data["spec"] == out.read_text()
    assert [rung["operations"] for rung in data["ladder"]] == sorted(
        (rung["operations"] for rung in data["ladder"]), reverse=True
    )
    assert main([*asked, "-o", str(out)]) == 0  # the same text
    out.write_text("mine")
    assert main([*asked, "-o", str(out)]) == 1
    assert out.read_text() == "mine"


@pytest.mark.parametrize(
    "more",
    [
        ["-o", "x.yaml"],
        ["--chart", "x.svg"],
        ["--tol", "2"],
        ["--tol", "1e-4", "--fold"],
        ["--tol", "1e-4", "--chart", "x"],
    ],
)
def test_options_that_do_not_go_together(more: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reduce", "pendulum", "--scene", "small", *more]) == 2


def test_nothing_is_approximated_by_default(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["reduce", "pendulum", "--scene", "small"]) == 0
    assert "tried (cost" in capsys.readouterr().out
