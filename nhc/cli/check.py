"""``nhc check``: every error of every spec, and what was found out about it."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import click

from nhc.cli.options import explain_option, json_option, specs_argument, verb
from nhc.cli.specs import open_spec
from nhc.cli.terminal import Exit, Failure, put_json, put_text, wants_colour
from nhc.records import record

if TYPE_CHECKING:
    from nhc.diagnostics import Diagnostic, Source


@verb("check", "nhc check kart.yaml", "nhc check chaplygin_sleigh --explain")
@specs_argument
@explain_option
@click.option("--concise", is_flag=True, help="One line for each finding: file:line:column: severity[code]: message.")
@json_option
def command(specs: tuple[str, ...], explain: bool, concise: bool, as_json: bool) -> int:
    """Check specs and say what was found.

    Prints all errors and warnings of each SPEC; the exit code is 1 when any has an error, 2 when any cannot be read.
    """
    if concise and as_json:
        raise click.UsageError("`--concise` and `--json` exclude one another")
    results = [_check_one(spec, explain=explain or as_json) for spec in specs]
    if as_json:
        put_json("nhc.check/1", {"specs": [_as_json(result) for result in results]})
    else:
        for result in results:
            _print(result, explain=explain, concise=concise)
    return max(result.exit for result in results)


@record
class Result:
    """What ``check`` says of one spec; ``facts`` as lines, ``data`` as a tree for JSON."""

    source: Source
    exit: Exit
    diagnostics: tuple[Diagnostic, ...]
    facts: tuple[str, ...]
    data: Mapping[str, Any]


def _check_one(spec: str, *, explain: bool) -> Result:
    """What is found of one spec: also that it is not there."""
    from nhc.diagnostics import SpecError
    from nhc.pipeline import check

    try:
        source = open_spec(spec)
        report = check(source, explain=explain)
    except SpecError as error:
        return Result(error.source, Exit.USAGE if error.is_usage else Exit.FAILED, error.diagnostics, (), {})
    except Failure as failure:
        return _report_missing(spec, failure)
    return Result(source, Exit.DONE, tuple(report.diagnostics), tuple(report.facts), report.data)


def _report_missing(spec: str, failure: Failure) -> Result:
    from nhc.diagnostics import Diagnostic, Label, Severity, Source, Span

    found = Diagnostic("E0101", Severity.ERROR, failure.message, (Label(Span(0, 0)),), failure.notes, failure.help)
    return Result(Source(spec, ""), failure.exit, (found,), (), {})


def _print(result: Result, *, explain: bool, concise: bool) -> None:
    from nhc.diagnostics import render_concise, render_text

    if concise:
        sys.stdout.write(render_concise(result.source, result.diagnostics))
        return
    if result.diagnostics:
        put_text(render_text(result.source, result.diagnostics, wants_colour(sys.stdout)))
        put_text("")
    put_text(f"{result.source.path}: {_count(result.diagnostics) or 'ok'}")
    if explain:
        for fact in result.facts:
            put_text(f"  {fact}", 4)


def _count(diagnostics: tuple[Diagnostic, ...]) -> str:
    """Return ``1 error, 2 warnings``, empty for none."""
    from nhc.diagnostics import Severity

    parts = []
    for severity in Severity:
        number = sum(diagnostic.severity is severity for diagnostic in diagnostics)
        if number:
            parts.append(f"{number} {severity.value}{'s' if number > 1 else ''}")
    return ", ".join(parts)


def _as_json(result: Result) -> dict[str, Any]:
    from nhc.diagnostics import to_json

    tree = to_json(result.source, result.diagnostics)
    return {"ok": result.exit is Exit.DONE, **tree, "facts": list(result.facts), "data": result.data}
