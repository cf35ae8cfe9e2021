"""Dimensional analysis: of everything where every coordinate and parameter has a unit, else of sums whose terms have them."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.diagnostics import Bag, Label, Span
from nhc.language.expressions.names import ENERGIES, PI, TIME
from nhc.language.expressions.syntax import (
    Binary,
    Call,
    Differential,
    Name,
    Negate,
    Number,
    Prime,
    Syntax,
    fold_tree,
    walk,
)
from nhc.language.orientation import angles_in
from nhc.language.scope import names_in
from nhc.language.spec import Constraint, Definition, Holonomic, Initial, Spec
from nhc.language.units.dimensions import (
    ENERGY,
    ONE,
    SECOND,
    Dimension,
    multiply,
    parse_unit,
    raise_to,
    show,
)
from nhc.records import record

_RATIO = "divide it by a parameter of the same unit"
_SAME = ("abs", "min", "max")  # functions whose value has the dimension of their arguments
_PER_SECOND = raise_to(SECOND, -1)
_PER_SECOND_2 = raise_to(SECOND, -2)
# an energy, or all of the mechanics divided by a mass or by a moment of inertia, which leaves the motion as it is
_KINETIC = (ENERGY, multiply(raise_to(parse_unit("m"), 2), _PER_SECOND_2), _PER_SECOND_2)


@record
class Quantity:
    """``dimension`` is None where it is not known; ``any`` marks the number 0, which fits everything.

    ``number`` is the value of an expression of numbers.  ``unfit``: a sum whose terms do not fit, which has been said; what else is
    added to it says nothing of the whole.
    """

    dimension: Dimension | None
    any: bool = False
    number: Fraction | None = None
    unfit: bool = False


_UNKNOWN = Quantity(None)
_UNFIT = Quantity(None, unfit=True)


class Checker:
    """Measures expressions of a spec; what does not fit goes into the bag."""

    def __init__(self, spec: Spec, bag: Bag, partial: bool = False) -> None:
        self.bag = bag
        self.partial = partial  # some have no unit, for which numbers and times may stand: sums alone are checked
        self.loose = False  # in starts, where a number beside a quantity has that one's unit
        self.seen: set[int] = set()  # angles of rotations, each of which stands in several parts of a quaternion
        self.told: set[tuple[str, Span]] = set()  # sums that do not fit: a place of a body stands in its components
        self.rotations = spec.rotations
        self.moving = {name for rotation in spec.rotations for name in rotation.velocities}
        self.names: dict[str, Quantity] = {TIME: _UNKNOWN if partial else Quantity(SECOND), PI: Quantity(ONE)}
        for name, unit in list_units(spec):
            self.names[name] = Quantity(parse_unit(unit)) if unit else _UNKNOWN
        for rotation in spec.rotations:
            self.names.update(dict.fromkeys(rotation.entries, Quantity(ONE)))
            self.names.update(dict.fromkeys(rotation.velocities, Quantity(_PER_SECOND)))

    def measure_named(self, spec: Spec) -> None:
        """Let the quantities of definitions and quasi-velocities be known, and which of them are velocities."""
        for name, value in spec.named_values:
            self.names[name] = self.measure(value)
            if any(
                isinstance(part, Prime) or (isinstance(part, Name) and part.name in self.moving) for part in walk(value)
            ):
                self.moving.add(name)

    def measure(self, tree: Syntax) -> Quantity:
        """Return the quantity of an expression; what does not fit in it is reported once, where it stands."""
        found = fold_tree(tree, self._visit)
        return _UNKNOWN if found.unfit else found

    def _visit(self, node: Syntax, parts: tuple[Quantity, ...]) -> Quantity:
        match node:
            case Number():
                return Quantity(None if self.partial else ONE, any=node.value == 0, number=node.value)
            case Name():
                return self.names.get(node.name, _UNKNOWN)
            case Differential():
                return self.names.get(node.name, _UNKNOWN)
            case Negate():
                number = parts[0].number
                return Quantity(parts[0].dimension, parts[0].any, -number if number is not None else None)
            case Prime():
                return self._scale(parts[0], _PER_SECOND)
            case Call():
                return self._call(node, parts)
            case Binary():
                return self._binary(node, parts[0], parts[1])

    @staticmethod
    def _scale(quantity: Quantity, by: Dimension) -> Quantity:
        return _UNKNOWN if quantity.dimension is None else Quantity(multiply(quantity.dimension, by), quantity.any)

    def _binary(self, node: Binary, left: Quantity, right: Quantity) -> Quantity:
        if node.op in "+-":
            result = self._common(node, left, right)
        elif node.op == "^":
            result = self._power(node, left, right)
        elif left.dimension is None or right.dimension is None:
            result = _UNKNOWN
        else:
            other = right.dimension if node.op == "*" else raise_to(right.dimension, -1)
            result = Quantity(multiply(left.dimension, other), left.any or (right.any and node.op == "*"))
        return Quantity(result.dimension, result.any, combine(node.op, left.number, right.number), result.unfit)

    def _common(self, node: Binary, left: Quantity, right: Quantity) -> Quantity:
        if left.unfit or right.unfit:
            return _UNFIT
        if left.any or right.any:
            return left if right.any else right
        if self.loose and (left.number is None) != (right.number is None):
            return right if right.number is None else left
        if left.dimension is None or right.dimension is None:
            return left if right.dimension is None else right
        if left.dimension != right.dimension:
            if self.partial and _may_hide(left.dimension, right.dimension):
                return _UNKNOWN
            word = "added to" if node.op == "+" else "less"
            what = f"{show(left.dimension)} {word} {show(right.dimension)}"
            if (what, node.operator) in self.told:
                return _UNFIT
            self.told.add((what, node.operator))
            labels = (Label(node.left.span, show(left.dimension)), Label(node.right.span, show(right.dimension)))
            bare = left.number is not None or right.number is not None
            missing = _lack_beside(left.dimension, right.dimension)
            help = ("a bare number has no unit: make it a parameter with its unit" if bare else missing,)
            self.bag.error("E0413", f"units do not fit: {what}", node.operator, labels=labels, help=help)
            return _UNFIT
        return Quantity(left.dimension)

    def _power(self, node: Binary, base: Quantity, exponent: Quantity) -> Quantity:
        if exponent.dimension not in (None, ONE) and not exponent.any:
            self._report(node.right, exponent, "an exponent must have no unit", _RATIO)
            return _UNKNOWN
        if base.dimension is None or base.dimension == ONE:
            return _UNKNOWN if base.unfit else base
        if exponent.number is None:
            help = "divide the base by a parameter of its unit, or write the exponent as a number"
            self._report(node.left, base, "a quantity with a unit takes constant exponents only", help)
            return _UNKNOWN
        return Quantity(raise_to(base.dimension, exponent.number), base.any)

    def _call(self, node: Call, parts: tuple[Quantity, ...]) -> Quantity:
        if node.function == "sqrt":
            return _UNKNOWN if parts[0].dimension is None else Quantity(raise_to(parts[0].dimension, Fraction(1, 2)))
        if node.function in (*_SAME, "atan2"):
            known = [(part, tree) for part, tree in zip(parts, node.arguments, strict=True) if not part.any]
            for part, tree in known[1:]:
                first, own = known[0][0].dimension, part.dimension
                if first is not None and own is not None and own != first:
                    rule = f"the arguments of `{node.function}` must have one unit"
                    self._report(tree, part, rule, _lack(first, own), always=not _may_hide(first, own))
                    return _UNKNOWN
            if node.function == "atan2":
                return Quantity(ONE)
            return known[0][0] if known else parts[0]
        if node.function != "sign":
            for part, tree in zip(parts, node.arguments, strict=True):
                if part.dimension not in (None, ONE) and not part.any:
                    self._report(tree, part, f"the argument of `{node.function}` must have no unit", _RATIO)
        return Quantity(ONE)

    def _report(self, tree: Syntax, quantity: Quantity, rule: str, help: str, always: bool = False) -> None:
        if self.partial and not always:
            return
        shown = show(quantity.dimension or ONE)
        self.bag.error("E0413", f"units do not fit: {rule}, found {shown}", tree.span, shown, help=(help,))

    def demand(self, tree: Syntax, wanted: tuple[Dimension, ...], what: str) -> Quantity:
        """Measure an expression and report one of another dimension than those wanted."""
        found = self.measure(tree)
        if self.partial:
            return found
        if wanted and found.dimension is not None and not found.any and found.dimension not in wanted:
            message = f"units do not fit: {what} must be {show(wanted[0])}, found {show(found.dimension)}"
            self.bag.error(
                "E0413", message, tree.span, show(found.dimension), help=(_lack(wanted[0], found.dimension),)
            )
            return _UNKNOWN
        return found

    def equate(self, item: Constraint | Holonomic) -> None:
        """Measure both sides of an equation and report different ones."""
        left, right = self.measure(item.left), self.measure(item.right)
        if left.any or right.any or None in (left.dimension, right.dimension) or left.dimension == right.dimension:
            return
        if self.partial and _may_hide(left.dimension or ONE, right.dimension or ONE):
            return
        message = f"units do not fit: {show(left.dimension or ONE)} = {show(right.dimension or ONE)}"
        label = Label(item.left.span, show(left.dimension or ONE))
        help = (_lack_beside(left.dimension or ONE, right.dimension or ONE),)
        self.bag.error("E0413", message, item.right.span, show(right.dimension or ONE), labels=(label,), help=help)


def _may_hide(left: Dimension, right: Dimension) -> bool:
    """Whether what a power of one base unit sets apart may be meant: a parameter with the value 1 is left out, as in y = x^2."""
    return sum(power != 0 for power in multiply(left, raise_to(right, -1))) < 2


def _lack(wanted: Dimension, found: Dimension) -> str:
    """What would make one dimension the other."""
    missing = multiply(wanted, raise_to(found, -1))
    return f"a factor with the unit {show(missing)} is missing, or a unit is declared wrongly"


def _lack_beside(left: Dimension, right: Dimension) -> str:
    """What would make either dimension the other: which of them is wrong is not known."""
    ahead, behind = multiply(right, raise_to(left, -1)), multiply(left, raise_to(right, -1))
    lacking = f"a factor with the unit {show(ahead)} is missing on the left, or one with {show(behind)} on the right"
    return f"{lacking}, or a unit is declared wrongly"


def combine(op: str, left: Fraction | None, right: Fraction | None) -> Fraction | None:
    """Return the value of an operation on numbers, as far as exponents need it."""
    if left is None or right is None or op == "^" or (op == "/" and right == 0):
        return None
    match op:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case _:
            return left / right


def list_units(spec: Spec) -> list[tuple[str, str]]:
    """Coordinates and parameters with their units' texts, empty where none is declared."""
    coordinates = [(coordinate.name, coordinate.unit) for coordinate in spec.coordinates]
    return [*coordinates, *((parameter.name, parameter.unit) for parameter in spec.parameters)]


def check_units(spec: Spec, bag: Bag, broken: Sequence[Span] = ()) -> None:
    """Report what does not fit (E0413); where a coordinate or parameter has no unit, only sums of what has one.

    Time is in seconds, numbers have no unit, 0 fits everything. T must be an energy (or an energy per mass or per
    moment of inertia), U and V the same as T, and a force times its coordinate too.  Expressions with a place in ``broken``,
    where there is another mistake, have no known unit.
    """

    def sound(*trees: Syntax) -> bool:
        return not any(tree.span.start <= place.start < tree.span.end for tree in trees for place in broken)

    turned = {name for rotation in spec.rotations for name in rotation.coordinates}
    units = [unit for name, unit in list_units(spec) if name not in turned]
    if not any(units):
        return
    checker = Checker(spec, bag, partial=not all(units))
    checker.measure_named(spec)
    kinetic = checker.demand(spec.kinetic, _KINETIC, "the kinetic energy") if sound(spec.kinetic) else _UNKNOWN
    energy = kinetic.dimension
    if spec.potential is not None and sound(spec.potential):
        checker.demand(spec.potential, (energy,) if energy else (), f"`{spec.potential_kind}`, like `T`,")
    for force in spec.forces:
        if sound(force.value):
            _check_force(checker, force, energy)
    equations: tuple[Constraint | Holonomic, ...] = (*spec.constraints, *spec.holonomic)
    for equation in equations:
        if sound(equation.left, equation.right):
            checker.equate(equation)
    for name in ENERGIES:
        checker.names.setdefault(name, kinetic)
    for output in spec.outputs:
        if sound(output.value):
            checker.measure(output.value)
    checker.loose = True
    for scene in spec.scenes:
        for start in scene.initial:
            if sound(start.value):
                _check_start(checker, start)
    checker.loose = False
    if not checker.partial:
        spec.memory["measured"] = checker, kinetic


def measured(spec: Spec) -> tuple[Checker, Quantity]:
    """A checker that knows what the spec names, and the quantity of T: that of :func:`check_units` where this went through."""
    known: tuple[Checker, Quantity] | None = spec.memory.get("measured")
    if known is None:
        checker = Checker(spec, Bag(spec.origin))  # what does not fit was told
        checker.measure_named(spec)
        known = spec.memory["measured"] = checker, checker.measure(spec.kinetic)
    return known


def _check_start(checker: Checker, start: Initial) -> None:
    """A start that speaks of parameters has the unit of what starts; one of numbers is in that unit already."""
    if any(start.name in rotation.coordinates for rotation in checker.rotations):
        for angle in angles_in(start.value):
            if id(angle) not in checker.seen:
                checker.seen.add(id(angle))
                checker.demand(angle, (ONE,), "the angle of a rotation")
        return
    dimension = checker.names.get(start.name, _UNKNOWN).dimension
    if dimension is None or all(name == PI for name in names_in(start.value)):
        return
    velocity = start.kind == "velocity"
    wanted = multiply(dimension, _PER_SECOND) if velocity else dimension
    checker.demand(start.value, (wanted,), f"the start of `{start.name}{chr(39) if velocity else ''}`")


def _check_force(checker: Checker, force: Definition, energy: Dimension | None) -> None:
    pushed = checker.names.get(force.name, _UNKNOWN).dimension
    if force.name in checker.moving and pushed is not None:
        pushed = multiply(pushed, raise_to(_PER_SECOND, Fraction(-1)))
    wanted: tuple[Dimension, ...] = ()
    if energy is not None and pushed is not None:
        wanted = (multiply(energy, raise_to(pushed, Fraction(-1))),)
    checker.demand(force.value, wanted, f"the force on `{force.name}`")
