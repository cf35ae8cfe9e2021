"""The stages of an explicit method by fours, for the rates that wait until several are known (``layers.py``)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.records import record
from nhc.simulate.c.kernel import Kernel
from nhc.simulate.methods.tableau import Explicit, Row

FOUR = 4  # doubles of a pack


@record
class Combination:
    """``first`` times the entry's slope at the start of the step plus the sum over the slots of the others.

    ``lanes``: the whole of it for many starts at once, added up in the same order, so that a start has the same end either way.
    """

    entry: int
    first: str
    rest: str
    lanes: tuple[str, ...]


@record
class LayerRun:
    """A layer in one group: the states of the entries that it ``reads`` between the ends, and where its slopes go (entry, row)."""

    number: int
    reads: tuple[Combination, ...]
    slopes: tuple[tuple[int, int], ...]


@record
class Group:
    """Four stages, done as soon as the ``last`` is known; its slopes go to the slots from ``slot`` on.

    A group may begin before the first stage: then the last one is put in again, and its slopes in those slots have no weight.
    """

    last: int
    stages: tuple[int, ...]
    nodes: str
    slot: int
    layers: tuple[LayerRun, ...]


@record
class Waiting:
    """How a method brings the entries that wait to the end of a step; empty where none does.

    ``ends``: those whose state at the end is none of the layers' business;
    ``arrived``: (entry, row) and the slot of their last slopes; ``errors``: for each estimate what it is for each of them;
    ``depths[j]``: how many layers stage j needs; ``states[j]``: what they read there, or what there is at the end, for lanes.
    """

    groups: tuple[Group, ...] = ()
    ends: tuple[Combination, ...] = ()
    rows: tuple[tuple[int, int], ...] = ()
    slots: tuple[tuple[int, int], ...] = ()
    errors: tuple[tuple[Combination, ...], ...] = ()
    depths: tuple[int, ...] = ()
    states: tuple[tuple[tuple[int, str], ...], ...] = ()


def count_slots(method: Explicit) -> int:
    """Places for the slopes of the stages after the start, in whole groups."""
    return FOUR * -(-method.stages // FOUR)


def plan_waiting(method: Explicit, kernel: Kernel) -> Waiting:
    """The groups of a method for a kernel's layers."""
    if not kernel.layers:
        return Waiting()
    plan = _Plan(method, kernel)
    groups = tuple(plan.list_groups())
    last = {entry for layer in kernel.layers for entry in layer.reads}
    weights = method.rows[method.stages - 1]
    ends = tuple(plan.combine(entry, weights) for entry in kernel.waiting if entry not in last)
    states = plan.list_states(groups)
    states[-1] += [(sum.entry, sum.lanes[0]) for sum in ends]
    return Waiting(
        groups=groups,
        ends=ends,
        states=tuple(map(tuple, states)),
        rows=tuple((entry, row) for row, entry in enumerate(kernel.waiting)),
        slots=tuple((stage, plan.place(stage)) for stage in range(1, method.stages + 1)),
        errors=tuple(tuple(plan.combine(entry, row) for entry in kernel.waiting) for row in method.errors),
        depths=tuple(sum(stage in need for need in plan.needs) for stage in range(method.stages + 1)),
    )


class _Plan:
    def __init__(self, method: Explicit, kernel: Kernel) -> None:
        self.method, self.kernel = method, kernel
        self.rows = {entry: row for row, entry in enumerate(kernel.waiting)}
        self.needs = _find_needs(method, len(kernel.layers))

    def place(self, stage: int) -> int:
        """The slot of a stage's slopes; that of the end is the last one."""
        return stage + count_slots(self.method) - 1 - self.method.stages

    def combine(self, entry: int, weights: Row) -> Combination:
        """Weights times an entry's slopes, in packs."""
        slots = [0.0] * count_slots(self.method)
        for stage, weight in enumerate(weights[1 : self.method.stages + 1], 1):
            slots[self.place(stage)] = weight
        packs = [
            f"(pack){{{_join(slots[k : k + FOUR])}}} * *(const pack *)(s->late[{self.rows[entry]}] + {k})"
            for k in range(0, len(slots), FOUR)
            if any(slots[k : k + FOUR])
        ]
        parts = [
            " + ".join(
                [
                    f"{slots[k]!r} * k[{self.stage(k)}][{entry}]"
                    for k in range(place, len(slots), FOUR)
                    if any(slots[k - place : k - place + FOUR])
                ]
                + ["0.0"] * (len(packs) == 1)  # the product is rounded before it is added
            )
            for place in range(FOUR)
        ]
        total = f"(({parts[0]}) + ({parts[1]})) + (({parts[2]}) + ({parts[3]}))" if packs else "0.0"
        first = repr(weights[0])
        return Combination(
            entry,
            first,
            " + ".join(packs) or "(pack){0}",
            (f"{first} * g->slope[{entry}] + ({total})",),
        )

    def stage(self, slot: int) -> int:
        """The stage whose slopes are in a slot; before the first one it is the last of the group."""
        stage = slot + self.method.stages + 1 - count_slots(self.method)
        return stage if stage > 0 else self.stage(slot - slot % FOUR + FOUR - 1)

    def list_states(self, groups: Iterable[Group]) -> list[list[tuple[int, str]]]:
        """For each stage the entries that the layers read there, and their states in lanes."""
        found: list[list[tuple[int, str]]] = [[] for _ in range(self.method.stages + 1)]
        for group in groups:
            for place in range(FOUR):
                stage = group.slot + place + self.method.stages + 1 - count_slots(self.method)
                for run in group.layers:
                    if stage in self.needs[run.number]:
                        found[stage] += [(sum.entry, sum.lanes[place]) for sum in run.reads]
        return [sorted(dict(states).items()) for states in found]

    def list_groups(self) -> Iterable[Group]:
        for slot in range(0, count_slots(self.method), FOUR):
            stages = [self.stage(k) for k in range(slot, slot + FOUR)]
            runs = [
                LayerRun(
                    number, self._read(number, stages), tuple((entry, self.rows[entry]) for entry in layer.entries)
                )
                for number, layer in enumerate(self.kernel.layers)
                if self.needs[number].intersection(stages)
            ]
            if runs:
                nodes = _join(self.method.nodes[stage] for stage in stages)
                yield Group(stages[-1], tuple(stages), nodes, slot, tuple(runs))

    def _read(self, number: int, stages: Sequence[int]) -> tuple[Combination, ...]:
        """The states that a layer reads at these stages; one that needs none stays where the step began."""
        rows = [self.method.rows[stage - 1] if stage in self.needs[number] else () for stage in stages]
        columns = [[row[k] if k < len(row) else 0.0 for row in rows] for k in range(stages[-1])]
        first, *others = columns
        used = [(stage, column) for stage, column in enumerate(others, 1) if any(column)]
        return tuple(
            Combination(
                entry,
                f"(pack){{{_join(first)}}}",
                " + ".join(
                    f"(pack){{{_join(column)}}} * s->late[{self.rows[entry]}][{self.place(stage)}]"
                    for stage, column in used
                ),
                tuple(
                    " + ".join(
                        [f"{first[place]!r} * g->slope[{entry}]"]
                        + [f"{column[place]!r} * k[{stage}][{entry}]" for stage, column in used]
                    )
                    for place in range(FOUR)
                ),
            )
            for entry in self.kernel.layers[number].reads
        )


def _find_needs(method: Explicit, count: int) -> list[set[int]]:
    """For each layer the stages after the start whose slopes have a weight anywhere, or where a later layer needs states."""
    end = method.stages
    used = {end} | {k for row in (*method.rows[end - 1 :], *method.errors, *method.dense) for k in _list_used(row, end)}
    found: list[set[int]] = []
    for _ in range(count):
        found.insert(0, set(used))
        used |= {k for stage in used for k in _list_used(method.rows[stage - 1], end)}
    return found


def _list_used(row: Row, end: int) -> list[int]:
    return [k for k, weight in enumerate(row) if weight and 0 < k <= end]


def _join(numbers: Iterable[float]) -> str:
    return ", ".join(map(repr, numbers))
