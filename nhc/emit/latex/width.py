"""How wide a formula is, without running TeX."""

from __future__ import annotations

import re
from functools import lru_cache

_NOTHING = (
    *(r"\dot", r"\ddot", r"\mathit", r"\mathrm", r"\mathtt", r"\ttfamily", r"\operatorname", r"\boldsymbol", r"\left"),
    *(r"\right", r"\text"),
)


@lru_cache(maxsize=16384)
def estimate(text: str) -> float:
    """The width of a formula without fractions, in points at ten points' size; rather too wide than too narrow."""
    width, small = 0.0, [1.0]
    for token in re.findall(r"\\[A-Za-z]+|\\.|[_^]\{|[{}]|[_^].|.", text):
        if token in ("_{", "^{"):
            small.append(small[-1] * 0.72)
        elif token == "{":
            small.append(small[-1])
        elif token == "}":
            if len(small) > 1:
                small.pop()
        else:
            width += _token_width(token) * small[-1]
    return width


def widest_group(text: str) -> float:
    """The width of the widest part in braces, such as what stands below a root: no line breaks there."""
    widest, depth, start = 0.0, 0, 0
    for found in re.finditer(r"\\.|[{}]", text):
        if found.group() == "{":
            start, depth = found.end() if depth == 0 else start, depth + 1
        elif found.group() == "}":
            depth -= 1
            widest = max(widest, estimate(text[start : found.start()])) if depth == 0 else widest
    return widest


def _token_width(token: str) -> float:
    if token in _NOTHING:
        return 0.0
    if token in (r"\sin", r"\cos", r"\ln", r"\exp", r"\sqrt"):
        return 13.5
    if token in (r"\sinh", r"\cosh", r"\tanh", r"\min", r"\max"):
        return 21.0
    if token in (r"\arcsin", r"\arccos", r"\arctan"):
        return 29.0
    if token == r"\,":
        return 1.7
    if token in ("+", "-", "="):
        return 12.5
    if token in (r"\wedge", r"\neq"):
        return 11.5
    if token in (r"\Bigl", r"\Bigr", r"\bigl", r"\bigr"):
        return 2.0
    if token in "().,|;[]'":
        return 4.0
    if token.isdigit() or (len(token) == 1 and token.islower() and token not in "mw"):
        return 5.1
    if token in "mwMW" or token in (r"\Omega", r"\Theta", r"\omega", r"\varphi", r"\psi"):
        return 8.6
    return 0.0 if token.isspace() else 7.0 if token.isupper() else 5.9
