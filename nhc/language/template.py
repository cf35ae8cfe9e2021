"""The text of a new spec."""

from __future__ import annotations

import re

from nhc.language.expressions.names import fold
from nhc.language.keys import SYSTEM_PATTERN

_TEXT = """\
# yaml-language-server: $schema=./nhc.schema.json
nhc: 1                                  # language version
system: {name}
about: A knife-edge sleigh; the centre of mass is a distance a ahead of the edge.

coordinates:                            # position of the edge, heading
  x: {{unit: m}}
  y: {{unit: m}}
  theta: {{unit: rad}}
parameters:
  m: {{value: 1.0, unit: kg, about: mass}}
  I: {{value: 0.3, unit: kg*m^2, about: moment of inertia about the centre of mass}}
  a: {{value: 0.25, unit: m, about: from the edge to the centre of mass}}
define:                                 # named expressions; x' is the velocity of x, and (...)' works on positions
  X: x + a*cos(theta)
  Y: y + a*sin(theta)

T: m/2*(X'^2 + Y'^2) + I/2*theta'^2     # kinetic energy
U: 0                                    # force function, Q = + dU/dq; or V, the potential energy, Q = - dV/dq
constraints:                            # linear in the velocities
  - slip: -sin(theta)*x' + cos(theta)*y' = 0
quasi_velocities:                       # what the constraints leave free
  v: cos(theta)*x' + sin(theta)*y'
  w: theta'
outputs:
  speed: abs(v)

draw:                                   # what the page of a run draws and moves
  - body: {{at: [x, y], angle: theta, shape: [[-0.2, -0.2], [0.6, -0.2], [0.6, 0.2], [-0.2, 0.2]]}}
  - {{point: [x, y], trace: true, name: edge}}
scenes:
  glide:
    about: starts straight with a little spin
    initial: {{v: 1.0, w: 0.5}}           # what is left out is 0
    time: [0, 20]
    need: [x, y, theta]
    tolerance: 1e-8
"""


def template(name: str) -> str:
    """Return the text of a small complete spec; ``name`` becomes the system's name, made lower case where need be.

    Raises ``ValueError`` where no name of a system can be made of it.
    """
    system = re.sub("[^a-z0-9_]+", "_", fold(name).lower()).strip("_")
    if not re.fullmatch(SYSTEM_PATTERN, system):
        raise ValueError(f"`{name}` is no name of a system")
    return _TEXT.format(name=system)
