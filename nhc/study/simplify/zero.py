"""Parts of an expression replaced, by zero above all, and what then vanishes with them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Set
from fractions import Fraction

from nhc.diagnostics import Span
from nhc.language.expressions.syntax import (
    Binary,
    Call,
    Differential,
    Name,
    Negate,
    Number,
    Prime,
    Syntax,
    children,
    fold_tree,
    rebuild,
    walk,
)

ZERO = Number(Fraction(0), Span(0, 0))
_ONE = Number(Fraction(1), Span(0, 0))
INFINITE = Name("infinity", Span(0, 0))
"""What is larger than all else; a tree that still holds it has no limit that is written without it."""
_VANISHING = ("sin", "tan", "asin", "atan", "sinh", "tanh", "sqrt", "abs", "sign")
Swap = Callable[[Syntax], Syntax | None]


def is_zero(tree: Syntax) -> bool:
    """Whether a tree is the number 0 as it stands."""
    return isinstance(tree, Number) and tree.value == 0


def is_infinite(tree: Syntax) -> bool:
    """Whether a tree holds what has no limit."""
    return any(node is INFINITE for node in walk(tree))


def replace_parts(tree: Syntax, swap: Swap, still: Set[str] = frozenset()) -> Syntax:
    """The tree with ``swap(node)`` in the place of the nodes for which it is not None; zeros that come in are worked off.

    ``still``: names that no longer move, of which a time derivative is 0.
    """

    def visit(node: Syntax, parts: tuple[Syntax, ...]) -> Syntax:
        new = swap(node)
        if new is not None:
            return new
        new = rebuild(node, parts)
        if isinstance(new, Prime) and (new is not node or still) and _stands(new.operand, still):
            return ZERO
        return new if new is node else _shorten(new)

    return fold_tree(tree, visit)


def _stands(tree: Syntax, still: Set[str]) -> bool:
    """Whether a tree holds numbers and names that do not move only."""
    return all(not isinstance(node, Name) or node.name in still for node in walk(tree) if not children(node))


def _shorten(node: Syntax) -> Syntax:
    """A node some parts of which have changed, without the zeros and infinities in it."""
    match node:
        case Prime() | Negate() if node.operand is INFINITE:
            return INFINITE
        case Prime() | Negate() if is_zero(node.operand):
            return ZERO
        case Call() if any(argument is INFINITE for argument in node.arguments):
            return INFINITE
        case Call() if node.function in _VANISHING and is_zero(node.arguments[0]):
            return ZERO
        case Call() if node.function in ("cos", "cosh", "exp") and is_zero(node.arguments[0]):
            return _ONE
        case Binary() if node.left is INFINITE or node.right is INFINITE:
            return _limit(node)
        case Binary():
            return _shorten_binary(node)
    return node


def _limit(node: Binary) -> Syntax:
    """A sum, product or power with something infinite in it."""
    if node.op == "/" and node.left is not INFINITE:
        return ZERO
    if node.op == "^" and node.right is not INFINITE:
        negative = isinstance(node.right, Negate) or (isinstance(node.right, Number) and node.right.value < 0)
        return ZERO if negative else INFINITE
    return INFINITE


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
    """(term, whether it is subtracted) of every sum in a tree: at its top, in factors, powers, divisors and functions.

    ``whole``: a tree that is no sum is a term itself.  That the rest of the tree is not linear in a sum does not matter:
    what is left out is measured.
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
        if not isinstance(node, Differential):
            stack += [(part, False, False) for part in reversed(children(node))]


def is_named(node: Syntax, name: str) -> bool:
    """Whether a node is that name."""
    return isinstance(node, Name) and node.name == name
