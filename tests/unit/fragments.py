"""Examples in documents: parts of specs, completed to whole specs, and what nhc says of them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import yaml

from nhc.diagnostics import Source, SpecError
from nhc.pipeline import check

ROOT = Path(__file__).resolve().parents[2]
BASE = {
    "nhc": "nhc: 1\n",
    "system": "system: example\n",
    "coordinates": "coordinates: [x, y, z, theta]\n",
    "parameters": "parameters: {m: 1, a: 2, b: 3, c: 0.5, g: 9.81, k: 4, l: 1.5, eps: 0.01}\n",
}
_SECTION = re.compile(r"^(\w+):", re.MULTILINE)
_BLOCK = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Block:
    """A fenced block: the words after its fence, its text, the heading that it stands under."""

    words: tuple[str, ...]
    text: str
    heading: str

    @property
    def is_yaml(self) -> bool:
        return self.words[:1] == ("yaml",)


def blocks(markdown: str) -> list[Block]:
    """The fenced blocks of a document, in their order."""
    found = []
    for match in _BLOCK.finditer(markdown):
        headings = re.findall(r"^#+ (.*)$", _BLOCK.sub("", markdown[: match.start()]), re.MULTILINE)
        found.append(Block(tuple(match.group(1).split()), match.group(2), headings[-1] if headings else ""))
    return found


def is_whole(text: str) -> bool:
    """Whether a text begins like a spec and goes on; one without any key stands for itself as well."""
    keys = _SECTION.findall(text)
    return not keys or (keys[0] == "nhc" and len(keys) > 1)


def complete(fragment: str) -> str:
    """The fragment with what it lacks of a spec above it; T is that of unit masses at the coordinates."""
    if is_whole(fragment):
        return fragment
    given = set(_SECTION.findall(fragment))
    above = "".join(text for key, text in BASE.items() if key not in given)
    if "T" not in given:
        squares = " + ".join(f"{name}'^2/2" for name in _coordinates(fragment))
        above += f"T: {squares}\n"
    return above + fragment


def _coordinates(fragment: str) -> list[str]:
    """The names of the fragment's coordinates, where they can be read; else those of the base."""
    try:
        tree = yaml.safe_load(fragment)
    except yaml.YAMLError:
        tree = None
    named = tree.get("coordinates") if isinstance(tree, dict) else None
    if not isinstance(named, list | dict):
        named = yaml.safe_load(BASE["coordinates"])["coordinates"]
    return [str(name) for name in named if str(name).isidentifier()] or ["x"]


def found_in(text: str) -> list[str]:
    """The codes of all errors and warnings of a spec."""
    try:
        report = check(Source("example.yaml", text))
    except SpecError as error:
        return [diagnostic.code for diagnostic in error.diagnostics]
    return [diagnostic.code for diagnostic in report.diagnostics]


def errors_in(text: str) -> list[str]:
    return [code for code in found_in(text) if code.startswith("E")]
