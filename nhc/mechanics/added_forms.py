"""The velocities that nhc made for a motion to keep, in words."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.show import to_text
from nhc.mechanics.frame import Frame, form_value, kept_forms, velocity_symbol
from nhc.mechanics.system import Form, System

_LONGEST_FORM = 200
"""Characters of a form that is put into a sentence."""


def added_forms(system: System, forms: Iterable[Form]) -> list[Form]:
    """Those that nhc made: no velocities of coordinates, and none of the spec or of its rotations."""
    known = {*system.q_names, *(form.name for form in system.quasi)}
    return [form for form in forms if form.name not in known]


def describe_added(system: System, frame: Frame | None) -> dict[str, str]:
    """What the velocities are that nhc made for a motion to keep: their names, and their forms as the language writes them, or
    what a line makes of them where that is said sooner.

    Those of the spec and of rotations are known by their names, as are the coordinates' velocities.
    """
    return {form.name: _describe(system, form) for form in added_forms(system, kept_forms(system, frame))}


def _describe(system: System, form: Form) -> str:
    g, line = system.graph, form.line
    text = to_text(g, substitute(g, [form_value(system, form)], _by_angular(system))[0], _LONGEST_FORM)
    if line is None or not text.endswith("…"):
        return text
    omega = velocity_symbol(system, form)
    values = [(j, g.add(g.mul(line.vector[j], omega), line.carried[j])) for j in line.columns]
    return ", ".join(f"{system.q_names[j]}' = {to_text(g, value, _LONGEST_FORM)}" for j, value in values)


def _by_angular(system: System) -> dict[Node, Node]:
    """The angular velocities of rotations in what is made of them: without the numbers in front, which go elsewhere in products."""
    g, found = system.graph, dict[Node, Node]()
    for form in system.quasi:
        if form.name in system.angular:
            number, core = g.split_coefficient(form_value(system, form))
            found[core] = g.mul_number(1 / Fraction(number), velocity_symbol(system, form))
    return found
