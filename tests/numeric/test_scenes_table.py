"""The table of docs/scenes.md is what the compiler finds."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from benchmarks import scenes
from nhc.language import decode, read
from nhc.pipeline import Options, reduce_scene
from tests.support import GALLERY, ROOT, spec_path

DOCUMENT = ROOT / "docs" / "scenes.md"
PART = re.compile(r"^<!-- generated: scenes -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)


def rows() -> list[str]:
    heads = ("system", "scene", "needs", "n full", "n reduced", "constants", "ops full", "ops reduced")
    found = [f"| {' | '.join(heads)} |", "|" + "---|" * len(heads)]
    for name in GALLERY:
        source = read(str(spec_path(name)))
        for scene in decode(source).scenes:
            made = reduce_scene(source, Options(scene=scene.name))
            needs = ", ".join(f"`{entry.name}`" for entry in scene.need)
            sizes = f"{len(made.full_state)} | {len(made.reduction.kept)} | {len(made.reduction.constants) or ''}"
            found.append(f"| {name} | {scene.name} | {needs} | {sizes} | {made.full_operations} | {made.operations} |")
    return found


def test_the_table_of_scenes_is_as_measured(golden: Callable[[Path, str], None]) -> None:
    text = DOCUMENT.read_text()
    made = "<!-- generated: scenes -->\n" + "\n".join(rows()) + "\n<!-- end -->"
    new, count = PART.subn(lambda _: made, text)
    assert count == 1
    golden(DOCUMENT, new)


@pytest.mark.slow
def test_the_measured_table_has_the_scenes_whose_model_is_another_one() -> None:
    """Times move from machine to machine; which scenes stand there and how many equations they have does not."""
    text = scenes.PART.search(DOCUMENT.read_text())
    assert text is not None
    shown = re.findall(r"^\| (\w+) \| (\w+) \| (\d+) → (\d+) \|", text.group(), re.MULTILINE)
    pairs = scenes.list_pairs()
    assert shown == [(p.name, p.scene, str(len(p.full.y)), str(len(p.reduced.y))) for p in pairs]
    assert all(len(p.reduced.y) <= len(p.full.y) for p in pairs)


@pytest.mark.slow
def test_what_a_scene_saves_is_measured() -> None:
    (pair,) = [p for p in scenes.list_pairs() if (p.name, p.scene) == ("suslov", "rates_only")]
    full, reduced = scenes.measure(pair)
    assert 0 < reduced.rhs < full.rhs and 0 < reduced.run < full.run
    assert scenes.print_row(pair, full, reduced).startswith("| suslov | rates_only | 5 → 2 | ")
