"""Syntax trees of expressions.

A tree may be as deep as its text is long (``1 + 1 + ...``), so nothing here recurses: every walk uses an explicit
stack, and nodes compare by identity; ``same`` compares what two trees say.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import TypeVar

from nhc.diagnostics import Span
from nhc.records import identity_record


@identity_record
class Number:
    """An exact number, not negative where it comes from a text."""

    value: Fraction
    span: Span


@identity_record
class Name:
    """A folded name: a coordinate, parameter, definition, quasi-velocity, ``t``, ``pi``, or in outputs an energy."""

    name: str
    span: Span


@identity_record
class Prime:
    """The total time derivative."""

    operand: Syntax
    span: Span


@identity_record
class Differential:
    """``d`` of a coordinate, a definition of positions, or ``t``; in constraints only."""

    name: str
    span: Span


@identity_record
class Negate:
    """Unary minus."""

    operand: Syntax
    span: Span


@identity_record
class Binary:
    """``op`` is one of ``+ - * / ^``; ``operator`` is the place of the sign itself."""

    op: str
    left: Syntax
    right: Syntax
    span: Span
    operator: Span


@identity_record
class Call:
    """A function of the language."""

    function: str
    arguments: tuple[Syntax, ...]
    span: Span


Syntax = Number | Name | Prime | Differential | Negate | Binary | Call
R = TypeVar("R")


def children(node: Syntax) -> tuple[Syntax, ...]:
    """Return the direct parts of a node, from left to right."""
    match node:
        case Binary():
            return (node.left, node.right)
        case Negate() | Prime():
            return (node.operand,)
        case Call():
            return node.arguments
        case _:
            return ()


def walk(root: Syntax) -> Iterator[Syntax]:
    """Yield the nodes of a tree, a node before its parts, from left to right."""
    stack = [root]
    while stack:
        node = stack.pop()
        yield node
        stack.extend(reversed(children(node)))


def fold_tree(root: Syntax, visit: Callable[[Syntax, tuple[R, ...]], R]) -> R:
    """Evaluate a tree bottom-up: ``visit(node, results of its parts)``."""
    results: list[R] = []
    stack: list[tuple[Syntax, bool]] = [(root, False)]
    while stack:
        node, ready = stack.pop()
        if isinstance(node, Name | Number | Differential):
            results.append(visit(node, ()))
        elif ready:
            count = len(node.arguments) if isinstance(node, Call) else 2 if isinstance(node, Binary) else 1
            values = tuple(results[len(results) - count :]) if count else ()
            if count:
                del results[len(results) - count :]
            results.append(visit(node, values))
        else:
            stack.append((node, True))
            if isinstance(node, Binary):
                stack += ((node.right, False), (node.left, False))
            elif isinstance(node, Call):
                stack += [(part, False) for part in reversed(node.arguments)]
            else:
                stack.append((node.operand, False))
    return results[0]


def rebuild(node: Syntax, parts: tuple[Syntax, ...]) -> Syntax:
    """Return the node with other parts."""
    if all(new is old for new, old in zip(parts, children(node), strict=True)):
        return node
    match node:
        case Binary():
            return Binary(node.op, parts[0], parts[1], node.span, node.operator)
        case Negate():
            return Negate(parts[0], node.span)
        case Prime():
            return Prime(parts[0], node.span)
        case Call():
            return Call(node.function, parts, node.span)
        case _:
            return node


def _head(node: Syntax) -> tuple[object, ...]:
    match node:
        case Number():
            return ("number", node.value)
        case Name():
            return ("name", node.name)
        case Differential():
            return ("differential", node.name)
        case Binary():
            return ("binary", node.op)
        case Call():
            return ("call", node.function, len(node.arguments))
        case Negate():
            return ("negate",)
        case Prime():
            return ("prime",)


def same(first: Syntax, second: Syntax) -> bool:
    """Say whether two trees are equal but for their places."""
    stack = [(first, second)]
    while stack:
        left, right = stack.pop()
        if _head(left) != _head(right):
            return False
        stack.extend(zip(children(left), children(right), strict=True))
    return True
