"""Coordinates that leave the range declared for them, where nhc expects them to stay when it chooses velocities."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.mechanics.values import coordinate_ranges, is_outside
from nhc.simulate.switching import Leg

Values = Sequence[tuple[float, float]]


def tell_ranges(
    legs: Sequence[Leg], headings: Sequence[str], times: Sequence[float], rows: Sequence[Sequence[float]]
) -> tuple[str, ...]:
    """A note for each coordinate that is outside of its range in a row, with the first time and how far it goes.

    ``rows`` are what the run gives under these headings: a coordinate may be there that its state does without.
    """
    system = legs[0].job.system
    notes = []
    for symbol, limits in coordinate_ranges(system).items():
        name = system.q_names[system.q.index(symbol)]
        if name in headings:
            place = headings.index(name)
            values: Values = [(t, row[place]) for t, row in zip(times, rows, strict=True)]
        else:
            values = [row for leg in legs for row in _list_rows(leg, symbol)]
        outside = [t for t, x in values if is_outside(limits, x)]
        if outside:
            (low, high), reached = limits, [x for _, x in values]
            notes.append(
                f"`{name}` leaves the range declared for it, [{low:.6g}, {high:.6g}], at t = {outside[0]:.6g}:"
                f" it goes from {min(reached):.6g} to {max(reached):.6g}"
            )
    return tuple(notes)


def _list_rows(leg: Leg, symbol: int) -> Values:
    """The times and values of a coordinate in a leg's rows; none where its state does without it."""
    if symbol not in leg.job.symbols:
        return []
    place = leg.job.symbols.index(symbol)
    states = leg.outcome.states
    return [(t, state[place]) for t, state in zip(leg.task.times[: len(states)], states, strict=True)]
