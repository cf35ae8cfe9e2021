"""The smallest exact model of what a scene needs: which entries of the state it keeps, and why it leaves out the others.

An entry stays when what is needed depends on it, directly or through the rates of entries that stay.  An entry that stays but whose
rate vanishes identically is a constant of the motion and becomes a parameter (Routh, where it is a momentum).  What stays does not
depend on what is left out, so any value may stand for the latter in its equations; the one that makes them short is taken.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.exact.modular import FieldPoint, Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.signs import MOST, Signs, may_hold, points_for
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import count
from nhc.language.spec import Scene
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.dependence import Dependence, find_dependence
from nhc.mechanics.flow import Flow, flow_of, solve_at
from nhc.mechanics.reduction.needs import Wanted, list_needs
from nhc.mechanics.reduction.quadrature import Given, Integral, close_integrals, find_integrals, solve_closed
from nhc.records import record

_DRAWS = 60
_FAR = 100  # durations of the scene, between t = 0 and its start


@record
class Omission:
    """An entry of the state that the scene's model does not hold, with the reason in words."""

    name: str
    reason: str


@record
class Reduction:
    """``kept`` and ``constants`` are indices into the full state ``names``; ``fixed`` has the values that stand for the rest.

    ``outputs`` are the columns of the scene's needs; on ``driving`` entries others that are kept depend; ``regular`` says that
    no guard of the frame can vanish any more.  ``undecided``: all is kept, for nothing could be told of what is left out.
    """

    equations: Equations
    formulation: Formulation
    names: tuple[str, ...]
    kept: tuple[int, ...]
    constants: tuple[int, ...]
    integrals: tuple[Integral, ...]
    left: tuple[Omission, ...]
    fixed: tuple[tuple[Node, Node], ...]
    outputs: tuple[Wanted, ...]
    driving: tuple[int, ...]
    regular: bool
    undecided: bool = False

    @property
    def state(self) -> tuple[str, ...]:
        """The names of the entries that are kept."""
        return tuple(self.names[i] for i in self.kept)


def reduce_equations(
    equations: Equations,
    formulation: Formulation,
    scene: Scene,
    known: Mapping[Node, Interval],
    folded: Mapping[Node, Node] | None = None,
    closed: Sequence[Node] = (),
) -> Reduction:
    """The reduction of one formulation's equations to what the scene needs.

    ``known`` bounds parameters and coordinates; ``folded`` are parameters whose values are put in first; ``closed`` integrals of
    the constraints.

    Raises:
        nhc.algebra.exact.modular.Unlucky: the motion is singular everywhere.
    """
    columns = list_needs(equations, scene)
    flow, nodes = flow_of(equations), [c.node for c in columns]
    if folded:
        flow, nodes = _fold(flow, nodes, folded)
    dependence = find_dependence(flow, nodes)
    closure = dependence.closure(range(len(nodes)))
    constants = [i for i in sorted(closure) if dependence.still[i]]
    kept = [i for i in sorted(closure) if not dependence.still[i]]
    if not kept:  # a model has a state, be it one that stands still
        kept, constants = (constants[:1] or [0]), constants[1:]
    fixed, regular = _fix(flow, nodes, [*kept, *constants], known, equations.guards)
    driving = tuple(i for i in kept if any(i in dependence.rates[j] for j in kept if j != i))
    given = Given([flow.y[i] for i in constants], driving, known, _is_far(scene))
    integrals = _integrate(flow, kept, fixed, given, closed)
    for integral in integrals:
        kept.remove(integral.index)
        fixed[flow.y[integral.index]] = flow.graph.add(integral.symbol, integral.rest)
    return Reduction(
        equations=equations,
        formulation=formulation,
        names=flow.names,
        kept=tuple(kept),
        constants=tuple(constants),
        integrals=tuple(integrals),
        left=tuple(_reasons(flow, dependence, kept, constants, integrals)),
        fixed=tuple({**(folded or {}), **fixed}.items()),
        outputs=tuple(columns),
        driving=driving,
        regular=regular,
    )


def keep_everything(equations: Equations, formulation: Formulation, scene: Scene) -> Reduction:
    """The model of a scene that leaves nothing out: for motions that no point of the prime field tells anything about."""
    names = flow_of(equations).names
    every = tuple(range(len(names)))
    columns = tuple(list_needs(equations, scene))
    return Reduction(
        equations, formulation, names, every, (), (), (), (), columns, every, regular=False, undecided=True
    )


def _is_far(scene: Scene) -> bool:
    """Whether it starts so far from t = 0 that doubles tell its times with two digits less."""
    begin, end = scene.time
    return abs(begin) > _FAR * (end - begin)


def _integrate(
    flow: Flow, kept: Sequence[int], fixed: Mapping[Node, Node], given: Given, closed: Sequence[Node]
) -> list[Integral]:
    """Coordinates that follow from others; one entry of the state stays in any case."""
    n = flow.system.n
    held = [i for i in kept if i < n]
    rates = dict(zip(held, substitute(flow.graph, [flow.velocities[i] for i in held], fixed), strict=True))
    w = [flow.y[i] for i in kept if i >= n]
    found = find_integrals(flow.system, rates, w, given)
    found += solve_closed(flow.system, closed, held, found, given)
    if len(found) == len(kept):
        g, first = flow.graph, flow.graph.mask([found[0].symbol])
        found = found[:-1] if any(g.depends(integral.rest, first) for integral in found) else found[1:]
    return close_integrals(flow.system, found)


def _fold(flow: Flow, nodes: Sequence[Node], folded: Mapping[Node, Node]) -> tuple[Flow, list[Node]]:
    g, size = flow.graph, len(flow.unknowns)
    new = substitute(g, [*flow.velocities, *flow.flat, *nodes], folded)
    n = len(flow.velocities)
    matrix = tuple(tuple(new[n + k * size : n + (k + 1) * size]) for k in range(size))
    start = n + size * size
    right = tuple(new[start : start + size])
    return Flow(flow.equations, flow.y, tuple(new[:n]), matrix, right, flow.unknowns), new[start + size :]


def _reasons(
    flow: Flow,
    dependence: Dependence,
    kept: Sequence[int],
    constants: Sequence[int],
    integrals: Sequence[Integral],
) -> list[Omission]:
    found, closed = [], {integral.index: integral for integral in integrals}
    for i, name in enumerate(flow.names):
        if i in kept:
            continue
        users = [flow.names[j] for j, rates in enumerate(dependence.rates) if i in rates and j != i]
        if i in closed:
            symbol = flow.graph.symbol_of(closed[i].symbol)
            assert symbol is not None
            reason = f"integrated: {closed[i].text}, where {symbol.name} is a parameter that the scene's start sets"
        elif i in constants:
            reason = "constant of the motion: it is a parameter, which the scene's start sets"
        elif not users and i < flow.system.n:
            reason = "cyclic and not needed: nothing depends on it"
        elif not users:
            reason = "decoupled and not needed: nothing else depends on it"
        else:
            reason = f"decoupled: only what is left out depends on it ({', '.join(users)})"
        found.append(Omission(name, reason))
    return found


# --- what stands for the entries that are left out --------------------------------------------------------------


@record
class _Model:
    """What the reduced equations are made of: rates of the held coordinates, matrix @ unknowns = right, needs, guards, and the
    ``scales`` that these are compared with, which may have poles of their own.
    """

    unknowns: tuple[Node, ...]
    rates: tuple[int, ...]
    velocities: tuple[Node, ...]
    matrix: tuple[Node, ...]
    right: tuple[Node, ...]
    needs: tuple[Node, ...]
    guards: tuple[Node, ...]
    scales: tuple[Node, ...]

    @property
    def nodes(self) -> tuple[Node, ...]:
        return (*self.velocities, *self.matrix, *self.right, *self.needs, *self.guards, *self.scales)

    def put(self, flow: Flow, symbol: Node, value: Node) -> _Model:
        """The model with a value in place of a symbol.

        Raises:
            ZeroDivisionError: it is singular there.
        """
        parts = (self.velocities, self.matrix, self.right, self.needs, self.guards, self.scales)
        new = iter(substitute(flow.graph, self.nodes, {symbol: value}))
        return _Model(self.unknowns, self.rates, *(tuple(next(new) for _ in part) for part in parts))

    def observe(self, point: FieldPoint) -> list[int]:
        """Residues of everything that is held or needed.

        Raises:
            Unlucky: the model is singular at this point.
        """
        size = len(self.unknowns)
        flat = point.evaluate([*self.matrix, *self.right, *self.guards])
        count = size * (size + 1)
        if not all(flat[count:]):
            raise Unlucky
        solved = solve_at(size, flat[:count], point.prime)
        found = point.evaluate([*self.velocities, *self.needs], dict(zip(self.unknowns, solved, strict=True)))
        return [*(solved[k] for k in self.rates), *found]

    def weak(self, flow: Flow, known: Mapping[Node, Interval]) -> int:
        """How many guards may vanish somewhere."""
        return sum(not cannot_vanish(flow.graph, node, known) for node in self.guards)


def _fix(
    flow: Flow,
    nodes: Sequence[Node],
    held: Sequence[int],
    known: Mapping[Node, Interval],
    guards: Sequence[tuple[Node, Node]],
) -> tuple[dict[Node, Node], bool]:
    """Values for all entries but the held ones, velocities first; and whether the guards cannot vanish with them.

    Once some have their values the equations need not contain others: 2 (R_1^2 + R_2^2)/|R|^2 is 0 without R_1 and R_2, whatever
    R_0 is.  These are free, but for poles of what was there at first.

    Raises:
        Unlucky: no values are found.
    """
    n, g = flow.system.n, flow.graph
    model = first = _Model(
        flow.unknowns,
        tuple(i - n for i in held if i >= n),
        tuple(flow.velocities[i] for i in held if i < n),
        tuple(x for row in flow.matrix for x in row),
        flow.right,
        tuple(nodes),
        tuple(value for value, _ in guards),
        tuple(scale for _, scale in guards),
    )
    fixed, free = dict[Node, Node](), list[Node]()
    for i in reversed(range(len(flow.y))):
        if i in held:
            continue
        if any(g.depends(node, g.deps[flow.y[i]]) for node in model.nodes):
            fixed[flow.y[i]], model = _put_best(flow, model, i, known)
        else:
            free.append(flow.y[i])
    return fixed | _put_free(g, first, fixed, free), not model.weak(flow, known)


def _put_free(graph: Graph, model: _Model, fixed: Mapping[Node, Node], free: Sequence[Node]) -> dict[Node, Node]:
    """One value for entries that may have any, with which, and with those of the others, the whole model has no pole."""
    for value in (0, 1, 2) if free else ():
        found = dict.fromkeys(free, graph.number(value))
        with suppress(ZeroDivisionError):
            substitute(graph, model.nodes, {**fixed, **found})
            return found
    if free:
        raise Unlucky
    return {}


def _put_best(flow: Flow, model: _Model, i: int, known: Mapping[Node, Interval]) -> tuple[Node, _Model]:
    """The value for one entry that leaves the fewest guards and the shortest expressions; 1 and 2 where 0 is singular."""
    g, symbol = flow.graph, flow.y[i]
    first = [g.zero, g.div(g.pi(), g.number(2))] if i < flow.system.n else [g.zero]
    for values in (first, [g.one], [g.number(2)]):
        found = []
        for k, value in enumerate(values):
            try:
                made = model.put(flow, symbol, value)
            except ZeroDivisionError:
                continue
            if _agree(flow, model, made):
                found.append((made.weak(flow, known), count(g, made.nodes), k, value, made))
        if found:
            return min(found)[3:]
    raise Unlucky


def _agree(flow: Flow, before: _Model, after: _Model) -> bool:
    """Whether the second model is regular and has the rates and needs of the first, at as many points as their signs need."""
    nodes = [*before.nodes, *after.nodes]
    needed, agreed, unlucky = _count_points(flow.graph, before, after), 0, 0
    primes = primes_of(flow.graph)
    for draw in range(_DRAWS * needed):
        found = []
        for model in (before, after):
            point = FieldPoint(flow.graph, 9_000_011 + draw, primes[(1 + agreed) % len(primes)])
            try:
                point.prepare(nodes)
                found.append(model.observe(point))
            except Unlucky:
                break
        if len(found) < 2:
            unlucky += 1
            if unlucky == _DRAWS:
                return False
            continue
        if found[0] != found[1]:
            return False
        agreed, unlucky = agreed + 1, 0
        if agreed == needed:
            return True
    return False


def _count_points(graph: Graph, before: _Model, after: _Model) -> int:
    """How many points tell whether two models agree."""
    nodes = [*before.nodes, *after.nodes]
    if not may_hold(graph, nodes):
        return 1
    signs = Signs(graph, nodes, later=graph.mask(before.unknowns))
    signs.solve([*before.matrix, *after.matrix], [*before.right, *after.right], before.unknowns)
    observed = [node for model in (before, after) for node in (*model.unknowns, *model.velocities, *model.needs)]
    degree = signs.degree(observed)
    return points_for(min(degree, MOST), 1)
