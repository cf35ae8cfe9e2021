"""The exact identity test: identities of the language's functions are recognised, near misses are not."""

from __future__ import annotations

import pytest

from nhc.algebra.exact import modular
from nhc.algebra.exact.both_signs import vanish_for_both_signs
from nhc.algebra.exact.modular import are_zero, is_zero, rank
from nhc.algebra.exact.residues import FULL_TURN, PRIMES, part_of_turn, square_root, turn
from nhc.algebra.exact.signs import Signs, degree_in_signs
from nhc.algebra.graph import Graph, Node
from nhc.algebra.probe import signed_probes
from nhc.diagnostics import Bag, Source, Span
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Binary, Call, Name, Negate, Number, Syntax, fold_tree

IDENTITIES = [
    ("sin(x) + sin(x + 2*pi/3) + sin(x + 4*pi/3)", "0"),
    ("sin(x + pi/3)", "sin(x)/2 + sqrt(3)/2*cos(x)"),
    ("cos(pi/6)", "sqrt(3)/2"),
    ("sin(pi/4)*sqrt(2)", "1"),
    ("4*cos(pi/5)", "1 + sqrt(5)"),
    ("4*sin(2*pi/5)", "sqrt(10 + 2*sqrt(5))"),
    ("2*sin(pi/8)", "sqrt(2 - sqrt(2))"),
    ("4*sin(pi/12)", "sqrt(6) - sqrt(2)"),
    ("cos(2*pi/7) + cos(4*pi/7) + cos(6*pi/7)", "-1/2"),
    ("8*cos(pi/9)*cos(2*pi/9)*cos(4*pi/9)", "1"),
    ("sin(pi/10)*sin(3*pi/10)", "1/4"),
    ("tan(x + pi/4)", "(1 + tan(x))/(1 - tan(x))"),
    ("sqrt(x^2)", "abs(x)"),
    ("sqrt(cos(x)^2)", "abs(cos(x))"),
    ("abs(x)*abs(y)", "abs(x*y)"),
    ("sign(2*x)", "sign(x)"),
    ("acos(x)", "pi/2 - asin(x)"),
    ("acos(-x) + acos(x)", "pi"),
    ("abs(1 - sqrt(2))", "sqrt(2) - 1"),
    ("max(sqrt(2), sqrt(3))*x", "sqrt(3)*x"),
    ("sin(2*x)", "2*sin(x)*cos(x)"),
    ("cos(3*x)", "4*cos(x)^3 - 3*cos(x)"),
    ("sin(x + y)", "sin(x)*cos(y) + cos(x)*sin(y)"),
    ("cos(x - 2*y)", "cos(x)*cos(2*y) + sin(x)*sin(2*y)"),
    ("sin(x/2)^2", "(1 - cos(x))/2"),
    ("sin(x + pi/2)", "cos(x)"),
    ("tan(x + y)", "(tan(x) + tan(y))/(1 - tan(x)*tan(y))"),
    ("tan(x)^2 + 1", "1/cos(x)^2"),
    ("sin(x*y + x*z)", "sin(x*(y + z))"),
    ("exp(cos(x - y))", "exp(cos(x)*cos(y) + sin(x)*sin(y))"),
    ("exp(-cos(x + y)^2)", "exp(sin(x + y)^2 - 1)"),
    ("sin(z*cos(2*x))", "sin(z - 2*z*sin(x)^2)"),
    ("exp(sin(x - 3*y))", "exp(sin(x)*cos(3*y) - cos(x)*sin(3*y))"),
    ("sin(x + sin(cos(y + z)))", "sin(x + sin(cos(y)*cos(z) - sin(y)*sin(z)))"),
    ("exp(x + y)", "exp(x)*exp(y)"),
    ("exp(-x)*exp(x)", "1"),
    ("exp(x/2)^2", "exp(x)"),
    ("cosh(x)^2 - sinh(x)^2", "1"),
    ("sinh(2*x)", "2*sinh(x)*cosh(x)"),
    ("tanh(x)", "(exp(2*x) - 1)/(exp(2*x) + 1)"),
    ("tanh(x + y)", "(tanh(x) + tanh(y))/(1 + tanh(x)*tanh(y))"),
    ("sqrt(x)^2", "x"),
    ("1/sqrt(x)", "sqrt(x)/x"),
    ("sqrt(4*x)", "2*sqrt(x)"),
    ("sqrt(2*x)", "sqrt(2)*sqrt(x)"),
    ("sqrt(3)/3*x", "x/sqrt(3)"),
    ("sqrt(8/27)", "2*sqrt(6)/9"),
    ("x^(1/3)*x^(2/3)", "x"),
    ("x^(3/2)", "x*sqrt(x)"),
    ("x^(2/5)*x^(1/10)", "sqrt(x)"),
    ("(x^2 - y^2)/(x - y)", "x + y"),
    ("atan(x + y) + atan(-x - y)", "0"),
    ("cos(atan(x))^2*(1 + x^2)", "1"),
    ("sin(2*atan(x))*(1 + x^2)", "2*x"),
    ("tan(atan(x) + atan(y))", "(x + y)/(1 - x*y)"),
    ("sin(asin(x)) + cos(acos(x))", "2*x"),
    ("sin(acos(x))", "sqrt(1 - x^2)"),
    ("cos(z + atan2(y, x))*sqrt(x^2 + y^2)", "x*cos(z) - y*sin(z)"),
    ("2*cos(atan(x)/2)^2", "1 + cos(atan(x))"),
    ("exp(2*log(x) + y)", "x^2*exp(y)"),
    ("abs(-x*y)", "abs(x*y)"),
    ("abs(x)^2", "x^2"),
    ("x*sign(x)", "abs(x)"),
    ("max(x, y) + min(x, y)", "x + y"),
]
NEAR_MISSES = [
    ("exp(cos(x - y))", "exp(cos(x)*cos(y) - sin(x)*sin(y))"),
    ("sin(2*x)", "2*sin(x)"),
    ("sin(x + y)", "sin(x)*cos(y) - cos(x)*sin(y)"),
    ("sin(x)^2 + cos(y)^2", "1"),
    ("cos(x + pi/2)", "sin(x)"),
    ("sin(x + pi)", "sin(x)"),
    ("sin(x) + sin(x + pi/3)", "0"),
    ("cos(pi/3)", "sqrt(3)/2"),
    ("cos(pi/5)", "sqrt(5)/2"),
    ("sin(pi/7)", "sin(2*pi/7)"),
    ("abs(x^2 - 1)", "x^2 - 1"),
    ("acos(x)", "pi/2 + asin(x)"),
    ("abs(1 - sqrt(2))", "1 - sqrt(2)"),
    ("exp(x + y)", "exp(x) + exp(y)"),
    ("exp(2*x)", "exp(x)"),
    ("cosh(x)^2 + sinh(x)^2", "1"),
    ("tanh(2*x)", "2*tanh(x)"),
    ("cos(atan(x))*(1 + x^2)", "1"),
    ("sin(asin(x)/2)", "x/2"),
    ("sin(atan2(x, y))*sqrt(x^2 + y^2)", "y"),
    ("exp(2*log(x))", "2*x"),
    ("sqrt(4*x)", "-2*sqrt(x)"),
    ("sqrt(2)*x", "x"),
    ("sqrt(x^2)", "x"),
    ("sqrt(x^2 + 2*x*y + y^2)", "x + y"),
    ("sqrt(9*x^2)", "3*x"),
    ("(x^4)^(1/4)", "x"),
    ("sqrt(x + y)", "sqrt(x) + sqrt(y)"),
    ("x^(1/3)", "x^(1/2)"),
    ("x^(1/3)*x^(1/3)", "x"),
    ("tan(x)^2", "1/cos(x)^2 + 1"),
    ("atan(x)", "x"),
    ("abs(x)", "x"),
    ("max(x, y)", "x"),
    ("sign(x)*sign(y)", "1"),
    ("abs(x + y)", "abs(x) + abs(y)"),
    ("min(x, y)", "max(x, y)"),
    ("log(x)", "exp(x)"),
    ("x + 1/1000000000000", "x"),
    ("pi", "22/7"),
]


def node_of(g: Graph, text: str) -> Node:
    tree = parse_expression(text, Span, Bag(Source("test", text)))
    assert tree is not None
    return fold_tree(tree, lambda part, operands: _visit(g, part, operands))


def _visit(g: Graph, part: Syntax, operands: tuple[Node, ...]) -> Node:
    match part:
        case Number():
            return g.number(part.value)
        case Name():
            return g.pi() if part.name == "pi" else g.symbol(part.name)
        case Negate():
            return g.neg(operands[0])
        case Call():
            return g.function(part.function, *operands)
        case Binary():
            known = {"+": g.add, "-": g.sub, "*": g.mul, "/": g.div}
            if part.op in known:
                return known[part.op](*operands)
            return g.function("powf", *operands)
        case _:
            raise AssertionError(part)


@pytest.mark.parametrize(("left", "right"), IDENTITIES)
def test_identity_is_recognised(left: str, right: str) -> None:
    g = Graph()
    assert is_zero(g, g.sub(node_of(g, left), node_of(g, right)))


@pytest.mark.parametrize(("left", "right"), NEAR_MISSES)
def test_near_miss_is_rejected(left: str, right: str) -> None:
    g = Graph()
    assert not is_zero(g, g.sub(node_of(g, left), node_of(g, right)))


def test_primes_are_what_the_field_needs() -> None:
    """Safe primes (Fermat's test to a few bases), 3 modulo 4, with roots of the small numbers."""
    assert len(set(PRIMES)) == len(PRIMES) >= 4
    for p in PRIMES:
        assert 2**60 < p < 2**61
        assert p % FULL_TURN == FULL_TURN - 1
        for q in (p, (p - 1) // 2):
            assert all(pow(base, q - 1, q) == 1 for base in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37))
        assert all(pow(k, (p - 1) // 2, p) == 1 for k in range(1, 53))


@pytest.mark.parametrize("p", PRIMES)
def test_parts_of_a_turn(p: int) -> None:
    """They add up, a quarter is (0, 1), and sines that are positive radicals of 2, 3 and 5 are squares as these are."""
    assert part_of_turn(FULL_TURN // 4, p) == (0, 1)
    one = part_of_turn(1, p)
    assert all(part_of_turn(k, p) == turn(*one, k, p) for k in (*range(-40, 40), 719, 1260, 5039))
    assert len({part_of_turn(k, p) for k in range(FULL_TURN)}) == FULL_TURN
    for parts in (8, 10, 12):
        assert all(square_root(part_of_turn(FULL_TURN // 2 // parts * k, p)[1], p) for k in range(1, parts))


@pytest.mark.parametrize("size", [2, 53, 127, 251, 127 * 251])
def test_positive_factors_leave_signs_alone(size: int) -> None:
    """127 is a square modulo none of the primes."""
    pairs = (
        ("abs({q}*x)", "{q}*abs(x)"),
        ("sign({q}*x + {q}*2*y)", "sign(x + 2*y)"),
        ("max({q}*x, {q}*y)", "{q}*max(x, y)"),
    )
    g = Graph()
    for left, right in pairs:
        one, other = (node_of(g, text.format(q=size)) for text in (left, right))
        assert is_zero(g, g.sub(one, other)) and not is_zero(g, g.add(one, other))
    assert not is_zero(g, g.add(node_of(g, f"max({size}*x, {size}*y)"), node_of(g, f"-{size}*min(x, y)")))


@pytest.mark.parametrize("seed", range(8))
def test_the_root_of_a_square_is_not_its_base(seed: int) -> None:
    """At every second point of the field it is: a few points do not tell."""
    g = Graph()
    assert not any(are_zero(g, [node_of(g, "sqrt(x^2) - x"), node_of(g, "sqrt(x^2) + x")], seed=seed))


@pytest.mark.parametrize("seed", range(6))
def test_rank_with_signs(seed: int) -> None:
    g = Graph()
    rows = [[node_of(g, "abs(x)"), node_of(g, "x")], [g.one, g.one]]
    assert rank(g, rows, seed) == 2
    assert rank(g, [[node_of(g, "abs(x)"), node_of(g, "x")], [node_of(g, "x"), node_of(g, "abs(x)")]], seed) == 1


NAMES = ("x y z", "q a b", "s h l", "xi lx ly", "theta n1 n2", "u d c", "r e1 e2", "phi cx cy")
HIDDEN = [
    "sqrt(x^2*y) - x*sqrt(y)",
    "sqrt((y*x)^2 + (z*x)^2) - x*sqrt(y^2 + z^2)",
    "cos(atan2(x*y, x*z)) - cos(atan2(y, z))",
    "sin(acos(cos(y))) - sin(y)",
    "cos(asin(sin(y))) - cos(y)",
    "(x^4*y)^(1/4) - x*y^(1/4)",
    "sqrt(x*y)*sqrt(x*z)*sqrt(y*z) - x*y*z",
]


@pytest.mark.parametrize("text", HIDDEN)
def test_roots_hide_signs(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Under all names and at all seeds, whether or not floats at points of both signs are looked at first."""
    for probes in (modular.signed_probes, lambda graph: []):
        monkeypatch.setattr(modular, "signed_probes", probes)
        for names in NAMES:
            g = Graph()
            node = node_of(g, text.translate(str.maketrans(dict(zip("xyz", names.split(), strict=True)))))
            assert not any(are_zero(g, [node], seed=seed)[0] for seed in range(3)), names


def test_independent_roots_hide_none() -> None:
    """Springs in space and roots in roots cost no further points."""
    for text in (
        "sqrt(x^2 + y^2) + sqrt(x^2 + z^2) - sqrt(y^2 + z^2)",
        "sqrt(sqrt(x^2 + y^2) + z)",
        "cos(2*atan2(x, y) + z)",
    ):
        g = Graph()
        assert degree_in_signs(g, [node_of(g, text)]) == 0
    g = Graph()
    assert degree_in_signs(g, [node_of(g, "abs(x)*sign(x) + max(x, y)*sqrt(z^2)")]) == 2
    assert degree_in_signs(g, [node_of(g, "sign(x) + sign(y) + sign(z)")]) == 1
    assert degree_in_signs(g, [node_of(g, "1/(4 + sign(x) + sign(y) + sign(z))")]) == 3


@pytest.mark.parametrize("seed", range(3))
def test_products_of_signs(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """One place of 64 is inside a box; what has too many faces is kept, zero or not."""
    monkeypatch.setattr(modular, "signed_probes", lambda graph: [])
    g = Graph()
    box = node_of(g, "*".join(f"(1 + sign({name}))" for name in "abcdef"))
    outside = g.sub(box, g.mul(box, node_of(g, "sign(a)")))
    assert are_zero(g, [box, outside], seed=seed) == [False, True]
    larger = g.mul(box, node_of(g, "(1 + sign(k))*(1 - sign(a))"))
    assert are_zero(g, [larger], seed=seed) == [False]


def test_rank_with_products_of_signs() -> None:
    g = Graph()
    box = node_of(g, "*".join(f"(1 + sign({name}))" for name in "abcde"))
    assert rank(g, [[box, g.zero], [g.one, g.one]]) == 2


def test_points_of_both_signs() -> None:
    """Names of one length do not change their signs together."""
    g = Graph()
    products = [g.mul(g.symbol(x), g.symbol(y)) for x, y in ("xy", "ab", "qr")]
    for product in products:
        assert len({probe.value(product) > 0 for probe in signed_probes(g)}) == 2


BOTH = [
    "(abs(x) + y)^2 - x^2 - 2*y*abs(x) - y^2",
    "(max(x, y) + min(x, y) - x)*z - y*z",
    "max(x, y)*min(x, y) - x*y",
    "(sign(x) + sign(y))^2 - 2 - 2*sign(x)*sign(y)",
    "sin(abs(x) + y) - sin(abs(x))*cos(y) - cos(abs(x))*sin(y)",
    "(1 + sqrt(x^2*y)*z)*(1 - sqrt(x^2*y)*z) + x^2*y*z^2 - 1 + 0*sqrt(y)",
    "1/(2 + abs(x)) + 1/(2 - abs(x)) - 4/(4 - x^2)",
]
MORE = [
    "abs(x)*abs(y) - abs(x*y)",
    "sqrt(x^2) - abs(x)",
    "sign(x*y)*abs(x) - x*sign(y)",
    "abs(abs(x) + y)^2 - (abs(x) + y)^2",
]


@pytest.mark.parametrize("text", BOTH)
def test_what_vanishes_for_both_signs_needs_no_further_points(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(degree: int, done: int) -> int:
        raise AssertionError(f"more than {done} points are asked for")

    monkeypatch.setattr(modular, "points_for", refuse)
    for seed in range(4):
        g = Graph()
        assert is_zero(g, node_of(g, text)) and are_zero(g, [node_of(g, text)], seed=seed) == [True]


@pytest.mark.parametrize("text", MORE)
def test_what_vanishes_only_as_signs_belong_together_is_seen_at_many_points(text: str) -> None:
    for seed in range(4):
        g = Graph()
        assert are_zero(g, [node_of(g, text)], seed=seed) == [True]


@pytest.mark.parametrize(
    "text", ["z*(abs(x) - x)", "max(x, y) - x", "(sign(x) - 1)*(sign(y) - 1)*(sign(z) - 1)", *HIDDEN]
)
def test_what_vanishes_at_a_point_for_its_signs_alone_is_no_zero(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Here the many points would say that all is zero."""
    monkeypatch.setattr(modular, "signed_probes", lambda graph: [])
    monkeypatch.setattr(modular, "points_for", lambda degree, done: done)
    found = list[bool]()
    for seed in range(40):
        g = Graph()
        node = node_of(g, text)
        points = [point for point, _ in modular._sampled(g, [node], 1, seed, modular.QuickPoint)]
        if points[0].values[node] == 0:
            found.append(node in vanish_for_both_signs(Signs(g, [node]), [node], points))
    assert found and not any(found)
