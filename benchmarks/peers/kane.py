"""The benchmark systems for SymPy's KanesMethod, each with the speeds that its users choose (Kane's own advice)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from sympy import Symbol, symbols
from sympy.physics.mechanics import (
    KanesMethod,
    Particle,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from benchmarks.peers.kane_bicycle import bicycle
from benchmarks.systems import split_name


@dataclass(frozen=True)
class Kane:
    """Equations ``mass_matrix u' = forcing``, q' as a matrix; symbols in order."""

    coordinates: list[Any]
    speeds: list[Any]
    parameters: list[Symbol]
    rates: Any
    mass_matrix: Any
    forcing: Any


def derive(name: str) -> Kane:
    """Build the model and Kane's equations."""
    family, count = split_name(name)
    method, bodies, loads, parameters = _FAMILIES[family](count)
    method.kanes_equations(bodies, loads)
    known = method.kindiffdict()
    rates = method.q.diff(dynamicsymbols._t).xreplace(known)
    return Kane(list(method.q), list(method.u), parameters, rates, method.mass_matrix, method.forcing)


def _body(name: str, point: Point, frame: ReferenceFrame, mass: Any, moment: Any) -> RigidBody:
    return RigidBody(name, point, frame, mass, (inertia(frame, 0, 0, moment), point))


def _planar_kinematics(q: list[Any], v: Any, across: Any, turn: list[tuple[Any, Any]]) -> list[Any]:
    """x', y' in the speeds along and across the first body, and the other rates."""
    from sympy import cos, sin

    x, y, theta = q
    t = dynamicsymbols._t
    plane = [
        x.diff(t) - v * cos(theta) + across * sin(theta),
        y.diff(t) - v * sin(theta) - across * cos(theta),
    ]
    return plane + [angle.diff(t) - rate for angle, rate in turn]


def _sleigh(_: int) -> Any:
    x, y, theta, v, s, w = dynamicsymbols("x y theta v s w")
    m, J, a = parameters = list(symbols("m J a"))
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", [theta, N.z])
    A.set_ang_vel(N, w * N.z)
    edge = Point("edge")
    edge.set_vel(N, v * A.x + s * A.y)
    centre = edge.locatenew("centre", a * A.x)
    centre.v2pt_theory(edge, N, A)
    kd = _planar_kinematics([x, y, theta], v, s, [(theta, w)])
    method = KanesMethod(
        N, q_ind=[x, y, theta], u_ind=[v, w], u_dependent=[s], kd_eqs=kd, velocity_constraints=[edge.vel(N).dot(A.y)]
    )
    return method, [_body("body", centre, A, m, J)], [], parameters


def _disk(_: int) -> Any:
    from sympy import cos, sin

    x, y, phi, theta, psi = q = dynamicsymbols("x y phi theta psi")
    wt, wu, wn, vx, vy = dynamicsymbols("wt wu wn vx vy")
    m, R, A_, C_, g = parameters = list(symbols("m R A C g"))
    t = dynamicsymbols._t
    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [phi, N.z])
    L = Y.orientnew("L", "Axis", [theta, Y.x])  # L.z the axis, L.y the line of steepest ascent
    D = L.orientnew("D", "Axis", [psi, L.z])
    D.set_ang_vel(N, wt * L.x + wu * L.y + wn * L.z)
    L.set_ang_vel(N, wt * L.x + wu * L.y + wu * cos(theta) / sin(theta) * L.z)
    centre = Point("centre")
    # the centre's height follows from the lean; its horizontal speeds are the dependent ones
    centre.set_vel(N, vx * N.x + vy * N.y + R * cos(theta) * wt * N.z)
    contact = -R * L.y
    slip = centre.vel(N) + D.ang_vel_in(N).cross(contact)
    kd = [
        x.diff(t) - vx,
        y.diff(t) - vy,
        phi.diff(t) - wu / sin(theta),
        theta.diff(t) - wt,
        psi.diff(t) - wn + wu * cos(theta) / sin(theta),
    ]
    method = KanesMethod(
        N,
        q_ind=list(q),
        u_ind=[wt, wu, wn],
        u_dependent=[vx, vy],
        kd_eqs=kd,
        velocity_constraints=[slip.dot(N.x), slip.dot(N.y)],
    )
    body = RigidBody("disk", centre, D, m, (inertia(L, A_, A_, C_), centre))
    return method, [body], [(centre, -m * g * N.z)], parameters


def _trailers(count: int) -> Any:
    q = dynamicsymbols(f"x y theta0 phi theta1:{count + 1}")
    x, y, phi = q[0], q[1], q[3]
    angles = [q[2], *q[4:]]
    v, w, across, *turn = dynamicsymbols(f"v w s w0:{count + 1}")
    m0, J0, Js, m, J, L = parameters = list(symbols("m0 J0 Js m J L"))
    N = ReferenceFrame("N")
    frames = [N.orientnew(f"A{i}", "Axis", [angle, N.z]) for i, angle in enumerate(angles)]
    for frame, rate in zip(frames, turn, strict=True):
        frame.set_ang_vel(N, rate * N.z)
    steered = frames[0].orientnew("F", "Axis", [phi, N.z])
    steered.set_ang_vel(N, (turn[0] + w) * N.z)
    axle = Point("P0")
    axle.set_vel(N, v * frames[0].x + across * frames[0].y)
    front = axle.locatenew("front", L * frames[0].x)
    front.v2pt_theory(axle, N, frames[0])
    slips = [axle.vel(N).dot(frames[0].y), front.vel(N).dot(steered.y)]
    bodies = [_body("car", axle, frames[0], m0, J0), _body("axle", front, steered, 0, Js)]
    for i in range(1, count + 1):
        following = axle.locatenew(f"P{i}", -L * frames[i].x)
        following.v2pt_theory(axle, N, frames[i])
        axle = following
        slips.append(axle.vel(N).dot(frames[i].y))
        bodies.append(_body(f"B{i}", axle, frames[i], m, J))
    turns = [*zip(angles, turn, strict=True), (phi, w)]
    kd = _planar_kinematics([x, y, angles[0]], v, across, turns)
    method = KanesMethod(
        N, q_ind=list(q), u_ind=[v, w], u_dependent=[across, *turn], kd_eqs=kd, velocity_constraints=slips
    )
    return method, bodies, [], parameters


def _snake(count: int) -> Any:
    x, y, *angles = dynamicsymbols(f"x y theta1:{count + 1}")
    v, across, *turn = dynamicsymbols(f"v s w1:{count + 1}")
    m, J, a = parameters = list(symbols("m J a"))
    N = ReferenceFrame("N")
    frames = [N.orientnew(f"A{i}", "Axis", [angle, N.z]) for i, angle in enumerate(angles)]
    for frame, rate in zip(frames, turn, strict=True):
        frame.set_ang_vel(N, rate * N.z)
    middle = Point("P1")
    middle.set_vel(N, v * frames[0].x + across * frames[0].y)
    slips = [middle.vel(N).dot(frames[0].y)]
    bodies = [_body("B1", middle, frames[0], m, J)]
    for i in range(1, count):
        hinge = middle.locatenew(f"H{i}", -a * frames[i - 1].x)
        hinge.v2pt_theory(middle, N, frames[i - 1])
        middle = hinge.locatenew(f"P{i + 1}", -a * frames[i].x)
        middle.v2pt_theory(hinge, N, frames[i])
        slips.append(middle.vel(N).dot(frames[i].y))
        bodies.append(_body(f"B{i + 1}", middle, frames[i], m, J))
    kd = _planar_kinematics([x, y, angles[0]], v, across, list(zip(angles, turn, strict=True)))
    method = KanesMethod(
        N,
        q_ind=[x, y, *angles],
        u_ind=[v, turn[0]],
        u_dependent=[across, *turn[1:]],
        kd_eqs=kd,
        velocity_constraints=slips,
    )
    return method, bodies, [], parameters


def _pendulum(count: int) -> Any:
    q = dynamicsymbols(f"x theta1:{count + 1}")
    angles = q[1:]
    v, *turn = u = dynamicsymbols(f"v w1:{count + 1}")
    M, m, length, g = parameters = list(symbols("M m l g"))
    t = dynamicsymbols._t
    N = ReferenceFrame("N")
    cart = Point("cart")
    cart.set_vel(N, v * N.x)
    particles, loads, last = [Particle("cart", cart, M)], [], cart
    for i, (angle, rate) in enumerate(zip(angles, turn, strict=True)):
        frame = N.orientnew(f"A{i}", "Axis", [angle, N.z])
        frame.set_ang_vel(N, rate * N.z)
        bob = last.locatenew(f"P{i}", -length * frame.y)
        bob.v2pt_theory(last, N, frame)
        particles.append(Particle(f"bob{i}", bob, m))
        loads.append((bob, -m * g * N.y))
        last = bob
    kd = [coordinate.diff(t) - speed for coordinate, speed in zip(q, u, strict=True)]
    return KanesMethod(N, q_ind=list(q), u_ind=list(u), kd_eqs=kd), particles, loads, parameters


_FAMILIES = {
    "sleigh": _sleigh,
    "disk": _disk,
    "trailers": _trailers,
    "snake": _snake,
    "pendulum": _pendulum,
    "bicycle": bicycle,
}
