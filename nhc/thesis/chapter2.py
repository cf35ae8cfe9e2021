"""Chapter II: the 2-forms of mechanical systems."""

from __future__ import annotations

from nhc.thesis.entries import Equation

EQUATIONS = (
    Equation(
        "II.1.1",
        "the 2-form of a point",
        r"\Omega = (m\,d\vec v - \vec X\,dt)\wedge(d\vec r - \vec v\,dt)",
        ("nhc.mechanics.formulations.newton.omega",),
        errata=("E9",),
    ),
    Equation(
        "II.1.2",
        "the same on two series of differentials, as a determinant",
        r"\Omega(d,\delta) = \begin{vmatrix} u(d) & w(d) \\ u(\delta) & w(\delta)\end{vmatrix}",
        test="tests/property/test_exterior.py::test_wedge_is_a_determinant",
    ),
    Equation(
        "II.1.3",
        "the same in components; its associated system is Newton's",
        r"\Omega = (m_i\,dv_i - X_i\,dt)\wedge(dx_i - v_i\,dt)",
        ("nhc.mechanics.formulations.newton.omega",),
        errata=("E9",),
    ),
    Equation(
        "II.1.4",
        "its kinetic part is exact",
        r"\Omega_c = d(m v_i\,dx_i - T\,dt)",
        ("nhc.mechanics.formulations.lagrange.kinetic_two_form",),
        "tests/thesis/test_errata_in_print.py::test_E9",
    ),
    Equation(
        "II.1.5",
        "its dynamic part is work times dt",
        r"\Omega_d = X_i\,dx_i\wedge dt",
        ("nhc.mechanics.formulations.lagrange.dynamic_two_form",),
    ),
    Equation(
        "II.2.1",
        "the kinetic 1-form of a system of points",
        r"\int_S \vec V_M\cdot d\vec{OM}\,dm - \tfrac12 dt\int_S \vec V_M^2\,dm",
        test="tests/thesis/test_errata_in_print.py::test_E13",
        errata=("E13",),
    ),
    Equation(
        "II.2.2",
        "the same in generalized coordinates; the sums run to n + 1, which gives p_i q'_i - T beside dt",
        r"\Omega_c = d\left[p_i\,dq_i - (p_i\dot q_i - T)\,dt\right]",
        ("nhc.mechanics.formulations.lagrange.kinetic_one_form",),
        errata=("E4", "E13"),
    ),
    Equation(
        "II.2.3",
        "the dynamic part",
        r"\Omega_d = Q_i\,dq_i\wedge dt",
        ("nhc.mechanics.formulations.lagrange.dynamic_two_form",),
    ),
    Equation(
        "II.3",
        "Lagrange's form and equations",
        r"\Omega = \left(dp_i - \left(\frac{\partial T}{\partial q_i} + Q_i\right)dt\right)\wedge(dq_i - \dot q_i\,dt),\quad"
        r" \frac{d}{dt}\frac{\partial T}{\partial\dot q_i} - \frac{\partial T}{\partial q_i} = Q_i",
        ("nhc.mechanics.formulations.lagrange.omega", "nhc.mechanics.formulations.lagrange.printed_rows"),
        errata=("E4", "E5"),
    ),
    Equation(
        "II.3.1",
        "the kinetic part of Lagrange's form",
        r"\Omega_c = dp_i\wedge dq_i - d(p_i\dot q_i - T)\wedge dt",
        ("nhc.mechanics.formulations.lagrange.kinetic_two_form",),
        errata=("E4", "E15"),
    ),
)
