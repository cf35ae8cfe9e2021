"""C2: constraints put into T before it is varied, and the boxed line of I.3: other motions, and the energy does not tell."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.mechanics.certificates.claims import Claim, reference_claim, solve_in_doubles, wrong_claims
from nhc.mechanics.choosing.choose import applicable, dependent_of
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_runner, open_system

STEPS = 400
ENDS = (("chaplygin_sleigh", 0.8), ("nh_particle", 5.0), ("rolling_disk", 1.0), ("chaplygin_ball", 2.0))
WRONG = ("lagrange_of_T_star", "boxed_I_3_sign")
Vector = NDArray[np.float64]


def run() -> Verdict:
    """Four systems of the gallery, each for a short time."""
    apart, energy, error = [], 0.0, 0.0
    for name, end in ENDS:
        away, change, off = _compare(name, end)
        apart.append(away)
        energy, error = max(energy, change), max(error, off)
    return Verdict(
        Measure(
            "the wrong equations of "
            + ", ".join(f"{name} end {a:.2g} and {b:.2g}" for (name, _), (a, b) in zip(ENDS, apart, strict=True))
            + f" away, their energy changes by {energy:.1e} only",
            min(min(pair) for pair in apart),
        ),
        Measure(f"at most {error:.1e} from d'Alembert's equations with multipliers, derived apart", error),
        "1e-8 from an independent derivation; energy is not taken for a proof",
        min(min(pair) for pair in apart) > 0.1 and energy < 1e-7 and error < 1e-8,
    )


def _compare(name: str, end: float) -> tuple[tuple[float, ...], float, float]:
    """(distances of the wrong motions, their energy's change, nhc's distance) from the truth at the end."""
    system = open_system(name)
    found = {w.claim.name: w.claim for w in wrong_claims(system, applicable(system))}
    truth, _ = follow(system, reference_claim(system), end)
    wrong = [follow(system, found[kind], end) for kind in WRONG]
    own = open_runner(system, "reference", "dop853").run((0.0, end))
    off = float(np.max(np.abs(np.array(own.y[: system.n]) - truth)))
    away = tuple(float(np.max(np.abs(q - truth))) for q, _ in wrong)
    return away, max(change for _, change in wrong), off


def follow(system: System, claim: Claim, end: float) -> tuple[Vector, float]:
    """(q at the end, the energy's largest change) along the accelerations of a claim, from the first scene, by RK4."""
    g, n = system.graph, system.n
    dependent = dependent_of(system).dependent
    frame = coordinate_frame(system, dependent)
    free = [i for i in range(n) if i not in dependent]
    start = start_of(system, system.spec.scenes[0])
    still = {system.t: 0.0, **dict(zip(system.p, start.p, strict=True))}

    def values(y: Sequence[float]) -> dict[Node, float]:
        known = {**still, **dict(zip(system.q, y[:n], strict=True)), **dict(zip(frame.free, y[n:], strict=True))}
        moving = [float(x) for x in evaluate(g, frame.kinematics, known)]
        return {**known, **dict(zip(system.v, moving, strict=True))}

    def slope(y: Vector) -> Vector:
        at = values([float(x) for x in y])
        rates = solve_in_doubles(claim, g, at)[0]
        return np.array([at[v] for v in system.v] + [rates[i] for i in free])

    def energy(y: Vector) -> float:
        return float(evaluate(g, [system.energy], values([float(x) for x in y]))[0])

    y = np.array([*start.q, *(start.v[i] for i in free)])
    first, worst = energy(y), 0.0
    for _ in range(STEPS):
        y = _step(slope, y, end / STEPS)
        worst = max(worst, abs(energy(y) - first))
    return y[:n], worst


def _step(slope: Callable[[Vector], Vector], y: Vector, h: float) -> Vector:
    a = slope(y)
    b = slope(y + h / 2 * a)
    c = slope(y + h / 2 * b)
    d = slope(y + h * c)
    return np.asarray(y + h / 6 * (a + 2 * b + 2 * c + d))


SCENARIO = Scenario("C2", "wrong equations from the right data", "chaplygin_sleigh", run)
