"""Reading: files, YAML, and where each character stands."""

from __future__ import annotations

import io
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nhc.diagnostics import Bag, Source, SpecError, render_text
from nhc.language import decode, read
from nhc.language.expressions.numbers import exact
from nhc.language.yaml_tree.nodes import Items, Table, Text
from nhc.language.yaml_tree.reader import read_nodes

START = "nhc: 1\nsystem: s\ncoordinates: [x, y]\nparameters: {m: 1}\nT: m*(x'^2 + y'^2)\n"


def refused(source: Source) -> list[str]:
    with pytest.raises(SpecError) as caught:
        decode(source)
    return [found.code for found in caught.value.diagnostics]


def test_read_a_file(tmp_path: Path) -> None:
    path = tmp_path / "a.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: 1\r\nb: \xce\xb8\rc: 3\n")
    source = read(path)
    assert (source.path, source.text) == (str(path), "a: 1\nb: \u03b8\nc: 3\n")


def test_read_standard_input(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"a: 1\n")))
    assert read("-") == Source("<stdin>", "a: 1\n")


@pytest.mark.parametrize(
    ("data", "code", "place"),
    [
        (b"x" * (1 << 20) + b"x", "E0103", (1, 1)),
        ("\u03b8\r\nab".encode() + b"\xff\xfe", "E0102", (2, 3)),
        (None, "E0101", (1, 1)),
    ],
    ids=["large", "latin", "missing"],
)
def test_files_that_are_refused(tmp_path: Path, data: bytes | None, code: str, place: tuple[int, int]) -> None:
    path = tmp_path / "a.yaml"
    if data is not None:
        path.write_bytes(data)
    with pytest.raises(SpecError) as caught:
        read(path)
    (found,) = caught.value.diagnostics
    assert found.code == code
    assert caught.value.source.position(found.span.start) == place
    assert render_text(caught.value.source, caught.value.diagnostics)


def test_the_largest_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "a.yaml"
    path.write_bytes(b"#" * (1 << 20))
    assert len(read(path).text) == 1 << 20


def test_a_folder_is_no_spec(tmp_path: Path) -> None:
    with pytest.raises(SpecError) as caught:
        read(tmp_path)
    assert [found.code for found in caught.value.diagnostics] == ["E0101"]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1", 1),
        ("010", 10),
        ("-1.50", Fraction(-3, 2)),
        ("+.5", Fraction(1, 2)),
        ("1e-3", Fraction(1, 1000)),
        ("1.E2", 100),
        ("0e999999999999", 0),
    ],
)
def test_numbers_are_read_exactly(text: str, value: Fraction) -> None:
    assert exact(text) == value


@pytest.mark.parametrize("text", ["", ".", "e3", "0x1F", "1,5", "nan", ".inf", "1 2", "\u0661"])
def test_texts_that_are_no_numbers(text: str) -> None:
    assert exact(text) is None


@pytest.mark.parametrize("text", ["1e999", "1e-999", "1" * 401, "1e99999999999", "0." + "0" * 900 + "1"])
def test_numbers_that_no_double_holds(text: str) -> None:
    with pytest.raises(ValueError, match=r"digits|large|small"):
        exact(text)


@pytest.mark.parametrize("name", ["y", "n", "on", "off", "no", "yes", "true", "t1", "null_"])
def test_yaml_words_are_names(name: str) -> None:
    text = f"nhc: 1\nsystem: s\ncoordinates: [{name}]\nparameters: {{m: 010}}\nT: m*{name}'^2\n"
    spec = decode(Source("a", text))
    assert [coordinate.name for coordinate in spec.coordinates] == [name]
    assert spec.parameters[0].value == 10


@pytest.mark.parametrize(
    "scalar",
    [
        "x + bad*y",
        "'x + bad*y'",
        '"x + bad*y"',
        "'x''+ bad*y'",
        "x +\n    bad*y",
        ">-\n    x +\n    bad*y",
        "|\n    x +\n\n    bad*y",
        '"x +\n  bad*y"',
    ],
)
def test_places_inside_of_scalars_are_exact(scalar: str) -> None:
    text = f"{START}forces:\n  x: {scalar}\n"
    with pytest.raises(SpecError) as caught:
        decode(Source("a", text))
    (found,) = caught.value.diagnostics
    assert text[found.span.start : found.span.end] == "bad"


@pytest.mark.parametrize("escape", ["\\u0062", "\\x62", "\\U00000062"])
def test_places_behind_escapes_are_exact(escape: str) -> None:
    text = START + f'forces:\n  x: "x\\t+ {escape}ad"\n'
    with pytest.raises(SpecError) as caught:
        decode(Source("a", text))
    (found,) = caught.value.diagnostics
    assert text[found.span.start : found.span.end] == f"{escape}ad"


def test_a_scalar_with_an_escaped_line_end_is_marked_as_a_whole() -> None:
    text = START + 'forces:\n  x: "x + \\\n    \\u0062ad"\n'
    with pytest.raises(SpecError) as caught:
        decode(Source("a", text))
    (found,) = caught.value.diagnostics
    assert text[found.span.start : found.span.end] == '"x + \\\n    \\u0062ad"'
    assert found.message == "unknown name `bad`"


def test_nodes_know_their_places() -> None:
    text = "# \u6f22\U0001f600\na: [b, {c: 'd'}]\n"
    root = read_nodes(Source("a", text), Bag(Source("a", text)))
    assert isinstance(root, Table)
    items = root.get("a")
    assert isinstance(items, Items)
    assert text[items.span.start : items.span.end] == "[b, {c: 'd'}]"
    inner = items.items[1]
    assert isinstance(inner, Table)
    leaf = inner.get("c")
    assert isinstance(leaf, Text)
    assert (leaf.value, text[leaf.span.start : leaf.span.end], leaf.plain) == ("d", "'d'", False)
    assert root.get("z") is None


@pytest.mark.parametrize("text", ["[" * 100_000, "{a: " * 50_000, "- " * 50_000, "? " * 1000, "&a " * 50])
def test_deep_files_are_refused_without_a_crash(text: str) -> None:
    assert refused(Source("a", text))


def test_many_definitions_in_a_chain() -> None:
    chain = "".join(f"  d{index}: d{index + 1} + 1\n" for index in range(3000)) + "  d3000: x\n"
    spec = decode(Source("a", f"{START}define:\n{chain}outputs:\n  v: d0'\n"))
    assert [definition.name for definition in spec.definitions][:2] == ["d3000", "d2999"]


@given(st.text(max_size=80))
@settings(max_examples=200, deadline=None)
def test_random_text_never_crashes(text: str) -> None:
    with pytest.raises(SpecError):
        decode(Source("a", text))


FRAGMENTS = (
    *(
        "x: ",
        "x'",
        "- ",
        "\n",
        "\n  ",
        "[",
        "]",
        "{",
        "}",
        ",",
        "'",
        '"',
        "&a ",
        "*a",
        "!!t ",
        "#",
        "|",
        ">",
        "2x",
        "=",
    ),
    *("~", "T: ", "U: ", "define:", "forces:", "constraints:", "scenes:", "holonomic:", "outputs:", "dependent:", "()"),
    *(
        "time: [0, 1]",
        "initial: ",
        "need: ",
        "parameters: ",
        "unit: kg",
        "value: ",
        "range: ",
        "1e-3",
        "\t",
        "pi",
        "(x)'",
    ),
)
fragments = st.sampled_from(FRAGMENTS)


@given(st.lists(fragments, max_size=25).map("".join))
@settings(max_examples=400, deadline=None)
def test_random_specs_never_crash(text: str) -> None:
    source = Source("a", START + text)
    try:
        decode(source)
    except SpecError as error:
        assert error.diagnostics
        assert render_text(source, error.diagnostics)
