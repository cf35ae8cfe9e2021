"""The order in which definitions need one another."""

from __future__ import annotations

from collections.abc import Mapping

from nhc.diagnostics import Bag, Label, Span
from nhc.language.expressions.syntax import Syntax
from nhc.language.scope import names_in


def order_definitions(named: Mapping[str, Syntax], spans: Mapping[str, Span], bag: Bag) -> tuple[str, ...]:
    """Return the names so that each comes after those that its expression needs; cycles are reported (E0308)."""
    needs = {name: [other for other in names_in(tree) if other in named] for name, tree in named.items()}
    state: dict[str, int] = {}  # 1: being visited, 2: done
    order: list[str] = []
    for root in named:
        if root in state:
            continue
        path, pending = [root], [iter(needs[root])]
        state[root] = 1
        while path:
            other = next(pending[-1], None)
            if other is None:
                pending.pop()
                name = path.pop()
                state[name] = 2
                order.append(name)
            elif other not in state:
                state[other] = 1
                path.append(other)
                pending.append(iter(needs[other]))
            elif state[other] == 1:
                _report_cycle(path[path.index(other) :], spans, bag)
    return tuple(order)


def _report_cycle(cycle: list[str], spans: Mapping[str, Span], bag: Bag) -> None:
    shown = [*cycle, cycle[0]]
    if len(shown) > 8:
        shown = [*shown[:4], "...", *shown[-3:]]
    labels = tuple(Label(spans[name], "in the cycle") for name in cycle[1:8])
    message = "definitions form a cycle: " + " -> ".join(shown)
    bag.error("E0308", message, spans[cycle[0]], labels=labels, help=("write one of them without the others",))
