"""How fast the clocks of a spec go: what is periodic in time, such as ``cos(w*t)``, may turn many times within one step.

The stages of such a step see a few phases of it, and so does the estimate of its error: by chance they agree, however wrong they
are.  Where the state hardly feels a force, steps are that long; those that meet lucky phases are taken, and where they span whole
periods the next ones meet the same phases, so that errors add up.  But how fast a function of time goes is known before the run,
and a step of many radians can ask what it passes over (``templates/c/methods/beats.c.jinja``, and step for step the same
:mod:`nhc.simulate.stepping.beating`).
"""

from __future__ import annotations

from collections.abc import Iterator

from nhc.algebra.calculus import derivative
from nhc.algebra.graph import POW, Node
from nhc.algebra.walks import count
from nhc.mechanics.system import System
from nhc.program.ir import Beats
from nhc.program.planning.base import PlannerBase
from nhc.program.runs.clock import HIGH, list_reached

_PERIODIC = frozenset({"sin", "cos"})
_LARGE = 1000  # operations beyond which a rate is not followed


def find_beats(planner: PlannerBase) -> Beats | None:
    """The rates of a spec's clocks, in radians for each unit of time; None where it has none."""
    g, t = planner.graph, planner.system.t
    found = [rate for rate in dict.fromkeys(_list_rates(planner.system)) if count(g, [rate]) <= _LARGE]
    if not found:
        return None
    function = planner.lower_out("beats", "how fast what is periodic in time goes", found)
    return Beats(function, all(not g.deps[rate] & g.mask((t,)) for rate in found))


def _list_rates(system: System) -> Iterator[Node]:
    """Of what turns with the time at a rate that the state has no part in; a power turns as often as its exponent says."""
    g, t = system.graph, system.t
    outside = ~g.mask((t, *system.p))
    for node in list_reached(system, (t,)):
        power = g.b[node] if g.op[node] == POW and 1 < g.b[node] < HIGH else 1
        angle = g.a[node] if power == 1 else g.a[g.a[node]]
        if g.op[node if power == 1 else g.a[node]] not in _PERIODIC or not g.deps[angle] & g.mask((t,)):
            continue
        rate = derivative(g, angle, t)
        if rate != g.zero and not g.deps[rate] & outside:
            yield g.mul(g.number(power), rate)
