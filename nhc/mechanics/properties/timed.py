"""What of a spec contains the time, in words."""

from __future__ import annotations

from nhc.mechanics.properties.conserved import given_forces
from nhc.mechanics.system import System


def timed_parts(system: System) -> list[str]:
    """The energies, forces and constraints in which the time is written, whatever the parameters are."""
    g, time = system.graph, system.graph.deps[system.t]
    energies = (("T", system.T), (system.spec.potential_kind or "V", system.U))
    parts = [name for name, node in energies if g.depends(node, time)]
    for names, force in zip(given_forces(system), system.Q, strict=True):
        if g.depends(force, time):
            parts += [part for name in names if (part := f"the force on `{name}`") not in parts]
    for rotation, torque in zip(system.rotations, system.torques, strict=True):
        if any(g.depends(node, time) for node in torque):
            parts.append(f"the torque on `{rotation.name}`")
    for form in system.constraints:
        if any(g.depends(node, time) for node in (*form.coefficients, form.constant)):
            parts.append(f"the constraint `{form.name}`")
    return parts
