"""What of a spec depends on the time, in words."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Node
from nhc.mechanics.properties.conserved import given_forces
from nhc.mechanics.properties.still import depends_on_time
from nhc.mechanics.system import System


def timed_parts(system: System) -> list[str]:
    """The energies, forces and constraints that depend on the time, for arbitrary parameters."""

    def is_timed(nodes: Sequence[Node]) -> bool:
        return any(depends_on_time(system, node) for node in nodes)

    energies = (("T", system.T), (system.spec.potential_kind or "V", system.U))
    parts = [name for name, node in energies if is_timed([node])]
    for names, force in zip(given_forces(system), system.Q, strict=True):
        if is_timed([force]):
            parts += [part for name in names if (part := f"the force on `{name}`") not in parts]
    for rotation, torque in zip(system.rotations, system.torques, strict=True):
        if is_timed(torque):
            parts.append(f"the torque on `{rotation.name}`")
    for form in system.constraints:
        if is_timed([*form.coefficients, form.constant]):
            parts.append(f"the constraint `{form.name}`")
    return parts
