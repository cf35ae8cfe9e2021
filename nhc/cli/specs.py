"""From what a user types for SPEC to the text of a spec."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click
from click.shell_completion import CompletionItem

from nhc.cli.terminal import Failure, say

if TYPE_CHECKING:
    from nhc.diagnostics import Source


EXTENDS = "extends"  # the key; the language is large, and what is kept of a spec that stands alone is found without it
SHELVES = ("ladder", "bodies")


def gallery_paths() -> dict[str, Path]:
    """Return the gallery's specs by name, in alphabetical order."""
    from nhc.resources import find_specs

    return {path.stem: path for path in sorted(find_specs().glob("*.yaml"))}


def shelf_paths() -> dict[str, Path]:
    """Return the specs beside the gallery's, as ``shelf/name``: models that extend one another, and some by their bodies."""
    from nhc.resources import find_specs

    return {f"{shelf}/{path.stem}": path for shelf in SHELVES for path in sorted((find_specs() / shelf).glob("*.yaml"))}


def open_spec(spec: str) -> Source:
    """Return the text of ``spec``: a file, ``-`` for stdin, or the name of a gallery spec when no such file exists (a folder of
    that name may hold what was emitted from it).

    Raises ``nhc.diagnostics.SpecError`` for what cannot be read as text, ``Failure`` for an unknown name.
    """
    from dataclasses import replace

    gallery = gallery_paths() if "/" not in spec else shelf_paths()
    path = Path(spec)
    exists = bool(spec) and path.exists()  # the path of no name is the folder
    if spec == "-" or (exists and not (path.is_dir() and spec in gallery)):
        return _read(spec)
    if spec not in gallery:
        raise Failure(f"no file `{spec}`, and no spec of the gallery has that name", _advise(spec, list(gallery)))
    say(f"taking `{spec}` from the gallery")
    # the same name as of a copy, so that what is made from it does not depend on where nhc is installed
    return replace(_read(str(gallery[spec])), path=gallery[spec].name)


def _read(path: str) -> Source:
    from nhc.diagnostics.files import read_source

    source = read_source(path)
    if EXTENDS not in source.text:
        return source
    from nhc.language.reading import with_bases

    return with_bases(source)


def take_first_scene(source: Source, purpose: str, instead: str = "") -> str:
    """The name of the first scene, which is said.

    Where there is none, ``purpose`` says what it is for, and ``instead`` what else would do.
    """
    from nhc.language import decode

    scenes = decode(source).scenes
    if not scenes:
        advice = "add one under `scenes:`, with `initial:`, `time: [start, end]` and `need:`"
        raise Failure(f"this spec has no scene {purpose}", [*filter(None, [instead]), advice])
    say(f"taking the scene `{scenes[0].name}`")
    return scenes[0].name


def list_texts(source: Source) -> tuple[str, ...]:
    """Everything of a spec that an answer can depend on: its name and text, and those of what it extends."""
    return tuple(part for each in (source, *source.bases) for part in (each.path, each.text))


def complete_spec(ctx: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Offer files and the gallery's names to the shell."""
    names = [CompletionItem(name) for name in gallery_paths() if incomplete and name.startswith(incomplete)]
    return [*names, CompletionItem(incomplete, type="file")]


def _advise(spec: str, names: list[str]) -> list[str]:
    from nhc.diagnostics import nearest

    beside = Path(f"{spec}.yaml")
    if beside.is_file():
        return [f"write `{beside}`"]
    near = nearest(Path(spec).stem, names)
    advice = [f"did you mean the gallery's `{near}`?"] if near else []
    return [*advice, "`nhc gallery` lists the gallery, `nhc new NAME` writes a first spec"]
