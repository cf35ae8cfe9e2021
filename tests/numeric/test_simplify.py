"""Approximate reductions: what goes, what stays, and that the errors said are those that a run finds again."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest

from nhc.cli.entry import main
from nhc.language import Source, Spec, decode, read
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Syntax
from nhc.language.expressions.unparse import unparse
from nhc.language.spec import Scene
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.report.ladder import print_ladder, reduced_spec
from nhc.report.ladder_picture import draw_ladder, make_ladder_page
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from nhc.simulate.task import TOO_MANY, News, Outcome, Task
from nhc.study.simplify import measure
from nhc.study.simplify.candidate import Candidate
from nhc.study.simplify.draft import Draft, draft_of
from nhc.study.simplify.elimination import Bounded, Search, Trial
from nhc.study.simplify.ladder import NOTHING_SAVED, Kept, Ladder, Size
from nhc.study.simplify.measure import Meter, NotMeasured, meter_of
from nhc.study.simplify.search import _rungs, simplify
from nhc.study.simplify.text import NoLimit, write_draft
from nhc.study.simplify.zero import INFINITE, ZERO, is_infinite, list_terms, replace_parts
from tests.support import GALLERY, spec_path

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


def test_what_is_asked_is_not_touched_though_the_model_may_lose_it() -> None:
    """A definition that an output shows keeps its terms there; the model uses a copy without them."""
    text = COUPLED.replace("scenes:", "outputs: {shown: bond}\nscenes:")
    ladder = simplify(source(text), "one", TOLERANCE)
    assert ladder.dropped == ("term `e*x*y` of `define.bond`",)
    spec = decode(source(ladder.spec))
    named = {d.name: unparse(d.value) for d in spec.definitions}
    assert named == {"bond": "e*x*y + k*y^2/2", "bond_model": "k*y^2/2"}
    assert unparse(spec.outputs[0].value) == "bond" and spec.potential is not None
    assert unparse(spec.potential) == "x^2/2 + bond_model"
    check_last(ladder, text)


def test_a_copy_reaches_through_the_definitions_between() -> None:
    text = COUPLED.replace("bond: e*x*y + k*y^2/2", "bond: e*x*y + k*y^2/2\n  twice: 2*bond").replace(
        "+ bond", "+ twice/2"
    )
    text = text.replace("scenes:", "outputs: {shown: twice}\nscenes:")
    draft = draft_of(source(text), decode(source(text)).scenes[0])
    (gone,) = [c for c in candidates_of(text) if c.about == "term `e*x*y` of `define.bond`"]
    again = next(c for c in draft.candidates(start_of_text(text)) if c.about == gone.about)
    spec = decode(source(write_draft(draft, draft.change([again]))))
    assert {d.name: unparse(d.value) for d in spec.definitions} == {
        "bond": "e*x*y + k*y^2/2",
        "bond_model": "k*y^2/2",
        "twice": "2*bond",
        "twice_model": "2*bond_model",
    }


def start_of_text(text: str) -> Start:
    spec = decode(source(text))
    return start_of(resolve(spec), spec.scenes[0])


def candidates_of(text: str) -> list[Candidate]:
    return draft_of(source(text), decode(source(text)).scenes[0]).candidates(start_of_text(text))


RAIL = """\
nhc: 1
system: rail
coordinates: {x: {unit: m}, y: {unit: m}, e: {unit: m}}
parameters:
  k: {value: 1e5, unit: N/m, about: of the support}
  m: {value: 1, unit: kg}
  s: {value: 1e6, unit: m, about: radius of the bend}
  g: {value: 9.81, unit: m/s^2}
T: m/2*(x'^2 + y'^2 + e'^2)
V: m*g*x/10 + k/2*(e - 0*x)^2 + m*g*y^2/s
constraints:
  - y' - (1 + x/s)*x' - e' = 0
scenes:
  down: {initial: {"x'": 1, "y'": 1}, time: [0, 2], need: [x, y]}
"""


@pytest.mark.slow
def test_a_stiff_support_and_a_large_radius_go() -> None:
    ladder = simplify(source(RAIL), "down", TOLERANCE)
    first, last = ladder.rungs[0].size, ladder.rungs[-1].size
    assert (first.states, last.states) == (5, 2) and last.calls < 0.05 * first.calls
    spec = decode(source(ladder.spec))
    assert "s" not in {p.name for p in spec.parameters}
    assert unparse(spec.constraints[0].left) == "y' - x'" or unparse(spec.constraints[0].left) == "y' - 1*x'"
    check_last(ladder, RAIL)


@pytest.mark.slow
def test_stiff_tyres_become_rigid_wheels() -> None:
    """The limit of its tyres is the ladder's next vehicle: the same motion, though neither tyre alone may go."""
    tyres = read(str(spec_path("ladder/relaxing_tyres")))
    ladder = simplify(tyres, "lane_change", 0.05)
    assert ladder.dropped == ("coordinates `e_f`, `e_r`, held where they start (stiff)",)
    rigid = run(open_scene(read(str(spec_path("ladder/rigid_bicycle"))), "lane_change"), Settings(tolerance=1e-9))
    found = run(open_scene(source(ladder.spec), "lane_change"), Settings(tolerance=1e-9))
    for a, b in zip(rigid.rows, found.rows, strict=True):
        assert a == pytest.approx(b, abs=1e-7)


TORUS = """nhc: 1
system: torus
coordinates: [x, y, phi, theta, psi]
parameters: {m: 3, R: 0.3, r: 0.05, A: 0.14, C: 0.27, g: 9.81}
bodies:
  yawed: {at: [x, y, R*cos(theta) + r], turns: [z: phi]}
  tilted: {parent: yawed, turns: [x: theta]}
  tyre: {parent: tilted, turns: [y: psi], mass: m, inertia: [A, C, A]}
points:
  contact: {parent: yawed, of: tyre, at: [0, R*sin(theta), -R*cos(theta) - r]}
gravity: [0, 0, -g]
constraints:
  - long: contact_v1 = 0
  - lat: contact_v2 = 0
scenes:
  roll: {initial: {theta: 0.2, psi': 6, phi': 0.1}, time: [0, 5], need: [theta]}
"""
"""long is cos(phi) vx + sin(phi) vy = 0; either term with lat allows the same velocities but where the other one is all of it."""


@pytest.mark.parametrize(
    ("term", "why"),
    [
        ("yawed_x1*contact_vx", "the run without it ends at t = 0: .* the coframe is singular"),
        ("yawed_y1*contact_vy", "the constraints lose their rank at t = 2.575"),
    ],
)
def test_what_takes_the_rank_of_constraints_on_the_way_stays(term: str, why: str) -> None:
    """The model's own run passes a place on its way unseen, since it goes by the velocities that are left: its error is 2e-8."""
    origin = source(TORUS)
    draft = draft_of(origin, decode(origin).scenes[0])
    meter = meter_of(origin, "roll", "", 1e-3)
    (candidate,) = (c for c in draft.candidates(meter.job.start) if c.about == f"term `{term}` of `define.contact_v1`")
    text = write_draft(draft, draft.change([candidate]), "")
    with pytest.raises(measure.Refused, match=f"{why}$"):
        meter.measure(text)
    if "lose their rank" in why:
        assert max(replace(meter, way=replace(meter.way, weakest=0.0)).measure(text)[0]) < 1e-6


def test_a_term_of_a_constraint_goes_and_its_only_one_does_not() -> None:
    abouts = [c.about for c in candidates_of(RAIL)]
    assert "term `x/s` of `constraints.c1`" in abouts and "parameter `s`, made infinite" in abouts
    assert "parameter `k`, made infinite" not in abouts and "parameter `s`, set to 0" in abouts
    assert not any(" of `constraints.c1`" in about and about.startswith("term `0`") for about in abouts)
    sleigh = spec_path("chaplygin_sleigh").read_text().replace("-sin(theta)*x' + cos(theta)*y' = 0", "w = 0")
    sleigh = sleigh.replace("define:", "define:\n  w: -sin(theta)*x' + cos(theta)*y'").replace(
        "  w: theta'", "  turn: theta'"
    )
    sleigh = (
        sleigh.replace("w: 1.3", "turn: 1.3").replace("w: 0.5", "turn: 0.5").replace("need: [v, w]", "need: [v, turn]")
    )
    assert not any("of `constraints" in c.about for c in candidates_of(sleigh))


def test_a_coordinate_that_starts_elsewhere_is_held_there_by_a_parameter_with_its_unit() -> None:
    text = RAIL.replace("initial: {", 'initial: {e: 0.25, "e\'": 0.5, ').replace('"y\'": 1}', '"y\'": 1.5}')
    draft = draft_of(source(text), decode(source(text)).scenes[0])
    found = {c.kind: c for c in draft.candidates(start_of_text(text)) if c.takes_coordinate}
    held = decode(source(write_draft(draft, draft.change([found["held"]]))))
    assert [(p.name, str_of(p.value), p.unit) for p in held.parameters][-1] == ("e_0", "1/4", "m")
    assert unparse(held.potential) == "m*g*x/10 + k/2*(e_0 - 0*x)^2 + m*g*y^2/s" if held.potential else False
    driven = decode(source(write_draft(draft, draft.change([found["driven"]]))))
    assert [(p.name, p.unit) for p in driven.parameters][-2:] == [("e_0", "m"), ("e_rate", "(m)/s")]
    assert unparse(driven.constraints[0].left) == "y' - (1 + x/s)*x' - e_rate"
    assert not {i.name for i in driven.scenes[0].initial} & {"e"}


TWO_SPRINGS = """\
nhc: 1
system: balance
coordinates: [x, a, b]
T: x'^2/2 + (a'^2 + b'^2)/2000
V: x^2/2 + 1e5*a^2 + 1e5*b^2 + (a - b)*x*200
scenes:
  swing: {initial: {x: 1, a: -1e-3, b: 1e-3}, time: [0, 2], need: [x]}
"""


@pytest.mark.slow
def test_coordinates_that_only_together_may_go_are_tried_together() -> None:
    text = TWO_SPRINGS
    ladder = simplify(source(text), "swing", 0.3)
    assert ladder.dropped == ("coordinates `a`, `b`, held where they start (stiff)",)
    assert [c.name for c in decode(source(ladder.spec)).coordinates] == ["x"]
    said = ladder.rungs[-1].errors[0]
    assert distances(text, reduced_spec(ladder), "swing")["x"] == pytest.approx(said, rel=1e-3)


def test_an_exchange_is_tried_when_what_goes_first_bars_more() -> None:
    """`p` and `q` spoil each other; the better by itself bars two that save more together."""

    class Fake(Search):
        def text(self, gone: Sequence[Candidate]) -> str:
            return "+".join(sorted(c.about for c in gone))

        def trial(self, gone: Sequence[Candidate]) -> Trial | str:
            self.runs += 1
            names = {c.about for c in gone}
            error = {"p": 1e-6, "q": 1e-5, "r": 1e-5}
            total = sum(error[n] for n in names) + (1.0 if "p" in names and len(names) > 1 else 0.0)
            return Trial((total,), Size(1, 100 - sum({"p": 12, "q": 10, "r": 10}[n] for n in names), 1))

    meter = cast(Meter, SimpleNamespace(own=(1e-9,), tolerance=1e-4, size=Size(1, 100, 1)))
    draft = cast(Draft, SimpleNamespace(change=lambda gone: gone))
    search = Fake(draft, meter, 99, None)
    candidates = [Candidate(name) for name in "pqr"]
    for candidate in candidates:
        trial = search.trial([candidate])
        assert isinstance(trial, Trial)
        search.alone[candidate] = trial
    search.gone = search._drop([], candidates)
    assert [c.about for c in search.gone] == ["p"]
    search._exchange()
    assert {c.about for c in search.gone} == {"q", "r"} and search.turned_back == 1
    assert search.reasons[candidates[0]].startswith("put back")


@pytest.mark.parametrize("most", [20, 99])
def test_an_exchange_that_uses_up_the_runs_leaves_a_ladder(most: int) -> None:
    """`b` goes early and is put back for `e` and `f`; what is left without it was never measured by itself, or is no model."""
    save = {"a": 10, "b": 12, "c": 10, "d": 10, "e": 11, "f": 11}
    error = {"a": 1e-6, "b": 2e-6, "c": 3e-6, "d": 4e-6, "e": 2e-5, "f": 2e-5}

    class Fake(Search):
        def text(self, gone: Sequence[Candidate]) -> str:
            return "+".join(sorted(c.about for c in gone))

        def _measure(self, text: str) -> Trial | str:
            names = set(text.split("+")) - {""}
            if names == {"a", "d"}:
                return "it stops"
            total = sum(error[n] for n in names) + ("b" in names and bool(names & {"e", "f"}))
            return Trial((total,), Size(1, 1000 - sum(save[n] for n in names), 1))

    meter = SimpleNamespace(own=(1e-9,), tolerance=1e-3, size=Size(1, 1000, 1), price=lambda text: text)
    search = Fake(cast(Draft, SimpleNamespace(change=lambda gone: gone)), cast(Meter, meter), most, None)
    search.known[""] = search.full
    candidates = [Candidate(name) for name in "abcdef"]
    for candidate in candidates:
        trial = search.trial([candidate])
        assert isinstance(trial, Trial)
        search.alone[candidate] = trial
    search.gone = search._drop([], candidates)
    with suppress(Bounded):
        search._exchange()
    assert "".join(c.about for c in search.gone) == "adcfe"
    assert [rung.dropped for rung in _rungs(search, search.gone)] == ["", "a", "d and c", "f", "e"]


def test_a_smallest_model_that_needs_more_steps_is_said_to_take_longer() -> None:
    """Operations are what is made fewer; whether a run is shorter is another question."""
    ladder = simplify(source(), "small", TOLERANCE)
    assert "quickest" not in print_ladder(ladder)
    last = ladder.rungs[-1]
    many = replace(last, size=replace(last.size, calls=100 * last.size.calls))
    text = print_ladder(replace(ladder, rungs=(*ladder.rungs[:-1], many)))
    fewer = ladder.rungs[1].size.calls
    assert f"its run takes {many.size.calls} right-hand sides, that of number 1 only {fewer}" in text


def test_the_ladder_has_prices_and_a_second_measurement() -> None:
    ladder = simplify(source(), "small", TOLERANCE)
    assert all(0 < rung.price.rhs < rung.price.run < 1 for rung in ladder.rungs)
    assert ladder.confirmed == "dopri5 at tolerance 1e-08"
    assert ladder.again[0] == pytest.approx(ladder.rungs[-1].errors[0], rel=0.05, abs=1e-7)
    text = draw_ladder(ladder)
    root = ET.fromstring(text)
    assert [e.get("data-k") for e in root.iter() if e.get("class") == "point"] == ["0", "1", "2"] * 2
    words = " ".join(e.text or "" for e in root.iter())
    assert "tolerance" in words and "term `-k*theta^9` of `forces.theta`" in words and "machine:" in words
    numbers = [e for e in root.iter() if e.text in ("0", "1", "2") and e.get("font-weight") == "bold"]
    assert len(numbers) >= 4 and all(
        float(e.get("y", "0")) > 66 for e in numbers
    )  # inside the plots, below their titles
    last = ladder.rungs[-1]
    root = ET.fromstring(draw_ladder(replace(ladder, tolerance=1.2 * last.error)))
    (limit, *_) = [float(e.get("x1") or 0) for e in root.iter() if e.get("stroke-dasharray")]
    (place, *_) = [float(e.get("x") or 0) for e in root.iter() if e.text == "2" and e.get("font-weight")]
    assert limit - 40 < place < limit - 6  # not on the dashed line
    page = make_ladder_page(ladder)
    assert (
        "<code>-k*theta^9</code>" in page
        and "`" not in page.split("<svg")[0] + page.split("</svg>")[1].split("<pre>")[0]
    )
    assert "What stays, and why" in page and 'src="' not in page and "Left out, with the error after it" in page


def test_a_stiff_scene_is_measured_by_a_method_for_it() -> None:
    text = SPEC.replace("c: {value: 1e-6", "c: {value: 1e4").replace("k: {value: 3,", "k: {value: 1e-9,")
    meter = meter_of(source(text), "small", "", 1e-3)
    assert meter.method == "radau5" and meter.second.method == "radau5" and meter.second.tolerance < 1e-7


DAMPED = """\
nhc: 1
system: damped
coordinates: [x, y]
parameters: {k: 1, K: 1e6, c: 1e5}
T: (x'^2 + y'^2)/2
V: k*x^2/2 + K*(y - x)^2/2
forces: {x: "c*(y' - x')", y: "-c*(y' - x')"}
scenes: {slow: {initial: {x: 1, y: 1}, time: [0, 10]}}
"""


@pytest.mark.slow
def test_what_is_not_confirmed_bars_nothing() -> None:
    """Without the damper, coarse steps of radau5 damp what finer ones do not; it goes first, and stays at last.

    The spring beside it may go while the damper is there: exp(A t) with K = 0 is 1.16e-5 away.
    """
    ladder = simplify(source(DAMPED), "slow", 1e-2)
    reasons = {kept.about: kept.reason for kept in ladder.kept}
    assert reasons["parameter `c`, set to 0"].startswith("not confirmed")
    assert ladder.dropped == ("term `K*(y - x)^2/2` of `V`",)
    assert ladder.dropped[0] not in reasons
    assert max(ladder.again) == pytest.approx(1.165e-5, rel=0.02)


RUBBING = """\
nhc: 1
system: rubbing
coordinates: [x]
parameters: {k: 2, mu: 0.3, e: 1e-6}
T: x'^2/2
V: k/2*x^2 + e*x^4
forces: {x: -mu*9.81*sign(x')}
scenes:
  slides: {initial: {x: 3, x': 1}, time: [0, 1]}
"""


def test_models_that_stick_and_long_scenes_are_not_interpreted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without its spring the block comes to rest, and is held there; where the steps of a run shrink, Python would take minutes."""
    whole, taken = InterpretedModel.integrate, []

    def integrate(model: InterpretedModel, task: Task, method: str, news: News) -> Outcome:
        found = whole(model, task, method, news)
        taken.append(found.steps + found.rejected)
        return found

    monkeypatch.setattr(InterpretedModel, "integrate", integrate)
    ladder = simplify(source(RUBBING), "slides", TOLERANCE)
    assert ladder.dropped == ("term `e*x^4` of `V`",)
    assert [kept.reason for kept in ladder.kept] == ["without it the error is 0.4", "without it the error is 0.26"]
    assert 0 < max(taken) < 1000
    taken.clear()
    ladder = simplify(source(RUBBING.replace("sign(x')", "tanh(x'/1e-12)")), "slides", TOLERANCE)
    assert any("takes more than" in kept.reason for kept in ladder.kept)
    assert 0 < max(taken) < 1000
    taken.clear()
    long = COUPLED.replace("time: [0, 6]", "time: [0, 3000]")
    monkeypatch.setattr(measure, "PATIENCE", 1e-6)  # whatever machine this is
    assert meter_of(source(long), "one", "", 1e-2).quick == 0
    assert 0 < max(taken) < 1000


HARD = """\
nhc: 1
system: hard
coordinates: [x, y, th]
parameters: {m: 1, I: 0.3, b: 1e-7}
T: m/2*(x'^2 + y'^2) + I/2*th'^2 + b*th'*x'
constraints: [{slip: "-sin(th)*x' + cos(th)*y' + b*th' = 0"}]
quasi_velocities: {v: "cos(th)*x' + sin(th)*y'", w: "th'"}
scenes: {go: {initial: {th: 0.1, v: 1, w: 0.5}, time: [0, 4], need: [x, y]}}
"""


def test_inertia_that_nothing_moves_any_more_goes_too() -> None:
    """Behind two held tyres the wheels' constraints say how the vehicle turns: its moment of inertia is no part of the model
    without which there is none, and at this tolerance it is not missed.
    """
    ladder = simplify(read(str(spec_path("ladder/relaxing_tyres"))), "lane_change", 0.06)
    assert ladder.dropped[1:] == ("term `J/2*psi'^2` of `T`",)
    assert "psi'^2" not in ladder.spec and max(ladder.again) < 0.06


SHAKEN = """\
nhc: 1
system: shaken
coordinates: [x, u, w]
parameters: {m: 5, k: 3000, n: 0.05, K: 5000, F: 0.3}
define: {X: x + w, Y: 3*w}
T: m/2*x'^2 + 1e-3*(x' + u')^2 + n/2*(X'^2 + Y'^2)
V: k/2*u^2 + K/2*w^2
forces: {x: F*sin(t)}
scenes: {go: {initial: {x': 2}, time: [0, 3], need: [x]}}
"""


def test_what_went_with_something_else_is_neither_kept_nor_named_again() -> None:
    ladder = simplify(source(SHAKEN), "go", 0.02)
    kept = " ".join(kept.about for kept in ladder.kept)
    assert "K/2*w^2" not in kept and "3*w" not in kept and "k/2*u^2" not in kept
    names = " ".join(ladder.dropped)
    assert names.count("`w`") == 1 and names.count("`u`") == 1


@pytest.mark.parametrize("idle", [1, 5])
def test_a_long_list_of_what_nothing_is_saved_without_is_counted(idle: int) -> None:
    ladder = simplify(source(SHAKEN), "go", 0.02)
    some = tuple(Kept(f"term `{k}`", f"{NOTHING_SAVED} (error 0)") for k in range(idle))
    text = print_ladder(replace(ladder, kept=(*some, Kept("term `x'^2` of `T`", "without it the error is 3"))))
    assert text.count("nothing is saved") == 1
    assert ("5 more: nothing is saved without any of them" in text) == (idle == 5)
    assert text.index("without it the error is 3") < text.index("nothing is saved")


@pytest.mark.slow
def test_models_that_take_very_many_steps_are_given_up() -> None:
    """Without its moment of inertia a body has almost no mass in its turn: the steps of a run become a billion times shorter."""
    ladder = simplify(source(HARD), "go", 1e-8)  # at which what is left of its inertia stays
    reasons = {kept.about: kept.reason for kept in ladder.kept}
    assert reasons["term `I/2*th'^2` of `T`"].startswith("the run without it takes more than 5")


@pytest.mark.parametrize("method", ["auto", "dop853", "rk4"])
def test_a_run_may_be_bounded(method: str) -> None:
    """Also where it is looked at after some hundred steps, whether it is stiff."""
    job = open_scene(source(SPEC.replace("time: [0, 5]", "time: [0, 5000]")), "large")
    found = run(job, Settings(method, 1e-9, 0.01 if method == "rk4" else 0.0, most=3000))
    assert found.outcome.kind == TOO_MANY and found.ended == "failed"
    assert (
        run(job, Settings(method, 1e-9, 0.01 if method == "rk4" else 0.0, most=2999)).outcome.t < found.outcome.t < 500
    )


def test_runs_that_the_dropping_does_not_use_go_to_more_candidates() -> None:
    """Two thirds of six runs measure four of five terms, none of which can go; the fifth can."""
    text = (
        "nhc: 1\nsystem: well\ncoordinates: [x]\nT: x'^2/2\nV: 50*x^2 + 30*x^4 + 20*x^6 + 10*x^8 + 0.000001*x^10\n"
        "scenes:\n  go: {initial: {x: 1}, time: [0, 2]}\n"
    )
    ladder = simplify(Source("well.yaml", text), "go", 1e-3, most=6)
    assert [rung.dropped for rung in ladder.rungs[1:]] == ["term `0.000001*x^10` of `V`"]
    assert not ladder.bounded


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
        draft = draft_of(original, scene)
        again = decode(source(write_draft(draft, draft.change([]))))
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
        ("(a + b)^2/(c + d)", ["(a + b)^2/(c + d)", "a", "b", "c", "d"]),
        ("sin(a - b*c)", ["sin(a - b*c)", "a", "-b*c"]),
        ("0", []),
    ],
)
def test_terms_are_told_apart_through_brackets_and_signs(text: str, terms: list[str]) -> None:
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
    made = replace_parts(tree_of(text), lambda node: ZERO if getattr(node, "name", "") == "e" else None)
    assert unparse(made) == left


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("a/e + b", "b"),
        ("a*e", ""),
        ("e^(-2) + b", "b"),
        ("1/(a + e)", "0"),
        ("sin(e)", ""),
        ("e/(e + 1)", ""),
        ("a - b/e'", "a"),
    ],
)
def test_what_is_left_of_an_expression_at_infinity(text: str, left: str) -> None:
    made = replace_parts(tree_of(text), lambda node: INFINITE if getattr(node, "name", "") == "e" else None)
    assert is_infinite(made) if not left else unparse(made) == left


def test_the_command_tells_its_steps_and_writes_spec_and_chart(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, out, chart = tmp_path / "stiff.yaml", tmp_path / "reduced.yaml", tmp_path / "ladder.svg"
    path.write_text(SPEC)
    asked = ["reduce", str(path), "--scene", "small", "--tol", "1e-4"]
    assert main([*asked, "-o", str(out), "--chart", str(chart)]) == 0
    table = capsys.readouterr().out
    assert "nothing: the full model" in table and "term `-k*theta^9` of `forces.theta`" in table
    assert chart.read_text().startswith("<svg") and "held where" not in chart.read_text()
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


def test_no_range_ends_with_minus_zero() -> None:
    """y' = -2 x' begins with -0.0 and is negative from there."""
    text = COUPLED.replace("{x: 1, y: 0.5}, time: [0, 6]", "{x: -1}, time: [0, 1]").replace("e*x*y + ", "")
    text = text.replace("scenes:", "constraints: [y' + 2*x' = 0]\ndependent: [y]\nformulation: voronec\nscenes:")
    meter = meter_of(source(text), "one", "", TOLERANCE)
    largest = {name: high for name, _, high, _ in meter.way.ranges(decode(source(text)))}
    assert str(largest["y'"]) == "0.0"


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", ["bodies/car_trailer", "chaplygin_ball_quaternion", "heavy_top_quaternion"])
def test_every_candidate_leaves_a_spec_that_can_be_read(name: str) -> None:
    """Also where definitions are nhc's own, of bodies and rotations, and where only names of forces use them."""
    origin = read(str(spec_path(name)))
    scene = decode(origin).scenes[0]
    draft = draft_of(origin, scene)
    candidates = draft.candidates(open_scene(origin, scene.name).start)
    assert len(candidates) > 10 and not any("define.R_" in candidate.about for candidate in candidates)
    for candidate in candidates:
        with suppress(NoLimit):
            decode(Source("less.yaml", write_draft(draft, draft.change([candidate]))))
