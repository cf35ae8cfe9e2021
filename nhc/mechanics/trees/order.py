"""In which order the forms of a recursion are replaced by what they are made of.

What was joined to a form stays joined to what comes in its place until that is gone too: the fewer variables wait between the first
time that something made of them was replaced and their own turn, the shorter the code.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.mechanics.trees.recursion import Terms

_SHORTER = 0.75  # of the waiting, for which another order than that in which the forms were written is taken


def choose_order(rates: int, definitions: Sequence[Terms]) -> list[int]:
    """The forms' numbers, each after all that are made of it: the last written first, or by their distance from the root.

    The second is shorter where recursions run side by side along a chain, as those of its velocities and of what its constraints
    make of them do: the order of writing would take one of them from the leaves to the root before the other.
    """
    forms = range(rates, rates + len(definitions))
    written = list(reversed(forms))
    depth = _find_depths(rates, definitions)
    other = sorted(forms, key=lambda j: (depth[j], j), reverse=True)
    shorter = _waiting(rates, definitions, other) < _SHORTER * _waiting(rates, definitions, written)
    return other if shorter else written


def _find_depths(rates: int, definitions: Sequence[Terms]) -> list[int]:
    """How far from the root each variable is: a form is one farther than what it is made of, and no farther from what is made of it
    than it must be, so that a rod's own form and a velocity that a constraint gives go with the bodies that need them.
    """
    depth = [0] * rates
    for terms in definitions:
        depth.append(1 + max((depth[c] for c in terms), default=0))
    nearest: dict[int, int] = {}
    for j in reversed(range(rates, len(depth))):
        depth[j] = nearest.get(j, depth[j] + 1) - 1
        for c in definitions[j - rates]:
            nearest[c] = min(nearest.get(c, depth[j]), depth[j])
    return depth


def _waiting(rates: int, definitions: Sequence[Terms], order: Sequence[int]) -> int:
    """Steps that variables wait, summed: from the first time that something made of them is replaced to their own."""
    first: dict[int, int] = {}
    last: dict[int, int] = {}
    for step, j in enumerate(order):
        last[j] = step
        for c in definitions[j - rates]:
            first.setdefault(c, step)
            last[c] = step  # a rate goes with the last that holds it; a form comes later by itself
    return sum(last[c] - step for c, step in first.items())
