"""Units of the velocities that nhc adds, as far as the spec's units tell them: v along an axle in m/s."""

from __future__ import annotations

from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, Node
from nhc.algebra.walks import reachable
from nhc.language.units.derived import show_unit
from nhc.language.units.dimensions import ONE, SECOND, Dimension, multiply, parse_unit, raise_to
from nhc.mechanics.added_forms import added_forms
from nhc.mechanics.frame import Frame, form_value, kept_forms
from nhc.mechanics.system import Form, System

_PER_SECOND = raise_to(SECOND, -1)
_SAME = ("abs", "min", "max")  # functions whose values have the unit of their arguments


def added_units(system: System, frame: Frame | None) -> dict[str, str]:
    """By name; those whose units are not known, or that add different ones, are left out."""
    added = added_forms(system, kept_forms(system, frame))
    if not added or not system.units:
        return {}
    measured = _measure_symbols(system)
    found = {}
    for form in added:
        dimension = _measure(system, measured, form)
        if dimension is not None:
            found[form.name] = show_unit(system.spec, dimension)
    return {name: unit for name, unit in found.items() if unit}


def _measure_symbols(system: System) -> dict[Node, Dimension | None]:
    found: dict[Node, Dimension | None] = {system.t: SECOND}
    for symbol, velocity, coordinate in zip(system.q, system.v, system.spec.coordinates, strict=True):
        found[symbol] = parse_unit(coordinate.unit) if coordinate.unit else None
        found[velocity] = multiply(parse_unit(coordinate.unit), _PER_SECOND) if coordinate.unit else None
    for symbol, parameter in zip(system.p, system.spec.parameters, strict=True):
        found[symbol] = parse_unit(parameter.unit) if parameter.unit else None
    return found


def _measure(system: System, measured: dict[Node, Dimension | None], form: Form) -> Dimension | None:
    """Of a form's value: of a line, in which each velocity is so many times it, what all of them agree on."""
    if form.line is None:
        return _dimension(system, measured, form_value(system, form))
    found = set()
    for j in form.line.columns:
        rate, entry = measured.get(system.v[j]), _dimension(system, measured, form.line.vector[j])
        if rate is None or entry is None:
            return None
        found.add(multiply(rate, raise_to(entry, -1)))
    return found.pop() if len(found) == 1 else None


def _dimension(system: System, known: dict[Node, Dimension | None], root: Node) -> Dimension | None:
    """Of an expression; None where it is not known, or where unlike things are added."""
    g = system.graph
    for node in reachable(g, [root], known=set(known)):
        if node in known:
            continue
        op, parts = g.op[node], [known.get(child) for child in g.kids[node]]
        made: Dimension | None = None
        if op == NUM:
            made = ONE
        elif op == MUL and None not in parts:
            first, second = (part for part in parts if part is not None)
            made = multiply(first, second)
        elif op in (ADD, NEG, *_SAME):
            made = parts[0] if all(part == parts[0] for part in parts) else None
        elif op == POW and parts[0] is not None:
            made = raise_to(parts[0], g.b[node])
        elif op == "sqrt" and parts[0] is not None:
            made = raise_to(parts[0], Fraction(1, 2))
        elif parts and all(part == ONE for part in parts):
            made = ONE
        known[node] = made
    return known.get(root)
