"""Whether two specs describe the same motion, with what a person needs to find the mistake where they do not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.graph import Node
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.language.units.dimensions import UnitError, base_words, parse_unit
from nhc.mechanics.certificates.certificate import SURE, log10_of_passing
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.pairs.pairing import Pairing, pair
from nhc.mechanics.pairs.points import Found, PairPoints
from nhc.mechanics.pairs.states import Measured, count_fitting, measure_pair
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.mechanics.values import parameter_value
from nhc.records import record

_ROUNDING = 1e-6
"""Double precision may lose this much to a badly conditioned state."""
_SEEN = 1e-11
"""A difference that is no rounding at ordinary states."""


@record
class Comparison:
    """``found`` is exact, at points of a prime field; ``measured`` in double precision.
    ``bare`` is what is found without potentials and forces, where the accelerations differ.

    ``on_leaf`` tells whether the points lie where the equations of positions hold; otherwise they lie on all levels of these, and
    a difference counts if the states, which are on the equations, show it.  That the first's equations of positions hold where the
    second's do is seen in double precision alone at ``fitting`` positions, where there are any.  ``notes`` are what else differs.
    """

    names: tuple[str, str]
    pairing: Pairing
    found: Found
    bare: Found | None
    on_leaf: bool
    fitting: int
    measured: Measured
    suspects: tuple[tuple[str, ...], tuple[str, ...]]
    notes: tuple[str, ...]

    @property
    def by_states(self) -> bool:
        """Whether the accelerations are compared at states alone: elsewhere than at the positions that are allowed, they differ."""
        return not all(self.found.equal) and self.measured.states > 0 and not self.on_leaf and self.largest <= _ROUNDING

    @property
    def is_open(self) -> bool:
        """Whether accelerations that the exact test tells apart are the same in double precision: the difference is small, or an
        identity that the field does not know, such as log(x y) = log(x) + log(y).
        """
        different = not all(self.found.equal) and not self.by_states
        return different and self.measured.states > 0 and self.largest <= _SEEN

    @property
    def largest(self) -> float:
        """The largest difference in double precision."""
        return max(self.measured.differences, default=0.0)

    @property
    def agrees(self) -> bool:
        """Velocities and accelerations are the same, and double precision does not contradict it."""
        found = self.found
        same = bool(found.equal) and (all(found.equal) or self.by_states)
        return same and self.largest <= _ROUNDING

    @property
    def log10_bound(self) -> float:
        """log10 of the probability that a difference passes the points."""
        return log10_of_passing(self.found.degree, self.found.signs, self.found.primes)

    @property
    def is_sure(self) -> bool:
        """Whether no difference can have passed."""
        return self.log10_bound <= SURE


def compare_specs(first: Source, second: Source, maps: Sequence[str], names: tuple[str, str]) -> Comparison:
    """Compare two specs; ``names`` are what they are called, ``maps`` texts such as ``theta=phi, x=l*sin(phi)``.

    Raises:
        nhc.diagnostics.SpecError: a spec has errors, the maps are wrong, or there is nothing to compare (E0506).
        nhc.algebra.exact.modular.Unlucky: no point was found where both have a motion.
    """
    systems = [resolve(decode(source)) for source in (first, second)]
    for system in systems:
        equations_of(system, formulate(system))  # refuses what the forces do not determine
    return compare_systems(systems[0], systems[1], maps, names)


def compare_systems(first: System, second: System, maps: Sequence[str], names: tuple[str, str]) -> Comparison:
    """Compare two systems, each on a graph of its own, as far as they have coordinates in common; raises the same."""
    pairing = pair(first, second, maps)
    points = PairPoints(pairing)
    found = points.look()
    fitting = count_fitting(points, names) if not (found.same_places or points.on_leaf) else 0
    if fitting:
        found = replace(found, off=())
    if not found.same_places:
        found = replace(found, equal=())  # there is no state in which both are
    measured = measure_pair(points, names) if found.equal else Measured()
    bare = None
    if not all(found.equal) and any(map(_is_driven, (pairing.first, pairing.second))):
        bare = PairPoints(replace(pairing, first=_undriven(pairing.first), second=_undriven(pairing.second))).look()
    open_leaf = bool(found.off) and found.places[0] < found.places[1]
    on_leaf = points.on_leaf and not open_leaf
    notes = (*_told_by_ranges(points, names, found), *_other_values(pairing, names), *_other_units(pairing, names))
    return Comparison(names, pairing, found, bare, on_leaf, fitting, measured, _suspects(points), notes)


def _is_driven(system: System) -> bool:
    return any(node != system.graph.zero for node in (system.U, *system.Q))


def _undriven(system: System) -> System:
    zero = system.graph.zero
    still = ((zero, zero, zero),) * len(system.torques)
    return replace(system, U=zero, Q=(zero,) * system.n, torques=still, pulls=None)


def _suspects(points: PairPoints) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Coordinates that only one of the systems has and that its equations hold."""
    g, pairing = points.graph, points.pairing
    first, second = pairing.first, pairing.second
    symbols = [
        [(first.q_names[i], g.symbol(first.q_names[i], "coordinate")) for i in pairing.alone[0]],
        [(second.q_names[j], second.q[j]) for j in pairing.alone[1]],
    ]
    found = []
    for laws, own in zip(points.laws, symbols, strict=True):
        found.append(tuple(name for name, node in own if _holds(points, laws.nodes(), node)))
    return found[0], found[1]


def _holds(points: PairPoints, nodes: Sequence[Node], symbol: Node) -> bool:
    return any(points.graph.depends(node, points.graph.deps[symbol]) for node in nodes)


def _told_by_ranges(points: PairPoints, names: tuple[str, str], found: Found) -> list[str]:
    """Coordinates in whose ranges alone roots are what they were taken for, or would be."""
    notes = []
    if points.ranged:
        known = ", ".join(f"`{name}`" for name in points.ranged)
        notes.append(f"signs of roots are those in the range of {known} in {names[1]}")
    for name in points.unsigned if not found.agrees else ():
        notes.append(
            f"a root is |{name}| here: give `{name}` a range in {names[1]}, as `range: [0, 1e3]`, if it is never negative"
        )
    return notes


# --- what else differs --------------------------------------------------------------------------------------


def _other_values(pairing: Pairing, names: tuple[str, str]) -> list[str]:
    """Parameters that are compared at equal values and have other ones in the specs."""
    second = dict(zip(pairing.second.p, pairing.second.spec.parameters, strict=True))
    images, notes = dict(pairing.parameters), []
    for p, entry in zip(pairing.first.p, pairing.first.spec.parameters, strict=True):
        other = second.get(images.get(p, -1))
        if other is None or entry.value is None or other.value is None:
            continue
        x, y = parameter_value(entry.value), parameter_value(other.value)
        if not math.isclose(x, y, rel_tol=1e-12, abs_tol=0.0):
            notes.append(f"`{entry.name}` is {x:g} in {names[0]} and {y:g} in {names[1]}: equal values were compared")
    return notes


def _other_units(pairing: Pairing, names: tuple[str, str]) -> list[str]:
    """Units that are not the same: numbers are compared, nothing is converted."""
    first, second = pairing.first, pairing.second
    places = [(i, pairing.place_of(i)) for i in pairing.common]
    pairs = [(first.spec.coordinates[i], second.spec.coordinates[j]) for i, j in places if j is not None]
    own = dict(zip(second.p, second.spec.parameters, strict=True))
    images, notes = dict(pairing.parameters), []
    units = [(x.name, x.unit, y.unit) for x, y in pairs]
    for p, entry in zip(first.p, first.spec.parameters, strict=True):
        other = own.get(images.get(p, -1))
        if other is not None:
            units.append((entry.name, entry.unit, other.unit))
    for name, x, y in units:
        if x and y and x != y and not _same_unit(x, y):
            notes.append(f"`{name}` is in {x} in {names[0]} and in {y} in {names[1]}: the numbers were compared")
    return notes


def _same_unit(x: str, y: str) -> bool:
    try:
        return parse_unit(x) == parse_unit(y) and base_words([x, y]) is not None
    except UnitError:
        return False
