"""The values that a spec gives its parameters, by themselves and in its scenes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.language.constants import constant_definitions
from nhc.language.expressions.names import PI
from nhc.language.expressions.syntax import Binary, Call, Name, Negate, Number, Syntax, fold_tree
from nhc.language.scope import names_in
from nhc.language.spec import Scene, Spec
from nhc.mechanics.system import System

_SLACK = 1e-9  # of a range's width


def default_values(system: System) -> dict[Node, float]:
    """Parameters at their defaults; 1 where there is none."""
    values: dict[Node, float] = {}
    for symbol, parameter in zip(system.p, system.spec.parameters, strict=True):
        values[symbol] = parameter_value(parameter.value)
    return values


def parameter_value(value: Fraction | Syntax | None) -> float:
    """A parameter's double; 1 stands for one that each scene has to give."""
    if value is None:
        return 1.0
    if isinstance(value, Fraction):
        return float(value)
    return constant_value(value)


def scene_values(system: System) -> list[dict[Node, float]]:
    """The parameters at their defaults, then at those of each scene that has others."""
    defaults = default_values(system)
    named = dict(zip((parameter.name for parameter in system.spec.parameters), system.p, strict=True))
    found = [defaults]
    for scene in system.spec.scenes:
        try:
            own = {named[given.name]: parameter_value(given.value) for given in scene.parameters}
        except (ArithmeticError, ValueError):
            continue  # said of the scene itself
        if own and {**defaults, **own} not in found:
            found.append({**defaults, **own})
    return found


def parameter_ranges(system: System) -> dict[Node, tuple[float, float]]:
    """From the least to the largest value of each parameter in the spec and its scenes; 1 where none gives one."""
    given = [p for p, parameter in zip(system.p, system.spec.parameters, strict=True) if parameter.value is not None]
    defaults, *scenes = scene_values(system)
    ranges = {}
    for symbol, value in defaults.items():
        values = [own[symbol] for own in scenes if symbol in given or own[symbol] != value] or [value]
        values += [value] if symbol in given else []
        ranges[symbol] = min(values), max(values)
    return ranges


def coordinate_ranges(system: System) -> dict[Node, tuple[float, float]]:
    """Where the spec expects coordinates to stay, of those that it says it of."""
    pairs = zip(system.q, system.spec.coordinates, strict=True)
    return {symbol: (float(c.range[0]), float(c.range[1])) for symbol, c in pairs if c.range is not None}


def is_outside(limits: tuple[float, float], value: float) -> bool:
    """Whether a coordinate has left its range: a motion that turns at the edge stays within."""
    slack = _SLACK * (limits[1] - limits[0])
    return not limits[0] - slack <= value <= limits[1] + slack


def start_values(spec: Spec, scene: Scene, p: Sequence[float]) -> dict[str, float]:
    """What the values of the scene's start may speak of."""
    return named_constants(spec, p, [entry.value for entry in scene.initial])


def named_constants(spec: Spec, p: Sequence[float], trees: Sequence[Syntax]) -> dict[str, float]:
    """The parameters and, where the trees have other names, the definitions of these; not a number where one has no value."""
    found = dict(zip((parameter.name for parameter in spec.parameters), p, strict=True))
    if {name for tree in trees for name in names_in(tree)} <= {*found, PI}:
        return found
    for definition in constant_definitions(spec.definitions, tuple(found)):
        try:
            found[definition.name] = constant_value(definition.value, found)
        except (ArithmeticError, ValueError):
            found[definition.name] = math.nan
    return found


def constant_value(tree: Syntax, names: dict[str, float] | None = None) -> float:
    """The double of a constant expression (numbers, pi, and the given names)."""
    if isinstance(tree, Number):  # as nearly all are
        return float(tree.value)
    graph, known = Graph(), names or {}
    node = fold_tree(tree, lambda part, operands: _constant(graph, part, operands, known))
    present = {graph.symbol(symbol.name): known[symbol.name] for symbol in graph.symbols if symbol.name in known}
    return float(evaluate(graph, [node], present)[0])


def _constant(graph: Graph, part: Syntax, operands: tuple[Node, ...], names: dict[str, float]) -> Node:
    match part:
        case Number():
            return graph.number(part.value)
        case Name():
            return graph.pi() if part.name == "pi" and "pi" not in names else graph.symbol(part.name)
        case Negate():
            return graph.neg(operands[0])
        case Call():
            return graph.function(part.function, *operands)
        case Binary():
            x, y = operands
            exponent = graph.value(y)
            if part.op == "^" and exponent is not None and exponent.denominator == 1:
                return graph.power(x, int(exponent))
            build = {"+": graph.add, "-": graph.sub, "*": graph.mul, "/": graph.div}.get(part.op)
            return build(x, y) if build else graph.function("powf", x, y)
        case _:
            raise ValueError("a constant expression holds no velocities")
