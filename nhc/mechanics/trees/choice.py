"""Whether a system is solved from the leaves of a tree: decided from the tree, before any matrix is assembled."""

from __future__ import annotations

import random
from collections.abc import Sequence

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import SYM, Graph, Node
from nhc.algebra.rewriting.related import count_angles
from nhc.algebra.walks import count, reachable
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.motion import Motion
from nhc.mechanics.system import System
from nhc.mechanics.trees.bodies import read_bodies
from nhc.mechanics.trees.chain import Chain, find_chain
from nhc.mechanics.trees.forces import lift_forces
from nhc.mechanics.trees.tree import Elimination

CHAINED = 4
"""Operations that the longer way from pivot to pivot of a tree is worth."""
ANGLE = 30
"""Operations that a sine with its cosine takes the time of."""
SUM = 6
"""Operations of a sine and cosine by the addition theorems."""
_BOTH = 12
"""Rates up to which a short start alone is no reason to look for no other recursion, and masses are compared by numbers."""
_SHORT = 30
"""Operations for each rate from which an elimination starts, and those it comes to, up to which no other is looked for."""
_MANIFOLD = 2
"""How many times as much one recursion may start from as the other to be solved."""
_MORE = 1.3
"""How many times as much one recursion of bodies may start from as another to be solved, too."""
_ENTRY, _CARRIED = 8, 4
"""Operations for an entry of the mass matrix with its share of the forces, and for a rate in a form that holds it by another,
beside those of the coefficients and of the forces on the rates, which both ways have."""

_ROUNDING = 1e-9  # of the diagonal, below which an entry of the mass matrix is none


def work(graph: Graph, nodes: Sequence[Node]) -> int:
    """Operations of the nodes; a sine and cosine of one angle are as many as ``ANGLE``, of a sum of others as many as ``SUM``."""
    called, related = count_angles(graph, nodes)
    return count(graph, nodes) + ANGLE * called + SUM * related


def tree_of(system: System, motion: Motion, kinetic: Kinetic, beside: Sequence[Node] = ()) -> Elimination | None:
    """The elimination along the tree; None where there is no recursion, or a pivot vanishes identically.

    Bodies that turn in space have others beside that of T's forms as they are written: of the bodies, on several axes.
    """
    written = find_chain(system, motion, kinetic)
    small = written is not None and _setting(written) <= _SHORT * len(motion.w)
    tree = _eliminate(written, beside) if small else None
    if tree is not None and (len(motion.w) > _BOTH or _is_short(tree)):
        return tree
    bodies = _chain_of_bodies(system, motion)
    if not bodies or small or written is None:
        return _shortest([tree or _eliminate(written, beside), *(_eliminate(chain, beside) for chain in bodies)])
    if _MANIFOLD * _setting(written) < _setting(bodies[0]):
        return _eliminate(written, beside) or _eliminate(bodies[0], beside)
    found = _shortest([_eliminate(chain, beside) for chain in bodies])
    if _MANIFOLD * _setting(bodies[0]) < _setting(written) and found is not None:
        return found
    return _shortest([_eliminate(written, beside), found])


def _is_short(tree: Elimination) -> bool:
    return count(tree.graph, tree.rates) <= _SHORT * len(tree.rates)


def _chain_of_bodies(system: System, motion: Motion) -> list[Chain]:
    """The recursions of bodies that start from little: on the axes of one body, or on those of each; else in space."""
    made = [find_chain(system, motion, spatial.kinetic, spatial) for spatial in read_bodies(system, motion)]
    found = sorted((chain for chain in made if chain is not None), key=_setting)
    return [chain for chain in found[:2] if _setting(chain) <= _MORE * _setting(found[0])]


def _shortest(trees: Sequence[Elimination | None]) -> Elimination | None:
    found = [tree for tree in trees if tree is not None]
    if len(found) < 2:
        return found[0] if found else None
    return min(found, key=lambda tree: work(tree.graph, tree.rates))


def _setting(chain: Chain) -> int:
    """Operations of what the elimination starts from."""
    coefficients = [a for terms in chain.definitions for a in terms.values()]
    return count(chain.graph, [*coefficients, *chain.turn, *chain.force])


def _eliminate(chain: Chain | None, beside: Sequence[Node]) -> Elimination | None:
    if chain is None:
        return None
    try:
        tree = Elimination(lift_forces(chain), beside)
    except ZeroDivisionError:
        return None
    return None if any(are_zero(tree.graph, [pivot for pivot, _ in tree.pivots])) else tree


def worthwhile_tree(system: System, motion: Motion, kinetic: Kinetic) -> Elimination | None:
    """The elimination along the tree, where it takes fewer operations than the matrix would."""
    if system.n > _BOTH:
        tree = tree_of(system, motion, kinetic)
        return tree if tree is not None and _is_worthwhile(tree, motion) else None
    written = find_chain(system, motion, kinetic)
    tree = _eliminate(written, ())
    if tree is None or not _is_worthwhile(tree, motion):
        return None  # both ways are compared when the other one is written out
    if written is not None and _setting(written) <= _SHORT * system.n and _is_short(tree):
        return tree
    return _shortest([tree, *(_eliminate(chain, ()) for chain in _chain_of_bodies(system, motion))])


def _is_worthwhile(tree: Elimination, motion: Motion) -> bool:
    return work(tree.graph, tree.rates) + CHAINED * len(motion.w) < dense_cost(tree.chain)


def dense_cost(chain: Chain) -> int:
    """Operations of mass matrix, right side and L D L^T, by which entries of the matrix are not zero, and which move.

    What consists of parameters alone costs nothing: it is computed before.
    """
    g, rates = chain.graph, chain.rates
    total = work(g, [*(a for terms in chain.definitions for a in terms.values()), *chain.force])
    reach = [1 << i for i in range(rates)]
    for terms in chain.definitions:
        mask = 0
        for c, a in terms.items():
            mask |= reach[c]
            if c >= rates and g.value(a) is None:
                total += _CARRIED * reach[c].bit_count()
        reach.append(mask)
    rows, moved = _pattern(chain, reach)
    total += _ENTRY * sum((moved[k] >> k).bit_count() for k in range(rates))
    for k in range(rates):
        total += _take_out(rows, moved, k)
    return total


def _pattern(chain: Chain, reach: Sequence[int]) -> tuple[list[int], list[int]]:
    """By rows of the mass matrix, as bits: the entries that are not zero, and those that the state moves.

    By numbers at two states: a wheel's inertia is the same however it has turned, which the rates that each form is made of (in
    ``reach``) do not tell.
    """
    size = range(chain.rates)
    states = _masses(chain) if chain.rates <= _BOTH else None
    if states is None:
        made = [1 << i for i in size]
        for a, b in chain.weights:
            for i in size:
                made[i] |= (reach[b] if reach[a] >> i & 1 else 0) | (reach[a] if reach[b] >> i & 1 else 0)
        return made, list(made)
    one, other = states
    scale = [max(abs(one[k, k]), abs(other[k, k])) if (k, k) in one else 0.0 for k in size]
    rows, moved = [1 << i for i in size], [0] * chain.rates
    for (i, j), value in one.items():
        small = _ROUNDING * (scale[i] * scale[j]) ** 0.5
        if max(abs(value), abs(other[i, j])) > small:
            rows[i] |= 1 << j
            rows[j] |= 1 << i
        if abs(value - other[i, j]) > small:
            moved[i] |= 1 << j
            moved[j] |= 1 << i
    return rows, moved


def _masses(chain: Chain) -> tuple[dict[tuple[int, int], float], dict[tuple[int, int], float]] | None:
    """Entries (i, j), i <= j, of the mass matrix at two states, for the same parameters; None where it has no value there."""
    g = chain.graph
    nodes = [*chain.weights.values(), *(a for terms in chain.definitions for a in terms.values())]
    order = reachable(g, nodes)
    fixed, draw = random.Random("parameters"), random.Random("states")
    symbols = sorted(node for node in order if g.op[node] == SYM)
    found = []
    values = {symbol: fixed.uniform(0.3, 1.3) for symbol in symbols}
    for _ in range(2):
        values.update((symbol, draw.uniform(0.3, 1.3)) for symbol in symbols if _moves(chain, symbol))
        try:
            found.append(_mass_of(chain, [float(x) for x in evaluate(g, nodes, values, order=order)]))
        except (ArithmeticError, ValueError, TypeError):
            return None
    return found[0], found[1]


def _mass_of(chain: Chain, numbers: Sequence[float]) -> dict[tuple[int, int], float]:
    """From the values of the weights and of the forms' coefficients, in their order."""
    flat = iter(numbers)
    weights = {key: next(flat) for key in chain.weights}
    forms: list[dict[int, float]] = [{i: 1.0} for i in range(chain.rates)]
    for terms in chain.definitions:
        made: dict[int, float] = {}
        for c in terms:
            a = next(flat)
            for i, b in forms[c].items():
                made[i] = made.get(i, 0.0) + a * b
        forms.append(made)
    mass: dict[tuple[int, int], float] = {}
    for (a, b), weight in weights.items():
        first, second = list(forms[a].items()), list(forms[b].items())
        for place, (i, x) in enumerate(first):
            own = weight * x
            for j, y in second[place:] if a == b else second:
                key = (i, j) if i <= j else (j, i)
                mass[key] = mass.get(key, 0.0) + own * y
    return mass


def _moves(chain: Chain, node: Node) -> bool:
    return bool(chain.graph.deps[node] & ~chain.parameters)


def _take_out(rows: list[int], moved: list[int], k: int) -> int:
    """Operations of one step of L D L^T on the entries that move; the patterns get what arises."""
    below = rows[k] >> (k + 1)
    width = below.bit_count()
    total = 1 + 5 * width if moved[k] >> k else 4 * width
    for i in range(k + 1, len(rows)):
        if rows[k] >> i & 1:
            rows[i] |= below << (k + 1)
            spread = rows[k] if moved[k] >> k & 1 or moved[k] >> i & 1 else moved[k]
            moved[i] |= spread >> (k + 1) << (k + 1)
            total += 2 * (spread >> i).bit_count()
    return total
