"""Readers of what is printed, text and LaTeX: they know the notation, and nothing of the printers."""

from __future__ import annotations

import math
import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping

FUNCTIONS: dict[str, Callable[..., float]] = {
    **{name: getattr(math, name) for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "sqrt", "atan2")},
    **{name: getattr(math, name) for name in ("asin", "acos", "atan", "log")},
    **{
        "arcsin": math.asin,
        "arccos": math.acos,
        "arctan": math.atan,
        "ln": math.log,
        "abs": abs,
        "max": max,
        "min": min,
    },
    "sign": lambda x: math.copysign(1.0, x),
    "sgn": lambda x: math.copysign(1.0, x),
}
_DIGITS = re.compile(r"\d+(\.\d+)?")


class Reader(ABC):
    """The value of a side; ``marks`` gives one to each symbol as it is printed. A wedge counts as a product."""

    def __init__(self, text: str, marks: Mapping[str, float]) -> None:
        self.text, self.at, self.marks = text, 0, marks
        self.keys = sorted(marks, key=len, reverse=True)

    def value(self) -> float:
        found = self.sum()
        self.skip()
        assert self.at == len(self.text), f"left over: {self.text[self.at :]!r} in {self.text!r}"
        return found

    def skip(self) -> None:
        while self.at < len(self.text) and self.text[self.at] == " ":
            self.at += 1

    def sees(self, token: str) -> bool:
        self.skip()
        return self.text.startswith(token, self.at)

    def takes(self, token: str) -> bool:
        found = self.sees(token)
        self.at += len(token) if found else 0
        return found

    def needs(self, token: str) -> None:
        assert self.takes(token), f"no {token!r} at {self.text[self.at :]!r} in {self.text!r}"

    def sum(self) -> float:
        total = -self.term() if self.takes("-") else self.term()
        while self.sees("+") or self.sees("-"):
            sign = -1.0 if self.takes("-") else 1.0
            self.takes("+")
            total += sign * self.term()
        return total

    @abstractmethod
    def term(self) -> float:
        """A product, as the notation writes it."""

    def number(self) -> float | None:
        self.skip()
        match = _DIGITS.match(self.text, self.at)
        self.at = match.end() if match else self.at
        return float(match[0]) if match else None

    def mark(self) -> float:
        self.skip()
        for key in self.keys:
            after = self.text[self.at + len(key) : self.at + len(key) + 1]
            cut = key[-1].isalnum() and after.isalnum() and (key[0] == "\\" or self.whole_words())
            if self.text.startswith(key, self.at) and not cut and after != "'":
                self.at += len(key)
                return self.marks[key]
        raise AssertionError(f"unknown: {self.text[self.at :]!r} in {self.text!r}")

    def whole_words(self) -> bool:
        return True


class TextReader(Reader):
    """``a*b/c``, ``f(x)^2``; a blank stands between a coefficient and its symbol, ``" ^ "`` between differentials."""

    def term(self) -> float:
        total = self.product()
        while self.text.startswith(" ^ ", self.at) or (
            self.text.startswith(" ", self.at) and self.text[self.at + 1 : self.at + 2] not in ("+", "-", "")
        ):
            self.takes("^")
            total *= self.product()
        return total

    def product(self) -> float:
        total = self.power()
        while self.at < len(self.text) and self.text[self.at] in "*/":
            total = total * self.power() if self.takes("*") else (self.needs("/"), total / self.power())[1]
        return total

    def power(self) -> float:
        base = self.atom()
        if self.text.startswith("^", self.at):
            self.at += 1
            base **= -self.atom() if self.takes("-") else self.atom()
        return base

    def atom(self) -> float:
        if self.takes("("):
            return (self.sum(), self.needs(")"))[0]
        number = self.number()
        if number is not None:
            return number
        match = re.compile(r"([a-z]+\d?)\(").match(self.text, self.at)
        if match and match[1] in FUNCTIONS:
            self.at = match.end()
            arguments = [self.sum()]
            while self.takes(","):
                arguments.append(self.sum())
            self.needs(")")
            return FUNCTIONS[match[1]](*arguments)
        return math.pi if self.sees("pi") and "pi" not in self.marks and self.takes("pi") else self.mark()


class LatexReader(Reader):
    r"""``\frac{a\,b}{c}``, ``\sin^{2} \theta``; factors stand beside each other."""

    bars = False

    def whole_words(self) -> bool:
        return False

    def skip(self) -> None:
        match = re.compile(r"(\s|\\,|\\cdot(?![a-zA-Z])|\\wedge(?![a-zA-Z]))*").match(self.text, self.at)
        assert match is not None
        self.at = match.end()

    def term(self) -> float:
        total = self.power()
        while not self.ends():
            total *= self.power()
        return total

    def ends(self) -> bool:
        self.skip()
        ends = ("+", "-", ")", "}", ",", r"\Bigr", *(("|",) if self.bars else ()))
        return self.at == len(self.text) or any(self.sees(token) for token in ends)

    def power(self) -> float:
        base = self.atom()
        return base ** self.inside("{", "}") if self.text.startswith("^", self.at) and self.takes("^") else base

    def inside(self, opening: str, closing: str) -> float:
        bars, self.bars = self.bars, opening == "|"
        self.needs(opening)
        found = self.sum()
        self.needs(closing)
        self.bars = bars
        return found

    def atom(self) -> float:
        if self.takes(r"\frac") or self.takes(r"\tfrac"):
            return self.inside("{", "}") / self.inside("{", "}")
        if self.takes(r"\sqrt"):
            return math.sqrt(self.inside("{", "}"))
        for key in self.keys:  # (T^{*})^{2}, {\dot{x}}^{2}: a symbol with its own signs is enclosed
            if self.takes(f"({key})") or self.takes(f"{{{key}}}"):
                return self.marks[key]
        names = "|".join(sorted(FUNCTIONS, key=len, reverse=True))
        match = re.compile(rf"\\(?:operatorname\{{(\w+)\}}|({names})(?![a-zA-Z]))").match(self.text, self.at)
        if match:
            self.at = match.end()
            return self.call(match[1] or match[2])
        for opening, closing in ((r"\Bigl(", r"\Bigr)"), ("(", ")"), ("|", "|")):
            if self.sees(opening):
                found = self.inside(opening, closing)
                return abs(found) if opening == "|" else found
        number = self.number()
        if number is not None:
            return number
        return math.pi if r"\pi" not in self.marks and self.sees(r"\pi") and self.takes(r"\pi") else self.mark()

    def call(self, name: str) -> float:
        exponent = self.inside("{", "}") if self.takes("^") else 1.0
        closing = r"\Bigr)" if self.sees(r"\Bigl(") else ")"
        if not (self.takes(r"\Bigl(") or self.takes("(")):
            return FUNCTIONS[name](self.mark()) ** exponent
        bars, self.bars = self.bars, False
        arguments = [self.sum()]
        while self.takes(","):
            arguments.append(self.sum())
        self.needs(closing)
        self.bars = bars
        return FUNCTIONS[name](*arguments) ** exponent
