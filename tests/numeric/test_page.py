"""What the page of a run draws of energy, residuals and reactions, and how it sets units."""

from __future__ import annotations

import json
import re

import pytest

from nhc.diagnostics.source import Source
from nhc.report.page import list_charts, list_check_charts, make_page
from nhc.report.svg import Axis, Chart, Series, draw, legend_rows
from nhc.report.units import typeset_label, typeset_unit
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run

WAGON = """
nhc: 1
system: wagon
coordinates: {x: {unit: m}, y: {unit: m}, theta: {unit: rad}}
parameters: {m: {value: 2, unit: kg}, I: {value: 1, unit: "kg*m^2"}, F: {value: FORCE, unit: N}}
T: m/2*(x'^2 + y'^2) + I/2*theta'^2
forces: {x: F*cos(theta), y: F*sin(theta)}
constraints:
  - front_left_wheel: cos(theta)*y' - sin(theta)*x' = 0
  - rear_right_wheel: theta' = 0
scenes: {go: {initial: {theta: 0.3, x': 0.5}, time: [0, 4], need: [reactions, x]}}
"""


def follow(force: str) -> Trajectory:
    found = run(
        open_scene(Source("wagon.yaml", WAGON.replace("FORCE", force)), checks=True),
        Settings(points=20, compiled=False),
    )
    assert found.ended == "done"
    return found


def test_an_energy_that_is_not_conserved_is_drawn_itself_without_a_legend() -> None:
    found = follow("0.5")
    (chart, *_) = list_check_charts(found, ["the force on `x`"])
    assert (chart.y.log, chart.y.label, chart.y.unit, chart.title) == (
        False,
        "T + V [J]",
        "J",
        "energy, which is not conserved",
    )
    energy = [row[0] for row in found.checks]
    assert list(chart.series[0].y) == energy and energy[-1] > 2 * energy[0]
    assert legend_rows(chart) == []
    page = make_page(found)
    assert "energy, which is not conserved" in page and "relative change" not in page


def test_an_energy_that_is_a_column_already_is_not_drawn_again() -> None:
    text = WAGON.replace("FORCE", "0.5").replace("need: [reactions, x]", "need: [energy, x]")
    found = run(open_scene(Source("wagon.yaml", text), checks=True), Settings(points=20, compiled=False))
    assert not any("energy" in chart.title for chart in list_check_charts(found, ["the force on `x`"]))
    assert any("energy" in chart.y.label for chart in list_charts(found))


def test_a_conserved_energy_has_its_relative_change_without_a_legend() -> None:
    charts = [
        Chart("energy: change", Axis("t"), Axis("relative change", log=True), (Series("energy", [0, 1], [1, 2]),))
    ]
    assert legend_rows(charts[0]) == []
    page = make_page(follow("0"))
    assert "relative change at most" in page and "not conserved" not in page


def test_residuals_within_rounding_are_one_line() -> None:
    found = follow("0.5")
    quiet = [chart for chart in list_check_charts(found) if chart.title.startswith("residuals")]
    assert all([series.label for series in chart.series] in (["largest of all"], []) for chart in quiet)
    width = len(found.job.checks)
    residuals = [k for k, column in enumerate(found.job.checks) if column.group == "residual"]
    assert len(residuals) == 2

    def with_residuals(*values: float) -> list[str]:
        row = [1.0] * width
        for k, value in zip(residuals, values, strict=True):
            row[k] = value
        object.__setattr__(found, "checks", tuple(row for _ in found.times))
        (chart,) = [chart for chart in list_check_charts(found) if chart.title.startswith("residuals")]
        return [series.label for series in chart.series]

    assert with_residuals(1e-16, -3e-15) == ["largest of all"]
    assert with_residuals(1e-16, 1e-9) == ["front_left_wheel", "rear_right_wheel"]


def test_several_reactions_have_an_axis_of_their_name_and_units_are_set() -> None:
    found = follow("0.5")
    labels = [chart.y.label for chart in list_charts(found)]
    assert "x [m]" in labels
    assert set(labels) <= {"x [m]", "lambda_front_left_wheel [N]", "lambda_rear_right_wheel [N*m]", "reactions [N]"}
    page = make_page(found)
    assert "I\u00a0=\u00a01\u00a0kg\u00a0m²" in page and "kg*m^2" not in page and "N*m" not in page
    units = {chart["unit"] for chart in json.loads(re.findall(r'id="data">(.*?)</script>', page)[0])}
    assert not any("*" in unit for unit in units)


@pytest.mark.parametrize(
    ("unit", "shown"),
    [
        ("kg*m^2", "kg\u00a0m²"),
        ("m/s^2", "m/s²"),
        ("N*m*s/rad", "N\u00a0m\u00a0s/rad"),
        ("m^-1*s^12", "m⁻¹\u00a0s¹²"),
        ("kg*m^2/s^3", "kg\u00a0m²/s³"),
        ("m^(-2)", "m⁻²"),
        ("m^(1/2)", "m^(1/2)"),
        ("m^0.5", "m^0.5"),
        ("", ""),
    ],
)
def test_units_are_typeset(unit: str, shown: str) -> None:
    assert typeset_unit(unit) == shown


def test_labels_keep_their_names() -> None:
    assert typeset_label("a^2*b [kg*m^2]") == "a^2*b [kg\u00a0m²]"
    chart = Chart("", Axis("t [s]"), Axis("p [kg*m/s]"), (Series("p", [0, 1], [0, 1]),))
    assert "p [kg\u00a0m/s]<" in draw(chart)
