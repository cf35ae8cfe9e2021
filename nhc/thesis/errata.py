"""The errata, in the order in which they were found."""

from __future__ import annotations

from nhc.thesis.entries import Erratum


def _erratum(number: int, title: str, place: str, printed: str, correction: str, evidence: str) -> Erratum:
    file = "test_errata" if number <= 8 else "test_errata_in_print"
    test = f"tests/thesis/{file}.py::test_E{number}"
    return Erratum(f"E{number}", title, place, printed, correction, evidence, test)


_LIST = (
    _erratum(
        1,
        "the sign of Čaplygin's bracket",
        "I.3, boxed line",
        "dT/dq'_alpha multiplies (db_alphamu/dq_nu - db_alphanu/dq_mu) q'_nu",
        "the bracket is (db_alphanu/dq_mu - db_alphamu/dq_nu), as in the last line of III.3",
        "on the particle, the skate and the sleigh the printed sign errs twice as far as leaving the term out; the vertical disk "
        "cannot tell, and energy is conserved either way",
    ),
    _erratum(
        2,
        "gamma counted twice",
        "III.2.4 and III.2.5",
        "the sum over increasing pairs is said to be half of itself twice over, so that the full double sum of gamma enters Omega",
        "p*_j [gamma^j_ts dpi_t ^ dpi_s] over increasing pairs, one half of the full sum; epsilon keeps the coefficient 1",
        "the coefficients of Omega are p*_j gamma^j exactly; with gamma doubled the free rigid body's accelerations are wrong by "
        "more than a tenth. The derivation that follows in the text differentiates as if the half were there, so III.2.6 escapes",
    ),
    _erratum(
        3,
        "which indices are summed",
        "III.2.6",
        "all indices are alpha, beta, gamma, which run over the dependent ones",
        "free index mu, velocities omega_nu, and momenta p*_i of all n quasi-velocities, as in I.2.15",
        "without the momenta of the constrained quasi-velocities every truly nonholonomic system of the gallery goes wrong",
    ),
    _erratum(
        4,
        "the 1-form p dq - T dt",
        "II.3, III.2.2, III.3",
        "Omega_c = d(p_i dq_i - T dt), and a_ji dq_i = dpi_j",
        "Omega_c = d(p_i dq_i - (p_i q'_i - T) dt); the two agree for T homogeneous and quadratic in the velocities only. "
        "With inhomogeneous quasi-velocities a_ji dq_i = dpi_j - a_j,n+1 dt",
        "the bead on a rotating rod is driven inwards in place of outwards; for the pumped pendulum even q' comes out wrong",
    ),
    _erratum(
        5,
        "Euler's theorem used beyond its reach",
        "II.3, III.2 after III.2.5, III.3",
        "d2T/dq'_k dq_i q'_k = 2 dT/dq_i; and the automatic rows read A*/2 (dpi - omega dt) = 0",
        "the first holds for T homogeneous quadratic in the velocities; the Hessian of T = A* omega omega/2 is A*, with no half",
        "exact on the double pendulum, off on the pumped pendulum; the Hessian of the rigid body is its inertia",
    ),
    _erratum(
        6,
        "false steps that cancel",
        "III.3.4 to III.3.7, III.4.4, III.4.5",
        "d2T*/dq'dq' without the terms in b_alphanu; T_alphabeta b_betamu + T_alphamu = 0; T_alphaq + T_alphabeta db/dq q' = 0",
        "d(dT*/dq'_mu) = dp_mu + b_alphamu dp_alpha + p_alpha db_alphamu; the two zeros confuse (dT/dq'_alpha)* with the "
        "derivative of T*, which has no q'_alpha. The final Omega is right",
        "on the particle z' = y x' at y = 0.7 the three relations are off by 0.49, 0.7 and x'; the corrected one holds exactly",
    ),
    _erratum(
        7,
        "one index three times",
        "III.4, second associated equation and last line",
        "b_betamu under a sum over mu where the free index is nu; the term d2T*/dq'_mu dq_beta b_betanu dq_mu is missing",
        "b_betanu d/dq_beta, as in I.4.9; the missing term restores -dT*/dq_beta b_betanu",
        "Voronec's particle and the trailers are wrong by more than a hundredth; where b is free of q_alpha nothing shows",
    ),
    _erratum(
        8,
        "the final 2-form of III.4 outside its hypotheses",
        "III.4, Omega",
        "a 2-form with -dT*/dq'_mu dq'_mu ^ dt and no terms in b_alpha or t",
        "(d(dT*/dq'_mu) - p_alpha db_alphamu - R_mu dt) ^ (dq_mu - q'_mu dt)",
        "both have the same kernel for Voronec's particle; with affine constraints, terms of first degree in T or the time "
        "in the constraints only the corrected one has the motion for its kernel",
    ),
    _erratum(
        9,
        "the order of the factors, and a mass too many",
        "II.1.1 against II.1.3, and the rows after II.1.3",
        "the factors of II.1.1 stand in the other order; -m(dv - X dt) = 0",
        "II.1.3 agrees with Omega_c = d(m v dx - T dt); the row is -(m dv - X dt) = 0",
        "the forms are opposite; a falling mass of 2 kg would accelerate by 2 g",
    ),
    _erratum(
        10,
        "the sign of U in L",
        "I.3, hypothesis 1",
        "L = T - U with Q = +dU/dq",
        "L = T + U",
        "the pendulum would be pushed away from its rest",
    ),
    _erratum(
        11,
        "how many equations, and the drift",
        "I.2.15 and the kinematics after it",
        "2n - 1 equations for omega_1+1, ...; q'_i = b_inu omega_nu",
        "2n - l equations for omega_l+1, ...; q'_i = b_inu omega_nu + b_i,n+1",
        "without b_i,n+1 the ball on the turning table breaks its constraints by an amount of order one; with it they hold exactly",
    ),
    _erratum(
        12,
        "p*_j for p*_i",
        "after I.2.11 and before I.2.13",
        "p*_j {[(delta pi_i)' - delta omega_i] - ...}; then [(delta pi_j)' - delta pi'_j] in the next display",
        "p*_i {[(delta pi_i)' - delta omega_i] - ...}; then [(delta pi_j)' - delta omega_j]",
        "with virtual displacements built by differentiation the corrected line is an identity; the printed ones are not",
    ),
    _erratum(
        13,
        "positions and their velocity",
        "II.2",
        "d OM = f(q), and V = df/dq_i q'_i summed over the coordinates",
        "OM = f(q), V = df/dq_r q'_r with r = 1..n+1",
        "without the time's own term the bead on the rod loses its Omega^2 r^2 / 2",
    ),
    _erratum(
        14,
        "a velocity for a coordinate",
        "before I.4.8",
        "dT/dq_i is said to be expressed by dT*/dq'_i",
        "by dT*/dq_i: dT*/dq_j = dT/dq_j + dT/dq'_alpha dq'_alpha/dq_j",
        "I.4.8 holds exactly for Voronec's particle; put in as the sentence says it does not",
    ),
    _erratum(
        15,
        "dots and indices of III.3",
        "II.3.1, III.2.3, III.3.2, III.3.3, III.3 (1)",
        "dT/dq'_i dq_i ^ dt for dT/dq_i dq_i ^ dt; (dT/dq'_mu) q'_mu db_alphamu; dq'_nu in row (1); no term in d2T/dq'dt",
        "dT/dq_i; (dT/dq'_alpha) q'_mu db_alphamu; dq_nu; and d2T/dq'_i dt dt ^ dq_i where T contains the time",
        "each relation holds exactly once corrected and fails as printed (particle, pumped pendulum)",
    ),
    _erratum(
        16,
        "which columns",
        "I.1 and III.1",
        "rank l is taken to mean that the first l columns are regular; commutation is proved for regular linear changes only",
        "choose columns with a regular block; eliminating dq_alpha is a restriction, allowed on Omega because "
        "dq_alpha - q'_alpha dt = b_alphamu (dq_mu - q'_mu dt)",
        "the snakeboard standing straight has rank 2 and a singular first block; Lagrange's Omega restricted is the master form",
    ),
)

ERRATA: dict[str, Erratum] = {erratum.number: erratum for erratum in _LIST}
