"""Constraints that are the components of one vector equation: v + w x r = 0 at a point of contact.

Two or three rows in succession are read as base + local vector on turned axes, where the base is a velocity that T has.  On those
axes the equation is short: it gives a root's velocity there outright, and between bodies it takes the place of the rows.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import list_terms, reachable, substitute
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.moving import Scene
from nhc.mechanics.moving_straight import straighten
from nhc.mechanics.turns import Path, Vector, add_vectors, change_axes
from nhc.mechanics.vectors import Chained
from nhc.records import record


@record
class Rolling:
    """held symbols of ``rows`` = the base's velocity + ``local`` on the axes of ``path``."""

    rows: tuple[int, ...]
    base: Chained
    is_position: bool
    path: Path
    local: Vector


def read_rolling(scene: Scene, values: Sequence[Node]) -> list[Rolling]:
    """Vector equations among the constraints, in their order."""
    found: list[Rolling] = []
    count, row = scene.system.l, 0
    known = _by_term(scene)
    while row < count:
        for size in (3, 2):
            if row + size > count:
                continue
            rows = tuple(range(row, row + size))
            rolling = _read(scene, known, rows, [values[k] for k in rows])
            if rolling is not None:
                found.append(rolling)
                row += size - 1
                break
        row += 1
    return found


def peel_rolling(scene: Scene, values: Sequence[Node]) -> list[Path]:
    """Axes in space on which triples of constraints were written down, turn by turn: no vector of T need turn with them."""
    g, known, found = scene.graph, _by_term(scene), list[Path]()
    for row in range(scene.system.l - 2):
        rows = values[row : row + 3]
        for _, velocity in _standing_in(scene, known, rows):
            rest = _without(g, rows, velocity)
            path = scene.velocities.unturn(rest).path if rest is not None else ()
            if len({axis for turn in path for axis in turn.plane}) == 3:
                found.append(path)
                break
    return found


Candidate = tuple[bool, Chained, Vector]
"""Whether it was read as a position, the vector, its velocity."""


def _by_term(scene: Scene) -> dict[Node, list[Candidate]]:
    """Vectors by the first component of their velocities, and by its first term; newest positions first, then velocities."""
    g, found = scene.graph, dict[Node, list[Candidate]]()
    for is_position, reader in ((True, scene.positions), (False, scene.velocities)):
        for vector in sorted(reader.known.values(), key=lambda v: v.components, reverse=True):
            velocity = scene.velocity_of(vector, is_position)
            for key in dict.fromkeys((velocity[0], *list_terms(g, velocity[0])[:1])):
                found.setdefault(key, []).append((is_position, vector, velocity))
    return found


def _read(
    scene: Scene, known: dict[Node, list[Candidate]], rows: tuple[int, ...], values: list[Node]
) -> Rolling | None:
    g = scene.graph
    components = [*values, *([g.zero] * (3 - len(values)))]
    for (is_position, vector), velocity in _standing_in(scene, known, values):
        rest = _without(g, components, velocity)
        if rest is None:
            continue
        place = _on_axes(scene, rest, planar=len(rows) == 2)
        if place is not None:
            return Rolling(rows, vector, is_position, *place)
    return None


def _standing_in(
    scene: Scene, known: dict[Node, list[Candidate]], values: Sequence[Node]
) -> list[tuple[tuple[bool, Chained], Vector]]:
    """Vectors of which the first row has a term, positions first and the newest first of them, with their velocities."""
    keys = dict.fromkeys((values[0], *list_terms(scene.graph, values[0])))
    candidates = {id(vector): (kind, vector, velocity) for key in keys for kind, vector, velocity in known.get(key, ())}
    ordered = sorted(candidates.values(), key=lambda c: (c[0], c[1].components), reverse=True)
    return [((kind, vector), velocity) for kind, vector, velocity in ordered]


def _without(graph: Graph, components: Sequence[Node], velocity: Vector) -> Vector | None:
    """What is left of the rows when a velocity is taken out of their terms."""
    g, rest = graph, []
    for node, taken in zip(components, velocity, strict=True):
        if (node == g.zero) != (taken == g.zero):
            return None
        left = _take(g, node, taken) if taken != g.zero else g.zero
        if left is None:
            return None
        rest.append(left)
    return (rest[0], rest[1], rest[2]) if any(x != g.zero for x in rest) else None


def _take(graph: Graph, node: Node, taken: Node) -> Node | None:
    """node - taken where taken is one of its terms, or all its terms are."""
    g = graph
    mine = list_terms(g, node, (taken,))
    if taken in mine:
        mine.remove(taken)
        return g.sum(mine)
    theirs = list_terms(g, taken)
    for term in theirs:
        if term not in mine:
            return None
        mine.remove(term)
    return g.sum(mine)


def _on_axes(scene: Scene, rest: Vector, *, planar: bool) -> tuple[Path, Vector] | None:
    """The rest as a vector on turned axes whose components the spec has as expressions."""
    g = scene.graph
    if planar:
        parts = scene.velocities.peel(rest)
        if len(parts) == 1 and parts[0].path:
            return parts[0].path, parts[0].local
    names = {scene.marks.of(node): node for node in reversed(reachable(g, rest))}
    for path in sorted(scene.paths, key=len, reverse=True):
        if (len({axis for turn in path for axis in turn.plane}) == 2) != planar:
            continue
        local = []
        for node in change_axes(g, rest, (), path):
            mark = scene.marks.of(node)
            known = g.zero if not any(mark) else names.get(mark)
            if known is None:
                opposite = names.get(scene.marks.negative(mark))
                known = None if opposite is None else g.neg(opposite)
            if known is None:
                break
            local.append(known)
        if len(local) == 3:
            return straighten(scene, path, (local[0], local[1], local[2]))
    return None


def apply_rolling(scene: Scene, rolling: Rolling) -> None:
    """Use the equation: it settles a root, or replaces its rows once the base has a home."""
    g = scene.graph
    local = rolling.local
    x, y, z = substitute(g, local, scene.replaced)
    local = (x, y, z)
    held = [scene.held[k] for k in rolling.rows] + [g.zero] * (3 - len(rolling.rows))
    turned = _turned(scene, rolling, (held[0], held[1], held[2]))
    velocity = scene.velocity_of(rolling.base, rolling.is_position)
    if rolling.base.base is None and all(v in scene.system.v or v == g.zero for v in velocity):
        x, y, z = (g.sub(a, b) for a, b in zip(turned, local, strict=True))
        scene.equations[velocity] = rolling.path, (x, y, z)
        out = change_axes(g, local, rolling.path, ())
        for k, v, node in zip(rolling.rows, velocity, out, strict=False):
            scene.rows[k] = g.add(v, node)
        return
    home = scene.home(rolling.base, rolling.is_position)
    there = add_vectors(g, change_axes(g, home.velocity, home.path, rolling.path), local)
    for k, node, other in zip(rolling.rows, there, turned, strict=False):
        # three equations for three rows
        scene.rows[k] = g.add(g.sub(node, other), scene.held[k])


def _turned(scene: Scene, rolling: Rolling, held: Vector) -> Vector:
    """Symbols for the rows' values on the equation's axes."""
    g = scene.graph
    new = []
    for k, node in enumerate(change_axes(g, held, (), rolling.path)):
        if node == g.zero:
            new.append(node)
            continue
        symbol = g.symbol(f"turned_{rolling.rows[0]}_{k}", "quasi")
        scene.meaning[symbol] = node
        new.append(symbol)
    return new[0], new[1], new[2]
