"""Models against a finer one: the vehicles' ladder, models with a known error, and what cannot be compared."""

from __future__ import annotations

import json
import math
import xml.etree.ElementTree as ET
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.diagnostics import SpecError
from nhc.language import Source, decode, read
from nhc.report.comparison import draw_comparison
from nhc.report.comparison_page import make_comparison_file
from nhc.report.comparison_text import advise_models, observations, to_markdown
from nhc.resources import find_specs
from nhc.simulate.changes import Changes
from nhc.study.chart.comparable import check_comparable
from nhc.study.chart.fidelity import Comparison, compare_models, name_models
from nhc.study.chart.grid import Grid

LADDER = ("point_mass", "rigid_bicycle", "relaxing_tyres")
# an oscillator, and the same with a force that it is held against: their distance is known in closed form
OSCILLATOR = """
nhc: 1
system: NAME
coordinates: {x: {}}
T: x'^2/2
V: x^2/2 - FORCE*x
outputs: {pull: x - FORCE}
scenes:
  swing: {initial: {x: 1}, time: [0, 3], need: [x]}
"""


def vehicle(name: str) -> Source:
    return read(str(find_specs() / "ladder" / f"{name}.yaml"))


def oscillator(name: str, force: str) -> Source:
    return Source(f"{name}.yaml", OSCILLATOR.replace("NAME", name).replace("FORCE", force))


@cache
def ladder(scene: str) -> Comparison:
    sources = [vehicle(name) for name in LADDER]
    return compare_models(sources[:2], sources[2], Grid(scene=scene, tolerances=(1e-3, 1e-6, 1e-9), budget=1e-4))


@pytest.mark.slow
def test_the_finer_vehicle_is_nearer_where_its_tyres_hardly_yield() -> None:
    made = ladder("lane_change")
    assert [rung.name for rung in made.rungs] == list(LADDER) and made.finest == "relaxing_tyres"
    point, rigid, tyres = made.rungs
    assert 0.06 < point.error < 0.12 and 0.03 < rigid.error < 0.06 and tyres.error < 1e-8
    assert max(point.own, rigid.own, tyres.own) < 1e-5 and made.reference.error < 1e-12
    assert (point.states, rigid.states, tyres.states) == (3, 4, 8) and dict(point.left).keys() == {"v"}
    assert not observations(made)


def test_a_model_that_is_no_better_than_a_cheaper_one_is_named() -> None:
    (text,) = observations(ladder("quick_change"))
    assert text.startswith("on this scene rigid_bicycle is not worth its price: point_mass")


def test_two_models_that_are_the_same_are_worth_the_same() -> None:
    """Only the errors of their runs differ: neither is better for that.  A longer one that is no nearer is not worth its price."""
    turned = oscillator("turned", "0")
    turned = Source(turned.path, turned.text.replace("V: x^2/2", "V: (x + 1)^2/2 - x - 1/2"))
    made = compare_models(
        [oscillator("free", "0"), turned], oscillator("held", "0"), Grid(tolerances=(1e-6, 1e-9), budget=1e-4)
    )
    assert max(rung.error for rung in made.rungs) < 1e-6 and not observations(made)
    stiff = oscillator("longer", "0")
    stiff = Source(stiff.path, stiff.text.replace("V: x^2/2", "V: x^2/2 + 1e-30*x^6"))
    (text,) = observations(
        compare_models(
            [oscillator("free", "0"), stiff], oscillator("held", "0.01"), Grid(tolerances=(1e-6, 1e-9), budget=1e-4)
        )
    )
    assert text.startswith("on this scene longer is not worth its price:") and "operations in 2 equations" in text


def test_the_error_falls_with_the_tolerance_down_to_the_models_own() -> None:
    made = ladder("lane_change")
    for rung in made.rungs:
        errors = [r.error for r in made.results if r.case.formulation == rung.name]
        assert len(errors) == 3 and errors[-1] == pytest.approx(rung.error, rel=1e-6)
    tyres = [r.error for r in made.results if r.case.formulation == "relaxing_tyres"]
    assert tyres[0] > 30 * tyres[1] > 900 * tyres[2]


def test_advice_takes_the_cheapest_model_that_reaches_the_accuracy() -> None:
    for target, best, text in advise_models(ladder("lane_change")):
        assert best is not None and best.error <= target
        if target < 0.04:
            assert best.case.formulation == "relaxing_tyres" and "point_mass is 9.1e-02 away" in text
        else:
            assert best.case.formulation != "relaxing_tyres"


def test_a_known_error_comes_out() -> None:
    """x = cos t against x = 0.01 + 0.99 cos t: the distance is 0.01 (1 - cos t), at most where t = 3."""
    made = compare_models(
        [oscillator("free", "0")], oscillator("held", "0.01"), Grid(tolerances=(1e-6, 1e-9), budget=1e-4)
    )
    assert made.rungs[0].errors[0] == pytest.approx(0.01 * (1 - math.cos(3.0)), rel=1e-7)
    both = compare_models(
        [oscillator("free", "0")],
        oscillator("held", "0.01"),
        Grid(needs=("x", "pull"), tolerances=(1e-9,), budget=1e-4),
    )
    assert both.needs == ("x", "pull") and len(both.rungs[0].errors) == 2


def test_a_method_with_fixed_steps_takes_finer_and_finer_ones() -> None:
    """Without a step of its own, rk4 would take five for any tolerance, and its error would pass for the model's."""
    made = compare_models(
        [oscillator("free", "0")],
        oscillator("held", "0.01"),
        Grid(methods=("rk4",), tolerances=(1e-4, 1e-6, 1e-8), budget=1e-4),
    )
    free, held = ([r for r in made.results if r.case.formulation == name] for name in ("free", "held"))
    assert [r.steps for r in held] == sorted({r.steps for r in held})
    assert all(r.case.step == pytest.approx(3 / r.steps) for r in (*free, *held))
    assert held[0].error > 30 * held[1].error > 900 * held[2].error > 0  # of fourth order
    assert made.rungs[0].errors[0] == pytest.approx(0.01 * (1 - math.cos(3.0)), rel=1e-3)
    assert 0 < made.rungs[0].own < 1e-5
    assert "steps of" in to_markdown(made)


def test_the_runs_of_all_models_are_held_to_the_same_accuracy() -> None:
    """The time of a run is that of the fastest whose integrator errs by no more than the scene's tolerance, in each model."""
    free, held = oscillator("free", "0"), oscillator("held", "0.01")
    sources = [Source(one.path, one.text.replace("need: [x]", "need: [x], tolerance: 1e-3")) for one in (free, held)]
    made = compare_models(sources[:1], sources[1], Grid(tolerances=(1e-2, 1e-5, 1e-10), budget=1e-4))
    for rung in made.rungs:
        own = [r for r in made.results if r.case.formulation == rung.name]
        near = [r.best for r in own if abs(r.error - own[-1].error) <= 1e-3]
        assert rung.run == min(near) > 0
    short = compare_models(sources[:1], sources[1], Grid(tolerances=(1e-9,), budget=1e-4))
    assert math.isnan(short.rungs[0].run)  # nothing says how good a single run is


def test_a_scene_is_changed_in_all_models_as_far_as_they_have_the_names() -> None:
    """x = 2 cos t against x = f + (2 - f) cos t; only the finer model has the force f."""
    held = oscillator("held", "f")
    held = Source(held.path, held.text.replace("T:", "parameters: {f: 1}\nT:"))
    free = Source("free.yaml", oscillator("free", "0").text.replace("[0, 3]", "[0, 7]"))
    grid = Grid(tolerances=(1e-9,), budget=1e-4, changes=Changes(("x=2, f = 0.02",), "1:2.5"))
    made = compare_models([free], held, grid)
    assert made.time == (1.0, 2.5)
    for kind in (".svg", ".html", ".md", ".json"):
        assert "scene: x=2, f = 0.02; time 1:2.5" in make_comparison_file(made, kind)
    assert "</b>:" not in make_comparison_file(made, ".html")  # neither spec says what it is
    assert made.rungs[0].errors[0] == pytest.approx(0.02 * (1 - math.cos(1.5)) / 2, rel=1e-6)
    with pytest.raises(SpecError, match="`z` is no coordinate"):
        compare_models([free], held, replace(grid, changes=Changes(("z=2",))))


def test_without_a_compiler_the_emitted_python_is_timed(monkeypatch: pytest.MonkeyPatch) -> None:
    for place in ("fidelity", "study", "measure"):
        monkeypatch.setattr(f"nhc.study.chart.{place}.find_compiler", lambda: "")
    made = compare_models([oscillator("free", "0")], oscillator("held", "0.01"), Grid(tolerances=(1e-6,), budget=1e-4))
    assert "no C compiler" in made.notes[0] and made.results[0].case.language == "python"
    assert made.rungs[0].errors[0] == pytest.approx(0.01 * (1 - math.cos(3.0)), rel=1e-3)


@pytest.mark.parametrize(
    ("here", "there", "fits"), [("cm", "m", False), ("deg", "rad", False), ("1", "rad", True), ("m", "", True)]
)
def test_centimetres_are_not_held_against_metres(here: str, there: str, fits: bool) -> None:
    sources = []
    for name, unit in (("free", here), ("held", there)):
        source = oscillator(name, "0")
        said = f"coordinates: {{x: {{unit: '{unit}'}}}}" if unit else "coordinates: [x]"
        said += "\nparameters: {plain: 1}"  # without a unit, so that the dimensions of V are not asked for
        sources.append(Source(source.path, source.text.replace("coordinates: {x: {}}", said)))
    specs = [decode(source) for source in sources]
    if fits:
        check_comparable(specs[0], specs[1], specs[1].scenes[0], ("x", "x'"), "free")
        return
    with pytest.raises(SpecError) as caught:
        check_comparable(specs[0], specs[1], specs[1].scenes[0], ("x", "x'"), "free")
    assert [d.code for d in caught.value.diagnostics] == ["E0505", "E0505"]
    told = {d.message.partition(" in `held")[0] for d in caught.value.diagnostics}
    assert told == {f"`x` is in {here} here, in {there}", f"`x'` is in {here}/s here, in {there}/s"}


@pytest.mark.parametrize(
    ("change", "code", "words"),
    [
        (("outputs: {pull: x - 0}", ""), "E0505", "`free` has no quantity `pull`"),
        (("[0, 3]", "[0, 4]"), "E0505", "lasts from 0 to 4 here, from 0 to 3 in `held.yaml`"),
        (("swing:", "sway:"), "E0503", "no scene `swing`"),
    ],
)
def test_what_cannot_be_compared_is_refused_at_its_place(change: tuple[str, str], code: str, words: str) -> None:
    source = oscillator("free", "0")
    source = Source(source.path, source.text.replace(*change))
    with pytest.raises(SpecError) as caught:
        compare_models([source], oscillator("held", "0.01"), Grid(scene="swing", needs=("x", "pull")))
    (found,) = [d for d in caught.value.diagnostics if d.code == code]
    assert words in found.message and found.help and caught.value.source is source
    assert source.position(found.labels[0].span.start)[0] >= 8


def test_pictures_pages_and_texts_carry_all_models() -> None:
    made = ladder("lane_change")
    text = draw_comparison(made)
    assert text == draw_comparison(made) and "nan" not in text
    root = ET.fromstring(text)
    points = {int(e.get("data-k") or -1) for e in root.iter() if e.get("class") == "point"}
    assert points == set(range(len(made.results)))
    words = " ".join(e.text or "" for e in root.iter())
    assert all(name in words for name in (*LADDER, *made.needs, "0 by definition", "machine:"))
    page = make_comparison_file(made, ".html")
    assert page.count('type="checkbox"') == 3 and 'src="' not in page
    data = json.loads(make_comparison_file(made, ".json"))
    assert data["schema"] == "nhc.comparison/1" and [m["name"] for m in data["models"]] == list(LADDER)
    assert len(data["motions"]["point_mass"]["y"]) == len(data["times"]) == 201
    table = to_markdown(made)
    assert "| point_mass | euler-lagrange | 3 of 4 |" in table and "exact by definition" in table
    assert "point_mass: `v`: constant of the motion" in table


def test_the_verb_compares_models(tmp_path: Path) -> None:
    for name, force in (("free", "0"), ("held", "0.01")):
        (tmp_path / f"{name}.yaml").write_text(oscillator(name, force).text)
    specs = [str(tmp_path / f"{name}.yaml") for name in ("free", "held")]
    asked = [specs[0], "--against", specs[1], "--tolerances", "1e-4,1e-8", "-o", str(tmp_path / "out")]
    assert main(["chart", *asked]) == 0
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == [f"swing_against_held{kind}" for kind in (".html", ".json", ".md", ".svg")]
    assert not any(str(tmp_path) in path.read_text() for path in (tmp_path / "out").iterdir())
    assert main(["chart", *asked, "--langs", "c"]) == 2


def test_models_are_named_by_what_tells_their_files_apart() -> None:
    assert name_models(["a/x.yaml", "b/y.yaml"]) == {"a/x.yaml": "x", "b/y.yaml": "y"}
    assert name_models(["a/x.yaml", "b/x.yaml"]) == {"a/x.yaml": "a/x", "b/x.yaml": "b/x"}
