"""Examples in documents: parts of specs, completed to whole specs, and what nhc says of them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import yaml

from nhc.diagnostics import Source, SpecError
from nhc.pipeline import check

ROOT = Path(__file__).resolve().parents[2]
SPECS = ROOT / "specs"
COORDINATES = ("x", "y", "z", "theta")
PARAMETERS = {"m": "1", "a": "2", "b": "3", "c": "0.5", "g": "9.81", "k": "4", "l": "1.5", "eps": "0.01"}
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
    """The fragment with what it lacks of a spec above it.

    Coordinates are those that occur in it, all of them where it has no T; T is that of unit masses at the coordinates;
    parameters are those of the table above whose names it does not declare itself.
    """
    if is_whole(fragment):
        return fragment
    given = set(_SECTION.findall(fragment))
    made = {"nhc": "1", "system": "example"}
    occurring = [name for name in COORDINATES if "T" not in given or re.search(rf"\b{name}\b", fragment)]
    made["coordinates"] = f"[{', '.join(occurring)}]"
    declared = re.split(r"^scenes:", fragment, flags=re.MULTILINE)[0]
    others = [name for name in PARAMETERS if not re.search(rf"(^|[{{,])\s*{name}:", declared, re.MULTILINE)]
    made["parameters"] = f"{{{', '.join(f'{name}: {PARAMETERS[name]}' for name in others)}}}"
    named = _coordinates(fragment) if "coordinates" in given else occurring
    made["T"] = " + ".join(f"{name}'^2/2" for name in named)
    return "".join(f"{key}: {value}\n" for key, value in made.items() if key not in given) + fragment


def _coordinates(fragment: str) -> list[str]:
    """The names of the fragment's own coordinates, where they can be read."""
    try:
        named = yaml.safe_load(fragment)["coordinates"]
    except yaml.YAMLError:
        named = COORDINATES
    return [name for name in named if isinstance(name, str) and name.isidentifier()] or ["x"]


def found_in(text: str) -> list[str]:
    """The codes of all errors and warnings of a spec."""
    try:
        report = check(Source("example.yaml", text))
    except SpecError as error:
        return [diagnostic.code for diagnostic in error.diagnostics]
    return [diagnostic.code for diagnostic in report.diagnostics]


def errors_in(text: str) -> list[str]:
    return [code for code in found_in(text) if code.startswith("E")]
