"""One test per erratum: the printed formula is built, and shown to differ from what the corrected one agrees with."""

from __future__ import annotations

import pytest

from nhc.algebra.calculus import derivative, gradient
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal, are_zero, is_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.exterior import Form, basis_form, d, one_form, wedge
from nhc.mechanics.certificates import wrong
from nhc.mechanics.formulations import chaplygin, euler_lagrange, lagrange, voronec
from nhc.mechanics.frame import Frame, total_derivative
from nhc.mechanics.system import System
from tests.thesis.scenery import (
    Values,
    any_states,
    distance,
    dot,
    error_of,
    generic_frame,
    kernel,
    predict,
    projected_truth,
    random_states,
    rates_of,
    reduced_of,
    state_of,
    system_of,
    truth,
)

RIGHT = 1e-12


def printed_two_form(system: System) -> Form:
    """d(p_i dq_i - T dt) + Q_i dq_i ^ dt, the thesis's form of Lagrange."""
    coframe = lagrange.phase_coframe(system)
    theta = one_form(coframe, {**dict(enumerate(lagrange.momenta(system))), 2 * system.n: system.graph.neg(system.T)})
    return d(theta) + lagrange.dynamic_two_form(system)


def free_accelerations(system: System, values: Values) -> list[float]:
    rates = rates_of(system.graph, system.n)
    rows = lagrange.printed_rows(system, rates)
    mass = gradient(system.graph, rows[0], rates) if system.n == 1 else None
    assert mass is not None  # used for one degree of freedom only
    force = evaluate(system.graph, [substitute(system.graph, rows, {rates[0]: system.graph.zero})[0], *mass], values)
    return [-float(force[0]) / float(force[1])]


@pytest.mark.parametrize("name", ["nh_particle", "skate_incline", "chaplygin_sleigh", "rolling_disk"])
def test_E1(name: str) -> None:
    reduced = reduced_of(system_of(name))
    rates, states = rates_of(reduced.graph, len(reduced.mu)), any_states(reduced.frame, 6)
    boxed = error_of(reduced.frame, wrong.boxed_I_3_sign(reduced, rates), rates, states)
    without = error_of(reduced.frame, wrong.lagrange_of_T_star(reduced, rates), rates, states)
    assert boxed > 0.1
    assert boxed == pytest.approx(2 * without, rel=1e-6)
    assert (
        error_of(reduced.frame, chaplygin.printed_rows(reduced, rates), rates, random_states(reduced.frame, 6)) < RIGHT
    )


def test_E2() -> None:
    frame = generic_frame(system_of("free_rigid_body"))
    g, n = frame.graph, frame.system.n
    momenta = gradient(g, euler_lagrange.quasi_energy(frame), frame.omega)
    kinetic = euler_lagrange.kinetic_two_form(frame)
    for m in range(n):
        for i in range(m + 1, n):
            swirl = dot(g, momenta, [frame.gamma(j, m, i) for j in range(n)])
            mixed = [frame.along(momenta[i], m), g.neg(frame.along(momenta[m], i))]
            assert is_zero(g, g.sub(kinetic.coefficient(m, i), g.sum([swirl, *mixed])))
            assert not is_zero(g, g.sub(kinetic.coefficient(m, i), g.sum([swirl, swirl, *mixed])))
    rates, states = rates_of(g, n), any_states(frame, 6)
    assert error_of(frame, wrong.III_2_4_doubled_gamma(frame, rates), rates, states) > 0.1
    assert error_of(frame, euler_lagrange.printed_rows(frame, rates), rates, random_states(frame, 6)) < RIGHT


@pytest.mark.parametrize(
    "name", ["chaplygin_sleigh", "nh_particle", "voronec_particle", "ball_on_table", "rolling_disk"]
)
def test_E3(name: str) -> None:
    frame = generic_frame(system_of(name))
    rates, states = rates_of(frame.graph, len(frame.free)), any_states(frame, 6)
    assert error_of(frame, wrong.III_2_6_as_printed(frame, rates), rates, states) > 0.1
    assert error_of(frame, euler_lagrange.printed_rows(frame, rates), rates, random_states(frame, 6)) < RIGHT


def test_E4() -> None:
    rod = system_of("bead_on_rod")
    (r,), (omega,) = rod.q, [p for p in rod.p if rod.symbol_name(p) == "Omega"]
    values = state_of(rod)
    expected = values[omega] ** 2 * values[r]
    assert kernel(lagrange.omega(rod), values)[1] == pytest.approx(expected, rel=RIGHT)
    assert kernel(printed_two_form(rod), values)[1] == pytest.approx(-expected, rel=RIGHT)

    pumped = system_of("pumped_pendulum")
    values = state_of(pumped)
    velocity, acceleration = kernel(lagrange.omega(pumped), values)
    assert velocity == pytest.approx(values[pumped.v[0]], rel=RIGHT)
    assert acceleration == pytest.approx(free_accelerations(pumped, values)[0], rel=RIGHT)
    assert abs(kernel(printed_two_form(pumped), values)[0] - values[pumped.v[0]]) > 0.1

    body = system_of("free_rigid_body")
    frame = generic_frame(body)
    g, n = body.graph, body.n
    energy = euler_lagrange.quasi_energy(frame)
    momenta = gradient(g, energy, frame.omega)
    target = euler_lagrange.full_coframe(frame)
    dynamic = euler_lagrange.dynamic_two_form(frame)
    printed = d(one_form(target, {**dict(enumerate(momenta)), 2 * n: g.neg(energy)})) + dynamic
    values = any_states(frame, 1)[0]
    rates = rates_of(g, n)
    moving = dict(zip(frame.omega, rates, strict=True))
    second = [total_derivative(body, node, frame.kinematics, moving) for node in frame.kinematics]
    errors = []
    for form in (printed, euler_lagrange.unconstrained_omega(frame)):
        solved = dict(zip(rates, kernel(form, values)[n : 2 * n], strict=True))
        errors.append(distance(evaluate(g, second, {**values, **solved}), truth(frame, [values])[0]))
    assert errors[0] > 0.1
    assert errors[1] < RIGHT


def test_E5() -> None:
    for name, holds in (("double_pendulum", True), ("spherical_pendulum", True), ("pumped_pendulum", False)):
        system = system_of(name)
        g, p = system.graph, lagrange.momenta(system)
        sides = [
            g.sub(dot(g, [derivative(g, x, q) for x in p], system.v), g.mul(g.number(2), derivative(g, system.T, q)))
            for q in system.q
        ]
        assert all(are_zero(g, sides)) == holds

    body = system_of("free_rigid_body")
    frame = euler_frame(body)
    g = body.graph
    momenta = gradient(g, euler_lagrange.quasi_energy(frame), frame.omega)
    hessian = [entry for p in momenta for entry in gradient(g, p, frame.omega)]
    inertia = [body.p[i] if i == j else g.zero for i in range(3) for j in range(3)]
    assert are_equal(g, hessian, inertia)
    halves = [g.div(entry, g.number(2)) for entry in inertia]
    assert not are_equal(g, hessian, halves)


def euler_frame(system: System) -> Frame:
    from nhc.mechanics.frame import make_frame

    return make_frame(system, system.quasi, [system.graph.symbol(form.name, "quasi") for form in system.quasi])


def test_E6() -> None:
    system = system_of("nh_particle")  # z' = y x', dependent z
    reduced = reduced_of(system)
    g, (x, _, z) = system.graph, system.v
    y = system.q[1]
    on = {z: reduced.velocity(0)}
    p = lagrange.momenta(system)
    b = reduced.b[0][0]
    values = {**any_states(reduced.frame, 1)[0], y: 0.7}
    T_zz, T_zx, T_xz, T_xx = (derivative(g, p[i], v) for i, v in ((2, z), (2, x), (0, z), (0, x)))
    star = derivative(g, derivative(g, reduced.T_star, x), x)
    printed_a = g.add(T_xx, g.mul(T_xz, b))
    whole_a = g.sum([printed_a, g.mul(b, T_zx), g.product([b, T_zz, b])])
    assert are_equal(g, [star], [whole_a])
    assert evaluate(g, [g.sub(star, printed_a)], values)[0] == pytest.approx(0.49)
    b_relation = g.add(g.mul(T_zz, b), T_zx)
    assert evaluate(g, [b_relation], values)[0] == pytest.approx(0.7)
    c_relation = g.add(derivative(g, p[2], y), g.product([T_zz, derivative(g, b, y), x]))
    assert evaluate(g, [c_relation], values)[0] == pytest.approx(values[x])
    # the corrected relation, on systems with everything in them
    for name in ("nh_particle", "voronec_particle", "affine_voronec", "ball_on_table"):
        reduced = reduced_of(system_of(name))
        system, g = reduced.system, reduced.graph
        coframe = voronec.reduced_coframe(reduced)
        on = dict(zip(system.v, reduced.frame.kinematics, strict=True))
        p = substitute(g, lagrange.momenta(system), on)
        for k, momentum in enumerate(gradient(g, reduced.T_star, reduced.v_mu)):
            total = one_form(coframe, coframe.differential(p[reduced.mu[k]]))
            for a, alpha in enumerate(reduced.alpha):
                total = total + one_form(coframe, coframe.differential(p[alpha])).scaled(reduced.b[a][k])
                total = total + one_form(coframe, coframe.differential(reduced.b[a][k])).scaled(p[alpha])
            assert (one_form(coframe, coframe.differential(momentum)) - total).is_zero()


@pytest.mark.parametrize("name", ["voronec_particle", "n_trailer3"])
def test_E7(name: str) -> None:
    reduced = reduced_of(system_of(name))
    rates, states = rates_of(reduced.graph, len(reduced.mu)), any_states(reduced.frame, 6)
    assert error_of(reduced.frame, wrong.I_4_9_mu_thrice(reduced, rates), rates, states) > 0.01
    assert error_of(reduced.frame, voronec.printed_rows(reduced, rates), rates, random_states(reduced.frame, 6)) < RIGHT
    expected = projected_truth(reduced.frame, rates)
    assert are_equal(reduced.graph, associated_rows(reduced, rates, corrected=True), expected)
    assert not are_equal(reduced.graph, associated_rows(reduced, rates, corrected=False), expected)
    # it cannot be seen where b is free of q_alpha
    particle = reduced_of(system_of("nh_particle"))
    rates = rates_of(particle.graph, len(particle.mu))
    expected = projected_truth(particle.frame, rates)
    assert are_equal(particle.graph, wrong.I_4_9_mu_thrice(particle, rates), expected)


def associated_rows(reduced: voronec.Reduced, rates: tuple[Node, ...], *, corrected: bool) -> list[Node]:
    """The second associated equation of III.4 on a motion, divided by dt; corrected: with its missing term and b_betanu."""
    g, system = reduced.graph, reduced.system
    star, v = reduced.T_star, reduced.v_mu
    momenta = gradient(g, star, v)
    rows = []
    for k, nu in enumerate(reduced.mu):
        terms = [voronec.motion_rate(reduced, momenta[k], rates)]
        terms.append(derivative(g, star, system.q[nu]))
        terms += [g.neg(g.mul(v[m], derivative(g, momenta[m], system.q[nu]))) for m in range(len(v))]
        for c, beta in enumerate(reduced.alpha):
            terms.append(g.mul(derivative(g, star, system.q[beta]), reduced.b[c][k]))
            if corrected:
                mixed = dot(g, [derivative(g, p, system.q[beta]) for p in momenta], v)
                terms.append(g.neg(g.mul(mixed, reduced.b[c][k])))
        for a, p in enumerate(reduced.p_alpha):
            turn = g.neg(voronec.motion_rate(reduced, reduced.b[a][k], rates))
            for m, velocity in enumerate(v):
                entry = reduced.b[a][m]
                slope = derivative(g, entry, system.q[nu])
                for c, beta in enumerate(reduced.alpha):
                    factor = reduced.b[c][k if corrected else m]
                    slope = g.add(slope, g.mul(derivative(g, entry, system.q[beta]), factor))
                turn = g.add(turn, g.mul(velocity, slope))
            terms.append(g.mul(p, turn))
        rows.append(g.sub(g.sum(terms), voronec.applied_force(reduced, k)))
    return rows


def printed_omega(reduced: voronec.Reduced) -> Form:
    """The final Omega of III.4."""
    g, m = reduced.graph, len(reduced.mu)
    coframe = voronec.reduced_coframe(reduced)
    dt = basis_form(coframe, 2 * m)
    total = Form(coframe, 2, {})
    for k, momentum in enumerate(gradient(g, reduced.T_star, reduced.v_mu)):
        left = one_form(coframe, coframe.differential(momentum))
        for a, p in enumerate(reduced.p_alpha):
            left = left - one_form(coframe, coframe.differential(reduced.b[a][k])).scaled(p)
        slope = reduced.frame.along(reduced.T_star, reduced.system.l + k)
        beside = one_form(coframe, {m + k: momentum, k: g.sub(slope, voronec.applied_force(reduced, k))})
        total = total + wedge(left, basis_form(coframe, k)) - wedge(beside, dt)
    return total


@pytest.mark.parametrize(
    ("name", "holds"),
    [
        ("voronec_particle", True),
        ("nh_particle", True),
        ("affine_voronec", False),
        ("ball_on_table", False),
        ("charged_sleigh", False),
    ],
)
def test_E8(name: str, holds: bool) -> None:
    reduced = reduced_of(system_of(name))
    m, states = len(reduced.mu), any_states(reduced.frame, 3)
    rates = rates_of(reduced.graph, m)
    right = predict(reduced.frame, voronec.printed_rows(reduced, rates), rates, states)
    worst = [0.0, 0.0]
    for values, expected in zip(states, right, strict=True):
        motion = [*(values[v] for v in reduced.v_mu), *(expected[i] for i in reduced.mu)]
        for k, form in enumerate((voronec.omega(reduced), printed_omega(reduced))):
            worst[k] = max(worst[k], distance(kernel(form, values)[: 2 * m], motion))
    assert worst[0] < 1e-11
    assert worst[1] < 1e-11 if holds else worst[1] > 0.01
