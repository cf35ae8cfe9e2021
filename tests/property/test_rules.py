"""Each rewriting rule by itself: it fires, and what it makes equals the unrewritten expression modulo primes."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import assume, given

from benchmarks.models import source
from benchmarks.rules import PAGE, compile_without, count
from benchmarks.systems import ROOT
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal, are_zero
from nhc.algebra.graph import NUM, PI, SYM, Graph, Node
from nhc.algebra.rewriting.rules import NAMES, RULES, WithoutRules
from nhc.algebra.walks import reachable
from nhc.emit import EmitOptions, render
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.planning.planner import Planner
from tests.property.expressions import NAMES as SYMBOLS
from tests.property.expressions import QUIET, Tree, build, rational_trees
from tests.property.test_algebra import Fractions, X, Y, Z, num, points, values_at
from tests.support import python_model

LOCAL: dict[str, Tree] = {
    "common factors": ("+", ("*", X, Y), ("neg", ("*", Z, Y))),
    "cancelled terms": ("+", X, ("-", Y, X)),
    "cancelled factors": ("*", ("*", X, ("pow", Y, 2)), ("pow", Y, -1)),
    "circle": ("+", ("*", num(3), ("pow", ("sin", X), 2)), ("*", num(3), ("pow", ("cos", X), 2))),
}
WHOLE = {
    "shared products": "trailers3",  # a system on which the rule changes the right-hand side
    "shared sums": "bicycle",
    "canonical forms": "disk",
    "divided sums": "dome",
    "gathered sums": "trailers3",
    "Cramer's rule": "bicycle",
    "orthonormal rows": "submarine",
    "constant brackets": "submarine",
    "completed squares": "written_out_top",
    "found positions": "written_out_arm4",
    "moving axes": "trailers3",
    "body axes": "chaplygin_ball_quaternion",
    "own axes": "ball_arm3",
    "leaning joints": "bicycle",
    "trees": "pendulum5",
    "composite inertias": "arm6",
    "short rows": "belt_egg",
    "uniform motion": "belt_egg",
    "detours": "smooth_tippe_top",
    "directions": "turret",
    "spherical tops": "bowl",
    "other axes": "turned_top",
    "short inverses": "dome",
    "order of pivots": "satellite3",
    "still pivots": "smooth_tippe_top",
    "pieces": "voronec_particle",
    "joined angles": "spherical2",
    "related angles": "snakeboard",
    "equal values": "trailers3",
    "shared powers": "atoms3",
    "shared reciprocals": "snake3",
    "folded numbers": "chaplygin_ball_quaternion",
}


def transplant(nodes: Sequence[Node], old: Graph, new: Graph) -> list[Node]:
    """The same nodes in another graph, operation by operation, without a rule."""
    found: dict[Node, Node] = {}
    for node in reachable(old, nodes):
        op = old.op[node]
        symbol, value = old.symbol_of(node), old.value(node)
        if op == SYM and symbol is not None:
            found[node] = new.symbol(symbol.name, symbol.kind)
        elif op == NUM and value is not None:
            found[node] = new.number(value)
        elif op == PI:
            found[node] = new.pi()
        else:
            children = [found[child] for child in old.children(node)]
            second = children[1] if len(children) > 1 else old.b[node]
            found[node] = new._make(op, children[0], second, new.mask(children))
    return [found[node] for node in nodes]


def rates(system: str, graph: Graph) -> list[Node]:
    """The right-hand side of a system that is compiled on the graph."""
    made = resolve(decode(source(system)), graph)
    formulation = formulate(made)
    return [target.node for target in Planner(equations_of(made, formulation), formulation).rhs().targets]


def test_every_rule_has_a_test() -> None:
    assert {*LOCAL, *WHOLE} == NAMES == {rule.name for rule in RULES}
    with pytest.raises(KeyError, match=r"no rule nonsense; there are .*circle"):
        WithoutRules(["nonsense"])


@pytest.mark.parametrize("rule", LOCAL)
def test_a_local_rule_fires_and_keeps_the_value(rule: str) -> None:
    with_all, without = Graph(), WithoutRules([rule])
    short, long = build(with_all, LOCAL[rule]), build(without, LOCAL[rule])
    (moved,) = transplant([short], with_all, without)
    assert moved != long
    assert are_zero(without, [without.sub(moved, long)], 4) == [True]
    assert len(reachable(without, [moved])) < len(reachable(without, [long]))


@pytest.mark.parametrize("rule", LOCAL)
@QUIET
@given(rational_trees, points)
def test_without_a_local_rule_every_expression_has_its_value(
    rule: str, tree: Tree, point: tuple[Fraction, ...]
) -> None:
    found = []
    for g in (Graph(), WithoutRules([rule])):
        try:
            node = build(g, tree)
            found.append(evaluate(g, [node], values_at(g, point), Fractions)[0])
        except ZeroDivisionError:
            assume(False)
    assert found[0] == found[1]


@pytest.mark.parametrize("rule", WHOLE)
def test_a_rule_of_whole_systems_fires_and_keeps_the_value(rule: str) -> None:
    """Modulo primes; where a rule leaves the nodes alone and changes the statements only, by the emitted modules."""
    system = WHOLE[rule]
    with_all, without = Graph(), WithoutRules([rule])
    short, long = rates(system, with_all), rates(system, without)
    assert are_equal(without, transplant(short, with_all, without), long)
    assert count(system) != count(system, (rule,))


@pytest.mark.sample(2)
@pytest.mark.parametrize("rule", sorted(NAMES))
def test_the_emitted_code_has_the_same_values(rule: str) -> None:
    system = WHOLE.get(rule, "trailers3")
    modules = [
        python_model(render(compile_without(system, off), "python", EmitOptions())[f"{system}.py"], system)
        for off in ((), (rule,))
    ]
    for k in range(4):
        apart = system == "atoms3"  # atoms that nearly touch have forces of 1e13, of which little is left in their sum
        y = [0.3 + 0.1 * ((3 * i + k) % 5) + apart * (i // 2) for i in range(len(modules[0].STATE))]
        first, second = (module.rhs(0.0, y) for module in modules)
        assert second == pytest.approx(first, rel=1e-9, abs=1e-9)


def test_the_page_names_every_rule_once_in_each_table() -> None:
    text = PAGE.read_text(encoding="utf-8")
    for rule in RULES:
        assert text.count(f"| {rule.name} |") == 2
        assert f"| {rule.name} | {rule.about} | `nhc/{rule.where}` |" in text
        assert (ROOT / "nhc" / rule.where).is_file()


def test_a_symbol_is_a_symbol() -> None:
    """What the tests above rely on: a transplanted expression keeps its symbols."""
    g, other = Graph(), Graph()
    x = g.symbol(SYMBOLS[0])
    assert other.symbol_of(transplant([x], g, other)[0]) == g.symbol_of(x)
