"""Constraints that are the components of one vector equation: v + w x r = 0 at a point of contact.

Two or three rows are read as base + local vector on turned axes, where the base is a velocity that T has.  In which order they
stand, and on which side of their equations, is all the same.  On those axes the equation is short: it gives a root's velocity
there outright, and between bodies it takes the place of the rows.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import list_terms
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.moving.straight import straighten
from nhc.mechanics.moving.vectors import Chained
from nhc.mechanics.rotations.turns import Path, Vector, add_vectors, change_axes
from nhc.records import record


@record
class Rolling:
    """``signs[i]`` times the held symbol of ``rows[i]`` = base's velocity + ``local``, turned to the axes of ``path``.

    The i-th component of the base has no row where it is zero: -1 stands there.
    """

    rows: tuple[int, int, int]
    signs: tuple[int, int, int]
    base: Chained
    is_position: bool
    path: Path
    local: Vector


Candidate = tuple[bool, Chained, Vector]
"""Whether it was read as a position, the vector, its velocity."""


@record
class _Matched:
    """Rows and signs as in :class:`Rolling`, and what is left of these rows without the velocity."""

    candidate: Candidate
    rows: tuple[int, int, int]
    signs: tuple[int, int, int]
    rest: Vector


def read_rolling(setting: Setting, values: Sequence[Node]) -> list[Rolling]:
    """Vector equations among the constraints, those of bases first; their rows may stand anywhere, and each with either sign."""
    found: list[Rolling] = []
    used = set[int]()
    known = _by_term(setting, _list_candidates(setting))
    for row in range(setting.system.l):
        rolling = next(_read(setting, known, row, values, used), None) if row not in used else None
        if rolling is not None:
            found.append(rolling)
            used.update(rolling.rows)
    return sorted(found, key=lambda rolling: _height(rolling.base))


def _height(vector: Chained) -> int:
    """How many vectors it stands on."""
    height, base = 0, vector.base
    while base is not None:
        height, base = height + 1, base.base
    return height


def peel_rolling(setting: Setting, values: Sequence[Node]) -> list[Path]:
    """Axes in space on which triples of constraints were written down, turn by turn: no vector of T need turn with them."""
    candidates, found = _list_candidates(setting), list[Path]()
    if all(setting.graph.zero in velocity for _, _, velocity in candidates):
        return found  # in the plane there are no triples
    known = _by_term(setting, candidates)
    for row in range(setting.system.l):
        for matched in _match(setting, known, row, values, 3, set(range(row))):
            path = setting.velocities.unturn(matched.rest).path
            if len(_turned_among(path)) == 3:
                found.append(path)
                break
    return found


def _list_candidates(setting: Setting) -> list[Candidate]:
    """The vectors that are known, newest positions first, then velocities."""
    return [
        (is_position, vector, setting.velocity_of(vector, is_position))
        for is_position, reader in ((True, setting.positions), (False, setting.velocities))
        for vector in sorted(reader.known.values(), key=lambda v: v.components, reverse=True)
    ]


def _by_term(setting: Setting, candidates: Iterable[Candidate]) -> dict[Node, list[Candidate]]:
    """The vectors by the components of their velocities, and by their first terms."""
    g, found = setting.graph, dict[Node, list[Candidate]]()
    for candidate in candidates:
        for key in dict.fromkeys(key for node in candidate[2] for key in (node, *list_terms(g, node)[:1])):
            found.setdefault(key, []).append(candidate)
    return found


def _read(
    setting: Setting, known: dict[Node, list[Candidate]], row: int, values: Sequence[Node], used: Collection[int]
) -> Iterator[Rolling]:
    for size in (3, 2):
        for matched in _match(setting, known, row, values, size, used):
            axes = {axis for axis in range(3) if matched.rows[axis] >= 0}
            place = _on_axes(setting, matched.rest, axes)
            if place is not None:
                is_position, vector, _ = matched.candidate
                yield Rolling(matched.rows, matched.signs, vector, is_position, *place)


def _match(
    setting: Setting,
    known: dict[Node, list[Candidate]],
    row: int,
    values: Sequence[Node],
    size: int,
    used: Collection[int],
) -> Iterator[_Matched]:
    """Vectors of ``size`` components of which the row has one as a term and other open rows the rest, positions first and the
    newest first of them.
    """
    g = setting.graph
    terms = (values[row], *list_terms(g, values[row]))
    keys = dict.fromkeys((*terms, *(g.neg(term) for term in terms)))
    candidates = {id(c[1]): c for key in keys for c in known.get(key, ()) if sum(x != g.zero for x in c[2]) == size}
    others = [k for k in range(setting.system.l) if k != row and k not in used]
    for candidate in sorted(candidates.values(), key=lambda c: (c[0], c[1].components), reverse=True):
        velocity = candidate[2]
        for first in (axis for axis in range(3) if velocity[axis] != g.zero):
            matched = _fill(g, values, velocity, first, [row, *others])
            if matched is not None:
                rows, signs, rest = matched
                yield _Matched(candidate, rows, signs, rest)
                break


def _fill(
    graph: Graph, values: Sequence[Node], velocity: Vector, first: int, open_rows: list[int]
) -> tuple[tuple[int, int, int], tuple[int, int, int], Vector] | None:
    """Rows for the components of a velocity, the first open one for the component ``first``; with signs and what is left."""
    g, rows, signs, rest = graph, [-1] * 3, [1] * 3, [graph.zero] * 3
    for axis in sorted(range(3), key=lambda axis: (axis != first, axis)):
        if velocity[axis] == g.zero:
            continue
        options = open_rows[:1] if axis == first else [k for k in open_rows[1:] if k not in rows]
        taken = ((k, sign, _take(g, g.scale(sign, values[k]), velocity[axis])) for k in options for sign in (1, -1))
        found = next(((k, sign, left) for k, sign, left in taken if left is not None), None)
        if found is None:
            return None
        rows[axis], signs[axis], rest[axis] = found
    if not any(x != g.zero for x in rest):
        return None
    return (rows[0], rows[1], rows[2]), (signs[0], signs[1], signs[2]), (rest[0], rest[1], rest[2])


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


def _on_axes(setting: Setting, rest: Vector, axes: set[int]) -> tuple[Path, Vector] | None:
    """The rest as a vector on axes turned among ``axes`` whose components the spec has as expressions."""
    g = setting.graph
    if len(axes) == 2:
        parts = setting.velocities.peel(rest)
        if len(parts) == 1 and parts[0].path and _turned_among(parts[0].path) == axes:
            return parts[0].path, parts[0].local
    names = {setting.marks.of(node): node for node in reversed(reachable(g, rest))}
    for path in sorted(setting.paths, key=len, reverse=True):
        if _turned_among(path) != axes:
            continue
        local = []
        for node in change_axes(g, rest, (), path):
            mark = setting.marks.of(node)
            known = g.zero if not any(mark) else names.get(mark)
            if known is None:
                opposite = names.get(setting.marks.negative(mark))
                known = None if opposite is None else g.neg(opposite)
            if known is None:
                break
            local.append(known)
        if len(local) == 3:
            return straighten(setting, path, (local[0], local[1], local[2]))
    return None


def _turned_among(path: Path) -> set[int]:
    return {axis for turn in path for axis in turn.plane}


def apply_rolling(setting: Setting, rolling: Rolling) -> None:
    """Use the equation: it settles a root, or replaces its rows once the base has a home."""
    g = setting.graph
    local = rolling.local
    x, y, z = substitute(g, local, setting.replaced)
    local = (x, y, z)
    turned = _turned(setting, rolling)
    velocity = setting.velocity_of(rolling.base, rolling.is_position)
    numbered = [
        (axis, k, sign) for axis, (k, sign) in enumerate(zip(rolling.rows, rolling.signs, strict=True)) if k >= 0
    ]
    if rolling.base.base is None and all(v in setting.system.v or v == g.zero for v in velocity):
        x, y, z = (g.sub(a, b) for a, b in zip(turned, local, strict=True))
        setting.equations[velocity] = rolling.path, (x, y, z)
        out = change_axes(g, local, rolling.path, ())
        for axis, k, sign in numbered:
            setting.rows[k] = g.scale(sign, g.add(velocity[axis], out[axis]))
        return
    home = setting.home(rolling.base, rolling.is_position)
    there = add_vectors(g, change_axes(g, home.velocity, home.path, rolling.path), local)
    for axis, k, _ in numbered:
        # three equations for three rows
        setting.rows[k] = g.add(g.sub(there[axis], turned[axis]), setting.held[k])


def _turned(setting: Setting, rolling: Rolling) -> Vector:
    """Symbols for the rows' values on the equation's axes."""
    g = setting.graph
    signed = zip(rolling.rows, rolling.signs, strict=True)
    x, y, z = (g.zero if k < 0 else g.scale(sign, setting.held[k]) for k, sign in signed)
    new, number = [], next(k for k in rolling.rows if k >= 0)
    for k, node in enumerate(change_axes(g, (x, y, z), (), rolling.path)):
        if node == g.zero:
            new.append(node)
            continue
        symbol = g.symbol(f"turned_{number}_{k}", "quasi")
        setting.meaning[symbol] = node
        new.append(symbol)
    return new[0], new[1], new[2]
