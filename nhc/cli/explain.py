"""``nhc explain``: pages on diagnostics and on equations."""

from __future__ import annotations

import click
from click.shell_completion import CompletionItem

from nhc.cli.options import verb
from nhc.cli.terminal import Failure, put, put_text


def _complete(ctx: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    from nhc.diagnostics import codes
    from nhc.thesis.errata import ERRATA
    from nhc.thesis.registry import EQUATIONS

    return [CompletionItem(name) for name in (*codes(), *EQUATIONS, *ERRATA) if name.startswith(incomplete.upper())]


@verb("explain", "nhc explain E0302", "nhc explain I.2.15")
@click.argument("subject", metavar="[CODE|EQUATION]", required=False, shell_complete=_complete)
def command(subject: str | None) -> int:
    """Explain a diagnostic code or an equation number.

    CODE is what a message shows in brackets, such as E0302; EQUATION is a number of the thesis, such as I.4.9, or of one
    of its errata, such as E7.  Without one, lists all of them.
    """
    from nhc.diagnostics import TITLES, page, suggest

    code = (subject or "").strip().upper()
    if code in TITLES:
        _put_lines(page(code))
        return 0
    from nhc.thesis.errata import ERRATA
    from nhc.thesis.pages import equation_page, erratum_page
    from nhc.thesis.registry import EQUATIONS

    if not code:
        for known, title in TITLES.items():
            put_text(f"{known}   {title}", 8)
        put("")
        put_text(f"equations: {', '.join(EQUATIONS)}", 4)
        put_text(f"errata of the thesis: {', '.join(ERRATA)}", 4)
        return 0
    if code in ERRATA:
        _put_lines(erratum_page(code))
        return 0
    number = next((known for known in EQUATIONS if known.upper() == code.strip("()")), None)
    if number is None:
        advice = suggest(code, [*TITLES, *EQUATIONS, *ERRATA], "`nhc explain` lists all codes and equations")
        raise Failure(f"`{subject}` is no diagnostic code and no equation number", [advice])
    _put_lines(equation_page(number))
    return 0


def _put_lines(text: str) -> None:
    """Sentences and formulas are broken to the terminal's width, code is not."""
    fenced = False
    for line in text.rstrip("\n").split("\n"):
        fenced ^= line.startswith("```")
        (put if fenced or not line.strip() else put_text)(line)
