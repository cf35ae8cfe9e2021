"""The general formulas of the thesis (corrected where it errs), in both spellings."""

from __future__ import annotations

from nhc.program.sheets.model import Formula

NOTATION = {
    "euler-lagrange": Formula(
        "omega_i = a_{i,j} q_j' + a_{i,n+1},  dpi_i = a_{i,j} dq_j + a_{i,n+1} dt,  q_j' = b_{j,i} omega_i + b_{j,n+1},"
        "  d/dpi_i = b_{j,i} d/dq_j,  P_i = b_{j,i} Q_j,  q_{n+1} = t",
        r"\begin{gathered} \omega_i = a_{ij}\, \dot q_j + a_{i,n+1}, \qquad d\pi_i = a_{ij}\, dq_j + a_{i,n+1}\, dt, \qquad"
        r" \dot q_j = b_{ji}\, \omega_i + b_{j,n+1}, \\ \frac{\partial}{\partial \pi_i} = b_{ji} \frac{\partial}{\partial q_j},"
        r" \qquad P_i = b_{ji} Q_j, \qquad q_{n+1} = t \end{gathered}",
    ),
    "voronec": Formula(
        "q_alpha' = b_{alpha,mu} q_mu' + b_alpha,  p_alpha = dT/dq_alpha'",
        r"\dot q_\alpha = b_{\alpha\mu}\, \dot q_\mu + b_\alpha, \qquad p_\alpha = \frac{\partial T}{\partial \dot q_\alpha}",
    ),
    "multipliers": Formula("a_{alpha,i} q_i' + a_alpha = 0", r"a_{\alpha i}\, \dot q_i + a_\alpha = 0"),
}
NOTATION["chaplygin"] = NOTATION["voronec"]
"""What the letters of the general formulas stand for."""

GAMMA = Formula(
    "d(dpi_i) = gamma^i_{m,j} dpi_m ^ dpi_j (m < j) - eps^i_j dpi_j ^ dt,"
    "  gamma^i_{t,j} = (da_{i,r}/dq_s - da_{i,s}/dq_r) b_{s,t} b_{r,j},  eps^i_j = gamma^i_{n+1,j}",
    r"\begin{gathered} d(d\pi_i) = \sum_{m<j} \gamma^i_{mj}\, d\pi_m \wedge d\pi_j - \varepsilon^i_j\, d\pi_j \wedge dt, \\"
    r" \gamma^i_{tj} = \Bigl(\frac{\partial a_{ir}}{\partial q_s} - \frac{\partial a_{is}}{\partial q_r}\Bigr) b_{st} b_{rj},"
    r" \qquad \varepsilon^i_j = \gamma^i_{n+1,j} \end{gathered}",
    "I.2.11",
)

THETA = Formula(
    "Theta = p_i dq_i - (p_i q_i' - T) dt,  p_i = dT/dq_i'",
    r"\boldsymbol{\theta} = p_i\, dq_i - (p_i \dot q_i - T)\, dt, \qquad p_i = \frac{\partial T}{\partial \dot q_i}",
    "II.2.2",
)
THETA_QUASI = Formula(
    "Theta = p*_j dpi_j - (p*_j omega_j - T) dt,  p*_j = dT/domega_j",
    r"\boldsymbol{\theta} = p^*_j\, d\pi_j - (p^*_j \omega_j - T)\, dt, \qquad p^*_j = \frac{\partial T}{\partial \omega_j}",
    "II.2.2",
)

OMEGA = {
    "newton": Formula(
        "Omega = (m_i dv_i - X_i dt) ^ (dx_i - v_i dt)",
        r"\boldsymbol{\Omega} = (m_i\, dv_i - X_i\, dt) \wedge (dx_i - v_i\, dt)",
        "II.1.3",
    ),
    "lagrange": Formula(
        "Omega = d Theta + Q_i dq_i ^ dt = (dp_i - (dT/dq_i + Q_i) dt) ^ (dq_i - q_i' dt)",
        r"\boldsymbol{\Omega} = d\boldsymbol{\theta} + Q_i\, dq_i \wedge dt"
        r" = \Bigl(dp_i - \Bigl(\frac{\partial T}{\partial q_i} + Q_i\Bigr) dt\Bigr) \wedge (dq_i - \dot q_i\, dt)",
        "II.3",
    ),
    "multipliers": Formula(
        "Omega = (dp_i - (dT/dq_i + Q_i + lambda_alpha a_{alpha,i}) dt) ^ (dq_i - q_i' dt)",
        r"\boldsymbol{\Omega} = \Bigl(dp_i - \Bigl(\frac{\partial T}{\partial q_i} + Q_i + \lambda_\alpha a_{\alpha i}\Bigr)"
        r" dt\Bigr) \wedge (dq_i - \dot q_i\, dt)",
        "II.3",
    ),
    "euler-lagrange": Formula(
        "Omega = [dp*_j + ((gamma^i_{m,j} omega_m + eps^i_j) p*_i - dT/dpi_j - P_j) dt] ^ eta_j"
        " + p*_i gamma^i_{m,j} eta_m ^ eta_j (m < j),  eta_j = dpi_j - omega_j dt",
        r"\begin{gathered} \boldsymbol{\Omega} = \Bigl[dp^*_j + \Bigl((\gamma^i_{mj} \omega_m + \varepsilon^i_j)\, p^*_i"
        r" - \frac{\partial T}{\partial \pi_j} - P_j\Bigr) dt\Bigr] \wedge \eta_j"
        r" + \sum_{m<j} p^*_i \gamma^i_{mj}\, \eta_m \wedge \eta_j, \\ \eta_j = d\pi_j - \omega_j\, dt \end{gathered}",
        "III.2.5",
    ),
    "voronec": Formula(
        "Omega = (d(dT*/dq_mu') - p_alpha db_{alpha,mu} - R_mu dt) ^ (dq_mu - q_mu' dt),"
        "  R_mu = (dT/dq_mu + Q_mu) + b_{alpha,mu} (dT/dq_alpha + Q_alpha),  dq_alpha = b_{alpha,mu} dq_mu + b_alpha dt",
        r"\begin{gathered} \boldsymbol{\Omega} = \Bigl(d\frac{\partial T^*}{\partial \dot q_\mu} - p_\alpha\, db_{\alpha\mu}"
        r" - R_\mu\, dt\Bigr) \wedge (dq_\mu - \dot q_\mu\, dt), \\ R_\mu = \frac{\partial T}{\partial q_\mu} + Q_\mu"
        r" + b_{\alpha\mu} \Bigl(\frac{\partial T}{\partial q_\alpha} + Q_\alpha\Bigr), \qquad"
        r" dq_\alpha = b_{\alpha\mu}\, dq_\mu + b_\alpha\, dt \end{gathered}",
        "III.4",
    ),
}
OMEGA["chaplygin"] = Formula(OMEGA["voronec"].text, OMEGA["voronec"].latex, "III.3")

EQUATIONS = {
    "newton": Formula("m_i v_i' = X_i", r"m_i \dot v_i = X_i", "II.1.3"),
    "lagrange": Formula(
        "d/dt dT/dq_i' - dT/dq_i = Q_i",
        r"\frac{d}{dt} \frac{\partial T}{\partial \dot q_i} - \frac{\partial T}{\partial q_i} = Q_i",
        "II.3",
    ),
    "multipliers": Formula(
        "d/dt dT/dq_i' - dT/dq_i = Q_i + lambda_alpha a_{alpha,i}",
        r"\frac{d}{dt} \frac{\partial T}{\partial \dot q_i} - \frac{\partial T}{\partial q_i} = Q_i + \lambda_\alpha a_{\alpha i}",
        "I.4.1",
    ),
    "euler-lagrange": Formula(
        "d/dt dT/domega_mu + (gamma^i_{nu,mu} omega_nu + eps^i_mu) dT/domega_i - dT/dpi_mu = P_mu,  P_mu = b_{i,mu} Q_i,"
        "  i over all n quasi-velocities",
        r"\frac{d}{dt} \frac{\partial T}{\partial \omega_\mu} + (\gamma^i_{\nu\mu} \omega_\nu + \varepsilon^i_\mu)"
        r" \frac{\partial T}{\partial \omega_i} - \frac{\partial T}{\partial \pi_\mu} = P_\mu = b_{i\mu} Q_i,"
        r" \qquad \text{summed over } i = 1, \dots, n",
        "I.2.15",
    ),
    "chaplygin": Formula(
        "d/dt dT*/dq_mu' - dT*/dq_mu + p_alpha [(db_{alpha,nu}/dq_mu - db_{alpha,mu}/dq_nu) q_nu' + db_alpha/dq_mu"
        " - db_{alpha,mu}/dt] = Q_mu + b_{alpha,mu} Q_alpha",
        r"\frac{d}{dt} \frac{\partial T^*}{\partial \dot q_\mu} - \frac{\partial T^*}{\partial q_\mu} + p_\alpha \Bigl["
        r"\Bigl(\frac{\partial b_{\alpha\nu}}{\partial q_\mu} - \frac{\partial b_{\alpha\mu}}{\partial q_\nu}\Bigr) \dot q_\nu"
        r" + \frac{\partial b_\alpha}{\partial q_\mu} - \frac{\partial b_{\alpha\mu}}{\partial t}\Bigr]"
        r" = Q_\mu + b_{\alpha\mu} Q_\alpha",
        "III.3",
    ),
    "voronec": Formula(
        "d/dt dT*/dq_mu' = dT*/dq_mu + b_{beta,mu} dT*/dq_beta + Q_mu + b_{beta,mu} Q_beta"
        " + p_alpha [b_{alpha,mu}' - (d/dq_mu + b_{beta,mu} d/dq_beta)(b_{alpha,nu} q_nu' + b_alpha)]",
        r"\begin{split} \frac{d}{dt} \frac{\partial T^*}{\partial \dot q_\mu} = {} & \frac{\partial T^*}{\partial q_\mu}"
        r" + b_{\beta\mu} \frac{\partial T^*}{\partial q_\beta} + Q_\mu + b_{\beta\mu} Q_\beta \\ & + p_\alpha \Bigl\{"
        r"\dot b_{\alpha\mu} - \Bigl(\frac{\partial}{\partial q_\mu} + b_{\beta\mu} \frac{\partial}{\partial q_\beta}\Bigr)"
        r" (b_{\alpha\nu} \dot q_\nu + b_\alpha)\Bigr\} \end{split}",
        "I.4.9",
    ),
}
POINCARE = Formula(
    EQUATIONS["euler-lagrange"].text.replace("mu", "j").replace("nu", "m"),
    EQUATIONS["euler-lagrange"].latex.replace(r"\mu", "j").replace(r"\nu", "m"),
    "I.2.14",
)

CONTRACTION = Formula(
    "i_X Omega = A_mu(X) eta_mu  for  Omega = A_mu ^ eta_mu and eta_mu(X) = 0,  eta_mu = dq_mu - q_mu' dt",
    r"\boldsymbol{\Omega} = A_\mu \wedge \eta_\mu, \quad \eta_\mu(X) = 0 \quad\Longrightarrow\quad"
    r" i_X \boldsymbol{\Omega} = A_\mu(X)\, \eta_\mu, \qquad \eta_\mu = dq_\mu - \dot q_\mu\, dt",
)
CONTRACTION_QUASI = Formula(
    CONTRACTION.text.replace("dq_mu - q_mu'", "dpi_mu - omega_mu"),
    CONTRACTION.latex.replace(r"dq_\mu - \dot q_\mu", r"d\pi_\mu - \omega_\mu"),
)
CONTRACTION_NEWTON = Formula(
    CONTRACTION.text.replace("dq_mu - q_mu'", "dx_mu - v_mu"),
    CONTRACTION.latex.replace(r"dq_\mu - \dot q_\mu", r"dx_\mu - v_\mu"),
)
ENERGY_THEOREM = Formula(
    "d/dt (p_i q_i' - T - U) = Q_i q_i' - dT/dt - dU/dt - lambda_alpha a_alpha"
    "   (p_i = dT/dq_i', Q without the potential's part, dT/dt and dU/dt at fixed q, q')",
    r"\frac{d}{dt} (p_i \dot q_i - T - U) = Q_i \dot q_i - \frac{\partial T}{\partial t} - \frac{\partial U}{\partial t}"
    r" - \lambda_\alpha a_\alpha \qquad \Bigl(p_i = \frac{\partial T}{\partial \dot q_i},\ Q_i"
    r" \text{ without the potential's part}\Bigr)",
)
ENERGY_THEOREM_FREE = Formula(
    ENERGY_THEOREM.text.replace(" - lambda_alpha a_alpha", ""),
    ENERGY_THEOREM.latex.replace(r" - \lambda_\alpha a_\alpha", ""),
)
REACTION = Formula(
    "Q_i becomes Q_i + lambda_alpha a_{alpha,i}  for  a_{alpha,i} q_i' + a_alpha = 0",
    r"Q_i \;\longrightarrow\; Q_i + \lambda_\alpha a_{\alpha i} \quad\text{for}\quad"
    r" a_{\alpha i}\, \dot q_i + a_\alpha = 0",
    "I.4.1",
)
