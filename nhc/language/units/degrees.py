"""Numbers that look like degrees where an angle in radians is meant: a slope of 30, a start at 45.

Nothing in a motion gives them away: sines of 30 rad are as good as those of 30 degrees.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction

from nhc.diagnostics import Bag, Label, Span
from nhc.language.expressions.syntax import Binary, Call, Name, Negate, Number, Syntax, walk
from nhc.language.spec import Constraint, Coordinate, Holonomic, Parameter, Spec
from nhc.language.units.dimensions import is_turned, parse_scale
from nhc.records import record

_OF_ANGLES = frozenset(("sin", "cos", "tan"))
_LEAST, _STEP = 10, 5  # degrees are written as 10, 15, 45, 90


@record
class _Given:
    """A value of a name; ``where``: what it is, in a sentence."""

    name: str
    value: Fraction
    span: Span
    where: str


def warn_of_degrees(spec: Spec, bag: Bag) -> None:
    """Add a warning (W0431) for each quantity that stands as an angle in sines, and has a round number of 10 and more."""
    given = [one for one in _given(spec) if abs(one.value) >= _LEAST and one.value % _STEP == 0]
    if not given:
        return
    angles = _angles(spec)
    entries: tuple[Coordinate | Parameter, ...] = (*spec.coordinates, *spec.parameters)
    declared = {one.name: one.unit for one in entries}
    by_name = dict[str, list[_Given]]()
    for one in given:
        unit = declared.get(one.name, "")
        if one.name in angles and not (unit and is_turned(parse_scale(unit))):  # which W0430 speaks of
            by_name.setdefault(one.name, []).append(one)
    for name, ones in by_name.items():
        first = ones[0]
        labels = tuple(Label(other.span, f"and {other.value}") for other in ones[1:])
        turns, rest = divmod(abs(float(first.value)), 2 * math.pi)
        what = f"{abs(first.value)} rad are {turns:.0f} turn{'s' if turns >= 2 else ''} and {math.degrees(rest):.0f} degrees"
        note = f"functions of angles take radians; {what}"
        help = f"write `{first.value}*pi/180` if degrees are meant"
        bag.warning(
            "W0431", f"`{name}` {first.where} {first.value}", first.span, labels=labels, notes=(note,), help=(help,)
        )


def _given(spec: Spec) -> Iterator[_Given]:
    """What is given as a plain number: parameters, scenes' own values of them, starts of coordinates."""
    for parameter in spec.parameters:
        yield from _plain(parameter.name, parameter.value, parameter.span, "is")
    for scene in spec.scenes:
        for override in scene.parameters:
            yield from _plain(override.name, override.value, override.span, "is")
        for start in scene.initial:
            if start.kind == "coordinate":
                yield from _plain(start.name, start.value, start.span, "starts at")


def _plain(name: str, value: Fraction | Syntax | None, span: Span, where: str) -> Iterator[_Given]:
    sign = 1
    while isinstance(value, Negate):
        value, sign = value.operand, -sign
    if isinstance(value, Number):
        value = value.value
    if isinstance(value, Fraction):
        yield _Given(name, sign * value, span, where)


def _angles(spec: Spec) -> set[str]:
    """The names whose value, times a number at most, is a term of what some sine is taken of."""
    equations: tuple[Constraint | Holonomic, ...] = (*spec.constraints, *spec.holonomic)
    rows = [side for row in equations for side in (row.left, row.right)]
    energies = [tree for tree in (spec.kinetic, spec.potential) if tree is not None]
    values = dict(spec.named_values)
    trees = [*energies, *rows, *values.values(), *(force.value for force in spec.forces)]
    found = set[str]()
    for tree in trees:
        for node in walk(tree):
            if isinstance(node, Call) and node.function in _OF_ANGLES:
                found.update(_terms(node.arguments[0]))
    waiting = [name for name in found if name in values]
    while waiting:
        for name in _terms(values[waiting.pop()]):
            if name not in found:
                found.add(name)
                waiting += [name] if name in values else []
    return found


def _terms(tree: Syntax) -> Iterable[str]:
    """The names that are terms of a sum, by themselves: what a rate or a wave number multiplies is no angle."""
    stack: list[Syntax] = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, Name):
            yield node.name
        elif isinstance(node, Negate):
            stack.append(node.operand)
        elif isinstance(node, Binary) and node.op in "+-":
            stack += (node.left, node.right)
        elif isinstance(node, Binary) and node.op in "*/":
            if isinstance(node.right, Number):
                stack.append(node.left)
            if isinstance(node.left, Number) and node.op == "*":
                stack.append(node.right)
