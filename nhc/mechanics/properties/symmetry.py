"""Turns of rotations under which a motion's field looks the same: what a steady turn may go along.

A turn of space about a fixed axis multiplies a quaternion from the left, one about an axis of the body from the right, so both
are linear in e; angular velocities on the axes that turn are turned with them.  A combination S of such turns is a symmetry of
y' = f(y) where S f = (df/dy) S y.  All combinations are found by exact linear algebra at random points of a prime field; those
that change what a sign is taken of are none.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from nhc.algebra.calculus import reachable, tangent
from nhc.algebra.exact.modular import FieldPoint, Unlucky, are_zero
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.relations import find_relations
from nhc.algebra.graph import Node
from nhc.algebra.solving.linear import STEPPED
from nhc.mechanics.flow import Flow, jacobian_residues, solve_at
from nhc.mechanics.frame import Frame

Generator = Mapping[tuple[int, int], Fraction]
"""S by its entries (row, column) over the state."""

_POINTS, _DRAWS = 3, 400


def turning_symmetries(flow: Flow, frame: Frame | None, rest: Sequence[int]) -> tuple[tuple[Generator, ...], ...]:
    """(turns of space, turns of space and of bodies) that leave the field of the entries ``rest`` as it is.

    Empty where there are none, and for formulations that keep the rates of quaternions.
    """
    if frame is None or not frame.turned:
        return ()
    of_space = [_generator(flow, frame, k, -1, axis, rest) for k in range(len(frame.turned)) for axis in range(3)]
    of_bodies = [_generator(flow, frame, k, 1, axis, rest) for k in range(len(frame.turned)) for axis in range(3)]
    try:
        found = [_symmetries(flow, rest, made) for made in (of_space, [*of_space, *of_bodies])]
    except Unlucky:
        return ()
    found = [tuple(turn for turn in made if _keeps_steps(flow, turn)) for made in found]
    kept = found if len(found[1]) > len(found[0]) else found[:1]
    return tuple(made for made in kept if made)


def _generator(flow: Flow, frame: Frame, k: int, side: int, axis: int, rest: Sequence[int]) -> Generator:
    """The turn of a rotation about an axis of space (``side`` -1) or of the body (1), on the entries ``rest``."""
    rotation = frame.turned[k]
    declared = next(r for r in flow.system.spec.rotations if r.name == rotation.name)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    e, half = rotation.places, Fraction(1, 2)
    entries = {
        (e[0], e[axis + 1]): -half,
        (e[axis + 1], e[0]): half,
        (e[i + 1], e[j + 1]): side * half,
        (e[j + 1], e[i + 1]): -side * half,
    }
    if side == rotation.sign:  # body: w' = w x axis; space: w' = axis x w
        names = {name: place for place, name in enumerate(flow.names)}
        w = [names.get(name) for name in declared.velocities]
        for row, column, sign in ((i, j, side), (j, i, -side)):
            a, b = w[row], w[column]
            if a is not None and b is not None:
                entries[a, b] = Fraction(sign)
    return {(r, c): x for (r, c), x in entries.items() if r in rest and c in rest}


def _symmetries(flow: Flow, rest: Sequence[int], generators: Sequence[Generator]) -> tuple[Generator, ...]:
    rows: list[list[int]] = []
    points, prime = 0, primes_of(flow.graph)[0]
    for draw in range(_DRAWS):
        if points == _POINTS:
            break
        try:
            rows += _defects(flow, rest, generators, FieldPoint(flow.graph, 13_000_003 + draw, prime))
        except Unlucky:
            continue
        points += 1
    if points < _POINTS:
        raise Unlucky
    found = []
    for vector in find_relations(rows, len(generators), prime):
        total: dict[tuple[int, int], Fraction] = {}
        for weight, generator in zip(vector, generators, strict=True):
            for place, x in generator.items():
                total[place] = total.get(place, Fraction(0)) + weight * x
        kept = {place: x for place, x in total.items() if x}
        if kept:
            found.append(kept)
    return tuple(found)


def _keeps_steps(flow: Flow, generator: Generator) -> bool:
    """Whether a turn leaves alone what signs, roots and branches are taken of: their own slopes tell of no step."""
    g, seeds = flow.graph, dict[Node, Node]()
    for (row, column), x in generator.items():
        y = flow.y[row]
        seeds[y] = g.add(seeds.get(y, g.zero), g.mul(g.number(x), flow.y[column]))
    nodes = reachable(g, [*flow.velocities, *flow.flat], g.mask(seeds))
    arguments = dict.fromkeys(kid for node in nodes if g.op[node] in STEPPED for kid in g.kids[node])
    return all(are_zero(g, tangent(g, list(arguments), seeds)))


def _defects(flow: Flow, rest: Sequence[int], generators: Sequence[Generator], point: FieldPoint) -> list[list[int]]:
    """(df/dy S y - S f) for every generator (columns) and entry of ``rest`` (rows), at a point."""
    p, size = point.prime, len(flow.unknowns)
    slopes = jacobian_residues(flow, point)
    y = point.evaluate(flow.y)
    rates = list(point.evaluate(flow.velocities))
    rates += solve_at(size, point.evaluate(flow.flat), p)[: flow.kept]
    columns = []
    for generator in generators:
        moved, turned = dict.fromkeys(range(len(y)), 0), dict.fromkeys(range(len(y)), 0)
        for (r, c), x in generator.items():
            weight = x.numerator * pow(x.denominator, -1, p)
            moved[r] += weight * y[c]
            turned[r] += weight * rates[c]
        columns.append([(sum(slopes[i][j] * moved[j] for j in moved) - turned[i]) % p for i in rest])
    return [list(row) for row in zip(*columns, strict=True)]
