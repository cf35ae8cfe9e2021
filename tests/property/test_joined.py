"""Addition theorems that were written out, joined again for paper: the values stay, and what was split comes back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import NEG, Graph, Node
from nhc.algebra.rewriting.angles import split_angles
from nhc.algebra.rewriting.joined import close_circles, join_sums
from nhc.algebra.rewriting.paper import shortest
from nhc.algebra.show import to_text
from nhc.algebra.walks import reachable
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve
from tests.property.expressions import QUIET

SPEC = "nhc: 1\nsystem: paper\ncoordinates: [a, b, c, v, w]\nparameters: [m, l, d, g]\nT: (a'^2 + b'^2 + c'^2 + v'^2 + w'^2)/2\n"


def read(text: str) -> tuple[Graph, Node]:
    system = resolve(decode(Source("paper.yaml", SPEC + f"outputs: {{x: {text}}}\n")))
    return system.graph, dict(system.outputs)["x"]


def count_written(graph: Graph, node: Node) -> int:
    """Operations of the expression written out, without signs."""
    children = graph.children(node)
    return (graph.op[node] != NEG and bool(children)) + sum(count_written(graph, kid) for kid in children)


@pytest.mark.parametrize(
    ("text", "joined"),
    [
        ("cos(a)*cos(b) + sin(a)*sin(b)", "cos(a - b)"),
        ("cos(a)*cos(b) - sin(a)*sin(b)", "cos(a + b)"),
        ("sin(a)*sin(b) - cos(a)*cos(b)", "-cos(a + b)"),
        ("sin(a)*cos(b) + cos(a)*sin(b)", "sin(a + b)"),
        ("cos(a)*sin(b) - sin(a)*cos(b)", "-sin(a - b)"),
        ("m*l*sin(a)*cos(b) + w*v^2 + m*l*cos(a)*sin(b)", "m*l*sin(a + b) + w*v^2"),
        ("2*cos(a)*cos(b) + sin(a)*sin(b)", ""),
        ("cos(a)*cos(b) + m*sin(a)*sin(b)", ""),
        ("cos(a)*cos(a) - sin(a)*sin(a)", ""),  # the angle that was given stays
        ("cos(a + b)*cos(b) + sin(a + b)*sin(b)", "cos(a)"),
        ("cos(a - b)*cos(b) - sin(a - b)*sin(b)", "cos(a)"),
        ("m/(sin(a)*cos(b) + cos(a)*sin(b))^2", "m/sin(a + b)^2"),
    ],
)
def test_two_terms_of_an_addition_theorem_are_joined(text: str, joined: str) -> None:
    g, node = read(text)
    (made,) = join_sums(g, [node])
    assert are_equal(g, [made], [node])
    assert (made == node) if not joined else (to_text(g, made) == joined)


@pytest.mark.parametrize(
    ("text", "closed"),
    [
        ("g*sin(a)^2*cos(b)^2 + g*cos(a)^2*cos(b)^2 + g*sin(b)^2", "g"),
        ("m*sin(a)^2/d + w + m*cos(a)^2/d", "m/d + w"),
        ("m*sin(a)^3*v + m*v*sin(a)*cos(a)^2", "m*v*sin(a)"),
        ("2*m*l*sin(a)^2*cos(b) + m*l*cos(a)^2*cos(b)", ""),
        ("m*sin(a)^2 + m*cos(b)^2", ""),
    ],
)
def test_circles_among_the_terms_are_closed(text: str, closed: str) -> None:
    g, node = read(text)
    made = close_circles(g, node)
    assert are_equal(g, [made], [node])
    assert (made == node) if not closed else (count_written(g, made) <= count_written(*read(closed)))


def test_a_sum_that_is_a_term_elsewhere() -> None:
    """It is joined where it is a factor, though a longer sum has it as a term."""
    g, node = read("m*(cos(a)*cos(b) + sin(a)*sin(b)) + w*(v + (cos(a)*cos(b) + sin(a)*sin(b)))")
    (made,) = join_sums(g, [node])
    assert to_text(g, made) == "m*cos(a - b) + w*(cos(a - b) + v)"
    assert are_equal(g, [made], [node])


def test_what_was_given_stays() -> None:
    g, kept = read("cos(a)*cos(b) + sin(a)*sin(b)")
    node = g.mul(kept, g.symbol("v"))
    assert join_sums(g, [node], {kept: kept}) == [node]


@QUIET
@given(
    st.lists(st.tuples(st.sampled_from("ab"), st.integers(-2, 2)), min_size=1, max_size=3),
    st.lists(st.sampled_from(("sin", "cos")), min_size=3, max_size=3),
)
def test_sums_of_three_come_back(more: list[tuple[str, int]], functions: list[str]) -> None:
    """Split by the addition theorems, then joined: equal, and no longer than what was split."""
    g = Graph()
    a, b, c, v = (g.symbol(name) for name in "abcv")
    extra = g.sum(g.mul_number(k, g.symbol(name)) for name, k in more)
    roots = [
        g.mul(v, g.function(functions[0], g.sum([a, b, c]))),
        g.add(g.function(functions[1], g.sub(a, b)), g.mul(v, g.function(functions[2], g.add(b, c)))),
        g.mul(extra, g.function(functions[2], g.sum([a, g.neg(b), g.neg(c)]))),
    ]
    split = split_angles(g, roots)
    joined = join_sums(g, split)
    assert are_equal(g, joined, roots)
    for old, new in zip(roots, joined, strict=True):
        angles = [node for node in reachable(g, [old]) if g.op[node] in ("sin", "cos")]
        assert len([node for node in reachable(g, [new]) if g.op[node] in ("sin", "cos")]) <= len(angles)


@pytest.mark.parametrize(
    ("text", "short"),
    [
        ("m*l^2/(2*(m*l^2)^2 - (m*l^2*cos(a - b))^2)", "1/((1 + sin(a - b)^2)*(m*l^2))"),  # a double pendulum's
        ("(m*(l*cos(a)*v + l*cos(b)*w)^2 + m*(l*sin(a)*v + l*sin(b)*w)^2)/2", "m*l^2*(v*(w*cos(a - b) + v/2) + w^2/2)"),
        ("m*((cos(c)*v)^2 + (sin(c)*v)^2) + (w - (d + g*cos(a))*v)^2", "(w - v*(d + g*cos(a)))^2 + m*v^2"),
    ],
)
def test_the_shortest(text: str, short: str) -> None:
    g, node = read(text)
    made = shortest(g, node, 60, lambda x: count_written(g, x))
    assert are_equal(g, [made], [node])
    assert to_text(g, made) == short
