"""What hidden holonomic constraints hold of a motion: integrals over q, which keep the values that its start gives them.

The steps of a search keep to the leaf of the start to first order only.  Where its integrals are known they are held, so that a
bicycle stays on its ground.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.graph import Node
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.properties.integrability import classify
from nhc.mechanics.properties.integrals import PositionIntegral, find_position_integrals
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.regular.undefined import are_defined
from nhc.mechanics.system import System
from nhc.study.linearization.field import Hold, SteadyModel


def leaf_integrals(system: System, formulation: Formulation) -> tuple[PositionIntegral, ...]:
    """The integrals of the constraints over q that are found."""
    if not system.l:
        return ()
    found = classify(system, formulation.frame)
    frame = coordinate_frame(system, choose_dependent(system).dependent)
    return find_position_integrals(system, frame, found.hidden, found.closed)


def defined_at(
    system: System, integrals: Sequence[PositionIntegral], place: dict[Node, float]
) -> list[tuple[str, Node]]:
    """Those that have a value at a place, with their texts."""
    shown = are_defined(system, [one.node for one in integrals], place)
    return [(one.text, one.node) for one, defined in zip(integrals, shown, strict=True) if defined]


def held_on_leaf(model: SteadyModel, guess: Sequence[float], integrals: Sequence[tuple[str, Node]]) -> SteadyModel:
    """The model whose searches keep the integrals at their values at the guess, where there is a steady motion with them."""
    return replace(model, leaf_holds=tuple(Hold(text, node, model.value(guess, node)) for text, node in integrals))
