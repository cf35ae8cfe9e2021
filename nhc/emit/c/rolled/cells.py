"""Places for values that pass from one statement to another through an array, so that loops find them at equal distances."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from nhc.records import record, structure

FEW = 4
"""What loops compute, of a sequence that has no place in their own rooms, and is copied."""


class UnfitError(Exception):
    """A sequence that no array can hold, as a family's members stand in its way; ``names``: the sequence."""

    def __init__(self, names: Sequence[str]) -> None:
        super().__init__()
        self.names = tuple(names)


@structure
class Room:
    """An array in the making: names at positions of its own, and the families whose runs it holds."""

    cells: dict[int, str]

    def take(self, cells: Mapping[int, str]) -> bool:
        """Enter the names if no other one has their positions."""
        if any(self.cells.get(place, name) != name for place, name in cells.items()):
            return False
        self.cells.update(cells)
        return True


@record
class Spot:
    """Entry k of a sequence stands ``first + step * k`` in the room's own positions."""

    room: Room
    first: int
    step: int


class Cells:
    """All rooms of one function.  ``runs``: the members of each family that loops compute, in order."""

    def __init__(self, runs: Iterable[Sequence[str]] = ()) -> None:
        self.rooms: list[Room] = []
        self._runs = [tuple(run) for run in runs]
        self._home = {name: (k, place) for k, run in enumerate(self._runs) for place, name in enumerate(run)}
        self._by_run: dict[int, list[Room]] = {}
        self._others: dict[tuple[str, ...], Spot] = {}

    def ask(self, names: Sequence[str]) -> Spot:
        """A spot where the names stand in their order.  Raises UnfitError."""
        homes = [(place, self._home[name]) for place, name in enumerate(names) if name in self._home]
        if not homes:
            return self._gather(tuple(names))
        place, (run, position) = homes[len(homes) // 2]
        step = 1
        if len(homes) > 1:
            other, (_, further) = homes[len(homes) // 2 - 1]
            step = 1 if (further < position) == (other < place) else -1
        first = position - step * place
        cells = {first + step * k: name for k, name in enumerate(names)}
        whole = dict(enumerate(self._runs[run]))
        blocked = any(whole.get(k, name) != name for k, name in cells.items())
        strange = [home for home in homes if blocked or home[1] != (run, first + step * home[0])]
        if len(strange) > FEW:
            raise UnfitError(names)
        for _, (other, _) in strange:
            self.ask_one(self._runs[other][0])
        if blocked:
            return self._gather(tuple(names))
        rooms = self._by_run.setdefault(run, [])
        for room in rooms:
            if room.take(cells):
                return Spot(room, first, step)
        room = Room(whole | cells)
        rooms.append(room)
        self.rooms.append(room)
        return Spot(room, first, step)

    def ask_one(self, name: str) -> None:
        """Some place for a single name."""
        if name in self._home:
            run, _ = self._home[name]
            if run not in self._by_run:
                self.ask(self._runs[run])
        else:
            self.ask((name,))

    def copied_of(self, spot: Spot, names: Sequence[str]) -> list[str]:
        """Those of a sequence at a spot that single statements must put there."""
        owner = next((run for run, rooms in self._by_run.items() if any(room is spot.room for room in rooms)), -1)
        return [
            name
            for k, name in enumerate(names)
            if name in self._home and self._home[name] != (owner, spot.first + spot.step * k)
        ]

    def list_copied(self) -> list[tuple[str, Room, int]]:
        """What loops compute and single statements must put into rooms of others, with its position there."""
        owners = {id(room): run for run, rooms in self._by_run.items() for room in rooms}
        return [
            (name, room, k)
            for room in self.rooms
            for k, name in room.cells.items()
            if name in self._home and self._home[name] != (owners.get(id(room)), k)
        ]

    def list_rooms(self, run: Sequence[str]) -> list[Room]:
        """The rooms that hold a family's members; the first of these is at position 0."""
        return self._by_run.get(self._home[run[0]][0], [])

    def _gather(self, names: tuple[str, ...]) -> Spot:
        found = self._others.get(names)
        if found is None:
            room = Room(dict(enumerate(names)))
            self.rooms.append(room)
            found = self._others[names] = Spot(room, 0, 1)
            self._others.setdefault(names[::-1], Spot(room, len(names) - 1, -1))
        return found


@structure
class Layout:
    """Where the rooms stand in one array of ``size``; each name's places in it."""

    size: int
    bases: dict[int, int]
    places: dict[str, tuple[int, ...]]

    def locate(self, spot: Spot) -> tuple[int, int]:
        """Where a sequence begins, and the distance of its entries."""
        return self.bases[id(spot.room)] + spot.first, spot.step


def furnish(cells: Cells) -> Layout:
    """The rooms one behind the other.  A name's places to which it is copied come last."""
    layout = Layout(0, {}, {})
    copied = cells.list_copied()
    late = {(id(room), place) for _, room, place in copied}
    for room in cells.rooms:
        low, high = min(room.cells), max(room.cells)
        base = layout.bases[id(room)] = layout.size - low
        layout.size = base + high + 1
        for place, name in room.cells.items():
            if (id(room), place) not in late:
                layout.places[name] = *layout.places.get(name, ()), base + place
    for name, room, place in copied:
        layout.places[name] = *layout.places[name], layout.bases[id(room)] + place
    return layout
