"""Angular velocities on the other axes: in space for a rotation whose omega is on the body's, or the reverse.

What a spec writes as R_y . omega is one component in space.  A vector that is a_i R_i by the rows of the matrix, with a_i that do
not hold the orientation, has the components a_i on the other axes: these are read off, and no product R R^T is left to simplify.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.algebra.walks import reachable
from nhc.mechanics.rotations.rotation import Rotation, make_rotation, put, spell
from nhc.mechanics.rotations.turns import Vector


def on_other_axes(g: Graph, rotation: Rotation) -> Rotation:
    """The same rotation with its omega on the other axes."""
    known: dict[Rotation, Rotation] = g.memory.setdefault("rotations on other axes", {})
    if rotation not in known:
        other = make_rotation(g, rotation.name, rotation.places, -rotation.sign, rotation.e, rotation.v)
        known[rotation], known[other] = other, rotation
    return known[rotation]


def omega_symbols(g: Graph, rotation: Rotation) -> tuple[Node, ...]:
    """Stand for omega as the spec has it."""
    return tuple(g.symbol(f"{rotation.name}_turn{k}", "test") for k in range(3))


def omega_in_symbols(g: Graph, rotation: Rotation) -> dict[Node, Node]:
    """Them in place of omega, for substitution."""
    mapping: dict[Node, Node] = {}
    for node, symbol in zip(rotation.omega, omega_symbols(g, rotation), strict=True):
        put(g, mapping, node, symbol)
    return mapping


def hold_orientation(g: Graph, rotation: Rotation, values: Sequence[Node]) -> bool:
    """Whether an entry of the matrix stands in one of the values."""
    entries = {g.split_coefficient(x)[1] for x in (*(x for row in rotation.matrix for x in row), *rotation.sums)}
    return not entries.isdisjoint(reachable(g, values))


def value_on_other_axes(g: Graph, rotation: Rotation, value: Node) -> Node | None:
    """A form that is linear in omega, with omega on the other axes; None where it would hold the orientation there."""
    if not g.depends(value, g.mask(rotation.v)):
        return value
    try:
        named = substitute(g, [value], omega_in_symbols(g, rotation), named=False)[0]
        (a, b, c), rest = linear_form(g, named, omega_symbols(g, rotation))
    except NotLinear:
        return None
    turned = turn_components(g, rotation, (a, b, c))
    return None if turned is None else g.add(rest, g.dot(turned, on_other_axes(g, rotation).omega))


def turn_components(g: Graph, rotation: Rotation, components: Vector) -> Vector | None:
    """A vector's components on the other axes, where these do not hold the orientation; else None."""
    own = spell(g, rotation)
    rows = []
    for k, node in enumerate(substitute(g, components, own.words, named=False)):
        entries = own.entries[k::3] if rotation.sign > 0 else own.entries[3 * k : 3 * k + 3]
        try:
            parts, rest = linear_form(g, node, entries)
        except NotLinear:
            return None
        if rest != g.zero or any(g.depends(part, g.mask(own.entries)) for part in parts):
            return None
        rows.append(parts)
    first, *others = rows
    differences = [g.sub(x, y) for other in others for x, y in zip(first, other, strict=True)]
    return (first[0], first[1], first[2]) if all(are_zero(g, differences)) else None


def turn_omega(g: Graph, rotation: Rotation, omega: Sequence[Node]) -> Vector:
    """omega on a rotation's own axes, from that on the other ones."""
    lines = zip(*rotation.matrix, strict=True) if rotation.sign > 0 else rotation.matrix
    x, y, z = (g.dot(line, omega) for line in lines)
    return x, y, z


def choose_axes(
    g: Graph, turned: Sequence[Rotation], values: Sequence[Node]
) -> tuple[tuple[Rotation, ...], Sequence[Node]]:
    """The rotations on the axes on which they are solved for, and the forms there.

    The spec's, but for a rotation of which no omega is asked for and all forms are without its orientation on the other axes: omega
    is solved for there and turned, where R would stand in each row and nothing would know that R R^T = 1.
    """
    bases = list[Rotation]()
    for rotation in turned if "other axes" not in g.off else ():
        found = list[Node | None]()
        if not {*rotation.omega} & {*values} and hold_orientation(g, rotation, values):
            found = [value_on_other_axes(g, rotation, value) for value in values]
        there = [value for value in found if value is not None]
        known = len(there) == len(values)
        bases.append(on_other_axes(g, rotation) if known else rotation)
        values = there if known else values
    return tuple(bases) or tuple(turned), values
