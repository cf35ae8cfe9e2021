"""Sines and cosines of two angles at once: each operation of the polynomials in both halves of a vector."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.emit.c.arrange import TURNED
from nhc.emit.names import list_bound_names
from nhc.emit.statements import iterate_refs
from nhc.program.contents import list_expressions, walk
from nhc.program.ir import Call, Expr, Statement
from nhc.records import record


@record
class Pair:
    """Two angles that are known before the statement at ``place``, which is the first to need one of them."""

    place: int
    angles: tuple[Expr, Expr]


def pair_angles(body: Sequence[Statement]) -> list[Pair]:
    """Each angle of a sine or cosine with the next one that is known when it is needed; some may stay alone."""
    known: dict[str, int] = {}  # name -> the first place at which it may be used
    needed: dict[Expr, int] = {}
    for place, statement in enumerate(body):
        parts = (part for expression in list_expressions(statement) for part in walk(expression))
        for part in parts:
            if isinstance(part, Call) and part.function in TURNED:
                needed.setdefault(part.arguments[0], place)
        known.update((name, place + 1) for name in list_bound_names((statement,)))
    ready = {angle: max((known.get(name, 0) for name in iterate_refs(angle)), default=0) for angle in needed}
    waiting, pairs = list(needed), list[Pair]()
    while waiting:
        one = waiting.pop(0)
        other = next((angle for angle in waiting if ready[angle] <= needed[one]), None)
        if other is not None:
            waiting.remove(other)
            pairs.append(Pair(needed[one], (one, other)))
    return pairs
