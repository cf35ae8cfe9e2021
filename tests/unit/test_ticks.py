"""Axes tell their values: labels and note together give back each tick, and every label has room."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from itertools import pairwise

import pytest

from nhc.report.drawing import shorten
from nhc.report.svg import LEAST, LEFT, Axis, Chart, Series, draw, find_frame, legend_rows, make_room
from nhc.report.ticks import Scale, linear_scale, log_scale

LENGTH = 600.0
MOST = 6  # letters beside an axis: they do not reach its name
RANGES = [
    *((0.0, 1.0), (0.0, 1e5), (0.0, 99999.0), (-1e200, 1e200), (1e-9, 3e-9), (-0.07, 0.0), (20.0, 21.0), (-4.0, 1e-30)),
    *((1.05499998, 1.05500004), (1e6, 1e6 + 1e-3), (9.99999956e-8, 9.999999995e-8), (-1.0000001, -1.0)),
    *((123456.0, 123460.0), (99999.0, 100001.0), (-1e-290, 1e-280), (1e22, 1.0001e22)),
]


def told(scale: Scale) -> list[Fraction]:
    """The values that a reader takes from the labels and the note."""
    power, added = 0, Fraction(0)
    for part in scale.note.replace("- ", "-").replace("+ ", "").split():
        if part.startswith("×1e"):
            power = int(part[3:])
        else:
            added = Fraction(part)
    return [Fraction(text) * Fraction(10) ** power + added for _, text in scale.ticks]


@pytest.mark.parametrize("exact", [False, True])
@pytest.mark.parametrize("ends", RANGES)
def test_labels_tell_the_values(ends: tuple[float, float], exact: bool) -> None:
    scale = linear_scale(*ends, LENGTH, 6, exact)
    values = told(scale)
    assert len(values) >= 3 and values == sorted(set(values))
    span = scale.high - scale.low
    for (place, text), value in zip(scale.ticks, values, strict=True):
        assert len(text) <= MOST
        assert abs(place / LENGTH - float((value - Fraction(scale.low)) / Fraction(span))) < 1e-3  # half a pixel


def test_zero_has_no_sign() -> None:
    scale = linear_scale(999999.999975, 1e6, LENGTH)
    assert scale.note == "×1e-5 + 1000000" and [text for _, text in scale.ticks][-3:-1] == ["-0.5", "0"]


@pytest.mark.parametrize("value", [0.0, -0.0, 5.0, 1e-7, -3e-300, 5e-324, 1e300, 0.1])
def test_a_constant_stands_inside(value: float) -> None:
    """Also one that rounding moves: its steps of a unit in the last place are no picture."""
    for end in (value, math.nextafter(value, math.inf)):
        scale = linear_scale(value, end, LENGTH)
        assert scale.low < value < scale.high and 0.2 < scale.place(value) / LENGTH < 0.8
        assert len(scale.ticks) >= 3


def test_few_decades_have_ticks_between() -> None:
    assert [text for _, text in log_scale(1e-3, 0.1, LENGTH).ticks] == [
        "1e-3",
        "2e-3",
        "5e-3",
        "1e-2",
        "2e-2",
        "5e-2",
        "1e-1",
    ]
    assert [text for _, text in log_scale(1e-20, 1.0, LENGTH).ticks] == [f"1e{k}" for k in range(-20, 1, 2)]


def test_what_overflows_leaves_an_axis() -> None:
    scale = linear_scale(-1.7e308, 1.7e308, LENGTH)
    assert math.isfinite(scale.low) and len(scale.ticks) >= 3


def test_a_note_is_drawn() -> None:
    chart = Chart("c", Axis("t", exact=True), Axis("energy [J]"), (Series("energy", [0, 1], [1.05499998, 1.05500004]),))
    assert f'<text x="{LEFT:.2f}" y="25.00" text-anchor="start" fill="#222222">×1e-8 + 1.055</text>' in draw(chart)


def test_readings_keep_apart_what_the_picture_keeps_apart() -> None:
    late = [1e6 + 1e-5 * k for k in range(100)]
    assert len(set(shorten(late))) == 100 and max(abs(a - b) for a, b in zip(late, shorten(late), strict=True)) < 1e-9
    assert len(set(shorten([0.5, 0.5 + 1e-16, 0.5 - 1e-16]))) == 1  # rounding


@pytest.mark.parametrize("end", [12000.0, -12000.0, 100.5])
def test_the_last_time_is_not_cut(end: float) -> None:
    """Its label stands about the end of the axis, half of it beyond."""
    chart = Chart("c", Axis("t", exact=True), Axis("x"), (Series("x", [end - abs(end) / 3, end], [0, 1]),))
    places = re.findall(
        r'<text x="([0-9.]+)" y="[0-9.]+" text-anchor="middle" fill="#222222">(-?[0-9.]+)</text>', draw(chart)
    )
    assert places and all(float(x) + 3.75 * len(text) <= chart.width for x, text in places)


def test_a_long_legend_leaves_the_plot_its_room() -> None:
    names = [f"a_long_name_of_a_coordinate_number_{k}" if k % 2 else f"q{k}" for k in range(40)]
    series = tuple(Series(name, (0.0, 1.0), (0.0, 1.0 + k)) for k, name in enumerate(names))
    chart = make_room(Chart("", Axis("t"), Axis("value"), series, 760, 340))
    rows = legend_rows(chart)
    assert find_frame(chart, len(rows)).y.length >= LEAST
    assert make_room(chart) == chart
    for row in rows:
        for (_, text, left), (_, _, right) in pairwise(row):
            assert left + 31 + 7.1 * len(text) < right, "a name reaches the line of the next one"
    few = Chart("", Axis("t"), Axis("value"), series[:3], 760, 340)
    assert make_room(few) == few
