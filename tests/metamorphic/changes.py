"""Changes of a spec that leave the motion as it is (theory.md A4: G2, G3, G6), each with what it does to states and results."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import partial

from nhc.diagnostics import Source, SpecError
from nhc.language import Differential, Name, Number, Prime, Syntax, decode, walk
from nhc.language.expressions.syntax import Binary
from nhc.mechanics.choosing.choose import build
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.resolving.resolve import resolve
from tests.generate import Writer
from tests.metamorphic.models import State
from tests.metamorphic.texts import Draft, Row, change_trees, inline, replace_leaves, tree_of, value, write

Vector = Sequence[float]


@dataclass(frozen=True)
class Change:
    """``enter`` maps a state of the old spec to one of the new; ``q_back`` and ``lambda_back`` map results to the old.

    ``formulations``: those that the change concerns (all that apply where it is empty).
    """

    text: str
    enter: Callable[[State], State] = lambda state: state
    q_back: Callable[[Vector, State], Vector] = lambda result, state: result
    lambda_back: Callable[[Vector, State], Vector] = lambda result, state: result
    formulations: tuple[str, ...] = ()


class Polynomials(Writer):
    """Functions without angles, whose residues do not depend on what else stands in the spec: for exact comparisons."""

    def function(self, over: list[int]) -> str:
        a, b = self.q[self.rng.choice(over)], self.q[self.rng.choice(over)]
        return self.rng.choice(
            (self.number(), f"{self.number()}*{a}", f"({a}*{b} - t/2)", f"0.2*{a}^2*t", f"({b} + 1/3)")
        )

    def positive(self, over: list[int]) -> str:
        return f"(1 + {self.q[self.rng.choice(over)]}^2)"


def writer_for(draft: Draft, rng: random.Random, exact: bool = False) -> Writer:
    """The writer of a draft's functions."""
    n = len(draft.coordinates)
    names = [name for name, _ in draft.parameters]
    kind = Polynomials if exact else Writer
    return kind(rng, n, list(draft.coordinates), names, over=list(range(n)), timed=True)


def _join(op: str, left: Syntax, right: Syntax) -> Syntax:
    return Binary(op, left, right, left.span, left.span)


def add_gauge(draft: Draft, w: Writer) -> Change:
    """T + dF(q, t)/dt: the same motion and the same reactions (G2)."""
    rate = tree_of(f"({w.function(w.over)} + {w.function(w.over)}*{w.function(w.over)} + 0.3*t*{w.rng.choice(w.q)}^2)'")
    return Change(write(replace(draft, kinetic=_join("+", draft.kinetic, rate))))


def as_velocities(draft: Draft) -> tuple[Row, ...]:
    """All constraints as velocity rows: differentials over dt, holonomic ones by their rates."""
    found = []
    for row in (*draft.rows, *draft.held):
        left, right = row.left, row.right
        if row.form == "differential":
            rates: dict[str, Syntax] = {c: Prime(Name(c, left.span), left.span) for c in draft.coordinates}
            rates["t"] = tree_of("1")
            left, right = replace_leaves(left, {}, rates), replace_leaves(right, {}, rates)
        if row.form == "position":
            left, right = Prime(_join("-", left, right), left.span), tree_of("0")
        found.append(Row(row.name, left, right, "velocity"))
    return tuple(found)


def mix_rows(draft: Draft, w: Writer) -> Change:
    """F(q, t) A in place of A with F a product of triangles: lambda = F^T lambda' (G3)."""
    rows = as_velocities(draft)
    size = len(rows)
    zero, one = tree_of("0"), tree_of("1")
    lower = [
        [one if i == j else tree_of(w.function(w.over)) if j < i else zero for j in range(size)] for i in range(size)
    ]
    upper = [[zero for _ in range(size)] for _ in range(size)]
    for i in range(size):
        upper[i][i] = tree_of(w.positive(w.over))
        for j in range(i + 1, size):
            upper[i][j] = tree_of(w.number())
    factors = [[zero] * size for _ in range(size)]
    for i in range(size):
        for j in range(size):
            for k in range(min(i, j) + 1):
                term = _join("*", lower[i][k], upper[k][j])
                factors[i][j] = term if factors[i][j] is zero else _join("+", factors[i][j], term)
    mixed = []
    for i in range(size):
        total: Syntax = zero
        for j, row in enumerate(rows):
            total = _join("+", total, _join("*", factors[i][j], _join("-", row.left, row.right)))
        mixed.append(Row(rows[i].name, total, zero, "velocity"))

    parameters = {name: value(tree_of(text), {}) for name, text in draft.parameters}

    def lambda_back(found: Vector, state: State) -> Vector:
        at = {**parameters, **dict(zip(draft.coordinates, state.q, strict=True)), "t": state.t}
        return [sum(value(factors[i][j], at) * found[i] for i in range(size)) for j in range(size)]

    return Change(write(replace(draft, rows=tuple(mixed), held=())), lambda_back=lambda_back)


def permute(draft: Draft, w: Writer) -> Change:
    """Everything in another order; dependent velocities and quasi-velocities keep their meaning."""
    order = list(range(len(draft.coordinates)))
    w.rng.shuffle(order)
    rows = list(range(len(draft.rows)))
    w.rng.shuffle(rows)
    held = list(range(len(draft.held)))
    w.rng.shuffle(held)
    entries, quasi = list(draft.define), list(draft.quasi)
    w.rng.shuffle(entries)
    w.rng.shuffle(quasi)
    made = replace(
        draft,
        coordinates=tuple(draft.coordinates[i] for i in order),
        rows=tuple(draft.rows[i] for i in rows),
        held=tuple(draft.held[i] for i in held),
        define=tuple(entries),
        quasi=tuple(quasi),
    )
    row_order = [*rows, *(len(rows) + i for i in held)]

    def enter(state: State) -> State:
        return State(state.t, tuple(state.q[i] for i in order), tuple(state.v[i] for i in order))

    return Change(
        write(made), enter, lambda found, _: _scatter(found, order), lambda found, _: _scatter(found, row_order)
    )


def _scatter(found: Vector, order: Sequence[int]) -> Vector:
    result = [0.0] * len(order)
    for place, index in enumerate(order):
        result[index] = found[place]
    return result


def choose_dependents(draft: Draft, w: Writer) -> Change:
    """Another regular choice of dependent velocities (G6)."""
    size = len(draft.rows) + len(draft.held)
    for _ in range(40):
        chosen = tuple(sorted(w.rng.sample(draft.coordinates, size)))
        text = write(replace(draft, dependent=chosen))
        try:
            build(resolve(decode(Source("draft.yaml", text))), "voronec")
        except (NotApplicable, SpecError):
            continue
        return Change(text, formulations=("voronec", "chaplygin"))
    raise AssertionError("no regular choice in 40 draws")


def choose_basis(draft: Draft, w: Writer) -> Change:
    """Other quasi-velocities: inhomogeneous, time-dependent, not integrable (A1 (2) to (4))."""
    plain = replace(inline(draft), quasi=(), dependent=())
    system = resolve(decode(Source("draft.yaml", write(plain))))
    bound = choose_dependent(system).dependent if system.constraints else ()
    free = [i for i in range(len(draft.coordinates)) if i not in bound]
    forms = []
    for k, lead in enumerate(free):
        terms = [f"{w.positive(w.over)}*{w.q[lead]}'"]
        terms += [f"{w.function(w.over)}*{w.q[j]}'" for j in free[:k]]
        terms += [f"0.1*{w.function(w.over)}*{w.q[j]}'" for j in free[k + 1 :] if w.rng.random() < 0.5]
        if w.rng.random() < 0.6:
            terms.append(w.function(w.over))
        name = next(f"qv{k}_{i}" for i in range(99) if f"qv{k}_{i}" not in draft.names)
        forms.append((name, tree_of(" + ".join(terms))))
    return Change(write(replace(plain, quasi=tuple(forms))), formulations=("euler-lagrange",))


def rescale(draft: Draft, w: Writer) -> Change:
    """Other units of each coordinate, of time and of mass: q = s Q, t = tau t', T = T'/mu."""
    scales = {name: w.rng.choice((0.5, 2.0, 4.0, 0.25, 1.5)) for name in draft.coordinates}
    tau, mu = w.rng.choice((0.5, 2.0, 1.25)), w.rng.choice((0.5, 4.0, 3.0))
    names = {name: tree_of(f"{s}*{name}") for name, s in scales.items()} | {"t": tree_of(f"{tau}*t")}
    rates: dict[str, Syntax] = {
        name: _join("*", tree_of(str(s)), Differential(name, draft.kinetic.span)) for name, s in scales.items()
    }
    rates["t"] = _join("*", tree_of(str(tau)), Differential("t", draft.kinetic.span))
    slower = tree_of(str(tau))
    made = change_trees(draft, lambda tree: replace_leaves(tree, names, rates, lambda node: _join("/", node, slower)))

    def times(factor: float, tree: Syntax) -> Syntax:
        return _join("*", tree_of(str(factor)), tree)

    made = replace(
        made,
        kinetic=times(mu, made.kinetic),
        potential=None if made.potential is None else times(mu, made.potential),
        forces=tuple((name, times(mu * scales[name], tree)) for name, tree in made.forces),
    )
    s = list(scales.values())

    def enter(state: State) -> State:
        q = tuple(x / k for x, k in zip(state.q, s, strict=True))
        return State(state.t / tau, q, tuple(v * tau / k for v, k in zip(state.v, s, strict=True)))

    weights = [mu * tau if row.form == "velocity" else mu for row in (*draft.rows, *draft.held)]
    return Change(
        write(made),
        enter,
        lambda found, _: [a * k / tau**2 for a, k in zip(found, s, strict=True)],
        lambda found, _: [x / k for x, k in zip(found, weights, strict=True)],
    )


def move_point(draft: Draft, w: Writer) -> Change:
    """q_i = Q_i + c sin(Q_j) + d t^2: a point transformation; Q_j gains c cos(Q_j) times the force on q_i."""
    c, d = w.rng.choice((0.4, -0.7)), w.rng.choice((0.0, 0.3))
    names = list(draft.coordinates)
    i = w.rng.randrange(len(names))
    j = w.rng.choice([k for k in range(len(names)) if k != i])
    x, y = names[i], names[j]
    shift = f"{c}*sin({y}) + {d}*t^2"
    rate = f"d{x} + {c}*cos({y})*d{y} + {2 * d}*t*dt"
    span = draft.kinetic.span
    form = replace_leaves(tree_of(rate), {f"d{k}": Differential(k, span) for k in (x, y, "t")})
    made = change_trees(draft, lambda tree: replace_leaves(tree, {x: tree_of(f"{x} + {shift}")}, {x: form}))
    forces = dict(made.forces)
    if x in forces:
        more = _join("*", tree_of(f"{c}*cos({y})"), forces[x])
        forces[y] = _join("+", forces[y], more) if y in forces else more
    made = replace(made, forces=tuple(forces.items()))

    def enter(state: State) -> State:
        q, v = list(state.q), list(state.v)
        q[i] -= c * math.sin(q[j]) + d * state.t**2
        v[i] -= c * math.cos(q[j]) * v[j] + 2 * d * state.t
        return State(state.t, tuple(q), tuple(v))

    def q_back(found: Vector, state: State) -> Vector:
        result = list(found)
        result[i] += c * math.cos(state.q[j]) * found[j] - c * math.sin(state.q[j]) * state.v[j] ** 2 + 2 * d
        return result

    return Change(write(made), enter, q_back)


def write_as_forms(draft: Draft, w: Writer) -> Change:
    """Definitions written out, and rows in velocities as differential forms: A q' + a = 0 is A dq + a dt = 0."""
    made = inline(draft)
    rows = []
    for row in made.rows:
        primes = [node for side in (row.left, row.right) for node in walk(side) if isinstance(node, Prime)]
        if row.form == "differential" or not all(isinstance(node.operand, Name) for node in primes):
            rows.append(row)
            continue
        whole = _join("-", row.left, row.right)
        free = replace_leaves(whole, {}, prime=lambda node: Number(Fraction(0), node.span))
        total = _join("*", free, Differential("t", whole.span))
        for name in dict.fromkeys(node.operand.name for node in primes if isinstance(node.operand, Name)):
            slope = _join("-", replace_leaves(whole, {}, prime=partial(_alone, name)), free)
            total = _join("+", total, _join("*", slope, Differential(name, whole.span)))
        rows.append(Row(row.name, total, tree_of("0"), "differential"))
    return Change(write(replace(made, rows=tuple(rows))))


def _alone(name: str, node: Prime) -> Syntax:
    """One for the velocity of that name, zero for the others."""
    assert isinstance(node.operand, Name)
    return Number(Fraction(node.operand.name == name), node.span)


EVERYWHERE = (add_gauge, permute, choose_basis, rescale)
WITH_ROWS = (mix_rows, choose_dependents, write_as_forms)


def changes_for(draft: Draft) -> tuple[Callable[[Draft, Writer], Change], ...]:
    """The changes that a spec admits."""
    more = WITH_ROWS if draft.rows or draft.held else ()
    moved = (move_point,) if len(draft.coordinates) > 1 else ()
    return (*EVERYWHERE, *more, *moved)
