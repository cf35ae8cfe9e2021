"""Titles of pictures stay in the picture, whatever a system is called, and every picture says what it shows."""

import re

import pytest

from nhc.report.marks import draw_title
from nhc.report.svg import Axis, Chart, Series, draw

WIDEST = 0.64  # of a bold letter, in sizes


@pytest.mark.parametrize("letters", [10, 60, 100, 1000])
def test_a_title_is_no_wider_than_its_picture(letters: int) -> None:
    found = re.search(r'font-size="([\d.]+)"[^>]*>([^<]*)<', draw_title(350, 20, "m" * letters, 700))
    assert found is not None
    size, text = float(found[1]), found[2]
    assert size >= 8 and len(text) * size * WIDEST <= 702
    assert (size == 17) == (letters == 10 or letters == 60) and ("…" in text) == (letters == 1000)


def test_a_picture_is_described() -> None:
    chart = Chart("a & b", Axis("t [s]"), Axis("value [m]"), (Series("x", [0, 1], [0, 1]), Series("y", [0, 1], [1, 0])))
    assert 'role="img" aria-label="a &amp; b: value [m] over t [s] (x, y)"' in draw(chart)


def test_few_values_are_marked_and_many_are_a_line() -> None:
    axis = Axis("t")
    for marked in (True, False):
        chart = Chart("", axis, axis, (Series("x", [0, 1, 2], [0, 1, 4], marked=marked),))
        assert draw(chart).count("<circle") == (3 if marked else 0)
