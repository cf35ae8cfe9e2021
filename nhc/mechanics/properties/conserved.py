"""What the motion conserves: energy or the exact balance of its power, momenta, moving energies, and small combinations.

Candidates are momenta p_i, rotations x_a p_b - x_b p_a, the spec's quasi-velocities, squares, and the energy, momenta also
times a parameter of the constraints.  All constant combinations that do not change are found by exact linear algebra at random
points of the motion in a prime field, so cancellations between them (a moving energy E - Omega J, Noether's theorem with a
rotation that turns several coordinates) need no guess.  What is found is tested again modulo another prime; what was not among
the candidates is not found.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.modular import Unlucky, are_zero, is_zero, rank
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.relations import find_relations, without
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import count
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.properties.candidates import Candidate, combine, combine_by_parameters, spell
from nhc.mechanics.properties.constancy import are_constant, has_jumps, jumps, rates_of
from nhc.mechanics.properties.named import energy_name, momentum_name
from nhc.mechanics.properties.sampling import Sampler
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import System
from nhc.mechanics.values import default_values
from nhc.records import record
from nhc.thesis.tie import equation

_SPARE = 6  # points more than candidates
_BUDGET = 260_000  # candidates times operations of the reference at one point
_MOST = 60  # candidates
ENERGY, MOMENTUM = "energy", "momentum"


@record
class Integral:
    """A constant of the motion; ``where`` are the parameters that have to be zero for it.

    ``moving``: the energy less momenta times constants, as it is seen from a moving frame.
    """

    text: str
    node: Node
    where: tuple[str, ...] = ()
    moving: bool = False


@record
class Conserved:
    """What was found.

    ``energy``: whether T + V is constant; ``power``: the terms of its rate, as texts; ``jacobi``: whether p q' - T + V is, where
    that is another function; ``integrals``: functionally independent; ``outputs``: the spec's own that are constant;
    ``tried``: in words; ``torn``: what of T + V, which is constant, jumps for other values of the parameters.
    """

    energy: bool
    power: tuple[str, ...]
    jacobi: bool | None
    integrals: tuple[Integral, ...]
    outputs: tuple[str, ...]
    tried: str
    torn: tuple[str, ...] = ()


def find_conserved(
    system: System, frame: Frame | None, adapted: Frame | None = None, known: Sequence[Node] = ()
) -> Conserved:
    """Search for more than the constants that are ``known`` (integrals of the constraints).

    ``frame`` is one whose free velocities are coordinate velocities (None: no constraints), ``adapted`` the frame of the
    quasi-velocities, if any.
    """
    sampler = Sampler(system, frame)
    g = system.graph
    generalized = generalized_energy(system)
    differs = not is_zero(g, g.sub(generalized, system.energy))
    outputs = [Candidate(name, node) for name, node in system.outputs]
    tested = [Candidate("E", system.energy), Candidate("p q' - T + V", generalized), *outputs]
    constant = are_constant(sampler, [c.node for c in tested])
    driving, uneven = driving_terms(system), uneven_terms(system)
    terms = [*driving, *uneven]
    # the theorem of energy: its terms hold fewer signs than the rate on the motion
    proved = [not terms and not constant[0], not driving and differs and not constant[1]]
    constant[:2] = [constant[0] or not terms, constant[1] or not driving]
    candidates, tried = list_candidates(system, sampler, adapted)
    found = _search(sampler, candidates, frame, known)
    for candidate, added in zip(candidates[-2:], proved, strict=True):
        nodes = [*known, *(i.node for i in found)]
        if added and not jumps(sampler, candidate.node) and _is_independent(sampler, frame, nodes, candidate.node):
            found.append(Integral(candidate.text, candidate.node))
    zero = [symbol for symbol, value in default_values(system).items() if value == 0.0]
    if zero:
        names = tuple(system.symbol_name(symbol) for symbol in zero)
        special = _search(Sampler(system, frame, zero), candidates, frame, [*known, *(i.node for i in found)])
        found += [replace(i, where=names) for i in special]
    stepping = _stepping(system) if constant[0] and jumps(sampler, system.energy) else []
    torn = _list_jumps(system, elsewhere=True) if constant[0] and not stepping else []
    constant = [holds and not jumps(sampler, c.node) for c, holds in zip(tested, constant, strict=True)]
    return Conserved(
        energy=constant[0],
        power=() if constant[0] else (*terms, *stepping),
        jacobi=constant[1] if differs else None,
        integrals=tuple(found),
        outputs=tuple(c.text for c, holds in zip(outputs, constant[2:], strict=True) if holds),
        tried=tried,
        torn=tuple(torn),
    )


def generalized_energy(system: System) -> Node:
    """p_i q'_i - T - U: the energy for T homogeneous quadratic in the velocities, Jacobi's function else."""
    g = system.graph
    p = gradient(g, system.T, system.v)
    return g.sub(g.dot(p, system.v), g.add(system.T, system.U))


@equation("III.2.2")
def power(system: System, multipliers: Sequence[Node]) -> Node:
    """d/dt (p q' - T - U) = Q q' - dT/dt - dU/dt - lambda_alpha a_alpha (the dt component of i_X Omega)."""
    g = system.graph
    explicit = tangent(g, [system.T, system.U], {system.t: g.one})
    driven = [g.mul(s, form.constant) for s, form in zip(multipliers, system.constraints, strict=True)]
    return g.sub(g.dot(system.Q, system.v), g.sum([*explicit, *driven]))


def power_terms(system: System) -> list[str]:
    """The terms of the balance of T + V that do not vanish, in words."""
    return [*driving_terms(system), *uneven_terms(system)]


def uneven_terms(system: System) -> list[str]:
    """Why T + V is not the p q' - T + V of the theorem, in words."""
    g = system.graph
    even = is_zero(g, g.sub(generalized_energy(system), system.energy))
    return [] if even else ["T is not homogeneous quadratic in the velocities"]


def driving_terms(system: System) -> list[str]:
    """The terms of the balance of p q' - T + V that do not vanish, in words (:func:`power`).

    A force whose work others cancel (a gyroscopic one) is none.
    """
    g = system.graph
    terms: list[str] = []
    turned = {k for rotation in system.rotations for k in rotation.places}
    idle = _idle_forces(system)
    given = given_forces(system)
    for i, q in enumerate(system.Q):
        if i not in turned and not idle[i] and not is_zero(g, q):
            terms += [term for name in given[i] if (term := f"the force on `{name}`") not in terms]
    for rotation, torque in zip(system.rotations, system.torques, strict=True):
        if not all(idle[k] for k in rotation.places) and not all(are_zero(g, torque)):
            terms.append(f"the torque on `{rotation.name}`")
    explicit = tangent(g, [system.T, system.U], {system.t: g.one})
    names = "T", system.spec.potential_kind or "V"
    terms += [f"{name} contains the time" for name, z in zip(names, are_zero(g, explicit), strict=True) if not z]
    for form in system.constraints:
        if not is_zero(g, form.constant):
            terms.append(f"the reaction of the moving constraint `{form.name}`")
    return terms


def given_forces(system: System) -> list[list[str]]:
    """For each coordinate what the spec names in `forces:` that may push along it: itself, or velocities and points."""
    turning = {velocity for rotation in system.spec.rotations for velocity in rotation.velocities}
    named = [force.name for force in system.spec.forces if force.name not in turning]
    others = [name for name in named if name not in system.q_names]
    return [[name] if name in named or not others else others for name in system.q_names]


def _idle_forces(system: System) -> list[bool]:
    """Which forces do no work that others do not cancel: all work is done without their velocities.

    That the work has no slope along these is not enough: an engine of constant power, Q = P/q', does work at every speed.
    """
    g = system.graph
    work = g.dot(system.Q, system.v)
    idle = are_zero(g, gradient(g, work, system.v))
    others = g.sum([g.mul(q, v) for q, v, none in zip(system.Q, system.v, idle, strict=True) if not none])
    try:
        (others,) = substitute(g, [others], {v: g.zero for v, none in zip(system.v, idle, strict=True) if none})
    except ZeroDivisionError:
        return [False] * system.n
    return idle if is_zero(g, g.sub(work, others)) else [False] * system.n


def _stepping(system: System) -> list[str]:
    """The energies that jump, in words: the equations have no force for the jump."""
    return [f"{name} jumps" for name in _list_jumps(system)] or ["T + V may jump"]


def _list_jumps(system: System, *, elsewhere: bool = False) -> list[str]:
    parts = (("T", system.T), (system.spec.potential_kind or "U", system.U))
    return [name for name, node in parts if has_jumps(system, [node], undecided=False, elsewhere=elsewhere)]


# --- candidates -------------------------------------------------------------------------------------------


def list_candidates(system: System, sampler: Sampler, frame: Frame | None) -> tuple[list[Candidate], str]:
    """Candidates, simplest first, and what they are in words; fewer for systems whose points are dear.

    The energy comes last, so that a combination with it is named as an energy.
    """
    g = system.graph
    p = gradient(g, system.T, system.v)
    cost = max(1, count(g, sampler.reference.nodes()))
    budget = min(_MOST, _BUDGET // cost)
    names = [momentum_name(system, name, p[i]) for i, name in enumerate(system.q_names)]
    momenta = [Candidate(name, momentum, MOMENTUM) for name, momentum in zip(names, p, strict=True)]
    turns = _rotations(system, p, names)
    scaled = [
        Candidate(f"{system.symbol_name(s)} {c.text}", g.mul(s, c.node), MOMENTUM, scaled=True)
        for s in _constraint_parameters(system)
        for c in (*momenta, *turns)
    ]
    groups = [
        ("momenta and the energy", momenta),
        ("quasi-velocities and their momenta", _quasi(system, p, frame)),
        ("angular momenta of rotations (L)", _angular_momenta(system, p)),
        ("angular momenta of coordinate pairs", turns),
        ("squares of coordinates and velocities", _squares(system)),
        ("momenta and angular momenta times a parameter of the constraints", scaled),
        ("angular momenta on the axes of angular velocities (L)", _angular_momenta(system, p, own=True)),
    ]
    kept, words = list[Candidate](), list[str]()
    for word, group in groups:
        if group and (not words or len(kept) + len(group) <= budget):
            kept += group
            words.append(word)
    kept.append(Candidate(energy_name(system), system.energy, ENERGY))
    kept.append(Candidate("(p q' - T + V)", generalized_energy(system), ENERGY))
    return kept, "linear combinations, with constant coefficients, of " + ", ".join(words)


def _quasi(system: System, p: Sequence[Node], frame: Frame | None) -> list[Candidate]:
    """The spec's quasi-velocities, and the momenta p*_mu = p_i b_i,mu of the frame's: constant in Cetaev's cyclic case (I.2.14)."""
    g = system.graph
    found = [Candidate(form.name, form_value(system, form)) for form in system.quasi]
    if frame is None:
        return found
    for symbol, e in zip(frame.free, frame.free_vectors, strict=True):
        known = g.symbol_of(symbol)
        if known is not None and known.kind == "quasi":
            found.append(Candidate(f"p*_{known.name}", g.dot(p, e)))
    return found


def _rotations(system: System, p: Sequence[Node], names: Sequence[str]) -> list[Candidate]:
    """x_a p_b - x_b p_a for pairs of coordinates of one unit that are no angles."""
    g, found = system.graph, []
    units = [c.unit or "" for c in system.spec.coordinates]
    turned = {k for rotation in system.rotations for k in rotation.places}
    for i, j in combinations([k for k in range(system.n) if k not in turned], 2):
        if units[i] != units[j] or units[i] in ("rad", "deg"):
            continue
        x, y = system.q_names[i], system.q_names[j]
        turn = g.sub(g.mul(system.q[i], p[j]), g.mul(system.q[j], p[i]))
        found.append(Candidate(f"({x} {names[j]} - {y} {names[i]})", turn, MOMENTUM))
    return found


def _angular_momenta(system: System, p: Sequence[Node], *, own: bool = False) -> list[Candidate]:
    """p_i e_i for the unit turns of each rotation about the axes that its velocities do not belong to, or about their ``own``."""
    found = []
    for rotation in system.rotations:
        letters = "xyz" if (rotation.sign > 0) != own else "123"
        momenta = rotation.own_momenta if own else rotation.other_momenta
        values = momenta(system.graph, [p[k] for k in rotation.places])
        found += [
            Candidate(f"L_{rotation.name}_{letter}", node, MOMENTUM)
            for letter, node in zip(letters, values, strict=True)
        ]
    return found


def _squares(system: System) -> list[Candidate]:
    g = system.graph
    velocities = zip(system.q_names, system.v, strict=True)
    positions = zip(system.q_names, system.q, strict=True)
    found = [Candidate(f"{name}'^2", g.power(v, 2)) for name, v in velocities]
    return found + [Candidate(f"{name}^2", g.power(q, 2)) for name, q in positions]


def _constraint_parameters(system: System) -> list[Node]:
    """The parameters that the constraints contain."""
    g = system.graph
    entries = [x for form in system.constraints for x in (*form.coefficients, form.constant)]
    return [s for s in system.p if any(g.depends(x, g.deps[s]) for x in entries)]


# --- the search -------------------------------------------------------------------------------------------


def _search(
    sampler: Sampler, candidates: Sequence[Candidate], frame: Frame | None, known: Sequence[Node]
) -> list[Integral]:
    """Independent constants beyond ``known`` among the constant combinations of the candidates."""
    g, width = sampler.system.graph, len(candidates)
    rates = rates_of(sampler, [c.node for c in candidates])
    prime = primes_of(g)[0]
    try:
        rows = sampler.residues([*rates, *(c.node for c in candidates)], width + _SPARE, prime)
    except Unlucky:
        return []
    constant = find_relations([row[:width] for row in rows], width, prime)
    trivial = find_relations([row[width:] for row in rows], width, prime)
    vectors = [[g.number(k) for k in vector] for vector in without(constant, trivial)]
    plain = [k for k, c in enumerate(candidates) if not c.scaled]
    numbers = [v for v in vectors if all(v[k] == g.zero for k, c in enumerate(candidates) if c.scaled)]
    for weights in combine_by_parameters(sampler, [candidates[k] for k in plain], len(numbers)):
        wide = dict(zip(plain, weights, strict=True))
        vectors.append([wide.get(k, g.zero) for k in range(width)])
    integrals: list[Integral] = []
    for vector in vectors:
        node = combine(g, vector, candidates)
        nodes = [*known, *(i.node for i in integrals)]
        if not _is_independent(sampler, frame, nodes, node):
            continue
        if are_constant(sampler, [node])[0] and not jumps(sampler, node):
            kinds = {c.kind for k, c in zip(vector, candidates, strict=True) if k != g.zero}
            integrals.append(Integral(spell(g, vector, candidates), node, moving={ENERGY, MOMENTUM} <= kinds))
    return integrals


def _is_independent(sampler: Sampler, frame: Frame | None, known: Sequence[Node], node: Node) -> bool:
    """Whether the node's differential on the constraints is independent of those of the known ones."""
    system, g = sampler.system, sampler.system.graph
    free = frame.free if frame is not None else system.v
    nodes = [*known, node]
    if frame is not None:
        nodes = substitute(g, nodes, moving(system, frame.kinematics))
    nodes = substitute(g, nodes, dict.fromkeys(sampler.zeroed, g.zero), named=False)
    rows = [gradient(g, x, (*system.q, *free, system.t)) for x in nodes]
    if not sampler.leaf.steps:
        return rank(g, rows) == len(nodes)
    return sampler.rank(rows) == len(nodes)
