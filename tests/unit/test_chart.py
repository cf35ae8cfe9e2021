"""The words and pictures of a chart follow from its numbers: synthetic studies with known answers."""

from __future__ import annotations

import json
import math
import re
import time
import xml.etree.ElementTree as ET
from collections import Counter
from dataclasses import replace
from types import SimpleNamespace

import pytest
from jinja2 import meta

from benchmarks.methods import print_table as print_methods
from benchmarks.methods import ratio as method_ratio
from nhc.cli.chart import LANGUAGES as OFFERED_LANGUAGES
from nhc.cli.chart import METHODS as OFFERED
from nhc.emit.environment import create_environment
from nhc.language import read
from nhc.program.ir import Argument, Call, Function, Load, Ref, Store
from nhc.report.chart import draw_study
from nhc.report.chart_file import make_file
from nhc.report.chart_text import list_failures, to_data, to_markdown
from nhc.report.labels import Box, place_names, place_numbers
from nhc.simulate.auto import decay_rate
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.methods import RUNGE_KUTTA, STRUCTURE
from nhc.simulate.opening import open_scene
from nhc.study.chart import case_runner
from nhc.study.chart.advice import advise, fastest
from nhc.study.chart.case import Case, Cost, Machine, Reference, Result, Study
from nhc.study.chart.grid import LANGUAGES
from nhc.study.chart.grid import STRUCTURE as CHARTED
from nhc.study.chart.measure import (
    energy_error,
    final_error,
    grid_error,
    median,
    sizes_of,
    time_repeats,
)
from nhc.study.chart.reference import extrapolate
from nhc.study.chart.taylor import NoTaylor, translate
from nhc.study.chart.words import duration
from tests.support import spec_path

TOLERANCES = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12)


def line(form: str, method: str, language: str, price: float, power: float, **change: object) -> list[Result]:
    """Errors equal to the tolerance, time price * tolerance^-power."""
    made = []
    for t in TOLERANCES:
        calls = round(100 * t**-power)
        result = Result(Case(form, method, language, t), t, t, t, 0.0, calls, 0, 10, 1, price * t**-power, 0.0, 5)
        made.append(replace(result, median=result.best * 1.1, **change))  # type: ignore[arg-type]
    return made


def study(results: list[Result], reference: float = 1e-16) -> Study:
    costs = (
        Cost("voronec", "I.4.9", "chosen", 4, "1 +-, 2 *, 0 /, 1 calls", 1e-8, 1e-6),
        Cost("multipliers", "I.4.1", "named", 6, "9 +-, 9 *, 1 /, 1 calls", 3e-8, 3e-6),
    )
    return Study(
        "toy", "about <a> toy", "s", (0.0, 1.0), ("x",), TOLERANCES, ("dop853", "dopri5"), ("c", "python"), 65, costs,
        tuple(results), Reference("dop853", "gauss6", "long double", reference, 1e-18),
        (("newton", "does not apply"),), (), Machine("cpu", 2, "cc 1", "-O2", "3.11", "0.1"),
    )  # fmt: skip


CROSSING = [
    *line("voronec", "dop853", "c", 2e-6, 1 / 8),  # the dearer start, the slower growth
    *line("voronec", "dopri5", "c", 1e-6, 1 / 5),
    *line("multipliers", "dop853", "c", 6e-6, 1 / 8),
    *line("voronec", "dop853", "python", 2e-3, 1 / 8),
]


def test_advice_takes_the_fastest_that_reaches_the_accuracy() -> None:
    targets = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
    for advice in advise(study(CROSSING), targets):
        assert advice.best is not None
        reach = [r for r in CROSSING if r.error + 1e-16 <= advice.target * (1 + 1e-9)]
        assert advice.best.error <= advice.target
        tightest = [r for r in reach if r.best < advice.best.best / 1.06 and r.error <= advice.target / 1.5]
        assert not tightest
    fine = advise(study(CROSSING), (2e-10,))[0]
    assert fine.best is not None and fine.best.case.series == ("voronec", "dop853", "c")
    assert "dopri5 takes" in fine.text and "multipliers takes 3.0 times as long" in fine.text
    assert "a right-hand side takes 30 ns against 10 ns" in fine.text and "6 states against 4" in fine.text
    assert "Python takes 1000 times as long" in fine.text
    coarse = advise(study(CROSSING), (2e-2,))[0]
    assert coarse.best is not None and coarse.best.case.method == "dopri5"


def test_a_cheaper_right_hand_side_is_no_reason_to_be_slower() -> None:
    made = study(CROSSING)
    cheap = tuple(replace(cost, c=5e-9) if cost.formulation == "multipliers" else cost for cost in made.costs)
    (fine,) = advise(replace(made, costs=cheap), (2e-10,))
    assert (
        "multipliers takes 3.0 times as long (though a right-hand side takes 5 ns against 10 ns, 6 states" in fine.text
    )


def test_a_case_that_is_right_by_luck_is_not_recommended() -> None:
    lucky = line("voronec", "dopri5", "c", 1e-7, 1 / 5)
    lucky[0] = replace(lucky[0], error=1e-9)  # the coarsest run, better than all but the tightest
    found = fastest([*lucky, *line("voronec", "dop853", "c", 1e-3, 1 / 8)], 1e-7, 0.0)
    assert found is not None and found.case.tolerance == 1e-8 and found.case.method == "dopri5"


def test_failures_and_peers_are_never_recommended_and_what_none_reaches_is_said() -> None:
    broken = [replace(r, failed="it blows up (t = 3)", error=math.nan) for r in line("voronec", "rk4", "c", 1e-9, 0.1)]
    peer = line("voronec", "LSODA", "scipy", 1e-9, 1 / 8)
    made = study([*broken, *peer, *CROSSING])
    for advice in advise(made, (1e-3, 1e-6)):
        assert advice.best is not None and advice.best.case.language == "c" and advice.best.case.method != "rk4"
        assert "SciPy's LSODA on the same C takes" in advice.text
    (none,) = advise(made, (1e-14,))
    assert (
        none.best is None and "no case of this chart reaches 1e-14: the least error is 1.0e-12, of voronec" in none.text
    )
    assert "with dop853 in C at tolerance 1e-12 (6 of" in none.text
    (near,) = advise(study([replace(r, unresolved=True) for r in CROSSING], 9e-13), (1.5e-12,))
    assert (
        near.best is None and "the least error is at most 1.9e-12" in near.text
    )  # of which the reference has the half
    lucky = [replace(r, error=1e-9) if r.case.tolerance < 1e-10 else r for r in line("voronec", "rk4", "c", 1e-6, 0.2)]
    (luck,) = advise(study(lucky), (5e-10,))
    assert luck.best is None and luck.text.endswith("and not all finer runs of that line reach it")
    (blind,) = advise(study(CROSSING, 1e-5), (1e-6,))
    assert blind.best is None and "the reference itself is known to 1.0e-05 only" in blind.text


def test_of_equal_cases_the_first_line_is_taken() -> None:
    twins = [*line("voronec", "dop853", "c", 1.02e-6, 1 / 8), *line("multipliers", "dop853", "c", 1e-6, 1 / 8)]
    (advice,) = advise(study(twins), (1e-3,))
    assert advice.best is not None and advice.best.case.formulation == "voronec"
    assert "multipliers takes as long" in advice.text


def test_the_picture_shows_every_case_and_marks_failures_and_unresolved_points() -> None:
    broken = [replace(r, failed="it blows up (t = 3)", error=math.nan) for r in line("multipliers", "rk4", "c", 1, 0.1)]
    others = [replace(r, grid_error=1e-3 * r.error) for r in line("voronec", "dopri5", "python", 1e-3, 0.2)]
    made = study([*CROSSING, *others, *broken], 1e-12)
    text = draw_study(made)
    assert text == draw_study(made)
    root = ET.fromstring(text)
    points = {int(e.get("data-k") or -1) for e in root.iter() if e.get("class") == "point"}
    good = {k for k, r in enumerate(made.results) if not r.failed}
    first_failed = next(k for k, r in enumerate(made.results) if r.failed)
    assert points == good | {first_failed}
    words = " ".join(e.text or "" for e in root.iter())
    for expected in ("down and left is better", "failed runs", "rk4, C", "all", "multipliers", "1.0e-12", "cpu"):
        assert expected in words
    hollow = Counter(
        int(e.get("data-k") or -1)
        for e in root.iter()
        if e.get("class") == "point" and e.get("fill") == "#ffffff" and e.tag.endswith(("circle", "polygon"))
    )
    for k in good:  # as grey as its place: of the panels with the error at the end there are two
        result = made.results[k]
        assert hollow[k] == 2 * (result.error < 1e-10) + (result.grid_error < 1e-10)
    assert all("nan" not in value for e in root.iter() for value in e.attrib.values())


def test_times_of_right_hand_sides_have_marks_of_no_method_and_no_formulation() -> None:
    text = draw_study(study(CROSSING))
    place = text.index("time of one right-hand side [s]")
    assert "<circle" not in text[place:] and "<rect" not in text[place:] and "<polygon" not in text[place:]
    assert text[place:].count('stroke-width="3"') == sum(
        math.isfinite(t) for cost in study(CROSSING).costs if not cost.twin for t in (cost.c, cost.python)
    )


def test_what_is_beaten_by_an_unresolved_case_is_not_among_the_best() -> None:
    """The slow line's finest resolved case has the least resolved error; a case on the grey ground is better and faster."""
    fast = [
        replace(r, error=1e-4 * r.error, unresolved=r.error <= 1e-6) for r in line("voronec", "dop853", "c", 1e-6, 0.1)
    ]
    slow = [replace(r, unresolved=r.error < 1e-10) for r in line("voronec", "radau5", "c", 1e-3, 0.1)]
    root = ET.fromstring(draw_study(study([*fast, *slow], 1e-12)))
    (front,) = (e.get("points") or "" for e in root.iter() if e.get("stroke") == "#bbbbbb" and e.get("points"))
    assert len(front.split()) == sum(not r.unresolved for r in fast)


def test_markers_stay_inside_their_panels_and_off_the_legend() -> None:
    root = ET.fromstring(draw_study(study(CROSSING)))
    frames = [e for e in root.iter() if e.tag.endswith("rect") and e.get("stroke") == "#555555"]
    boxes = [tuple(float(e.get(k) or 0) for k in ("x", "y", "width", "height")) for e in frames]
    assert len(boxes) == 5
    for e in root.iter():
        if e.get("class") == "point" and e.tag.endswith("circle"):
            x, y = float(e.get("cx") or 0), float(e.get("cy") or 0)
            assert any(a - 1 <= x <= a + w + 1 and b - 1 <= y <= b + h + 1 for a, b, w, h in boxes)
    legend = [
        float(e.get("y") or 0) for e in root.iter() if (e.text or "") in ("method", "equations", "run by", "marks")
    ]
    assert len(legend) == 4 and max(legend) < min(b for _, b, _, _ in boxes) - 15


def texts_of(root: ET.Element) -> list[str]:
    return [e.text or "" for e in root.iter() if e.tag.endswith("text")]


def test_what_a_panel_cannot_show_has_no_axis() -> None:
    free = [replace(r, residual=math.nan, energy=math.nan) for r in CROSSING]
    words = texts_of(ET.fromstring(draw_study(study(free))))
    assert "the system has no constraints" in words and "no energy is known" in words
    assert not any("left minus right side" in word for word in words)
    held = texts_of(ET.fromstring(draw_study(study(CROSSING))))
    assert "nothing but zeros" in held and "the system has no constraints" not in held


def test_lines_have_their_methods_beside_them_where_nothing_is_covered() -> None:
    lines = [("dop853", [[(100.0, 100.0), (200.0, 50.0)]]), ("dopri5", [[(100.0, 112.0), (200.0, 62.0)]])]
    frame = Box(0.0, 0.0, 300.0, 200.0)
    upper, lower = place_names(lines, frame)
    assert (upper.text, lower.text) == ("dop853", "dopri5")
    assert upper.y < 100 and lower.y > 62 + 8  # neither fits between the lines
    crowd = [(60.0 + x, 60.0 + y) for x in range(0, 200, 4) for y in range(-60, 100, 4)]
    assert [name.text for name in place_names([lines[0], ("crowd", [crowd])], frame)] == ["crowd"]
    assert place_names(lines, Box(90.0, 40.0, 120.0, 115.0)) == []
    both = [("dop853", [*lines[0][1], *lines[1][1]])]
    assert len(place_names(both, frame)) == 1  # a kind has its name once


def test_methods_are_named_in_the_picture() -> None:
    text = draw_study(study(CROSSING))
    panel = text[text.index("time against error at the end") : text.index("error along the motion")]
    named = re.findall(r'<text [^>]*class="m(\d) l(\d)">([^<]+)<', panel)
    assert sorted(named) == [("0", "0", "dop853"), ("0", "1", "dop853, Python"), ("1", "0", "dopri5")]


def test_formulations_with_the_same_code_are_told_and_not_compared() -> None:
    made = study(CROSSING)
    voronec, multipliers = made.costs
    made = replace(made, costs=(voronec, replace(voronec, formulation="chaplygin", twin="voronec"), multipliers))
    assert all("; chaplygin has the same code; " in a.text for a in advise(made) if a.best is not None)
    assert "| as voronec | as voronec |" in to_markdown(made)
    assert "the same code as voronec" in texts_of(ET.fromstring(draw_study(made)))


def test_an_error_below_what_the_reference_resolves_is_a_bound() -> None:
    faint = [replace(r, error=1e-13, unresolved=True) for r in CROSSING[:6]]
    (advice,) = advise(study(faint, 1e-12), (1e-6,))
    assert "error at most 1.1e-12," in advice.text


def test_time_spent_waiting_does_not_count() -> None:
    wait = 0.05
    best, middle, _ = time_repeats(lambda _: time.sleep(wait), 1e-4)
    assert best <= middle < wait / 2


def test_the_texts_carry_method_tolerance_reference_and_machine() -> None:
    broken = [replace(r, failed="it blows up (t = 3)", error=math.nan) for r in line("multipliers", "rk4", "c", 1, 0.1)]
    made = study([*CROSSING, *broken])
    data = json.loads(make_file(made, ".json"))
    assert data["schema"] == "nhc.chart/1" and data["machine"]["compiler"] == "cc 1"
    assert data["reference"]["error"] == 1e-16 and data["reference"]["confirmed_by"] == "gauss6"
    assert len(data["results"]) == len(made.results)
    failed = [r for r in data["results"] if r["failed"]]
    assert len(failed) == len(broken) and all(r["error"] is None for r in failed)
    assert all({"method", "tolerance", "language", "formulation"} <= set(r) for r in data["results"])
    assert [a["target"] for a in data["recommendations"]] == [1e-3, 1e-6, 1e-9, 1e-12]
    words = to_markdown(made)
    assert "multipliers with rk4: it blows up (6 runs)" in words and "newton: does not apply" in words
    assert "| voronec | dop853 | C | 6.32 µs | 20 µs | 35.6 µs | - |" in words.splitlines()
    assert "machine: cpu (2 cores); cc 1 -O2; Python 3.11; nhc 0.1" in words and "confirmed by gauss6" in words
    assert list_failures(made) == [("multipliers with rk4", "it blows up", 6)]
    assert "NaN" not in json.dumps(to_data(made), allow_nan=False)


def test_the_page_is_alone_and_escapes_what_it_is_given() -> None:
    page, picture = (make_file(study(CROSSING), ending) for ending in (".html", ".svg"))
    assert picture.startswith("<svg") and picture.rstrip().endswith("</svg>") and "checkbox" not in picture
    assert "about &lt;a&gt; toy" in page and "<a> toy" not in page
    assert not re.search(r'(src|href)="', page) and "http" not in page.replace("http://www.w3.org/2000/svg", "")
    (text,) = re.findall(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert len(json.loads(text)) == len(CROSSING)
    assert page.count('type="checkbox"') == 6  # two methods, two formulations, two languages


@pytest.mark.parametrize(
    ("template", "given"),
    [
        ("c/chart/repeat.c.jinja", {"head", "name"}),
        ("c/chart/natural.c.jinja", {"head", "name"}),
        ("c/chart/again.c.jinja", {"name", "method"}),
        ("c/chart/long.c.jinja", {"head", "name", "methods", "functions", "parameters", "needed"}),
    ],
)
def test_a_template_uses_exactly_what_it_is_given(template: str, given: set[str]) -> None:
    environment = create_environment()
    assert environment.loader is not None
    tree = environment.parse(environment.loader.get_source(environment, template)[0])
    assert meta.find_undeclared_variables(tree) == given


def test_the_command_line_offers_exactly_what_there_is() -> None:
    assert (*RUNGE_KUTTA, *STRUCTURE) == OFFERED
    assert set(CHARTED) == set(STRUCTURE)
    assert LANGUAGES == OFFERED_LANGUAGES


def test_errors_are_relative_to_each_columns_own_size() -> None:
    reference = [[0.0, 0.0, 5.0], [1e-3, 200.0, 5.0], [2e-3, 100.0, 5.0]]
    rows = [[0.0, 0.0, 5.0], [1e-3, 200.0, 5.0], [2.2e-3, 101.0, 5.0]]
    sizes = sizes_of(reference, 2)
    assert sizes == [2e-3, 200.0]
    assert final_error(rows, reference, sizes) == pytest.approx(0.1)
    assert grid_error(rows, reference, sizes) == pytest.approx(math.sqrt((0.1**2 + 0.005**2) / 6))
    assert sizes_of([[0.0]], 1) == [1.0]
    energies = [[1.0, 4.0], [1.0, 2.0]]
    assert energy_error([[1.0, 4.0], [1.2, 2.0]], energies, ["energy", "kinetic"]) == pytest.approx(0.05)
    assert math.isnan(energy_error(rows, reference, ["need", "need", "need"]))


def test_times_are_taken_per_run_and_long_runs_once() -> None:
    counts: list[int] = []

    def quick(count: int) -> None:
        counts.append(count)
        sum(range(10 * count))  # a clock sees it even if a busy machine has made the batches short

    best, middle, number = time_repeats(quick, 1e-4)
    assert 0 < best <= middle and number >= 3
    assert counts[0] == 1 and counts[-1] >= 64  # a run that is nothing is repeated until the clock can see it
    calls: list[int] = []

    def slow(count: int) -> None:
        calls.append(count)
        sum(range(200_000))

    assert time_repeats(slow, 1e-7)[2] == 1 and calls == [1]
    assert median([3.0, 1.0, 2.0]) == 2.0 and median([4.0, 1.0, 2.0, 3.0]) == 2.5
    assert [duration(x) for x in (2.5, 2.5e-3, 2.5e-6, 2.5e-9, math.nan)] == [
        "2.5 s",
        "2.5 ms",
        "2.5 µs",
        "2.5 ns",
        "-",
    ]


def test_extrapolation_takes_away_the_sixth_power() -> None:
    def solved(h: float) -> list[list[float]]:
        return [[1.0 + 3.0 * h**6]]

    assert extrapolate(solved(0.2), solved(0.1))[0][0] == pytest.approx(1.0, abs=1e-15)


HEYOKA = SimpleNamespace(
    expression=float, time=0.3, pi=math.pi, sin=math.sin, cos=math.cos, tan=math.tan, sqrt=math.sqrt, exp=math.exp
)


@pytest.mark.parametrize(
    ("name", "formulation"),
    [("chaplygin_sleigh", "euler-lagrange"), ("rolling_disk", "multipliers"), ("heavy_top", "lagrange")],
)
def test_what_heyoka_is_given_has_the_values_of_the_emitted_code(name: str, formulation: str) -> None:
    """Its expressions stood in for by numbers: the translation, solves and all, is the right-hand side."""
    job = open_scene(read(str(spec_path(name))), formulation=formulation)
    function = next(f for f in job.program.functions if f.name == "rhs")
    y = [x + 0.1 + 0.05 * k for k, x in enumerate(job.y)]
    expected = InterpretedModel(job.program, 0).rhs(0.3, y, job.p)
    assert translate(function, HEYOKA, y, job.p) == pytest.approx(expected, rel=1e-11, abs=1e-11)


def test_what_taylors_method_cannot_do_is_refused() -> None:
    body = (Load("x", "y", 0), Store("out", 0, Call("abs", (Ref("x"),))))
    function = Function("rhs", "", (Argument("y", 1),), Argument("out", 1), body)
    with pytest.raises(NoTaylor, match="no `abs`"):
        translate(function, HEYOKA, [1.0], [])
    with pytest.raises(NoTaylor, match="9000 operations"):
        translate(replace(function, adds=9000), HEYOKA, [1.0], [])


def test_a_decaying_mode_is_found_and_an_oscillation_is_none() -> None:
    assert decay_rate([[-50.0, 1.0], [0.0, -1.0]]) == pytest.approx(50.0, rel=1e-6)
    assert decay_rate([[0.0, 100.0], [-100.0, 0.0]]) == 0.0
    assert decay_rate([[3.0]]) == 0.0 and decay_rate([[0.0]]) == 0.0


def test_the_table_of_methods_has_the_best_other_one_in_compiled_code() -> None:
    made = study(CROSSING)
    slow = replace(made, results=tuple(r for r in CROSSING if r.case.method == "dop853"))
    cells = [method_ratio(made, 1e-6), method_ratio(slow, 1e-6)]
    ours, theirs = (
        fastest([r for r in CROSSING if r.case.series[1:] == (m, "c")], 1e-6, 1e-16) for m in ("dop853", "dopri5")
    )
    assert ours is not None and theirs is not None
    assert cells == [f"{theirs.best / ours.best:.2g} (dopri5)", "-"]
    assert "| toy, s | " in print_methods([made]) and "known to 1e-16 or better" in print_methods([made])


def test_what_the_interpreter_takes_is_learnt_from_its_first_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Large implicit steps take it two thousand times as long as compiled code: the finer ones are not tried."""
    compiled = {1e-3: 1e-4, 1e-6: 4e-3, 1e-9: 7e-3}

    def run(bench: object, case: Case, budget: float) -> Result:
        return Result(case, calls=100, best=compiled[case.tolerance] * (1 if case.language == "c" else 2000))

    monkeypatch.setattr(case_runner, "run_case", run)
    made = case_runner.CaseRunner(SimpleNamespace(name="m"), False, 1e-3)  # type: ignore[arg-type]
    for language in ("c", "python"):
        done = [made.run(Case("m", "radau5", language, t), rung) for rung, t in ((1, 1e-3), (4, 1e-6), (7, 1e-9))]
        assert [len(results) for results in done] == ([1, 1, 1] if language == "c" else [1, 0, 0])
    assert made.many == ["radau5", "radau5"]


def test_what_compiled_code_takes_too_long_for_is_not_interpreted(monkeypatch: pytest.MonkeyPatch) -> None:
    """The rattleback's chart spent eight minutes of nine in Python at tolerances that its C had given up."""
    monkeypatch.setattr(case_runner, "run_case", lambda bench, case, budget: Result(case, calls=100, best=1e-4))
    made = case_runner.CaseRunner(SimpleNamespace(name="m"), False, 1e-3)  # type: ignore[arg-type]
    alone = case_runner.CaseRunner(SimpleNamespace(name="m"), False, 1e-3)  # type: ignore[arg-type]
    rungs = ((1, 1e-3), (4, 1e-6), (7, 1e-9))
    assert made.run(Case("m", "gauss6", "c", 1e-3), 1)
    monkeypatch.setitem(case_runner.SLOW, "c", -1.0)
    assert [len(made.run(Case("m", "gauss6", "c", t), rung)) for rung, t in rungs[1:]] == [1, 0]
    assert [len(made.run(Case("m", "gauss6", "python", t), rung)) for rung, t in rungs] == [1, 1, 0]
    assert made.many == ["gauss6"]
    assert all(alone.run(Case("m", "gauss6", "python", t), rung) for rung, t in rungs)


def test_a_long_compiler_line_stays_in_the_picture() -> None:
    machine = Machine(
        "A Processor of a Long Name", 96, "cc (Distribution 12.2.0-14+deb12u1)", "-fno-flag " * 16, "3", "1"
    )
    root = ET.fromstring(draw_study(replace(study(CROSSING), machine=machine)))
    small = [e for e in root.iter() if e.get("font-size") == "10.5" and e.get("fill") == "#555555"]
    assert len(small) == 3 and " ".join(str(e.text).strip() for e in small).endswith("nhc 1")
    for line in small:
        assert float(line.get("x", "")) + 10.5 * 0.56 * len(line.text or "") < float(root.get("width", ""))
        assert float(line.get("y", "")) < float(root.get("height", "")) - 4


def test_numbers_of_places_that_are_close_together_cover_nothing() -> None:
    """Each has its own side; one that has no room is left out."""
    places = [(100.0, 100.0), (105.0, 92.0), (108.0, 101.0), (95.0, 104.0)]
    frame = Box(0, 0, 200, 200)
    found = place_numbers(list("0123"), places, [places], frame)
    boxes = [Box(n.x, n.y - 9, n.x + 7, n.y) for n in found if n is not None]
    assert len(boxes) >= 3
    for k, box in enumerate(boxes):
        assert not any(map(box.holds, places)) and not any(map(box.meets, boxes[:k]))
    assert place_numbers(["0"], [(100.0, 100.0)], [], Box(95, 95, 105, 105)) == [None]
