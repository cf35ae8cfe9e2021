"""Can several expressions vanish at once?  Interval bounds on smaller and smaller boxes.

A box is done with as soon as the bounds of one of the expressions leave zero out.  Coordinates that stand in sines and cosines
alone go once around; those of unknown range that stand elsewhere are never divided (R. E. Moore, Interval Analysis (1966), ch. 4).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from nhc.algebra.bounds.interval import EVERYTHING, Interval, excludes_zero, list_bounds
from nhc.algebra.calculus import tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable

_MOST_WORK = 400_000  # nodes that are bounded, over all boxes
_SMALLEST = 2.0**-12  # of a side of the first box
_LONGEST_PERIOD = 24  # turns

_Box = dict[Node, Interval]


def cannot_vanish_together(graph: Graph, roots: Sequence[Node], known: Mapping[Node, Interval]) -> bool:
    """Whether at every point of the symbols' intervals one of the roots is away from zero; False where that was not shown.

    ``known`` as for :func:`nhc.algebra.bounds.interval.cannot_vanish`.
    """
    if not roots:
        return False
    first = _first_box(graph, roots, known)
    order = reachable(graph, roots)
    sides = {symbol: high - low for symbol, (low, high) in first.items() if math.isfinite(high - low) and high > low}
    boxes, left = [first], _MOST_WORK // len(order)
    while boxes:
        box, left = boxes.pop(), left - 1
        bounds = list_bounds(graph, order, {**known, **box})
        if any(excludes_zero(bounds[root]) for root in roots):
            continue
        widest = max(sides, key=lambda symbol: _width(box[symbol]) / sides[symbol], default=None)
        if widest is None or left < len(boxes) or _width(box[widest]) < _SMALLEST * sides[widest]:
            return False
        low, high = box[widest]
        middle = low + (high - low) / 2
        boxes += [{**box, widest: (low, middle)}, {**box, widest: (middle, high)}]
    return True


def _width(interval: Interval) -> float:
    return interval[1] - interval[0]


def _first_box(graph: Graph, roots: Sequence[Node], known: Mapping[Node, Interval]) -> _Box:
    symbols = sorted({symbol for root in roots for symbol in graph.symbols_in(root)})
    box: _Box = {}
    for symbol in symbols:
        box[symbol] = known.get(symbol, EVERYTHING)
        turns = 0 if math.isfinite(_width(box[symbol])) else _turns(graph, roots, symbol)
        if turns:
            box[symbol] = (-turns * math.pi, turns * math.pi)
    return box


def _turns(graph: Graph, roots: Sequence[Node], symbol: Node) -> int:
    """After how many turns of the symbol all roots repeat; 0 where they need not."""
    g, turns = graph, 1
    waves = [n for n in reachable(g, roots) if g.op[n] in ("sin", "cos") and g.depends(n, g.deps[symbol])]
    for slope in tangent(g, [g.a[wave] for wave in waves], {symbol: g.one}):
        number = g.value(slope)
        if number is None:
            return 0
        turns = math.lcm(turns, number.denominator)
    bare = substitute(g, roots, {wave: g.symbol(f"wave {k}", "other") for k, wave in enumerate(waves)}, named=False)
    outside = any(g.depends(root, g.deps[symbol]) for root in bare)
    return 0 if outside or turns > _LONGEST_PERIOD else turns
