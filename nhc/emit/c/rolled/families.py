"""Families of statements that one line of a loop can stand for, and what their operands are from pass to pass.

A member's operand is, over the passes, one name; an input's entries at equal distances; the members of a family, each a fixed
number of passes off, but for a few other names at the ends; or other names throughout, which must then be put into an array.
Orbits of the shift are shortened until all their operands are of these kinds.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence

from nhc.emit.c.rolled.shift import LEAST, Piece
from nhc.program.ir import Load
from nhc.records import record, structure


@structure
class Family:
    """Statements in the order of the shift; the positions ``low`` to ``high`` of the orbit are the members."""

    orbit: tuple[str, ...]
    low: int
    high: int

    @property
    def members(self) -> tuple[str, ...]:
        return self.orbit[self.low : self.high + 1]


@record
class Edge:
    """A family uses another's members ``ahead`` positions further on its own positions."""

    user: int
    used: int
    ahead: int


class Families:
    """The families of a body, by number; ``home`` says of each member where it stands."""

    def __init__(self, pieces: Mapping[str, Piece], loads: Mapping[str, Load], orbits: Sequence[Sequence[str]]) -> None:
        self.pieces, self.loads = pieces, loads
        self.all: dict[int, Family] = {k: Family(tuple(orbit), 0, len(orbit) - 1) for k, orbit in enumerate(orbits)}
        self.home: dict[str, tuple[int, int]] = {
            key: (k, place) for k, family in self.all.items() for place, key in enumerate(family.orbit)
        }
        self._slots: dict[tuple[int, int, int], list[tuple[str, ...]]] = {}
        self._names: dict[tuple[int, int, int], tuple[frozenset[str], frozenset[str]]] = {}
        self._edges: dict[int, list[Edge]] = {}
        self.frozen = set[int]()  # families that stand in a loop
        self._users: dict[str, set[int]] = {}
        for k, family in self.all.items():
            for key in family.orbit:
                for name in pieces[key].operands:
                    self._users.setdefault(name, set()).add(k)
        self._settle(set(self.all))

    def freeze(self, spans: Mapping[int, tuple[int, int]]) -> None:
        """Families have found their loop, with these positions; their other members become statements of their own."""
        self.frozen |= spans.keys()
        waiting = set[int]()
        for number, (low, high) in spans.items():
            family = self.all[number]
            self.all[number] = Family(family.orbit, low, high)
            for place in (*range(family.low, low), *range(high + 1, family.high + 1)):
                waiting |= self._release(family.orbit[place])
        self._settle(waiting)

    def list_lost(self, number: int, taken: set[int]) -> set[int]:
        """All positions that a family loses when some are taken out of it: the longest stretch is left."""
        family = self.all[number]
        ends = [family.low - 1, *sorted(taken), family.high + 1]
        size, low = max((b - a - 1, a + 1) for a, b in itertools.pairwise(ends))
        left = range(low, low + size) if size >= LEAST else range(0)
        return {place for place in range(family.low, family.high + 1) if place not in left}

    def cut(self, lost: Mapping[int, set[int]]) -> None:
        """Take members out of families, from their ends."""
        waiting = set[int]()
        for number in lost.keys() & self.all.keys():
            family = self.all[number]
            places = self.list_lost(number, {k for k in lost[number] if family.low <= k <= family.high})
            left = [place for place in range(family.low, family.high + 1) if place not in places]
            if left:
                self.all[number] = Family(family.orbit, left[0], left[-1])
            else:
                del self.all[number]
            for place in places:
                waiting |= self._release(family.orbit[place])
        self._settle(waiting | lost.keys())

    def drop(self, number: int) -> None:
        """Give a family up; others that count on it are shortened."""
        waiting = set[int]()
        for key in self.all.pop(number).members:
            waiting |= self._release(key)
        self._settle(waiting)

    def list_slots(self, number: int) -> list[tuple[str, ...]]:
        """The operands of the members, slot by slot."""
        family = self.all[number]
        key = number, family.low, family.high
        if key not in self._slots:
            self._slots[key] = list(zip(*(self.pieces[key].operands for key in family.members), strict=True))
        return self._slots[key]

    def list_names(self, number: int) -> tuple[frozenset[str], frozenset[str]]:
        """The names that all members use alike, and the others."""
        family = self.all[number]
        key = number, family.low, family.high
        if key not in self._names:
            fixed, moving = set[str](), set[str]()
            for slot in self.list_slots(number):
                (fixed if is_constant(slot) else moving).update(slot)
            self._names[key] = frozenset(fixed), frozenset(moving)
        return self._names[key]

    def list_edges(self, number: int) -> list[Edge]:
        """What other families a family uses."""
        if number not in self._edges:
            found: dict[Edge, None] = {}
            for slot in self.list_slots(number):
                for place, name in enumerate(slot, self.all[number].low):
                    if name in self.home and not is_constant(slot):
                        used, position = self.home[name]
                        found[Edge(number, used, position - place)] = None
                        break
            self._edges[number] = list(found)
        return self._edges[number]

    def _release(self, key: str) -> set[int]:
        """A member becomes a statement of its own; the families that use it."""
        self._edges.pop(self.home.pop(key)[0], None)
        users = self._users.get(key, set())
        for number in users:
            self._edges.pop(number, None)
        return users

    def _settle(self, waiting: set[int]) -> None:
        while waiting:
            number = waiting.pop()
            if number not in self.all or number in self.frozen:
                continue
            family = self.all[number]
            low, high = self._find_longest(number)
            if (low, high) == (family.low, family.high):
                continue
            if high - low + 1 < LEAST:
                low, high = family.high + 1, family.high
                del self.all[number]
            else:
                self.all[number] = Family(family.orbit, low, high)
                waiting.add(number)
            for place in (*range(family.low, low), *range(high + 1, family.high + 1)):
                waiting |= self._release(family.orbit[place])

    def _find_longest(self, number: int) -> tuple[int, int]:
        """The positions at which every slot is of a kind that a loop can have."""
        family = self.all[number]
        low, high = 0, len(family.members) - 1
        for slot in self.list_slots(number):
            first, last = self._measure(slot)
            low, high = max(low, first), min(high, last)
        return family.low + low, family.low + high

    def _measure(self, slot: tuple[str, ...]) -> tuple[int, int]:
        """The longest stretch of a slot that one operand of a line can stand for."""
        whole = 0, len(slot) - 1
        if is_constant(slot) or self.find_stride(slot) is not None:
            return whole
        blocks = self._list_blocks(slot)
        if not blocks:
            return whole
        best = max(range(len(blocks)), key=lambda k: blocks[k][1] - blocks[k][0])
        first = blocks[best - 1][1] + 1 if best else 0
        last = blocks[best + 1][0] - 1 if best + 1 < len(blocks) else whole[1]
        return first, last

    def _list_blocks(self, slot: tuple[str, ...]) -> list[tuple[int, int]]:
        """Where members of one family follow each other."""
        blocks: list[tuple[int, int]] = []
        before: tuple[int, int] | None = None
        for place, name in enumerate(slot):
            now = self.home.get(name)
            if now is None:
                before = None
                continue
            if before is not None and now == (before[0], before[1] + 1):
                blocks[-1] = blocks[-1][0], place
            else:
                blocks.append((place, place))
            before = now
        return blocks

    def find_stride(self, slot: tuple[str, ...]) -> int | None:
        """The distance of the entries where a slot reads an input."""
        read = [self.loads[name] for name in slot if name in self.loads]
        if len(read) < len(slot) or any(load.array != read[0].array or load.index < 0 for load in read):
            return None
        steps = {b.index - a.index for a, b in itertools.pairwise(read)}
        return steps.pop() if len(steps) == 1 else None


def is_constant(slot: tuple[str, ...]) -> bool:
    """Whether all members use the same name."""
    return len(set(slot)) == 1
