"""The order in which families are passed through in loops, and the statements between the loops.

Families that need each other in a circle, a recursion along the chain, share a loop and settle its direction; others join a loop
where all that they need is there.  In a loop each family has a delay, by which its members come later, so that what a pass uses is
computed before (the least solution of difference constraints, as in software pipelining).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from nhc.emit.c.rolled.families import Edge, Families, is_constant
from nhc.emit.c.rolled.shift import LEAST, Piece
from nhc.records import record, structure

_FEW = 0.3
"""Of its members that a family may lose to what a single statement needs."""
_KEPT = 0.7
"""Of its passes that a loop must keep when another family joins."""


@record
class Plan:
    """A loop: passes ``first`` to ``last``; in pass k a family's member stands at ``sign * (k - delay)`` of its orbit."""

    sign: int
    first: int
    last: int
    delays: dict[int, int]

    def place(self, number: int, turn: int) -> int:
        """The position in its orbit of the family's member in a pass."""
        return self.sign * (turn - self.delays[number])


@structure
class _Draft:
    sign: int
    delays: dict[int, int]
    first: int
    last: int
    most: int


class Scheduler:
    """Orders the pieces of a body: keys of single statements, and plans of loops."""

    def __init__(self, pieces: Mapping[str, Piece], families: Families, known: set[str]) -> None:
        self.pieces, self.families = pieces, families
        self.done = set(known)
        self.order: list[str | Plan] = []

    def run(self) -> list[str | Plan]:
        """Everything, in order.  A family that waits for what waits for it is taken apart."""
        self._emit_ready()
        while self._list_open():
            open_ = set(self._list_open())
            edges = {n: [edge for edge in self.families.list_edges(n) if edge.used in open_] for n in sorted(open_)}
            circles = _list_circles(self._list_free(edges))
            drafts = [self._draft(sign, circles, edges) for sign in (1, -1)]
            best = max(drafts, key=lambda draft: len(draft.delays))
            if best.delays:
                self._close(best)
            else:
                self._yield(edges)
            self._emit_ready()
        assert len(self.done) >= len(self.pieces)
        return self.order

    def _list_open(self) -> list[int]:
        """The families that have no loop yet."""
        return [number for number in self.families.all if number not in self.families.frozen]

    def _list_free(self, edges: Mapping[int, Sequence[Edge]]) -> dict[int, int]:
        """What the families need, as bits, that wait for no single statement, nor for families that do."""
        needs = {n: _gather(edge.used for edge in made) for n, made in edges.items() if self._is_free(n)}
        while True:
            free = _gather(needs)
            late = [number for number, mask in needs.items() if mask & ~free]
            if not late:
                return needs
            for number in late:
                del needs[number]

    def _is_free(self, number: int) -> bool:
        """Whether all that a family takes from elsewhere than families is done."""
        fixed, moving = self.families.list_names(number)
        home = self.families.home
        return self.done >= fixed and all(name in home for name in moving - self.done)

    def _yield(self, edges: Mapping[int, Sequence[Edge]]) -> None:
        """Where nothing can go on: members that single statements wait for become single, as few as may be.

        This happens where it all begins, in the families that wait for none but each other.
        """
        wanted = {number: self._list_wanted(number) for number in edges}
        masks = self._mask_needs()
        waits: dict[int, int] = {}
        for number, names in wanted.items():
            waits[number] = _gather(edge.used for edge in edges[number])
            for name in names:
                waits[number] |= masks[name]
        first = _list_circles(waits)[0]
        users: dict[str, dict[int, set[int]]] = {}
        for number in first:
            for name, places in wanted[number].items():
                users.setdefault(name, {})[number] = places
        losses = [self._choose_loss(name, places) for name, places in users.items()]
        if losses:
            least = min(map(_count_lost, losses))
            for loss in losses:
                if _count_lost(loss) == least:
                    self.families.cut(loss)
        else:
            self.families.drop(min(first, key=lambda number: len(self.families.all[number].members)))

    def _mask_needs(self) -> dict[str, int]:
        """By name: the families that a statement waits for, directly or by way of single statements, as bits."""
        home = self.families.home
        masks: dict[str, int] = {}
        for key, piece in self.pieces.items():  # operands come before
            if key in self.done:
                continue
            if key in home:
                masks[key] = 1 << home[key][0]
            else:
                mask = 0
                for name in piece.operands:
                    mask |= masks.get(name, 0)
                masks[key] = mask
        return masks

    def _choose_loss(self, name: str, users: Mapping[int, set[int]]) -> dict[int, set[int]]:
        """What families lose so that a name is no obstacle any more.

        Where a recursion begins, what the name needs is soon done one by one; where it ends, that would be all of it, and those who
        use the name are done one by one.
        """
        loss = self._weigh(name)
        if loss is not None:
            return loss
        return {number: self.families.list_lost(number, places) for number, places in users.items()}

    def _list_wanted(self, number: int) -> dict[str, set[int]]:
        """What is not done and a whole loop would wait for, with the positions that need it.

        Single statements, or one member of a family for all passes.
        """
        home, low = self.families.home, self.families.all[number].low
        found: dict[str, set[int]] = {}
        for slot in self.families.list_slots(number):
            constant = is_constant(slot)
            for place, name in enumerate(slot, low):
                if name not in self.done and (constant or name not in home):
                    found.setdefault(name, set()).add(place)
        return found

    def _weigh(self, name: str) -> dict[int, set[int]] | None:
        """What families lose when all that a statement needs is done one by one; None where one loses much."""
        home, all_ = self.families.home, self.families.all
        places: dict[int, set[int]] = {}
        stack, seen = [name], {name}
        while stack:
            key = stack.pop()
            if key in home:
                number, place = home[key]
                taken = places.setdefault(number, set())
                taken.add(place)
                if len(taken) > _FEW * len(all_[number].members):
                    return None
            for operand in self.pieces[key].operands:
                if operand not in self.done and operand not in seen:
                    seen.add(operand)
                    stack.append(operand)
        loss = {number: self.families.list_lost(number, taken) for number, taken in places.items()}
        much = any(len(lost) > _FEW * len(all_[number].members) for number, lost in loss.items())
        return None if much or not loss else loss

    def _emit_ready(self) -> None:
        """Single statements whose operands are known, again and again."""
        waiting = [key for key in self.pieces if key not in self.done and key not in self.families.home]
        while waiting:
            left = []
            for key in waiting:
                if self.done.issuperset(self.pieces[key].operands):
                    self.done.add(key)
                    self.order.append(key)
                else:
                    left.append(key)
            if len(left) == len(waiting):
                return
            waiting = left

    def _draft(self, sign: int, circles: Sequence[Sequence[int]], edges: Mapping[int, Sequence[Edge]]) -> _Draft:
        """As many families as one loop of this direction can have."""
        draft = _Draft(sign, {}, 0, 0, 0)
        waiting = list(circles)
        grown = True
        while grown:
            grown = False
            for circle in list(waiting):
                inside = draft.delays.keys() | set(circle)
                if all(edge.used in inside for number in circle for edge in edges[number]) and self._join(
                    draft, circle, edges
                ):
                    waiting.remove(circle)
                    grown = True
        return draft

    def _join(self, draft: _Draft, circle: Sequence[int], edges: Mapping[int, Sequence[Edge]]) -> bool:
        """Take the families of a circle into a draft, unless it would become too short or go both ways."""
        delays: dict[int, int] = {}
        sign, known = draft.sign, draft.delays
        for _ in range(len(circle) + 1):
            moved = False
            for number in circle:
                for edge in edges[number]:
                    base = known.get(edge.used, delays.get(edge.used))
                    least = None if base is None else base + sign * edge.ahead
                    if least is not None and delays.get(number, least - 1) < least:
                        delays[number] = least
                        moved = True
            if not delays:
                delays[circle[0]] = draft.first - self._span(sign, circle[0])[0]
                moved = True
            if not moved:
                break
        else:
            return False
        return self._accept(draft, delays) if len(delays) == len(circle) else False

    def _accept(self, draft: _Draft, delays: Mapping[int, int]) -> bool:
        spans = [
            (low + delays[number], high + delays[number])
            for number in delays
            for low, high in (self._span(draft.sign, number),)
        ]
        first, last = max(low for low, _ in spans), min(high for _, high in spans)
        most = max(draft.most, last - first + 1)
        if draft.delays:
            first, last = max(first, draft.first), min(last, draft.last)
        if last - first + 1 < max(LEAST, _KEPT * most):
            return False
        draft.first, draft.last, draft.most = first, last, most
        draft.delays.update(delays)
        return True

    def _span(self, sign: int, number: int) -> tuple[int, int]:
        """First and last position, where positions count down if the loop does."""
        family = self.families.all[number]
        return (family.low, family.high) if sign > 0 else (-family.high, -family.low)

    def _close(self, draft: _Draft) -> None:
        """What comes too early or too late for the passes becomes single; then the loop stands."""
        plan = Plan(draft.sign, draft.first, draft.last, dict(draft.delays))
        spans: dict[int, tuple[int, int]] = {}
        for number in plan.delays:
            low, high = sorted((plan.place(number, plan.first), plan.place(number, plan.last)))
            spans[number] = low, high
        self.families.freeze(spans)
        self._emit_ready()
        for number in plan.delays:
            self.done.update(self.families.all[number].members)
        self.order.append(plan)


def _gather(numbers: Iterable[int]) -> int:
    mask = 0
    for number in numbers:
        mask |= 1 << number
    return mask


def _count_lost(loss: Mapping[int, set[int]]) -> int:
    return sum(map(len, loss.values()))


def _list_circles(needs: Mapping[int, int]) -> list[list[int]]:
    """The families in sets that need each other (strongly connected), each set after those that it needs.

    ``needs``: by number, the numbers that it needs as bits.
    """
    reach = {number: mask | 1 << number for number, mask in needs.items()}
    for middle in reach:  # Warshall's closure
        through = reach[middle]
        for number, mask in reach.items():
            if mask >> middle & 1:
                reach[number] = mask | through
    circles: dict[int, list[int]] = {}  # those that need each other reach the same
    for number, mask in reach.items():
        circles.setdefault(mask, []).append(number)
    return [circles[mask] for mask in sorted(circles, key=int.bit_count)]
