"""Where a choice is regular: sampling at ordinary and at special points, bounds, and the choice of dependent velocities."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.interval import Interval, cannot_vanish
from nhc.algebra.linear import determinant_of
from nhc.algebra.polynomial import normalise
from nhc.language.syntax import Syntax
from nhc.mechanics.system import System

_TRIALS = 12
_MANY = 250  # subsets of columns that are tried one by one


@dataclass(frozen=True)
class Choice:
    """Dependent velocities with the determinant of their block; ``regular`` if it can be shown never to vanish."""

    dependent: tuple[int, ...]
    determinant: Node | None
    regular: bool


def default_values(system: System) -> dict[Node, float]:
    """Parameters at their defaults; 1 where there is none."""
    values: dict[Node, float] = {}
    for symbol, parameter in zip(system.p, system.spec.parameters, strict=True):
        values[symbol] = parameter_value(parameter.value)
    return values


def parameter_value(value: object) -> float:
    """A parameter's double; 1 stands for one that each scene has to give."""
    from fractions import Fraction

    if value is None:
        return 1.0
    if isinstance(value, Fraction):
        return float(value)
    return constant_value(value)  # type: ignore[arg-type]


def constant_value(tree: Syntax, names: dict[str, float] | None = None) -> float:
    """The double of a constant expression (numbers, pi, and the given names)."""
    from nhc.language.syntax import fold_tree

    graph = Graph()
    known = dict(names or {})
    node = fold_tree(tree, lambda part, operands: _constant(graph, part, operands, known))
    return float(evaluate(graph, [node], {graph.symbol(name): value for name, value in known.items()})[0])


def _constant(graph: Graph, part: Syntax, operands: tuple[Node, ...], names: dict[str, float]) -> Node:
    from nhc.language.syntax import Binary, Call, Name, Negate, Number

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


def intervals(system: System) -> dict[Node, Interval]:
    """Parameters as points, coordinates over their declared ranges."""
    known: dict[Node, Interval] = {node: (value, value) for node, value in default_values(system).items()}
    for symbol, coordinate in zip(system.q, system.spec.coordinates, strict=True):
        if coordinate.range is not None:
            known[symbol] = (float(coordinate.range[0]), float(coordinate.range[1]))
    return known


def trial_points(system: System) -> list[dict[Node, float]]:
    """Random states, and the special ones (zero, quarter turns) where careless choices are singular."""
    rng = random.Random(7)
    parameters = default_values(system)
    points = []
    for k in range(_TRIALS):
        special = (0.0, math.pi / 2, math.pi / 4, math.pi) if k < 4 else ()
        point = dict(parameters)
        for j, symbol in enumerate(system.q):
            coordinate = system.spec.coordinates[j]
            if coordinate.range is not None:
                low, high = (float(end) for end in coordinate.range)
                point[symbol] = rng.uniform(low, high)
            else:
                point[symbol] = special[(k + j * (k > 1)) % 4] if special and k != 0 else 0.0 if k == 0 else rng.uniform(-3, 3)
        for symbol in system.v:
            point[symbol] = rng.uniform(-1, 1)
        point[system.t] = rng.uniform(0, 2)
        points.append(point)
    return points


def sampled_rows(system: System) -> list[list[list[float]]]:
    """The constraint matrix at each trial point where it can be evaluated."""
    g = system.graph
    flat = [a for form in system.constraints for a in form.coefficients]
    result = []
    for point in trial_points(system):
        try:
            values = evaluate(g, flat, point)
        except (ArithmeticError, ValueError):
            continue
        result.append([[float(x) for x in values[r * system.n : (r + 1) * system.n]] for r in range(system.l)])
    return result


def relative_determinant(matrix: Sequence[Sequence[float]], columns: Sequence[int]) -> float:
    """|det| of the columns divided by the product of the norms of the whole rows (Hadamard): in [0, 1]."""
    block = [[row[j] for j in columns] for row in matrix]
    scale = math.prod(max(math.sqrt(sum(x * x for x in row)), 1e-300) for row in matrix)
    return abs(_float_determinant(block)) / scale


def _float_determinant(block: list[list[float]]) -> float:
    size, det = len(block), 1.0
    rows = [list(row) for row in block]
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        if rows[pivot][k] == 0.0:
            return 0.0
        if pivot != k:
            rows[k], rows[pivot], det = rows[pivot], rows[k], -det
        det *= rows[k][k]
        for i in range(k + 1, size):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k], strict=True)]
    return det


def choose_dependent(system: System) -> Choice:
    """The l velocities to solve for: never singular where there is such a choice, else singular as rarely as possible."""
    n, lower = system.n, system.l
    if lower == 0:
        return Choice((), system.graph.one, True)
    samples = sampled_rows(system)
    if math.comb(n, lower) <= _MANY:
        candidates = [list(c) for c in combinations(range(n), lower)]
    else:
        candidates = [_greedy(system, samples)]
    scored = []
    for columns in candidates:
        values = [relative_determinant(matrix, columns) for matrix in samples] or [0.0]
        weak = sum(value < 1e-3 for value in values)
        scored.append((weak, -round(sum(sorted(values)[: max(1, len(values) // 2)]) / len(values), 3), columns))
    scored.sort()
    best: Choice | None = None
    for weak, _, columns in scored[:8]:
        choice = judge(system, tuple(columns))
        if best is None or (choice.regular and not best.regular):
            best = choice
        if best.regular or weak > scored[0][0]:
            break
    assert best is not None
    return best


def _greedy(system: System, samples: list[list[list[float]]]) -> list[int]:
    """Column by column: the one whose smallest pivot over the samples is largest (for systems with many constraints)."""
    work = [[list(row) for row in matrix] for matrix in samples[-3:] or samples]
    chosen: list[int] = []
    for row in range(system.l):
        best = max(
            (j for j in range(system.n) if j not in chosen),
            key=lambda j: (round(min(abs(m[row][j]) for m in work), 9), j),
        )
        chosen.append(best)
        for matrix in work:
            pivot = matrix[row][best]
            if pivot == 0.0:
                continue
            for i in range(row + 1, system.l):
                factor = matrix[i][best] / pivot
                if factor:
                    matrix[i] = [x - factor * y for x, y in zip(matrix[i], matrix[row], strict=True)]
    return sorted(chosen)


def judge(system: System, dependent: tuple[int, ...]) -> Choice:
    """The block's determinant in canonical form (None for large blocks) and whether it can vanish."""
    g = system.graph
    block = [[form.coefficients[j] for j in dependent] for form in system.constraints]
    if len(block) > 5:
        return Choice(dependent, None, False)
    determinant = normalise(g, determinant_of(g, block), 200)
    return Choice(dependent, determinant, cannot_vanish(g, determinant, intervals(system)))
