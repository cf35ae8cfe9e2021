"""By way of quasi-velocities: T's own angular velocities in place of the rates of Euler's angles.

With u = W w for forms u of T, the Euler-Lagrange equations M u' = f (I.2.14, under constraints I.2.15) have a matrix that often
hardly moves, where W^T M W is full and moves with every angle.  The state stays (q, w), without constraints w = q': u is put in,
and w' = W^-1 (u' - W' w).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, islice

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import are_zero, rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import divisors_in
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.solving.blocks import find_eliminated, without_sign
from nhc.algebra.walks import count
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.energies.kinetic import Kinetic, kinetic_structure, rates_of_positions, velocity_forms
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import Frame, complete_basis, form_value, make_frame, total_derivative, velocity_symbol
from nhc.mechanics.moving.structure import drift_of
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import Form, System
from nhc.records import record

_MOST = 20
"""Velocities beyond which a second matrix is not assembled; choices of T's forms among which independent ones are sought."""
_TRIALS = 3
"""Bases for which it is."""


@record
class Detour:
    """``equations`` over the quasi-velocities u of ``frame``; ``values`` are theirs by the state's velocities w = ``back`` (u), and
    ``drift`` is W' w for u = W w, and ``swirl`` the same by u itself where this is known.
    """

    equations: Equations
    frame: Frame
    values: dict[Node, Node]
    drift: tuple[Node, ...]
    back: tuple[Node, ...]
    swirl: tuple[Node | None, ...] = ()

    @property
    def graph(self) -> Graph:
        return self.frame.graph

    def accelerations(self, rates: Sequence[Node]) -> list[Node]:
        """w' = W^-1 (u' - W' w) from the rates of u, by u; what both terms have in common is gone before u is put in."""
        g = self.graph
        changed = [g.sub(rate, own) for rate, own in zip(substitute(g, rates, self.values), self.drift, strict=True)]
        known = [k for k, swirl in enumerate(self.swirl) if swirl is not None]
        less = [shorten(g, [g.sub(rates[k], self.swirl[k] or g.zero)])[0] for k in known]
        for k, node in zip(known, substitute(g, less, self.values), strict=True):
            changed[k] = node
        return tangent(g, self.back, dict(zip(self.frame.free, changed, strict=True)))


def find_detour(equations: Equations, kept: Sequence[Form]) -> Detour | None:
    """By T's forms that are no rates of positions; None where there are none, or the system is large.

    ``kept`` are the forms whose values the velocities w are.
    """
    system = equations.system
    if not 1 < system.n - system.l == len(kept) <= _MOST or "detours" in system.graph.off:
        return None
    # a constrained system has its structure already, a tree may do without
    atoms = kinetic_structure(system).atoms if system.l else velocity_forms(system)
    basis = not system.l and len(atoms) == system.n and not set(atoms) <= {*system.v}
    if not basis and rates_of_positions(system).issuperset(atoms):
        return None
    known: dict[tuple[Node, ...], Detour | None] = system.graph.memory.setdefault("detours", {})
    key = (system.T, system.U, *system.Q, *equations.motion.w, *equations.motion.velocities)
    if key not in known:
        known[key] = _make_detour(equations, kept)
    return known[key]


def _make_detour(equations: Equations, kept: Sequence[Form]) -> Detour | None:
    kinetic = kinetic_structure(equations.system)
    for forms in _choose_forms(equations.system, kinetic, kept):
        found = _by_way_of(forms, equations, kinetic, kept)
        if found is not None:
            return found
    return None


def _by_way_of(forms: Sequence[Form], equations: Equations, kinetic: Kinetic, kept: Sequence[Form]) -> Detour | None:
    """None where these forms are no basis, or are singular where the state's velocities are not."""
    system, motion = equations.system, equations.motion
    g, found = system.graph, equations_over(system, forms, [velocity_symbol(system, form) for form in forms], kinetic)
    if found is None:
        return None
    frame, made = found
    if not made.definite or not _is_sound(frame, made, equations):
        return None
    by_w, by_u = moving(system, motion.velocities), moving(system, frame.kinematics)
    values = [g.zero if form in kept else substitute(g, [form_value(system, form)], by_w)[0] for form in forms]
    still = dict.fromkeys(motion.w, g.zero)
    put_in = {symbol: value for symbol, value, form in zip(frame.free, values, forms, strict=True) if form not in kept}
    drift = [total_derivative(system, value, motion.velocities, still) for value in values]
    if system.rotations:  # (R^T)' omega = -omega x R^T omega, which is zero
        drift = [g.zero if gone else x for x, gone in zip(drift, are_zero(g, drift), strict=True)]
    back = tuple(substitute(g, [form_value(system, form) for form in kept], by_u))
    return Detour(made, frame, put_in, tuple(drift), back, _swirl(system, frame, put_in, drift))


def equations_over(
    system: System, forms: Sequence[Form], symbols: Sequence[Node], kinetic: Kinetic
) -> tuple[Frame, Equations] | None:
    """The Euler-Lagrange equations over quasi-velocities; None where these are no basis."""
    try:
        frame = make_frame(system, forms, symbols)
        number = "I.2.15" if system.l else "I.2.14"
        return frame, equations_of(system, Formulation("euler-lagrange", number, frame, None, (), ""), kinetic)
    except Singular:
        return None


def _swirl(system: System, frame: Frame, values: Mapping[Node, Node], drift: Sequence[Node]) -> tuple[Node | None, ...]:
    """The drift by the forms themselves, where their brackets are constant and say it."""
    g = system.graph
    own = drift_of(frame)
    if own is None:
        return ()
    same = are_zero(g, [g.sub(x, y) for x, y in zip(substitute(g, own, values), drift, strict=True)])
    return tuple(node if equal and node != g.zero else None for node, equal in zip(own, same, strict=True))


def _is_sound(frame: Frame, made: Equations, equations: Equations) -> bool:
    """Whether the state's velocities are singular, or their mass matrix M_w is, wherever the coframe of u is.

    M_w = W^T M_u W is where W is, if M_u is finite there: if it divides by nothing that the state's velocities do not.
    """
    if any(without_sign(frame.graph, pivot) in find_eliminated(frame.graph) for pivot, _ in frame.guards):
        return False
    system = equations.system
    g = system.graph
    allowed = divisors_in(g, [system.T, *equations.motion.velocities])
    return divisors_in(g, [x for row in made.mass for x in row]) <= allowed


def _choose_forms(system: System, kinetic: Kinetic, kept: Sequence[Form]) -> Iterator[tuple[Form, ...]]:
    """Bases of T's forms that are no rates of positions, the simplest first, and of the velocities that are kept.

    There may be some: constraints leave fewer of these forms independent, and the first velocities or the last complete them.
    """
    g, turning = system.graph, [k for k in range(len(kinetic.atoms)) if not kinetic.is_exact(k)]
    # of an angular velocity 2 (...) T has the form without the number
    named = {g.split_coefficient(form.value)[1]: form for form in kept if form.value is not None}
    if named.keys() >= {g.split_coefficient(kinetic.atoms[k])[1] for k in turning}:
        whole = _all_forms(system, kinetic, kept, named)
        if whole:
            yield whole
        return
    own = [
        named.get(g.split_coefficient(form_value(system, form))[1], form)
        for form in _own_forms(system, kinetic, turning)
    ]
    rows = {form: list(form.coefficients) for form in (*system.constraints, *own)}
    held = list(system.constraints)
    size = rank(g, list(rows.values())) - system.l if system.l else len(own)

    def independent(forms: Sequence[Form]) -> bool:
        return size == len(own) or rank(g, [rows[form] for form in (*held, *forms)]) == system.l + size

    seen = set[tuple[Form, ...]]()
    for forms in islice(combinations(own, size), _MOST):
        if set(forms) <= set(kept) or not independent(forms):
            continue
        for rest in _complete(system, [*held, *forms], kept):
            if (*forms, *rest) not in seen:
                yield (*forms, *rest)
                seen.add((*forms, *rest))
            if len(seen) == _TRIALS:
                return


def _all_forms(system: System, kinetic: Kinetic, kept: Sequence[Form], named: Mapping[Node, Form]) -> tuple[Form, ...]:
    """All forms of T, rates of positions among them, where these are a basis and their matrix is constant: of a body whose
    coordinates are those of another point than its centre; else none.
    """
    g, atoms, moves = system.graph, kinetic.atoms, ~system.graph.mask(system.p)
    if len(atoms) != len(kept) or any(g.depends(h, moves) for row in kinetic.hessian for h in row):
        return ()
    places = {velocity: k for k, velocity in enumerate(system.v)}
    own = {form.name: form for form in kept}
    found = []
    for k, atom in enumerate(atoms):
        form = named.get(g.split_coefficient(atom)[1])
        if form is None and atom in places:
            form = own.get(system.q_names[places[atom]])
        made = kinetic.form(k)
        found.append(form or Form(f"own {k + 1}", made.coefficients, made.constant, made.place, value=atom))
    rows = [list(form.coefficients) for form in (*system.constraints, *found)]
    return tuple(found) if not set(found) <= set(kept) and rank(g, rows) == system.n else ()


def _complete(system: System, given: Sequence[Form], kept: Sequence[Form]) -> Iterator[tuple[Form, ...]]:
    """The velocities that complete a basis: the first, the last, and some sets among them."""
    missing, pool = system.n - len(given), [form for form in kept if form not in given]
    yield tuple(complete_basis(system, given, pool))
    if missing:
        yield tuple(complete_basis(system, given, pool[::-1])[::-1])
        for rest in islice(combinations(pool, missing), _MOST):
            if len(complete_basis(system, given, rest)) == missing:
                yield rest


def _own_forms(system: System, kinetic: Kinetic, turning: list[int]) -> list[Form]:
    """Independent forms of T that are no rates of positions, the simplest first.

    Once as many forms as velocities stand in them are chosen, as for a body's three turns, no other form of these velocities
    is: a joint's rate stays beside its body's angular velocity.
    """
    g = system.graph
    held = {k: {v for v in system.v if g.depends(kinetic.atoms[k], g.deps[v])} for k in turning}
    chosen, rows = list[Form](), list[list[Node]]()
    closed, open_forms, opened = set[Node](), 0, set[Node]()
    for k in sorted(turning, key=lambda k: (len(held[k]), count(g, [kinetic.atoms[k]]), k)):
        form = kinetic.form(k)
        if held[k] & closed or rank(g, [*rows, list(form.coefficients)]) == len(rows):
            continue
        rows.append(list(form.coefficients))
        chosen.append(Form(f"own {k + 1}", form.coefficients, form.constant, form.place, value=kinetic.atoms[k]))
        opened |= held[k]
        open_forms += 1
        if len(opened) == open_forms:
            closed |= opened
            opened, open_forms = set(), 0
    return chosen
