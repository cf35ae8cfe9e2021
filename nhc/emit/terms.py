"""Expressions as a reader orders them: sums with the positive terms first, products with numbers and parameters first."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from nhc.program.ir import Binary, Call, Expr, Negate, Number, Pi, Power, Ref
from nhc.program.sheets.model import RANK_STEP, Side, Symbol, Term
from nhc.records import record

_ONE = Fraction(1)
_NUMBER, _PI, _SUM, _CALL = 0, 1, 8 * RANK_STEP, 9 * RANK_STEP
_AWKWARD = 20  # smallest denominator of a fraction that is set as a decimal
_PLACES, _SMALL = 9, Fraction(1, 1000)  # of a decimal: the most places, and the smallest value


@record
class Product:
    """``number * over... / under...`` with a positive number; ``negative`` is its sign."""

    negative: bool
    number: Fraction
    over: tuple[Expr, ...]
    under: tuple[Expr, ...]

    @property
    def parts(self) -> tuple[str, str]:
        """What of the number stands above and below the line; empty for 1."""
        return split_number(self.number)


def split_number(value: Fraction) -> tuple[str, str]:
    """Numerator and denominator of a positive number, empty for 1; a decimal above where a fraction would be awkward.

    2.25 is 9/4 and 0.3 is 3/10, but 9.81 remains 9.81: a finite decimal, and no simple fraction.
    """
    places = next((k for k in range(_PLACES + 1) if 10**k % value.denominator == 0), 0)
    if places == 0 or value.denominator % 5 or value.denominator < _AWKWARD or value < _SMALL:
        above, below = ("" if part == 1 else str(part) for part in (value.numerator, value.denominator))
        return above, below
    digits = f"{value.numerator * (10**places // value.denominator):0{places + 1}d}"
    return f"{digits[:-places]}.{digits[-places:]}", ""


def flatten_sum(expression: Expr) -> list[tuple[bool, Expr]]:
    """(negative, term) for each term; one that is positive comes first where there is one."""
    found: list[tuple[bool, Expr]] = []
    stack = [(False, expression)]
    while stack:
        negative, part = stack.pop()
        match part:
            case Binary(op="+" | "-"):
                stack.append((negative != (part.op == "-"), part.right))
                stack.append((negative, part.left))
            case Negate():
                stack.append((not negative, part.operand))
            case Number() if part.value < 0:
                found.append((not negative, Number(-part.value)))
            case _:
                found.append((negative, part))
    found = _collected(found)
    first = next((k for k, (negative, _) in enumerate(found) if not negative), 0)
    return [found[first], *found[:first], *found[first + 1 :]]


def _collected(terms: list[tuple[bool, Expr]]) -> list[tuple[bool, Expr]]:
    """Terms of the same factors as one; a sum that the graph keeps in two halves may hold them twice."""
    if len(terms) < 2:
        return terms
    totals: dict[object, Fraction] = {}
    first: dict[object, int] = {}
    keys = list[object]()
    for k, (negative, term) in enumerate(terms):
        inside, number, over, under = _split(term)
        key = frozenset(_exponents(over).items()), frozenset(_exponents(under).items())
        keys.append(key)
        totals[key] = totals.get(key, Fraction(0)) + (number if negative == inside else -number)
        first.setdefault(key, k)
    if len(totals) == len(terms):
        return terms
    kept = [k for k, key in enumerate(keys) if first[key] == k and totals[key]]
    return [(totals[keys[k]] < 0, _product(abs(totals[keys[k]]), flatten_product(terms[k][1], {}))) for k in kept] or [
        (False, Number(Fraction(0)))
    ]


def _product(number: Fraction, product: Product) -> Expr:
    total: Expr = Number(number)
    for k, factor in enumerate(product.over):
        total = factor if k == 0 and number == 1 else Binary("*", total, factor)
    for factor in product.under:
        total = Binary("/", total, factor)
    return total


def flatten_product(expression: Expr, symbols: Mapping[str, Symbol]) -> Product:
    """The factors of a term, in reading order."""
    negative, number, over, under = _split(expression)
    return Product(negative, number, _ordered(over, symbols), _ordered(under, symbols))


def _split(expression: Expr) -> tuple[bool, Fraction, list[Expr], list[Expr]]:
    """Whether a term is negative, its number, its factors and its divisors."""
    negative, number = False, _ONE
    over: list[Expr] = []
    under: list[Expr] = []
    stack = [(False, expression)]
    while stack:
        below, part = stack.pop()
        match part:
            case Binary(op="*" | "/"):
                stack.append((below != (part.op == "/"), part.right))
                stack.append((below, part.left))
            case Negate():
                negative = not negative
                stack.append((below, part.operand))
            case Number() if part.value != 0:
                negative = negative != (part.value < 0)
                number = number / abs(part.value) if below else number * abs(part.value)
            case _:
                (under if below else over).append(part)
    return negative, number, over, under


def _ordered(factors: list[Expr], symbols: Mapping[str, Symbol]) -> tuple[Expr, ...]:
    if len(factors) < 2:
        return tuple(factors)
    gathered = [base if n == 1 else Power(base, n) for base, n in _exponents(factors).items()]
    return tuple(sorted(gathered, key=lambda factor: _rank(factor, symbols)))


def _exponents(factors: list[Expr]) -> dict[Expr, int]:
    """Equal factors as one power: the exponents that are not zero."""
    exponents: dict[Expr, int] = {}
    for factor in factors:
        base, n = (factor.base, factor.exponent) if isinstance(factor, Power) else (factor, 1)
        exponents[base] = exponents.get(base, 0) + n
    return {base: n for base, n in exponents.items() if n}


def _rank(factor: Expr, symbols: Mapping[str, Symbol]) -> int:
    match factor:
        case Number():
            return _NUMBER
        case Pi():
            return _PI
        case Ref():
            return symbols[factor.name].rank if symbols else 0
        case Power():
            return _rank(factor.base, symbols)
        case Call():
            inner = factor.arguments[0]
            return _CALL + (_rank(inner, symbols) % RANK_STEP if isinstance(inner, Ref) else RANK_STEP // 2)
        case _:
            return _SUM


def is_sum(expression: Expr) -> bool:
    """Whether the expression has several terms."""
    return len(flatten_sum(expression)) > 1


def is_unit(expression: Expr) -> bool:
    """Whether the expression is 1 or -1."""
    return isinstance(expression, Number) and abs(expression.value) == 1


def list_terms(side: Side) -> list[tuple[bool, Term]]:
    """(negative, term) of a side: a lone sum without factors is split, other signs are taken out of the coefficients."""
    found: list[tuple[bool, Term]] = []
    for term in side:
        parts = flatten_sum(term.coefficient)
        if not term.factors:
            found.extend((negative, Term(part)) for negative, part in parts)
        elif len(parts) == 1:
            found.append((parts[0][0], Term(parts[0][1], term.factors)))
        elif all(negative for negative, _ in parts):
            found.append((True, Term(_negated(parts), term.factors)))
        else:
            found.append((False, term))
    return found


def _negated(parts: list[tuple[bool, Expr]]) -> Expr:
    """The sum of terms that are all negative, with its sign changed."""
    total = parts[0][1]
    for _, part in parts[1:]:
        total = Binary("+", total, part)
    return total
