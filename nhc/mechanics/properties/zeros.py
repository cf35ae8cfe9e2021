"""Where a long expression vanishes: told by its factors, for nobody reads it whole, and a part of it says nothing."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.bounds.subdivision import cannot_vanish_together
from nhc.algebra.graph import Node
from nhc.algebra.parts import split_powers
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.mechanics.properties.named import LONG, is_cut, zero_text
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.system import System

_WHOLE, _FACTOR = 160, 60
"""Characters of an expression, and of a factor of one, that are told."""
_POSITIVE = frozenset({"exp", "cosh"})


def never_vanishes(system: System, node: Node | None) -> bool:
    """Whether a determinant is not zero at any state."""
    g, known = system.graph, intervals(system)
    return node is not None and (cannot_vanish(g, node, known) or cannot_vanish_together(g, [node], known))


def where_zero(system: System, node: Node, quote: str, text: str = "") -> str:
    """What follows "where" of an expression: that it is zero, or which of its factors are; ``quote`` stands around formulas.

    ``text``: how it is written; by default in the shortest way.
    """
    text = text or zero_text(system, node)
    if len(text) <= _WHOLE:
        return f"{quote}{text} = 0{quote}"
    short, long = _told(system, _forms(system, node)[0])
    told = [f"{quote}{factor} = 0{quote}" for factor in short]
    if long or not told:
        told.append("another factor, a long expression, vanishes" if told else f"{LONG} vanishes")
    return f"{', '.join(told[:-1])} or {told[-1]}" if len(told) > 1 else told[0]


def where_all_zero(system: System, nodes: Sequence[Node], texts: Sequence[str], most: int, quote: str) -> str:
    """The same for expressions that vanish together: all of them, or the factors that they share, and what else there is."""
    shown = " = ".join(texts[:most])
    if len(shown) <= 2 * _WHOLE and not any(map(is_cut, texts[:most])):
        others = f", where {len(texts) - most} other minors vanish, too" if len(texts) > most else ""
        return f"{quote}{shown} = 0{quote}{others}"
    every = [{base for form in _forms(system, node) for base in form} for node in nodes]
    short, _ = _told(system, [base for base in _forms(system, nodes[0])[0] if all(base in other for other in every)])
    told = [f"{quote}{factor} = 0{quote}" for factor in short]
    return ", ".join([*told, f"{'or where ' if told else ''}{len(nodes)} minors, long expressions, vanish together"])


def _told(system: System, bases: Sequence[Node]) -> tuple[list[str], bool]:
    """The short ones of these factors that may vanish, and whether there are longer ones."""
    texts = [zero_text(system, base) for base in bases if not never_vanishes(system, base)]
    short = sorted((text for text in texts if len(text) <= _FACTOR), key=len)
    return short, len(short) < len(texts)


def _forms(system: System, node: Node) -> list[list[Node]]:
    """Its factors that move, as it is written and with its angles in canonical form; first the form that has more of them."""
    g, still, found = system.graph, system.graph.mask(system.p), []
    for form in (node, normalise_angles(g, node, 40)):
        powers = split_powers(g, form)[1]
        found.append([b for b, n in powers.items() if n > 0 and g.deps[b] & ~still and g.op[b] not in _POSITIVE])
    return sorted(found, key=len, reverse=True)
