"""Signs and functions of expressions as other languages write them, and what to write here."""

from __future__ import annotations

import re
import unicodedata

CONDITIONS = "the language has no conditions: write them with `sign`, `min` or `max`"
COMMENT = "a comment begins with a blank and `#`"
_INEQUALITIES = "write a constraint with `=`; " + CONDITIONS
ACCELERATIONS = "a spec speaks of positions and velocities only; accelerations are what nhc derives"
_GRAMMAR = "expressions hold numbers, names, `+ - * / ^ ( ) , '` and `=`"
_SIGNS = {
    "\u2212": "write `-`",
    "\u2013": "write `-`",
    "\u00b7": "write `*`",
    "\u22c5": "write `*`",
    "\u00d7": "write `*`",
    "\u00f7": "write `/`",
    "\u2019": "write the plain prime `'`",
    **{"\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[k]: f"write `^{k}`" for k in range(10)},
    **{chr(0x2080 + k): f"write a plain digit in a name, as in `x{k}`" for k in range(10)},
    "\u207b": "write the power after `^`, as in `x^-1`",
    "\u00bc": "write `1/4`",
    "\u00bd": "write `1/2`",
    "\u00be": "write `3/4`",
    "\u00b0": "angles are in radians: write `*pi/180`",
    "\u221a": "write `sqrt(...)`",
    "\u2044": "write `/`",
    "\u2217": "write `*`",
    "\u2022": "write `*`",
    "\u2018": "write the plain prime `'`",
    "\u00b4": "write the plain prime `'`",
    "`": "write the plain prime `'`",
    "\u2033": ACCELERATIONS,
    "\u221e": "a spec holds finite numbers only",
    "!": "the language has no factorials",
    "[": "use round parentheses",
    "]": "use round parentheses",
    "{": "use round parentheses",
    "}": "use round parentheses",
    "|": "write `abs(...)`",
    '"': "write `'` twice only for a second derivative, which the language has not",
    "%": f"the language has no remainder; {COMMENT}",
    "#": COMMENT,
    ";": "leave the `;` out",
    "$": "leave the `$` out: expressions are not LaTeX",
    "<": CONDITIONS,
    ">": CONDITIONS,
    **dict.fromkeys("\u2264\u2265", _INEQUALITIES),
}
_MODULES = ("np", "numpy", "jnp", "math", "cmath", "Math", "sp", "sympy", "sym", "std")
_LATEX = {
    **dict.fromkeys(("frac", "dfrac", "tfrac"), "write `a/b`"),
    **dict.fromkeys(("cdot", "times"), "write `*`"),
    **dict.fromkeys(("ddot", "dddot"), ACCELERATIONS),
    "sqrt": "write `sqrt(...)`",
    "ln": "write `log(...)`",
}

SPELLINGS: dict[str, str] = {
    "ln": "log",
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "arctan2": "atan2",
    "tg": "tan",
    "sgn": "sign",
    "fabs": "abs",
    "pow": "x^y",
    "cot": "1/tan(x)",
    "sec": "1/cos(x)",
    "csc": "1/sin(x)",
    "cbrt": "sign(x)*abs(x)^(1/3)",
    "hypot": "sqrt(x^2 + y^2)",
    **dict.fromkeys(("diff", "der", "deriv", "derivative", "ddt"), "dot(x)"),
    "log10": "log(x)/log(10)",
    "log2": "log(x)/log(2)",
    "heaviside": "(1 + sign(x))/2",
    **dict.fromkeys(("rational", "frac", "fraction"), "a/b"),
    **dict.fromkeys(("radians", "deg2rad"), "x*pi/180"),
    **{f"{function}d": f"{function}(x*pi/180)" for function in ("sin", "cos", "tan")},
    **dict.fromkeys(("asinh", "arcsinh"), "log(x + sqrt(x^2 + 1))"),
    **dict.fromkeys(("acosh", "arccosh"), "log(x + sqrt(x^2 - 1))"),
    **dict.fromkeys(("atanh", "arctanh"), "log((1 + x)/(1 - x))/2"),
}
"""Functions as others call them, in small letters."""


def meant_sign(text: str, at: int) -> str:
    """What to do about a sign that no expression holds, at this place of a text."""
    if text[at] == ".":
        return _meant_dot(text, at)
    share = (
        re.search(r"(?<![\w.])(\d+)$", text[:at].rstrip()) if text[at] == "%" and not text[at + 1 :].strip() else None
    )
    if share:
        return f"write `{share[1]}/100`"
    if text[at] == "\\":
        return _meant_latex(text[at + 1 :])
    return _meant_pair(text, at) or _SIGNS.get(text[at]) or _meant_wide(text[at])


def _meant_pair(text: str, at: int) -> str:
    """What to do about a sign that means something together with its neighbours."""
    pair = text[at : at + 2]
    if pair in ("<=", ">="):
        return _INEQUALITIES
    if pair == ":=":
        return "write `=`"
    named = re.fullmatch(r"\s*([^\W\d]\w*)\s*", text[:at]) if text[at] == ":" else None
    if named:
        return f'quotes go around the text alone: write `{named[1]}: "..."`'
    whose, index = re.search(r"[^\W\d]\w*$", text[:at]), re.match(r"\[(\d+)\]", text[at:])
    return f"there are no arrays here: write `{whose.group()}{index[1]}`" if whose and index else ""


def _meant_wide(sign: str) -> str:
    """What to do about a blank or a sign that only looks like one of this language."""
    if unicodedata.category(sign) in ("Zs", "Cf"):
        return "replace it by a plain blank: it looks like one, or like nothing"
    plain = unicodedata.normalize("NFKC", sign)
    return f"write `{plain}`" if plain != sign and plain in "+-*/^(),'=" else _GRAMMAR


def _meant_dot(text: str, at: int) -> str:
    before, after = re.search(r"\w*$", text[:at]), re.match(r"\w*", text[at + 1 :])
    assert before is not None and after is not None  # both may be empty
    whose, what = before.group(), after.group()
    if what in ("diff", "dt"):
        return f"write `{whose or '(...)'}'`"
    if whose in _MODULES and what:
        return f"write `{what}`, without `{whose}.`"
    if not what and text[at + 1 : at + 2] in ("*", "/", "^", "'"):
        return f"there are no arrays here: write `{text[at + 1]}`"
    return f"a name holds letters, digits and `_`: write `{whose}_{what}`" if whose and what else _GRAMMAR


def _meant_latex(rest: str) -> str:
    word = re.match("[A-Za-z]*", rest)
    assert word is not None  # it may be empty
    rate = re.match(r"dot\s*\{?\s*\\?(\w+)", rest)
    if rate:
        return f"write `{rate[1]}'`"
    known = _LATEX.get(word.group())
    return known or (
        f"write `{word.group()}`, without the `\\`" if word.group() not in ("", "left", "right") else "leave it out"
    )


def within(text: str) -> str:
    """What stands in the parentheses with which a text begins; `x` where it is long, or they are never closed."""
    depth = 0
    for at, sign in enumerate(text[:24]):
        depth += (sign == "(") - (sign == ")")
        if not depth:
            return text[1:at].strip()
    return "x"


def meant_power(function: str, argument: str, power: str) -> str:
    """What to write where the power stands behind the name of a function: `sin^2(x)`, `sin^-1(x)`."""
    if power == "-1" and function in ("sin", "cos", "tan"):
        return f"write `a{function}({argument})`, or `1/{function}({argument})` for the reciprocal"
    return f"write `{function}({argument})^{power}`"


def meant_call(name: str, rest: str) -> str:
    """What to write for the call of something that is no function, ``rest`` being the text from its parenthesis on."""
    rate = re.match(r"\(\s*([^\W\d]\w*)\s*(?:,\s*t\s*)?\)", rest)
    if rate and SPELLINGS.get(name.lower()) == "dot(x)":
        return f"write `{rate[1]}'`"
    if rate and name == "d":
        return f"the differential in a constraint is written `d{rate[1]}`, the velocity `{rate[1]}'`"
    if name.lower() in ("ddot", "dddot"):
        return ACCELERATIONS
    if name.lower() in SPELLINGS:
        return f"write `{SPELLINGS[name.lower()]}`"
    if re.match(r"\(\s*t\s*\)", rest):
        return f"write `{name}`: nhc knows which names change in time"
    return "`nhc explain E0206` lists the functions" if re.match(r"\([^()=]*,", rest) else ""
