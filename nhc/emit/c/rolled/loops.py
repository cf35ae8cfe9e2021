"""Loops from plans, when it is known where all values stand."""

from __future__ import annotations

import re
from collections.abc import Sequence

from nhc.emit.c.rolled.cells import Layout
from nhc.emit.c.rolled.lines import Fetch, Leave, Line, Loop, Put
from nhc.emit.c.rolled.roll import Rolled, build, list_turns
from nhc.emit.c.rolled.schedule import Plan
from nhc.program.ir import Let, Store
from nhc.records import structure

_NUMBERS = re.compile(r"\d+")


@structure
class LoopWriter:
    """Writes the loops of a body.

    ``passed``, ``own``: the array that holds what the body's own statements hand on, and its layout; ``numbers``, ``foreign``: the
    same of the body before a sweep.  ``taken``: names that are bound already, those of loops are added.
    """

    rolled: Rolled
    passed: str
    own: Layout
    numbers: str
    foreign: Layout
    taken: set[str]

    def write(self) -> list[Line]:
        """The lines of the body."""
        lines: list[Line] = [
            Leave(name, place)
            for name in self.own.places
            if name in self.rolled.loads
            for place in self.own.places[name]
        ]
        home = self.rolled.families.home
        copied = [
            (home[name][0], Leave(name, self.own.bases[id(room)] + place))
            for name, room, place in self.rolled.cells.list_copied()
        ]
        for item in self.rolled.order:
            if isinstance(item, Plan):
                lines.append(self._write_loop(item))
                lines += [leave for number, leave in copied if number in item.delays]
            else:
                lines.append(item)
        return lines

    def _write_loop(self, plan: Plan) -> Loop:
        rolled = self.rolled
        families = rolled.families.all
        local: dict[int, str] = {}
        fetched: dict[tuple[str, ...], str] = {}
        outside: set[str] = set()
        body: list[Fetch | Let | Leave | Put] = []
        for number, first in rolled.list_lines(plan).items():
            piece, names = rolled.pieces[first], list[str]()
            for j, turns in enumerate(list_turns(rolled, plan, number)):
                slot = rolled.slots[id(plan), number, j]
                if slot.kind == "name":
                    outside.add(turns[0])
                    names.append(turns[0])
                elif slot.kind == "line":
                    names.append(local[rolled.families.home[turns[0]][0]])
                else:
                    if turns not in fetched:
                        fetched[turns] = self._name(turns)
                        body.append(self._fetch(fetched[turns], turns, (id(plan), number, j)))
                    names.append(fetched[turns])
            members = families[number].members
            if isinstance(piece.statement, Store):
                body.append(self._put(piece.statement, build(piece.outline[2:], names), members, plan.sign))
                continue
            local[number] = self._name(members)
            body.append(Let(local[number], build(piece.outline, names)))
            start = 0 if plan.sign > 0 else len(members) - 1
            for room in rolled.cells.list_rooms(members):
                body.append(Leave(local[number], self.own.bases[id(room)] + start, plan.sign))
        return Loop(plan.last - plan.first + 1, tuple(body), frozenset(outside))

    def _fetch(self, name: str, turns: Sequence[str], key: tuple[int, int, int]) -> Fetch:
        slot, loads = self.rolled.slots[key], self.rolled.loads
        if slot.kind == "input":
            first, second = loads[turns[0]], loads[turns[1]]
            return Fetch(name, first.array, first.index, second.index - first.index)
        if slot.kind == "number":
            return Fetch(name, self.numbers, *self.foreign.locate(self.rolled.spots[key]))
        return Fetch(name, self.passed, *self.own.locate(self.rolled.spots[key]))

    def _put(self, store: Store, value: object, members: Sequence[str], sign: int) -> Put:
        pair = [self.rolled.pieces[key].statement for key in members[::sign][:2]]
        assert isinstance(pair[0], Store)
        assert isinstance(pair[1], Store)
        return Put(Store(store.array, store.index, value, "", store.origin), pair[1].index - pair[0].index)  # type: ignore[arg-type]

    def _name(self, names: Sequence[str]) -> str:
        """A name for what is named so in each pass: what the names have in common, or the first with a number."""
        stems = {_NUMBERS.sub("", name, count=1) for name in names}
        stem = (stems.pop() if len(stems) == 1 else _NUMBERS.sub("", names[0])).strip("_") or "z"
        name, number = stem, 1
        while name in self.taken or not name.isidentifier():
            number += 1
            name = f"{stem}_{number}"
        self.taken.add(name)
        return name
