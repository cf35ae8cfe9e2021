"""Forces with a potential that depends on the places of T's points: on the points' axes, not through the coordinates.

Where U contains components of a position that T moves, dU along a vector e is the gradient by these components times the point's
velocity along e, which is at hand on the point's axes.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.moving.bodies import Bodies
from nhc.mechanics.rotations.turns import Vector, change_axes, cross


def find_loads(setting: Setting, bodies: Bodies, forms: int) -> tuple[tuple[Node, ...], Node, dict[Node, Node]]:
    """(what U gives to each of the forms, U with the points' places as symbols of their own, those symbols' places).

    The loads are over the coordinates; dU(e) is their sum weighted with W_k(e), and the derivative of what is left of U.
    """
    g, system = setting.graph, setting.system
    loads = [g.zero] * forms
    symbols: dict[Node, Node] = {}
    owners: list[tuple[Node, int, int]] = []
    for number, hung in enumerate(bodies.hung):
        for axis, place in enumerate(hung.vector.components):
            if hung.is_position and hung.path and place not in symbols and g.depends(place, g.mask(system.q)):
                symbols[place] = g.symbol(f"place_{number}_{axis}", "form")
                owners.append((symbols[place], number, axis))
    rest = substitute(g, [system.U], symbols)[0]
    used = [(symbol, number, axis) for symbol, number, axis in owners if g.depends(rest, g.deps[symbol])]
    places = {symbol: place for place, symbol in symbols.items()}
    slopes = substitute(g, gradient(g, rest, [symbol for symbol, _, _ in used]), places)
    for slope, (_, number, axis) in zip(slopes, used, strict=True):
        hung = bodies.hung[number]
        unit = [g.zero] * 3
        unit[axis] = g.one
        direction = change_axes(g, (unit[0], unit[1], unit[2]), (), hung.path)
        _add(setting, loads, hung.point, direction, slope)
        if hung.spin is not None:
            x, y, z = (g.mul(slope, a) for a in hung.arm)
            _add(setting, loads, hung.spin, cross(g, (x, y, z), direction), g.one)
    return tuple(loads), rest, places


def _add(setting: Setting, loads: list[Node], numbers: Sequence[int], vector: Vector, factor: Node) -> None:
    g = setting.graph
    for k, node in zip(numbers, vector, strict=False):
        if k >= 0:
            loads[k] = g.add(loads[k], g.mul(factor, node))
