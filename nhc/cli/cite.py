"""``nhc cite``: where it all comes from."""

from __future__ import annotations

import click

from nhc.cli.options import output_option, spec_argument, verb
from nhc.cli.specs import open_spec
from nhc.cli.write import deliver


@verb("cite", "nhc cite chaplygin_sleigh")
@spec_argument
@output_option
@click.option("--force", is_flag=True, help="Replace the file after `-o` when it exists.")
def command(spec: str, output: str | None, force: bool) -> int:
    """List the literature behind a spec and its equations."""
    source = open_spec(spec)
    from nhc.pipeline import cite

    deliver(cite(source), output, force=force, fitted=True)
    return 0
