"""Where the full model goes on a scene, and whether the constraints of a smaller one hold there."""

from __future__ import annotations

import math
from statistics import median

from nhc.language import Spec
from nhc.language.units.derived import derive_units
from nhc.mechanics.properties.singular import smallest_singular_value
from nhc.mechanics.system import System
from nhc.records import record
from nhc.simulate.prepare import Job
from nhc.simulate.run import Trajectory

_LOST = 0.05
"""Of what the full model's constraints have left at their weakest, beside what they have usually."""


@record
class Way:
    """The full model's motion on the output grid: ``rows`` of coordinates and velocities, by ``names``, at ``times``.

    ``weakest``: :func:`_weakest` of its own constraints.
    """

    names: tuple[str, ...]
    times: tuple[float, ...]
    rows: tuple[tuple[float, ...], ...]
    weakest: float

    def find_lost(self, job: Job) -> float | None:
        """The time at which the constraints of a smaller model lose their rank, or nearly; None where they do not.

        Its own run may pass such a place unseen: of sin(phi) v = 0 it may know v = 0 only.
        """
        found = _weakest(job, self.names, self.times, self.rows)
        return found[1] if found[0] < _LOST * self.weakest else None

    def ranges(self, spec: Spec) -> tuple[tuple[str, float, float, str], ...]:
        """(name, least, largest, unit) of each coordinate and velocity."""
        units = derive_units(spec)
        columns = zip(self.names, zip(*self.rows, strict=True), strict=True)
        return tuple((name, min(x) + 0.0, max(x) + 0.0, units.get(name, "")) for name, x in columns)  # no -0.0


def list_asked(system: System) -> tuple[str, ...]:
    """What a run has to tell for a :class:`Way`."""
    return tuple(name for c in system.spec.coordinates for name in (c.name, f"{c.name}'"))


def way_of(found: Trajectory) -> Way:
    """Of a run that tells all coordinates and velocities."""
    names, times, rows = found.headings, found.times, found.rows
    return Way(names, times, rows, _weakest(found.job, names, times, rows)[0])


def _weakest(
    job: Job, names: tuple[str, ...], times: tuple[float, ...], rows: tuple[tuple[float, ...], ...]
) -> tuple[float, float]:
    """The least singular value of the constraints beside its usual size, and when it is least; infinite without constraints."""
    system, values = job.system, list[tuple[float, float]]()
    if not system.constraints:
        return math.inf, 0.0
    place = job.start.values(system)
    symbols = dict(zip(system.q_names, system.q, strict=True))
    kept = [(k, symbols[name]) for k, name in enumerate(names) if name in symbols]
    for t, row in zip(times, rows, strict=True):
        place |= {system.t: t, **{symbol: row[k] for k, symbol in kept}}
        try:
            values.append((smallest_singular_value(system, place), t))
        except (ArithmeticError, ValueError):
            values.append((0.0, t))
    least, t = min(values)
    usual = median(value for value, _ in values)
    return (least / usual if usual else 0.0), t
