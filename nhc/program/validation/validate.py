"""Whether the functions of a program compute what the equations say: exactly, on the statements that the emitters print.

This is translation validation (A. Pnueli, M. Siegel, E. Singerman, TACAS 1998): no rule that was applied on the way is trusted,
what came out is held against the equations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nhc.algebra.dense import Singular, solve_columns_modulo
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.modular import are_zero, enough_points, vanishes_numerically
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.associate import Equations
from nhc.mechanics.certificates.certificate import Certificate, certify, derive_all
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.system import System
from nhc.program.build import build_functions
from nhc.program.ir import Function
from nhc.program.planning.planner import Planner
from nhc.program.validation.promises import Promise, Promises
from nhc.program.validation.reading_back import Place, Reader

_POINTS = 2

Kept = dict[str, bool | None]
"""By function, whether it keeps what it promises; None where no point was found at which that can be seen, or where it is kept to
40 digits at real places, by an identity that the prime field does not have."""


Show = Callable[[float, str], None]


def certify_programs(system: System, show: Show | None = None) -> tuple[Certificate, dict[str, Kept]]:
    """The certificate of a system, and by formulation whether its functions keep what they promise; derived once for both.

    ``show`` is told how much is done, and what is next.
    """
    derived, kept = derive_all(system), dict[str, Kept]()
    for k, (formulation, equations) in enumerate(derived):
        if show is not None:
            show(k / (len(derived) + 1), f"emitted code of {formulation.name}")
        kept[formulation.name] = validate(equations, formulation)
    if show is not None:
        show(len(derived) / (len(derived) + 1), "formulations against one another")
    return certify(system, derived=derived), kept


def validate(equations: Equations, formulation: Formulation) -> Kept:
    """Whether each function of the program of these equations computes what they say."""
    planner = Planner(equations, formulation)
    return validate_functions(planner, build_functions(planner))


def validate_functions(planner: Planner, functions: Sequence[Function]) -> Kept:
    """The same of functions of the planner's plans, also where another stands in for one."""
    own = {function.name: function for function in functions}
    kept = _validate(planner, own)
    standing = {function.name: function.otherwise for function in functions if function.otherwise is not None}
    if standing:
        for name, too in _validate(planner, own | standing).items():
            kept[name] = kept[name] and too
    return kept


def _validate(planner: Planner, functions: dict[str, Function]) -> Kept:
    promises = Promises(planner, Reader(planner.graph, functions, places_of(planner))).collect()
    return {promise.function: holds(planner.graph, promise) for promise in promises}


def places_of(planner: Planner) -> dict[Place, Node]:
    """The symbols that stand at the places of the functions' arrays."""
    loads = (*planner.state_loads.items(), *planner.motion_loads.items())
    return {(array, index): node for node, (array, index, _) in loads}


def holds(graph: Graph, promise: Promise) -> bool | None:
    """Whether a function keeps its promise; None where that is not decided."""
    try:
        if promise.stages:
            return _vanish_staged(graph, promise)
        zero = are_zero(graph, promise.nodes)
    except Unlucky:
        return None
    left = [node for node, vanishes in zip(promise.nodes, zero, strict=True) if not vanishes]
    if left and all(vanishes_numerically(graph, node, 1) for node in left):
        return None  # an identity that the field does not have
    return not left


def _vanish_staged(graph: Graph, promise: Promise) -> bool:
    """Whether the nodes vanish at random points where the stages have been solved.

    Raises:
        Unlucky: no point was found.
    """
    nodes = [node for node in promise.nodes if node != graph.zero]
    inside = [x for stage in promise.stages for row in (*stage.matrix, *stage.columns) for x in row]
    unknowns = graph.mask([x for stage in promise.stages for column in stage.symbols for x in column])
    primes, needed = primes_of(graph), max(_POINTS, enough_points(graph, [*nodes, *inside]))
    for k in range(needed if nodes else 0):
        prime, seeds = primes[k % len(primes)], range(k * 100_003, k * 100_003 + MOST_DRAWS)
        for _, point in draw_points(graph, [*inside, *nodes], prime, seeds, later=unknowns):
            try:
                _settle(promise, point)
                if any(point.evaluate(nodes)):
                    return False
                break
            except (Unlucky, Singular):
                continue
        else:
            raise Unlucky
    return True


def _settle(promise: Promise, point: FieldPoint) -> None:
    """Give the stages' symbols their values."""
    for stage in promise.stages:
        matrix = [point.evaluate(row) for row in stage.matrix]
        columns = [point.evaluate(column) for column in stage.columns]
        found: Sequence[Sequence[int]] = solve_columns_modulo(matrix, list(zip(*columns, strict=True)), point.prime)
        for symbols, values in zip(stage.symbols, zip(*found, strict=True), strict=True):
            point.evaluate([], dict(zip(symbols, values, strict=True)))
