"""Each function of the language by itself: value, slopes by all their routes, intervals and error bounds, against mpmath."""

from __future__ import annotations

from itertools import product

import mpmath
import pytest

from nhc.algebra.bounds.interval import bounds, excludes_zero
from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.evaluate import Mpmath, evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.probe import bounded
from nhc.algebra.solving.sizes import size_of
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.language.expressions.names import FUNCTIONS
from nhc.mechanics.resolving.resolve import resolve

# On all of the line where nothing else is said; (first operand, second operand), away from kinks.
PLACES = {
    "asin": (-0.9, -0.3, 0.2, 0.95),
    "acos": (-0.9, -0.3, 0.2, 0.95),
    "log": (0.05, 0.7, 3.0),
    "sqrt": (0.05, 0.7, 3.0),
}
ANYWHERE = (-2.3, -1.1, -0.4, 0.3, 1.2, 2.9)
SECOND = (-1.7, -0.6, 0.45, 2.2)
CASES = [
    (name, (x, y) if most == 2 else (x,))
    for name, (_, most) in (*FUNCTIONS.items(), ("powf", (2, 2)))
    for x in ((0.05, 0.7, 3.0) if name == "powf" else PLACES.get(name, ANYWHERE))
    for y in (SECOND if most == 2 else (0.0,))
]


def plain(name: str, *at: object) -> object:
    """By mpmath, or by the definition."""
    known = {"abs": abs, "min": min, "max": max, "sign": mpmath.sign, "powf": lambda x, y: x**y}
    return known.get(name, getattr(mpmath, name, None))(*at)


def functions_of(g: Graph, name: str, count: int) -> tuple[Node, list[Node]]:
    symbols = [g.symbol(letter) for letter in "xy"[:count]]
    if name == "tan":
        return g.div(g.function("sin", symbols[0]), g.function("cos", symbols[0])), symbols
    return g.function(name, *symbols), symbols


@pytest.mark.parametrize(("name", "at"), CASES)
def test_value_slopes_and_second_slopes(name: str, at: tuple[float, ...]) -> None:
    g = Graph()
    node, symbols = functions_of(g, name, len(at))
    forward = [tangent(g, [node], {symbol: g.one})[0] for symbol in symbols]
    reverse = gradient(g, node, symbols)
    second = [gradient(g, slope, symbols) for slope in forward]
    with mpmath.workdps(60):
        values = dict(zip(symbols, map(mpmath.mpf, at), strict=True))
        orders = [tuple(int(i == k) for i in range(len(at))) for k in range(len(at))]
        sums = [[tuple(map(sum, zip(a, b, strict=True))) for b in orders] for a in orders]
        wanted = [mpmath.diff(lambda *z: plain(name, *z), tuple(values.values()), n) for n in orders]
        curved = [mpmath.diff(lambda *z: plain(name, *z), tuple(values.values()), n) for row in sums for n in row]
        nodes = [node, *forward, *reverse, *(x for row in second for x in row)]
        found = evaluate(g, nodes, values, Mpmath())
        exact = [plain(name, *values.values()), *wanted, *wanted, *curved]
        assert all(abs(x - y) < mpmath.mpf(10) ** -25 * (1 + abs(y)) for x, y in zip(found, exact, strict=True))


@pytest.mark.parametrize(("name", "at"), [case for case in CASES if case[0] != "tan"])  # tan is a quotient
def test_intervals_and_error_bounds_hold_the_value(name: str, at: tuple[float, ...]) -> None:
    g = Graph()
    node, symbols = functions_of(g, name, len(at))
    with mpmath.workdps(40):
        for below, above in product((0.0, 1e-9, 0.03), (0.0, 1e-9, 0.04, 5.0)):
            box = {symbol: (x - below, x + above) for symbol, x in zip(symbols, at, strict=True)}
            low, high = bounds(g, node, box)
            for corner in product(*((*ends, x) for ends, x in zip(box.values(), at, strict=True))):
                exact = plain(name, *map(mpmath.mpf, corner))
                if isinstance(exact, mpmath.mpf | float | int):  # outside its domain it has no real value
                    assert low <= exact <= high or abs(exact - low) < 1e-15 or abs(exact - high) < 1e-15
        error = 1e-9
        value, bound = bounded(name, 0, at[0], error, *((at[1], error) if len(at) == 2 else (0.0, 0.0)))
        for moved in product(*((x - error, x, x + error) for x in at)):
            exact = plain(name, *map(mpmath.mpf, moved))
            assert abs(exact - value) <= bound * (1 + 1e-6) + abs(value) * 2.0**-52  # to first order
        assert bound < 1e3 * error * (1 + abs(value))


SIZES = [  # a node, a place where it vanishes, and the size that it is measured against there
    ("sin(x)", (0.0, 2.0), 1.0),
    ("cos(x)", (float(mpmath.pi) / 2, 2.0), 1.0),
    ("x - y", (2.0, 2.0), 4.0),
    ("x*cos(y) - x", (3.0, 0.0), 6.0),
    ("(x - 1)^3", (1.0, 2.0), 8.0),
    ("y*x/sqrt(x^2 + y^2)", (0.0, 2.0), 2.0),
    ("-y*sin(x)", (0.0, -2.0), 2.0),
]


@pytest.mark.parametrize(("text", "place", "size"), SIZES)
def test_sizes_do_not_vanish_with_what_they_measure(text: str, place: tuple[float, float], size: float) -> None:
    source = f"nhc: 1\nsystem: s\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nV: {text}\n"
    system = resolve(decode(Source("s.yaml", source)))
    g, node = system.graph, system.U
    found = size_of(g, node)
    value, measured = evaluate(g, [node, found], dict(zip(system.q, place, strict=True)))
    assert abs(value) < 1e-15 and measured == pytest.approx(size, rel=1e-12)
    for x, y in product(ANYWHERE, repeat=2):
        value, measured = evaluate(g, [node, found], dict(zip(system.q, (x, y), strict=True)))
        assert abs(value) <= measured * (1 + 1e-14)


@pytest.mark.parametrize(
    ("interval", "excluded"),
    [
        ((1.0, 2.0), True),
        ((0.0, 2.0), False),
        ((-1e-3, 2.0), False),
        ((1e-12, 1.0), False),  # no more than what rounding leaves of 1
        ((1e-6, 1.0), True),
        ((1e-12, 1e-11), True),
        ((2e-9, mpmath.inf), True),
        ((1e-12, mpmath.inf), False),
        ((-mpmath.inf, mpmath.inf), False),
    ],
)
def test_zero_is_excluded_by_more_than_rounding_and_on_both_sides_alike(
    interval: tuple[float, float], excluded: bool
) -> None:
    low, high = map(float, interval)
    assert excludes_zero((low, high)) is excluded
    assert excludes_zero((-high, -low)) is excluded
