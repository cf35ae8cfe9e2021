"""Chapter I: the equations of motion of nonholonomic systems."""

from __future__ import annotations

from nhc.thesis.entries import Equation

_DERIVED = (
    "a step of the derivation from points and virtual work; nhc starts from T, and its outcome (I.2.13) is implemented"
)

EQUATIONS = (
    Equation(
        "I.1.1",
        "linear nonholonomic constraints",
        r"a_{\alpha i}\dot q_i + a_\alpha = 0",
        ("nhc.mechanics.frame.form_value", "nhc.mechanics.formulations.multipliers.constraint_rates"),
    ),
    Equation(
        "I.1.2",
        "the constraints solved for the dependent velocities",
        r"\dot q_\alpha = b_{\alpha\mu}\dot q_\mu + b_\alpha",
        ("nhc.mechanics.frame.dependent_coefficients",),
        errata=("E16",),
    ),
    Equation(
        "I.2.1",
        "quasi-velocities, inhomogeneous ones by omega_{n+1} = 1",
        r"\omega_i = a_{ij}\dot q_j + a_{i,n+1}",
        ("nhc.mechanics.frame.make_frame",),
    ),
    Equation(
        "I.2.2",
        "the constraints as the first quasi-velocities",
        r"\omega_\alpha = a_{\alpha j}\dot q_j + a_{\alpha,n+1} = 0",
        ("nhc.mechanics.frame.make_frame",),
    ),
    Equation(
        "I.2.3",
        "differentials of quasi-coordinates: a coframe",
        r"d\pi_i = a_{ij}\,dq_j + a_{i,n+1}\,dt",
        ("nhc.mechanics.formulations.euler_lagrange.full_coframe",),
    ),
    Equation(
        "I.2.4",
        "kinematics",
        r"\dot q_j = b_{jk}\omega_k + b_{j,n+1},\quad b_{j,n+1} = -b_{jk}a_{k,n+1}",
        ("nhc.mechanics.frame.Frame.kinematics",),
    ),
    Equation(
        "I.2.5",
        "derivative along a quasi-coordinate",
        r"\frac{\partial\phi}{\partial\pi_i} = b_{ji}\frac{\partial\phi}{\partial q_j}",
        ("nhc.mechanics.frame.Frame.along",),
    ),
    Equation("I.2.6", "Newton's equations of points", r"m_i\vec w_i = \vec F_i + \vec R_i", reason=_DERIVED),
    Equation(
        "I.2.7",
        "the principle of virtual work",
        r"m_i\vec w_i\cdot\delta\vec r_i = \vec F_i\cdot\delta\vec r_i",
        reason=_DERIVED,
    ),
    Equation(
        "I.2.8",
        "Lagrange's central equation",
        r"\frac{d}{dt}(m_i\vec v_i\cdot\delta\vec r_i) = \delta T + \delta W"
        r" + m_i\vec v_i\cdot[(\delta\vec r_i)' - \delta\vec v_i]",
        reason=_DERIVED,
    ),
    Equation(
        "I.2.9",
        "the central equation in generalized coordinates",
        r"\frac{d}{dt}(p_j\,\delta q_j) = \delta T + Q_j\,\delta q_j + p_j[(\delta q_j)' - \delta\dot q_j]",
        reason=_DERIVED,
    ),
    Equation(
        "I.2.10",
        "the transposition term in the momenta of quasi-velocities",
        r"p_j[(\delta q_j)' - \delta\dot q_j] = p^*_i a_{ij}[(\delta q_j)' - \delta\dot q_j]",
        test="tests/thesis/test_errata_in_print.py::test_E12",
    ),
    Equation(
        "I.2.11",
        "the transposition relations, with gamma and epsilon",
        r"(\delta\pi_i)' - \delta\omega_i = a_{ik}[(\delta q_k)' - \delta\dot q_k]"
        r" + \gamma^i_{mj}\omega_m\,\delta\pi_j + \epsilon^i_j\,\delta\pi_j,\quad"
        r" \gamma^i_{tj} = \left(\frac{\partial a_{ir}}{\partial q_s} - \frac{\partial a_{is}}{\partial q_r}\right)"
        r" b_{st}b_{rj},\ \epsilon^i_j = \gamma^i_{n+1,j}",
        ("nhc.mechanics.frame.Frame.gamma",),
        "tests/property/test_structure.py::test_structure_equations",
    ),
    Equation(
        "I.2.12",
        "the central equation in quasi-velocities",
        r"\frac{d}{dt}\left(\frac{\partial T}{\partial\omega_j}\delta\pi_j\right) = \delta T + P_j\,\delta\pi_j"
        r" + p^*_i[(\delta\pi_i)' - \delta\omega_i] - (\gamma^i_{mj}\omega_m + \epsilon^i_j)p^*_i\,\delta\pi_j",
        reason=_DERIVED,
        errata=("E12",),
    ),
    Equation(
        "I.2.13",
        "the Euler-Lagrange expression on virtual displacements",
        r"\delta\pi_j\left[\frac{d}{dt}\frac{\partial T}{\partial\omega_j} + (\gamma^i_{mj}\omega_m + \epsilon^i_j)"
        r"\frac{\partial T}{\partial\omega_i} - \frac{\partial T}{\partial\pi_j} - P_j\right] = 0",
        ("nhc.mechanics.formulations.euler_lagrange.printed_rows",),
        errata=("E12",),
    ),
    Equation(
        "I.2.14",
        "Euler-Lagrange (Poincaré) without constraints",
        r"\frac{d}{dt}\frac{\partial T}{\partial\omega_j} + (\gamma^i_{mj}\omega_m + \epsilon^i_j)"
        r"\frac{\partial T}{\partial\omega_i} - \frac{\partial T}{\partial\pi_j} = P_j",
        ("nhc.mechanics.formulations.euler_lagrange.printed_rows",),
    ),
    Equation(
        "I.2.15",
        "Euler-Lagrange (Hamel) with constraints; the sum on i runs over all n",
        r"\frac{d}{dt}\frac{\partial T}{\partial\omega_\mu} + (\gamma^i_{\nu\mu}\omega_\nu + \epsilon^i_\mu)"
        r"\frac{\partial T}{\partial\omega_i} - \frac{\partial T}{\partial\pi_\mu} = P_\mu = b_{i\mu}Q_i",
        ("nhc.mechanics.formulations.euler_lagrange.printed_rows",),
        "tests/thesis/test_agreement.py::test_hamel_agrees",
        errata=("E11",),
    ),
    Equation(
        "I.3",
        "Čaplygin's equations and their hypotheses (boxed)",
        r"\frac{d}{dt}\frac{\partial T^*}{\partial\dot q_\mu} - \frac{\partial T^*}{\partial q_\mu} + p_\alpha\left("
        r"\frac{\partial b_{\alpha\nu}}{\partial q_\mu} - \frac{\partial b_{\alpha\mu}}{\partial q_\nu}\right)\dot q_\nu = Q_\mu",
        ("nhc.mechanics.formulations.chaplygin.hypotheses", "nhc.mechanics.formulations.chaplygin.printed_rows"),
        "tests/thesis/test_agreement.py::test_chaplygin_agrees",
        errata=("E1", "E10"),
    ),
    Equation(
        "I.3.1",
        "virtual displacements on the constraints; b_alpha has no part in them",
        r"\delta q_\alpha = b_{\alpha\mu}\,\delta q_\mu",
        ("nhc.mechanics.frame.coordinate_frame",),
    ),
    Equation(
        "I.3.2",
        "d'Alembert's equations with the dependent displacements eliminated",
        r"\frac{d}{dt}\frac{\partial T}{\partial\dot q_\mu} - \frac{\partial T}{\partial q_\mu} - Q_\mu"
        r" + b_{\alpha\mu}\frac{d}{dt}\frac{\partial T}{\partial\dot q_\alpha} = 0",
        ("nhc.mechanics.formulations.chaplygin.printed_rows",),
        "tests/thesis/test_agreement.py::test_chaplygin_agrees",
    ),
    Equation(
        "I.3.3",
        "momenta of T*",
        r"\frac{\partial T^*}{\partial\dot q_\mu} = \frac{\partial T}{\partial\dot q_\mu}"
        r" + \frac{\partial T}{\partial\dot q_\alpha}b_{\alpha\mu}",
        ("nhc.mechanics.formulations.voronec.reduce",),
    ),
    Equation(
        "I.3.4",
        "slopes of T*",
        r"\frac{\partial T^*}{\partial q_\mu} = \frac{\partial T}{\partial q_\mu}"
        r" + p_\alpha\frac{\partial b_{\alpha\nu}}{\partial q_\mu}\dot q_\nu",
        test="tests/thesis/test_errata_in_print.py::test_E14",
    ),
    Equation(
        "I.4.1",
        "Lagrange's equations with multipliers, independent rows",
        r"\frac{d}{dt}\frac{\partial T}{\partial\dot q_\mu} - \frac{\partial T}{\partial q_\mu} - Q_\mu"
        r" + \lambda_\alpha b_{\alpha\mu} = 0",
        ("nhc.mechanics.formulations.multipliers.printed_rows",),
    ),
    Equation(
        "I.4.2",
        "Lagrange's equations with multipliers, dependent rows",
        r"\frac{d}{dt}\frac{\partial T}{\partial\dot q_\beta} - \frac{\partial T}{\partial q_\beta} - Q_\beta - \lambda_\beta = 0",
        ("nhc.mechanics.formulations.multipliers.printed_rows",),
    ),
    Equation(
        "I.4.3",
        "momenta of T*, as I.3.3",
        r"\frac{\partial T^*}{\partial\dot q_\mu} = \frac{\partial T}{\partial\dot q_\mu}"
        r" + \frac{\partial T}{\partial\dot q_\beta}b_{\beta\mu}",
        ("nhc.mechanics.formulations.voronec.reduce",),
    ),
    Equation(
        "I.4.4",
        "their rates",
        r"\frac{d}{dt}\frac{\partial T^*}{\partial\dot q_\mu} = \dot p_\mu + b_{\beta\mu}\dot p_\beta + p_\beta\dot b_{\beta\mu}",
        ("nhc.mechanics.formulations.voronec.printed_rows",),
    ),
    Equation(
        "I.4.5",
        "I.4.1 with a force function",
        r"\dot p_\mu = \frac{\partial(T+U)}{\partial q_\mu} - \lambda_\alpha b_{\alpha\mu}",
        ("nhc.mechanics.formulations.multipliers.printed_rows",),
    ),
    Equation(
        "I.4.6",
        "I.4.2 with a force function",
        r"\dot p_\beta = \frac{\partial(T+U)}{\partial q_\beta} + \lambda_\beta",
        ("nhc.mechanics.formulations.multipliers.printed_rows",),
    ),
    Equation(
        "I.4.7",
        "the multipliers eliminated",
        r"\frac{d}{dt}\frac{\partial T^*}{\partial\dot q_\mu} = \frac{\partial(T+U)}{\partial q_\mu}"
        r" + b_{\beta\mu}\frac{\partial(T+U)}{\partial q_\beta} + p_\beta\dot b_{\beta\mu}",
        test="tests/thesis/test_agreement.py::test_voronec_agrees",
    ),
    Equation(
        "I.4.8",
        "slopes of T and of T*",
        r"\frac{\partial T^*}{\partial q_j} = \frac{\partial T}{\partial q_j}"
        r" + p_\alpha\frac{\partial}{\partial q_j}(b_{\alpha\nu}\dot q_\nu + b_\alpha)",
        ("nhc.mechanics.formulations.voronec.printed_rows",),
        "tests/thesis/test_errata_in_print.py::test_E14",
        errata=("E14",),
    ),
    Equation(
        "I.4.9",
        "Voronec's equations, for affine and time-dependent constraints, any T and any forces",
        r"\frac{d}{dt}\frac{\partial T^*}{\partial\dot q_\mu} = \frac{\partial T^*}{\partial q_\mu}"
        r" + b_{\beta\mu}\frac{\partial T^*}{\partial q_\beta} + Q_\mu + b_{\beta\mu}Q_\beta + p_\alpha\left\{\dot b_{\alpha\mu}"
        r" - \left(\frac{\partial}{\partial q_\mu} + b_{\beta\mu}\frac{\partial}{\partial q_\beta}\right)"
        r"(b_{\alpha\nu}\dot q_\nu + b_\alpha)\right\}",
        ("nhc.mechanics.formulations.voronec.printed_rows",),
        "tests/thesis/test_agreement.py::test_voronec_agrees",
    ),
)
