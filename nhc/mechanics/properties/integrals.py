"""Integrals f(q, t) = const of integrable constraints, in elementary functions.

The integrals are the functions that the allowed motions leave constant: e_mu(f) = 0 for every free direction and X_0(f) = 0 for
the drift.  Among candidate functions (coordinates, the functions and named definitions that the constraints are made of,
products of coordinates, each also times a parameter of the constraints; antiderivatives of the constraints' terms) all constant
combinations with this property are found by exact linear algebra at random points of a prime field.  That finds integrals of single
constraints and of combinations alike, with no integrating factor; each is tested again modulo another prime.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import combinations, combinations_with_replacement

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.modular import Unlucky, are_zero
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.relations import find_relations, without
from nhc.algebra.graph import ADD, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.walks import reachable
from nhc.mechanics.frame import Frame, coordinate_frame
from nhc.mechanics.properties.candidates import Candidate, combine
from nhc.mechanics.properties.leaf import Leaf, has_values, leaf_of, parts_on, rank_on
from nhc.mechanics.properties.named import LONG, is_cut, named_text
from nhc.mechanics.properties.primitives import find_primitives
from nhc.mechanics.properties.separated import find_separated
from nhc.mechanics.system import Form, System
from nhc.records import record

_MOST = 150  # candidates
_PARTNERS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh"}  # up to a factor, integrals of each other
_SPARE = 8  # equations more than candidates
_LONGEST, _WHOLE = 160, 100_000  # characters of a text that is still worth printing; of one that a program reads


@record
class PositionIntegral:
    """``node`` = const on every motion; ``names`` are the constraints that imply it (several: a combination of them).

    ``text`` is cut where it is too long to be read, ``whole`` is not.
    """

    node: Node
    text: str
    whole: str
    names: tuple[str, ...]


def find_position_integrals(
    system: System, frame: Frame, hidden: int, closed: Sequence[str]
) -> tuple[PositionIntegral, ...]:
    """Up to ``hidden`` functionally independent integrals; fewer where the rest is not among the candidates.

    ``closed`` are names of constraints that are integrable by themselves.
    """
    found: list[PositionIntegral] = []
    leaf = leaf_of(system, [x for e in (*frame.free_vectors, frame.drift) for x in e])
    held = [(form.equation, form.name) for form in system.constraints if form.equation is not None]
    for k in _new(system, leaf, [], [node for node, _ in held]):
        node, name = held[k]
        found.append(PositionIntegral(node, *_texts(system, node, declared=True), (name,)))
    for candidates in _stages(system, closed):
        if len(found) >= hidden:
            break
        nodes = _search(system, leaf, frame, candidates)
        nodes = [nodes[k] for k in _new(system, leaf, [f.node for f in found], nodes, hidden)]
        for node, names in zip(nodes, _users(system, leaf, nodes), strict=True):
            found.append(PositionIntegral(node, *_texts(system, node), names))
    own = _find_own(system, closed, {f.names for f in found})
    if own:  # they stand in for combinations with others
        every = sorted([*found, *own], key=lambda f: len(f.names) > 1)
        found = [every[k] for k in _new(system, leaf, [], [f.node for f in every], hidden)]
    return tuple(found)


def _find_own(system: System, closed: Sequence[str], known: Collection[tuple[str, ...]]) -> list[PositionIntegral]:
    """Integrals of single constraints of which none is known: among all positions, for at those that the spec's holonomic
    constraints allow an integral is told from combinations with these by nothing.

    With rotations a form alone is no system: the lengths of the quaternions stand beside it.
    """
    own = list[PositionIntegral]()
    for form in system.constraints if system.l > 1 and not system.rotations else ():
        if form.name not in closed or form.equation is not None or (form.name,) in known:
            continue
        part = replace(system, constraints=(form,))
        nonzero = [k for k, a in enumerate(form.coefficients) if a != system.graph.zero]
        if nonzero:
            solved = min(nonzero, key=lambda k: len(reachable(system.graph, [form.coefficients[k]])))
            own += find_position_integrals(part, coordinate_frame(part, (solved,)), 1, (form.name,))
    return own


def tell_integral(integral: PositionIntegral, declared: Collection[str]) -> str:
    """An integral, marked as in a derivation, and where it comes from; what is declared is zero, not just some constant."""
    names = [f"`{name}`" for name in integral.names]
    own = len(names) == 1 and integral.names[0] in declared
    if is_cut(integral.text):  # the spec has it in the user's words
        return f"that of {names[0]}, as declared" if own else f"{LONG} (from {' and '.join(names)})"
    if own:
        return f"${integral.text} = 0$ (`{integral.names[0]}`, as declared)"
    return f"${integral.text} = const$ (from {' and '.join(names)})"


def quote_integral(integral: PositionIntegral) -> str:
    """An integral as an equation in a message."""
    return f"{LONG}, which `check --json` has whole" if is_cut(integral.text) else f"`{integral.text} = const`"


def _texts(system: System, node: Node, *, declared: bool = False) -> tuple[str, str]:
    """Without its number in front, and its sign, unless the spec has them."""
    plain = node if declared else system.graph.split_coefficient(node)[1]
    text = named_text(system, plain, _LONGEST)
    return text, named_text(system, plain, _WHOLE) if is_cut(text) else text


def _new(system: System, leaf: Leaf, known: Sequence[Node], nodes: Sequence[Node], most: int = 0) -> list[int]:
    """Numbers of the nodes that are independent of those known and of each other, up to ``most`` with those known (0: all)."""
    g, chosen = system.graph, list[int]()
    slopes = [gradient(g, x, (*system.q, system.t)) for x in (*known, *nodes)]
    first = len(known)
    if first + len(nodes) <= (most or len(slopes)) and rank_on(g, slopes, leaf) == len(slopes):
        return list(range(len(nodes)))
    for k in range(len(nodes)):
        if most and first + len(chosen) >= most:
            break
        rows = [*slopes[:first], *(slopes[first + i] for i in (*chosen, k))]
        if rank_on(g, rows, leaf) == len(rows):
            chosen.append(k)
    return chosen


def _users(system: System, leaf: Leaf, nodes: Sequence[Node]) -> list[tuple[str, ...]]:
    """Names of the constraints that each node's differential needs: it is no combination of the others."""
    g, forms = system.graph, system.constraints
    rows = [[*form.coefficients, form.constant] for form in forms]
    rows += [list(gradient(g, node, (*system.q, system.t))) for node in nodes]
    parts = parts_on(g, rows, len(forms), leaf) if nodes else []
    return [tuple(form.name for form, used in zip(forms, part, strict=True) if used) for part in parts]


# --- candidates -------------------------------------------------------------------------------------------


def _stages(system: System, closed: Sequence[str]) -> list[list[Candidate]]:
    """Candidate sets, the small ones first; those at the end are for constraints that are integrable by themselves."""
    g = system.graph
    coordinates = [*system.q, system.t] if _contains_time(system) else list(system.q)
    products = [g.mul(x, y) for x, y in combinations_with_replacement(coordinates, 2)]
    parameters = [s for s in system.p if any(g.depends(x, g.deps[s]) for x in _entries(system.constraints))]
    outputs = [node for _, node in system.outputs if not g.depends(node, g.mask(system.v))]
    scaled = [g.mul(s, x) for s in parameters for x in coordinates]
    pairs = [g.mul(g.mul(s, r), x) for s, r in combinations_with_replacement(parameters, 2) for x in coordinates]
    atoms = _functions(system, system.constraints)
    stages = [
        [*coordinates, *products],
        [*coordinates, *outputs],
        [*coordinates, *scaled],
        [*coordinates, *atoms],
        [*coordinates, *scaled, *(g.mul(s, x) for s in parameters for x in (*atoms, *_partners(g, atoms)))],
        [*coordinates, *scaled, *pairs],
        [*coordinates, *scaled, *products, *(g.mul(s, x) for s in parameters for x in products)],
        [*coordinates, *find_primitives(system)],
        [*coordinates, *find_separated(system)],
        [*coordinates, *scaled, *_elementary(g, coordinates)],
        [*coordinates, *scaled, *(g.mul(s, x) for s in (g.one, *parameters) for x in _polar(system))],
    ]
    for form in system.constraints:
        if form.name not in closed:
            continue
        own = [x for x, a in zip(coordinates, (*form.coefficients, form.constant), strict=False) if a != g.zero]
        inside = [x for x in _functions(system, [form]) if not g.deps[x] & g.mask(coordinates) & ~g.mask(own)]
        inside += _partners(g, inside)
        held = [s for s in parameters if any(g.depends(x, g.deps[s]) for x in _entries([form]))]
        stages.append([*own, *inside, *(g.mul(s, x) for s in held for x in inside)])
        stages.append([*own, *inside, *(g.mul(x, y) for x in own for y in inside), *products])
    return [[Candidate("", node) for node in _unique(g, stage)[:_MOST]] for stage in stages]


def _partners(g: Graph, functions: Sequence[Node]) -> list[Node]:
    return [g.function(_PARTNERS[g.op[x]], g.a[x]) for x in functions if g.op[x] in _PARTNERS]


def _elementary(g: Graph, coordinates: Sequence[Node]) -> list[Node]:
    """Logarithms, sines, cosines and quotients of the coordinates, and their products with coordinates: for small systems.

    Logarithms are those of absolute values, which are constant wherever the rates are: y' = y holds at negative y, too.
    """
    if len(coordinates) > 5:
        return []
    waves = [g.function(name, x) for x in coordinates for name in ("sin", "cos")]
    logs = [g.function("log", g.function("abs", x)) for x in (*coordinates, *waves)]
    quotients = [g.div(x, y) for x in (g.one, *coordinates) for y in coordinates if x != y]
    return [*waves, *logs, *quotients, *(g.mul(x, wave) for x in coordinates for wave in waves)]


def _polar(system: System) -> list[Node]:
    """Angle and logarithm of the radius in the planes of two coordinates that the constraints' coefficients hold both: of screws,
    spirals and what moves about an axis, in Cartesian coordinates.
    """
    g, found, entries = system.graph, list[Node](), _entries(system.constraints)
    held = [x for x in system.q if any(g.depends(entry, g.deps[x]) for entry in entries)]
    for x, y in combinations(held, 2):
        found += [g.function("atan2", y, x), g.function("log", g.add(g.mul(x, x), g.mul(y, y)))]
    return found


def _entries(forms: Sequence[Form]) -> list[Node]:
    return [x for form in forms for x in (*form.coefficients, form.constant)]


def _contains_time(system: System) -> bool:
    g = system.graph
    return any(g.depends(x, g.deps[system.t]) for x in _entries(system.constraints)) or any(
        form.constant != g.zero for form in system.constraints
    )


def _functions(system: System, forms: Sequence[Form]) -> list[Node]:
    """Functions of position that the forms are made of: sin, sqrt and their like, and the spec's definitions; short ones first."""
    g = system.graph
    allowed = g.mask((*system.q, system.t))
    found = [
        node
        for node in reachable(g, _entries(forms))
        if g.depends(node, allowed)
        and not g.depends(node, g.mask(system.v))
        and (node in g.labels or g.op[node] not in (ADD, MUL, NEG, POW, SYM))
    ]
    return sorted(found, key=lambda node: (len(reachable(g, [node])), node))


def _unique(graph: Graph, nodes: Sequence[Node]) -> list[Node]:
    return [node for node in dict.fromkeys(nodes) if graph.value(node) is None]


# --- the search -------------------------------------------------------------------------------------------


def _search(system: System, leaf: Leaf, frame: Frame, candidates: Sequence[Candidate]) -> list[Node]:
    """Constant combinations that every allowed motion leaves constant, less those that are constants anyway."""
    g, places = system.graph, (*system.q, system.t)
    if leaf.steps:
        candidates = [c for c in candidates if has_values(g, leaf, gradient(g, c.node, places))]
    nodes, width = [c.node for c in candidates], len(candidates)
    along = [tangent(g, nodes, dict(zip(system.q, e, strict=True))) for e in frame.free_vectors]
    along.append(tangent(g, nodes, {**dict(zip(system.q, frame.drift, strict=True)), system.t: g.one}))
    slopes = [tangent(g, nodes, {x: g.one}) for x in places]
    prime = primes_of(g)[0]
    rows = _rows(g, leaf, along, width)
    constant = find_relations(rows, width, prime)
    if not constant:
        return []
    trivial = find_relations(_rows(g, leaf, slopes, width), width, prime)
    found = []
    for vector in without(constant, trivial):
        node = combine(g, [g.number(k) for k in vector], candidates)
        rates = [tangent(g, [node], dict(zip(system.q, e, strict=True)))[0] for e in frame.free_vectors]
        rates += tangent(g, [node], {**dict(zip(system.q, frame.drift, strict=True)), system.t: g.one})
        if _vanish(g, leaf, rates):
            found.append(node)
    return found


def _vanish(graph: Graph, leaf: Leaf, rates: Sequence[Node]) -> bool:
    """Whether all rates are zero where the constraints allow positions; tested modulo another prime than they were found with."""
    if not leaf.steps:
        return all(are_zero(graph, rates))
    return rank_on(graph, [rates], leaf, primes_of(graph)[1]) == 0


def _rows(graph: Graph, leaf: Leaf, directions: Sequence[Sequence[Node]], width: int) -> list[list[int]]:
    """Values of every candidate's derivatives at enough points: one row for each direction and point."""
    rows: list[list[int]] = []
    flat = [node for row in directions for node in row]
    for _, point in draw_points(
        graph, flat, primes_of(graph)[0], range(7_000_003, 7_000_003 + MOST_DRAWS), settle=leaf.settling
    ):
        try:
            values = point.evaluate(flat)
        except Unlucky:
            continue
        rows += [values[k : k + width] for k in range(0, len(values), width)]
        if len(rows) >= width + _SPARE * len(directions):
            return rows
    raise Unlucky
