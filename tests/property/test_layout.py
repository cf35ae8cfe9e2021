"""Lines of limited width: nothing is lost, no line is wider than it has to be, and there is an end."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nhc.emit.layout import LAST, Piece, fill, total
from tests.property.expressions import QUIET

pieces = st.builds(
    lambda width, breaks: Piece("x" * width, float(width), breaks),
    st.integers(1, 14),
    st.sampled_from([0, 0, 1, 2, 3, LAST + 1]),
)


@QUIET
@given(st.lists(pieces, max_size=25), st.integers(3, 25), st.integers(3, 25))
def test_lines_are_the_pieces_and_fit(run: list[Piece], first: int, rest: int) -> None:
    lines = fill(run, float(first), float(rest))
    assert "".join(lines) == "".join(piece.text for piece in run)
    # the runs between all places where a line may end
    starts = [0, *(k for k, piece in enumerate(run) if piece.breaks and k), len(run)]
    widths = {sum(len(piece.text) for piece in run[:a]): total(run[a:b]) for a, b in pairwise(starts)}
    at = 0
    for number, line in enumerate(lines):
        limit = first if number == 0 else rest
        assert not line or at in widths  # it starts where one may
        assert len(line) <= limit or len(line) == widths[at]  # a single run may be too wide
        at += len(line)


def test_a_run_without_a_place_to_break_is_one_line() -> None:
    assert fill([Piece("a" * 30, 30.0), Piece("b" * 30, 30.0)], 20.0, 20.0) == ["a" * 30 + "b" * 30]
    assert fill([], 20.0, 20.0) == [""]


@pytest.mark.parametrize(("depths", "wanted"), [((1, 2), "aaaaaaaa bbbbcccc"), ((2, 1), "aaaaaaaabbbb cccc")])
def test_a_line_ends_where_parentheses_are_least_deep(depths: tuple[int, int], wanted: str) -> None:
    run = [Piece("a" * 8, 8.0), Piece("bbbb", 4.0, depths[0]), Piece("cccc", 4.0, depths[1])]
    assert fill(run, 14.0, 14.0) == wanted.split()


def test_what_opens_a_line_stands_in_its_place() -> None:
    run = [Piece("a" * 8, 8.0), Piece("b" * 8, 8.0, 1, "*" + "b" * 8)]
    assert fill(run, 10.0, 10.0) == ["a" * 8, "*" + "b" * 8]
    assert fill(run, 20.0, 20.0) == ["a" * 8 + "b" * 8]
