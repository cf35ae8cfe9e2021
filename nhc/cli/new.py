"""``nhc new``: a first spec."""

from __future__ import annotations

import re
from pathlib import Path

import click

from nhc.cli.options import verb
from nhc.cli.terminal import Failure, say
from nhc.cli.write import deliver


@verb("new", "nhc new kart")
@click.argument("name")
@click.option("-o", "output", metavar="DIR|FILE", help="Where to write; default: NAME.yaml here, `-`: stdout.")
@click.option("--force", is_flag=True, help="Replace a file that exists.")
def command(name: str, output: str | None, force: bool) -> int:
    """Write a first spec to start from.

    The spec is called NAME and stands in NAME.yaml; it compiles and runs as it is.
    """
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name):
        stem = re.sub(r"\.ya?ml$", "", name.lower())  # the file's name in place of the system's
        proposal = re.sub(r"[^a-z0-9]+", "_", stem).strip("_0123456789") or "my_system"
        raise Failure(
            f"`{name}` is no name for a system: lower case letters, digits and `_`, a letter first",
            [f"nhc new {proposal}"],
        )
    from nhc.language.template import template

    target = output or "."
    if target != "-" and (Path(target).is_dir() or not Path(target).suffix):
        target = str(Path(target) / f"{name}.yaml")
    deliver(template(name), target, force=force)
    if target != "-":
        page = Path(target).with_suffix(".html")
        say(f"next: `nhc check {target}`, `nhc run {target} -o {page}`")
        say("`nhc schema -o nhc.schema.json`, in the same folder, lets an editor complete and check it")
    return 0
