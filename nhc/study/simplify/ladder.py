"""What came out of an approximate reduction."""

from __future__ import annotations

from nhc.program.scene_model import ENTRY
from nhc.records import record

NOTHING_SAVED = "nothing is saved without it"
NOT_MEASURED = "not measured"
"""How the reasons begin of what stays without being missed, and of what was not looked at."""


@record
class Size:
    """What a model costs: entries of its state, operations of its right-hand side, and how often a run evaluated it."""

    states: int
    operations: int
    calls: int

    @property
    def work(self) -> int:
        """What is made smaller: operations, with what an entry of the state costs in a run."""
        return self.operations + ENTRY * self.states

    @property
    def run_work(self) -> int:
        """The same over a run: what is smaller may need more steps, as where a fast motion is left without what damps it."""
        return self.work * self.calls


@record
class Price:
    """Measured seconds, the least of several: of one right-hand side, and of a run that keeps its end only."""

    rhs: float
    run: float


@record
class Rung:
    """One model: what it leaves out beyond the one before it, its errors (as the ladder's ``needs``), its size and price."""

    dropped: str
    errors: tuple[float, ...]
    size: Size
    price: Price

    @property
    def error(self) -> float:
        return max(self.errors)


@record
class Kept:
    """A candidate that stays, and why."""

    about: str
    reason: str


@record
class Ladder:
    """``rungs`` from the full model, whose errors are the reference's own, to the smallest within ``tolerance``.

    ``confirmed``: how the reference and the smallest model were measured once more, ``again`` the errors of the smallest then;
    ``ranges``: (name, least, largest, unit) of each coordinate and velocity of the full model on the scene; ``runs``:
    models that were measured, ``turned_back``: things that were left out, and put back for others; ``bounded``: the number of runs
    reached ``most``, so more might be left out; ``spec``: the text of the smallest model, without a header; ``changes``: what the
    scene has in place of what its spec says.
    """

    system: str
    scene: str
    time: tuple[float, float]
    points: int
    method: str
    compiled: bool
    tolerance: float
    run_tolerance: float
    confirmed: str
    again: tuple[float, ...]
    parameters: tuple[tuple[str, float], ...]
    needs: tuple[str, ...]
    ranges: tuple[tuple[str, float, float, str], ...]
    rungs: tuple[Rung, ...]
    kept: tuple[Kept, ...]
    runs: int
    turned_back: int
    most: int
    bounded: bool
    machine: str
    spec: str
    notes: tuple[str, ...]
    changes: tuple[str, ...] = ()

    @property
    def dropped(self) -> tuple[str, ...]:
        return tuple(rung.dropped for rung in self.rungs[1:])
