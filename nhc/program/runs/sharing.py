"""Frictions that hold together, and what each of them can take of the load.

Where the velocities that frictions hold are independent, the share of each is a reaction.  Where some follow from others, as those
of the bearings of one train of gears, many shares carry the same load, and rest lasts as long as there is one of them (the limit
analysis of Drucker, Prager and Greenberg 1952; Coulomb's law for each).

With v_f = sum of beta_fb v_b for the held v_b, the reactions lambda_b of v_b = 0 have to be sums of s_f c_f beta_fb with all
|s_f| <= 1, a zonotope.  Its faces have normals n across all but one of the independent directions that lie in them: for each n,
|n . lambda| <= h(n) = sum of c_f |n . beta_f|.  Where n . lambda gets larger, what has no part along n goes on to hold, and all the
rest slips.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import are_zero, is_zero, rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import solve
from nhc.mechanics.system import System
from nhc.program.planning.planner import Planner
from nhc.program.runs.friction import Friction, list_signs
from nhc.program.runs.needed import reactions_of
from nhc.records import record

Row = tuple[Node, ...]
_TERMS = 60  # of a part of a direction, up to which it is brought to its canonical form
_FACES = 40  # of one group of frictions, above which it is not said when it breaks loose
# by which the load is more than friction where it breaks loose, so that it does not stick again at once
_MARGIN = Fraction(1, 10**9)


@record
class Release:
    """``frictions`` slip where the square of ``size`` is less than those of ``rows``, each times the held reactions."""

    frictions: tuple[Friction, ...]
    size: Node
    rows: tuple[Row, ...]


@record
class Share:
    """The part of ``friction`` that acts: minus ``rows``, each times the held reactions, for each of its forms."""

    friction: Friction
    rows: tuple[Row, ...]


@record
class Held:
    """``frictions`` hold; the forms of the ``leading`` ones are constraints, in this order, from which the others follow."""

    frictions: tuple[Friction, ...] = ()
    leading: tuple[Friction, ...] = ()
    releases: tuple[Release, ...] = ()
    shares: tuple[Share, ...] = ()

    @property
    def names(self) -> set[str]:
        """Of the constraints that stand for friction."""
        return {form.name for friction in self.leading for form in friction.forms}


def list_releases(planner: Planner, held: Held) -> list[Node]:
    """Values that are positive while friction holds, one for each release; what leads are the planner's last constraints."""
    g, reactions = planner.graph, _held_reactions(planner, held)
    most, found = g.number(1 + _MARGIN), list[Node]()
    for release in held.releases:
        size, *_ = planner.on_motion([release.size])
        loads = [g.dot(planner.on_motion(row), reactions) for row in release.rows]
        found.append(g.sub(g.mul(most, g.power(size, 2)), g.sum([g.power(load, 2) for load in loads])))
    return found


def put_values(planner: Planner, held: Held, nodes: Sequence[Node]) -> list[Node]:
    """Nodes on the motion with what acts in place of each friction's ``values``."""
    if not held.frictions:
        return list(nodes)
    g, reactions = planner.graph, _held_reactions(planner, held)
    found = {
        value: g.neg(g.dot(planner.on_motion(row), reactions))
        for share in held.shares
        for value, row in zip(share.friction.values, share.rows, strict=True)
    }
    return substitute(g, nodes, found)


def _held_reactions(planner: Planner, held: Held) -> list[Node]:
    return list(reactions_of(planner)[-sum(len(friction.forms) for friction in held.leading) :])


# --- what follows from what ---------------------------------------------------------------------------------------------


def list_following(system: System, held: Sequence[Friction], others: Sequence[Friction]) -> list[Friction]:
    """Those of ``others`` whose slips vanish with those that are held, and not by the constraints alone."""
    g, own = system.graph, [form.coefficients for form in system.constraints]
    rows = [*own, *(form.coefficients for friction in held for form in friction.forms)]
    most = rank(g, rows)

    def follows(friction: Friction) -> bool:
        new = [form.coefficients for form in friction.forms]
        return rank(g, [*rows, *new]) == most and rank(g, [*own, *new]) > len(own)

    found, known = list[Friction](), {node for friction in held for node in list_signs(system, friction)}
    for friction in others:
        if friction.function not in known and follows(friction):
            found.append(friction)
            known |= list_signs(system, friction)
    return found


def hold_together(system: System, frictions: Sequence[Friction]) -> Held:
    """How frictions hold together in a system in which nothing is held; in a plane, what follows from others is left out.

    Raises:
        Singular: too many of them follow from each other.
    """
    g = system.graph
    rows = [form.coefficients for form in system.constraints]
    leading, following = list[Friction](), list[Friction]()
    for friction in sorted(frictions, key=lambda friction: -len(friction.forms)):
        new = [form.coefficients for form in friction.forms]
        free = rank(g, [*rows, *new]) == len(rows) + len(new)
        (leading if free else following).append(friction)
        rows += new if free else []
    width = sum(len(friction.forms) for friction in leading)
    plane = [j for j, wide in enumerate(len(f.forms) > 1 for f in leading for _ in f.forms) if wide]
    following = [friction for friction in following if len(friction.forms) == 1]
    unit = [tuple(g.one if i == j else g.zero for j in range(width)) for i in range(width)]
    tied = [
        (friction, row)
        for friction, row in zip(following, _follow(g, rows, width, following), strict=True)
        if all(row[j] == g.zero for j in plane)
    ]
    releases, shares, place = list[Release](), list[Share](), 0
    groups = list[list[tuple[Friction, Row]]]()
    for friction in leading:
        own = unit[place : place + len(friction.forms)]
        place += len(own)
        if any(_meets(g, row, own[0]) for _, row in tied):
            groups.append([(friction, own[0])])
            continue
        releases.append(Release((friction,), friction.size, tuple(own)))
        shares.append(Share(friction, tuple(_scaled(g, row, g.div(g.one, friction.size)) for row in own)))
    for group in _join(groups, tied, g):
        releases += _list_faces(g, group)
        shares += _share(g, group)
    known = [*leading, *(friction for friction, _ in tied)]
    return Held(tuple(x for x in frictions if x in known), tuple(leading), tuple(releases), tuple(shares))


def _follow(graph: Graph, rows: Sequence[Row], width: int, following: Sequence[Friction]) -> list[Row]:
    """beta: each following slip by the held ones, which are the last ``width`` of the independent rows."""
    g = graph
    if not following:
        return []
    wanted = [friction.forms[0].coefficients for friction in following]
    if len(rows) == len(rows[0]):
        matrix, right = [list(column) for column in zip(*rows, strict=True)], [list(row) for row in wanted]
    else:
        matrix = [[g.dot(a, b) for b in rows] for a in rows]
        right = [[g.dot(a, row) for a in rows] for row in wanted]
    found = solve(g, matrix, right).unknowns
    parts = [[normalise(g, x, _TERMS) for x in row[len(rows) - width :]] for row in found]
    return [tuple(g.zero if is_zero(g, x) else x for x in row) for row in parts]


def _join(
    groups: list[list[tuple[Friction, Row]]], following: Sequence[tuple[Friction, Row]], graph: Graph
) -> Iterator[list[tuple[Friction, Row]]]:
    """Groups of frictions that have held velocities in common, each with its direction."""
    for friction, row in following:
        own = [group for group in groups if any(_meets(graph, row, other) for _, other in group)]
        if not own:
            continue
        groups = [
            *(group for group in groups if group not in own),
            [*(x for group in own for x in group), (friction, row)],
        ]
    yield from groups


def _meets(graph: Graph, row: Row, other: Row) -> bool:
    return any(graph.zero not in pair for pair in zip(row, other, strict=True))


# --- faces and shares ---------------------------------------------------------------------------------------------------


def _list_faces(graph: Graph, group: Sequence[tuple[Friction, Row]]) -> list[Release]:
    g, found = graph, dict[frozenset[Node], Release]()
    used = [j for j in range(len(group[0][1])) if any(row[j] != g.zero for _, row in group)]
    for chosen in combinations(group, len(used) - 1):
        normal = _normal(g, [[row[j] for j in used] for _, row in chosen])
        if all(are_zero(g, [*normal])):
            continue
        parts = [g.dot(normal, [row[j] for j in used]) for _, row in group]
        slips = [not is_zero(g, part) for part in parts]
        loose = tuple(friction for (friction, _), slip in zip(group, slips, strict=True) if slip)
        size = g.sum(
            [g.mul(f.size, g.function("abs", x)) for (f, _), x, slip in zip(group, parts, slips, strict=True) if slip]
        )
        whole = dict(zip(used, normal, strict=True))
        row = tuple(whole.get(j, g.zero) for j in range(len(group[0][1])))
        found.setdefault(frozenset(friction.function for friction in loose), Release(loose, size, (row,)))
        if len(found) > _FACES:
            raise Singular
    return list(found.values())


def _normal(graph: Graph, rows: Sequence[Sequence[Node]]) -> list[Node]:
    """What is across one row less than there are columns: its minors, with their signs."""
    g, width = graph, len(rows) + 1

    def minor(matrix: list[list[Node]]) -> Node:
        if not matrix:
            return g.one
        return g.sum(
            [
                g.mul(g.mul(g.number((-1) ** j), x), minor([[*row[:j], *row[j + 1 :]] for row in matrix[1:]]))
                for j, x in enumerate(matrix[0])
                if x != g.zero
            ]
        )

    signed = ((j, minor([[*row[:j], *row[j + 1 :]] for row in rows])) for j in range(width))
    return [normalise(g, g.mul(g.number((-1) ** j), x), _TERMS) for j, x in signed]


def _share(graph: Graph, group: Sequence[tuple[Friction, Row]]) -> list[Share]:
    """One of the shares that carry a load: of one velocity, all frictions give the same part of what they can; of several,
    the parts have the least sum of squares.
    """
    g, width = graph, len(group[0][1])
    used = [j for j in range(width) if any(row[j] != g.zero for _, row in group)]
    if len(used) == 1:
        parts = [row[used[0]] for _, row in group]
        whole = g.div(
            g.one, g.sum([g.mul(f.size, g.function("abs", x)) for (f, _), x in zip(group, parts, strict=True)])
        )
        found = [[g.mul(g.function("sign", x), whole)] for x in parts]
    else:
        columns = [[g.mul(f.size, row[j]) for j in used] for f, row in group]
        matrix = [[g.sum([g.mul(c[i], c[j]) for c in columns]) for j in range(len(used))] for i in range(len(used))]
        units = [[g.one if i == j else g.zero for j in range(len(used))] for i in range(len(used))]
        inverse = solve(g, matrix, units).unknowns
        found = [[g.dot(row, column) for row in inverse] for column in columns]
    wide = [dict(zip(used, row, strict=True)) for row in found]
    rows = [tuple(row.get(j, g.zero) for j in range(width)) for row in wide]
    return [Share(friction, (row,)) for (friction, _), row in zip(group, rows, strict=True)]


def _scaled(graph: Graph, row: Row, factor: Node) -> Row:
    return tuple(graph.mul(factor, x) for x in row)
