"""Kane's equations assembled body by body with CasADi's own derivatives."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import casadi as ca


@dataclass
class Assembly:
    """Partial sums of Kane's equations in the quasi-velocities ``u``: ``mass u' = force``."""

    q: Any
    u: Any
    rates: Any  # q' as a function of q and u
    mass: Any = field(init=False)
    force: Any = field(init=False)

    def __post_init__(self) -> None:
        self.mass = ca.SX.zeros(self.u.numel(), self.u.numel())
        self.force = ca.SX.zeros(self.u.numel(), 1)

    def velocity(self, position: Any) -> Any:
        return ca.jtimes(position, self.q, self.rates)

    def add_point(self, mass: Any, position: Any, load: Any = None) -> None:
        """A mass at a position, with a force on it."""
        velocity = self.velocity(position)
        partial = ca.jacobian(velocity, self.u)
        acceleration = ca.jtimes(velocity, self.q, self.rates)
        self.mass += mass * (partial.T @ partial)
        self.force -= mass * (partial.T @ acceleration)
        if load is not None:
            self.force += partial.T @ load

    def add_turn(self, moments: Any, spin: Any, frame: Any = None) -> None:
        """A body of inertia ``moments`` turning at ``spin``, both on axes that turn at ``frame`` (none: a fixed axis)."""
        partial = ca.jacobian(spin, self.u)
        rate = moments @ ca.jtimes(spin, self.q, self.rates)
        if frame is not None:
            rate += ca.cross(frame, moments @ spin)
        self.mass += partial.T @ moments @ partial
        self.force -= partial.T @ rate

    def solve(self) -> Any:
        diagonal, upper, order = ca.ldl(self.mass)
        return ca.ldl_solve(self.force, diagonal, upper, order)
