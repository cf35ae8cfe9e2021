"""Which velocities that a scene gives contradict each other or the constraints, and what would fit."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.dense import RowSpace
from nhc.diagnostics import Bag
from nhc.language.spec import Initial, Scene
from nhc.records import record

TOLERANCE = 1e-9  # how far, relative to the size of its terms, a given start may be from satisfying the constraints
PROJECT = "or let `nhc run --project` move them to the nearest ones that fit"  # no help for the starts of a table


@record
class Claim:
    """``row`` times the velocities is ``right``, to ``size``'s rounding: a constraint, or with its ``entry`` what a scene gives.

    ``name`` and ``value`` are those of a message; ``declared``: the entry stands in the spec, where it has a place of its own, and
    not in an option.
    """

    name: str
    row: tuple[float, ...]
    right: float
    size: float
    entry: Initial | None = None
    value: float = 0.0
    declared: bool = False

    @property
    def text(self) -> str:
        """How a message calls it."""
        return f"`{self.name} = {self.value:.6g}`" if self.entry else f"the constraint `{self.name}`"


def meet(bag: Bag, scene: Scene, claims: Sequence[Claim], projecting: bool = False) -> RowSpace:
    """The equations of all claims but those that contradict the ones before them, each of which is reported (E0409).

    ``projecting``: the claims are only what the scene gives, for `--project` moves the velocities to the constraints.
    """
    solver, before = RowSpace(len(claims[0].row) if claims else 0), list[Claim]()
    given = [claim for claim in claims if claim.entry]
    movable = not projecting and not any(_contradicts(given[:k], claim) for k, claim in enumerate(given))
    for claim in claims:
        off = solver.add(claim.row, claim.right)
        if off is None or abs(off) <= TOLERANCE * claim.size:
            before.append(claim)
            continue
        others = _blamed(before, claim)
        among = all(one.entry for one in others)
        what = "contradict each other" if among else "violate the constraints"
        help = [_advise(claim, others), *([PROJECT] if movable else [])]
        why = ": `--project` can only move velocities that fit together" if projecting else ""
        bag.error(
            "E0409",
            f"the initial velocities of {scene.called} {what} by {abs(off):.3g}",
            claim.entry.span if claim.entry else scene.span,
            notes=(f"{claim.text} contradicts {_join(claim, others)}{why}",),
            help=(*help,),
        )
    return solver


def _contradicts(before: Sequence[Claim], claim: Claim) -> bool:
    space = RowSpace(len(claim.row))
    for one in before:
        space.add(one.row, one.right)
    off = space.add(claim.row, claim.right)
    return off is not None and abs(off) > TOLERANCE * claim.size


def _blamed(before: Sequence[Claim], claim: Claim) -> list[Claim]:
    """As few of the claims before as contradict it, and among them constraints only where the scene's values do not suffice."""
    left = [one for one in before if not one.entry] + [one for one in before if one.entry]
    for one in tuple(left):
        fewer = [other for other in left if other is not one]
        if _contradicts(fewer, claim):
            left = fewer
    return sorted(left, key=lambda one: one.entry is None)


def _join(claim: Claim, others: Sequence[Claim]) -> str:
    """What is contradicted, in words; it is nothing where all coefficients of the claim are zero."""
    own = bool(claim.entry) and not claim.declared  # who gave this may not see what the scene has
    names = [f"{one.text} of the scene" if own and one.declared else one.text for one in others]
    if len(names) < 3:
        return " and ".join(names) or "itself: its coefficients are zero there"
    return f"{', '.join(names[:-1])} and {names[-1]}"


def _advise(claim: Claim, others: Sequence[Claim]) -> str:
    """What to leave out, or which value would fit: that of the spec, whose reader asked for another one in an option."""
    given = [one for one in others if one.entry]
    if not claim.entry:
        return "start where the constraints can be satisfied"
    if not given:
        return f"leave `{claim.name}` out: it follows from the others"
    changed = min(reversed(given), key=lambda one: not one.declared)
    space = RowSpace(len(claim.row))
    for one in (*(one for one in others if one is not changed), claim):
        space.add(one.row, one.right)
    off = space.add(changed.row, changed.right)
    if off is None:
        return f"leave `{claim.name}` out: it follows from the others"
    fits = changed.value - off
    return f"leave `{claim.name}` out, or let `{changed.name}` be {fits:.12g}, which fits"
