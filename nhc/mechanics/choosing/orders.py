"""Other orders in which velocities complete the quasi-velocities of a spec, and whether a completion is regular everywhere."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.graph import Node
from nhc.algebra.parts import split_powers
from nhc.algebra.rewriting.angles import normalise_angles as normalise
from nhc.algebra.solving.blocks import determinant_of
from nhc.mechanics.frame import make_frame, velocity_symbol
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.system import Form, System

_TURNS = 8  # orders of velocities to complete a coframe with that are tried, of each kind
_EXPANDED = 8  # coordinates up to which the determinant of a coframe is looked at


def list_orders(system: System, pool: Sequence[Form]) -> Iterator[Sequence[Form]]:
    """What to complete with first: the independent velocities from another one on, or a dependent one.

    Beside the speed along a keel that skids as it turns, the yaw rate is always regular, though the keel could be solved for it.
    """
    own = pool[: -system.n]
    yield from (own[k:] for k in range(1, min(len(own), _TURNS)))
    dependent = [form for form in pool[-system.n :] if all(form.name != free.name for free in own)]
    yield from ([form] for form in dependent[:_TURNS])


def may_vanish(system: System, forms: Sequence[Form]) -> bool:
    """Whether the determinant of n forms may be zero somewhere, as far as a look at it tells; no for many forms."""
    if system.n > _EXPANDED:
        return False
    g = system.graph
    determinant = normalise(g, determinant_of(g, [list(form.coefficients) for form in forms]), 200)
    return not cannot_vanish(g, determinant, intervals(system))


def count_weak(system: System, free: Sequence[Form]) -> int:
    """How many of the pivots that a coframe is solved by may vanish, ``free`` being its forms beside the constraints."""
    return len(_list_weak(system, free))


def weak_factors(system: System, free: Sequence[Form]) -> set[Node]:
    """The factors of these pivots that may vanish."""
    return find_weak_factors(system, _list_weak(system, free))


def find_weak_factors(system: System, nodes: Sequence[Node]) -> set[Node]:
    """The factors of nodes that may vanish."""
    g, known = system.graph, intervals(system)
    factors = {base for node in nodes for base in split_powers(g, node)[1]}
    return {base for base in factors if not cannot_vanish(g, base, known)}


def _list_weak(system: System, free: Sequence[Form]) -> list[Node]:
    frame = make_frame(system, free, [velocity_symbol(system, form) for form in free])
    known = intervals(system)
    return [guard for guard, _ in frame.guards if not cannot_vanish(system.graph, guard, known)]
