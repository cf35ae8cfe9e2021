"""One test per erratum of writing and of convention (E9 to E16), as in ``test_errata.py``."""

from __future__ import annotations

import math

import pytest

from nhc.algebra.calculus import derivative, gradient, tangent
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal, are_zero, is_zero
from nhc.algebra.rebuilding import substitute
from nhc.exterior import Form, basis_form, d, one_form, pullback, wedge
from nhc.mechanics.formulations import euler_lagrange, lagrange, newton, voronec
from nhc.mechanics.frame import form_value, total_derivative
from nhc.mechanics.regular.regularity import relative_determinant
from nhc.mechanics.values import default_values
from tests.thesis.scenery import (
    Values,
    any_states,
    dot,
    generic_frame,
    kernel,
    rates_of,
    reduced_of,
    state_of,
    system_of,
)
from tests.thesis.test_diagrams import constrained_images

RIGHT = 1e-12


def test_E9() -> None:
    system = system_of("point_mass")
    g, n = system.graph, system.n
    right, coframe = newton.omega(system), lagrange.phase_coframe(system)
    swapped = Form(coframe, 2, {})
    for i, momentum in enumerate(lagrange.momenta(system)):
        force = one_form(coframe, {n + i: gradient(g, momentum, system.v)[i], 2 * n: g.neg(system.force(i))})
        swapped = swapped + wedge(basis_form(coframe, i) - basis_form(coframe, 2 * n).scaled(system.v[i]), force)
    assert (right + swapped).is_zero()
    assert not (right - swapped).is_zero()
    kinetic = d(one_form(coframe, {**dict(enumerate(lagrange.momenta(system))), 2 * n: g.neg(system.T)}))
    assert (kinetic + lagrange.dynamic_two_form(system) - right).is_zero()
    values = {**state_of(system), system.v[2]: 0.0}  # no drag
    fall = kernel(right, values)[-1]
    assert fall == pytest.approx(-9.81)
    printed = evaluate(g, [system.force(2)], values)[0]  # m (dv - X dt) = 0: the acceleration would be X
    assert abs(printed - fall) > 9


def test_E10() -> None:
    system = system_of("pendulum")
    g, rates = system.graph, rates_of(system.graph, 1)
    for sign, holds in ((1, True), (-1, False)):
        L = g.add(system.T, g.mul(g.number(sign), system.U))
        momentum = derivative(g, L, system.v[0])
        row = total_derivative(system, momentum, system.v, dict(zip(system.v, rates, strict=True)))
        row = g.sub(row, derivative(g, L, system.q[0]))
        assert are_equal(g, [row], lagrange.printed_rows(system, rates)) == holds


def test_E11() -> None:
    reduced = reduced_of(system_of("ball_on_table"))
    system, g, frame = reduced.system, reduced.graph, reduced.frame
    assert len(frame.kinematics) + len(euler_lagrange.printed_rows(frame, rates_of(g, 3))) == 2 * system.n - system.l
    assert 2 * system.n - system.l != 2 * system.n - 1
    without = [g.sub(node, b) for node, b in zip(frame.kinematics, frame.drift, strict=True)]
    on, broken = (
        [g.add(dot(g, form.coefficients, velocities), form.constant) for form in system.constraints]
        for velocities in (frame.kinematics, without)
    )
    assert all(are_zero(g, on))
    assert max(abs(x) for x in evaluate(g, broken, any_states(frame, 1)[0])) > 0.1


def test_E12() -> None:
    """I.2.10 and I.2.11 on virtual displacements built by differentiation: dq_j = delta q_j, with rates and variations of q'."""
    frame = generic_frame(system_of("free_rigid_body"))
    system, g, n = frame.system, frame.graph, frame.system.n
    shift, shift_rate, varied = (rates_of(g, n, name) for name in ("dq", "dq_rate", "dv"))
    omega = [form_value(system, form) for form in frame.forms]
    delta_pi = [dot(g, form.coefficients, shift) for form in frame.forms]
    moving = {
        **dict(zip(system.q, system.v, strict=True)),
        system.t: g.one,
        **dict(zip(shift, shift_rate, strict=True)),
    }
    varying = {**dict(zip(system.q, shift, strict=True)), **dict(zip(system.v, varied, strict=True))}
    gap = [g.sub(x, y) for x, y in zip(tangent(g, delta_pi, moving), tangent(g, omega, varying), strict=True)]
    c = [g.sub(x, y) for x, y in zip(shift_rate, varied, strict=True)]
    p = lagrange.momenta(system)
    p_star = [dot(g, e, p) for e in frame.vectors]
    carried = [dot(g, [dot(g, [form.coefficients[j] for form in frame.forms], p_star)], [c[j]]) for j in range(n)]
    assert are_equal(g, [g.sum(carried)], [dot(g, p, c)])  # I.2.10
    swirl = []
    for i in range(n):
        per_j = [g.add(frame.epsilon(i, j), dot(g, [frame.gamma(i, m, j) for m in range(n)], omega)) for j in range(n)]
        swirl.append(per_j)
    brace = [g.sub(gap[i], dot(g, swirl[i], delta_pi)) for i in range(n)]
    assert are_equal(g, [dot(g, p_star, brace)], [dot(g, p, c)])
    # p*_j: the momentum belongs to the index of delta pi_j, the sum on i is left to itself
    printed = g.sum(
        [g.mul(p_star[j], g.sub(gap[i], g.mul(swirl[i][j], delta_pi[j]))) for i in range(n) for j in range(n)]
    )
    assert not are_equal(g, [printed], [dot(g, p, c)])
    # (delta pi_j)' - (delta pi_j)' would be zero; the bracket is not, even where variations and rates of q' commute
    still = substitute(g, gap, dict(zip(shift_rate, varied, strict=True)))
    assert not any(are_zero(g, still))


def test_E13() -> None:
    system = system_of("bead_on_rod")
    g, (m, omega) = (
        system.graph,
        [next(p for p in system.p if system.symbol_name(p) == name) for name in ("m", "Omega")],
    )
    (r,) = system.q
    angle = g.mul(omega, system.t)
    place = [g.mul(r, g.function("cos", angle)), g.mul(r, g.function("sin", angle))]
    energies = []
    for seeds in ({r: system.v[0], system.t: g.one}, {r: system.v[0]}):
        speed = tangent(g, place, seeds)
        energies.append(g.div(g.mul(m, dot(g, speed, speed)), g.number(2)))
    assert are_equal(g, [energies[0]], [system.T])
    lost = g.div(g.product([m, g.power(omega, 2), g.power(r, 2)]), g.number(2))
    assert are_equal(g, [g.sub(system.T, energies[1])], [lost])
    assert not is_zero(g, lost)
    # II.2.1: V.dOM dm - V^2/2 dt, on the point, is the kinetic 1-form of II.2.2
    coframe = lagrange.phase_coframe(system)
    speed = tangent(g, place, {r: system.v[0], system.t: g.one})
    theta = one_form(coframe, {2: g.neg(system.T)})
    for v, x in zip(speed, place, strict=True):
        theta = theta + one_form(coframe, coframe.differential(x)).scaled(g.mul(m, v))
    assert (theta - lagrange.kinetic_one_form(system)).is_zero()


def test_E14() -> None:
    for name in ("voronec_particle", "affine_voronec"):
        reduced = reduced_of(system_of(name))
        system, g = reduced.system, reduced.graph
        for j in range(system.n):
            turn = [derivative(g, reduced.velocity(a), system.q[j]) for a in range(len(reduced.alpha))]
            right = g.add(reduced.slopes[j], dot(g, reduced.p_alpha, turn))
            assert are_equal(g, [derivative(g, reduced.T_star, system.q[j])], [right])
            assert not are_equal(g, [derivative(g, reduced.T_star, system.v[j])], [right])


def test_E15() -> None:
    reduced = reduced_of(system_of("nh_particle_pot"))
    system, g, m = reduced.system, reduced.graph, len(reduced.mu)
    coframe, v = voronec.reduced_coframe(reduced), reduced.v_mu
    on = dict(zip(system.v, reduced.frame.kinematics, strict=True))
    p = substitute(g, lagrange.momenta(system), on)
    # III.3.2: slopes of T, not momenta
    for mu in reduced.mu:
        turns = [dot(g, [derivative(g, b, system.q[mu]) for b in row], v) for row in reduced.b]
        right = g.sub(derivative(g, reduced.T_star, system.q[mu]), dot(g, reduced.p_alpha, turns))
        assert are_equal(g, [reduced.slopes[mu]], [right])
    momentum_gaps = [g.sub(p[mu], derivative(g, reduced.T_star, v[k])) for k, mu in enumerate(reduced.mu)]
    assert not all(are_zero(g, momentum_gaps))  # what III.3.2 says with its dots, b being free of q'
    # III.3.3: p_i dq'_i = dT*/dq'_mu dq'_mu + p_alpha q'_mu db_alphamu, and not p_mu q'_mu db_alphamu
    images, _ = constrained_images(reduced)
    whole = Form(coframe, 1, {})
    for i in range(system.n):
        whole = whole + images[system.n + i].scaled(p[i])
    star = one_form(coframe, {m + k: derivative(g, reduced.T_star, v[k]) for k in range(m)})
    corrected, printed = star, star
    for a, p_alpha in enumerate(reduced.p_alpha):
        for k, b in enumerate(reduced.b[a]):
            turn = one_form(coframe, coframe.differential(b)).scaled(v[k])
            corrected, printed = corrected + turn.scaled(p_alpha), printed + turn.scaled(p[reduced.mu[k]])
    assert (whole - corrected).is_zero()
    assert not (whole - printed).is_zero()
    # III.3 (1): dq_nu; with dq'_nu the row does not hold on a motion
    rates = rates_of(g, m)
    momenta = gradient(g, reduced.T_star, v)
    hessian = [gradient(g, momentum, v) for momentum in momenta]
    assert are_equal(g, [dot(g, row, v) for row in hessian], momenta)
    assert not are_equal(g, [dot(g, row, rates) for row in hessian], momenta)
    # II.3.1: where T contains the time, d(p dq - T dt) has a term that the printed expansion lacks
    pumped = system_of("pumped_pendulum")
    g, frame = pumped.graph, lagrange.phase_coframe(pumped)
    (momentum,), (q,), (speed,), dt = lagrange.momenta(pumped), pumped.q, pumped.v, basis_form(frame, 2)
    printed = wedge(basis_form(frame, 1), basis_form(frame, 0)).scaled(derivative(g, momentum, speed))
    printed = printed - wedge(one_form(frame, {0: derivative(g, pumped.T, q), 1: momentum}), dt)
    exact = d(one_form(frame, {0: momentum, 2: g.neg(pumped.T)}))
    missing = wedge(dt, basis_form(frame, 0)).scaled(derivative(g, momentum, pumped.t))
    assert (exact - printed - missing).is_zero()
    assert not missing.is_zero()


def test_E16() -> None:
    board = system_of("snakeboard")
    values: Values = {
        **default_values(board),
        **dict.fromkeys(board.q, 0.2),
        **dict.fromkeys(board.v, 0.0),
        board.t: 0.0,
    }
    assert board.q_names[:3] == ("x", "y", "theta")
    flat = evaluate(board.graph, [a for form in board.constraints for a in form.coefficients], values)
    rows = [[float(x) for x in flat[k * board.n : (k + 1) * board.n]] for k in range(2)]
    assert relative_determinant(rows, (0, 1)) < RIGHT
    assert max(relative_determinant(rows, columns) for columns in ((0, 2), (1, 2))) > 0.1
    # eliminating dq_alpha is a restriction, legitimate on Omega
    for name in ("snakeboard", "affine_voronec"):
        reduced = reduced_of(system_of(name))
        m = len(reduced.mu)
        images, functions = constrained_images(reduced)
        target = voronec.reduced_coframe(reduced)
        dt = basis_form(target, 2 * m)
        for a, alpha in enumerate(reduced.alpha):
            left = images[alpha] - dt.scaled(reduced.velocity(a))
            right = Form(target, 1, {})
            for k in range(m):
                right = right + (basis_form(target, k) - dt.scaled(reduced.v_mu[k])).scaled(reduced.b[a][k])
            assert (left - right).is_zero()
        found = pullback(lagrange.omega(reduced.system), target, images, functions)
        assert (found - voronec.omega(reduced)).is_zero()
        assert all(math.isfinite(x) for x in kernel(found, any_states(reduced.frame, 1)[0]))
