"""The stability laboratory against closed forms, published thresholds and catalogued sensitivities."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.language import read
from nhc.mechanics.starts.scenes import start_of
from nhc.pipeline import Options, model, stability
from nhc.report.stability import list_charts
from nhc.simulate.methods import METHODS, RUNGE_KUTTA
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.stability.bench import open_bench
from nhc.study.stability.drift import Drift, long_run
from nhc.study.stability.laboratory import Laboratory, Question
from nhc.study.stability.laws import find_law
from nhc.study.stability.stepsize import amplification, predict
from nhc.study.stability.table import judge, lines
from nhc.study.stability.tree import tree
from nhc.study.stability.work import FEWER, NODES, WEIGHTS, estimate
from tests.numeric.test_stiffness import SYRUP
from tests.numeric.test_switching import SKATER, forced
from tests.support import ROOT, hide_numpy, spec_path

PLAIN = Question()


@cache
def look(name: str, question: Question = PLAIN, formulation: str = "") -> Laboratory:
    path = ROOT / name if name.endswith(".yaml") else spec_path(name)
    return stability(read(str(path)), question, Options(formulation=formulation))


def crossings(found: Laboratory) -> list[float]:
    assert found.motion is not None and found.motion.swept is not None
    return [c.value for c in found.motion.swept.crossings]


SPRING = """nhc: 1
system: spring
coordinates: [x]
parameters: {k: K}
T: x'^2/2
V: k*x^2/2 + x^4/4
scenes:
  a: {initial: {x: START}, time: [0, 20]}
  b: {initial: {x: 1}, time: [0, 20]}
"""


@pytest.mark.slow
def test_changed_values_hold_for_every_study(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As if the spec said so, also beside a steady motion of another scene; the head lists them."""
    plain, other = tmp_path / "spring.yaml", tmp_path / "other" / "spring.yaml"
    other.parent.mkdir()
    plain.write_text(SPRING.replace("K", "1").replace("START", "1"))
    other.write_text(SPRING.replace("K", "90").replace("START", "1/2"))
    told, trees, page = [], [], tmp_path / "page.html"
    for arguments in ([str(other)], [str(plain), "--set", "k=90", "--set", "x=k/180"], [str(plain)]):
        for steady in ([], ["--about", "x=0", "--set", "k=90"]):
            assert main(["stability", *arguments, "--long", "1", *steady]) == 0
            told.append(capsys.readouterr().out.splitlines())
        assert main(["stability", *arguments, "--long", "1", "--json", "-o", str(page), "--force"]) == 0
        trees.append(json.loads(capsys.readouterr().out))
        assert ("values than those" in page.read_text()) == ("--set" in arguments)
    head = "  other values than those of the spec's scene: k=90, x=k/180"
    assert told[2][2] == head and told[2][:2] + told[2][3:] == told[0]
    assert told[4] != told[0] and head not in told[4]
    assert trees[1] | {"changes": []} == trees[0] != trees[2] and trees[1]["changes"] == [head.strip()]
    assert "k=90" in told[5][2]


# --- thresholds -----------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_weave_and_capsize_of_the_bicycle_from_its_scene() -> None:
    found = look("bicycle", Question(sweep=("v", 0.0, 10.0, 11)))
    assert crossings(found) == pytest.approx([4.2923825363411, 6.0242620153884], abs=1e-7)


def test_rolling_and_spinning_disk() -> None:
    rolling = look("rolling_disk", Question(about="theta=pi/2", sweep=("w_n", 1.0, 4.0, 4)))
    spinning = look("rolling_disk", Question(about="theta=pi/2", sweep=("w_u", 1.0, 8.0, 4)))
    assert crossings(rolling) == pytest.approx([math.sqrt(0.0625 * 9.81 * 0.5 / (0.125 * 0.375))], abs=1e-8)
    assert crossings(spinning) == pytest.approx([math.sqrt(9.81 * 0.5 / 0.3125)], abs=1e-8)


@pytest.mark.slow
def test_sleeping_top_in_angles_that_are_regular_there() -> None:
    found = look("specs/atlas/upright_top.yaml", Question(about="w3=2.5", sweep=("w3", 1.0, 3.0, 6)))
    assert crossings(found) == pytest.approx([math.sqrt(4 * 2.0) / 1.5], abs=1e-7)


@pytest.mark.slow
def test_rattleback_exchanges_its_growing_mode_with_the_sense_of_spin() -> None:
    found = look("rattleback", Question(about="w3=5", sweep=("w3", -5.0, 5.0, 2), lengths=1))
    assert found.motion is not None and found.motion.swept is not None
    for point, sign in zip(found.motion.swept.points, (1, -1), strict=True):
        parts = sorted((x.imag, x.real) for x in eigenvalues(point) if x.imag > 0)
        assert parts[0] == pytest.approx((34.143692, -0.202521 * sign), abs=1e-5)
        assert parts[1] == pytest.approx((109.392323, 2.120692 * sign), abs=1e-5)


def test_gimbal_lock_is_said_and_no_verdict_given() -> None:
    found = look("heavy_top", Question(scene="sleeping"))
    (verdict,) = [line for line in lines(found) if line.split()[:1] == ["verdict"]]
    assert verdict.split()[1] == "none" and "gimbal lock" in verdict
    assert tree(found)["steady"]["verdict"] is None


# --- steps ----------------------------------------------------------------------------------------------------


def amplify(name: str, z: complex) -> complex:
    return complex(amplification(RUNGE_KUTTA[name], np.array([z], dtype=complex))[0])


def test_stability_functions_of_the_methods() -> None:
    """R(z) approximates exp(z) to the order; the classical limits of RK4; the implicit ones stay below 1 on the left."""
    z = -0.1 + 0.05j
    for name, method in RUNGE_KUTTA.items():
        errors = [abs(amplify(name, x) - np.exp(x)) for x in (z, z / 2)]
        if method.order <= 6:
            assert math.log2(errors[0] / errors[1]) == pytest.approx(method.order + 1, abs=0.3), name
    assert abs(amplify("rk4", -2.785293563)) == pytest.approx(1.0, abs=1e-6)
    assert abs(amplify("rk4", 2j * math.sqrt(2))) == pytest.approx(1.0, abs=1e-12)
    for name in ("radau5", "gauss4", "gauss6", "midpoint"):
        assert all(abs(amplify(name, x)) <= 1 + 1e-9 for x in (-1e3, -10 + 50j, 30j)), name


def test_predicted_step_of_an_oscillator() -> None:
    """For long runs the limit goes to 2 sqrt 2 / omega from above."""
    limit = predict(RUNGE_KUTTA["rk4"], [7j, -7j], 1e4)
    assert limit == pytest.approx(2 * math.sqrt(2) / 7, rel=2e-3)
    assert math.isinf(predict(RUNGE_KUTTA["radau5"], [-1e6], 10.0))


def test_measured_and_predicted_steps_of_a_linear_system_agree(tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.mktemp("spec") / "spring.yaml"
    path.write_text(
        "nhc: 1\nsystem: spring\ncoordinates: [x, y]\nT: x'^2/2 + y'^2/2\nV: 5000*x^2 + y^2/2\n"
        "scenes:\n  ring:\n    initial: {x: 0.01, y: 1}\n    time: [0, 20]\n"
    )
    found = stability(read(str(path)), Question(lengths=2))
    for limit in found.limits:
        if limit.method in ("rk4", "dopri5"):
            assert limit.measured == pytest.approx(limit.predicted, rel=0.06), limit
    assert found.spectrum is not None and found.spectrum.fastest == pytest.approx(100.0, rel=1e-9)


KEPLER = """nhc: 1
system: kepler
coordinates: [x, y]
parameters: {e: 99/100}
T: (x'^2 + y'^2)/2
V: -1/sqrt(x^2 + y^2)
scenes: {ellipse: {initial: {x: 1 + e, y': sqrt((1 - e)/(1 + e))}, time: [0, 20]}}
"""


@pytest.mark.slow
def test_the_fastest_rate_is_found_where_the_motion_is_fast() -> None:
    """At the pericentre of an ellipse, sqrt(2/(1 - e)^3), which no equally spaced places meet; that is no stiffness."""
    found = stability(Source("kepler.yaml", KEPLER), Question(lengths=1))
    assert found.spectrum is not None and found.spectrum.fastest == pytest.approx(math.sqrt(2e6), rel=1e-2)
    assert min(abs(found.spectrum.when - k * math.pi) for k in (1, 3, 5)) < 1e-3
    assert found.stiffness is not None and found.stiffness < 100
    assert any(line.split()[:4] == ["fastest", "|lambda|", "1414", "at"] for line in lines(found))


# --- drift, sensitivity, distances ----------------------------------------------------------------------------


def test_rules_that_a_power_is_integrated_by() -> None:
    """Exact for polynomials of degree 22 and 13; where they do not follow, each part's error is told."""
    for degree in range(23):
        exact = (1 - (-1) ** (degree + 1)) / (degree + 1)
        assert WEIGHTS @ NODES**degree == pytest.approx(exact, abs=1e-14)
        assert degree > 13 or pytest.approx(exact, abs=1e-14) == FEWER @ NODES**degree
    for rate in (1.0, 10.0, 300.0, 1e4):
        edges = np.linspace(0.0, 3.0, 101)
        at = (edges[:-1] + edges[1:])[:, None] / 2 + 0.015 * NODES
        for values, exact in (
            (np.cos(rate * at), np.sin(rate * edges) / rate),
            (np.exp(-rate * at), (1.0 - np.exp(-rate * edges)) / rate),
        ):
            missed = float(np.max(np.abs(np.cumsum(0.015 * values @ WEIGHTS) - exact[1:])))
            assert missed < 2.0 * estimate(0.015 * values @ (WEIGHTS - FEWER)) + 1e-13


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", ["snakeboard", "ball_on_table", "bead_on_rod"])
def test_the_balance_of_power_closes_where_energy_is_not_conserved(name: str) -> None:
    found = look(name, Question(lengths=2))
    energy = found.runs[0].drifts[0]
    assert energy.kind in ("balance", "energy") and max(energy.series) < 1e-6


DAMPED = """nhc: 1
system: damped
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: 50*x^2 + 2*y^2
forces: {x: -3*x', y: -0.1*y'}
scenes: {a: {initial: {x: 1, y: 1}, time: [0, 20]}}
"""


def test_a_balance_is_not_hidden_by_its_integral(tmp_path: Path) -> None:
    """Its power oscillates at 20 rad/s over 200 s: by a rule over 2001 rows the error, 0.03, was told as that of dop853."""
    path = tmp_path / "damped.yaml"
    path.write_text(DAMPED)
    found = stability(read(str(path)), PLAIN, Options())
    exact, coarse = found.runs[0], found.runs[1]
    assert exact.method == "dop853"
    assert max(exact.drifts[0].first, exact.drifts[0].last) < 1e-8
    assert 1e-5 < coarse.drifts[0].last < 1e-2
    assert len(exact.times) == len(exact.drifts[0].series) <= 2001
    # every step of a method that is stable for all decaying modes is stable here, whatever lies between the steps
    limits = {limit.method: limit for limit in found.limits}
    assert all(math.isinf(limits[name].measured) for name in ("radau5", "gauss4", "gauss6", "midpoint"))
    for name in ("dop853", "dopri5", "rk4"):
        assert limits[name].measured == pytest.approx(limits[name].predicted, rel=0.03)


ENGINE = """nhc: 1
system: engine
coordinates: [x]
parameters: {w: 1000}
T: x'^2/2
V: 2*x^2
forces: {x: "50*cos(w*t) - 0.2*x'"}
scenes: {a: {initial: {x: 1}, time: [0, 10]}}
"""
TABLE = """nhc: 1
system: table
coordinates: [x, y]
define: {al: 2*sin(50*t)}
T: (x'^2 + y'^2)/2
V: (x^2 + 2*y^2)/2
constraints:
  - blade: -sin(al)*(x' + 3*y) + cos(al)*(y' - 3*x) = 0
scenes: {a: {initial: {x: 1, y: 0.5, x': 0.3, y': 3}, time: [0, 10]}}
"""


@pytest.mark.sample(2)
@pytest.mark.parametrize("text", [ENGINE, TABLE])
def test_the_balance_of_a_motion_that_is_driven_fast(text: str) -> None:
    """Over equally spaced rows the power of 1000 and 50 rad/s looks slow, and every second row agrees: 1.0 and 1.2 were told."""
    found = stability(Source("fast.yaml", text), PLAIN)
    exact = found.runs[0].drifts[0]
    assert exact.kind == "balance" and exact.resolved and max(exact.series) < 1e-7
    assert tree(found)["drift"][0]["quantities"][0]["resolved"]


@pytest.mark.slow
def test_the_balance_of_a_motion_that_jumps() -> None:
    """Van der Pol's oscillator leaps between any two rows; the steps are short there."""
    text = "nhc: 1\nsystem: vdp\ncoordinates: [x]\nT: x'^2/2\nV: x^2/2\nforces: {x: 100*(1 - x^2)*x'}\n"
    found = stability(Source("vdp.yaml", text + "scenes: {a: {initial: {x: 2}, time: [0, 100]}}\n"), PLAIN)
    exact = found.runs[0].drifts[0]
    assert exact.kind == "balance" and exact.resolved and max(exact.series) < 1e-5


def test_the_equilibrium_is_found_where_no_place_of_the_scene_leads_to_it() -> None:
    """From x = 2 a search among all states exchanges the spring against a friction that grows with the speed."""
    text = "nhc: 1\nsystem: vdp\ncoordinates: [x]\nT: x'^2/2\nV: x^2/2\nforces: {x: 3/2*(1 - x^2)*x'}\n"
    found = stability(Source("vdp.yaml", text + "scenes: {a: {initial: {x: 2}, time: [0, 0.4]}}\n"), PLAIN)
    assert found.motion is not None and found.motion.place == "the start"
    assert found.motion.linearisation.steady.y == pytest.approx((0.0, 0.0), abs=1e-12)


def test_a_power_that_the_steps_do_not_follow_is_not_resolved() -> None:
    """A force of 1e6 rad/s, over whose turns fixed steps pass."""
    made = model(Source("engine.yaml", ENGINE.replace("1000", "1e6").replace("10]", "0.1]")))
    bench = open_bench(made.equations, made.formulation, start_of(made.system, made.spec.scenes[0]))
    (drift,) = long_run(bench, 1000.0, "rk4", 0.1).drifts
    assert not drift.resolved and judge(drift).startswith("not resolved: the integral of the power errs by")


def test_the_ends_of_steps() -> None:
    """The same from C and from Python, of each as many as there are steps, with the run's end the last."""
    ends = []
    for compiled in (True, False):
        bench = look("chaplygin_sleigh", Question(compiled=compiled, lengths=1)).bench
        outcome = bench.integrate("dop853", bench.times, logged=True)
        assert len(outcome.ends) == outcome.steps and outcome.ends[-1] == bench.times[-1]
        assert bench.integrate("dop853", bench.times).ends == []
        ends.append(outcome.ends)
    assert ends[0] == pytest.approx(ends[1], rel=1e-6)


def test_sensitivities_are_those_of_the_catalogue() -> None:
    """To the factor that the choice of a norm makes."""
    for name, catalogued in (
        ("pendulum", 17),
        ("chaplygin_sleigh", 11),
        ("rolling_disk", 65),
        ("double_pendulum", 249),
    ):
        found = look(name).sensitivity
        assert found is not None and 0.3 < found.plain / catalogued < 3.5, name


def test_the_largest_growth_is_found_where_the_motion_jumps() -> None:
    """Van der Pol's oscillator by the variational equations (Radau at 1e-10): 35347 at t = 81.187, in steps of 1e-5."""
    text = "nhc: 1\nsystem: vdp\ncoordinates: [x]\nT: x'^2/2\nV: x^2/2\nforces: {x: 100*(1 - x^2)*x'}\n"
    found = stability(Source("vdp.yaml", text + "scenes: {a: {initial: {x: 2}, time: [0, 90]}}\n"), Question(lengths=1))
    growth = found.sensitivity
    assert growth is not None and growth.largest == pytest.approx(35347, rel=0.02)
    assert growth.peak == pytest.approx(81.187, abs=1e-3) and max(growth.norms) < 100
    (chart,) = [chart for chart in list_charts(found) if chart.title.startswith("growth of perturbations")]
    assert max(chart.series[0].y) == growth.largest
    assert any("of relative perturbations, at t = 81.18" in line for line in lines(found))


def test_laws_of_growth() -> None:
    t = [0.25 * k for k in range(41)]
    law = find_law(t, [1 + 0.1 * math.exp(1.5 * x) for x in t], 10.0)
    assert law.name == "exponential" and law.rate == pytest.approx(1.5, rel=0.05) and 20 < law.horizon < 26
    law = find_law(t, [1 + x**2 for x in t], 10.0)
    assert law.name == "power" and law.rate == pytest.approx(2.0, rel=0.1) and math.isinf(law.horizon)
    assert math.isinf(find_law(t, [1.0] * len(t), 10.0).horizon)
    # beside a motion that returns perturbations only swing, and a trend of the swings is none
    law = find_law(t, [1.35 + 0.35 * math.sin(4 * x + 2) for x in t], 10.0)
    assert law.name == "none" and math.isnan(law.rate) and math.isnan(law.horizon)


@pytest.mark.parametrize("power", [1.0, 2.0, 3.5])
@pytest.mark.parametrize("swing", [0.0, 0.5])
def test_a_power_of_t_is_no_exponential(power: float, swing: float) -> None:
    """Also where the perturbations swing, where they start late, and in a part of the scene that an exponential fits as well."""
    for offset in (0.0, 1.0):
        t = [0.05 * k for k in range(401)]
        norms = [1 + max(x - offset, 0.0) ** power * math.exp(swing * math.sin(5 * x)) for x in t]
        for count in (41, 101, 401):
            law = find_law(t[:count], norms[:count], 2.0)
            assert law.name != "exponential" and not math.isfinite(law.horizon), (offset, count)


def test_a_growth_that_ends_is_extrapolated_by_no_exponential() -> None:
    t = [0.25 * k for k in range(401)]
    for fold in (2.0, 5.0, 9.0):
        law = find_law(t, [math.exp(min(x, fold)) for x in t], 100.0)
        assert law.name != "exponential" and not math.isfinite(law.horizon), fold


def test_an_exponential_is_seen_where_it_ends_later_and_where_it_is_beyond_rounding() -> None:
    t = [0.25 * k for k in range(401)]
    law = find_law(t, [math.exp(min(x, 20.0)) for x in t], 10.0)
    assert law.name == "exponential" and law.rate == pytest.approx(1.0) and law.until == 20.0
    law = find_law(t, [math.exp(2 * x) for x in t], 10.0)
    assert law.seen and law.horizon == pytest.approx(math.log(0.01 * 2**53) / 2, abs=0.25)


def test_the_disk_grows_by_a_power_and_chaos_by_an_exponential() -> None:
    """Runs from theta = 1.2 and 1.2 + 1e-8 of the disk part 540-fold by t = 100, 1180-fold at most by t = 200."""
    disk = look("rolling_disk")
    assert disk.sensitivity is not None and disk.sensitivity.law.name == "power"
    assert 0.5 < disk.sensitivity.law.rate < 1.5 and disk.sensitivity.law.until == pytest.approx(50)
    assert any("fitted from t = 5 to 50 s" in line for line in lines(disk))
    assert any("far beyond the scene" in line for line in lines(disk))
    for name, low, high in (("chaotic", 0.08, 0.2), ("double_pendulum", 0.7, 1.6)):
        found = look(name).sensitivity
        assert found is not None and found.law.name == "exponential" and low < found.law.rate < high
        assert math.isfinite(found.law.horizon)


def test_an_unstable_rest_has_its_exponential() -> None:
    text = "nhc: 1\nsystem: top\ncoordinates: [a]\nT: a'^2/2\nV: 9*cos(a)\nscenes: {rest: {initial: {a: 0}, time: [0, 1.5]}}\n"
    found = stability(Source("top.yaml", text), PLAIN).sensitivity
    assert found is not None and found.law.name == "exponential" and found.law.rate == pytest.approx(3.0, rel=1e-3)
    assert found.law.seen and found.law.horizon == pytest.approx(math.log(0.01 * 2**53) / 3, abs=0.5)


def test_a_forced_oscillator_has_no_law_of_growth(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """x'' = -4 x + cos t: perturbations are turned, never more, so that nothing can be said of when rounding is seen."""
    path = tmp_path / "forced.yaml"
    path.write_text(
        "nhc: 1\nsystem: forced\ncoordinates: [x]\nT: x'^2/2\nV: 2*x^2\nforces: {x: cos(t)}\n"
        "scenes: {beat: {initial: {x: 0.5}, time: [0, 20]}}\n"
    )
    assert main(["stability", str(path)]) == 0
    out = capsys.readouterr().out
    assert "no law: no steady growth" in out and "not known without a law" in out
    assert main(["stability", str(path), "--json"]) == 0
    growth = json.loads(capsys.readouterr().out)["sensitivity"]
    assert growth["law"] == "none" and growth["rate"] is None and growth["horizon"] is None


SHEARS = """nhc: 1
system: shears
coordinates: [x, y, a]
T: (x'^2 + y'^2 + a'^2)/2
V: -100*a
constraints: ["x' = 0", "cos(a)*x' + sin(a)*y' = 0"]
scenes: {close: {initial: {a: 1e-5 + 50*0.13729^2, a': -13.729}, time: [0, 0.3]}}
"""


def test_distances_are_looked_for_between_rows() -> None:
    """Two edges close to 1e-5 within a millisecond, where no row is: then their unit vectors' smallest singular value is known."""
    found = stability(Source("shears.yaml", SHEARS), Question(lengths=1))
    (rank,) = (d for d in found.distances if d.kind == "constraints")
    assert rank.least == pytest.approx(math.sqrt(2) * math.sin(0.5e-5), rel=1e-3) and min(rank.series) > 2 * rank.least
    assert rank.t == pytest.approx(0.13729, abs=1e-4)


SWING = """nhc: 1
system: swing
coordinates: [a, y]
T: (a'^2 + y'^2)/2
V: -100^2*cos(a) + 0.05^2*y^2/2
scenes: {a: {initial: {a: 3, y: 1}, time: [0, 14]}}
"""


def test_what_decays_as_fast_as_it_grows_is_not_stiff() -> None:
    """A pendulum beside a slow spring decays by exp(-100 t) at its top, and leaves it as fast."""
    found = stability(Source("swing.yaml", SWING), Question(lengths=1))
    text = "\n".join(lines(found))
    assert found.stiffness is not None and found.stiffness > 1000
    assert "not stiff: accuracy asks for shorter steps still" in text and "take radau5" not in text


HELD = """nhc: 1
system: held
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: 2^2*y^2/2 + 1e4*(x - y)^2/2
forces: {x: -1000*(x' - y'), y: 1000*(x' - y')}
scenes: {a: {initial: {x: 1, y: 1, y': 0.5}, time: [0, 10]}}
"""


def test_stability_that_limits_steps_a_little_is_said() -> None:
    """dop853 takes 3142 steps of 6.3 times the fastest time of decay, radau5 half as many."""
    found = stability(Source("held.yaml", HELD), Question(lengths=1))
    assert found.held and "stability limits the steps, but those of radau5 are not 10 times" in "\n".join(lines(found))


def test_rounding_is_no_decay() -> None:
    found = stability(Source("swing.yaml", SWING.replace("a: 3", "a: 0.1")), Question(lengths=1))
    assert (
        found.spectrum is not None
        and found.spectrum.decay == 0.0
        and len(set(np.diff(found.spectrum.times).round(12))) == 1
    )


def test_distances_see_the_singular_dependent_choice() -> None:
    """The sleigh turns by more than a quarter: solving for y' becomes singular, the adapted coframe never."""
    found = {d.kind: d for d in look("chaplygin_sleigh").distances}
    assert found["dependent"].least < 0.05 and found["frame"].least > 0.99 and found["constraints"].least > 0.99


def test_a_scene_that_fails_leaves_what_can_be_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Voronec's equations on a fixed block that the sleigh crosses: exit 3 with the reason, and the table so far."""
    page = tmp_path / "sleigh.html"
    assert main(["stability", "chaplygin_sleigh", "-f", "voronec", "-o", str(page)]) == 3
    assert "the run goes on with" in page.read_text()
    out, err = capsys.readouterr()
    assert "not done" in out and "the determinant vanishes here" in err
    assert "the run goes on with voronec solved for x'" in out and "leave `--formulation` out" in err


@pytest.mark.slow
def test_what_a_run_does_is_said_where_something_is_weak(tmp_path_factory: pytest.TempPathFactory) -> None:
    """A skater of one's own with a fixed block, drag in syrup, and a system that is sound."""
    folder = tmp_path_factory.mktemp("own")
    skater, syrup = folder / "skater.yaml", folder / "syrup.yaml"
    skater.write_text(forced(SKATER, "x").text.replace("[0, 12]", "[0, 1.15]"))
    syrup.write_text(SYRUP.replace("FORCE", "-2e4*(x' - cos(t))").replace("10]", "1]"))
    weak = stability(read(str(skater)), Question(lengths=1), Options(formulation="voronec"))
    assert not weak.failed and weak.conduct == ()  # it ends just before its block is weak
    weak = stability(read(str(skater)), Question(lengths=1), Options(formulation="multipliers"))
    assert weak.conduct == () and not any(d.used for d in weak.distances if d.kind == "dependent")
    stiff = stability(read(str(syrup)), Question(lengths=1))
    assert any("the run goes on with radau5" in line for line in stiff.conduct)
    assert "what `nhc run` does on this scene" in "\n".join(lines(stiff)) and "take radau5" in "\n".join(lines(stiff))
    assert look("chaplygin_sleigh").conduct == ()


def test_pictures_leave_out_what_cannot_be_read() -> None:
    found = look("chaplygin_sleigh")
    (drift, *_) = [chart for chart in list_charts(found) if chart.title.startswith("drift by dop853")]
    assert [series.label for series in drift.series] == ["T + V"]  # the slip stays at rounding
    assert all(len(series.x) <= 300 for series in drift.series)


def test_numbers_and_axes_have_the_units_of_the_spec() -> None:
    found = look("rolling_disk", Question(about="theta=pi/2", sweep=("w_n", 1.0, 4.0, 4), lengths=1))
    text = "\n".join(lines(found))
    for part in (
        "  eigenvalue [1/s]  ",
        "along the scene [1/s]\n",
        "stable step [s]: ",
        "until t = 5 s by",
        "at t = 4.05 s\n",
        "along w_n [rad/s]\n",
        "  roll_x  0, 0 ",
    ):
        assert part in text
    axes = {chart.x.label for chart in list_charts(found)}
    assert {"w_n [rad/s]", "t [s]", "real part [1/s]"} <= axes
    assert "real parts: growth" in {chart.title for chart in list_charts(found)}  # nothing is left out of it


def test_a_drift_is_relative_to_what_the_quantity_is(tmp_path: Path) -> None:
    """On Kepler's ellipse of eccentricity 0.9 slopes at the pericentre times sizes at the apocentre are 22 times the energy."""
    path = tmp_path / "kepler.yaml"
    path.write_text(
        "nhc: 1\nsystem: kepler\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nV: -1/sqrt(x^2 + y^2)\n"
        "scenes: {ellipse: {initial: {x: 0.1, y': 4.358898943540674}, time: [0, 6.283185307179586]}}\n"
    )
    run = stability(read(str(path)), Question(lengths=2), Options()).runs[1]
    energy, momentum = run.drifts

    def slope(y: np.ndarray) -> np.ndarray:
        return np.concatenate([y[2:], -y[:2] / np.hypot(y[0], y[1]) ** 3])

    y, h = np.array([0.1, 0.0, 0.0, 4.358898943540674]), run.step
    seen = [y]
    for _ in range(round(4 * math.pi / h)):
        a = slope(y)
        b = slope(y + h / 2 * a)
        c = slope(y + h / 2 * b)
        y = y + h / 6 * (a + 2 * b + 2 * c + slope(y + h * c))
        seen.append(y)
    x, z, u, v = np.array(seen).T
    kinetic, area = (u**2 + v**2) / 2, x * v - z * u
    total = kinetic - 1 / np.hypot(x, z)
    # rows between the steps are interpolated, which shows at the pericentre
    assert 0.5 < energy.last / float(abs(total - total[0]).max() / kinetic[0]) < 2
    assert 0.5 < momentum.last / float(abs(area - area[0]).max() / area[0]) < 2


def test_a_drift_is_told_by_its_ratio() -> None:
    """A run cannot show that an error is bounded."""
    told = {
        (first, last, relative): judge(Drift("x", "energy", relative, first, last, 1e-14, (first, last)))
        for first, last, relative in (
            (2e-6, 3e-6, True),
            (2e-6, 5e-6, False),
            (0.0, 1e-9, True),
            (1e-15, 9e-15, True),
            (1e-6, 1.23e-4, True),
        )
    }
    assert list(told.values()) == [
        "1.5 times as large",
        "grows, 2.5 times as large, absolute",
        "grows, from zero",
        "rounding",
        "grows, 120 times as large",
    ]


def test_json_and_page(tmp_path_factory: pytest.TempPathFactory, capsys: pytest.CaptureFixture[str]) -> None:
    page = tmp_path_factory.mktemp("page") / "p.html"
    assert main(["stability", "pendulum", "--json", "-o", str(page), "--long", "2"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["schema"] == "nhc.stability/1" and {x["method"] for x in data["steps"]} == set(METHODS)
    text = page.read_text()
    assert text.count("<svg") >= 4 and "nan" not in text.lower().replace("nhc", "")
    assert main(["stability", "pendulum", "-o", str(page)]) == 1


@pytest.mark.parametrize("arguments", [["pendulum"], ["--atlas"]])
def test_without_numpy_the_packages_are_named(
    arguments: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    hide_numpy(monkeypatch)
    assert main(["stability", *arguments]) == 2
    error = capsys.readouterr().err
    assert "needs numpy" in error and "`python -m pip install numpy scipy`" in error


def test_the_interpreted_model_gives_the_same() -> None:
    """Without a compiler: shorter runs, the same findings."""
    slow = look("pendulum", Question(compiled=False, lengths=1))
    fast = look("pendulum", Question(lengths=1))
    assert not slow.bench.model.compiled
    assert slow.sensitivity is not None and fast.sensitivity is not None
    assert slow.sensitivity.plain == pytest.approx(fast.sensitivity.plain, rel=1e-5)
    for a, b in zip(slow.limits, fast.limits, strict=True):
        assert a.predicted == b.predicted or a.predicted == pytest.approx(b.predicted, rel=1e-6)


def test_a_question_about_what_is_not_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["stability", "pendulum", "--scene", "nowhere"]) == 2
    assert "no scene `nowhere`" in capsys.readouterr().err
    assert main(["stability", "pendulum", "--sweep", "nothing=0:1"]) == 2
    assert main(["stability", "pendulum", "--sweep", "theta=1:0"]) == 2
    assert main(["stability", "bead_on_rod", "--about", "r=5", "--hold", "r=5", "--sweep", "Omega=1:2"]) == 3


@pytest.mark.slow
def test_a_scene_that_leads_its_formulation_astray_is_studied_with_multipliers() -> None:
    """A crank leaves the range declared for it, where the velocities chosen there become singular; nobody asked for them."""
    text = """nhc: 1
system: crank
coordinates: {c: {range: [0.2, 1.2]}, b: {}, s: {range: [1.5, 3]}}
T: (c'^2 + b'^2 + s'^2)/2
holonomic: ["cos(c) + 2*cos(b) - s = 0", "sin(c) - 2*sin(b) = 0"]
scenes: {turn: {initial: {s: 3, c': 4}, time: [0, 3]}}
"""
    found = stability(Source("crank.yaml", text), Question(lengths=1))
    assert not found.failed and found.bench.formulation.name == "multipliers"
    assert any("studied with multipliers: the scene ends at t = " in note for note in found.bench.notes)
    assert any("the run goes on with" in note for note in found.conduct)


ORBIT = """
nhc: 1
system: orbit
coordinates: [r, phi, z]
parameters: {{GM: {gm!r}}}
T: (r'^2 + r^2*phi'^2 + z'^2)/2
V: -GM/r*(1 - z^2/(2*r^2))
scenes: {{go: {{initial: {{r: {r!r}, phi': {rate!r}}}, time: [0, {end!r}]}}}}
"""


@pytest.mark.slow
def test_an_orbit_is_the_same_in_metres_and_in_radii(tmp_path: Path) -> None:
    """Sizes of components that differ by 1e18, and two that stay zero, make no growth and hide no drift."""
    found = []
    for length, time in ((1.0, 1.0), (1.5e11, 5e6), (1e-9, 1e-9)):
        numbers = {"gm": length**3 / time**2, "r": length, "rate": 1.1 / time, "end": 9.0 * time}
        spec = tmp_path / "orbit.yaml"
        spec.write_text(ORBIT.format(**numbers))
        source = read(str(spec))
        found.append((stability(source, Question(), Options()), time))
    first, _ = found[0]
    assert first.sensitivity is not None
    for other, time in found[1:]:
        assert other.sensitivity is not None and other.motion is not None and first.motion is not None
        assert other.sensitivity.norms == pytest.approx(first.sensitivity.norms, rel=1e-3)
        assert other.sensitivity.law.name == first.sensitivity.law.name
        assert other.sensitivity.law.horizon / time == first.sensitivity.law.horizon == math.inf
        assert other.stiffness == pytest.approx(first.stiffness, rel=1e-3, abs=1e-9)
        by_step = {limit.method: limit for limit in first.limits}
        assert all(
            x.measured / time == pytest.approx(by_step[x.method].measured, rel=0.05)
            for x in other.limits
            if x.method in ("dop853", "dopri5", "rk4")
        )
        for a, b in zip(first.runs[1].drifts, other.runs[1].drifts, strict=True):
            assert a.what == b.what and 0.3 < max(b.series) / max(a.series) < 3 and max(a.series) > 1e-9
        made, r = other.motion.linearisation, other.motion.linearisation.steady.y[0]
        swings = {round(abs(x) * math.sqrt(r**3 / other.bench.job.p[0]), 9) for x in eigenvalues(made)}
        assert swings == {1.0} and made.family == 1


def test_growth_of_a_slow_scene_and_of_one_that_is_over_at_once() -> None:
    t = [0.25e9 * k for k in range(41)]
    law = find_law(t, [1 + 0.1 * math.exp(1.5e-9 * x) for x in t], 10e9)
    assert law.name == "exponential" and law.rate == pytest.approx(1.5e-9, rel=0.05) and 20e9 < law.horizon < 26e9
    assert find_law([1e-300 * k for k in range(41)], [1.0] * 41, 40e-300).horizon == math.inf


def test_a_state_beside_the_scene_may_be_out_of_the_domain(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A ten thousandth of what x comes to is more than it starts at, and sqrt(x) has no value there."""
    spec = tmp_path / "edge.yaml"
    spec.write_text(
        "nhc: 1\nsystem: edge\ncoordinates: [x]\nT: x'^2/2\nV: -sqrt(x)\nscenes: {s: {initial: {x: 1e-5}, time: [0, 5]}}\n"
    )
    assert main(["stability", str(spec)]) == 0
    assert "drift until t = 50 by dop853" in capsys.readouterr().out


def test_a_drag_without_a_slope_at_rest() -> None:
    """c v sqrt(v^2) has the slope 0 there, which its derivative as it is written does not tell: 0/0."""
    text = "nhc: 1\nsystem: parachute\ncoordinates: [x, z]\nT: (x'^2 + z'^2)/2\nV: 9.81*z + x^2\ndefine: {v: sqrt(x'^2 + z'^2)}\n"
    drag = "forces: {x: -v*x', z: -v*z'}\nscenes: {drop: {initial: {x: 1}, time: [0, 4]}}\n"
    found = stability(Source("parachute.yaml", text + drag), PLAIN)
    assert found.spectrum is not None and found.spectrum.times[0] > 0.0 and len(found.spectrum.times) > 2
    assert found.sensitivity is not None and {name for name, _ in found.missing} <= {"steady motion"}
