"""Arguments and options that several verbs share."""

from __future__ import annotations

import click

from nhc.cli.specs import complete_spec

# nhc.language.FORMULATIONS again, which takes too long to import for a help text; a test holds them equal
FORMULATIONS = ("auto", "newton", "lagrange", "euler-lagrange", "chaplygin", "voronec", "multipliers")


def split_names(context: click.Context, parameter: click.Parameter, value: str | None) -> tuple[str, ...]:
    """The names of ``a,b``; an option that is given names something."""
    names = tuple(name.strip() for name in (value or "").split(",") if name.strip())
    if value is not None and not names:
        raise click.BadParameter("it names nothing; leave it out, or write `a,b`", context, parameter)
    return names


spec_argument = click.argument("spec", shell_complete=complete_spec)
specs_argument = click.argument("specs", metavar="SPEC...", nargs=-1, required=True, shell_complete=complete_spec)
formulation_option = click.option(
    "--formulation",
    "-f",
    type=click.Choice(FORMULATIONS),
    default=None,
    help="The formulation to derive, in place of the spec's own.",
)
json_option = click.option("--json", "as_json", is_flag=True, help="Print JSON with a versioned schema.")
explain_option = click.option("--explain", is_flag=True, help="Say what was found out on the way, and why.")
output_option = click.option("-o", "output", metavar="FILE", help="Write to FILE in place of stdout (`-`).")
anew_option = click.option("--anew", is_flag=True, help="Derive anew, whatever an earlier run has kept.")
