"""``nhc cite``: where it all comes from."""

from __future__ import annotations

import click

from nhc.cli.options import list_examples, output_option, spec_argument
from nhc.cli.specs import open_spec
from nhc.cli.write import deliver


@click.command("cite", epilog=list_examples("nhc cite chaplygin_sleigh"))
@spec_argument
@output_option
@click.option("--force", is_flag=True, help="Replace the file after `-o` when it exists.")
def command(spec: str, output: str | None, force: bool) -> int:
    """List the literature behind a spec and its equations."""
    source = open_spec(spec)
    from nhc.pipeline import cite

    deliver(cite(source), output, force=force, fitted=True)
    return 0
