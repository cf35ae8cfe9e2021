"""Structure equations of quasi-velocities: what d of the coframe gives is gamma and epsilon (I.2.11)."""

from __future__ import annotations

import pytest

from nhc.algebra.calculus import derivative
from nhc.algebra.exact.modular import are_equal, is_zero
from nhc.exterior import basis_form, d
from nhc.mechanics.formulations.euler_lagrange import full_coframe
from nhc.mechanics.frame import Frame, make_frame
from tests.thesis.scenery import generic_frame, system_of


def euler_frame() -> Frame:
    system = system_of("free_rigid_body")
    return make_frame(system, system.quasi, [system.graph.symbol(form.name, "quasi") for form in system.quasi])


@pytest.mark.parametrize(
    "name", ["free_rigid_body", "chaplygin_sleigh", "affine_voronec", "ball_on_table", "point_mass"]
)
def test_structure_equations(name: str) -> None:
    """d(dpi_i) = 1/2 gamma^i_mj dpi_m ^ dpi_j - epsilon^i_j dpi_j ^ dt, with generic quasi-velocities."""
    frame = generic_frame(system_of(name))
    g, n = frame.graph, frame.system.n
    coframe = full_coframe(frame)
    seen = 0
    for i in range(n):
        form = d(basis_form(coframe, i))
        for m in range(n):
            for j in range(n):
                assert is_zero(g, g.sub(form.coefficient(m, j), frame.gamma(i, m, j)))
            assert is_zero(g, g.add(form.coefficient(m, 2 * n), frame.epsilon(i, m)))
        allowed = {(m, j) for m in range(n) for j in range(n)} | {(m, 2 * n) for m in range(n)}
        assert set(form.terms) <= allowed
        seen += len(form.terms)
    assert seen > 0


def test_angular_velocities_have_the_structure_constants_of_turns() -> None:
    """On body axes gamma^i_mj = -e_imj, the structure constants of so(3), and epsilon vanishes."""
    frame = euler_frame()
    g = frame.graph
    for i in range(3):
        for m in range(3):
            for j in range(3):
                sign = (i - m) * (m - j) * (j - i) // 2  # Levi-Civita
                assert is_zero(g, g.add(frame.gamma(i, m, j), g.number(sign)))
            assert is_zero(g, frame.epsilon(i, m))


@pytest.mark.parametrize("name", ["free_rigid_body", "affine_voronec", "ball_on_table"])
def test_gamma_is_antisymmetric(name: str) -> None:
    frame = generic_frame(system_of(name))
    g, n = frame.graph, frame.system.n
    for i in range(n):
        for m in range(n):
            for j in range(n):
                assert is_zero(g, g.add(frame.gamma(i, m, j), frame.gamma(i, j, m)))


def test_frame_and_coframe_are_inverse() -> None:
    frame = generic_frame(system_of("ball_on_table"))
    g, n = frame.graph, frame.system.n
    for i, form in enumerate(frame.forms):
        values = [g.sum([g.mul(a, x) for a, x in zip(form.coefficients, e, strict=True)]) for e in frame.vectors]
        assert are_equal(g, values, [g.one if j == i else g.zero for j in range(n)])
        drift = g.sum([g.mul(a, x) for a, x in zip(form.coefficients, frame.drift, strict=True)])
        assert is_zero(g, g.add(drift, form.constant))


def test_derivatives_along_quasi_coordinates_are_the_differential() -> None:
    """(I.2.5) and Remark 3: d phi = dphi/dpi_i dpi_i + dphi/dpi_(n+1) dt."""
    frame = generic_frame(system_of("affine_voronec"))
    g, n = frame.graph, frame.system.n
    coframe = full_coframe(frame)
    x, y, z = frame.system.q
    phi = g.mul(g.function("sin", g.mul(x, frame.system.t)), g.add(y, g.power(z, 2)))
    found = coframe.differential(phi)
    assert are_equal(g, [found.get(j, g.zero) for j in range(n)], [frame.along(phi, j) for j in range(n)])
    drift = dict(zip(frame.system.q, frame.drift, strict=True))  # d/dpi_(n+1) = d/dt + b_j(n+1) d/dq_j
    along_time = g.sum(
        [derivative(g, phi, frame.system.t), *(g.mul(b, derivative(g, phi, q)) for q, b in drift.items())]
    )
    assert is_zero(g, g.sub(found.get(2 * n, g.zero), along_time))
