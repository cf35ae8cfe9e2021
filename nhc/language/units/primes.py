"""Primes that were lost, found by powers of time alone.

Whatever their units are otherwise, a coordinate has no power of the second, a velocity has s^-1, and what is added must have the
same power.  A parameter without a unit may have any, so powers are linear forms in unknown ones, which sums and equations
determine: ``m*(x' - r*w)`` says that ``r*w`` has s^-1.  Where no powers fit, and one prime more makes all of them fit, that prime
was most likely forgotten: a kinetic energy stays one without it, and nothing in the motion would give it away.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from fractions import Fraction

from nhc.diagnostics import Bag, Label
from nhc.language.expressions.names import PI, TIME
from nhc.language.expressions.syntax import (
    Binary,
    Call,
    Differential,
    Name,
    Negate,
    Number,
    Prime,
    Syntax,
    children,
    fold_tree,
    walk,
)
from nhc.language.spec import Spec
from nhc.language.units.check import combine, list_units
from nhc.language.units.dimensions import SECOND, parse_unit
from nhc.records import record

Power = dict[str, Fraction]  # of the second: unknown -> factor, "" -> what is known; None fits everything

_S = SECOND.index(1)
_ONE = Fraction(1)
_RATE: Power = {"": Fraction(-1)}
_PLAIN = ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log")  # of numbers, to numbers
_MOST = 200_000  # nodes that are looked at in search of a prime
_SHOWN = 3  # places
_PLAINEST, _FINEST = 2, 4  # the largest of numbers by themselves that stand for no parameter; quarters


def warn_lost_primes(spec: Spec, bag: Bag) -> None:
    """Add a warning (W0428) where one prime, and nothing else that is written, keeps powers of time from fitting."""
    named = _used(spec)
    if _fits(spec, named):
        return
    rows = [(row.left, row.right) for row in spec.constraints]
    groups = [*((value,) for _, value in named), (spec.kinetic,), *rows]
    places = {coordinate.name for coordinate in spec.coordinates}
    moving = {name for rotation in spec.rotations for name in rotation.velocities} | spec.velocities
    for name, value in named:
        held = {node.name for node in walk(value) if isinstance(node, Name)}
        if held & moving or any(isinstance(node, Prime) for node in walk(value)):
            moving.add(name)
        elif held & places:
            places.add(name)
    tried = [name for group in groups if _moves(group, moving) for tree in group for name in _unprimed(tree, places)]
    size = sum(1 for group in groups for tree in group for _ in walk(tree))
    most = max(1, _MOST // size)
    lost = list({name.span: name for name in tried[:most] if _fits(spec, named, name)}.values())[:_SHOWN]
    if not lost:
        return
    first, *others = lost
    bag.warning(
        "W0428",
        f"`{first.name}` may lack a prime: `{first.name}'`",
        first.span,
        labels=tuple(Label(name.span, f"or here: `{name.name}'`") for name in others),
        notes=("what is added must have one unit: the powers of time do not agree, and with one prime more they do",),
        help=("write the prime; where a parameter with the value 1 was left out, as in a rotating frame, write that",),
    )


def _used(spec: Spec) -> list[tuple[str, Syntax]]:
    """The definitions and quasi-velocities without those that only forces and outputs use, whose numbers may have any unit."""
    trees = [spec.kinetic, *(side for row in spec.constraints for side in (row.left, row.right))]
    wanted = {quasi.name for quasi in spec.quasi_velocities}
    wanted |= {node.name for tree in trees for node in walk(tree) if isinstance(node, Name | Differential)}
    used = []
    for name, value in reversed(spec.named_values):
        if name in wanted:
            used.append((name, value))
            wanted |= {node.name for node in walk(value) if isinstance(node, Name)}
    return used[::-1]


def _moves(trees: Iterable[Syntax], moving: Collection[str]) -> bool:
    """Whether an expression, or one side of an equation, contains velocities, so that others may be meant in it."""
    return any(
        isinstance(node, Prime) or (isinstance(node, Name) and node.name in moving)
        for tree in trees
        for node in walk(tree)
    )


def _unprimed(tree: Syntax, places: Collection[str]) -> Iterator[Name]:
    """The positions in a tree that could bear a prime: not in an angle, nor in an exponent."""
    stack = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, Name) and node.name in places:
            yield node
        elif isinstance(node, Binary) and node.op == "^":
            stack.append(node.left)
        elif not isinstance(node, Prime) and not (isinstance(node, Call) and node.function in _PLAIN):
            stack += reversed(children(node))


def _fits(spec: Spec, named: Sequence[tuple[str, Syntax]], primed: Name | None = None) -> bool:
    """Whether there are powers of time that fit, with a prime more at one name."""
    try:
        _Powers(spec, named, primed)
    except _Misfit:
        return False
    except _Unitless:
        return True
    return True


class _Unitless(Exception):
    """Time is a number in this spec, as in sin(t): its powers say nothing."""


class _Misfit(Exception):
    """Two powers that must be the same differ."""


@record
class _Part:
    """``number`` is the value of an expression of numbers."""

    power: Power | None
    number: Fraction | None = None


class _Powers:
    """The powers of time in a spec, with a prime more at one name.

    Raises:
        _Misfit: there are none.
    """

    def __init__(self, spec: Spec, named: Sequence[tuple[str, Syntax]], primed: Name | None) -> None:
        self.primed = primed
        self.found: dict[str, Power] = {}  # an unknown -> what it is in others
        self.free = 0
        rotated = [name for rotation in spec.rotations for name in (*rotation.coordinates, *rotation.entries)]
        self.names: dict[str, Power] = {PI: {}, TIME: {"": Fraction(1)}}
        for name, unit in list_units(spec):
            self.names[name] = {"": Fraction(parse_unit(unit)[_S])} if unit else {name: Fraction(1)}
        for coordinate in spec.coordinates:
            if not coordinate.unit:
                self.names[coordinate.name] = {}
        self.names |= {name: {} for name in rotated}
        self.names |= {name: _RATE for rotation in spec.rotations for name in rotation.velocities}
        for name, value in named:
            power = self._measure(value)
            self.names[name] = self._any() if power is None else power
        self._measure(spec.kinetic)
        for row in spec.constraints:
            self._equate(self._measure(row.left), self._measure(row.right))

    def _any(self) -> Power:
        """A new unknown: what a number has that may stand for a parameter."""
        self.free += 1
        return {f"#{self.free}": Fraction(1)}

    def _measure(self, tree: Syntax) -> Power | None:
        return fold_tree(tree, self._visit).power

    def _visit(self, node: Syntax, parts: tuple[_Part, ...]) -> _Part:
        match node:
            case Number():
                # 9.81 and 4 may stand for parameters; 2, 0.5 and 3/4 are of mathematics, and 0 is anything
                plain = node.value <= _PLAINEST and node.value.denominator <= _FINEST
                return _Part(None if not node.value else {} if plain else self._any(), node.value)
            case Name():
                power = self.names.get(node.name) or ({} if node.name in self.names else self._any())
                return _Part(_product(power, _RATE) if node is self.primed else power)
            case Differential():
                return _Part(self.names[node.name])
            case Negate():
                number = parts[0].number
                return _Part(parts[0].power, None if number is None else -number)
            case Prime():
                return _Part(_product(parts[0].power, _RATE))
            case Call():
                if node.function in _PLAIN and parts[0].power and any(_is_time(one) for one in walk(node)):
                    self._equate_number(parts[0].power)
                return _Part(self._call(node.function, [part.power for part in parts]))
            case Binary():
                left, right = parts
                return _Part(self._binary(node.op, left, right), combine(node.op, left.number, right.number))

    def _call(self, function: str, powers: list[Power | None]) -> Power | None:
        if function == "sqrt":
            return _product({}, powers[0], Fraction(1, 2))
        if function in ("abs", "sign"):
            return powers[0] if function == "abs" else {}
        # a number that stands for a parameter is at home in an argument, as in sin(2*t)
        self._equate(powers[0], {} if function in _PLAIN else powers[1], strict=False)
        if function in ("min", "max"):
            return powers[1] if powers[0] is None else powers[0]
        return {}

    def _binary(self, op: str, left: _Part, right: _Part) -> Power | None:
        if op in "+-":
            if left.number is not None or right.number is not None:  # 1 - x'^2
                return left.power if left.number is None else right.power
            self._equate(left.power, right.power)
            return right.power if left.power is None else left.power
        if op == "^":
            if right.number is None:
                self._equate(left.power, {}, strict=False)
                return {}
            return _product({}, left.power, right.number)
        if op == "/" and right.number is not None and right.number.denominator == 1:  # m*r^2/12, 7/10
            return left.power if left.number is None else {}
        if op == "/" and right.power is None:
            return left.power
        return _product(left.power, right.power, Fraction(1 if op == "*" else -1))

    def _equate_number(self, power: Power) -> None:
        """Let what time is part of be a number."""
        try:
            self._equate(power, {})
        except _Misfit:
            raise _Unitless from None

    def _equate(self, left: Power | None, right: Power | None, strict: bool = True) -> None:
        """Let two powers be the same: an unknown in them becomes known, or they fit, or they do not."""
        if left is None or right is None:
            return
        gap: Power = {}
        stack = list((_product(left, right, Fraction(-1)) or {}).items())
        while stack:
            unknown, factor = stack.pop()
            if unknown in self.found:
                stack += [(other, factor * by) for other, by in self.found[unknown].items()]
            else:
                gap[unknown] = gap.get(unknown, Fraction(0)) + factor
        gap = {unknown: factor for unknown, factor in gap.items() if factor}
        solved = next((unknown for unknown in gap if unknown), None)
        if solved is not None:
            by = gap.pop(solved)
            self.found[solved] = {unknown: -factor / by for unknown, factor in gap.items()}
        elif gap and strict:
            raise _Misfit


def _is_time(node: Syntax) -> bool:
    return isinstance(node, Name) and node.name == TIME


def _product(left: Power | None, right: Power | None, by: Fraction = _ONE) -> Power | None:
    """The power of ``left * right^by``."""
    if left is None or right is None:
        return None
    total = dict(left)
    for unknown, factor in right.items():
        total[unknown] = total.get(unknown, Fraction(0)) + factor * by
    return total
