"""A formula of the registry on one line of text, for terminals: the LaTeX that the registry uses, and no more of it."""

from __future__ import annotations

import re
import unicodedata
from itertools import pairwise

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\S")
_LETTERS = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "epsilon": "ε",
    "lambda": "λ",
    "mu": "μ",
    "nu": "ν",
    "pi": "π",
    "phi": "φ",
    "omega": "ω",
    "Omega": "Ω",
}
_SIGNS = {
    "partial": "∂",
    "wedge": "∧",
    "cdot": "·",
    "int": "∫",
    "dots": "…",
    "det": "det",
    "{": "{",
    "}": "}",
    "\\": ";",
}
_UNSEEN = frozenset({"left", "right", "Big", "quad", ",", " "})
_ACCENTS = {"dot": "'", "vec": "", "tilde": "\u0303"}  # q' is the language's own sign; an arrow has no place on a line
_RAISED = {"*": "*", "2": "²"}


def plain(latex: str) -> str:
    r"""``\frac{\partial T}{\partial\dot q_\mu} = Q_\mu`` as ``∂T/∂q'_μ = Q_μ``.

    Raises:
        KeyError: a command that no formula of the registry had so far.
    """
    latex = latex.replace(r"\begin{vmatrix}", "|").replace(r"\end{vmatrix}", "|").replace("&", ",")
    atoms = _Reader(_TOKEN.findall(latex)).read("")
    return atoms[0] + "".join(_space(last, atom) + atom for last, atom in pairwise(_with_signs(atoms)))


class _Reader:
    r"""Reads tokens from the left; what a command takes (``\frac{..}{..}``, ``\dot q``) is read by a call of its own."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens = tokens
        self.at = 0

    def read(self, end: str) -> list[str]:
        """The atoms (signs, and letters or fractions with their indices) up to the token ``end``, or to the end of all."""
        atoms = []
        while self.at < len(self.tokens) and self.tokens[self.at] != end:
            atoms.append(self.argument() + self.scripts())
        self.at += 1
        return [atom for atom in atoms if atom]

    def argument(self) -> str:
        """What a command takes: one token, or a group without its spaces."""
        token = self.tokens[self.at]
        self.at += 1
        if token == "{":
            return "".join(self.read("}"))
        if not token.startswith("\\"):
            return token
        name = token[1:]
        if name in ("frac", "tfrac"):
            above = self.argument()
            return f"{above}/{self.argument()}"
        if name in _ACCENTS:
            return unicodedata.normalize("NFC", self.argument() + _ACCENTS[name])
        return "" if name in _UNSEEN else _LETTERS.get(name) or _SIGNS[name]

    def scripts(self) -> str:
        text = ""
        while self.at < len(self.tokens) and self.tokens[self.at] in ("_", "^"):
            kind = self.tokens[self.at]
            self.at += 1
            script = self.argument()
            if kind == "^" and script in _RAISED:
                text += _RAISED[script]
            else:
                text += kind + (f"{{{script}}}" if "," in script or "_" in script else script)
        return text


def _with_signs(atoms: list[str]) -> list[str]:
    """A sign with nothing before it to add to goes with what follows; d of a fraction takes brackets."""
    joined: list[str] = []
    for atom in atoms:
        if joined and joined[-1] == "-" and (len(joined) == 1 or joined[-2] in "=([,"):
            joined[-1] += atom
        elif joined and joined[-1] == "d" and "/" in atom:
            joined.append(f"({atom})")
        else:
            joined.append(atom)
    return joined


def _space(last: str, atom: str) -> str:
    """What stands between two neighbours: a space about signs and between factors, none behind d, ∂, δ and numbers."""
    if atom[0] in ",;:)]}'" or (atom[0] == "|" and last != "=") or last in ("(", "[", "{", "|"):
        return ""
    if atom[0] in "([{":  # u(d) and ∂(T + U), but p_j (...)
        return "" if (len(last) == 1 and last not in "+-=∧·)]") or last == "det" else " "
    return "" if last in ("d", "δ", "∂") or last.isdigit() else " "
