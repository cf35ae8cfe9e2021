"""Straight code with loops in place of what repeats along a chain."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from nhc.emit.c.rolled.cells import Cells, Spot, UnfitError
from nhc.emit.c.rolled.families import Families, is_constant
from nhc.emit.c.rolled.schedule import Plan, Scheduler
from nhc.emit.c.rolled.shift import Outline, Piece, find_orbits, list_pieces
from nhc.emit.statements import collect_refs
from nhc.program.ir import Binary, Call, Expr, Let, Load, Negate, Number, Pi, Power, Ref, Section, Statement, Store
from nhc.records import record, structure

WORTH = 0.8
"""Of its statements that code may have when it is rolled; else it stays as it is."""
SEED = "seed"
"""The array of a sweep's directions."""


@record
class Slot:
    """What an operand of a line is in each pass: ``kind`` is name (one for all), line (of the same pass), input, array, or number.

    A number is one that another body has computed.
    """

    kind: str
    names: tuple[str, ...]


Key = tuple[int, int, int]
"""A plan by its identity, a family, an operand."""


@structure
class Rolled:
    """The order of a body: statements and plans of loops; what operands are, and where those in arrays stand."""

    order: list[Statement | Plan]
    families: Families
    pieces: dict[str, Piece]
    loads: Mapping[str, Load]
    slots: dict[Key, Slot]
    cells: Cells
    spots: dict[Key, Spot]

    @property
    def length(self) -> int:
        """Statements, those of loops once."""
        return sum(len(item.delays) if isinstance(item, Plan) else 1 for item in self.order)

    def ask_singles(self, wanted: Collection[str] = ()) -> None:
        """Places for what others need of loops: single statements, loops of one member for all passes, and who else wants it."""
        needed = set(wanted)
        for item in self.order:
            if not isinstance(item, Plan):
                needed |= collect_refs(item)
        needed |= {slot.names[0] for slot in self.slots.values() if slot.kind == "name"}
        for name in sorted(needed & self.families.home.keys()):
            self.cells.ask_one(name)

    def list_lines(self, plan: Plan) -> dict[int, str]:
        """The families of a loop in the order of their lines, with the first pass's members."""
        first = {number: self.families.all[number].orbit[plan.place(number, plan.first)] for number in plan.delays}
        return dict(sorted(first.items(), key=lambda item: self.pieces[item[1]].place))

    def is_in_order(self, known: Collection[str]) -> bool:
        """Whether everything is there when it is needed, pass by pass, and is done once."""
        done = {*known, *self.loads}
        for item in self.order:
            if isinstance(item, Plan):
                lines = [self.families.all[number].orbit for number in self.list_lines(item)]
                keys = [
                    orbit[item.place(number, turn)]
                    for turn in range(item.first, item.last + 1)
                    for number, orbit in zip(self.list_lines(item), lines, strict=True)
                ]
            elif isinstance(item, Let | Store):
                keys = [item.name if isinstance(item, Let) else f"{item.array}[{item.index}]"]
            else:
                keys = []
            for key in keys:
                if key in done or not done.issuperset(self.pieces[key].operands):
                    return False
                done.add(key)
        return done.issuperset(self.pieces)

    def list_hints(self) -> list[tuple[str, ...]]:
        """The sequences of another body's names that are needed, in the order of the shift."""
        signs = {id(item): item.sign for item in self.order if isinstance(item, Plan)}
        return [slot.names[:: signs[key[0]]] for key, slot in self.slots.items() if slot.kind == "number"]

    def ask_numbers(self, foreign: Cells) -> None:
        """Ask another body's cells for these sequences.  Raises UnfitError."""
        for key, slot in self.slots.items():
            if slot.kind == "number":
                self.spots[key] = foreign.ask(slot.names)


def roll(
    body: Sequence[Statement],
    loads: Mapping[str, Load],
    given: Collection[str] = (),
    hints: Sequence[Sequence[str]] = (),
) -> Rolled | None:
    """The body with loops, or None where there are none that are worth it.

    ``given`` are names that another body has computed; ``hints``: sequences of names that another body needs in their order.
    """
    pieces = list_pieces(body)
    orbits = find_orbits(pieces, loads, hints)
    while orbits:
        families = Families(pieces, loads, orbits)
        if sum(len(f.members) - 1 for f in families.all.values()) < (1 - WORTH) * len(pieces):
            return None
        order = Scheduler(pieces, families, {*loads, *given}).run()
        plans = [item for item in order if isinstance(item, Plan)]
        runs = [families.all[number].members for plan in plans for number in plan.delays]
        rest = [s for s in body if not isinstance(s, Let | Store | Section)]
        made = Rolled(
            [
                *(item if isinstance(item, Plan) else pieces[item].statement for item in order),
                *(s for s in rest if not isinstance(s, Load)),
            ],
            families,
            pieces,
            loads,
            {},
            Cells(runs),
            {},
        )
        if made.length > WORTH * len(pieces) or not made.is_in_order(given):
            return None
        unfit = {families.all[number].orbit for number in _find_slots(made, plans, frozenset(given))}
        if not unfit:
            made.ask_singles()
            return made
        orbits = [orbit for orbit in orbits if tuple(orbit) not in unfit]
    return None


def _find_slots(made: Rolled, plans: Sequence[Plan], given: frozenset[str]) -> set[int]:
    """What each operand of each line is; the numbers of families with one that no array can hold."""
    unfit = set[int]()
    for plan in plans:
        for number in plan.delays:
            for j, names in enumerate(list_turns(made, plan, number)):
                key = id(plan), number, j
                made.slots[key] = slot = _classify(made, plan, names, given)
                if slot.kind != "array":
                    continue
                try:
                    made.spots[key] = spot = made.cells.ask(names)
                except UnfitError:
                    unfit.add(number)
                    continue
                home = made.families.home
                if any(home[name][0] in plan.delays for name in made.cells.copied_of(spot, names)):
                    unfit.add(number)  # copies are made behind the loop
    return unfit


def list_turns(made: Rolled, plan: Plan, number: int) -> list[tuple[str, ...]]:
    """The operands of a family's line, slot by slot, in the order of the passes."""
    slots = made.families.list_slots(number)
    return slots if plan.sign > 0 else [slot[::-1] for slot in slots]


def _classify(made: Rolled, plan: Plan, names: tuple[str, ...], given: frozenset[str]) -> Slot:
    if is_constant(names):
        return Slot("name", names)
    if made.families.find_stride(names) is not None:
        return Slot("input", names)
    home = made.families.home
    places = [home.get(name) for name in names]
    if places[0] is not None and places[0][0] in plan.delays:
        used = places[0][0]
        if all(
            place is not None and place == (used, plan.place(used, turn))
            for turn, place in enumerate(places, plan.first)
        ):
            return Slot("line", names)
    if given:
        numbers = [name in given or (name in made.loads and made.loads[name].array != SEED) for name in names]
        if all(numbers):
            return Slot("number", names)
        assert not any(numbers), "what is linear in the directions is no number"
    return Slot("array", names)


def build(outline: Outline, names: Sequence[str]) -> Expr:
    """The expression of an outline with these names in its blanks."""
    stack: list[Expr] = []
    left = list(names)
    for token in reversed(outline):
        if token == "":
            stack.append(Ref(left.pop()))
        elif isinstance(token, tuple) and token[0] == "power":
            stack.append(Power(stack.pop(), token[1]))
        elif isinstance(token, tuple):
            stack.append(Call(token[0], tuple(stack.pop() for _ in range(token[1]))))
        elif token == "negate":
            stack.append(Negate(stack.pop()))
        elif token == "pi":
            stack.append(Pi())
        elif isinstance(token, str):
            first = stack.pop()
            stack.append(Binary(token, first, stack.pop()))
        else:
            stack.append(Number(token))  # type: ignore[arg-type]
    (value,) = stack
    return value
