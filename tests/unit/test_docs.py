"""The documents say what the code does: tables from the code, examples that are checked, links that lead somewhere."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from benchmarks.chart import draw_scaling
from nhc.cli.entry import VERBS
from nhc.language.expressions.names import DOT, FUNCTIONS, PI, TIME
from nhc.language.schema import reference_table
from nhc.language.units.dimensions import _PREFIXES, _UNITS, _UNPREFIXED, ONE, Dimension, show
from nhc.version import __version__
from tests.unit.fragments import ROOT, Block, blocks, complete, errors_in, is_whole

DOCUMENTS = sorted((ROOT / "docs").rglob("*.md"))
PROSE = [ROOT / "README.md", ROOT / "CHANGELOG.md", *DOCUMENTS]
LANGUAGE = ROOT / "docs" / "language.md"
INDEX = ROOT / "docs" / "index.md"
EXAMPLES = [
    pytest.param(path, block, id=f"{path.stem}-{number}")
    for path in PROSE
    for number, block in enumerate(blocks(path.read_text()))
    if block.is_yaml
]


def _code(names: list[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def _function_table() -> str:
    rows = ["| arguments | functions |", "|---|---|"]
    for count in sorted({most for _, most in FUNCTIONS.values()}):
        rows.append(f"| {count} | {_code([name for name, (_, most) in FUNCTIONS.items() if most == count])} |")
    return "\n".join(rows) + "\n"


def _unit_table() -> str:
    by_dimension: dict[Dimension, list[str]] = {}
    for name, dimension in _UNITS.items():
        by_dimension.setdefault(dimension, []).append(name)
    rows = ["| dimension | units |", "|---|---|"]
    for dimension, names in by_dimension.items():
        rows.append(f"| {'none' if dimension == ONE else show(dimension)} | {_code(names)} |")
    prefixes = _code(list(dict.fromkeys(_PREFIXES)))
    without = _code(list(_UNPREFIXED))
    return (
        "\n".join(rows)
        + f"\n\nAll but {without} take a prefix: {prefixes}; `t` only one that enlarges.  `Ω` is `ohm`.\n"
    )


def _reserved() -> str:
    return f"the functions, {_code(list(FUNCTIONS))} and `{DOT}`, the constant `{PI}`, and the time `{TIME}`.\n"


def _decisions() -> str:
    paths = sorted((ROOT / "docs" / "decisions").glob("*.md"))
    titles = [path.read_text().splitlines()[0].removeprefix("# ") for path in paths]
    return "\n".join(f"- [{title}](decisions/{path.name})" for title, path in zip(titles, paths, strict=True))


REFERENCE: dict[str, Callable[[], str]] = {
    "keys": reference_table,
    "reserved": _reserved,
    "functions": _function_table,
    "units": _unit_table,
}


@pytest.mark.parametrize(
    ("path", "makers"), [(LANGUAGE, REFERENCE), (INDEX, {"decisions": _decisions})], ids=["language", "index"]
)
def test_generated_parts(path: Path, makers: dict[str, Callable[[], str]], golden: Callable[[Path, str], None]) -> None:
    text = path.read_text()
    assert re.findall(r"^<!-- generated: (\w+) -->$", text, re.MULTILINE) == list(makers)
    for name, make in makers.items():
        part = re.compile(rf"^<!-- generated: {name} -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)
        made = f"<!-- generated: {name} -->\n{make().strip()}\n<!-- end -->"
        text, count = part.subn(lambda _, made=made: made, text)
        assert count == 1
    golden(path, text)


def test_examples_exist() -> None:
    assert len(EXAMPLES) >= 8


@pytest.mark.parametrize(("path", "block"), EXAMPLES)
def test_examples_of_specs_are_good(path: Path, block: Block) -> None:
    assert ("fragment" in block.words) is not is_whole(block.text), "a part of a spec is marked `yaml fragment`"
    expected = [word for word in block.words if re.fullmatch(r"E\d{4}", word)]  # an example of a mistake names it
    assert errors_in(complete(block.text)) == expected


def test_a_bad_example_would_be_seen() -> None:
    assert errors_in(complete("V: tehta\n")) == ["E0302"]


def _anchors(path: Path) -> set[str]:
    """The names that headings get on a forge, and those that are written out."""
    text = path.read_text()
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    made = {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}
    return made | set(re.findall(r'<a id="([^"]+)">', text))


@pytest.mark.parametrize("path", PROSE, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_links_lead_somewhere(path: Path) -> None:
    text = re.sub(r"^```.*?^```$", "", path.read_text(), flags=re.MULTILINE | re.DOTALL)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if target.startswith(("http://", "https://")):
            continue
        file, _, anchor = target.partition("#")
        there = (path.parent / file) if file else path
        assert there.exists(), f"dead link {target}"
        assert not anchor or anchor in _anchors(there), f"no heading for {target}"


@pytest.mark.parametrize(
    "path",
    [ROOT / "docs/architecture.md", *sorted((ROOT / "docs/decisions").glob("*.md"))],
    ids=lambda path: path.name,
)
def test_code_that_is_named_is_there(path: Path) -> None:
    """A file by the end of its path, a folder from the top of the project or of the package."""
    folders = [ROOT / name for name in ("nhc", "tests", "benchmarks", "templates", "specs")]
    files = [
        f"/{file.relative_to(ROOT).as_posix()}" for folder in folders for file in folder.rglob("*") if file.is_file()
    ]
    files += [f"/{file.name}" for file in ROOT.glob("*.py")]
    for name in re.findall(r"`((?:\w+/)*\w+\.(?:py|jinja)|(?:\w+/)+\w+)`", path.read_text()):
        is_folder = (ROOT / name).is_dir() or (ROOT / "nhc" / name).is_dir()
        assert is_folder or any(file.endswith((f"/{name}", f"/{name}.py")) for file in files), f"no {name}"


def test_every_document_is_reachable_from_the_index() -> None:
    linked = re.findall(r"\]\(([^)#\s]+)", INDEX.read_text())
    names = [path.relative_to(ROOT / "docs").as_posix() for path in DOCUMENTS if path != INDEX]
    assert [name for name in names if name not in linked] == []


def test_the_citation_has_the_version() -> None:
    assert f"\nversion: {__version__}\n" in (ROOT / "CITATION.cff").read_text()


def test_every_verb_is_described() -> None:
    help = (ROOT / "docs" / "cli.md").read_text()
    assert [verb for verb in VERBS if f"| `nhc {verb}" not in help] == []


def test_the_chart_of_derivations_shows_the_table_beside_it() -> None:
    """Drawn anew from the page's milliseconds, which are rounded, the chart's points are where the file has them."""
    table = re.findall(r"^\| (trailers|snake) \|(.*) ms \|", (ROOT / "docs/performance.md").read_text(), re.MULTILINE)
    times = {
        family: dict(zip((5, 10, 20, 50, 100), (float(x) / 1e3 for x in row.replace("ms", "").split("|")), strict=True))
        for family, row in table
    }
    assert set(times) == {"trailers", "snake"}
    drawn, kept = (
        [(float(x), float(y)) for x, y in re.findall(r'<circle cx="([\d.]+)" cy="([\d.]+)"', text)]
        for text in (draw_scaling(times), (ROOT / "docs/derivation.svg").read_text())
    )
    assert len(drawn) == 10
    assert np.abs(np.array(drawn) - kept).max() < 1.5
