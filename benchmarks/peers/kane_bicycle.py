"""Whipple's bicycle for KanesMethod, after SymPy's own test (test_kane3: Meijaard et al. 2007 in Autolev's names).

The wheels' places on the ground and their turns are ignorable and left out, which spares KanesMethod work.
"""

from __future__ import annotations

from typing import Any

from sympy import symbols
from sympy.physics.mechanics import KanesMethod, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia

# approximately the set of Meijaard et al., in the order of the parameters below
VALUES = (
    *(0.35, 0.3, 1.2566, 0.0321, 0.3, 0.9534, 0.03, 0.2, 0.3, 0.4, 0.0603, 0.12, 0.1405, 0.28),
    *(9.2, 11.0, 2.8, -2.4, 0.05892, 0.06, 0.00708, 0.00756, 9.81, 85.0, 4.0, 3.0, 2.0),
)


def bicycle(_: int) -> Any:
    """The method, its bodies, loads and parameters."""
    yaw, lean, pitch, steer = dynamicsymbols("yaw lean pitch steer")
    u1, u2, u3, u4, u5, u6 = dynamicsymbols("u1:7")
    names = (
        "rF rR tilt offset fork frame_length h1 h3 b1 b3 R11 R22 F11 F22 B11 B22 B33 B31 H11 H22 H33 H31 g mB mH mF mR"
    )
    parameters = list(symbols(names))
    (rF, rR, tilt, offset, fork, length, h1, h3, b1, b3, R11, R22, F11, F22) = parameters[:14]
    (B11, B22, B33, B31, H11, H22, H33, H31, g, mB, mH, mF, mR) = parameters[14:]
    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [yaw, N.z])
    R = Y.orientnew("R", "Axis", [lean, Y.x])
    frame = R.orientnew("B", "Axis", [pitch + tilt, R.y])
    frame_axes = frame.orientnew("Bx", "Axis", [-tilt, frame.y])
    front = frame.orientnew("H", "Axis", [steer, frame.x])
    front_axes = front.orientnew("Hx", "Axis", [-tilt, front.y])
    rear_wheel, front_wheel = ReferenceFrame("WR"), ReferenceFrame("WF")

    rear_contact = Point("rear contact")
    rear_hub = rear_contact.locatenew("rear hub", rR * R.z)
    head = rear_hub.locatenew("head", length * frame.z)
    frame_centre = rear_hub.locatenew("B", -b1 * frame.x + b3 * frame.z)
    front_centre = head.locatenew("H", -h1 * front.x + h3 * front.z)
    front_hub = head.locatenew("front hub", fork * front.x + offset * front.z)
    down = (front.y.dot(Y.z) * front.y - Y.z).normalize()
    front_contact = front_hub.locatenew("front contact", rF * down)

    Y.set_ang_vel(N, u1 * Y.z)
    R.set_ang_vel(Y, u2 * R.x)
    rear_wheel.set_ang_vel(frame, u3 * frame.y)
    frame.set_ang_vel(R, u4 * frame.y)
    front.set_ang_vel(frame, u5 * frame.x)
    front_wheel.set_ang_vel(front, u6 * front.y)
    rear_contact.set_vel(N, 0)
    rear_hub.v2pt_theory(rear_contact, N, rear_wheel)
    head.v2pt_theory(rear_hub, N, frame)
    frame_centre.v2pt_theory(rear_hub, N, frame)
    front_centre.v2pt_theory(head, N, front)
    front_hub.v2pt_theory(head, N, front)
    front_contact.v2pt_theory(front_hub, N, front_wheel)

    bodies = [
        RigidBody("B", frame_centre, frame, mB, (inertia(frame_axes, B11, B22, B33, 0, 0, B31), frame_centre)),
        RigidBody("H", front_centre, front, mH, (inertia(front_axes, H11, H22, H33, 0, 0, H31), front_centre)),
        RigidBody("R", rear_hub, rear_wheel, mR, (inertia(frame, R11, R22, R11), rear_hub)),
        RigidBody("F", front_hub, front_wheel, mF, (inertia(front, F11, F22, F11), front_hub)),
    ]
    loads = [
        (point, -mass * g * Y.z)
        for point, mass in ((frame_centre, mB), (front_centre, mH), (front_hub, mF), (rear_hub, mR))
    ]
    t = dynamicsymbols._t
    method = KanesMethod(
        N,
        q_ind=[yaw, lean, steer],
        q_dependent=[pitch],
        configuration_constraints=[front_contact.pos_from(rear_contact).dot(Y.z)],
        u_ind=[u2, u3, u5],
        u_dependent=[u1, u4, u6],
        velocity_constraints=[front_contact.vel(N).dot(axis) for axis in (Y.x, Y.y, Y.z)],
        kd_eqs=[yaw.diff(t) - u1, lean.diff(t) - u2, pitch.diff(t) - u4, steer.diff(t) - u5],
        constraint_solver="CRAMER",
    )
    return method, bodies, loads, parameters
