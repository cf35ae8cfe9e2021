"""CasADi's C for a system: Kane's form assembled by CasADi's own derivatives, its LDL^T unrolled, its cse.

The state is nhc's own (coordinates, then the free quasi-velocities), so that results can be compared.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import casadi as ca

from benchmarks.models import Sources
from benchmarks.peers.casadi_assembly import Assembly
from benchmarks.peers.casadi_bicycle import bicycle
from benchmarks.systems import split_name

_WRAPPER = """
int casadi_call(double t, const double *y, const double *p, double *dydt)
{{
    const double *arg[{arguments}] = {{y, p, &t}};
    double *res[{results}] = {{dydt}};
    casadi_int iw[{integers} + 1];
    double w[{reals} + 1];
    return casadi_rhs(arg, res, iw, w, 0);
}}
"""


def casadi_sources(name: str) -> Sources:
    """C of ``int casadi_call(t, y, p, dydt)``."""
    family, count = split_name(name)
    assembly, parameters = _FAMILIES[family](count)
    state = ca.vertcat(assembly.q, assembly.u)
    slope = ca.cse(ca.vertcat(assembly.rates, assembly.solve()))
    function = ca.Function("casadi_rhs", [state, parameters], [slope])
    return print_sources(function)


def print_sources(function: Any) -> Sources:
    """C of ``casadi_call`` around a function ``casadi_rhs`` of (state, parameters), or of (state, parameters, time)."""
    with tempfile.TemporaryDirectory() as folder:
        generator = ca.CodeGenerator("model.c", {"with_header": False})
        generator.add(function)
        generator.generate(folder + "/")
        text = (Path(folder) / "model.c").read_text()
    text += _WRAPPER.format(
        arguments=function.sz_arg(), results=function.sz_res(), integers=function.sz_iw(), reals=function.sz_w()
    )
    return Sources("casadi_call", {"casadi_model.c": text})


def _along(theta: Any) -> Any:
    return ca.vertcat(ca.cos(theta), ca.sin(theta))


def _across(theta: Any) -> Any:
    return ca.vertcat(-ca.sin(theta), ca.cos(theta))


def _symbols(*sizes: int) -> Any:
    return [ca.SX.sym(name, size) for name, size in zip(("q", "u", "p"), sizes, strict=True)]


def _sleigh(_: int) -> Any:
    q, u, p = _symbols(3, 2, 3)
    m, J, a = ca.vertsplit(p)
    made = Assembly(q, u, ca.vertcat(u[0] * _along(q[2]), u[1]))
    made.add_point(m, q[:2] + a * _along(q[2]))
    made.add_turn(J, u[1])
    return made, p


def _disk(_: int) -> Any:
    q, u, p = _symbols(5, 3, 5)
    m, R, A, C, g = ca.vertsplit(p)
    phi, theta = q[2], q[3]
    yaw = u[1] / ca.sin(theta)
    frame = ca.vertcat(u[0], u[1], yaw * ca.cos(theta))
    plane = R * ca.sin(theta) * u[0] * ca.vertcat(ca.sin(phi), -ca.cos(phi)) - R * u[2] * _along(phi)
    made = Assembly(q, u, ca.vertcat(plane, yaw, u[0], u[2] - frame[2]))
    made.add_point(m, ca.vertcat(q[0], q[1], R * ca.sin(theta)), ca.vertcat(0, 0, -m * g))
    made.add_turn(ca.diag(ca.vertcat(A, A, C)), u, frame)
    return made, p


def _trailers(count: int) -> Any:
    """The rates by the recursion down the train, as a user who knows it writes them."""
    q, u, p = _symbols(count + 4, 2, 6)
    m0, J0, Js, m, J, L = ca.vertsplit(p)
    axle, velocity = q[:2], u[0] * _along(q[2])
    rates, axles = [velocity, u[0] * ca.tan(q[3]) / L, u[1]], [axle]
    for i in range(count):
        rates.append(ca.dot(_across(q[4 + i]), velocity) / L)
        velocity = velocity - L * rates[-1] * _across(q[4 + i])
        axles.append(axles[-1] - L * _along(q[4 + i]))
    made = Assembly(q, u, ca.vertcat(*rates))
    made.add_turn(J0, made.rates[2])
    made.add_turn(Js, made.rates[2] + made.rates[3])
    for i, place in enumerate(axles):
        made.add_point(m if i else m0, place)
        if i:
            made.add_turn(J, made.rates[3 + i])
    return made, p


def _snake(count: int) -> Any:
    """The rates by the recursion down the chain."""
    q, u, p = _symbols(count + 2, 2, 3)
    m, J, a = ca.vertsplit(p)
    velocity = u[0] * _along(q[2])
    rates, middles = [velocity, u[1]], [q[:2]]
    for i in range(1, count):
        hinge = velocity - a * rates[-1] * _across(q[1 + i])
        rates.append(ca.dot(_across(q[2 + i]), hinge) / a)
        velocity = hinge - a * rates[-1] * _across(q[2 + i])
        middles.append(middles[-1] - a * _along(q[1 + i]) - a * _along(q[2 + i]))
    made = Assembly(q, u, ca.vertcat(*rates))
    for i, middle in enumerate(middles):
        made.add_point(m, middle)
        made.add_turn(J, made.rates[2 + i])
    return made, p


def _pendulum(count: int) -> Any:
    q, u, p = _symbols(count + 1, count + 1, 4)
    M, m, length, g = ca.vertsplit(p)
    made = Assembly(q, u, u)
    made.add_point(M, q[0])
    bob = ca.vertcat(q[0], 0)
    for i in range(count):
        bob = bob + length * ca.vertcat(ca.sin(q[1 + i]), -ca.cos(q[1 + i]))
        made.add_point(m, bob, ca.vertcat(0, -m * g))
    return made, p


def _bicycle(_: int) -> Any:
    return bicycle()


_FAMILIES = {
    "sleigh": _sleigh,
    "disk": _disk,
    "trailers": _trailers,
    "snake": _snake,
    "pendulum": _pendulum,
    "bicycle": _bicycle,
}
