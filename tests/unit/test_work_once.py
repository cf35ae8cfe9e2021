"""What is known is not made again: functions of a program, walks over the graph, and error bounds at several points."""

from __future__ import annotations

import math
from collections import Counter

import pytest

from nhc.algebra.graph import Graph
from nhc.algebra.probe import Probe
from nhc.algebra.rewriting.digits import _Points
from nhc.algebra.walks import reachable
from nhc.diagnostics import Source
from nhc.emit.names import Scope
from nhc.mechanics.properties import integrability
from nhc.pipeline import Options, check, emit
from nhc.program import build
from tests.support import ROOT


@pytest.mark.parametrize("name", ["chaplygin_sleigh", "holonomic_pendulum"])
def test_emitting_everything_lowers_each_function_once(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    lowered, lower = Counter[str](), build.lower_function

    def counted(graph, plan, parameters):  # type: ignore[no-untyped-def]
        lowered[plan.name] += 1
        return lower(graph, plan, parameters)

    monkeypatch.setattr(build, "lower_function", counted)
    path = ROOT / "specs" / f"{name}.yaml"
    emit(Source(path.name, path.read_text(encoding="utf-8")), "c", Options())
    assert lowered["rhs"] == lowered["energy"] == 1
    assert lowered["positions"] == (name == "holonomic_pendulum")
    assert set(lowered.values()) == {1}


def test_a_check_that_is_not_explained_looks_for_warnings_only(monkeypatch: pytest.MonkeyPatch) -> None:
    """The growth vector of 20 trailers takes longer than all the rest."""
    asked, growth_vector = list[int](), integrability.growth_vector

    def counted(graph, variables, *others):  # type: ignore[no-untyped-def]
        asked.append(len(variables))
        return growth_vector(graph, variables, *others)

    monkeypatch.setattr(integrability, "growth_vector", counted)
    source = Source("trailers3.yaml", (ROOT / "specs" / "n_trailer3.yaml").read_text(encoding="utf-8"))
    short = check(source, explain=False)
    assert not asked
    whole = check(source)
    assert asked
    assert short.diagnostics == whole.diagnostics
    assert {"growth", "cyclic", "applicable", "chaplygin"} <= whole.data.keys()


def test_a_walk_that_is_remembered_belongs_to_its_caller() -> None:
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    root = g.add(g.mul(x, y), g.function("sin", x))
    first = reachable(g, [root])
    kept = list(first)
    first.clear()
    second = reachable(g, [root])
    assert second == kept
    second.reverse()
    assert reachable(g, [root]) == kept
    assert reachable(g, [x]) == [x]
    assert reachable(g, [root]) == kept


def test_bounds_at_all_points_are_those_of_a_probe_at_each() -> None:
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    difference = g.sub(g.power(g.sub(x, y), 3), g.div(g.function("sin", x), g.add(y, g.number(2))))
    nodes = [difference, g.function("sqrt", difference), g.function("atan2", x, difference), g.mul(g.pi(), difference)]
    points = _Points(g)
    points.evaluate(nodes)
    for k in range(len(points.values[x])):

        class Placed(Probe):
            def _place(self, symbol, k=k):  # type: ignore[no-untyped-def]
                return points.values[g.symbol(symbol.name)][k]

        probe = Placed(g)
        for node in nodes:
            value = probe.value(node)
            assert value == points.values[node][k] or (math.isnan(value) and math.isnan(points.values[node][k]))
            if math.isfinite(value):
                assert probe.errors[node] == points.errors[node][k]


def test_temporaries_are_counted_on() -> None:
    """The thousandth name of a prefix is not searched for from the first one on; names that are there already are left alone."""

    class Asked(set[str]):
        times = 0

        def __contains__(self, name: object) -> bool:
            self.times += 1
            return super().__contains__(name)

    scope = Scope((), 63)
    scope._taken = asked = Asked({"t3", "t5"})
    assert [scope.fresh("t") for _ in range(4)] == ["t1", "t2", "t4", "t6"]
    assert [scope.fresh("u") for _ in range(1000)][-1] == "u1000"
    assert asked.times <= 1010
