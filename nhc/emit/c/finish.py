"""What a function tests before it says that its output is good: a short sum in place of every entry and every pivot.

Infinities and NaN pass through sums, products and roots, so that a finite rate proves much of what it was computed from to be
finite, and a finite quotient proves its denominator to be nonzero.  What is proved so is not tested again; which block was singular
is found out after the test has failed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from functools import reduce

from nhc.emit.c.body import BodyPrinter
from nhc.program.contents import walk
from nhc.program.ir import (
    Binary,
    Call,
    Expr,
    Guard,
    Let,
    Load,
    Negate,
    Number,
    Pi,
    Power,
    Ref,
    Section,
    Statement,
    Store,
)
from nhc.records import record

MOST = 64  # terms of a sum that is written out
_THROUGH = frozenset(
    {"sin", "cos", "tan", "asin", "acos", "sinh", "cosh", "sqrt", "abs", "log"}
)  # no finite value at an infinity
_UPRIGHT = frozenset({"sqrt", "abs", "sin", "tan", "asin", "sinh"})  # zero where their argument is
_BOUNDED = frozenset({"sin", "cos"})
_ZERO = Number(Fraction(0))


@record
class Finish:
    """Entries of the output whose sum is tested, and the guards that it does not decide.

    ``factors``: values that are not zero if and only if the same holds for all of these guards without a scale.
    """

    entries: tuple[int, ...]
    guards: tuple[Guard, ...]
    factors: tuple[Expr, ...] = ()


def choose_finish(body: Sequence[Statement]) -> Finish | None:
    """What must be tested at the end of a body; None where parts of it stand elsewhere or leave early, or where it is too long."""
    if not all(isinstance(s, Section | Load | Let | Guard | Store) for s in body):
        return None
    proof = _Proof(body)
    stores = [s for s in body if isinstance(s, Store)]
    entries: list[int] = []
    simple = [s for s in stores if _is_simple(s.value)]
    for store in (*(s for s in reversed(stores) if not _is_simple(s.value)), *simple):  # the last depend on most
        if not proof.bounds(store.value):
            entries.append(store.index)
            proof.assume_finite(store.value)
    if len(entries) > MOST:
        return None
    found, guards = proof.copy(), list[Guard]()
    for guard in reversed([s for s in body if isinstance(s, Guard)]):  # the last depend on most
        if not (guard.scale == _ZERO and proof.excludes_zero(guard.value)):
            guards.insert(0, guard)
            if guard.scale == _ZERO:  # others may be negative, with a negative mass
                proof.assume_nonzero(guard.value)
    return Finish(
        tuple(sorted(entries)), tuple(guards), found.choose_factors([g.value for g in guards if g.scale == _ZERO])
    )


def _is_simple(value: Expr) -> bool:
    return isinstance(value, Ref) or (
        isinstance(value, Binary) and isinstance(value.left, Ref) and isinstance(value.right, Ref)
    )


def print_finish(
    printer: BodyPrinter,
    finish: Finish,
    body: Sequence[Statement],
    output: str,
    size: int,
    near: tuple[str, str],
) -> None:
    """The test and, behind it, which block is singular or which entry infinite where it fails, if any.

    ``near``: what holds besides where the inlined sine and cosine may be taken, and how to leave where it does not.
    """
    total = " + ".join(f"{output}[{index}]" for index in finish.entries)
    tests = print_tests(printer, finish, total) + [near[0]] * bool(near[0])
    if tests:
        if finish.entries:
            printer.add_comment("an infinity, a NaN or a division by zero anywhere above stays in this sum")
        if finish.entries and finish.factors:
            printer.add_comment("(times 0 it is NaN then, and the comparison fails)")
        printer.open_unless(tests)
        if near[0]:
            printer.print_exit(near[0], near[1])
        for statement in body:
            if isinstance(statement, Guard):
                printer.print_guard(statement)
        printer.helpers.add("finish")
        printer.add(f"return {printer.prefix}_finish({size}, {output});")  # finite numbers may have an infinite sum
        printer.close()
    printer.add(f"return {printer.prefix.upper()}_OK;")


def print_tests(printer: BodyPrinter, finish: Finish, total: str) -> list[str]:
    """The conditions under which all is good; 0 times the sum is NaN where it is not finite, and no product is larger than that."""
    tests = [printer.print_good(guard) for guard in finish.guards if guard.scale != _ZERO]
    if not finish.factors:
        return [f"fabs({total}) <= DBL_MAX"] * bool(total) + tests
    product = printer.printer.print(
        Call("abs", (reduce(lambda left, right: Binary("*", left, right), finish.factors),))
    )
    if not total:
        return [f"{product} > 0.0", *tests]
    return [f"{product} > 0.0 * {total}" if len(finish.entries) == 1 else f"{product} > 0.0 * ({total})", *tests]


def _is_product(value: Expr) -> bool:
    match value:
        case Ref() | Negate() | Binary(op="*"):
            return True
        case Power():
            return value.exponent > 0
    return False


def _count_products(factors: Sequence[Expr]) -> int:
    """The operations of a product of these."""
    return max(len(factors) - 1, 0) + sum(not isinstance(part, Ref) for factor in factors for part in walk(factor))


class _Proof:
    """Names that are known to be finite, and names that are known to be neither zero nor NaN."""

    def __init__(self, body: Iterable[Statement]) -> None:
        self._values = {s.name: s.value for s in body if isinstance(s, Let)}
        self._finite: set[str] = set()
        self._nonzero: set[str] = set()
        self._inputs = {s.name for s in body if isinstance(s, Load)}

    def copy(self) -> _Proof:
        """The same, which does not learn what this one will."""
        made = _Proof(())
        made._values, made._inputs = self._values, self._inputs
        made._finite, made._nonzero = set(self._finite), set(self._nonzero)
        return made

    def choose_factors(self, values: Sequence[Expr]) -> tuple[Expr, ...]:
        """What may still be zero where one of the values is: products as they stand, or all their factors, whichever are fewer."""
        whole, apart = (
            tuple(dict.fromkeys(factor for value in values for factor in self._list_factors(value, opened)))
            for opened in (False, True)
        )
        return apart if _count_products(apart) <= _count_products(whole) else whole

    def _list_factors(self, value: Expr, opened: bool) -> list[Expr]:
        """The factors that are not known to be neither zero nor NaN; ``opened``: those of named products too."""
        found: list[Expr] = []
        stack = [value]
        while stack:
            part = stack.pop()
            match part:
                case Ref():
                    inner = self._values.get(part.name) if opened else None
                    if part.name in self._nonzero:
                        continue
                    if inner is not None and _is_product(inner):
                        stack.append(inner)
                    else:
                        found.append(part)
                case Binary(op="*"):
                    stack += (part.right, part.left)
                case Negate():
                    stack.append(part.operand)
                case Power() if part.exponent > 0:
                    stack.append(part.base)
                case Call(function="abs"):
                    stack += part.arguments
                case Number() if part.value:
                    continue
                case _:
                    found.append(part)
        return found

    def assume_finite(self, expression: Expr) -> None:
        """Draw what follows from a finite value."""
        stack = [expression]
        while stack:
            part = stack.pop()
            match part:
                case Ref():
                    if part.name not in self._finite:
                        self._finite.add(part.name)
                        stack += [self._values[part.name]] if part.name in self._values else []
                case Binary():
                    stack.append(part.left)
                    if part.op == "/":
                        self.assume_nonzero(part.right)
                    else:
                        stack.append(part.right)
                case Negate():
                    stack.append(part.operand)
                case Power():
                    if part.exponent > 0:
                        stack.append(part.base)
                    else:
                        self.assume_nonzero(part.base)
                case Call():
                    stack += part.arguments if part.function in _THROUGH else ()
                case Number() | Pi():
                    pass

    def assume_nonzero(self, expression: Expr) -> None:
        """Draw what follows from a value that is neither zero nor NaN."""
        stack = [expression]
        while stack:
            part = stack.pop()
            match part:
                case Ref():
                    if part.name not in self._nonzero:
                        self._nonzero.add(part.name)
                        stack += [self._values[part.name]] if part.name in self._values else []
                case Binary(op="*"):
                    stack += (part.left, part.right)
                case Binary(op="/"):
                    stack.append(part.left)
                case Negate():
                    stack.append(part.operand)
                case Power():
                    stack += [part.base] if part.exponent > 0 else []
                case Call():
                    stack += part.arguments if part.function in _UPRIGHT else ()
                case _:
                    pass

    def excludes_zero(self, expression: Expr) -> bool:
        """Whether the value is known to be neither zero nor NaN."""
        match expression:
            case Ref():
                return expression.name in self._nonzero
            case Negate():
                return self.excludes_zero(expression.operand)
            case Call(function="abs"):
                return self.excludes_zero(expression.arguments[0])
        return False

    def bounds(self, expression: Expr) -> bool:
        """Whether the value is known to be finite without a test."""
        match expression:
            case Number() | Pi():
                return True
            case Ref():
                if expression.name in self._finite:
                    return True
                value = self._values.get(expression.name)
                return value is not None and self.bounds(value)
            case Negate():
                return self.bounds(expression.operand)
            case Call():
                return expression.function in _BOUNDED and self.bounds(expression.arguments[0])
            case Binary(op="*"):
                pairs = ((expression.left, expression.right), (expression.right, expression.left))
                return any(self._is_turned(one) and self.bounds(other) for one, other in pairs)
        return False

    def _is_turned(self, expression: Expr) -> bool:
        """Whether the value lies between -1 and 1."""
        if isinstance(expression, Ref):
            value = self._values.get(expression.name)
            return value is not None and self._is_turned(value)
        return isinstance(expression, Call) and expression.function in _BOUNDED and self.bounds(expression.arguments[0])
