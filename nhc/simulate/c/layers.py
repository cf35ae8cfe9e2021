"""Which rates of a right-hand side can wait until the stages of a step are known: those of entries that no stage asks for.

An entry of the state that no rate reads, as a position on the plane often is, needs no value between the ends of a step, and its
rates can be computed for several stages at once when the rest is known.  Without it other entries may be read by no rate any
more (a heading that only the position asks for), and so on.
"""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.statements import collect_refs
from nhc.program.ir import Guard, Let, Load, Statement, Store
from nhc.records import record

_EARLY = 0


@record
class Layer:
    """Entries whose rates are computed together; ``reads`` are the waiting entries that they read, of earlier layers all."""

    entries: tuple[int, ...]
    body: tuple[Statement, ...]
    reads: tuple[int, ...]


@record
class Split:
    """A body in parts: ``early`` at each stage, then the layers one after the other.

    ``kept`` are the names that a part uses though an earlier one binds them, first those that ``early`` binds.  Guards are asked
    at each stage.
    """

    early: tuple[Statement, ...]
    layers: tuple[Layer, ...]
    kept: tuple[str, ...]

    @property
    def waiting(self) -> tuple[int, ...]:
        """The entries that wait, in order."""
        return tuple(sorted(entry for layer in self.layers for entry in layer.entries))


def split_layers(body: tuple[Statement, ...]) -> Split:
    """The parts of a body of loads, lets, guards and one store for each entry of the state ``y``."""
    sources = _find_sources(body)
    stores = {s.index: _gather(sources, collect_refs(s)) for s in body if isinstance(s, Store)}
    asked = frozenset().union(*(_gather(sources, collect_refs(s)) for s in body if isinstance(s, Guard)))
    peeled = _peel(stores, asked)
    places = {entry: place for place, entries in enumerate(peeled, _EARLY + 1) for entry in entries}
    used = _place_names(body, places)
    parts: list[list[Statement]] = [[] for _ in range(len(peeled) + 1)]
    kept: dict[str, None] = {}
    for statement in body:
        for place in _list_places(statement, places, used):
            parts[place].append(statement)
        if isinstance(statement, Let | Load) and not _is_loaded_again(statement, places):
            places_used = used.get(statement.name, set())
            if len(places_used) > 1:
                kept[statement.name] = None
    layers = tuple(
        Layer(entries, tuple(part), _list_reads(part, places)) for entries, part in zip(peeled, parts[1:], strict=True)
    )
    early = {statement.name for statement in parts[_EARLY] if isinstance(statement, Let | Load)}
    return Split(tuple(parts[_EARLY]), layers, tuple(sorted(kept, key=lambda name: name not in early)))


def _find_sources(body: Iterable[Statement]) -> dict[str, frozenset[int]]:
    """Name -> the entries of the state that it depends on."""
    found: dict[str, frozenset[int]] = {}
    for statement in body:
        if isinstance(statement, Load):
            found[statement.name] = frozenset((statement.index,) if statement.array == "y" else ())
        elif isinstance(statement, Let):
            found[statement.name] = _gather(found, collect_refs(statement))
    return found


def _gather(sources: dict[str, frozenset[int]], names: Iterable[str]) -> frozenset[int]:
    return frozenset().union(*(sources.get(name, frozenset()) for name in names))


def _peel(stores: dict[int, frozenset[int]], asked: frozenset[int]) -> list[tuple[int, ...]]:
    """The entries that wait, layer by layer: again and again those that nothing left reads."""
    left = dict(stores)
    found: list[tuple[int, ...]] = []
    while True:
        loose = set(left) - asked.union(*left.values())
        if not loose:
            return found
        found.insert(0, tuple(sorted(loose)))
        left = {entry: reads for entry, reads in left.items() if entry not in loose}


def _place_names(body: tuple[Statement, ...], places: dict[int, int]) -> dict[str, set[int]]:
    """Name -> the parts that use it; a let is bound in the first of them."""
    used: dict[str, set[int]] = {}
    for statement in reversed(body):
        for place in (
            _list_places(statement, places, used)[:1]
            if isinstance(statement, Let)
            else _list_places(statement, places, used)
        ):
            for name in collect_refs(statement):
                used.setdefault(name, set()).add(place)
    return used


def _list_places(statement: Statement, places: dict[int, int], used: dict[str, set[int]]) -> list[int]:
    """The parts that a statement stands in."""
    if isinstance(statement, Store):
        return [places.get(statement.index, _EARLY)]
    if isinstance(statement, Let | Load):
        found = sorted(used.get(statement.name, ()))
        return found if isinstance(statement, Load) and _is_loaded_again(statement, places) else found[:1]
    return [_EARLY]


def _is_loaded_again(load: Let | Load, places: dict[int, int]) -> bool:
    """Whether each part that uses it loads it for itself: a value that stands ready for the layers too."""
    return isinstance(load, Load) and (load.array != "y" or load.index in places)


def _list_reads(part: Iterable[Statement], places: dict[int, int]) -> tuple[int, ...]:
    return tuple(sorted({s.index for s in part if isinstance(s, Load) and s.array == "y" and s.index in places}))
