"""``nhc gallery``: the specs that come with nhc."""

from __future__ import annotations

from pathlib import Path

import click
from click.shell_completion import CompletionItem

from nhc.cli.options import json_option, verb
from nhc.cli.specs import gallery_paths, shelf_paths
from nhc.cli.terminal import Failure, put_json, put_text
from nhc.cli.write import deliver


def _complete(ctx: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    return [CompletionItem(name) for name in gallery_paths() if name.startswith(incomplete)]


@verb("gallery", "nhc gallery", "nhc gallery rolling_disk -o .")
@click.argument("name", required=False, shell_complete=_complete)
@click.option("-o", "output", metavar="DIR|FILE", help="With NAME: copy the spec there.")
@click.option("--force", is_flag=True, help="Replace a file that exists.")
@json_option
def command(name: str | None, output: str | None, force: bool, as_json: bool) -> int:
    """List the specs that come with nhc, print or copy one.

    Without NAME lists all of them; with NAME prints that spec.
    """
    paths = gallery_paths()
    if name is None:
        if output is not None:
            raise click.UsageError("`-o` copies one spec: name it")
        _list(paths, as_json)
        return 0
    if "/" in name:
        paths = shelf_paths()
    if name not in paths:
        from nhc.diagnostics import suggest

        raise Failure(f"no spec `{name}` in the gallery", [suggest(name, paths, "`nhc gallery` lists it")])
    text = paths[name].read_text(encoding="utf-8")
    if as_json:
        put_json("nhc.gallery/1", {"specs": [{"name": name, "about": _about(paths[name]), "text": text}]})
        return 0
    if output is not None and output != "-" and (Path(output).is_dir() or not Path(output).suffix):
        output = str(Path(output) / paths[name].name)
    deliver(text, output, force=force)
    return 0


def _list(paths: dict[str, Path], as_json: bool) -> None:
    abouts = {name: _about(path) for name, path in paths.items()}
    if as_json:
        put_json("nhc.gallery/1", {"specs": [{"name": name, "about": about} for name, about in abouts.items()]})
        return
    width = max(map(len, abouts), default=0)
    for name, about in abouts.items():
        put_text(f"{name:<{width}}  {about}".rstrip(), width + 2)


def _about(path: Path) -> str:
    """Return the first line of what the spec says about itself."""
    from nhc.language import decode, read

    return " ".join(decode(read(str(path))).about.split())
