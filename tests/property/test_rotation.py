"""The closed forms of a rotation against the definitions, exactly, for quaternions of any length."""

from __future__ import annotations

import pytest

from nhc.algebra.calculus import tangent
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.energies.kinetic import exterior_derivative
from nhc.mechanics.frame import make_frame
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.rotations import turning
from nhc.mechanics.rotations.rotation import Rotation
from nhc.mechanics.rotations.turns import cross
from nhc.mechanics.system import Form, System

SPEC = """
nhc: 1
system: s
coordinates: [x]
rotation: {{R: {{velocities: [w1, w2, w3], frame: {frame}}}}}
T: (x'^2 + w1^2 + 2*w2^2 + 3*w3^2)/2
"""


def made(frame: str) -> tuple[System, Rotation]:
    system = resolve(decode(Source("s.yaml", SPEC.format(frame=frame))))
    return system, system.rotations[0]


@pytest.fixture(params=["body", "space"])
def both(request: pytest.FixtureRequest) -> tuple[System, Rotation]:
    return made(request.param)


def vector(graph: Graph, name: str, size: int) -> list[Node]:
    return [graph.symbol(f"{name}{k}", "test") for k in range(size)]


def vanish(graph: Graph, nodes: list[Node]) -> bool:
    return all(are_zero(graph, nodes))


def test_the_matrix_is_a_rotation(both: tuple[System, Rotation]) -> None:
    g, R = both[0].graph, both[1].matrix
    for i in range(3):
        for j in range(3):
            product = g.sum([g.mul(R[i][k], R[j][k]) for k in range(3)])
            assert vanish(g, [g.sub(product, g.number(int(i == j)))])
    third = cross(g, [R[k][0] for k in range(3)], [R[k][1] for k in range(3)])
    assert vanish(g, [g.sub(third[k], R[k][2]) for k in range(3)])


def test_the_kinematics_are_the_inverse_of_the_angular_velocity(both: tuple[System, Rotation]) -> None:
    """omega(e'(n, w)) = w and (|e|^2)' = n by the nodes themselves, not by what is remembered."""
    (system, rotation), g = both, both[0].graph
    n, *w = vector(g, "w", 4)
    rates = rotation.velocities(g, (n, w[0], w[1], w[2]))
    on = dict(zip(rotation.v, rates, strict=True))
    values = substitute(g, [rotation.growth, *rotation.omega], on)
    assert vanish(g, [g.sub(a, b) for a, b in zip(values, (n, *w), strict=True)])
    assert system.quasi[0].value == rotation.omega[0]


def test_what_the_spec_says_is_what_is_computed_with(both: tuple[System, Rotation]) -> None:
    """The formulas that `--dump decode` prints have the values of the nodes that stand for them."""
    from nhc.language.rotation import entries_of, velocities_of
    from nhc.mechanics.resolving.resolve import Resolver

    system, rotation = both
    declared = system.spec.rotations[0]
    build = Resolver(system.spec, system.graph)
    nodes = [build.node(d.value) for d in (*velocities_of(declared), *entries_of(declared))]
    own = [*rotation.omega, *(x for row in rotation.matrix for x in row)]
    assert vanish(system.graph, [system.graph.sub(a, b) for a, b in zip(nodes, own, strict=True)])


def test_rates_of_the_matrix(both: tuple[System, Rotation]) -> None:
    """R' = R [omega], or [omega] R, against the chain rule."""
    (system, rotation), g = both, both[0].graph
    rates = vector(g, "r", 4)
    plain = dict(zip(rotation.e, rates, strict=True))
    closed = rotation.rates_of_matrix(g, rotation.turning(g, rates)[1:])
    for i in range(3):
        for j in range(3):
            assert vanish(g, [g.sub(closed[i][j], tangent(g, [rotation.matrix[i][j]], plain)[0])])
    assert turning.along(system, [g.zero, *rates])[rotation.e[2]] == rates[2]


@pytest.mark.parametrize("still", [(), (0,), (1, 2, 3, 4), (0, 1, 2, 3, 4)], ids=str)
def test_exterior_derivatives(both: tuple[System, Rotation], still: tuple[int, ...]) -> None:
    """d omega and that of a form with an entry of R in it, against the curl of the coefficients; with components that are zero."""
    (system, rotation), g = both, both[0].graph
    x, e = vector(g, "x", 6), [g.zero if k in still else node for k, node in enumerate(vector(g, "e", 5))]
    mixed = g.add(g.mul(rotation.matrix[0][2], rotation.omega[1]), g.mul(system.q[0], system.v[0]))
    for value in (*rotation.omega, mixed, rotation.growth):
        rows = [tangent(g, [value], {v: g.one})[0] for v in system.v]
        form = Form("f", tuple(rows), g.zero, value=value)
        on_x, on_e = turning.Direction(system, x[:5], x[5]), turning.Direction(system, e)
        closed = turning.derivative_by_turns(system, form, on_x, on_e)
        assert closed is not None
        moved = tangent(g, rows, dict(zip(system.q, x[:5], strict=True)))
        back = tangent(g, rows, dict(zip(system.q, e, strict=True)))
        curl = g.sub(
            g.sum([g.mul(a, b) for a, b in zip(moved, e, strict=True)]),
            g.sum([g.mul(a, b) for a, b in zip(back, x[:5], strict=True)]),
        )
        assert vanish(g, [g.sub(closed, curl), g.sub(exterior_derivative(system, form, on_x, on_e), curl)])


def test_gamma_is_that_of_the_rotation_group() -> None:
    for frame, sign in (("body", -1), ("space", 1)):
        system, _ = made(frame)
        g = system.graph
        free = [*system.quasi, Form("x", (g.one, *[g.zero] * 4), g.zero, value=system.v[0])]
        names = [g.symbol(form.name, "quasi") for form in system.quasi]
        found = make_frame(system, free, [*names, system.v[0]])
        assert [g.value(found.gamma(1, 2, 3)), g.value(found.gamma(2, 3, 1)), g.value(found.gamma(1, 3, 2))] == [
            sign,
            sign,
            -sign,
        ]
        assert g.value(found.gamma(1, 1, 2)) == 0 and not found.guards


def test_the_length_is_a_gauge(both: tuple[System, Rotation]) -> None:
    """Entries and angular velocity are the same for k e."""
    (_, rotation), g = both, both[0].graph
    k = g.symbol("k", "test")
    scaled = {x: g.mul(k, x) for x in (*rotation.e, *rotation.v)}
    nodes = [*rotation.omega, *(x for row in rotation.matrix for x in row)]
    assert vanish(g, [g.sub(a, b) for a, b in zip(nodes, substitute(g, nodes, scaled), strict=True)])
