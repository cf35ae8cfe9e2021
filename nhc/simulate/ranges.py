"""Coordinates that leave the range declared for them, where nhc expects them to stay when it chooses velocities."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.simulate.switching import Leg

Values = Sequence[tuple[float, float]]

_SLACK = 1e-9  # of the range's width: a motion that turns at its edge stays within


def tell_ranges(
    legs: Sequence[Leg], headings: Sequence[str], times: Sequence[float], rows: Sequence[Sequence[float]]
) -> tuple[str, ...]:
    """A note for each coordinate that is outside of its range in a row, with the first time and how far it goes.

    ``rows`` are what the run gives under these headings: a coordinate may be there that its state does without.
    """
    system = legs[0].job.system
    notes = []
    for symbol, coordinate in zip(system.q, system.spec.coordinates, strict=True):
        if coordinate.range is None:
            continue
        low, high = map(float, coordinate.range)
        if coordinate.name in headings:
            place = headings.index(coordinate.name)
            values: Values = [(t, row[place]) for t, row in zip(times, rows, strict=True)]
        else:
            values = [row for leg in legs for row in _list_rows(leg, symbol)]
        slack = _SLACK * (high - low)
        outside = [t for t, x in values if not low - slack <= x <= high + slack]
        if outside:
            least, most = min(x for _, x in values), max(x for _, x in values)
            notes.append(
                f"`{coordinate.name}` leaves the range declared for it, [{low:.6g}, {high:.6g}], at t = {outside[0]:.6g}:"
                f" it goes from {least:.6g} to {most:.6g}"
            )
    return tuple(notes)


def _list_rows(leg: Leg, symbol: int) -> Values:
    """The times and values of a coordinate in a leg's rows; none where its state does without it."""
    if symbol not in leg.job.symbols:
        return []
    place = leg.job.symbols.index(symbol)
    states = leg.outcome.states
    return [(t, state[place]) for t, state in zip(leg.task.times[: len(states)], states, strict=True)]
