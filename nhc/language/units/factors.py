"""The numbers by which each quantity of a spec is multiplied somewhere, of which one may convert its unit."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from nhc.language.expressions.constant import ConstantError, evaluate
from nhc.language.expressions.names import PI
from nhc.language.expressions.syntax import Binary, Call, Differential, Name, Negate, Number, Prime, Syntax, fold_tree
from nhc.language.spec import Coordinate, Parameter, Spec
from nhc.language.units.dimensions import ONE, is_turned, parse_scale, parse_unit
from nhc.records import fresh, structure


@structure
class _Part:
    """Of a part of an expression: the numbers that are factors of it, and those that each name in it is multiplied by so far.

    ``open``: the names that what stands around it still multiplies; ``is_sum``: what a power of it does not.
    """

    factors: set[float] = fresh(factory=set)
    open: dict[str, set[float]] = fresh(factory=dict)
    is_sum: bool = False


class Factors:
    """``applied``: by the name of a coordinate, parameter or definition the numbers that multiply it in some expression."""

    def __init__(self, spec: Spec) -> None:
        self.applied: dict[str, set[float]] = {}
        self.numbers = dict(_converting(spec))
        within: dict[str, set[str]] = {}
        for name, value in spec.named_values:
            within[name] = set(self._measure(value))
        trees = [spec.kinetic, *(tree for tree in (spec.potential,) if tree is not None)]
        trees += [force.value for force in spec.forces]
        trees += [side for row in spec.constraints for side in (row.left, row.right)]
        trees += [side for row in spec.holonomic for side in (row.left, row.right)]
        trees += [start.value for scene in spec.scenes for start in scene.initial]
        for tree in trees:
            self._measure(tree)
        for name, _ in reversed(spec.named_values):  # what multiplies a definition multiplies what it is made of
            for other in within[name]:
                self.applied.setdefault(other, set()).update(self.applied.get(name, ()))

    def _measure(self, tree: Syntax) -> dict[str, set[float]]:
        """The names that are open in a whole expression."""
        part = fold_tree(tree, self._visit)
        self._close(part)
        return part.open

    def _close(self, part: _Part) -> None:
        for name, numbers in part.open.items():
            self.applied.setdefault(name, set()).update(numbers)

    def _visit(self, node: Syntax, parts: tuple[_Part, ...]) -> _Part:
        match node:
            case Number():
                return _Part({float(abs(node.value))} if node.value else set())
            case Name() if node.name in self.numbers:
                return _Part({self.numbers[node.name]})
            case Name() | Differential():
                return _Part(open={} if node.name == PI else {node.name: set()})
            case Negate() | Prime():
                return parts[0]
            case Binary() if node.op in "*/":
                first, second = parts
                found = {name: numbers | second.factors for name, numbers in first.open.items()}
                for name, numbers in second.open.items():
                    found[name] = found.get(name, set()) | numbers | first.factors
                return _Part(first.factors | second.factors, found, first.is_sum or second.is_sum)
            case Binary() if node.op in "+-":
                both = {name: numbers | parts[1].open.get(name, set()) for name, numbers in parts[0].open.items()}
                return _Part(open={**parts[1].open, **both}, is_sum=True)
            case Binary() if not parts[0].is_sum and not parts[1].open:
                return _Part(parts[0].factors, parts[0].open)
            case Binary() | Call():
                for part in parts:
                    self._close(part)
        return _Part()


def is_number(one: Coordinate | Parameter) -> bool:
    """Whether it is a parameter that may convert, as ``deg: pi/180`` without a unit or 1000 mm/m: no angle in degrees."""
    if not isinstance(one, Parameter):
        return False
    return not one.unit or (parse_unit(one.unit) == ONE and not is_turned(parse_scale(one.unit)))


def _converting(spec: Spec) -> Iterator[tuple[str, float]]:
    """Parameters that are numbers, with their values."""
    for one in filter(is_number, spec.parameters):
        try:
            value = (
                0.0
                if one.value is None
                else float(one.value if isinstance(one.value, Fraction) else evaluate(one.value))
            )
        except ConstantError:
            continue
        if value:
            yield one.name, abs(value)
