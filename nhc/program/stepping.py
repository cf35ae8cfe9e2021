"""What bounds adaptive steps, in runs of any kind and in emitted drivers alike."""

from __future__ import annotations

from nhc.records import record

SAFETY = 0.01
"""Of the wanted accuracy, for each step: errors add up and grow."""
LEAST_TOLERANCE = 3e-15
FINEST = LEAST_TOLERANCE / SAFETY
"""With a finer accuracy steps are what they are with this one."""
MANY_STEPS = 10_000
"""From here on errors that all have one sign add up to a hundred times the accuracy and more, which is said."""
MOST_STEPS = 1_000_000_000


@record
class Limits:
    """When a run whose steps become ever shorter is given up, and an entry of the state that holds them up let go.

    After ``stride`` attempts it is asked whether the rest would take more than MOST_STEPS of the same length: whether less than
    ``few`` of it is done. ``patience``: how often in a row that is so before the run ends; past a singular place steps are that
    short too, for some hundred thousand. ``hopeless``: refusals in a row by errors that are none the less for the shorter step,
    after which an entry that is next to nothing is held to a millionth of the largest one. ``returns``: how often a run goes back
    to where steps were held to sizes that did not come, before no sizes to come are believed any more. ``trust``: the error of a
    refused step of an explicit method, relative to its end, up to which it tells how large the state becomes. ``power``: of the
    time, with which a state may grow in a step that tells this; dop853 sees none above 22, for the end has 1/22 of the weight.
    ``faint``: the part of the largest entry below which another one may be made by rounding. ``opening``: the first step's part
    of a run from rest, of explicit methods; about a tenth, and sin(18 deg)^2, for round parts of a run may be whole numbers of a
    force's periods. ``turn``: the radians of a clock, of what is periodic in time, in a step up to which the estimate of its
    error tells what the clock does; ``far``: those of dop853.
    """

    stride: int = 20_000
    patience: int = 50
    hopeless: int = 2
    returns: int = 20
    trust: float = 0.1
    power: float = 24.0
    faint: float = 1e-10
    opening: float = 0.09549150281252627
    turn: float = 2.0
    far: float = 3.0
    safety: float = SAFETY
    least_tolerance: float = LEAST_TOLERANCE

    @property
    def few(self) -> float:
        return self.stride / MOST_STEPS


LIMITS = Limits()
