"""Every scenario of the atlas passes, and the document lists them all."""

from __future__ import annotations

import json
import math

import pytest

from nhc.cli.entry import main
from nhc.study.atlas.diagram import follow
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_system
from nhc.study.atlas.table import SCENARIOS, lines, markdown, tree
from tests.support import ROOT

CASES = [pytest.param(s, id=s.code, marks=[pytest.mark.slow] if s.slow else []) for s in SCENARIOS]


@pytest.mark.sample(4)
@pytest.mark.parametrize("scenario", CASES)
def test_scenario(scenario: Scenario) -> None:
    verdict = scenario.run()
    assert verdict.passed, "\n".join(lines([(scenario, verdict)]))
    assert math.isfinite(verdict.naive.number) and math.isfinite(verdict.nhc.number)


def test_the_wrong_motions_are_those_of_the_catalogue() -> None:
    """(x, y, theta) of the sleigh after 0.8 s, by three derivations."""
    from nhc.mechanics.certificates.claims import reference_claim, wrong_claims
    from nhc.mechanics.choosing.choose import applicable

    system = open_system("chaplygin_sleigh")
    claims = {w.claim.name: w.claim for w in wrong_claims(system, applicable(system))}
    expected = {
        "boxed_I_3_sign": (-0.5090079698, -0.2676699917, 0.9755106005),
        "lagrange_of_T_star": (-0.3368167944, -0.1712296654, 1.0725331098),
    }
    assert follow(system, reference_claim(system), 0.8)[0] == pytest.approx(
        (-0.0824013306, 0.0442491478, 1.1155387419), abs=1e-8
    )
    for name, end in expected.items():
        assert follow(system, claims[name], 0.8)[0] == pytest.approx(end, abs=1e-8)


def test_codes_are_unique_and_in_order() -> None:
    codes = [(int(s.code.strip("Cb")), s.code) for s in SCENARIOS]
    assert codes == sorted(set(codes)) and {number for number, _ in codes} == set(range(1, 17))


def test_a_failing_scenario_is_shown_and_counted() -> None:
    verdict = Verdict(Measure("a", 1.0), Measure("b", 2.0), "c", False)
    results = [(Scenario("C0", "t", "s", lambda: verdict), verdict)]
    assert "FAIL" in lines(results)[0] and lines(results)[-1] == "0 of 1 pass"
    assert "**fail**" in markdown(results) and tree(results)["scenarios"][0]["passed"] is False


def test_what_is_measured_stands_below_the_table() -> None:
    verdict = Verdict(Measure("a long text of the naive way", 1.0), Measure("what nhc does", 2.0), "1e-9", True)
    head, _, row, *below = markdown([(Scenario("C0", "t", "s", lambda: verdict), verdict)]).splitlines()
    assert (head, row) == ("| | failure | system | nhc |", "| C0 | t | `s` | pass |")
    assert below == [
        "",
        "**C0: t**",
        "",
        "- naive: a long text of the naive way",
        "- nhc: what nhc does",
        "- criterion: 1e-9",
    ]


def test_the_document_lists_every_scenario() -> None:
    text = (ROOT / "docs" / "stability.md").read_text()
    for s in SCENARIOS:
        (row,) = [line for line in text.splitlines() if line.startswith(f"| {s.code} |")]
        assert s.title in row and s.system in row and row.endswith("| pass |")


def test_a_failing_scenario_makes_the_verb_fail(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    verdict = Verdict(Measure("a", 1.0), Measure("b", 2.0), "c", False)
    monkeypatch.setattr("nhc.study.atlas.table.SCENARIOS", (Scenario("C0", "t", "s", lambda: verdict),))
    assert main(["stability", "--atlas", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["schema"] == "nhc.atlas/1"
    assert main(["stability"]) == 2
    assert main(["stability", "pendulum", "--atlas"]) == 2
