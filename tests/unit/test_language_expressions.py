"""Expressions: grammar, places, depth, and the way back to text."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from nhc.diagnostics import Bag, Source, Span
from nhc.language import Binary, Call, Name, Negate, Number, Prime, Syntax, same, walk
from nhc.language.expressions.constant import ConstantError, evaluate
from nhc.language.expressions.names import FUNCTIONS, GREEK, fold, is_name
from nhc.language.expressions.parser import parse_equation, parse_expression
from nhc.language.expressions.unparse import unparse

HERE = Span(0, 0)


def parse(text: str) -> Syntax:
    bag = Bag(Source("a", text))
    tree = parse_expression(text, Span, bag)
    assert tree is not None, bag.diagnostics
    return tree


def refuse(text: str) -> tuple[str, int, int]:
    bag = Bag(Source("a", text))
    assert parse_expression(text, Span, bag) is None
    (found,) = bag.diagnostics
    return found.code, found.span.start, found.span.end


def show(tree: Syntax) -> str:
    """Every operation in parentheses."""
    match tree:
        case Number():
            return str(tree.value)
        case Name():
            return tree.name
        case Prime():
            return f"D({show(tree.operand)})"
        case Negate():
            return f"(-{show(tree.operand)})"
        case Binary():
            return f"({show(tree.left)}{tree.op}{show(tree.right)})"
        case Call():
            return f"{tree.function}({','.join(map(show, tree.arguments))})"
        case _:
            raise AssertionError(tree)


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        ("a+b*c", "(a+(b*c))"),
        ("a-b-c", "((a-b)-c)"),
        ("a/b/c*d", "(((a/b)/c)*d)"),
        ("-x^2", "(-(x^2))"),
        ("(-x)^2", "((-x)^2)"),
        ("2^-1", "(2^(-1))"),
        ("2^-x^2", "(2^(-(x^2)))"),
        ("2^-x*y", "((2^(-x))*y)"),
        ("a^b^c", "(a^(b^c))"),
        ("a**b", "(a^b)"),
        ("-a*b", "((-a)*b)"),
        ("a - -b", "(a-(-b))"),
        ("a*-b", "(a*(-b))"),
        ("--a", "(-(-a))"),
        ("x'^2", "(D(x)^2)"),
        ("x\u2032", "D(x)"),
        ("(x + y)'*z", "(D((x+y))*z)"),
        ("dot(x)", "D(x)"),
        ("sin(x)'", "D(sin(x))"),
        ("atan2(y, x + 1)", "atan2(y,(x+1))"),
        ("\u03b8 + \u03b81 + \u0394\u03c9", "((theta+theta1)+Deltaomega)"),
        ("\u03c0", "pi"),
        ("lambda*I*E*class", "(((lambda*I)*E)*class)"),
        (".5 + 1e-3 + 010 + 1.", "(((1/2+1/1000)+10)+1)"),
    ],
)
def test_operators_bind_as_in_mathematics(text: str, meaning: str) -> None:
    assert show(parse(text)) == meaning


def test_numbers_are_exact() -> None:
    tree = parse("0.1")
    assert isinstance(tree, Number)
    assert tree.value == Fraction(1, 10)
    tree = parse("1.7976931348623157e307")
    assert isinstance(tree, Number)
    assert tree.value == 17976931348623157 * 10**291


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2x", ("E0203", 0, 2)),
        ("2 x", ("E0203", 2, 3)),
        ("x'y", ("E0203", 0, 3)),
        ("(a)(b)", ("E0203", 0, 4)),
        ("a(b)", ("E0206", 0, 1)),
        ("x''", ("E0207", 0, 3)),
        ("a + ", ("E0202", 3, 4)),
        ("", ("E0202", 0, 0)),
        ("'", ("E0202", 0, 1)),
        ("a = b", ("E0208", 2, 3)),
        ("a; b", ("E0201", 1, 2)),
        ("x\u00b2", ("E0201", 1, 2)),
        ("1.2.3", ("E0210", 0, 5)),
        ("1_000", ("E0210", 0, 5)),
        ("1e999999999", ("E0210", 0, 11)),
        ("1" * 5000, ("E0210", 0, 5000)),
        ("(a", ("E0204", 0, 1)),
        ("a)", ("E0204", 1, 2)),
        ("min(a)", ("E0206", 0, 6)),
        ("sin()", ("E0206", 4, 5)),
        ("(a, b)", ("E0202", 2, 3)),
        ("(" * 201 + "x" + ")" * 201, ("E0205", 200, 201)),
        ("2^" * 201 + "x", ("E0205", 401, 402)),
        ("x+" * 50_001 + "x", ("E0205", 0, 1)),
    ],
    ids=lambda value: value[:12] if isinstance(value, str) else value[0],
)
def test_a_bad_expression_gets_its_code_and_place(text: str, expected: tuple[str, int, int]) -> None:
    assert refuse(text) == expected


def test_depth_200_is_allowed() -> None:
    assert show(parse("(" * 200 + "x" + ")" * 200)) == "x"


@pytest.mark.parametrize("sign", "+-*/")
def test_long_sums_need_no_stack(sign: str) -> None:
    text = sign.join(["x"] * 20_000)
    tree = parse(text)
    assert sum(1 for _ in walk(tree)) == 39_999
    assert unparse(tree).replace(" ", "") == text
    assert same(tree, parse(text))
    assert not same(tree, parse(text + "+1"))
    assert "Binary" in repr(tree)


def test_an_equation_has_one_equals_sign_at_the_top() -> None:
    bag = Bag(Source("a", ""))
    sides = parse_equation("x' + 1 = 0", Span, bag)
    assert sides is not None
    assert [show(side) for side in sides] == ["(D(x)+1)", "0"]
    for text in ("x'", "x = y = 0", "(x = 0)"):
        assert parse_equation(text, Span, bag) is None
    assert [found.code for found in bag.diagnostics] == ["E0208"] * 3


def test_spans_cover_their_text() -> None:
    text = "a*(x + sin(y))' - -b^2"
    tree = parse(text)
    shown = [text[node.span.start : node.span.end] for node in walk(tree)]
    assert shown == [
        *(text, "a*(x + sin(y))'", "a", "(x + sin(y))'", "x + sin(y)", "x", "sin(y)", "y", "-b^2", "b^2", "b", "2")
    ]


def test_all_greek_letters_have_names() -> None:
    assert len(GREEK) == 25 + 24
    assert fold("\u03c2\u03c3\u03a3") == "sigmasigmaSigma"
    assert fold("\u00b5") == "mu"  # the micro sign
    assert fold("\u03d1") == "theta"  # the other theta
    assert all(is_name(letter) for letter in GREEK)
    assert not any(is_name(text) for text in ("", "1a", "a b", "a'", "x\u00b2", "a-b"))
    assert is_name("\u043c\u0430\u0441\u0441\u0430")


names = st.sampled_from(["x", "theta", "m1", "T", "lambda", "pi", "t", "xdot", "dx"])
values = st.one_of(
    st.integers(0, 10**30).map(Fraction),
    st.tuples(st.integers(0, 10**25), st.integers(-40, 40)).map(lambda pair: pair[0] * Fraction(10) ** pair[1]),
)
leaves = st.one_of(names.map(lambda name: Name(name, HERE)), values.map(lambda value: Number(value, HERE)))


def grow(inner: st.SearchStrategy[Syntax]) -> st.SearchStrategy[Syntax]:
    unary = st.sampled_from(sorted(name for name, arity in FUNCTIONS.items() if arity == (1, 1)))
    binary = st.sampled_from(sorted(name for name, arity in FUNCTIONS.items() if arity == (2, 2)))
    return st.one_of(
        inner.map(lambda tree: Negate(tree, HERE)),
        inner.filter(lambda tree: not isinstance(tree, Prime | Number)).map(lambda tree: Prime(tree, HERE)),
        st.builds(lambda op, a, b: Binary(op, a, b, HERE, HERE), st.sampled_from("+-*/^"), inner, inner),
        st.builds(lambda f, a: Call(f, (a,), HERE), unary, inner),
        st.builds(lambda f, a, b: Call(f, (a, b), HERE), binary, inner, inner),
    )


@given(st.recursive(leaves, grow, max_leaves=25))
def test_text_and_back(tree: Syntax) -> None:
    assert same(parse(unparse(tree)), tree)


@given(st.text(alphabet=st.sampled_from("xy1.0e+-*/^()',= \u03b8sin\u00b2min\n"), max_size=60))
@settings(max_examples=300)
def test_random_expressions_never_crash(text: str) -> None:
    bag = Bag(Source("a", text))
    tree = parse_expression(text, Span, bag)
    assert (tree is None) == bag.has_errors
    if tree is not None:
        assert same(parse(unparse(tree)), tree)


@given(st.text(max_size=40))
def test_random_text_never_crashes(text: str) -> None:
    bag = Bag(Source("a", text))
    assert (parse_expression(text, Span, bag) is None) == bag.has_errors


CONSTANTS = {
    **{f"{name}(0.4)": None for name in FUNCTIONS if FUNCTIONS[name][1] == 1},
    **{f"{name}(-0.4)": None for name in ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "abs")},
    **{"sign(-0.4)": -1.0, "sign(0)": 0.0, "sign(3)": 1.0, "min(2, -3)": -3.0, "max(2, -3)": 2.0, "2^-2": 0.25},
    **{"atan2(1, -1)": 3 * math.pi / 4, "atan2(-2, 0)": -math.pi / 2, "sin(pi)": 0.0, "cos(-3*pi/2)": 0.0},
    **{"tan(2*pi)": 0.0, "sin(pi/6)": 0.5, "cos(pi)": -1.0, "1/4 - 3*(2 - 1/3)": -4.75, "-pi^2": -(math.pi**2)},
    **{"sin(3.141592653589793)": math.sin(math.pi), "sin(pi + 1e-9)": math.sin(math.pi + 1e-9)},  # no multiple of pi
}


@pytest.mark.parametrize(("text", "wanted"), CONSTANTS.items())
def test_values_of_constants(text: str, wanted: float | None) -> None:
    """Those that are not given are those of the C library; turns of pi are taken for what they mean."""
    if wanted is None:
        name, _, argument = text.rstrip(")").partition("(")
        own = {"abs": abs, "sign": lambda x: 1.0}
        wanted = own.get(name, getattr(math, name, None))(float(argument))
    assert evaluate(parse(text)) == pytest.approx(wanted, rel=1e-15, abs=0.0)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        *(
            (text, "E0313")
            for text in ("sqrt(-1)", "log(-2)", "asin(2)", "acos(-2)", "exp(1000)", "cosh(1000)", "(-8)^(1/3)")
        ),
        *((text, "E0417") for text in ("1/0", "1/(2 - 2)", "1/sin(pi)", "tan(pi/2)", "0^-1")),
    ],
)
def test_constants_without_a_value(text: str, code: str) -> None:
    with pytest.raises(ConstantError) as caught:
        evaluate(parse(text))
    assert caught.value.code == code
