"""Chapter III: the equations of motion as associated systems of 2-forms."""

from __future__ import annotations

from nhc.thesis.entries import Equation

_FALSE = "a false intermediate step whose error cancels later; nhc goes by the master form"

EQUATIONS = (
    Equation(
        "III.1.1",
        "the associated system of a monomial",
        r"\Omega = u_1\wedge u_2:\quad u_1 = 0,\ u_2 = 0",
        ("nhc.mechanics.rows.associated_rows",),
        "tests/thesis/test_diagrams.py::test_monomial",
    ),
    Equation(
        "III.1.2",
        "a regular linear change commutes with taking the associated system",
        r"u_i = b_{ij}\tilde u_j,\quad \tilde\Omega = \det(b)\,\tilde u_1\wedge\tilde u_2",
        test="tests/thesis/test_diagrams.py::test_transform_and_associate_commute",
        errata=("E16",),
    ),
    Equation(
        "III.2.1",
        "the dynamic part in quasi-coordinates",
        r"\Omega_d = P_j\,d\pi_j\wedge dt",
        ("nhc.mechanics.formulations.euler_lagrange.dynamic_two_form",),
    ),
    Equation(
        "III.2.2",
        "the part of the kinetic form beside dt; on a motion it gives the theorem of energy",
        r"d\left[(p^*_j\omega_j - T)\,dt\right] = d(p^*_j\omega_j - T)\wedge dt",
        ("nhc.mechanics.properties.conserved.power", "nhc.mechanics.formulations.euler_lagrange.kinetic_two_form"),
        errata=("E4",),
    ),
    Equation(
        "III.2.3",
        "the part with the momenta's differentials",
        r"dp^*_j\wedge d\pi_j",
        ("nhc.mechanics.formulations.euler_lagrange.kinetic_two_form",),
        errata=("E15",),
    ),
    Equation(
        "III.2.4",
        "the part with the differentials of dpi",
        r"p^*_j\,d(d\pi_j) = \tfrac12 p^*_j\gamma^j_{mi}\,d\pi_m\wedge d\pi_i - p^*_j\epsilon^j_i\,d\pi_i\wedge dt",
        ("nhc.mechanics.formulations.euler_lagrange.kinetic_two_form",),
        "tests/property/test_structure.py::test_structure_equations",
        errata=("E2",),
    ),
    Equation(
        "III.2.5",
        "Omega in all quasi-velocities",
        r"\Omega = dp^*_j\wedge d\pi_j + \tfrac12 p^*_j\gamma^j_{mi}\,d\pi_m\wedge d\pi_i - p^*_j\epsilon^j_i\,d\pi_i\wedge dt"
        r" - d(p^*_j\omega_j - T)\wedge dt + P_j\,d\pi_j\wedge dt",
        ("nhc.mechanics.formulations.euler_lagrange.unconstrained_omega",),
        errata=("E2", "E5"),
    ),
    Equation(
        "III.2.6",
        "Euler-Lagrange (Hamel), as I.2.15",
        r"\frac{d}{dt}\frac{\partial T}{\partial\omega_\mu} + (\gamma^i_{\nu\mu}\omega_\nu + \epsilon^i_\mu)"
        r"\frac{\partial T}{\partial\omega_i} - \frac{\partial T}{\partial\pi_\mu} = P_\mu",
        ("nhc.mechanics.formulations.euler_lagrange.printed_rows",),
        "tests/thesis/test_agreement.py::test_hamel_agrees",
        errata=("E3",),
    ),
    Equation(
        "III.3",
        "Čaplygin's equations, last line of III.3 (the right sign), with affine and time-dependent b",
        r"\frac{d}{dt}\frac{\partial T^*}{\partial\dot q_\mu} - \frac{\partial T^*}{\partial q_\mu} + p_\alpha\left[\left("
        r"\frac{\partial b_{\alpha\nu}}{\partial q_\mu} - \frac{\partial b_{\alpha\mu}}{\partial q_\nu}\right)\dot q_\nu"
        r" + \frac{\partial b_\alpha}{\partial q_\mu} - \frac{\partial b_{\alpha\mu}}{\partial t}\right]"
        r" = Q_\mu + b_{\alpha\mu}Q_\alpha",
        ("nhc.mechanics.formulations.chaplygin.printed_rows",),
        "tests/thesis/test_diagrams.py::test_substitute_and_differentiate_do_not_commute",
        errata=("E4", "E5", "E15"),
    ),
    Equation(
        "III.3.1",
        "the dynamic part; Q_alpha = 0",
        r"Q_i\,dq_i\wedge dt = Q_\mu\,dq_\mu\wedge dt",
        ("nhc.mechanics.formulations.voronec.omega",),
    ),
    Equation(
        "III.3.2",
        "the slopes of T on the constraints",
        r"\frac{\partial T}{\partial q_i}dq_i\wedge dt = \left(\frac{\partial T^*}{\partial q_\mu}"
        r" - p_\alpha\frac{\partial b_{\alpha\nu}}{\partial q_\mu}\dot q_\nu\right)dq_\mu\wedge dt",
        test="tests/thesis/test_errata_in_print.py::test_E15",
        errata=("E15",),
    ),
    Equation(
        "III.3.3",
        "the momenta against the velocities' differentials",
        r"\frac{\partial T}{\partial\dot q_i}d\dot q_i\wedge dt = \frac{\partial T^*}{\partial\dot q_\mu}d\dot q_\mu\wedge dt"
        r" + p_\alpha\dot q_\mu\,db_{\alpha\mu}\wedge dt",
        test="tests/thesis/test_errata_in_print.py::test_E15",
        errata=("E15",),
    ),
    Equation(
        "III.3.4",
        "the Hessian's part, independent rows (as a whole: dp_mu + b_alphamu dp_alpha = d(dT*/dq'_mu) - p_alpha db_alphamu)",
        r"\frac{\partial^2T^*}{\partial\dot q_\nu\partial\dot q_\mu} = T_{\nu\mu} + T_{\nu\beta}b_{\beta\mu}"
        r" + b_{\alpha\nu}T_{\alpha\mu} + b_{\alpha\nu}T_{\alpha\beta}b_{\beta\mu}",
        test="tests/thesis/test_errata.py::test_E6",
        reason=_FALSE,
        errata=("E6",),
    ),
    Equation(
        "III.3.5",
        "the Hessian's part, dependent rows",
        r"dp_\alpha = T_{\alpha\mu}d\dot q_\mu + T_{\alpha\beta}d\dot q_\beta + \dots",
        test="tests/thesis/test_errata.py::test_E6",
        reason=_FALSE,
        errata=("E6",),
    ),
    Equation(
        "III.3.6",
        "the mixed part, dependent rows",
        r"\frac{\partial p_\alpha}{\partial q_\mu}\Big|_{T^*} = T_{\alpha q_\mu}"
        r" + T_{\alpha\beta}\frac{\partial b_{\beta\nu}}{\partial q_\mu}\dot q_\nu",
        test="tests/thesis/test_errata.py::test_E6",
        reason=_FALSE,
        errata=("E6",),
    ),
    Equation(
        "III.3.7",
        "the mixed part, independent rows",
        r"d\frac{\partial T^*}{\partial\dot q_\mu} = dp_\mu + b_{\alpha\mu}\,dp_\alpha + p_\alpha\,db_{\alpha\mu}",
        test="tests/thesis/test_errata.py::test_E6",
        reason=_FALSE,
        errata=("E6",),
    ),
    Equation(
        "III.4",
        "Voronec's equations, last line of III.4, and the 2-form they are associated to",
        r"\tilde\Omega = \left(d\frac{\partial T^*}{\partial\dot q_\mu} - p_\alpha\,db_{\alpha\mu} - R_\mu\,dt\right)"
        r"\wedge(dq_\mu - \dot q_\mu\,dt)",
        ("nhc.mechanics.formulations.voronec.omega", "nhc.mechanics.formulations.voronec.printed_rows"),
        "tests/thesis/test_errata_in_print.py::test_E16",
        errata=("E7", "E8"),
    ),
    Equation(
        "III.4.1",
        "the dynamic part",
        r"\Omega_d = (Q_\mu + b_{\beta\mu}Q_\beta)\,dq_\mu\wedge dt",
        ("nhc.mechanics.formulations.voronec.omega",),
    ),
    Equation(
        "III.4.2",
        "the slopes of T on the constraints",
        r"\frac{\partial T}{\partial q_j} = \frac{\partial T^*}{\partial q_j}"
        r" - p_\gamma\frac{\partial}{\partial q_j}(b_{\gamma\nu}\dot q_\nu + b_\gamma)",
        ("nhc.mechanics.formulations.voronec.omega",),
    ),
    Equation(
        "III.4.3",
        "the momenta against the velocities' differentials",
        r"p_i\,d\dot q_i\wedge dt = \frac{\partial T^*}{\partial\dot q_\mu}d\dot q_\mu\wedge dt"
        r" + p_\beta(\dot q_\mu\,db_{\beta\mu} + db_\beta)\wedge dt",
        ("nhc.mechanics.formulations.voronec.omega",),
    ),
    Equation(
        "III.4.4",
        "the momenta's differentials against dq (the printed split into Hessian parts is false, the sum is right)",
        r"dp_i\wedge dq_i = \left(d\frac{\partial T^*}{\partial\dot q_\mu} - p_\alpha\,db_{\alpha\mu}\right)\wedge dq_\mu"
        r" + b_\alpha\,dp_\alpha\wedge dt",
        ("nhc.mechanics.formulations.voronec.omega",),
        errata=("E6",),
    ),
    Equation(
        "III.4.5",
        "the mixed part",
        r"\frac{\partial^2T^*}{\partial\dot q_\nu\partial q_i} = \frac{\partial p_\nu}{\partial q_i}"
        r" + b_{\alpha\nu}\frac{\partial p_\alpha}{\partial q_i} + p_\alpha\frac{\partial b_{\alpha\nu}}{\partial q_i}",
        test="tests/thesis/test_errata.py::test_E6",
        reason=_FALSE,
        errata=("E6",),
    ),
)
