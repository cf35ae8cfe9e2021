"""Forces along one direction are added before they are multiplied by it: the values stay, the work is that of one force."""

from __future__ import annotations

from itertools import product

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.along import add_along
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.mechanics.certificates.certificate import certify
from nhc.pipeline import Options, model, program


def directions(graph: Graph) -> tuple[list[Node], list[Node], Node]:
    """Components of a unit vector, sizes of two forces along it, a stiffness."""
    parts = [graph.symbol(name, "coordinate") for name in "xyz"]
    inverse = graph.inverse(graph.function("sqrt", graph.sum([graph.power(x, 2) for x in parts])))
    sizes = [graph.sub(graph.function("cos", parts[0]), parts[1]), graph.symbol("v", "velocity")]
    return [graph.mul(x, inverse) for x in parts], sizes, graph.symbol("k", "parameter")


@pytest.mark.parametrize(("sign", "other"), list(product((1, -1), (1, -1))))
def test_what_is_along_one_direction_is_added_in_front_of_it(sign: int, other: int) -> None:
    g = Graph()
    units, (pull, push), k = directions(g)
    beside = g.mul(g.symbol("w", "velocity"), g.function("sin", g.symbol("q", "coordinate")))
    slopes = [g.mul(k, g.add(g.mul_number(sign, g.mul(pull, d)), g.symbol("q", "coordinate"))) for d in units]
    forces = [g.add(g.mul_number(other, g.mul(push, d)), beside) for d in units]
    plain = [g.add(slope, force) for slope, force in zip(slopes, forces, strict=True)]
    made = [add_along(g, slope, force, g.mask([k])) for slope, force in zip(slopes, forces, strict=True)]
    joined = [node for node in made if node is not None]
    assert len(joined) == len(units)
    assert are_equal(g, joined, plain)
    assert count(g, joined) < count(g, plain)


def test_where_nothing_is_shared_no_node_is_made() -> None:
    g = Graph()
    units, (pull, push), k = directions(g)
    slope, force = g.neg(g.mul(k, g.mul(pull, units[0]))), g.mul(push, g.function("tanh", g.symbol("q", "coordinate")))
    before = len(g)
    assert add_along(g, slope, force, g.mask([k])) is None
    assert add_along(g, slope, g.zero, g.mask([k])) is None
    assert len(g) == before


def test_a_spring_with_its_damper_is_one_force() -> None:
    """Three points in a row on elastic ropes with friction: 31 operations for each."""
    names = [[f"{c}{k}" for c in "xyz"] for k in (1, 2, 3)]
    ropes = [
        " + ".join(f"({a} - {b})^2" if b != "0" else f"{a}^2" for a, b in zip(own, before, strict=True))
        for own, before in zip(names, [["0"] * 3, *names], strict=False)
    ]
    text = f"""nhc: 1
system: ropes
coordinates: [{", ".join(x for own in names for x in own)}]
parameters: {{m: 1, k: 100, l: 1, g: 9.81, c: 0.3}}
define:
  {"; ".join(f"r{j}: sqrt({rope})" for j, rope in enumerate(ropes)).replace("; ", chr(10) + "  ")}
T: m/2*({" + ".join(f"{x}'^2" for own in names for x in own)})
V: k/2*({" + ".join(f"(r{j} - l)^2" for j in range(3))}) + m*g*(z1 + z2 + z3)
forces: {{{", ".join(f"r{j}: -c*r{j}'" for j in range(3))}}}
"""
    source = Source("ropes.yaml", text)
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications + rhs.divisions <= 93
    assert all(agreement.accelerations for agreement in certify(model(source).system, points=1).agreements)
