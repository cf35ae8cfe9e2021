"""Expressions as infix text with the fewest parentheses that keep the order of evaluation bit for bit.

The languages differ in a few leaves only (numbers, calls, powers): a ``Dialect`` says how.  Where a line may not grow
without bound, the printer hands the longest operand to ``spill``, which stores it under a name and returns that name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple, Protocol

from nhc.program.ir import Binary, Call, Expr, Negate, Number, Pi, Power, Ref
from nhc.records import record

SUM, PRODUCT, UNARY, POWER, ATOM = range(1, 6)
LEVELS = {"+": SUM, "-": SUM, "*": PRODUCT, "/": PRODUCT}
OPPOSITE = {"+": "-", "-": "+"}


class Text(NamedTuple):
    """Printed expression and how tightly its outermost operation binds."""

    text: str
    level: int


class Dialect(Protocol):
    """What is special to a language."""

    def print_number(self, value: Fraction) -> str: ...
    def print_pi(self) -> str: ...
    def print_power(self, base: Text, exponent: int) -> Text: ...
    def print_call(self, function: str, arguments: tuple[str, ...]) -> str: ...


def enclose(part: Text, least: int) -> str:
    """The text, in parentheses unless it binds at least as tightly as ``least``."""
    return part.text if part.level >= least else f"({part.text})"


def split_sign(expression: Expr) -> tuple[bool, Expr]:
    """Whether the expression is written with a minus in front, and what follows it."""
    if isinstance(expression, Negate):
        return True, expression.operand
    if isinstance(expression, Number) and expression.value < 0:
        return True, Number(-expression.value)
    return False, expression


@record
class ExpressionPrinter:
    """``names``: the language's spelling of the IR's; ``width``: the longest text allowed (0: no limit); ``spill`` stores
    an operand that makes a text longer.
    """

    dialect: Dialect
    names: Mapping[str, str]
    width: int = 0
    spill: Callable[[str], str] | None = None

    def print(self, expression: Expr) -> str:
        """The text of an expression, at the lowest level."""
        return self.render(expression).text

    def render(self, expression: Expr) -> Text:
        """Walk down the left operands in a loop: sums of thousands of terms lean that way.

        A minus goes to the first factor of a product, and two of them cancel: that changes no double.
        """
        if type(expression) is Ref:  # every other operand
            return Text(self.names[expression.name], ATOM)
        spine: list[Binary] = []
        negative = False
        while True:
            if isinstance(expression, Binary) and not (negative and expression.op in OPPOSITE):
                spine.append(expression)
                expression = expression.left
            elif isinstance(expression, Negate):
                negative, expression = not negative, expression.operand
            else:
                break
        if negative and isinstance(expression, Number):
            negative, expression = False, Number(-expression.value)
        if type(expression) is Ref:
            part = Text(self.names[expression.name], ATOM)
        else:
            part = self._render_term(expression)
        if negative:
            part = self._negate(part)
        if self.width:
            for node in reversed(spine):
                part = self._join(node.op, part, node.right)
            return part
        return self._chain(part, spine) if spine else part

    def _chain(self, first: Text, spine: Sequence[Binary]) -> Text:
        """What :meth:`_join` makes of one operand after the other, where no text is too long; the last of them comes first."""
        text, level = first
        for node in reversed(spine):
            op, right, outer = node.op, node.right, LEVELS[node.op]
            if level < outer:
                text = f"({text})"
            if type(right) is Ref:
                text = f"{text} {op} {self.names[right.name]}"
            else:
                op, second = self._right(op, right)
                text = f"{text} {op} {enclose(second, outer + 1)}"
            level = outer
        return Text(text, level)

    def _render_term(self, expression: Expr) -> Text:
        if isinstance(expression, Number):
            text = self.dialect.print_number(expression.value)
            return Text(text, UNARY if text.startswith("-") else ATOM)
        if isinstance(expression, Pi):
            return Text(self.dialect.print_pi(), ATOM)
        if isinstance(expression, Power):
            (base,) = self._shorten([self.render(expression.base)], 12)
            return self.dialect.print_power(base, expression.exponent)
        if isinstance(expression, Call):
            return self._call(expression)
        return self.render(expression)

    def _call(self, call: Call) -> Text:
        parts = self._shorten([self.render(argument) for argument in call.arguments], 16)
        return Text(self.dialect.print_call(call.function, tuple(part.text for part in parts)), ATOM)

    def _negate(self, operand: Text) -> Text:
        (operand,) = self._shorten([operand], 3)
        return Text(f"-{enclose(operand, ATOM)}", UNARY)

    def _right(self, op: str, operand: Expr) -> tuple[str, Text]:
        """The operation and its right operand; a + (-b) and a - b are the same double."""
        if op in OPPOSITE:
            negative, positive = split_sign(operand)
            if negative:
                return OPPOSITE[op], self.render(positive)
        return op, self.render(operand)

    def _join(self, op: str, left: Text, operand: Expr) -> Text:
        op, right = self._right(op, operand)
        left, right = self._shorten([left, right], 7)
        level = LEVELS[op]
        return Text(f"{enclose(left, level)} {op} {enclose(right, level + 1)}", level)

    def _shorten(self, parts: list[Text], extra: int) -> list[Text]:
        """Store the longest parts under names until all of them and ``extra`` characters fit."""
        if self.spill is None or not self.width:
            return parts
        parts = list(parts)
        while sum(len(part.text) + 2 for part in parts) + extra > self.width:
            longest = max(range(len(parts)), key=lambda i: len(parts[i].text))
            name = self.spill(parts[longest].text)
            if len(name) >= len(parts[longest].text):
                break
            parts[longest] = Text(name, ATOM)
        return parts
