"""Units that do not go together: ``mm`` beside ``m``, ``kN`` beside kilogram and metre, ``deg`` beside sines.

Dimensions fit all the same, and nothing is converted, so that a length of 20 mm counts as 20 m.  Units go together where each is
the product of the same base units, whatever these are (centimetre, gram and second do): where factors of metre, kilogram and so on
exist that make every declared unit 1.  In logarithms that is a linear system, whose right-hand sides are powers of 2, 3, 5 and pi.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from nhc.diagnostics import Bag, Label
from nhc.language.expressions.syntax import Number, Syntax, walk
from nhc.language.spec import Coordinate, Parameter, Spec
from nhc.language.units.dimensions import (
    ONE,
    SECOND,
    Dimension,
    Scale,
    factor,
    multiply,
    parse_scale,
    parse_unit,
    raise_to,
)

_TURNED = "deg"
_CLOSE = 1e-3  # numbers that convert are rounded, as 57.3

_Row = tuple[Dimension, Scale]


def warn_of_scales(spec: Spec, bag: Bag) -> None:
    """Add a warning (W0430) where a unit does not go together with those before it, and no expression seems to convert any."""
    entries: tuple[Coordinate | Parameter, ...] = (*spec.coordinates, *spec.parameters)
    declared = [one for one in entries if one.unit]
    rows: list[_Row] = [(SECOND, parse_scale("s"))]
    for one in declared:
        dimension, scale = _reduce((parse_unit(one.unit), parse_scale(one.unit)), rows)
        if dimension != ONE:
            rows.append((dimension, scale))
        elif any(scale):
            if not any(_converts(number, scale) for number in _numbers(spec)):
                _warn(one, declared, scale, bag)
            return


def _reduce(row: _Row, rows: list[_Row]) -> _Row:
    """What is left of a row once the pivots of others, each its first power, are taken out of it."""
    for dimension, scale in rows:
        pivot = next(k for k, power in enumerate(dimension) if power)
        times = -Fraction(row[0][pivot]) / dimension[pivot]
        row = multiply(row[0], raise_to(dimension, times)), multiply(row[1], raise_to(scale, times))
    return row


def _numbers(spec: Spec) -> Iterator[Fraction]:
    """All that could convert a unit: numbers in expressions, and values of parameters without a unit, as of ``deg: pi/180``."""
    trees: list[Syntax] = [spec.kinetic, *(value for _, value in spec.named_values)]
    trees += [tree for tree in (spec.potential,) if tree is not None]
    trees += [item.value for item in (*spec.forces, *spec.outputs)]
    trees += [side for row in spec.constraints for side in (row.left, row.right)]
    trees += [side for row in spec.holonomic for side in (row.left, row.right)]
    for value in (one.value for one in spec.parameters if one.unit in ("", "1")):
        if isinstance(value, Fraction):
            yield value
        elif value is not None:
            trees.append(value)
    yield from (node.value for tree in trees for node in walk(tree) if isinstance(node, Number))


def _converts(number: Fraction, scale: Scale) -> bool:
    """Whether a number converts what has this scale, or a square or cube of it."""
    size = abs(math.log(factor(scale)))
    known = [size, size / 2, size / 3, size + math.log(math.pi), size + math.log(2 * math.pi)]  # 180 and 360 in pi/180
    return number != 0 and any(abs(abs(math.log(abs(number))) - wanted) < _CLOSE for wanted in known)


def _warn(one: Coordinate | Parameter, declared: list[Coordinate | Parameter], scale: Scale, bag: Bag) -> None:
    """That the unit of ``one`` is so many of what the others make."""
    dimension, own = parse_unit(one.unit), parse_scale(one.unit)
    alike = [
        other
        for other in declared[: declared.index(one)]
        if parse_unit(other.unit) == dimension and parse_scale(other.unit) != own
    ]
    times = f"{factor(scale):.6g}"
    labels: tuple[Label, ...] = ()
    if one.unit == _TURNED:
        message = f"`{one.name}` is in degrees, and functions of angles take radians"
        help = f"write `unit: rad`, and values times pi/180; or convert where it stands: `sin({one.name}*pi/180)`"
    elif alike:
        message = f"`{one.name}` is in {one.unit}, and `{alike[0].name}` in {alike[0].unit}"
        labels = (Label(alike[0].span, f"in {alike[0].unit}"),)
        help = f"give both in one unit: values in {one.unit} times {times} are in {alike[0].unit}"
    elif dimension == raise_to(SECOND, dimension[SECOND.index(1)]):
        message = f"`{one.name}` is in {one.unit}, and time is in seconds"
        help = f"give it in seconds: values times {times}"
    else:
        message = f"`{one.name}` is in {one.unit}, {times} times what the other units make"
        help = f"give it in the base units of the others: values times {times}"
    bag.warning(
        "W0430",
        message,
        one.span,
        labels=labels,
        help=(help,),
        notes=("nothing is converted: only dimensions are compared",),
    )
