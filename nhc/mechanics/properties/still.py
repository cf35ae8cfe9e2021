"""What of T and of the constraints holds no velocity: it comes from what moves by itself, or from a prime that was forgotten."""

from __future__ import annotations

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import Unlucky, are_zero, is_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.algebra.solving.linear import degrees, depends
from nhc.mechanics.properties.named import LONG, is_cut, named_text
from nhc.mechanics.system import System

_LONGEST = 60  # characters
_TERMS = 40


def describe_kinetic(system: System, explain: bool) -> str:
    """How T depends on the velocities, and its terms that hold none; expressions between dollar signs."""
    if degrees(system.graph, system.v)[system.T] != 2:
        return "no polynomial of degree 2 in the velocities"
    text = "quadratic in the velocities"
    if not explain:
        return text
    g, rest = system.graph, dict.fromkeys(system.v, system.graph.zero)
    still, *momenta = substitute(g, [system.T, *gradient(g, system.T, system.v)], rest, named=False)
    if all(are_zero(g, [still, *momenta])):
        return f"homogeneous {text}"
    shown = "" if is_zero(g, still) else f" (without velocities {_shown(system, still)})"
    return f"{text}, with terms of lower degree{shown}"


def describe_affine(system: System) -> str:
    """That constraints are affine, and what holds no velocity in the first that is; expressions between dollar signs."""
    g = system.graph
    moved = [form for form in system.constraints if not is_zero(g, form.constant)]
    if not moved:
        return "affine"
    more = f" and in {len(moved) - 1} more" if len(moved) > 1 else ""
    return f"affine (without velocities {_shown(system, moved[0].constant)} in `{moved[0].name}`{more})"


def _shown(system: System, node: Node) -> str:
    node = _at_start(system, node)
    forms = dict.fromkeys((node, normalise_angles(system.graph, node, _TERMS)))
    text = min((named_text(system, form, _LONGEST) for form in forms), key=len)
    return LONG if is_cut(text) else f"${text}$"


def depends_on_time(system: System, node: Node) -> bool:
    """Exactly where that can be decided: the square of a velocity on turning axes holds the time, and does not depend on it."""
    g = system.graph
    if not g.depends(node, g.deps[system.t]):
        return False
    try:
        return depends(g, [node], [system.t])[0]
    except Unlucky:
        return True


def _at_start(system: System, node: Node) -> Node:
    """The same without the time, where that is in it only by sight."""
    if depends_on_time(system, node):
        return node
    try:
        return substitute(system.graph, [node], {system.t: system.graph.zero}, named=False)[0]
    except ArithmeticError:  # it is written with a pole there
        return node
