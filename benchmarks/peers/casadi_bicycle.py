"""The gallery's bicycle for CasADi: the same coordinates, parameters and free velocities as specs/bicycle.yaml."""

from __future__ import annotations

from typing import Any

import casadi as ca

from benchmarks.peers.casadi_assembly import Assembly

FREE = (4, 6, 7)  # roll', steer', thR'
BOUND = (3, 5, 8)  # yaw', pitch', thF'


def bicycle() -> Any:
    """The assembled equations and the parameters in the spec's order."""
    q, qd, u, p = ca.SX.sym("q", 9), ca.SX.sym("qd", 9), ca.SX.sym("u", 3), ca.SX.sym("p", 26)
    (w, c, lam, g, r_R, m_R, R_xx, R_yy, x_B, z_B, m_B, B_xx, B_xz, B_yy, B_zz) = ca.vertsplit(p[:15])
    (x_H, z_H, m_H, H_xx, H_xz, H_yy, H_zz, r_F, m_F, F_xx, F_yy) = ca.vertsplit(p[15:])
    tilted = _turn(2, lam)
    rear = _turn(3, q[3]) @ _turn(1, q[4]) @ _turn(2, q[5])  # columns: the axes of the rear frame in space
    front = rear @ tilted @ _turn(3, q[6]) @ tilted.T
    hub = q[:3]
    foot = hub + rear @ ca.vertcat(w + c, 0, r_R)
    rear_centre = hub + rear @ ca.vertcat(x_B, 0, z_B + r_R)
    front_centre = foot + front @ ca.vertcat(x_H - w - c, 0, z_H)
    front_hub = foot + front @ ca.vertcat(-c, 0, -r_F)
    turn = ca.vertcat(
        ca.cos(q[5]) * qd[4] - ca.cos(q[4]) * ca.sin(q[5]) * qd[3],
        qd[5] + ca.sin(q[4]) * qd[3],
        ca.sin(q[5]) * qd[4] + ca.cos(q[4]) * ca.cos(q[5]) * qd[3],
    )
    front_turn = tilted @ (_turn(3, q[6]).T @ tilted.T @ turn + ca.vertcat(0, 0, qd[6]))
    rear_spin = turn + ca.vertcat(0, qd[7], 0)
    front_spin = front_turn + ca.vertcat(0, qd[8], 0)
    rear_slip = qd[:3] + rear @ ca.cross(rear_spin, _contact(rear, r_R))
    front_slip = ca.jtimes(front_hub, q, qd) + front @ ca.cross(front_spin, _contact(front, r_F))
    rates = _solve_rates(qd, u, rear_slip, front_slip)
    made = Assembly(q, u, rates)
    for mass, place in ((m_R, hub), (m_B, rear_centre), (m_H, front_centre), (m_F, front_hub)):
        made.add_point(mass, place, ca.vertcat(0, 0, mass * g))
    # the spins as functions of q and u
    turn, front_turn, rear_spin, front_spin = ca.substitute([turn, front_turn, rear_spin, front_spin], [qd], [rates])
    made.add_turn(ca.diag(ca.vertcat(R_xx, R_yy, R_xx)), rear_spin, turn)
    made.add_turn(_inertia(B_xx, B_yy, B_zz, B_xz), turn, turn)
    made.add_turn(_inertia(H_xx, H_yy, H_zz, H_xz), front_turn, front_turn)
    made.add_turn(ca.diag(ca.vertcat(F_xx, F_yy, F_xx)), front_spin, front_turn)
    return made, p


def _solve_rates(qd: Any, u: Any, rear_slip: Any, front_slip: Any) -> Any:
    """q' in the free velocities: the rear hub's velocity stands alone in its rows, the other three rates by Cramer."""
    free, bound = ca.vertcat(*(qd[i] for i in FREE)), ca.vertcat(*(qd[i] for i in BOUND))
    hub = qd[:3] - rear_slip
    rows = ca.substitute(front_slip, qd[:3], hub)
    matrix = ca.jacobian(rows, bound)
    rest = ca.substitute(rows, bound, ca.SX.zeros(3, 1))
    solved = ca.substitute(-ca.inv_minor(matrix) @ rest, free, u)
    hub = ca.substitute(ca.substitute(hub, bound, solved), free, u)
    known = dict(zip((*FREE, *BOUND), (*ca.vertsplit(u), *ca.vertsplit(solved)), strict=True))
    return ca.vertcat(hub, *(known[i] for i in range(3, 9)))


def _turn(axis: int, angle: Any) -> Any:
    """Columns: the turned axes."""
    s, c = ca.sin(angle), ca.cos(angle)
    rows = {
        1: [[1, 0, 0], [0, c, -s], [0, s, c]],
        2: [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        3: [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return ca.vertcat(*(ca.horzcat(*row) for row in rows[axis]))


def _contact(frame: Any, radius: Any) -> Any:
    """From a wheel's centre to its point of contact, on the frame's axes."""
    scale = radius / ca.sqrt(frame[2, 0] ** 2 + frame[2, 2] ** 2)
    return ca.vertcat(scale * frame[2, 0], 0, scale * frame[2, 2])


def _inertia(xx: Any, yy: Any, zz: Any, xz: Any) -> Any:
    """T = (xx w1^2 + yy w2^2 + zz w3^2)/2 + xz w1 w3, as the spec writes it."""
    return ca.vertcat(ca.horzcat(xx, 0, xz), ca.horzcat(0, yy, 0), ca.horzcat(xz, 0, zz))
