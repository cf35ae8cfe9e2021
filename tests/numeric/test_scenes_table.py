"""The table of docs/scenes.md is what the compiler finds."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

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


def test_table(golden: Callable[[Path, str], None]) -> None:
    text = DOCUMENT.read_text()
    made = "<!-- generated: scenes -->\n" + "\n".join(rows()) + "\n<!-- end -->"
    new, count = PART.subn(lambda _: made, text)
    assert count == 1
    golden(DOCUMENT, new)
