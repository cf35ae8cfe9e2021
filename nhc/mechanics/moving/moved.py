"""A frame and T's velocity forms on moving axes: what :mod:`nhc.mechanics.associate` needs, in shorter expressions."""

from __future__ import annotations

from collections.abc import Callable

from nhc.algebra.graph import Node
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.frame import Frame
from nhc.mechanics.rotations.turns import Vector
from nhc.records import record


@record
class Turning:
    """Axes with angular velocity ``omega`` on the motion, and what the forms ``members`` are on them: that velocity, or a point's.

    With p_i the sum of T's slopes by the forms of ``members[i]``, what the velocities of points give to them left out, the terms
    domega along a vector of the frame add up to its weight . (omega x p); the weight is that of ``forms`` where T has them.
    """

    members: tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]
    omega: Vector
    forms: tuple[int, ...] | None


@record
class Weights:
    """W_k(e) of T's forms for a vector e of the frame, and along e what turns and is no form, in the order of ``Moved.turning``."""

    forms: tuple[Node, ...]
    spins: tuple[Vector, ...]


@record
class Spread:
    """T's forms and the velocities as linear functions of ``held``, the symbols of the constraints' forms."""

    forms: tuple[Node, ...]
    velocities: tuple[Node, ...]
    held: tuple[Node, ...]


@record
class Moved:
    """T in the forms of ``kinetic`` on moving axes.

    ``u`` and ``drift`` are the forms on the motion and their rates with the kept velocities' rates left out; ``weights`` are
    those along the frame's free vectors, ``weigh()`` gives those along the constraints' vectors, ``spread()`` what they are
    taken from, None where there are rotations.  The drift of an ``inertial`` form is a component of an acceleration; ``loads``
    are what U gives to each form, ``potential`` what is left of U, in symbols for the ``places`` of points.  A form that is
    ``carried`` needs no term domega of its own.  ``settled``: every vector that stands on no other has forms of the frame for
    its components, so that no other axes can be better.
    """

    frame: Frame
    velocities: tuple[Node, ...]
    kinetic: Kinetic
    u: tuple[Node, ...]
    drift: tuple[Node, ...]
    weights: tuple[Weights, ...]
    weigh: Callable[[], tuple[Weights, ...]]
    spread: Callable[[], Spread] | None
    carried: tuple[bool, ...]
    inertial: tuple[bool, ...]
    loads: tuple[Node, ...]
    potential: Node
    places: dict[Node, Node]
    settled: bool
    turning: tuple[Turning, ...]
