"""Units that do not go together: ``mm`` beside ``m``, ``kN`` beside kilogram and metre, ``deg`` beside sines.

Dimensions fit all the same, and nothing is converted, so that a length of 20 mm counts as 20 m.  Units go together where each is
the product of the same base units, whatever these are (centimetre, gram and second do): where factors of metre, kilogram and so on
exist that make every declared unit 1.  In logarithms that is a linear system, whose right-hand sides are powers of 2, 3, 5 and pi.
"""

from __future__ import annotations

import math
from fractions import Fraction

from nhc.diagnostics import Bag, Label
from nhc.language.spec import Coordinate, Parameter, Spec
from nhc.language.units.dimensions import (
    ONE,
    SECOND,
    Dimension,
    Scale,
    factor,
    is_turned,
    multiply,
    parse_scale,
    parse_unit,
    raise_to,
)
from nhc.language.units.factors import Factors, is_number
from nhc.records import record

_CLOSE = 1e-3  # numbers that convert are rounded, as 57.3


@record
class _Row:
    """A unit as logarithms; ``names``: the quantities it was made of, its own first."""

    dimension: Dimension
    scale: Scale
    names: tuple[str, ...]


def warn_of_scales(spec: Spec, bag: Bag) -> None:
    """Add a warning (W0430) for each unit that does not go together with those before it, and that no number seems to convert."""
    entries: tuple[Coordinate | Parameter, ...] = (*spec.coordinates, *spec.parameters)
    declared = [one for one in entries if one.unit]
    rows = [_Row(SECOND, parse_scale("s"), ())]
    numbers: dict[str, set[float]] | None = None
    alone = dict[str, list[Coordinate | Parameter]]()
    scales = dict[str, Scale]()
    for one in declared:
        left = _reduce(_Row(parse_unit(one.unit), parse_scale(one.unit), (one.name,)), rows)
        if left.dimension != ONE:
            rows.append(left)
        elif any(left.scale) and not is_number(one):
            numbers = Factors(spec).applied if numbers is None else numbers
            found = set[float]().union(*(numbers.get(name, ()) for name in left.names))
            if not any(_converts(number, left.scale) for number in found):
                alone.setdefault(one.unit, []).append(one)
                scales[one.unit] = left.scale
    for unit, ones in alone.items():
        _warn(ones, declared, scales[unit], bag)


def _reduce(row: _Row, rows: list[_Row]) -> _Row:
    """What is left of a row once the pivots of others, each its first power, are taken out of it."""
    for other in rows:
        pivot = next(k for k, power in enumerate(other.dimension) if power)
        times = -Fraction(row.dimension[pivot]) / other.dimension[pivot]
        if times:
            dimension = multiply(row.dimension, raise_to(other.dimension, times))
            scale = multiply(row.scale, raise_to(other.scale, times))
            row = _Row(dimension, scale, (*row.names, *other.names))
    return row


def _converts(number: float, scale: Scale) -> bool:
    """Whether a number converts what has this scale, or a square or cube of it."""
    size = abs(math.log(factor(scale)))
    known = [size, size / 2, size / 3]
    if is_turned(scale):  # 180 and 360, which pi is written beside
        known += [size + math.log(math.pi), size + math.log(2 * math.pi)]
    return any(abs(abs(math.log(number)) - wanted) < _CLOSE for wanted in known)


def _warn(ones: list[Coordinate | Parameter], declared: list[Coordinate | Parameter], scale: Scale, bag: Bag) -> None:
    """That the unit of these is so many of what the others make."""
    one = ones[0]
    dimension, own = parse_unit(one.unit), parse_scale(one.unit)
    alike = [
        other
        for other in declared[: declared.index(one)]
        if parse_unit(other.unit) == dimension and parse_scale(other.unit) != own
    ]
    times = f"{factor(scale):.6g}"
    labels = tuple(Label(other.span, f"in {one.unit}, too") for other in ones[1:])
    if is_turned(own):
        what = "degrees" if one.unit == "deg" else one.unit
        message = f"`{one.name}` is in {what}, and functions of angles take radians"
        help = f"write `{one.unit.replace('deg', 'rad')}`, and values times pi/180; or convert where it stands: `{one.name}*pi/180`"
    elif alike:
        message = f"`{one.name}` is in {one.unit}, and `{alike[0].name}` in {alike[0].unit}"
        labels = (Label(alike[0].span, f"in {alike[0].unit}"), *labels)
        help = f"give both in one unit: values in {one.unit} times {times} are in {alike[0].unit}"
    elif dimension == raise_to(SECOND, dimension[SECOND.index(1)]):
        message = f"`{one.name}` is in {one.unit}, and time is in seconds"
        help = f"give it in seconds: values times {times}"
    else:
        message = f"`{one.name}` is in {one.unit}, {times} times what the other units make"
        help = f"give it in the base units of the others: values times {times}"
    note = "nothing is converted: only dimensions are compared"
    bag.warning("W0430", message, one.span, labels=labels, notes=(note,), help=(help,))
