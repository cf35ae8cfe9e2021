"""C16: changes of a spec that leave its motion as it is; wrong equations do not stand them."""

from __future__ import annotations

import numpy as np

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.certificates.claims import wrong_claims
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.resolving.resolve import resolve
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings
from nhc.simulate.run import run as run_scene
from nhc.study.atlas.diagram import follow
from nhc.study.atlas.scenario import Measure, Scenario, Verdict

END = 0.5
SLEIGH = """nhc: 1
system: sled
coordinates: [ORDER]
parameters: {m: 1, J: 0.5, a: 0.7}
T: m/2*(x'^2 + y'^2) + J/2*theta'^2GAUGE
constraints:
  - slip: FACTOR(-sin(theta)*x' + cos(theta)*y' - a*theta') = 0
MORE
scenes: {glide: {initial: {theta: 0.8, START}, time: [0, 2], need: [x, y, theta]}}
"""
PLAIN = {"ORDER": "x, y, theta", "GAUGE": "", "FACTOR": "", "MORE": "", "START": "x': 1, theta': 0.5"}
CHANGES: tuple[tuple[str, dict[str, str], str], ...] = (
    ("a total derivative in T", {"GAUGE": " + theta*cos(x)*x' + sin(x)*theta'"}, ""),
    ("constraints times a function", {"FACTOR": "(2 + sin(x*y))*"}, "multipliers"),
    ("another coframe", {"MORE": "quasi_velocities: {u: cos(theta)*x' + sin(theta)*y' + theta', w: 2*theta'}"}, ""),
    ("solved for y'", {"MORE": "dependent: [y]"}, "voronec"),
    ("solved for theta'", {"MORE": "dependent: [theta]"}, "voronec"),
    ("other order of the coordinates", {"ORDER": "theta, y, x"}, ""),
    ("multipliers", {}, "multipliers"),
)
ROLLER = """nhc: 1
system: roller
coordinates: [s, phi]
parameters: {m: 1.5, I: 0.2, R: 0.4, k: 3}
T: m/2*s'^2 + I/2*phi'^2
V: k/2*s^2
constraints:
  - roll: s' - R*phi' = 0
scenes: {go: {initial: {s: 1}, time: [0, 2], need: [s]}}
"""
REDUCED = (
    ROLLER.replace("[s, phi]", "[s]")
    .replace("I/2*phi'^2", "I/2*(s'/R)^2")
    .replace("constraints:\n  - roll: s' - R*phi' = 0\n", "")
)


def run() -> Verdict:
    """The sleigh in seven guises, and a rolling constraint that can be integrated."""
    plain = _end(SLEIGH, PLAIN)
    found = [
        max(abs(a - b) for a, b in zip(_end(SLEIGH, PLAIN | made, form), plain, strict=True))
        for _, made, form in CHANGES
    ]
    whole = abs(_end(ROLLER, {})[0] - _end(REDUCED, {})[0])
    worst = max(*found, whole)
    naive = _apart()
    return Verdict(
        Measure(f"Lagrange's equations of T* for the sleigh, solved for x' and for y', end {naive:.2g} apart", naive),
        Measure(
            f"{', '.join(name for name, _, _ in CHANGES)}; an integrable constraint put in: ends at most {worst:.0e} apart",
            worst,
        ),
        "1e-11 under every change",
        naive > 0.1 and worst <= 1e-11,
    )


def _source(text: str, parts: dict[str, str]) -> Source:
    for key, part in parts.items():
        text = text.replace(key, part)
    return Source("sled.yaml", text)


def _end(text: str, parts: dict[str, str], formulation: str = "") -> tuple[float, ...]:
    found = run_scene(open_scene(_source(text, parts), formulation=formulation), Settings(tolerance=1e-12, points=2))
    return found.rows[-1]


def _apart() -> float:
    """How far the wrong equations end from themselves with another velocity put in."""
    ends = []
    for name in ("x", "y"):
        made = resolve(decode(_source(SLEIGH, PLAIN | {"MORE": f"dependent: [{name}]"})))
        claims = {w.claim.name: w.claim for w in wrong_claims(made, applicable(made))}
        ends.append(follow(made, claims["lagrange_of_T_star"], END)[0])
    return float(np.max(np.abs(ends[0] - ends[1])))


SCENARIO = Scenario("C16", "the same system in other words", "chaplygin_sleigh", run)
