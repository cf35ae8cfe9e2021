"""Turns and shifts under which a motion's field looks the same: what a steady motion may go along.

A turn of space about a fixed axis multiplies a quaternion from the left, one about an axis of the body from the right, so both
are linear in e; angular velocities on the axes that turn are turned with them.  Coordinates, velocities and the components of an
angular velocity are turned two at a time, and each coordinate may be shifted: the headings of a car and its trailers together,
with x' and y' where the state has them.  A combination S y + s of such fields is a symmetry of y' = f(y) where
S f = (df/dy) (S y + s).  All combinations are found by exact linear algebra at random points of a prime field, with coefficients
that may depend on the parameters (gears turn by their radii); those that change what a sign is taken of are none.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import null_space
from nhc.algebra.exact.families import draw_parameters, find_families
from nhc.algebra.exact.modular import FieldPoint, Unlucky, are_zero
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.relations import find_relations
from nhc.algebra.graph import Node
from nhc.algebra.solving.linear import STEPPED
from nhc.algebra.walks import reachable
from nhc.mechanics.flow import Flow, jacobian_residues, solve_at
from nhc.mechanics.frame import Frame
from nhc.mechanics.rotations.rotation import Rotation

Generator = Mapping[tuple[int, int], Node]
"""S by its entries (row, column) over the state, functions of the parameters; s in the column after the last."""

_Simple = Mapping[tuple[int, int], Fraction]
_POINTS, _SPARE, _DRAWS = 3, 8, 400
_NEAR = 2  # x, y and z of a body stand side by side; pairs that do not are tried where these have no turn
_MOST = 120  # generators, the rank of whose defects costs the cube


def symmetries_of(flow: Flow, frame: Frame | None, rest: Sequence[int]) -> tuple[tuple[Generator, ...], ...]:
    """Larger and larger groups of what leaves the field of the entries ``rest`` as it is; none where nothing does.

    Turns of space, these with turns of bodies, and all of it with plane turns and shifts.  Turns of neighbours come first: those of
    all pairs together turn a free centre of mass against what moves about it, too, which says nothing.
    """
    turned = flow.system.rotations if frame is None else frame.turned
    of_space, of_bodies = (
        [_generator(flow, rotation, side, axis, rest) for rotation in turned for axis in range(3)] for side in (-1, 1)
    )
    turns = [*of_space, *of_bodies]
    near, far = ([*turns, *_plane(flow, rest, reach)] for reach in (_NEAR, flow.system.n))
    try:
        found = _groups(flow, rest, near, (len(of_space), len(turns), len(near)))
        if len(near) < len(far) <= _MOST and not any(column < len(flow.y) for one in found[-1] for _, column in one):
            found += _groups(flow, rest, far, (len(far),))
    except Unlucky:
        return ()
    return tuple(group for before, group in pairwise([(), *found]) if len(group) > len(before))


def _plane(flow: Flow, rest: Sequence[int], reach: int) -> list[_Simple]:
    """A shift of each coordinate; turns of coordinates, of their rates, of components of angular velocities, two at a time.

    ``reach``: how far apart two of a kind may stand.
    """
    n, one = flow.system.n, Fraction(1)
    names = {name: place for place, name in enumerate(flow.names)}
    quaternions = {place for rotation in flow.system.rotations for place in rotation.places}
    vectors = [i for i in range(n) if i not in quaternions]
    rates = [names.get(f"{flow.system.q_names[i]}'") for i in vectors]
    angular = [[names.get(w) for w in declared.velocities] for declared in flow.system.spec.rotations]
    kinds = [_among(vectors, rest), _among(rates, rest), *(_among(places, rest) for places in angular)]
    pairs = [(i, j) for kind in kinds for k, i in enumerate(kind) for j in kind[k + 1 : k + 1 + reach]]
    return [*({(i, len(flow.y)): one} for i in kinds[0]), *({(i, j): -one, (j, i): one} for i, j in pairs)]


def _among(places: Sequence[int | None], rest: Sequence[int]) -> list[int]:
    return [place for place in places if place is not None and place in rest]


def _generator(flow: Flow, rotation: Rotation, side: int, axis: int, rest: Sequence[int]) -> _Simple:
    """The turn of a rotation about an axis of space (``side`` -1) or of the body (1), on the entries ``rest``."""
    declared = next(r for r in flow.system.spec.rotations if r.name == rotation.name)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    e, half = rotation.places, Fraction(1, 2)
    names = {name: place for place, name in enumerate(flow.names)}
    rates = [names.get(f"{flow.system.q_names[place]}'") for place in e]
    entries = dict[tuple[int, int], Fraction]()
    for own in (list(e), [place for place in rates if place is not None]):
        if len(own) == len(e):
            entries[own[0], own[axis + 1]], entries[own[axis + 1], own[0]] = -half, half
            entries[own[i + 1], own[j + 1]], entries[own[j + 1], own[i + 1]] = side * half, -side * half
    if side == rotation.sign:  # body: w' = w x axis; space: w' = axis x w
        w = [names.get(name) for name in declared.velocities]
        for row, column, sign in ((i, j, side), (j, i, -side)):
            a, b = w[row], w[column]
            if a is not None and b is not None:
                entries[a, b] = Fraction(sign)
    return {(r, c): x for (r, c), x in entries.items() if r in rest and c in rest}


def _groups(
    flow: Flow, rest: Sequence[int], generators: Sequence[_Simple], sizes: Sequence[int]
) -> list[tuple[Generator, ...]]:
    """The symmetries among the first so many generators, for each size, by the same points.

    Raises:
        Unlucky: the field has no values at random points.
    """
    if not generators:
        return [() for _ in sizes]
    g, drawn = flow.graph, _Drawn(flow, rest, generators)
    parameters = [
        symbol for symbol in flow.system.p if any(g.deps[x] & g.deps[symbol] for x in (*flow.velocities, *flow.flat))
    ]
    here = draw_parameters(parameters, drawn.prime, 1)
    drawn.rows(here)  # tells which generators are idle
    found = []
    for size in sizes:
        used = [k for k in range(size) if k not in drawn.idle]
        many = len(null_space(drawn.columns(here, used), len(used), drawn.prime)) if used else 0
        every = [*drawn.columns(here, used), *drawn.columns({}, used)] if many else []
        vectors = [[g.number(x) for x in v] for v in find_relations(every, len(used), drawn.prime)] if many else []
        if len(vectors) < many:
            wider = find_families(g, parameters, partial(drawn.columns, used=used), len(used), drawn.prime)
            whole = [vector for vector in wider if vector is not None]
            vectors = whole if len(whole) == many else vectors
        made = [_combine(flow, [generators[k] for k in used], vector) for vector in vectors]
        found.append(tuple(one for one in made if one and _keeps_steps(flow, one)))
    return found


class _Drawn:
    """What generators do to the field at random points; ``idle`` are those that do nothing at any."""

    def __init__(self, flow: Flow, rest: Sequence[int], generators: Sequence[_Simple]) -> None:
        self._flow, self._rest, self._generators = flow, rest, generators
        self._known = dict[tuple[int, ...], list[list[int]]]()
        self.idle, self.prime = set(range(len(generators))), primes_of(flow.graph)[0]

    def columns(self, fixed: Mapping[Node, int], used: Sequence[int]) -> list[list[int]]:
        """The rows of some generators."""
        return [[row[k] for k in used] for row in self.rows(fixed)]

    def rows(self, fixed: Mapping[Node, int]) -> list[list[int]]:
        """The defects of the generators at some points more than they are, with these values of the parameters.

        Raises:
            Unlucky: the field has no values there.
        """
        key = tuple(fixed.values())
        if key in self._known:
            return self._known[key]
        flow, rest = self._flow, self._rest
        wanted = max(_POINTS, -(-(len(self._generators) + _SPARE) // max(len(rest), 1)))
        rows = list[list[int]]()
        for draw in range(_DRAWS):
            point = FieldPoint(flow.graph, 13_000_003 + draw, self.prime)
            try:
                point.evaluate([], fixed)
                columns, still = _defects(flow, rest, self._generators, point)
            except Unlucky:
                continue
            rows += [list(row) for row in zip(*columns, strict=True)]
            self.idle &= still
            wanted -= 1
            if not wanted:
                self._known[key] = rows
                return rows
        raise Unlucky


def _combine(flow: Flow, generators: Sequence[_Simple], weights: Sequence[Node]) -> Generator:
    g, total = flow.graph, dict[tuple[int, int], Node]()
    for weight, generator in zip(weights, generators, strict=True):
        for place, x in generator.items():
            total[place] = g.add(total.get(place, g.zero), g.mul(weight, g.number(x)))
    return {place: x for place, x in total.items() if x != g.zero}


def _keeps_steps(flow: Flow, generator: Generator) -> bool:
    """Whether a turn leaves alone what signs, roots and branches are taken of: their own slopes tell of no step."""
    g, seeds = flow.graph, dict[Node, Node]()
    for (row, column), x in generator.items():
        y, along = flow.y[row], flow.y[column] if column < len(flow.y) else g.one
        seeds[y] = g.add(seeds.get(y, g.zero), g.mul(x, along))
    nodes = reachable(g, [*flow.velocities, *flow.flat], g.mask(seeds))
    arguments = dict.fromkeys(kid for node in nodes if g.op[node] in STEPPED for kid in g.kids[node])
    return all(are_zero(g, tangent(g, list(arguments), seeds)))


def _defects(
    flow: Flow, rest: Sequence[int], generators: Sequence[_Simple], point: FieldPoint
) -> tuple[list[list[int]], set[int]]:
    """df/dy (S y + s) - S f for every generator, over the entries ``rest``, at a point; the generators with zeros in both terms."""
    p, size = point.prime, len(flow.unknowns)
    slopes = jacobian_residues(flow, point)
    y = [*point.evaluate(flow.y), 1]
    rates = list(point.evaluate(flow.velocities))
    rates += [*solve_at(size, point.evaluate(flow.flat), p)[: flow.kept], 0]
    columns, idle = list[list[int]](), set[int]()
    for k, generator in enumerate(generators):
        moved, turned = dict[int, int](), dict[int, int]()
        for (r, c), x in generator.items():
            weight = x.numerator * pow(x.denominator, -1, p)
            moved[r] = moved.get(r, 0) + weight * y[c]
            turned[r] = turned.get(r, 0) + weight * rates[c]
        by_slopes = [sum(slopes[i][j] * x for j, x in moved.items()) % p for i in rest]
        if not any(by_slopes) and not any(turned[i] % p for i in turned):
            idle.add(k)
        columns.append([(x - turned.get(i, 0)) % p for x, i in zip(by_slopes, rest, strict=True)])
    return columns, idle
