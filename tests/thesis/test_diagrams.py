"""The two diagrams of ch. III: the one of III.1 commutes, the one of III.3 does not, and by exactly the constraints' own terms."""

from __future__ import annotations

import pytest

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.exterior import Form, basis_form, coordinate_coframe, d, interior, one_form, pullback, wedge
from nhc.mechanics.certificates import wrong
from nhc.mechanics.formulations import euler_lagrange, lagrange, voronec
from nhc.mechanics.frame import Frame
from tests.thesis.scenery import any_states, error_of, generic_frame, rates_of, reduced_of, system_of

UNCONSTRAINED = ["free_rigid_body", "bead_on_rod", "pumped_pendulum", "double_pendulum", "spherical_pendulum"]


def test_monomial() -> None:
    """The associated system of u1 ^ u2 is u1 = u2 = 0, and a regular change of the u multiplies the form by its determinant."""
    g = Graph()
    coframe = coordinate_coframe(g, [g.symbol("x"), g.symbol("y")], ["u1", "u2"])
    rows = [[g.symbol(f"b{i}{j}") for j in range(2)] for i in range(2)]
    form = wedge(basis_form(coframe, 0), basis_form(coframe, 1))
    assert (interior([g.one, g.zero], form) - basis_form(coframe, 1)).is_zero()
    assert (interior([g.zero, g.one], form) + basis_form(coframe, 0)).is_zero()
    moved = pullback(form, coframe, [one_form(coframe, dict(enumerate(row))) for row in rows], {})
    determinant = g.sub(g.mul(rows[0][0], rows[1][1]), g.mul(rows[0][1], rows[1][0]))
    assert (moved - form.scaled(determinant)).is_zero()


def quasi_images(frame: Frame) -> tuple[list[Form], dict[Node, Node]]:
    """dq_i, dq'_i, dt in the coframe (dpi, domega, dt), and q' as functions of omega."""
    system, g, n = frame.system, frame.graph, frame.system.n
    target = euler_lagrange.full_coframe(frame)
    images = []
    for i in range(n):
        images.append(one_form(target, {**{j: frame.vectors[j][i] for j in range(n)}, 2 * n: frame.drift[i]}))
    images += [one_form(target, target.differential(velocity)) for velocity in frame.all_kinematics]
    images.append(one_form(target, {2 * n: g.one}))
    return images, dict(zip(system.v, frame.all_kinematics, strict=True))


@pytest.mark.parametrize("name", UNCONSTRAINED)
def test_transform_and_associate_commute(name: str) -> None:
    """III.1 with generic quasi-velocities: Omega in them is Lagrange's pulled back, and so is each associated equation."""
    system = system_of(name)
    frame = generic_frame(system)
    g, target = frame.graph, euler_lagrange.full_coframe(frame)
    images, functions = quasi_images(frame)
    before, after = lagrange.omega(system), euler_lagrange.unconstrained_omega(frame)
    assert (pullback(before, target, images, functions) - after).is_zero()
    size = len(target)
    for k in range(size):  # i_(dual vector k) of the transformed form = the same combination of transformed equations
        unit = [g.one if j == k else g.zero for j in range(size)]
        combined = Form(target, 1, {})
        for j, image in enumerate(images):
            weight = image.coefficient(k)
            row = interior([g.one if m == j else g.zero for m in range(size)], before)
            combined = combined + pullback(row, target, images, functions).scaled(weight)
        assert (interior(unit, after) - combined).is_zero(), k


def constrained_images(reduced: voronec.Reduced) -> tuple[list[Form], dict[Node, Node]]:
    """dq, dq', dt on the constraints: dq_alpha = b_alphamu dq_mu + b_alpha dt."""
    system, g, frame, m = reduced.system, reduced.graph, reduced.frame, len(reduced.mu)
    target = voronec.reduced_coframe(reduced)
    images = []
    for i in range(system.n):
        images.append(one_form(target, {**{k: e[i] for k, e in enumerate(frame.free_vectors)}, 2 * m: frame.drift[i]}))
    images += [one_form(target, target.differential(velocity)) for velocity in frame.kinematics]
    images.append(one_form(target, {2 * m: g.one}))
    return images, dict(zip(system.v, frame.kinematics, strict=True))


CONSTRAINED = ["chaplygin_sleigh", "nh_particle", "rolling_disk", "voronec_particle", "affine_voronec", "ball_on_table"]


@pytest.mark.parametrize("name", CONSTRAINED)
def test_substitute_and_differentiate_do_not_commute(name: str) -> None:
    """III.3: d and then the constraints, minus the constraints and then d, is -p_alpha (db_alphamu ^ dq_mu + db_alpha ^ dt)."""
    reduced = reduced_of(system_of(name))
    target = voronec.reduced_coframe(reduced)
    images, functions = constrained_images(reduced)
    theta = lagrange.kinetic_one_form(reduced.system)
    right = pullback(d(theta), target, images, functions)
    left = d(pullback(theta, target, images, functions))
    expected = Form(target, 2, {})
    dt = basis_form(target, 2 * len(reduced.mu))
    for a, p in enumerate(reduced.p_alpha):
        turn = wedge(one_form(target, target.differential(reduced.b_0[a])), dt)
        for k, b in enumerate(reduced.b[a]):
            turn = turn + wedge(one_form(target, target.differential(b)), basis_form(target, k))
        expected = expected - turn.scaled(p)
    assert (right - left - expected).is_zero()
    assert not expected.is_zero()


def test_the_wrong_path_gives_lagrange_of_T_star() -> None:
    """theta on the constraints is dT*/dq'_mu dq_mu - (dT*/dq'_mu q'_mu - T*) dt, whatever the constraints are."""
    for name in CONSTRAINED:
        reduced = reduced_of(system_of(name))
        g, m = reduced.graph, len(reduced.mu)
        images, functions = constrained_images(reduced)
        theta = lagrange.kinetic_one_form(reduced.system)
        found = pullback(theta, voronec.reduced_coframe(reduced), images, functions)
        momenta = gradient(g, reduced.T_star, reduced.v_mu)
        power = g.sum([g.mul(p, v) for p, v in zip(momenta, reduced.v_mu, strict=True)])
        expected = [*momenta, g.sub(reduced.T_star, power)]
        assert are_equal(g, [found.coefficient(k) for k in (*range(m), 2 * m)], expected)


def test_how_far_the_wrong_path_leads() -> None:
    """On the sleigh the two paths differ by far more than the motion itself; on the vertical disk by nothing."""
    for name, dependent, low, high in (("chaplygin_sleigh", "x", 1.0, 1e9), ("vertical_disk", "x y", 0.0, 1e-12)):
        reduced = reduced_of(system_of(name), dependent.split())
        rates = rates_of(reduced.graph, len(reduced.mu))
        rows = wrong.lagrange_of_T_star(reduced, rates)
        assert low <= error_of(reduced.frame, rows, rates, any_states(reduced.frame)) < high


@pytest.mark.parametrize("name", CONSTRAINED)
def test_right_path_is_the_master_form(name: str) -> None:
    """Lagrange's Omega with the constraints put in afterwards is the form that nhc associates (III.4)."""
    reduced = reduced_of(system_of(name))
    images, functions = constrained_images(reduced)
    found = pullback(lagrange.omega(reduced.system), voronec.reduced_coframe(reduced), images, functions)
    assert (found - voronec.omega(reduced)).is_zero()
