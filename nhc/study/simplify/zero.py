"""Parts of an expression set to zero, and what then vanishes with them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from nhc.diagnostics import Span
from nhc.language.syntax import Binary, Call, Name, Negate, Number, Prime, Syntax, fold_tree, rebuild

ZERO = Number(Fraction(0), Span(0, 0))
_ONE = Number(Fraction(1), Span(0, 0))
_VANISHING = ("sin", "tan", "asin", "atan", "sinh", "tanh", "sqrt", "abs", "sign")


def is_zero(tree: Syntax) -> bool:
    """Whether a tree is the number 0 as it stands."""
    return isinstance(tree, Number) and tree.value == 0


def vanish(tree: Syntax, gone: Callable[[Syntax], bool]) -> Syntax:
    """The tree with 0 for the parts that are ``gone``; what was written with a 0 and stays is left as it is."""

    def visit(node: Syntax, parts: tuple[Syntax, ...]) -> Syntax:
        if gone(node):
            return ZERO
        new = rebuild(node, parts)
        return new if new is node else _shorten(new)

    return fold_tree(tree, visit)


def _shorten(node: Syntax) -> Syntax:
    """A node some parts of which have changed, without the zeros in it."""
    match node:
        case Prime() | Negate() if is_zero(node.operand):
            return ZERO
        case Call() if node.function in _VANISHING and is_zero(node.arguments[0]):
            return ZERO
        case Call() if node.function in ("cos", "cosh", "exp") and is_zero(node.arguments[0]):
            return _ONE
        case Binary():
            return _shorten_binary(node)
    return node


def _shorten_binary(node: Binary) -> Syntax:
    left, right = node.left, node.right
    match node.op:
        case "+" if is_zero(left):
            return right
        case "+" | "-" if is_zero(right):
            return left
        case "-" if is_zero(left):
            return Negate(right, node.span)
        case "*" if is_zero(left) or is_zero(right):
            return ZERO
        case "/" if is_zero(left) and not is_zero(right):
            return ZERO
        case "^" if is_zero(right) and not is_zero(left):
            return _ONE
        case "^" if is_zero(left) and isinstance(right, Number) and right.value > 0:
            return ZERO
    return node


def list_terms(tree: Syntax, whole: bool) -> Iterator[tuple[Syntax, bool]]:
    """(term, whether it is subtracted) of every sum in a tree: at its top, and in factors of its terms.

    ``whole``: a tree that is no sum is a term itself.  Sums inside of powers and functions are no terms: the tree is not
    linear in them.
    """
    stack: list[tuple[Syntax, bool, bool]] = [(tree, False, whole)]
    while stack:
        node, minus, is_term = stack.pop()
        match node:
            case Binary(op="+" | "-"):
                stack.append((node.right, minus != (node.op == "-"), True))
                stack.append((node.left, minus, True))
                continue
            case Negate():
                stack.append((node.operand, not minus, is_term))
                continue
        if is_term and not is_zero(node):
            yield node, minus
        match node:
            case Binary(op="*"):
                stack.append((node.right, False, False))
                stack.append((node.left, False, False))
            case Binary(op="/"):
                stack.append((node.left, False, False))


def is_named(node: Syntax, name: str) -> bool:
    """Whether a node is that name."""
    return isinstance(node, Name) and node.name == name
