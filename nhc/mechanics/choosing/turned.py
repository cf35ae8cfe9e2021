"""Angular velocities on the axes on which a spec does not have them, where constraints hold a component there.

A constraint on the component of omega along an axis of space is oblique to the axes of the body: which two of their components are
free changes as the body turns, and each choice is singular somewhere.  The other two components in space are free everywhere.
"""

from __future__ import annotations

from nhc.mechanics.choosing.minors import unused_name
from nhc.mechanics.system import Form, System


def turned_omegas(system: System) -> list[list[Form]]:
    """The components of each rotation's angular velocity in space where the spec has them on the body's axes, or the reverse."""
    g, names = system.graph, list[str]()
    found = list[list[Form]]()
    for rotation in system.rotations:
        lines = rotation.matrix if rotation.sign > 0 else tuple(zip(*rotation.matrix, strict=True))
        own = list[Form]()
        for line in lines:
            names.append(unused_name(system, names))
            own.append(Form.written(names[-1], g.dot(line, rotation.omega), g, system.v, ""))
        found.append(own)
    return found
