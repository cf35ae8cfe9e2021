"""Which statements are the same ones, a body further: the shift along a chain, found in straight code.

The shift takes a statement to one of the same outline whose operands are the shifted operands.  It is sought from the results
downwards (an entry of the output and the entry a stride further must be computed alike) and then upwards from what was found.
Nothing depends on the shift being right: whether statements can share a loop is decided operand by operand afterwards.
"""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Mapping, Sequence

from nhc.program.ir import Binary, Call, Expr, Let, Load, Negate, Number, Power, Ref, Store
from nhc.records import structure

LEAST = 5  # passes that a loop must have
_STRIDES = 4  # strides of the output that are tried

Outline = tuple[object, ...]


def trace(value: Expr) -> tuple[Outline, tuple[str, ...]]:
    """What an expression does, operand by operand in preorder, with a blank for each name; and the names."""
    tokens: list[object] = []
    names: list[str] = []
    stack: list[Expr] = [value]
    while stack:
        node = stack.pop()
        if isinstance(node, Ref):
            tokens.append("")
            names.append(node.name)
        elif isinstance(node, Binary):
            tokens.append(node.op)
            stack += (node.right, node.left)
        elif isinstance(node, Negate):
            tokens.append("negate")
            stack.append(node.operand)
        elif isinstance(node, Power):
            tokens.append(("power", node.exponent))
            stack.append(node.base)
        elif isinstance(node, Call):
            tokens.append((node.function, len(node.arguments)))
            stack += reversed(node.arguments)
        else:
            tokens.append(node.value if isinstance(node, Number) else "pi")
    return tuple(tokens), tuple(names)


@structure
class Piece:
    """A let or a store: its key (a store's is made up), its place in the code, outline and operands."""

    key: str
    statement: Let | Store
    place: int
    outline: Outline
    operands: tuple[str, ...]


def list_pieces(body: Sequence[object]) -> dict[str, Piece]:
    """The lets and stores of a body by key, in their order."""
    pieces: dict[str, Piece] = {}
    for place, statement in enumerate(body):
        if isinstance(statement, Let | Store):
            outline, operands = trace(statement.value)
            stored = isinstance(statement, Store)
            key = f"{statement.array}[{statement.index}]" if isinstance(statement, Store) else statement.name
            outline = ("store", statement.array, *outline) if isinstance(statement, Store) else outline
            assert stored or key not in pieces
            pieces[key] = Piece(key, statement, place, outline, operands)
    return pieces


def find_orbits(
    pieces: Mapping[str, Piece], loads: Mapping[str, Load], hints: Sequence[Sequence[str]] = ()
) -> list[list[str]]:
    """Runs of statements, each the shift of the one before, at least ``LEAST`` long; none where there is no such order.

    ``hints``: names, each perhaps the shift of the one before.
    """
    stores = [piece for piece in pieces.values() if isinstance(piece.statement, Store)]
    alike: dict[Outline, list[int]] = {}
    for piece in stores:
        assert isinstance(piece.statement, Store)
        alike.setdefault(piece.outline, []).append(piece.statement.index)
    strides: Counter[int] = Counter()
    for places in alike.values():
        places.sort()
        strides.update(b - a for a, b in itertools.pairwise(places))
        strides.update(b - a for a, b in zip(places, places[2:], strict=False))
    best: list[list[str]] = []
    covered = 0
    tried = [stride for stride, times in strides.most_common(_STRIDES) if times >= LEAST - 1]
    for stride in tried or ([0] if hints else []):
        found = _Shift(pieces, loads).follow(stores, stride, hints)
        reached = sum(map(len, found))
        if reached > covered + covered // 8:
            best, covered = found, reached
    return best


class _Shift:
    """A partial one-to-one map of names, grown from pairs of results."""

    def __init__(self, pieces: Mapping[str, Piece], loads: Mapping[str, Load]) -> None:
        self.pieces, self.loads = pieces, loads
        self.next: dict[str, str] = {}
        self.taken: set[str] = set()

    def follow(self, stores: Sequence[Piece], stride: int, hints: Sequence[Sequence[str]]) -> list[list[str]]:
        """The orbits of the shift that takes each entry of the output to the one a stride further."""
        by_index = {piece.statement.index: piece for piece in stores if isinstance(piece.statement, Store)}
        for index in sorted(by_index):
            further = by_index.get(index + stride)
            if further is not None and further.outline == by_index[index].outline:
                self._pair(by_index[index].key, further.key)
        for names in hints:
            for one, other in itertools.pairwise(names):
                self._pair(one, other)
        self._climb()
        return self._list_orbits()

    def _pair(self, one: str, other: str) -> None:
        stack = [(one, other)]
        while stack:
            one, other = stack.pop()
            if one == other or one in self.next or other in self.taken:
                continue
            first, second = self.pieces.get(one), self.pieces.get(other)
            if first is None or second is None:
                if first is not second or not self._are_alike(one, other):
                    continue
            elif first.outline != second.outline:
                continue
            self.next[one] = other
            self.taken.add(other)
            if first is not None and second is not None:
                stack += reversed(list(zip(first.operands, second.operands, strict=True)))

    def _are_alike(self, one: str, other: str) -> bool:
        """Whether two numbers that are read may be shifts of each other."""
        first, second = self.loads.get(one), self.loads.get(other)
        if first is None or second is None:
            return first is second
        return first.array == second.array

    def _climb(self) -> None:
        """Statements whose operands have all been found, and which are there a body further, too."""
        known = {(piece.outline, piece.operands): key for key, piece in self.pieces.items()}
        for key, piece in self.pieces.items():
            if key in self.next or not piece.operands or isinstance(piece.statement, Store):
                continue
            shifted = tuple(self.next.get(name, name) for name in piece.operands)
            other = known.get((piece.outline, shifted))
            if other is not None and other != key and other not in self.taken:
                self.next[key] = other
                self.taken.add(other)

    def _list_orbits(self) -> list[list[str]]:
        orbits = []
        for key in self.pieces:
            if key in self.taken or key not in self.next:
                continue
            orbit = [key]
            while orbit[-1] in self.next:
                orbit.append(self.next[orbit[-1]])
            if len(orbit) >= LEAST:
                orbits.append(orbit)
        return orbits
