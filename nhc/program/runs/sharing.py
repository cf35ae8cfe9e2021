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

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import are_zero, is_zero, rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import solve
from nhc.mechanics.choosing.independence import independence
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.system import Form, System
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
class Part:
    """A friction of a group whose velocities follow from one another: ``row`` by the held forms, ``across`` by the constraints
    of the spec, which take the rest of its force.
    """

    friction: Friction
    row: Row
    across: Row = ()


@record
class Held:
    """``frictions`` hold; the forms of the ``leading`` ones are constraints, in this order, from which the others follow.

    ``alone`` are those whose share is a reaction, with the rows of their forms; the others share a load in ``groups``.
    """

    frictions: tuple[Friction, ...] = ()
    leading: tuple[Friction, ...] = ()
    releases: tuple[Release, ...] = ()
    alone: tuple[tuple[Friction, tuple[Row, ...]], ...] = ()
    groups: tuple[tuple[Part, ...], ...] = ()

    @property
    def names(self) -> set[str]:
        """Of the constraints that stand for friction."""
        return {form.name for friction in self.leading for form in friction.forms}


NO_FRICTION = Held()


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
    return substitute(planner.graph, nodes, _list_shares(planner, held)) if held.frictions else list(nodes)


def list_corrections(planner: Planner, held: Held) -> dict[str, Node]:
    """What the reactions of the spec's constraints have more, by their names, than those of a system without friction: of frictions
    that follow from others, they take what these do not.
    """
    g, found = planner.graph, dict[str, Node]()
    shares = _list_shares(planner, held) if held.groups else {}
    forms = planner.system.constraints
    for part in (part for group in held.groups for part in group if part.across):
        pull = g.mul(shares[part.friction.values[0]], planner.on_motion([part.friction.size])[0])
        for form, across in zip(forms, planner.on_motion(part.across), strict=False):
            found[form.name] = g.add(found.get(form.name, g.zero), g.mul(pull, across))
    return {name: node for name, node in found.items() if node != g.zero}


def _list_shares(planner: Planner, held: Held) -> dict[Node, Node]:
    """The part of each friction that acts, from -1 to 1, on the motion."""
    g, reactions = planner.graph, _held_reactions(planner, held)
    found = dict[Node, Node]()
    for friction, rows in held.alone:
        (size,) = planner.on_motion([friction.size])
        loads = [g.dot(row, reactions) for row in rows]
        found |= {value: g.neg(g.div(x, size)) for value, x in zip(friction.values, loads, strict=True)}
    for group in held.groups:
        used = _list_used(g, [part.row for part in group])
        parts = [
            (planner.on_motion([part.friction.size])[0], planner.on_motion([part.row[j] for j in used]))
            for part in group
        ]
        shares = split_load(g, [g.neg(reactions[j]) for j in used], parts)
        found |= {part.friction.values[0]: share for part, share in zip(group, shares, strict=True)}
    return found


def _held_reactions(planner: Planner, held: Held) -> list[Node]:
    return list(reactions_of(planner)[-sum(len(friction.forms) for friction in held.leading) :])


# --- what follows from what ---------------------------------------------------------------------------------------------


def list_following(system: System, held: Sequence[Friction], others: Sequence[Friction]) -> list[Friction]:
    """Those of ``others`` whose slips vanish with those that are held, and not by the constraints alone."""
    g, own = system.graph, [form.coefficients for form in system.constraints]
    rows = _list_whole((*system.constraints, *(form for friction in held for form in friction.forms)))
    most = rank(g, rows)

    def follows(friction: Friction) -> bool:
        new = [form.coefficients for form in friction.forms]
        return rank(g, [*rows, *_list_whole(friction.forms)]) == most and rank(g, [*own, *new]) > len(own)

    found, known = list[Friction](), {node for friction in held for node in list_signs(system, friction)}
    for friction in others:
        if friction.function not in known and follows(friction):
            found.append(friction)
            known |= list_signs(system, friction)
    return found


def _list_whole(forms: Sequence[Form]) -> list[Row]:
    """Rows with their constants: of slips on belts that move one follows from the other only where these do."""
    return [(*form.coefficients, form.constant) for form in forms]


def hold_together(system: System, frictions: Sequence[Friction]) -> Held:
    """How frictions hold together in a system in which nothing is held; in a plane, what follows from others is left out.

    Raises:
        Singular: too many of them follow from each other, or they cannot hold at one time.
    """
    g, own = system.graph, [form.coefficients for form in system.constraints]
    rows, leading, following = list(own), list[Friction](), list[Friction]()
    points = trial_points(system)

    def order(friction: Friction) -> tuple[int, float]:
        """A slip that the constraints hold at some place by themselves is no good constraint there."""
        return -len(friction.forms), -round(independence(system, friction.forms[:1], points), 2)

    for friction in sorted(frictions, key=order):
        new = [form.coefficients for form in friction.forms]
        free = rank(g, [*rows, *new]) == len(rows) + len(new)
        (leading if free else following).append(friction)
        rows += new if free else []
    width = len(rows) - len(own)
    plane = [j for j, wide in enumerate(len(f.forms) > 1 for f in leading for _ in f.forms) if wide]
    following = [friction for friction in following if len(friction.forms) == 1]
    whole = _list_whole((*system.constraints, *(form for friction in leading for form in friction.forms)))
    if rank(g, [*whole, *_list_whole([friction.forms[0] for friction in following])]) > len(whole):
        raise Singular
    tied = [
        Part(friction, row[len(own) :], row[: len(own)])
        for friction, row in zip(following, _follow(g, rows, following), strict=True)
        if all(row[len(own) + j] == g.zero for j in plane) and any(x != g.zero for x in row[len(own) :])
    ]
    unit = [tuple(g.one if i == j else g.zero for j in range(width)) for i in range(width)]
    releases, alone, single, place = list[Release](), list[tuple[Friction, tuple[Row, ...]]](), list[Part](), 0
    for friction in leading:
        mine = tuple(unit[place : place + len(friction.forms)])
        place += len(mine)
        if any(_meets(g, part.row, mine[0]) for part in tied):
            single.append(Part(friction, mine[0]))
            continue
        releases.append(Release((friction,), friction.size, mine))
        alone.append((friction, mine))
    groups = _join(single, tied, g)
    releases += [release for group in groups for release in _list_faces(g, group)]
    known = [*leading, *(part.friction for part in tied)]
    held = tuple(x for x in frictions if x in known)
    return Held(held, tuple(leading), tuple(releases), tuple(alone), tuple(map(tuple, groups)))


def _follow(graph: Graph, rows: Sequence[Row], following: Sequence[Friction]) -> list[Row]:
    """Each following slip by the independent rows, those of the constraints and then those of the held slips."""
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
    parts = [[normalise(g, x, _TERMS) for x in row] for row in found]
    return [tuple(g.zero if is_zero(g, x) else x for x in row) for row in parts]


def _join(single: Sequence[Part], following: Sequence[Part], graph: Graph) -> list[list[Part]]:
    """Groups of frictions that have held velocities in common."""
    groups = [[part] for part in single]
    for part in following:
        own = [group for group in groups if any(_meets(graph, part.row, other.row) for other in group)]
        if own:
            groups = [*(group for group in groups if group not in own), [*(x for group in own for x in group), part]]
    return groups


def _meets(graph: Graph, row: Row, other: Row) -> bool:
    return any(graph.zero not in pair for pair in zip(row, other, strict=True))


# --- faces and shares ---------------------------------------------------------------------------------------------------


def _list_faces(graph: Graph, group: Sequence[Part]) -> list[Release]:
    g, used = graph, _list_used(graph, [part.row for part in group])
    found = list[Release]()
    for normal, parts in _list_normals(g, [[part.row[j] for j in used] for part in group]):
        loose = [(part.friction, x) for part, x in zip(group, parts, strict=True) if x != g.zero]
        size = g.sum([g.mul(friction.size, g.function("abs", x)) for friction, x in loose])
        whole = dict(zip(used, normal, strict=True))
        row = tuple(whole.get(j, g.zero) for j in range(len(group[0].row)))
        found.append(Release(tuple(friction for friction, _ in loose), size, (row,)))
    return found


def _list_used(graph: Graph, rows: Sequence[Row]) -> list[int]:
    return [j for j in range(len(rows[0])) if any(row[j] != graph.zero for row in rows)]


def _list_normals(graph: Graph, rows: Sequence[Sequence[Node]]) -> list[tuple[list[Node], list[Node]]]:
    """The normal of each pair of faces, and its products with all directions, which are zero where these lie in the face.

    Raises:
        Singular: there are too many.
    """
    g, found = graph, dict[tuple[bool, ...], tuple[list[Node], list[Node]]]()
    for chosen in combinations(rows, len(rows[0]) - 1):
        normal = _normal(g, chosen)
        if all(are_zero(g, normal)):
            continue
        parts = [g.dot(normal, row) for row in rows]
        parts = [g.zero if is_zero(g, x) else x for x in parts]
        found.setdefault(tuple(x == g.zero for x in parts), (normal, parts))
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


def split_load(graph: Graph, load: Sequence[Node], parts: Sequence[tuple[Node, Sequence[Node]]]) -> list[Node]:
    """One of the shares s with sum of s c a = ``load`` over the parts (c, a), none of which is larger than it has to be.

    The load is k times a point of the face that it points to, k = |n . load|/h(n) being the largest of all faces; there what has
    a part along n gives k, and what lies in the face shares the rest in the same way.  Along one direction all give the same.
    """
    g = graph
    if len(load) == 1:
        whole = g.div(load[0], g.sum([g.mul(c, g.function("abs", a[0])) for c, a in parts]))
        return [g.mul(g.function("sign", a[0]), whole) for _, a in parts]
    gauges, found = list[Node](), list[list[Node]]()
    for normal, along in _list_normals(g, [a for _, a in parts]):
        value = g.dot(normal, load)
        size = g.sum([g.mul(c, g.function("abs", x)) for (c, _), x in zip(parts, along, strict=True)])
        gauges.append(g.div(g.function("abs", value), size))
        given = [g.mul(g.div(value, size), g.function("sign", x)) for x in along]
        pulls = [g.mul(x, c) for x, (c, _) in zip(given, parts, strict=True)]
        rest = [
            g.sub(part, g.sum([g.mul(x, a[i]) for x, (_, a) in zip(pulls, parts, strict=True)]))
            for i, part in enumerate(load)
        ]
        drop = min((j for j, x in enumerate(normal) if x != g.zero), key=lambda j: g.value(normal[j]) is None)
        inside = [k for k, x in enumerate(along) if x == g.zero]
        within = [(parts[k][0], [x for j, x in enumerate(parts[k][1]) if j != drop]) for k in inside]
        shares = split_load(g, [x for j, x in enumerate(rest) if j != drop], within)
        own = dict(zip(inside, shares, strict=True))
        found.append([own.get(k, given[k]) for k in range(len(parts))])
    weights = [
        g.product([g.add(g.one, g.function("sign", g.sub(gauge, x))) for m, x in enumerate(gauges) if m != k])
        for k, gauge in enumerate(gauges)
    ]
    total = g.sum(weights)
    return [
        g.div(g.sum([g.mul(w, row[k]) for w, row in zip(weights, found, strict=True)]), total)
        for k in range(len(parts))
    ]
