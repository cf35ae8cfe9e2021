"""Whether the smallest model of a scene gives what the whole equations give: exactly, on the statements of both."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.program.build import build_functions
from nhc.program.ir import Function
from nhc.program.planning.planner import Planner
from nhc.program.planning.scene import ScenePlanner
from nhc.program.reduced import build_scene_functions
from nhc.program.scene_model import SceneModel
from nhc.program.validation.promises import Promise, Promises
from nhc.program.validation.reading_back import Place, Reader
from nhc.program.validation.validate import Kept, holds, places_of


def validate_scene(model: SceneModel) -> Kept:
    """Whether all functions of a scene's model give what the whole equations give."""
    return validate_scene_functions(model.planner, build_scene_functions(model.planner, ()))


def validate_scene_functions(planner: ScenePlanner, functions: Sequence[Function]) -> Kept:
    """Whether the functions of a scene's model give the rates of what is kept, the start and the needs that the whole equations
    give, at every whole state; its constants have the values that this state gives them.
    """
    own = {function.name: function for function in functions}
    slopes = Promises(planner, Reader(planner.graph, own, places_of(planner))).jacobian()
    promises = [*_Comparison(planner, own).collect(), slopes]
    return {promise.function: holds(planner.graph, promise) for promise in promises}


class _Comparison:
    """A scene's model beside the whole equations."""

    def __init__(self, planner: ScenePlanner, functions: dict[str, Function]) -> None:
        self.planner, self.made, self.graph = planner, planner.reduction, planner.graph
        whole = Planner(self.made.equations, self.made.formulation)
        wanted = {function.name: function for function in build_functions(whole, ("rhs", "state", "reactions"))}
        self.whole, self.reader = whole, Reader(self.graph, wanted, places_of(whole))
        g, names = self.graph, (*whole.system.q, *self.made.equations.motion.w)
        constants = {i.symbol: g.sub(names[i.index], i.written) for i in self.made.integrals}
        known: dict[Place, Node] = {}
        for place, node in places_of(planner).items():
            known[place] = constants.get(node, node)
        self.own = Reader(g, functions, known)
        self.folded = {x: value for x, value in self.made.fixed if x in set(whole.system.p)}

    def collect(self) -> list[Promise]:
        """In the order of the functions."""
        found = []
        for name in ("rhs", "state"):
            theirs = self.reader.read(name).written
            found.append(self._equal(name, [theirs.get(i, self.graph.zero) for i in self.made.kept]))
        return [*found, self._equal("outputs", self._needs())]

    def _needs(self) -> list[Node]:
        """What the scene needs, by the rates and reactions of the whole equations."""
        equations, n = self.made.equations, self.whole.system.n
        rates, forces = self.reader.read("rhs").written, self.reader.read("reactions").written
        known = {x: rates.get(n + k, self.graph.zero) for k, x in enumerate(equations.motion.rates)}
        known |= {x: forces.get(k, self.graph.zero) for k, x in enumerate(equations.multipliers)}
        return substitute(self.graph, [column.node for column in self.made.outputs], known)

    def _equal(self, name: str, expected: Sequence[Node]) -> Promise:
        g, found = self.graph, self.own.read(name)
        values = [found.written.get(k, g.zero) for k in range(len(expected))]
        nodes = [g.sub(x, y) for x, y in zip(values, expected, strict=True)]
        stages = [
            *found.stages,
            *(stage for theirs in ("rhs", "state", "reactions") for stage in self.reader.read(theirs).stages),
        ]
        return Promise(name, tuple(substitute(g, nodes, self.folded)), tuple(dict.fromkeys(stages)))
