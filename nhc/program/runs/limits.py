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
    """When a run whose steps become ever shorter is given up, when an entry of the state may no longer hold the others up, and how
    far an estimate of the error is believed.
    """

    stride: int = 20_000
    """Attempts at steps after which it is asked whether the rest of the run would take more than MOST_STEPS of that length."""
    patience: int = 50
    """How often in a row it would before the run ends; just past a singular place steps are that short too, some 1e5 of them."""
    glance: int = 500
    """Attempts after which it is asked whether the motion is held at a jump of the forces."""
    unimproved: int = 2
    """Refusals in a row whose error a shorter step did not lessen; then entries near zero are held to 1e-6 of the largest only."""
    returns: int = 20
    """How often a run goes back because entries did not grow as a refused step foretold; then such forecasts are ignored."""
    landings: int = 8
    """Attempts in a row that are to end at a corner, half of them after one whose error was too large; after them the error alone
    tells how long the next one is."""
    trust: float = 0.1
    """The error of a refused explicit step, relative to its end, up to which that end foretells how large entries become."""
    power: float = 24.0
    """The power of the time with which entries may grow in such a step; dop853, whose end weighs 1/22, sees none above 22."""
    faint: float = 1e-10
    """The part of the largest entry below which another one may be made by rounding."""
    steady: float = 16.0
    """How many times as long as the step after which it was asked what rounding makes of the slopes another one may be for the
    answer to hold."""
    shorter: float = 0.25
    """The part of the longest step since noise was measured to which steps have to come down before it is measured again."""
    opening: float = 0.09549150281252627
    """The first step of an explicit method from rest, as a part of the run: a tenth, but sin(18 deg)^2, since round parts of a
    run may be whole numbers of a force's periods."""
    turn: float = 2.0
    """Radians that a clock (what is periodic in time) may turn in a step for the estimate of the error to tell what it does."""
    far: float = 3.0
    """The same for dop853."""
    wild: float = 1.0
    """The last term of dop853's interpolant over the sum of the last but two and twice the last but one, beyond which a mode that
    is too fast for the step made it: 0.6 where the step is two time constants of that mode, 1.3 at three, 2.0 to 2.6 from four on;
    at most 0.5 in smooth motions."""
    within: float = 4e4
    """That term over what the end may err by, where rows and events are too far off: within the step the error is some 1e-7 of it
    times the accuracy wanted, a hundredth of which the end may err by."""
    caution: float = 0.85
    """Of the length that the controller of an explicit method gives the next step."""
    integral: float = 0.7
    """The controller's power of the error, by the method's exponent: length error^(-0.7/k) former^(0.4/k) (Gustafsson 1991; Hairer
    and Wanner 1996, sec. IV.2)."""
    proportional: float = 0.4
    """Its power of the error of the step before."""
    safety: float = SAFETY
    least_tolerance: float = LEAST_TOLERANCE

    @property
    def few(self) -> float:
        """The part of a run that ``stride`` steps take where the whole takes MOST_STEPS."""
        return self.stride / MOST_STEPS


LIMITS = Limits()
