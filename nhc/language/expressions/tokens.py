"""The words of an expression."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from nhc.diagnostics import Span
from nhc.language.expressions.loanwords import meant_sign
from nhc.language.expressions.names import continues_name, fold, is_folded, starts_name
from nhc.records import record

LONGEST = 100_000  # characters of an expression
_NUMBER = re.compile(r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")
_SIGNS = {"**": "^", "+": "+", "-": "-", "*": "*", "/": "/", "^": "^", "(": "(", ")": ")", ",": ",", "=": "="}
# a name in ASCII, a number that nothing continues, or a sign: nearly every word; the others are read with more care
_PLAIN = re.compile(
    r"[ \t\n\r]*(?:([A-Za-z_][A-Za-z_0-9]*)(?![A-Za-z_0-9]|[^\x00-\x7f])"
    r"|((?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)(?![0-9._eE])"
    r"|(\*\*|[-+*/^(),=]))"
)


class ExpressionError(Exception):
    """The first mistake of one expression; becomes a diagnostic in ``parse``."""

    def __init__(self, code: str, message: str, span: Span, help: str) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.span = span
        self.help = help


@record
class Token:
    """``kind`` is number, name, prime, end, or the sign itself; ``text`` is folded for names."""

    kind: str
    text: str
    start: int
    end: int


Locate = Callable[[int, int], Span]  # offsets in the expression's text -> place in the source


def tokenise(text: str, locate: Locate) -> Iterator[Token]:
    """Yield the words of a text and an ``end``; raises ``ExpressionError`` at what is no word."""
    at, size = 0, len(text)
    while at < size:
        found = _PLAIN.match(text, at)
        if found is not None:
            at, group = found.end(), found.lastindex or 0
            word = found.group(group)
            kind = "name" if group == 1 else "number" if group == 2 else _SIGNS[word]
            yield Token(kind, word, found.start(group), at)
            continue
        character = text[at]
        if character in " \t\n\r":
            at += 1
            continue
        token = _next(text, at, locate)
        yield token
        at = token.end
    yield Token("end", "", size, size)


def _next(text: str, at: int, locate: Locate) -> Token:
    character = text[at]
    found = _NUMBER.match(text, at)
    if found:
        return _number(text, at, found.end(), locate)
    if character in "'\u2032":
        return Token("prime", "'", at, at + 1)
    sign = "**" if text.startswith("**", at) else character
    if sign in _SIGNS:
        return Token(_SIGNS[sign], sign, at, at + len(sign))
    if starts_name(character):
        end = at + 1
        while end < len(text) and continues_name(text[end]):
            end += 1
        name = fold(text[at:end])
        if is_folded(name):
            return Token("name", name, at, end)
    shown = character if character.isprintable() else f"U+{ord(character):04X}"
    raise ExpressionError("E0201", f"unexpected character `{shown}`", locate(at, at + 1), meant_sign(text, at))


def _number(text: str, start: int, end: int, locate: Locate) -> Token:
    if end < len(text) and (text[end] == "." or (text[end] == "_" and text[end + 1 : end + 2].isdigit())):
        while end < len(text) and (text[end] in "._" or text[end].isdigit()):
            end += 1
        help = "write digits with at most one `.`"
        if text[start:end].count(".") < 2:
            help = f"write the digits of a number without `_`: `{text[start:end].replace('_', '')}`"
        raise ExpressionError("E0210", f"malformed number `{text[start:end]}`", locate(start, end), help)
    return Token("number", text[start:end], start, end)
