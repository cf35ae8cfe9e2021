"""Expressions in LaTeX, in pieces of estimated width."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from nhc.emit.latex.names import PLAIN, Names
from nhc.emit.latex.width import estimate
from nhc.emit.layout import LAST, Piece, add_term, hold, nest, total
from nhc.emit.terms import Product, flatten_product, flatten_sum, is_sum, is_unit, list_terms, split_number
from nhc.program.ir import Binary, Call, Expr, Negate, Number, Pi, Power, Ref
from nhc.program.sheets.model import RANK_STEP, Mark, Side, Symbol
from nhc.records import record

_FRACTION = 190.0  # widest numerator or denominator that is set as a fraction, in points
_NARROW = 100.0  # of an argument that stays on one line
COMMANDS = {
    "asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan", "atan2": r"\operatorname{atan2}", "log": r"\ln",
    "sign": r"\operatorname{sgn}",
}  # fmt: skip
_MARK = "@"  # no identifier of the IR


_TIMES = Piece(r"\,", estimate(r"\,"), LAST, r"\cdot ")


def _piece(text: str, breaks: int = 0) -> Piece:
    return Piece(text, estimate(text), breaks)


@record
class LatexMath:
    """Prints over one derivation's symbols, with its spelling of their names."""

    symbols: Mapping[str, Symbol]
    names: Names = PLAIN

    def pieces(self, expression: Expr) -> list[Piece]:
        """The terms of a sum with their signs, breakable before each sign."""
        found: list[Piece] = []
        for negative, term in flatten_sum(expression):
            add_term(found, negative, self._term(term), estimate)
        return found

    def side(self, side: Side) -> list[Piece]:
        """A sum of coefficients times basis elements; the empty one is 0."""
        if not side:
            return [_piece("0")]
        found: list[Piece] = []
        for negative, term in list_terms(side):
            basis = self._basis(term.factors)
            if len(term.factors) == 1 and not term.factors[0].prefix and not is_sum(term.coefficient):
                body = self._with_mark(term.coefficient, term.factors[0])
            elif not term.factors:
                body = self._term(term.coefficient)
            elif is_unit(term.coefficient):
                body = basis
            elif is_sum(term.coefficient):
                body = [*_enclose(self.pieces(term.coefficient)), *_thin(basis)]
            else:
                body = [*self._term(term.coefficient), *_thin(basis)]
            add_term(found, negative, body, estimate)
        return found

    def _basis(self, marks: Sequence[Mark]) -> list[Piece]:
        texts = [self.names.print_mark(mark) for mark in marks]
        return [_piece(text) if k == 0 else _piece(rf" \wedge {text}", LAST) for k, text in enumerate(texts)]

    def _with_mark(self, coefficient: Expr, mark: Mark) -> list[Piece]:
        """A product with a rate or velocity at its place among the factors: before sines and cosines."""
        whole = Binary("*", coefficient, Ref(_MARK))
        return LatexMath({**self.symbols, _MARK: Symbol(mark, 7 * RANK_STEP)}, self.names)._term(whole)

    def _term(self, term: Expr) -> list[Piece]:
        product = flatten_product(term, self.symbols)
        sign = [_piece("-")] if product.negative else []
        over = self._factors(product.over)
        under = self._factors(product.under)
        if not product.under:
            return [*sign, *_numbered(product.number, over)]
        top, bottom = product.parts
        if bottom:
            under = [_piece(bottom), *_thin(under)]
        if top or not over:
            over = [_piece(top or "1"), *(_thin(over) if over else [])]
        return [*sign, *self._quotient(product, over, under)]

    def _quotient(self, product: Product, over: list[Piece], under: list[Piece]) -> list[Piece]:
        """A fraction where both parts are narrow and flat, else one before the factors in parentheses.

        A denominator that is neither has a negative exponent.
        """
        top, bottom = product.parts
        below = self.pieces(product.under[0]) if len(product.under) == 1 and not bottom else under
        above = self.pieces(product.over[0]) if len(product.over) == 1 and not top else over
        width = max(total(above), total(below))
        if width <= _FRACTION and _is_flat((*above, *below)):
            return [Piece(rf"\frac{{{_join(above)}}}{{{_join(below)}}}", width + 4.0)]
        sums = tuple(factor for factor in product.over if isinstance(factor, Binary | Negate))
        ahead = self._factors(tuple(factor for factor in product.over if factor not in sums))
        if top or not ahead:
            ahead = [_piece(top or "1"), *(_thin(ahead) if ahead else [])]
        width = max(total(ahead), total(below))
        if sums and width <= _FRACTION and _is_flat((*ahead, *below)):
            fraction = Piece(rf"\frac{{{_join(ahead)}}}{{{_join(below)}}}", width + 4.0)
            return [fraction, *_thin(self._factors(sums))]
        inverse = self._inverse(product, below)
        if [piece.text for piece in over] == ["1"]:
            return inverse
        return [*over, *_thin(inverse)]

    def _inverse(self, product: Product, below: list[Piece]) -> list[Piece]:
        lone = product.under[0] if len(product.under) == 1 and not product.parts[1] else None
        match lone:
            case Ref():
                return self._power(Power(lone, -1))
            case Power():
                return self._power(Power(lone.base, -lone.exponent))
            case _:
                return [*_enclose(below), _piece("^{-1}")]

    def _factors(self, factors: tuple[Expr, ...]) -> list[Piece]:
        found: list[Piece] = []
        for factor in factors:
            body = self._factor(factor)
            found += _thin(body) if found else body
        return found

    def _factor(self, factor: Expr) -> list[Piece]:
        match factor:
            case Number():
                return [_number(factor.value)]
            case Pi():
                return [_piece(r"\pi")]
            case Ref():
                return [_piece(self.names.print_mark(self.symbols[factor.name].mark))]
            case Power():
                return self._power(factor)
            case Call():
                return self._call(factor)
            case Binary() | Negate():
                return _enclose(self.pieces(factor))

    def _power(self, power: Power) -> list[Piece]:
        base, exponent = power.base, power.exponent
        if isinstance(base, Call) and base.function in ("sin", "cos", "sinh", "cosh", "tanh"):
            return self._call(base, f"^{{{exponent}}}")
        if isinstance(base, Ref):
            mark = self.symbols[base.name].mark
            text = self.names.print_mark(mark)
            safe = f"({text})" if mark.star or mark.upper else f"{{{text}}}" if mark.dots else text
            return [_piece(f"{safe}^{{{exponent}}}")]
        bars = isinstance(base, Call) and base.function == "abs"  # enclose as parentheses do
        inner = self.pieces(base)
        return [*(inner if bars else _enclose(inner)), _piece(f"^{{{exponent}}}")]

    def _call(self, call: Call, exponent: str = "") -> list[Piece]:
        inner = [self.pieces(argument) for argument in call.arguments]
        if call.function == "pow":
            return [*_enclose(inner[0]), _piece(f"^{{{_join(inner[1])}}}")]
        if call.function == "sqrt" and total(inner[0]) <= _FRACTION:
            return [Piece(rf"\sqrt{{{_join(inner[0])}}}", total(inner[0]) + 9.0)]
        if call.function == "sqrt":
            return [*_enclose(inner[0]), _piece("^{1/2}")]
        if call.function == "abs":
            return [_piece("|"), *nest(inner[0]), _piece("|")]
        head = _piece(COMMANDS.get(call.function, f"\\{call.function}") + exponent)
        if len(call.arguments) == 1 and isinstance(call.arguments[0], Ref):
            return [head, _piece(" "), *inner[0]]
        arguments = [piece for k, part in enumerate(inner) for piece in ([_piece(r",\,")] if k else []) + part]
        return [head, *_enclose(hold(arguments, _NARROW))]


def _numbered(number: Fraction, over: list[Piece]) -> list[Piece]:
    if number == 1 and over:
        return over
    return [_number(number), *(_thin(over) if over else [])]


def _number(value: Fraction) -> Piece:
    if value < 0:
        inner = _number(-value)
        return Piece(f"(-{inner.text})", inner.width + 14.0)
    above, below = split_number(value)
    if not below:
        return _piece(above or "1")
    return Piece(rf"\tfrac{{{above or '1'}}}{{{below}}}", 4.0 * max(len(above), len(below)) + 3.0)


def _is_flat(pieces: Sequence[Piece]) -> bool:
    return not any(r"\frac" in piece.text for piece in pieces)


def _thin(pieces: list[Piece]) -> list[Piece]:
    return [_TIMES, *pieces]


def _join(pieces: list[Piece]) -> str:
    return "".join(piece.text for piece in pieces)


def _enclose(pieces: list[Piece]) -> list[Piece]:
    """Parentheses, larger ones round fractions; they may open on one line and close on another."""
    big = any(r"\frac" in piece.text for piece in pieces)
    opening, closing = (r"\Bigl(", r"\Bigr)") if big else ("(", ")")
    return [_piece(opening), *nest(pieces), _piece(closing)]
