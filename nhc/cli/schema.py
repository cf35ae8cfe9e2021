"""``nhc schema``: what an editor needs to complete a spec."""

from __future__ import annotations

import json

import click

from nhc.cli.options import output_option, verb
from nhc.cli.write import deliver


@verb("schema", "nhc schema -o nhc.schema.json")
@output_option
@click.option("--force", is_flag=True, help="Replace the file after `-o` when it exists.")
def command(output: str | None, force: bool) -> int:
    """Print the JSON Schema of the spec language."""
    from nhc.language.schema import schema

    deliver(json.dumps(schema(), indent=2, ensure_ascii=False), output, force=force)
    return 0
