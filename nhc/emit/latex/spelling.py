"""Names and texts in LaTeX: Greek by name, indices below, the user's words escaped."""

from __future__ import annotations

import re
import unicodedata

from nhc.emit.prose import PUNCTUATION, clean
from nhc.program.sheets.model import LATIN, OTHER

_GREEK_NAMES = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi chi psi omega"
    " Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
)
_GREEK = frozenset(_GREEK_NAMES.split())
_SPELLED = {"epsilon": r"\varepsilon", "phi": r"\varphi"}
_SPECIAL = {"Omega form": r"\boldsymbol{\Omega}", "Theta form": r"\boldsymbol{\theta}"}
_SPECIAL |= {f"{name}{OTHER}": bold for name, bold in _SPECIAL.items()}  # bold is another shape already
_SPECIAL |= {f"{base}{OTHER}": rf"\mathcal{{{base}}}" for base in "TUEHQ"}
_SPECIAL |= {f"Delta{OTHER}": r"\mathcal{D}"}
_SPECIAL |= {f"p{OTHER}": r"\mathcal{P}", f"lambda{OTHER}": r"\Lambda", f"omega{OTHER}": r"\varpi"}
_AXES = frozenset("xyz0123456789")
_WORDS = (r"\mathit{", r"\mathrm{", r"\text{")
_LONG_WORD = 16
_LONGEST_PART, _CHUNK = 25, 10  # characters
_SYMBOLS = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}", ">": r"\textgreater{}", "|": r"\textbar{}",
    '"': r"\textquotedbl{}", "`": r"\textasciigrave{}",
}  # fmt: skip
_LETTERS = {"\u00df": r"\ss{}", "\u00f8": r"\o{}", "\u00d8": r"\O{}", "\u0142": r"\l{}", "\u0141": r"\L{}",
            "\u00e6": r"\ae{}", "\u00c6": r"\AE{}", "\u0131": r"\i{}", "\u20ac": r"\texteuro{}",
            "\u2013": r"\textendash{}", "\u2014": r"\textemdash{}", "\u2018": r"\textquoteleft{}",
            "\u2019": r"\textquoteright{}", "\u201c": r"\textquotedblleft{}", "\u201d": r"\textquotedblright{}"}  # fmt: skip
_MATH = {"\u00b5": r"\mu", "\u00b1": r"\pm", "\u00d7": r"\times", "\u00b7": r"\cdot", "\u22c5": r"\cdot", "\u2264": r"\leq",
         "\u2265": r"\geq", "\u2260": r"\neq", "\u2248": r"\approx", "\u2192": r"\to", "\u221e": r"\infty", "\u00b0": r"^{\circ}",
         "\u2032": r"{}'", "\u2033": r"{}''", "\u2212": "-", "\u2126": r"\Omega", "\u2202": r"\partial"}  # fmt: skip
_ACCENTS = {"\u0300": r"\`", "\u0301": r"\'", "\u0302": r"\^", "\u0303": r"\~", "\u0304": r"\=", "\u0306": r"\u",
            "\u0307": r"\.", "\u0308": r'\"', "\u030a": r"\r", "\u030b": r"\H", "\u030c": r"\v", "\u0327": r"\c",
            "\u0328": r"\k"}  # fmt: skip

# ISO 9:1995, by one letter each
_CYRILLIC = dict(zip("абвгдеёжзийклмнопрстуфхцчшщыэюяіїє", "abvgdeëžzijklmnoprstufhcčšŝyèûâìïê", strict=True))
_CYRILLIC |= {letter.upper(): latin.upper() for letter, latin in _CYRILLIC.items()}
_CYRILLIC |= {"ь": "'", "Ь": "'", "ъ": "''", "Ъ": "''"}


def spell_base(name: str) -> tuple[str, tuple[str, ...]]:
    """(LaTeX of the base, further lower indices): ``theta1`` is theta with index 1, ``r_R`` r with R, ``mass`` one italic word."""
    if name in _SPECIAL:
        return _SPECIAL[name], ()
    head, *rest = name.split("_")
    indices = tuple(part for part in rest if part)
    match = re.fullmatch(r"([A-Za-z]+?)([0-9]+\w*)", head)
    if match and (len(match[1]) == 1 or match[1] in _GREEK):
        head, indices = match[1], (match[2], *indices)
    if not head:
        return r"\_", indices
    return spell_word(head), indices


def spell_word(word: str) -> str:
    """One word in math: a letter, a Greek letter, or an italic (upright with digits) word."""
    if word in _GREEK:
        return _SPELLED.get(word, f"\\{word}")
    if word in LATIN:
        return rf"\mathrm{{{LATIN[word]}}}"
    if len(word) == 1 and word.isascii():
        return word
    if word.isascii() and word.isdigit():
        return word
    if not word.isascii():
        return rf"\text{{{escape(word)}}}"
    return rf"\mathit{{{word}}}"


def spell_index(index: str) -> str:
    """An index: what stands below a symbol, a letter perhaps with an index of its own, as p_b; words stand in a row."""
    base, lower = spell_base(index)
    if lower and base.startswith(_WORDS):
        return r"\,".join([base, *map(spell_part, lower)])
    return f"{base}_{{{','.join(map(spell_part, lower))}}}" if lower else base


def spell_part(part: str) -> str:
    """What stands below a letter in a name of the spec: numbers and axes stand as they are (``I_xz``, ``e_1x``); a
    word describes, and is upright (ISO 80000-1).
    """
    return part if set(part) <= _AXES else spell_index(part).replace(r"\mathit", r"\mathrm")


def escape(text: str) -> str:
    """The user's text as LaTeX text; Cyrillic letters as Latin ones, and what else the fonts do not have by its code."""
    return escape_part(clean(text))


def escape_part(text: str) -> str:
    """A part of a text that is clean already; blanks at its ends stay."""
    return _part_ligatures("".join(_escape_character(character) for character in text))


def _part_ligatures(shown: str) -> str:
    """Two hyphens, commas or quotes would be set as a dash or as a quotation mark: ``--explain`` is what a reader has to type."""
    return re.sub(r"([-,'])(?=\1)", r"\1{}", shown)


def escape_breakable(text: str) -> str:
    """The same; an expression that is one long word may be broken after an operator or a parenthesis, a long name anywhere."""
    return " ".join(_escape_word(word) for word in text.split(" "))


def _escape_word(word: str) -> str:
    parts = re.split(r"(?<=[*/(,_])", word) if len(word) > _LONG_WORD else [word]
    return r"\allowbreak{}".join(chunk for part in parts for chunk in _chunks(part))


def _chunks(part: str) -> list[str]:
    """The part itself unless it is too long for the end of a line."""
    return split_shown(part, _CHUNK) if count_shown(part) > _LONGEST_PART else [escape_part(part)]


def count_shown(text: str) -> int:
    """The number of characters that the text takes when set; one that is named by its code, as <U+2126>, takes several."""
    return sum(_length(_escape_character(character)) for character in text)


def _length(shown: str) -> int:
    return 8 if shown.startswith(r"\textless{}U") else 1


def split_shown(text: str, most: int) -> list[str]:
    """The text, escaped for LaTeX, in parts of at most ``most`` characters as they are set."""
    chunks, length = [""], 0
    for shown in map(_escape_character, text):
        own = _length(shown)
        if length + own > most and chunks[-1]:
            chunks.append("")
            length = 0
        chunks[-1] += shown
        length += own
    return [_part_ligatures(chunk) for chunk in chunks]


_EXPRESSION = re.compile(r"(?:[0-9.]+(?:e-?[0-9]+)?|pi|sqrt\([0-9.]+\)|\^-?[0-9]+|[-+*/() ]){1,20}")
_PLAIN = re.compile(r"[0-9.]*")


def spell_unit(unit: str) -> str:
    """``kg*m^2`` as kg m with a raised 2."""
    parts = re.split(r"\^\(?(-?\d+(?:/\d+)?)\)?", clean(unit))
    shown = [f"$^{{{part}}}$" if k % 2 else escape_part(part).replace("*", r"\,") for k, part in enumerate(parts)]
    return "".join(shown)


def spell_value(value: str) -> str:
    """A value as a formula where it is an expression of numbers and pi, as ``2*sqrt(2)/3``; else as text."""
    if not _EXPRESSION.fullmatch(value) or _PLAIN.fullmatch(value):
        return escape_breakable(clean(value))
    shown = re.sub(r"sqrt\(([0-9.]+)\)", r"\\sqrt{\1}", value)
    shown = re.sub(r"\^(-?[0-9]+)", r"^{\1}", shown)
    shown = re.sub(r"([0-9.]+)e(-?[0-9]+)", r"\1\\cdot 10^{\2}", shown)
    shown = re.sub(r"(?<![0-9.])1\\cdot 10", "10", shown)
    shown = re.sub(r"pi\b *", r"\\pi ", shown).replace("*", r"\,").strip()
    return f"${shown}$"


def _escape_character(character: str) -> str:
    if character in _SYMBOLS:
        return _SYMBOLS[character]
    if character.isascii():
        return character
    if character in _LETTERS:
        return _LETTERS[character]
    if character in _MATH:
        return f"${_MATH[character]}$"
    if character in PUNCTUATION:
        return "".join(_SYMBOLS.get(c, c) for c in PUNCTUATION[character])
    greek = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (\w+)( WITH .*)?", unicodedata.name(character, ""))
    if greek:
        word = greek[2].lower() if greek[1] == "SMALL" else greek[2].capitalize()
        return f"${spell_word('lambda' if word == 'lamda' else 'Lambda' if word == 'Lamda' else word)}$"
    if character in _CYRILLIC:
        return "".join(map(_escape_character, _CYRILLIC[character]))
    base, *marks = tuple(unicodedata.normalize("NFD", character))
    if base.isascii() and len(marks) == 1 and marks[0] in _ACCENTS:
        return f"{_ACCENTS[marks[0]]}{{{base}}}"
    return _compatible(character)


def _compatible(character: str) -> str:
    """A raised or lowered digit or sign and a fraction by their parts, else the character's code."""
    parts = unicodedata.decomposition(character).split()
    if parts and parts[0] in ("<super>", "<sub>", "<fraction>"):
        text = "".join(chr(int(part, 16)) for part in parts[1:]).replace("\u2044", "/").replace("\u2212", "-")
        if re.fullmatch(r"[-+0-9a-zA-Z/]+", text):
            return {"<super>": f"$^{{{text}}}$", "<sub>": f"$_{{{text}}}$"}.get(parts[0], text)
    return _code(character)


def escape_exactly(name: str) -> str:
    """A name whose letters all remain themselves: Greek letters, which lose accents elsewhere, and Cyrillic ones by their codes."""
    changed = ("GREEK", "CYRILLIC")
    return "".join(_code(c) if unicodedata.name(c, "").startswith(changed) else _escape_character(c) for c in name)


def _code(character: str) -> str:
    return rf"\textless{{}}U+{ord(character):04X}\textgreater{{}}"
