r"""Expressions inside of a sentence: ``theta*b - r*(p_R - p_L)/2`` as :math:`\theta\,b - r\,(p_R - p_L)/2`.

Supported: what the findings of ``nhc check --explain`` are written in, the spec language and, besides, factors side by side
(``x p_y``), momenta ``p*_v`` and ``dT/dx'``, equations and lists.
Not supported, on purpose: stacked fractions, which would push lines apart.
"""

from __future__ import annotations

import re

from nhc.emit.latex.math import COMMANDS
from nhc.emit.latex.names import Names
from nhc.emit.latex.spelling import escape_breakable
from nhc.program.sheets.model import Mark

_TOKEN = re.compile(
    r"(?P<partial>dT/d(?P<rate>[^\W\d]\w*)')|(?P<momentum>p\*_(?P<quasi>\w+))|(?P<name>[^\W\d]\w*'*)"
    r"|(?P<number>\d+(?:\.\d+)?)|(?P<sign>[-+*/^=(),])|(?P<cut>\u2026)|(?P<blank> +)"
)
_PLAIN = ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "min", "max", "sqrt")
_FUNCTIONS = {name: f"\\{name}" for name in _PLAIN} | COMMANDS | {"abs": r"\operatorname{abs}"}
_WORDS = {"const": r"\text{const}"} | _FUNCTIONS
_COMMANDS = frozenset(_FUNCTIONS.values())
_OPERANDS = frozenset(("partial", "momentum", "name", "number"))
_BARE = frozenset(rf"\{name}" for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh"))
"""Functions that need no parentheses about a name, and whose exponent stands before it."""


def print_inline(text: str, names: Names) -> str:
    """The expression as inline math; as plain text where it holds a character that no expression has."""
    tokens, at = list[tuple[str, str]](), 0
    while at < len(text):
        found = _TOKEN.match(text, at)
        if found is None:
            return escape_breakable(text)
        kind, at = str(found.lastgroup), found.end()
        kind = {"rate": "partial", "quasi": "momentum"}.get(kind, kind)
        tokens.append((kind, _spell(kind, found, names)))
    return f"${''.join(_join(tokens))}$"


def _spell(kind: str, found: re.Match[str], names: Names) -> str:
    match kind:
        case "partial":
            return rf"\partial T/\partial {names.print_mark(Mark(found['rate'], dots=1))}"
        case "momentum":
            return f"{{{names.print_mark(Mark('p', (found['quasi'],), star=True))}}}"  # it has a raised star: a power needs braces
        case "name":
            bare = found["name"].rstrip("'")
            if bare == "dt" and bare not in names.names:
                return bare
            if bare.startswith("p_") and bare not in names.names and bare[2:] in names.names:
                return names.print_mark(Mark("p", (bare[2:],)))
            return _WORDS.get(bare) or names.print_mark(Mark(bare, dots=len(found["name"]) - len(bare)))
        case "cut":
            return r"\dots"
        case _:
            return found[0]


def _join(tokens: list[tuple[str, str]]) -> list[str]:
    """Products get a thin space, exponents braces, roots their bar."""
    shown: list[str] = []
    k = 0
    while k < len(tokens):
        kind, text = tokens[k]
        after = tokens[k + 1] if k + 1 < len(tokens) else ("", "")
        if text in ("^", r"\sqrt") and after[1] == "(":
            end = _closing(tokens, k + 1)
            shown += [text, "{", *_join(tokens[k + 2 : end]), "}"]
            k = end
        elif text in _BARE and (bare := _bare(tokens, k)):
            length, exponent = bare
            shown += [text, exponent, " ", tokens[k + 2][1]]
            k += length - 1
        elif text == "^":
            length = 2 if after[1] == "-" else 1
            shown += ["^{", *(part for _, part in tokens[k + 1 : k + 1 + length]), "}"]
            k += length
        elif text == "*":
            shown.append(r"\,")
        elif kind != "blank":
            spaced = f" {text} " if text in ("+", "-", "=") else f"{text} " if text == "," else text
            shown.append(spaced)
        elif (
            k
            and tokens[k - 1][1] not in _COMMANDS
            and _ends(tokens[k - 1])
            and (after[0] in _OPERANDS or after[1] == "(")
        ):
            shown.append(r"\,")
        k += 1
    return shown


def _bare(tokens: list[tuple[str, str]], k: int) -> tuple[int, str] | None:
    r"""How many tokens make the ``cos(a)`` or ``cos(a)^2`` that may be \cos a, and its exponent; None where it may not."""
    texts = [text for _, text in tokens[k + 1 : k + 5]]
    if texts[:1] != ["("] or texts[2:3] != [")"] or tokens[k + 2][0] != "name":
        return None
    length, exponent = 4, ""
    if texts[3:] == ["^"]:
        kind, power = tokens[k + 5] if k + 5 < len(tokens) else ("", "")
        if kind != "number":
            return None
        length, exponent = 6, f"^{{{power}}}"
    rest = [token for token in tokens[k + length :] if token[0] != "blank"]
    if rest[:1] == [("sign", "*")]:
        del rest[0]
    kind, text = rest[0] if rest else ("", "")
    followed = text in ("(", "/") or (kind in _OPERANDS and text not in _COMMANDS)
    return None if followed else (length, exponent)


def _ends(token: tuple[str, str]) -> bool:
    """Whether an operand may end with the token."""
    return token[0] in _OPERANDS or token[1] == ")"


def _closing(tokens: list[tuple[str, str]], start: int) -> int:
    """The place of the parenthesis that closes the one at ``start``; the end where none does."""
    depth = 0
    for k in range(start, len(tokens)):
        depth += {"(": 1, ")": -1}.get(tokens[k][1], 0)
        if depth == 0:
            return k
    return len(tokens)
