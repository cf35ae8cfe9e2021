"""Marks and expressions as plain text, in the spelling of the spec language."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from nhc.emit.layout import Piece, add_term, hold, nest
from nhc.emit.terms import flatten_product, flatten_sum, is_sum, is_unit, list_terms, split_number
from nhc.program.ir import Binary, Call, Expr, Negate, Number, Pi, Power, Ref
from nhc.program.sheets.model import OTHER, Mark, Side, Symbol
from nhc.records import record

_SUM, _PRODUCT, _POWER, _ATOM = range(4)
_NARROW = 24  # columns of an argument that stays on one line
_SPECIAL = {"Omega form": "Omega", "Theta form": "Theta", "epsilon": "eps"}
_SPECIAL |= {f"{base} form{OTHER}": f"<{base}>" for base in ("Omega", "Theta")}
_SPECIAL |= {f"{base}{OTHER}": f"<{base}>" for base in ("T", "U", "E", "H", "Q", "p", "lambda", "omega", "Delta")}


def print_mark(mark: Mark) -> str:
    """``theta''``, ``dx'``, ``gamma^slip_{v,w}``."""
    base = _SPECIAL.get(mark.base, mark.base)
    if mark.star:
        base += "*"
    if mark.upper:
        base += "^" + ",".join(mark.upper)
    if len(mark.lower) == 1:
        base += f"_{mark.lower[0]}" if not mark.lower[0].isdigit() else mark.lower[0]
    elif mark.lower:
        base += "_{" + ",".join(mark.lower) + "}"
    return f"{mark.prefix}{base}{chr(39) * mark.dots}{mark.at}"


@record
class TextMath:
    """Prints over one derivation's symbols."""

    symbols: Mapping[str, Symbol]

    def pieces(self, expression: Expr) -> list[Piece]:
        """The terms of a sum with their signs, breakable before each sign."""
        found: list[Piece] = []
        for negative, term in flatten_sum(expression):
            add_term(found, negative, self._term(term), len)
        return found

    def side(self, side: Side) -> list[Piece]:
        """A sum of coefficients times basis elements; the empty one is 0."""
        if not side:
            return [_piece("0")]
        found: list[Piece] = []
        for negative, term in list_terms(side):
            basis = " ^ ".join(print_mark(mark) for mark in term.factors)
            if not term.factors:
                body = self._term(term.coefficient)
            elif is_unit(term.coefficient):
                body = [_piece(basis)]
            elif is_sum(term.coefficient):
                body = [_piece("("), *nest(self.pieces(term.coefficient)), _piece(f") {basis}")]
            else:
                body = self._term(term.coefficient)
                product = flatten_product(term.coefficient, self.symbols)
                if product.under or product.parts[1]:  # x/2 y' might be read as x/(2 y')
                    sign, body = body[: product.negative], body[product.negative :]
                    body = [*sign, _piece("("), *nest(body), _piece(")")]
                body = [*body, _piece(f" {basis}")]
            add_term(found, negative, body, len)
        return found

    def _term(self, term: Expr) -> list[Piece]:
        """A product; its sign has been taken out."""
        product = flatten_product(term, self.symbols)
        above, below = product.parts
        top: list[Piece] = []
        if above or not product.over:
            top.append(_piece(above or "1"))
        for factor in product.over:
            if top:
                top.append(_piece("*"))
            top += self._factor(factor)
        under = [self._factor(factor) for factor in product.under]
        if below:
            under.insert(0, [_piece(below)])
        if product.negative:
            top.insert(0, _piece("-"))
        if not under:
            return top
        if len(under) == 1:
            return [*top, _piece("/"), *under[0]]
        bottom = [piece for k, part in enumerate(under) for piece in ([_piece("*")] if k else []) + part]
        return [*top, _piece("/("), *bottom, _piece(")")]

    def _factor(self, factor: Expr) -> list[Piece]:
        match factor:
            case Number():
                return [_piece(_fraction(factor.value))]
            case Pi():
                return [_piece("pi")]
            case Ref():
                return [_piece(print_mark(self.symbols[factor.name].mark))]
            case Power():
                exponent = str(factor.exponent) if factor.exponent > 0 else f"({factor.exponent})"
                return [*self._base(factor.base), _piece(f"^{exponent}")]
            case Call():
                return self._call(factor)
            case Binary() | Negate():
                return [_piece("("), *nest(self.pieces(factor)), _piece(")")]

    def _base(self, base: Expr) -> list[Piece]:
        if isinstance(base, Ref | Call | Pi) and not (isinstance(base, Call) and base.function == "pow"):
            return self._factor(base)
        return [_piece("("), *nest(self.pieces(base)), _piece(")")]

    def _call(self, call: Call) -> list[Piece]:
        if call.function == "pow":
            base, exponent = call.arguments
            return [*self._base(base), _piece("^("), *nest(self.pieces(exponent)), _piece(")")]
        inner = [
            piece for k, a in enumerate(call.arguments) for piece in ([_piece(", ")] if k else []) + self.pieces(a)
        ]
        return [_piece(f"{call.function}("), *hold(inner, _NARROW), _piece(")")]


def _piece(text: str) -> Piece:
    return Piece(text, len(text))


def _fraction(value: Fraction) -> str:
    above, below = split_number(abs(value))
    text = f"{'-' if value < 0 else ''}{above or '1'}{f'/{below}' if below else ''}"
    return text if value >= 0 and not below else f"({text})"
