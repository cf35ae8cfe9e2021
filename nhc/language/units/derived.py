"""Units of what a spec does not declare one for: velocities, quasi-velocities, outputs, the energy and the reactions."""

from __future__ import annotations

from nhc.language.expressions.names import ENERGIES
from nhc.language.expressions.syntax import Binary, Call, Differential, Name, Negate, Prime, Syntax, fold_tree, walk
from nhc.language.spec import Constraint, Holonomic, Spec, reaction_name
from nhc.language.units.check import list_units, measured
from nhc.language.units.dimensions import (
    ENERGY,
    SECOND,
    Dimension,
    base_words,
    multiply,
    parse_unit,
    raise_to,
    show,
)

_RATE = raise_to(SECOND, -1)
_SECOND = SECOND.index(1)
_FORCE = multiply(ENERGY, raise_to(parse_unit("m"), -1))
_TURNED = ("asin", "acos", "atan", "atan2")  # functions whose values are angles
_SAME = ("abs", "min", "max")


def derive_units(spec: Spec) -> dict[str, str]:
    """The unit of each name that a trajectory may have; names whose unit is not known are left out.

    They are coordinates, velocities ``x'``, quasi-velocities, outputs, ``energy`` and ``lambda_<constraint>``.  Declared units keep
    their spelling; others are products of the base units as the spec writes these (``km``, ``g``), and where it mixes
    scales (``m`` and ``cm``) there are none.
    """
    return _Deriver(spec).derive() if spec.time_unit else {}


def show_unit(spec: Spec, dimension: Dimension) -> str:
    """A unit of that dimension in the base units as the spec writes these; empty where it mixes scales."""
    words = base_words([unit for _, unit in list_units(spec) if unit])
    return "" if words is None else show(dimension, words)


class _Deriver:
    def __init__(self, spec: Spec) -> None:
        self.spec = spec
        self.words = base_words([unit for _, unit in list_units(spec) if unit])
        self.checker, self.kinetic = measured(spec)
        self.angles = {name for name, unit in list_units(spec) if unit == "rad"}
        self.angles.update(name for rotation in spec.rotations for name in rotation.velocities)
        self.angles.update(name for name, value in spec.named_values if fold_tree(value, self._turns))

    def derive(self) -> dict[str, str]:
        spec, names = self.spec, self.checker.names
        found = {c.name: c.unit for c in spec.coordinates}
        found.update((f"{c.name}'", self._rate(c.unit)) for c in spec.coordinates if c.unit)
        for quasi in spec.quasi_velocities:
            found[quasi.name] = self._name(names[quasi.name].dimension, quasi.name in self.angles)
        for rotation in spec.rotations:
            found.update((name, self._name(names[name].dimension, True)) for name in rotation.velocities)
        found["energy"] = self._name(self.kinetic.dimension, energy=True)
        rows: tuple[Constraint | Holonomic, ...] = (*spec.constraints, *spec.holonomic)
        found.update((reaction_name(row.name), self._reaction(row)) for row in rows)
        for name in ENERGIES:
            names.setdefault(name, self.kinetic)
        for output in spec.outputs:
            quantity = self.checker.measure(output.value)
            energy = any(isinstance(node, Name) and node.name in ENERGIES for node in walk(output.value))
            turning = fold_tree(output.value, self._turns)
            found[output.name] = "" if quantity.any else self._name(quantity.dimension, turning, energy)
        return {name: unit for name, unit in found.items() if unit}

    def _rate(self, unit: str) -> str:
        """That of a coordinate's velocity."""
        return self._name(multiply(parse_unit(unit), _RATE)) if "/" in unit else f"{unit}/s"

    def _reaction(self, row: Constraint | Holonomic) -> str:
        """That of lambda, which makes a force of the coefficients of the velocities: a power over the row, or an energy."""
        side = self.checker.measure(row.left)
        side = self.checker.measure(row.right) if side.any else side
        if self.kinetic.dimension is None or side.dimension is None or side.any:
            return ""
        in_velocities = isinstance(row, Constraint) and row.form == "velocity"
        divisor = multiply(side.dimension, SECOND) if in_velocities else side.dimension
        dimension = multiply(self.kinetic.dimension, raise_to(divisor, -1))
        return "N*m" if dimension == ENERGY and self._plain(dimension) else self._name(dimension)

    def _name(self, dimension: Dimension | None, turning: bool = False, energy: bool = False) -> str:
        """``turning``: an angle, or a quantity in which only an angle's radian was lost; ``energy``: joule may be said."""
        if dimension is None or self.words is None:
            return ""
        if dimension == _FORCE and self._plain(dimension):
            return "N"
        if energy and dimension == ENERGY and self._plain(dimension):
            return "J"
        text = show(dimension, self.words)
        if turning and dimension == raise_to(SECOND, dimension[_SECOND]):
            text = "rad" if text == "1" else text.replace("1/", "rad/", 1)
        return text

    def _plain(self, dimension: Dimension) -> bool:
        """Whether the spec's own base units are those of the SI."""
        return self.words is not None and show(dimension, self.words) == show(dimension)

    def _turns(self, node: Syntax, parts: tuple[bool, ...]) -> bool:
        """Whether an expression holds an angle as a factor of its terms: radians stay with numbers, and cancel each other."""
        match node:
            case Name() | Differential():
                return node.name in self.angles
            case Negate() | Prime():
                return parts[0]
            case Call():
                return node.function in _TURNED or (node.function in _SAME and any(parts))
            case Binary():
                if node.op in "+-":
                    return any(parts)
                return parts[0] != parts[1] if node.op == "*" else node.op == "/" and parts[0] and not parts[1]
            case _:
                return False
