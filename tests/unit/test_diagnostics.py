"""Diagnostics: places, rendering, codes and their pages."""

from __future__ import annotations

import json
from importlib.resources import files

import pytest

from nhc.diagnostics import (
    TITLES,
    Bag,
    Diagnostic,
    Label,
    Severity,
    Source,
    Span,
    SpecError,
    codes,
    nearest,
    page,
    render_concise,
    render_text,
    to_json,
)


def make(text: str, part: str, message: str = "wrong", code: str = "E0302") -> tuple[Source, Diagnostic]:
    start = text.index(part)
    return Source("a.yaml", text), Diagnostic(
        code, Severity.ERROR, message, (Label(Span(start, start + len(part)), "here"),)
    )


def test_positions_count_from_one() -> None:
    source = Source("a", "ab\ncd\n")
    assert [source.position(offset) for offset in (0, 1, 2, 3, 5, 6, 99)] == [
        *((1, 1), (1, 2), (1, 3), (2, 1), (2, 3), (3, 1), (3, 1))
    ]
    assert (source.line(2), source.line(3), source.line(4)) == ("cd", "", "")


def test_text_shows_the_line_and_the_mark() -> None:
    text = "T: x\nU: tehta + 1\n"
    source, diagnostic = make(text, "tehta")
    diagnostic = Diagnostic(
        "E0302",
        Severity.ERROR,
        "unknown name `tehta`",
        (*diagnostic.labels, Label(Span(0, 1), "there")),
        ("a note",),
        ("did you mean `theta`?",),
    )
    assert render_text(source, [diagnostic]) == (
        "error[E0302]: unknown name `tehta`\n"
        " --> a.yaml:2:4\n"
        "  |\n"
        "1 | T: x\n"
        "  | - there\n"
        "2 | U: tehta + 1\n"
        "  |    ^^^^^ here\n"
        "  |\n"
        "  = note: a note\n"
        "  = help: did you mean `theta`?\n"
    )


@pytest.mark.parametrize(
    ("line", "part", "column", "width"),
    [
        ("ab cd", "cd", 3, 2),
        ("\tcd", "cd", 4, 2),
        ("\u6f22\u5b57 cd", "cd", 5, 2),  # two characters of two columns
        ("e\u0301 cd", "cd", 2, 2),  # a combining accent takes no column
        ("a \u6f22 b", "\u6f22", 2, 2),
    ],
)
def test_the_mark_stands_under_what_it_marks(line: str, part: str, column: int, width: int) -> None:
    source, diagnostic = make(line, part)
    lines = render_text(source, [diagnostic]).splitlines()
    assert lines[4] == "  | " + " " * column + "^" * width + " here"


def test_no_control_character_reaches_the_terminal() -> None:
    source, diagnostic = make("a\x1b[31m \u202ecd", "cd", "bad \x1b[0m")
    assert "\x1b" not in render_text(source, [diagnostic])
    assert "\u202e" not in render_text(source, [diagnostic])
    assert "\x1b" not in render_concise(source, [diagnostic])


def test_a_long_line_is_cut_around_the_mark() -> None:
    source, diagnostic = make("a" * 5000 + " cd " + "b" * 5000, "cd")
    lines = render_text(source, [diagnostic]).splitlines()
    assert max(map(len, lines)) < 160
    at = lines[4].index("^")
    assert lines[3][at : at + 2] == "cd"


def test_a_mark_of_several_lines_ends_with_the_first() -> None:
    source, diagnostic = make("ab cd\nef gh\n", "cd\nef")
    assert render_text(source, [diagnostic]).splitlines()[4] == "  |    ^^ here"


def test_a_file_that_was_not_read_has_no_lines() -> None:
    diagnostic = Diagnostic("E0101", Severity.ERROR, "cannot read", (Label(Span(0, 0)),), (), ("look",))
    assert render_text(Source("a.yaml", ""), [diagnostic]) == (
        "error[E0101]: cannot read\n --> a.yaml:1:1\n  = help: look\n"
    )


def test_colour_is_asked_for() -> None:
    source, diagnostic = make("ab", "b")
    assert "\x1b[1;31merror" in render_text(source, [diagnostic], colour=True)
    assert "\x1b" not in render_text(source, [diagnostic])


def test_concise_and_json() -> None:
    source, diagnostic = make("ab\ncd ef", "ef")
    assert render_concise(source, [diagnostic]) == "a.yaml:2:4: error[E0302]: wrong\n"
    place = {"line": 2, "column": 4, "end_line": 2, "end_column": 6}
    assert json.loads(json.dumps(to_json(source, [diagnostic]))) == {
        "nhc_diagnostics": 1,
        "file": "a.yaml",
        "diagnostics": [
            {
                "code": "E0302",
                "severity": "error",
                "message": "wrong",
                **place,
                "labels": [{**place, "text": "here"}],
                "notes": [],
                "help": [],
            }
        ],
    }


def test_a_bag_raises_everything_in_order() -> None:
    bag = Bag(Source("a", "abc"))
    bag.warning("W0410", "second", Span(1, 2), help=("do",))
    bag.raise_if_errors()
    bag.error("E0302", "third", Span(2, 3), help=("do",))
    bag.error("E0302", "first", Span(0, 1), help=("do",))
    bag.error("E0302", "first", Span(0, 1), help=("do",))
    with pytest.raises(SpecError) as caught:
        bag.raise_if_errors()
    assert [found.message for found in caught.value.diagnostics] == ["first", "second", "third"]
    assert str(caught.value).splitlines()[0] == "a:1:1: E0302: first"
    with pytest.raises(KeyError):
        bag.error("E9999", "no such code", Span(0, 0), help=("do",))


def test_the_nearest_name_is_near_or_none() -> None:
    assert nearest("tehta", ["x", "theta"]) == "theta"
    assert nearest("M", ["x", "m"]) == "m"
    assert nearest("quark", ["x", "theta"]) is None


def test_each_code_has_a_page_and_each_page_a_code() -> None:
    folder = files("nhc.diagnostics").joinpath("pages")
    pages = sorted(entry.name.removesuffix(".md") for entry in folder.iterdir() if entry.name.endswith(".md"))
    assert pages == sorted(codes())
    for code in codes():
        text = page(code)
        assert text.startswith(f"# {code}: {TITLES[code]}\n")
        assert [line for line in text.splitlines() if line.startswith("## ")] == ["## Why", "## Wrong", "## Instead"]
    assert page("e0302") == page("E0302")
    with pytest.raises(KeyError):
        page("E0000")
