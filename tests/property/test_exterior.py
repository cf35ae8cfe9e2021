"""Laws of the exterior calculus, exactly, in coordinate coframes and in general ones."""

from __future__ import annotations

import random
from itertools import combinations

import pytest

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import is_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.linear import solve
from nhc.exterior import (
    Coframe,
    Form,
    basis_form,
    coordinate_coframe,
    d,
    function_form,
    general_coframe,
    interior,
    one_form,
    pullback,
    wedge,
)

NAMES = ("x", "y", "z", "t")
SEEDS = range(4)


def function(g: Graph, rng: random.Random, variables: tuple[Node, ...]) -> Node:
    """A random function of the variables."""
    x, y = rng.choice(variables), rng.choice(variables)
    k = g.number(rng.randint(1, 4))
    choices = [
        g.function("sin", g.add(x, g.mul(k, y))),
        g.mul(g.power(x, 2), y),
        g.function("exp", g.mul(k, x)),
        g.add(k, g.mul(x, y)),
        g.inverse(g.add(k, g.power(x, 2))),
    ]
    return g.add(rng.choice(choices), g.mul(k, rng.choice(choices)))


def make_coframe(g: Graph, rng: random.Random, kind: str, names: tuple[str, ...] = NAMES) -> Coframe:
    variables = tuple(g.symbol(name) for name in names)
    size = len(variables)
    if kind == "coordinates":
        return coordinate_coframe(g, variables, [f"d{name}" for name in names])
    while True:
        rows = [[function(g, rng, variables) if rng.random() < 0.5 else g.zero for _ in names] for _ in names]
        rows = [[g.add(entry, g.one) if i == j else entry for j, entry in enumerate(row)] for i, row in enumerate(rows)]
        identity = [[g.one if i == j else g.zero for i in range(size)] for j in range(size)]
        try:
            dual = solve(g, rows, identity).unknowns
        except Singular:
            continue
        return general_coframe(g, variables, [f"u{k}" for k in range(size)], rows, dual)


def make_form(g: Graph, rng: random.Random, coframe: Coframe, degree: int) -> Form:
    indices = [index for index in combinations(range(len(coframe)), degree) if rng.random() < 0.8]
    return Form(coframe, degree, {index: function(g, rng, coframe.variables) for index in indices})


@pytest.fixture(params=[(kind, seed) for kind in ("coordinates", "general") for seed in SEEDS], ids=str)
def scene(request: pytest.FixtureRequest) -> tuple[Graph, random.Random, Coframe]:
    kind, seed = request.param
    g, rng = Graph(), random.Random(seed)
    return g, rng, make_coframe(g, rng, kind)


Scene = tuple[Graph, random.Random, Coframe]


def test_d_of_d_is_zero(scene: Scene) -> None:
    g, rng, coframe = scene
    for degree in (0, 1, 2):
        assert d(d(make_form(g, rng, coframe, degree))).is_zero()
    for k in range(len(coframe)):
        assert d(d(basis_form(coframe, k))).is_zero()


def test_leibniz(scene: Scene) -> None:
    g, rng, coframe = scene
    for p, q in ((0, 1), (1, 0), (1, 1), (1, 2), (2, 1), (2, 2)):
        u, w = make_form(g, rng, coframe, p), make_form(g, rng, coframe, q)
        right = wedge(d(u), w) + (-wedge(u, d(w)) if p % 2 else wedge(u, d(w)))
        assert (d(wedge(u, w)) - right).is_zero()


def test_wedge_is_graded_and_associative(scene: Scene) -> None:
    g, rng, coframe = scene
    for p, q in ((1, 1), (1, 2), (2, 2), (1, 3)):
        u, w = make_form(g, rng, coframe, p), make_form(g, rng, coframe, q)
        turned = wedge(w, u)
        assert (wedge(u, w) - (-turned if p * q % 2 else turned)).is_zero()
    u, v, w = (make_form(g, rng, coframe, degree) for degree in (1, 1, 2))
    assert (wedge(wedge(u, v), w) - wedge(u, wedge(v, w))).is_zero()
    assert wedge(u, u).is_zero()


def test_wedge_is_a_determinant(scene: Scene) -> None:
    """(II.1.2): (u ^ w)(X, Y) = u(X) w(Y) - w(X) u(Y)."""
    g, rng, coframe = scene
    u, w = make_form(g, rng, coframe, 1), make_form(g, rng, coframe, 1)
    X, Y = ([function(g, rng, coframe.variables) for _ in range(len(coframe))] for _ in range(2))
    on = {name: [interior(vector, form).coefficient() for vector in (X, Y)] for name, form in (("u", u), ("w", w))}
    determinant = g.sub(g.mul(on["u"][0], on["w"][1]), g.mul(on["w"][0], on["u"][1]))
    assert is_zero(g, g.sub(interior(Y, interior(X, wedge(u, w))).coefficient(), determinant))


def test_interior_product(scene: Scene) -> None:
    """i_X i_X = 0, and i_X is an antiderivation with the thesis's left derivative: i_X(u ^ w) = u(X) w - w(X) u."""
    g, rng, coframe = scene
    X = [function(g, rng, coframe.variables) for _ in range(len(coframe))]
    for p, q in ((1, 1), (1, 2), (2, 1), (2, 2)):
        u, w = make_form(g, rng, coframe, p), make_form(g, rng, coframe, q)
        second = wedge(u, interior(X, w))
        right = wedge(interior(X, u), w) + (-second if p % 2 else second)
        assert (interior(X, wedge(u, w)) - right).is_zero()
    assert interior(X, interior(X, make_form(g, rng, coframe, 3))).is_zero()


def test_cartan_on_functions(scene: Scene) -> None:
    """i_X df is the derivative along X, which does not depend on the coframe; L_X = d i_X + i_X d commutes with d."""
    g, rng, coframe = scene
    X = [function(g, rng, coframe.variables) for _ in range(len(coframe))]
    form = make_form(g, rng, coframe, 1)

    def lie(u: Form) -> Form:
        return d(interior(X, u)) + interior(X, d(u))

    assert (d(lie(form)) - lie(d(form))).is_zero()


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", ["coordinates", "general"])
def test_pullback_is_natural(kind: str, seed: int) -> None:
    """d and pullback along a map of three variables into four commute; so do wedge and pullback."""
    g, rng = Graph(), random.Random(seed)
    source = make_coframe(g, rng, "coordinates")
    target = make_coframe(g, rng, kind, ("p", "q", "r"))
    place = {symbol: function(g, rng, target.variables) for symbol in source.variables}
    images = [one_form(target, target.differential(value)) for value in place.values()]
    for degree in (0, 1, 2):
        form = make_form(g, rng, source, degree)
        left, right = (pullback(d(form), target, images, place), d(pullback(form, target, images, place)))
        assert (left - right).is_zero()
    u, w = make_form(g, rng, source, 1), make_form(g, rng, source, 1)
    parts = wedge(pullback(u, target, images, place), pullback(w, target, images, place))
    assert (pullback(wedge(u, w), target, images, place) - parts).is_zero()


@pytest.mark.parametrize("seed", SEEDS)
def test_general_coframe_is_the_coordinates_in_disguise(seed: int) -> None:
    """Reading a form in a general coframe by its rows commutes with d."""
    g, rng = Graph(), random.Random(seed)
    general = make_coframe(g, rng, "general")
    plain = coordinate_coframe(g, general.variables, NAMES)
    images = []
    for r in range(len(plain)):  # dx_r = x_r-component of each dual vector
        images.append(one_form(general, {k: vector[r] for k, vector in enumerate(general.dual)}))
    for degree in (0, 1, 2):
        form = make_form(g, rng, plain, degree)
        left = pullback(d(form), general, images, {})
        assert (left - d(pullback(form, general, images, {}))).is_zero()


def test_wrong_signs_are_noticed() -> None:
    """The laws above can fail: with one sign turned each of them does."""
    g, rng = Graph(), random.Random(1)
    coframe = make_coframe(g, rng, "general")
    u, w = make_form(g, rng, coframe, 1), make_form(g, rng, coframe, 1)
    assert not (d(wedge(u, w)) - wedge(d(u), w) - wedge(u, d(w))).is_zero()
    assert not (wedge(u, w) - wedge(w, u)).is_zero()
    assert not d(u).is_zero()
    assert function_form(coframe, g.zero).is_zero()
