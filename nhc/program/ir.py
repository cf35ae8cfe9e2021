"""The intermediate representation that every emitter prints.

Supported: straight-line functions over scalars; loads, lets, guards, dense solves, stores, one scalar result; another function's
output at the same arguments; statements repeated for one direction after the other (derivatives).
Not supported, on purpose: other loops, branches, arrays as values, side effects.

Names in the IR are identifiers over ``[A-Za-z0-9_]``, unique in their function; a language's own reserved words
are that language's affair (``emit/<language>/names.py``).
"""

from __future__ import annotations

from fractions import Fraction

from nhc.records import record

# --- expressions -----------------------------------------------------------------------------------------


@record
class Number:
    """An exact rational; the printer rounds it once, to the nearest double."""

    value: Fraction


@record
class Pi:
    """The circle's number."""


@record
class Ref:
    """A name that an earlier Load, Let or Solve of the same function has bound."""

    name: str


@record
class Negate:
    operand: Expr


@record
class Binary:
    """``op`` is one of ``+ - * /``."""

    op: str
    left: Expr
    right: Expr


@record
class Power:
    """An integer power with ``exponent >= 2`` that was not worth unrolling, or a negative one."""

    base: Expr
    exponent: int


@record
class Call:
    """A function of the language: sin cos tan asin acos atan atan2 sinh cosh tanh exp log sqrt abs sign min max,
    and ``pow`` (a power whose exponent is no integer).
    """

    function: str
    arguments: tuple[Expr, ...]


Expr = Number | Pi | Ref | Negate | Binary | Power | Call

# --- statements ------------------------------------------------------------------------------------------


@record
class Origin:
    """Where a statement comes from: the number of the equation and the place in the spec."""

    equation: str = ""  # "I.2.15"
    place: str = ""  # "chaplygin_sleigh.yaml:14:4"


@record
class Section:
    """A comment that heads the statements after it, e.g. "from the parameters alone"."""

    title: str
    origin: Origin = Origin()


@record
class Load:
    """``name = array[index]``; for ``t``, ``array`` is "t" and ``index`` is -1 (a scalar argument)."""

    name: str
    array: str
    index: int
    about: str = ""  # "heading [rad]"
    quantity: str = ""  # as the spec writes it: "theta", "theta'"


@record
class Let:
    name: str
    value: Expr
    origin: Origin = Origin()


@record
class Guard:
    """Leave with the nonzero status ``status`` unless ``|value| > tolerance * scale`` (so a NaN leaves too)."""

    value: Expr
    scale: Expr
    tolerance: float
    status: int
    what: str  # "the block of dependent velocities (y) is singular"


@record
class Solve:
    """Dense ``matrix @ x = column`` for each column, by elimination with row pivoting; ``names[c][i]`` binds x_i of column c.

    Leaves with ``status`` when a pivot is no larger than ``tolerance`` times the largest entry of its row of the matrix, in units
    of the unknowns in which the first ``masses`` entries of the diagonal are one, and the largest entry of each multiplier's column
    beside them, too: neither the units of the coordinates nor a factor of a constraint may decide what is singular.
    ``matrix[i][j]`` and ``columns[c][i]`` are expressions (often Number(0)).
    """

    matrix: tuple[tuple[Expr, ...], ...]
    columns: tuple[tuple[Expr, ...], ...]
    names: tuple[tuple[str, ...], ...]
    tolerance: float
    status: int
    what: str
    plain: bool = False
    """The matrix has neither masses nor multipliers: the unknowns have the units that they come in."""

    @property
    def masses(self) -> int:
        """The number of unknowns before those that stand beside a block of zeros."""
        masses = 0 if self.plain else len(self.matrix)
        while masses and all(entry == Number(Fraction(0)) for entry in self.matrix[masses - 1][masses - 1 :]):
            masses -= 1
        return masses


@record
class Store:
    """``array[index] = value``."""

    array: str
    index: int
    value: Expr
    about: str = ""  # "theta''"
    origin: Origin = Origin()


@record
class Result:
    """The scalar value of a function that returns one (energy)."""

    value: Expr
    origin: Origin = Origin()


@record
class Evaluate:
    """``array`` becomes the output of the program's ``function`` at this function's own arguments; comes before all loads."""

    function: str
    array: str
    size: int


@record
class Sweep:
    """``body`` once for each entry of ``offsets``: in pass k the name ``seeds[k]`` is 1 and the other seeds are 0.

    ``body`` holds lets and stores, is linear in the seeds, and may use what stands before it; the index of its stores counts
    from the pass's offset.  The passes are independent, so that several may run at once in vectors.
    """

    about: str
    seeds: tuple[str, ...]
    offsets: tuple[int, ...]
    body: tuple[Let | Store, ...]


Statement = Section | Load | Let | Guard | Solve | Store | Result | Evaluate | Sweep


@record
class Argument:
    """``t`` has no size; others are arrays of ``size`` doubles."""

    name: str
    size: int  # -1 for a scalar


@record
class Function:
    """``name`` without the system's prefix: rhs, velocities, ...

    ``output`` is the array that Stores write (None: a scalar Result). ``finite`` says that the emitter must leave with a nonzero
    status when an output is not finite (every function that can meet a singular point of the spec's own expressions).
    ``otherwise`` stands in for it, at the same arguments, where it would leave with the status 1: it does not depend on an order.
    """

    name: str
    about: str
    inputs: tuple[Argument, ...]
    output: Argument | None
    body: tuple[Statement, ...]
    equation: str = ""
    adds: int = 0
    multiplications: int = 0
    divisions: int = 0
    calls: int = 0
    otherwise: Function | None = None


@record
class Quantity:
    """A name of the spec with what is known of it."""

    name: str  # as the spec writes it (Greek folded): "theta", "theta'", "v"
    unit: str = ""
    about: str = ""
    default: Fraction | float | None = None


Stop = tuple[float, float]
"""Where a step has to end: the last time before a jump and the first after it, or the same time twice where nothing jumps."""


@record
class SceneData:
    """What a driver needs: a consistent start. ``y`` and ``p`` are doubles in the program's order.

    ``stops``: in the order of the time.
    """

    name: str
    about: str
    y: tuple[float, ...]
    p: tuple[float, ...]
    time: tuple[float, float]
    need: tuple[str, ...]
    tolerance: float
    stops: tuple[Stop, ...] = ()


@record
class Lookout:
    """What a driver keeps an eye on: values of ``function`` whose change of sign ends its run, with what each would mean.

    Those from ``dips`` on are sought where they only touch zero.
    """

    function: Function
    losses: tuple[str, ...]
    dips: int


CORNER = 0.0, 0.0  # of an argument at whose zero steps end


@record
class Leaps:
    """What a step must not leap over (:mod:`nhc.program.runs.leaps`): ``function`` gives arguments; ``held``: that they stay zero.

    ``parts``, of each: the part of it by which it may change in a step towards zero, and by how much always; no part: a corner.
    """

    function: Function
    parts: tuple[tuple[float, float], ...]
    held: tuple[str, ...]

    @property
    def lands(self) -> bool:
        """Whether steps end at some of its zeros."""
        return CORNER in self.parts


@record
class Beats:
    """How fast what is periodic in time goes (:mod:`nhc.program.runs.beats`): ``function`` gives rates, which are ``steady``
    where they do not depend on the time.
    """

    function: Function
    steady: bool


@record
class Hold:
    """What brings a driver's state back to its constraints: after each step ``calls`` in their order, in each the first name, and
    the next one where that returns ``status``.  ``torn``: what it means that a short step is moved far.
    """

    functions: tuple[Function, ...]
    calls: tuple[tuple[str, ...], ...]
    status: int
    what: str
    torn: str


@record
class Needed:
    """What a driver computes by a function of its own, for none of the model's gives it: ``names``, in the order of its output."""

    function: Function
    names: tuple[str, ...]


@record
class Driving:
    """What a driver or a run needs beside the functions: what ends a step or a run, what brings a step's end back to the
    constraints, and what scenes need that is no part of the state; None where there is nothing to do.
    """

    lookout: Lookout | None = None
    hold: Hold | None = None
    needed: Needed | None = None
    leaps: Leaps | None = None
    beats: Beats | None = None


NO_DRIVING = Driving()


@record
class Program:
    system: str
    about: str
    formulation: str
    equation: str  # the equations of motion's number, "I.2.15"
    reason: str  # why this formulation
    coordinates: tuple[Quantity, ...]
    state: tuple[Quantity, ...]
    parameters: tuple[Quantity, ...]
    constraints: tuple[Quantity, ...]
    outputs: tuple[Quantity, ...]
    functions: tuple[Function, ...]
    scenes: tuple[SceneData, ...] = ()
    notes: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()  # what the emitted functions cannot do
    driving: Driving = NO_DRIVING
