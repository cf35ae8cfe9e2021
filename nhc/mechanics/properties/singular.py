"""Where the constraints themselves lose rank: there the equations of motion are undefined in every formulation."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import reduce
from itertools import combinations
from operator import and_, or_

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.bounds.subdivision import cannot_vanish_together
from nhc.algebra.calculus import tangent
from nhc.algebra.dense import symmetric_eigenvalues
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import ADD, MUL, POW, Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.algebra.shared import find_shared
from nhc.algebra.solving.blocks import determinant_of
from nhc.mechanics.choosing.pivots import set_pivots_aside
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.rotations.turning import along, from_base, rows_in_base
from nhc.mechanics.system import System
from nhc.records import record

_MOST_ROWS = 3
_MOST_MINORS = 60
_FEW_TERMS = 100
_FEW_COORDINATES = 4


@record
class RankLoss:
    """``regular``: shown to have full rank everywhere (None: too large to decide); else only where all of ``minors`` vanish."""

    regular: bool | None
    minors: tuple[Node, ...]


def find_rank_loss(system: System) -> RankLoss:
    """Rows with a pivot that cannot vanish are set aside; the others are judged by the squares of their maximal minors."""
    known: list[tuple[System, RankLoss]] = system.graph.memory.setdefault("losses of rank", [])
    found = next((loss for owner, loss in known if owner is system), None)
    if found is None:
        found = _find_rank_loss(system)
        known.append((system, found))
    return found


def needs_ranges(system: System) -> bool:
    """Whether the rank is known to be full for the coordinates' declared ranges only."""
    spec = system.spec
    if all(coordinate.range is None for coordinate in spec.coordinates):
        return False
    bare = replace(spec, coordinates=tuple(replace(coordinate, range=None) for coordinate in spec.coordinates))
    return not find_rank_loss(replace(system, spec=bare)).regular


def _find_rank_loss(system: System) -> RankLoss:
    g, known = system.graph, intervals(system)
    rows, columns = set_pivots_aside(system)
    matrix = rows_in_base(system, system.constraints)
    if not rows:
        return RankLoss(True, ())
    free = [j for j in range(system.n) if j not in columns]
    free = [j for j in free if any(matrix[r][j] != g.zero for r in rows)]
    if len(rows) > _MOST_ROWS or math.comb(len(free), len(rows)) > _MOST_MINORS:
        return RankLoss(None, ())
    minors, whole = dict[Node, None](), list[Node]()
    for subset in combinations(free, len(rows)):
        block = [[matrix[r][j] for j in subset] for r in rows]
        minor = normalise_angles(g, determinant_of(g, block), 120)
        if minor != g.zero:
            minors[g.split_coefficient(minor)[1]] = None
            whole.append(minor)
    kept = list(minors)
    if any(cannot_vanish(g, minor, known) for minor in kept):
        return RankLoss(True, ())
    gram = normalise(g, g.sum([g.power(minor, 2) for minor in whole]), 200)
    if cannot_vanish(g, gram, known) or cannot_vanish_together(g, kept, known):
        return RankLoss(True, ())
    if system.rotations and cannot_vanish_together(g, _unturned(system, gram, whole), known):
        return RankLoss(True, ())
    shared, rest = _split_shared(g, kept, known)
    return RankLoss(False, (shared,) if cannot_vanish_together(g, rest, known) else tuple(kept))


def find_lost_factors(system: System) -> frozenset[Node]:
    """The factors whose zeros are all the places where the rank is lost; none where it is lost otherwise, or where nobody knows."""
    loss = find_rank_loss(system)
    alone = loss.regular is False and len(loss.minors) == 1
    return frozenset(_factors(system.graph, loss.minors[0])) if alone else frozenset()


def find_vanishing_factors(system: System) -> list[Node]:
    """What all coefficients of one constraint share and what may vanish, without powers: there it says nothing.

    No measure that compares a constraint with its own size sees these places.
    """
    found = dict[Node, None]()
    for row in rows_in_base(system, system.constraints):
        found |= dict.fromkeys(_vanishing_shared(system, row))
    return list(found)


def find_vanishing_rows(system: System) -> list[tuple[Node, ...]]:
    """Constraints whose coefficients may all vanish at one place, though they share no factor: x y' - y x' = 0 where x = y = 0.

    There no part of them tells by its sign, nor by its size against that of the others.  Where that hangs on many coordinates
    nothing is said.
    """
    g, known, found = system.graph, intervals(system), list[tuple[Node, ...]]()
    for row in rows_in_base(system, system.constraints):
        entries = tuple(node for node in row if node != g.zero)
        several = len(entries) > 1 and _may_vanish_together(system, entries, known)
        if several and not _vanishing_shared(system, entries):
            found.append(entries)
    return found


def _may_vanish_together(system: System, entries: Sequence[Node], known: Mapping[Node, Interval]) -> bool:
    """Whether a few coordinates can make all entries zero; most often two of them, a sine and a cosine, tell that none can."""
    g, moving = system.graph, system.graph.mask((*system.q, system.t))
    groups: dict[int, list[Node]] = {}
    for entry in entries:
        groups.setdefault(g.deps[entry] & moving, []).append(entry)
    if any(m.bit_count() == 1 and cannot_vanish_together(g, group, known) for m, group in groups.items()):
        return False
    whole = reduce(or_, groups)
    if not 0 < whole.bit_count() <= _FEW_COORDINATES or any(cannot_vanish(g, entry, known) for entry in entries):
        return False
    held = [form.equation for form in system.constraints if form.equation is not None]
    held = [node for node in held if not g.deps[node] & moving & ~whole]
    return not cannot_vanish_together(g, [*entries, *held], known)


def find_vanishing_minors(system: System) -> list[Node]:
    """The same of the maximal minors of several constraints: there they do not say as much as they are."""
    if system.l < 2:
        return []  # that of one constraint are its coefficients
    return _vanishing_shared(system, find_rank_loss(system).minors)


def _vanishing_shared(system: System, nodes: Sequence[Node]) -> list[Node]:
    """The factors that all of the nodes but zeros have and that may vanish, also where they were multiplied out.

    Those are sought where nothing tells that what is left, without the factors in sight, cannot vanish.
    """
    g, known = system.graph, intervals(system)
    entries = [node for node in nodes if node != g.zero]
    if not entries or any(cannot_vanish(g, entry, known) for entry in entries):
        return []
    parts = [_factors(g, entry) for entry in entries]
    shared = reduce(and_, parts)
    found = [factor for base in sorted(shared) for factor in (_apart(g, base) if g.op[base] == ADD else [base])]
    rest = [g.product(g.power(base, k) for base, k in (own - shared).items()) for own in parts]
    if not cannot_vanish(g, normalise(g, g.sum([g.power(x, 2) for x in rest]), _FEW_TERMS), known):
        found += find_shared(g, rest)
    return [base for base in found if not cannot_vanish(g, base, known)]


def _apart(graph: Graph, base: Node) -> list[Node]:
    """The factors of a sum: where two of them vanish in one step, their product has one sign before and after it."""
    return find_shared(graph, [base]) or [base]


def _split_shared(graph: Graph, minors: Sequence[Node], known: Mapping[Node, Interval]) -> tuple[Node, list[Node]]:
    """The factors that all minors have and that may vanish, as a product without powers, and what is left of the minors."""
    g = graph
    parts = [_factors(g, minor) for minor in minors]
    shared = reduce(and_, parts)
    for base in [base for base in shared if cannot_vanish(g, base, known)]:
        del shared[base]
    rest = [g.product(g.power(base, k) for base, k in (own - shared).items()) for own in parts]
    return g.product(sorted(shared)), rest


def _factors(graph: Graph, node: Node) -> Counter[Node]:
    """Factors of a product with their exponents; its sign and its number are left out."""
    found, stack = Counter[Node](), [(node, 1)]
    while stack:
        top, times = stack.pop()
        top = graph.split_coefficient(top)[1]
        if graph.op[top] == MUL:
            stack += [(graph.a[top], times), (graph.b[top], times)]
        elif graph.op[top] == POW and graph.b[top] > 0:
            stack.append((graph.a[top], times * graph.b[top]))
        elif top != graph.one:
            found[top] += times
    return found


def _unturned(system: System, gram: Node, minors: Sequence[Node]) -> list[Node]:
    """The minors where the bodies have not turned, as far as their turns do not change the sum of the squares (rows and columns
    of R have one length everywhere).
    """
    g, start = system.graph, dict[Node, Node]()
    for rotation in system.rotations:
        if not any(_slopes(system, gram, rotation.places[1:])):
            start |= dict(zip((system.q[k] for k in rotation.places), (g.one, g.zero, g.zero, g.zero), strict=True))
    return substitute(g, minors, start, named=False)


def never_changes(system: System, node: Node) -> bool:
    """Whether the node has one value wherever the quaternions keep their length."""
    g = system.graph
    if g.depends(node, g.deps[system.t]):
        return False
    lengths = {rotation.places[0] for rotation in system.rotations}
    return not any(_slopes(system, node, [k for k in range(system.n) if k not in lengths]))


def _slopes(system: System, node: Node, places: Sequence[int]) -> list[bool]:
    """Whether the node changes along each of these vectors of the base."""
    g, slopes = system.graph, list[Node]()
    for k in places:
        unit = [g.one if j == k else g.zero for j in range(system.n)]
        slopes += tangent(g, [node], along(system, from_base(system, unit, system.rotations)))
    return [not zero for zero in are_zero(g, slopes)]


def smallest_singular_value(system: System, place: dict[Node, float]) -> float:
    """sigma_min of the constraint matrix at a state (``place`` gives t, q and p their values); infinite without constraints.

    The square root of the smallest eigenvalue of A A^T, by Jacobi's rotations; zero to rounding where the rank is lost.
    """
    if not system.constraints:
        return math.inf
    flat = [a for form in system.constraints for a in form.coefficients]
    values = [float(x) for x in evaluate(system.graph, flat, place)]
    rows = [values[k * system.n : (k + 1) * system.n] for k in range(system.l)]
    gram = [[sum(x * y for x, y in zip(r, s, strict=True)) for s in rows] for r in rows]
    return math.sqrt(max(0.0, min(symmetric_eigenvalues(gram))))
