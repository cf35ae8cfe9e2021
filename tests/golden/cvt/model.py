"""cvt, emitted by nhc 0.1.0 (nhc:870219d14fba00ff).

A continuously variable transmission; a plane oscillator whose free direction is set
    by a symmetric driver.
Equations of motion: chaplygin (III.3)
Why: dependent velocities of the spec
Note: hypothesis of I.3 that fails (the generalized equations are used): a force
    acts on the dependent coordinate `y`

State y:
y[0] = x
y[1] = y
y[2] = xi
y[3] = x'
y[4] = xi'

No parameters.

Constraints:
0: belt

Outputs:
out[0] = E_xi
out[1] = E_xy

Operations of one call (+-: sums and differences; calls: sin, cos, ...):
rhs: 3 +-, 5 *, 1 /, 2 calls
velocities: 0 +-, 1 *, 0 /, 1 calls
accelerations: 4 +-, 5 *, 1 /, 2 calls
state: 0 +-, 0 *, 0 /, 0 calls
residuals: 1 +-, 1 *, 0 /, 1 calls
reactions: 3 +-, 4 *, 1 /, 2 calls
energy: 5 +-, 8 *, 0 /, 2 calls
jacobian: 5 +-, 15 *, 1 /, 2 calls
outputs: 4 +-, 8 *, 0 /, 2 calls

A singular point raises SingularModelError.
Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en
    mecanique des systemes non holonomes, Namur 1977; 17:4 beside a statement is
    line:column of the spec.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

COORDINATES: tuple[str, ...] = ("x", "y", "xi")
STATE: tuple[str, ...] = ("x", "y", "xi", "x'", "xi'")
PARAMETERS: tuple[str, ...] = ()
CONSTRAINTS: tuple[str, ...] = ("belt",)
OUTPUTS: tuple[str, ...] = ("E_xi", "E_xy")
DEFAULTS: tuple[float, ...] = ()

REASONS = (
    "",
    "",
    "the mass matrix is singular",
    "a result is not finite or not defined",
)
NOT_FINITE = 3


class SingularModelError(ArithmeticError):
    """The model is singular here; ``status`` is the code that C returns."""

    def __init__(self, status: int, function: str) -> None:
        super().__init__(status, function)  # what copies and pickles make it of again
        self.status = status

    def __str__(self) -> str:
        return f"{self.args[1]}: {REASONS[self.status]}"


def _finish(function: str, values: list[float]) -> list[float]:
    if not all(map(math.isfinite, values)):
        raise SingularModelError(NOT_FINITE, function)
    return values


def _single(function: str, value: float) -> float:
    if not math.isfinite(value):
        raise SingularModelError(NOT_FINITE, function)
    return value


def _refuse(
    value: float,
    bound: float,
    status: int,
    function: str,
) -> SingularModelError:
    """What to raise of a block that does not exceed its bound: it is singular, or no number."""
    singular = value <= bound < math.inf
    return SingularModelError(status if singular else NOT_FINITE, function)


def rhs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """Right-hand side dy/dt = f(t, y; p) (III.3).

    Arguments: t (scalar), y (5,), p (0,).
    Returns dydt (5,).
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    xi = float(y[2])
    x_dot = float(y[3])  # x'
    xi_dot = float(y[4])  # xi'
    try:
        # from the state
        s_xi = math.sin(xi)
        z1 = 1.0 + s_xi * s_xi
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "rhs")
        c_xi = math.cos(xi)
        dydt: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            -x_dot * s_xi,
            # xi' (I.1.2)
            xi_dot,
            # x'' (III.3) 7:4
            (s_xi * (y_2 - c_xi * (x_dot * xi_dot)) - x) / z1,
            # xi'' (III.3) 7:4
            s_xi,
        ]
        return _finish("rhs", dydt)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "rhs") from error


def velocities(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All velocities q' from the state (I.1.2).

    Arguments: t (scalar), y (5,), p (0,).
    Returns qdot (3,).
    """
    xi = float(y[2])
    x_dot = float(y[3])  # x'
    xi_dot = float(y[4])  # xi'
    try:
        # from the state
        s_xi = math.sin(xi)
        qdot: list[float] = [
            # x' (I.1.2)
            x_dot,
            # y' (I.1.2)
            -x_dot * s_xi,
            # xi' (I.1.2)
            xi_dot,
        ]
        return _finish("velocities", qdot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "velocities") from error


def accelerations(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """All accelerations q'' on the motion (III.3).

    Arguments: t (scalar), y (5,), p (0,).
    Returns qddot (3,).
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    xi = float(y[2])
    x_dot = float(y[3])  # x'
    xi_dot = float(y[4])  # xi'
    try:
        # from the state
        s_xi = math.sin(xi)
        z1 = 1.0 + s_xi * s_xi
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "accelerations")
        c_xi = math.cos(xi)
        z2 = c_xi * (x_dot * xi_dot)
        z3 = (x - s_xi * (y_2 - z2)) / z1
        qddot: list[float] = [
            # x'' (III.3)
            -z3,
            # y'' (III.3)
            s_xi * z3 - z2,
            # xi'' (III.3)
            s_xi,
        ]
        return _finish("accelerations", qddot)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "accelerations") from error


def state(
    t: float,
    q: Sequence[float],
    qdot: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """The state y from coordinates and velocities.

    Arguments: t (scalar), q (3,), qdot (3,), p (0,).
    Returns y (5,).
    """
    x = float(q[0])
    y_2 = float(q[1])  # y
    xi = float(q[2])
    x_dot = float(qdot[0])  # x'
    xi_dot = float(qdot[2])  # xi'
    try:
        # from the coordinates and velocities
        y: list[float] = [x, y_2, xi, x_dot, xi_dot]
        return _finish("state", y)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "state") from error


def residuals(
    t: float,
    q: Sequence[float],
    qdot: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """Left minus right side of each constraint, zero on every motion (I.1.1).

    Arguments: t (scalar), q (3,), qdot (3,), p (0,).
    Returns r (1,).
    """
    xi = float(q[2])
    x_dot = float(qdot[0])  # x'
    y_dot = float(qdot[1])  # y'
    try:
        # from the coordinates and velocities
        s_xi = math.sin(xi)
        r: list[float] = [
            # belt = 0 (I.1.1) 10:5
            y_dot + x_dot * s_xi,
        ]
        return _finish("residuals", r)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "residuals") from error


def reactions(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[float]:
    """Reactions lambda of the constraints (I.4.1).

    Arguments: t (scalar), y (5,), p (0,).
    Returns lambda_ (1,).
    Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    xi = float(y[2])
    x_dot = float(y[3])  # x'
    xi_dot = float(y[4])  # xi'
    try:
        # from the state
        s_xi = math.sin(xi)
        z1 = 1.0 + s_xi * s_xi
        # the mass matrix is singular, if z1 is 0
        if not abs(z1) > 0.0:
            raise _refuse(abs(z1), 0.0, 2, "reactions")
        c_xi = math.cos(xi)
        lambda_: list[float] = [
            # reaction of belt: Q_i gains lambda_1 a_1i (I.4.1) 10:5
            (y_2 + x * s_xi - c_xi * (x_dot * xi_dot)) / z1,
        ]
        return _finish("reactions", lambda_)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "reactions") from error


def energy(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> float:
    """Energy T + V.

    Arguments: t (scalar), y (5,), p (0,).
    Returns a scalar.
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    xi = float(y[2])
    x_dot = float(y[3])  # x'
    xi_dot = float(y[4])  # xi'
    try:
        # from the state
        c_xi = math.cos(xi)
        s_xi = math.sin(xi)
        z1 = x_dot * s_xi
        s1 = 0.5 * (xi_dot * xi_dot + (x_dot * x_dot + z1 * z1))
        z2 = 0.5 * (x * x + y_2 * y_2) + c_xi + s1
        value1 = z2
        return _single("energy", value1)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "energy") from error


def jacobian(
    t: float,
    y: Sequence[float],
    p: Sequence[float] = DEFAULTS,
) -> list[list[float]]:
    """Jacobian matrix of rhs, d rhs_i / d y_j (III.3).

    Arguments: t (scalar), y (5,), p (0,).
    Returns rows (5, 5): d rhs_i / d y_j stands at [i][j].
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    xi = float(y[2])
    x_dot = float(y[3])  # x'
    xi_dot = float(y[4])  # xi'
    try:
        # from the state
        s_xi = math.sin(xi)
        z1 = s_xi * s_xi
        z2 = 1.0 + z1
        # the mass matrix is singular, if z2 is 0
        if not abs(z2) > 0.0:
            raise _refuse(abs(z2), 0.0, 2, "jacobian")
        c_xi = math.cos(xi)
        z3 = 1.0 / z2
        z4 = s_xi * z3
        z5 = x_dot * xi_dot
        z6 = y_2 - c_xi * z5
        z7 = c_xi * s_xi * z3
        J: list[float] = [
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            -x_dot * c_xi,
            # (III.3)
            -s_xi,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
            # (III.3)
            1.0,
            # (III.3)
            -z3,
            # (III.3)
            z4,
            # (III.3)
            z3 * (z1 * z5 + c_xi * (z6 + 2.0 * ((x - s_xi * z6) * z4))),
            # (III.3)
            -xi_dot * z7,
            # (III.3)
            -x_dot * z7,
            0.0,
            0.0,
            # (III.3)
            c_xi,
            0.0,
            0.0,
        ]
        _finish("jacobian", J)
        return [J[k1 : k1 + 5] for k1 in range(0, 25, 5)]
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "jacobian") from error


def outputs(t: float, y: Sequence[float], p: Sequence[float] = DEFAULTS) -> list[float]:
    """The spec's outputs.

    Arguments: t (scalar), y (5,), p (0,).
    Returns out (2,).
    """
    x = float(y[0])
    y_2 = float(y[1])  # y
    xi = float(y[2])
    x_dot = float(y[3])  # x'
    xi_dot = float(y[4])  # xi'
    try:
        # from the state
        c_xi = math.cos(xi)
        s_xi = math.sin(xi)
        z1 = x_dot * s_xi
        out: list[float] = [
            # E_xi 13:9
            0.5 * (xi_dot * xi_dot) + c_xi,
            # E_xy 14:9
            0.5 * (y_2 * y_2 + (x * x + (x_dot * x_dot + z1 * z1))),
        ]
        return _finish("outputs", out)
    except (ValueError, ZeroDivisionError, OverflowError) as error:
        raise SingularModelError(NOT_FINITE, "outputs") from error
