"""Numbers that look like degrees where an angle in radians is meant: a slope of 30, a start at 45.

Nothing in a motion gives them away: sines of 30 rad are as good as those of 30 degrees.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from fractions import Fraction

from nhc.diagnostics import Bag, Label, Span
from nhc.language.expressions.constant import ConstantError, evaluate
from nhc.language.expressions.names import TIME
from nhc.language.expressions.syntax import Binary, Call, Name, Negate, Number, Syntax, children, walk
from nhc.language.spec import Constraint, Coordinate, Holonomic, Parameter, Spec
from nhc.language.units.dimensions import is_turned, parse_scale
from nhc.records import fresh, record, structure

_OF_ANGLES = frozenset(("sin", "cos", "tan"))
_LEAST, _STEP = 10, 5  # degrees are written as 10, 15, 45, 90


@record
class _Given:
    """A value, of a name or of none; ``where``: what it is, in a sentence."""

    name: str
    value: Fraction
    span: Span
    where: str


@structure
class _Sines:
    """What sines are taken of: ``angles`` and ``numbers`` are terms of sums; ``factors`` are names that multiply elsewhere."""

    angles: set[str] = fresh(factory=set)
    numbers: list[Number] = fresh(factory=list)
    factors: set[str] = fresh(factory=set)


def warn_of_degrees(spec: Spec, bag: Bag) -> None:
    """Add a warning (W0431) for each quantity that stands as an angle in sines, and has a round number of 10 and more, and for each
    such number among these angles, and among those that a rotation starts with.
    """
    sines = _read(spec)
    entries: tuple[Coordinate | Parameter, ...] = (*spec.coordinates, *spec.parameters)
    turned = {one.name for one in entries if one.unit and is_turned(parse_scale(one.unit))}  # which W0430 speaks of
    angles = sines.angles - turned - {one.name for one in spec.parameters if one.name in sines.factors}
    starts = [start for scene in spec.scenes for start in scene.initial if start.kind == "coordinate"]
    angles |= {start.value.name for start in starts if isinstance(start.value, Name) and start.name in angles}
    by_place = dict[str, dict[Span, _Given]]()
    for one in (*_numbers(sines.numbers), *_given(spec)):
        if one.value % _STEP == 0 and abs(one.value) >= _LEAST and (not one.name or one.name in angles):
            by_place.setdefault(one.name or str(one.span), {}).setdefault(one.span, one)
    for ones in by_place.values():
        _warn([*ones.values()], bag)


def _warn(ones: list[_Given], bag: Bag) -> None:
    first = ones[0]
    size = abs(first.value)
    labels = tuple(Label(other.span, f"and {other.value}") for other in ones[1:])
    turns, rest = divmod(float(size), 2 * math.pi)
    what = f"{size} rad are {turns:.0f} turn{'s' if turns >= 2 else ''} and {math.degrees(rest):.0f} degrees"
    note = f"functions of angles take radians; {what}"
    help = f"write `{first.value}*pi/180` if degrees are meant"
    message = f"`{first.name}` {first.where} {first.value}" if first.name else f"an angle of {first.value}"
    bag.warning("W0431", message, first.span, labels=labels, notes=(note,), help=(help,))


def _numbers(found: Iterable[Number]) -> Iterator[_Given]:
    for number in found:
        yield _Given("", number.value, number.span, "")


def _given(spec: Spec) -> Iterator[_Given]:
    """What is given as a number: parameters, scenes' own values of them, ranges and starts of coordinates."""
    for parameter in spec.parameters:
        yield from _plain(parameter.name, parameter.value, parameter.span, "is")
    for coordinate in spec.coordinates:
        for bound in coordinate.range or ():
            yield _Given(coordinate.name, bound, coordinate.span, "has a range to")
    for scene in spec.scenes:
        for override in scene.parameters:
            yield from _plain(override.name, override.value, override.span, "is")
        for start in scene.initial:
            if start.kind == "coordinate":
                yield from _plain(start.name, start.value, start.span, "starts at")


def _plain(name: str, value: Fraction | Syntax | None, span: Span, where: str) -> Iterator[_Given]:
    if isinstance(value, Fraction):
        yield _Given(name, value, span, where)
    elif value is not None and not any(isinstance(node, Name | Call) for node in walk(value)):
        try:
            yield _Given(name, Fraction(evaluate(value)), span, where)
        except ConstantError:
            return


def _read(spec: Spec) -> _Sines:
    """Of all expressions of the mechanics, and of starts; what a definition is made of is so with it."""
    equations: tuple[Constraint | Holonomic, ...] = (*spec.constraints, *spec.holonomic)
    rows = [side for row in equations for side in (row.left, row.right)]
    energies = [tree for tree in (spec.kinetic, spec.potential) if tree is not None]
    values = dict(spec.named_values)
    found = _Sines()
    for tree in (*energies, *rows, *values.values(), *(force.value for force in spec.forces)):
        _read_tree(tree, found)
    for start in (start for scene in spec.scenes for start in scene.initial):  # of quaternions, by angles
        _read_tree(start.value, found)
    waiting = [name for name in found.angles if name in values]
    while waiting:
        for term in _terms(values[waiting.pop()]):
            if isinstance(term, Name) and term.name not in found.angles:
                found.angles.add(term.name)
                waiting += [term.name] if term.name in values else []
    return found


def _read_tree(tree: Syntax, found: _Sines) -> None:
    """Its sines, and what stands as a factor outside of them."""
    stack = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, Call) and node.function in _OF_ANGLES:
            terms = list(_terms(node.arguments[0]))
            if any(isinstance(term, Name) and term.name == TIME for term in terms):
                continue  # beside the time itself stand times
            found.angles.update(term.name for term in terms if isinstance(term, Name))
            found.numbers += [term for term in terms if isinstance(term, Number)]
            continue
        parts = children(node)
        if isinstance(node, Binary) and node.op in "*/^":
            found.factors.update(part.name for part in parts if isinstance(part, Name))
        stack.extend(parts)


def _terms(tree: Syntax) -> Iterator[Name | Number]:
    """The names and numbers that are terms of a sum, by themselves: what a rate or a wave number multiplies is no angle."""
    stack: list[Syntax] = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, Name | Number):
            yield node
        elif isinstance(node, Negate):
            stack.append(node.operand)
        elif isinstance(node, Binary) and node.op in "+-":
            stack += (node.left, node.right)
        elif isinstance(node, Binary) and node.op in "*/":
            if isinstance(node.right, Number):
                stack.append(node.left)
            if isinstance(node.left, Number) and node.op == "*":
                stack.append(node.right)
