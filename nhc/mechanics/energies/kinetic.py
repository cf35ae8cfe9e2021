"""The structure of the kinetic energy: T as a function of velocity forms.

T is read as tau(u, q, t) where the u_k are the largest subexpressions of T that are affine in the velocities.  With
u_k = W_ki q'_i + W_k0 and pi_k = d tau/d u_k, the Lagrange expression contracted with a vector e is

    e . (d/dt dT/dq' - dT/dq) = W_k(e) pi'_k + pi_k domega_k(X, e) - e(tau),

where omega_k = W_ki dq_i + W_k0 dt and X is the motion.  The middle term vanishes where omega_k is exact, as it is
whenever the user gave a position and let nhc differentiate it; nothing is expanded, and the cost is a small multiple
of T's own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.dense import pivot_signs
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import is_zero
from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.parts import split_parameters
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import degrees, linear_form
from nhc.mechanics.rotations import turning
from nhc.mechanics.rotations.turning import Direction
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import scene_values
from nhc.records import fresh, record


@record
class Kinetic:
    """``atoms`` are the velocity forms as they stand in T, ``u`` their symbols in ``tau``; ``slope[k]`` is pi_k,
    ``hessian[k][j]`` its derivative by u_j.
    """

    system: System
    atoms: tuple[Node, ...]
    u: tuple[Node, ...]
    tau: Node
    slope: tuple[Node, ...]
    hessian: tuple[tuple[Node, ...], ...]
    _exact: dict[int, bool] = fresh(factory=dict)
    _forms: dict[int, Form] = fresh(factory=dict)

    @property
    def forms(self) -> tuple[Form, ...]:
        """The atoms with their coefficients."""
        return tuple(self.form(k) for k in range(len(self.atoms)))

    def form(self, k: int) -> Form:
        """Atom k with its coefficients."""
        if k not in self._forms:
            self._forms[k] = _as_form(self.system, self.atoms[k], f"u{k + 1}")
        return self._forms[k]

    def is_exact(self, k: int) -> bool:
        """Whether the exterior derivative of form k vanishes identically: rates are known to be exact, others are tested."""
        if k not in self._exact:
            atom = self.atoms[k]
            self._exact[k] = atom in self._rates or _is_exact(self.system, self.form(k))
        return self._exact[k]

    @cached_property
    def _rates(self) -> set[Node]:
        return rates_of_positions(self.system)

    def is_positive(self) -> bool:
        """Whether T is positive as a quadratic form of its velocity forms, with the parameters' values in the spec and its scenes:
        its mass matrix is then positive wherever the motion is regular.  Sums of squares with constant positive factors are, and
        what has a constant positive matrix.
        """
        g = self.system.graph
        constants = g.mask(self.system.p)
        given = scene_values(self.system)
        if all(_is_sum_of_squares(g, self.tau, values, constants) for values in given):
            return True
        flat = [h for row in self.hessian for h in row]
        if any(g.depends(h, ~constants) for h in flat):
            return False
        return all(self._is_positive_at(flat, values) for values in given)

    def _is_positive_at(self, flat: Sequence[Node], values: dict[Node, float]) -> bool:
        """Whether the constant matrix is."""
        g = self.system.graph
        try:
            found = dict(zip(flat, map(float, evaluate(g, flat, values)), strict=True))
        except (ArithmeticError, ValueError):
            return False
        return all(sign > 0 for sign in pivot_signs([[found[h] for h in row] for row in self.hessian]))


def rates_of_positions(system: System) -> set[Node]:
    """Rates of the coordinates and of the spec's positions, these also without factors that do not move."""
    g, p = system.graph, system.graph.mask(system.p)
    return {_without_constants(g, rate, p) for rate in g.rate_of}.union(g.rate_of, system.v)


def velocity_forms(system: System) -> list[Node]:
    """The largest subexpressions of T that are affine in the velocities, without their factors; none where T is no polynomial in
    the velocities.
    """
    return _forms_of(system, energy_as_squares(system))


def _forms_of(system: System, energy: Node) -> list[Node]:
    g = system.graph
    degree = degrees(g, system.v)
    if degree[energy] == 99:
        return []
    rates, constants = rates_of_positions(system), g.mask(system.p)

    def strip(node: Node) -> Node:
        """The rate of a length is a form as it stands, L' = (x x' + y y')/L: exact, which its numerator is not."""
        bare = _without_factor(g, node, degree)
        if system.rotations and bare != node and bare not in rates:  # R_z3 (R_z1 q - R_z2 p)/s is the rate of s
            whole = _without_constants(g, node, constants)
            if whole in rates:
                return whole
        divided = g.op[node] == MUL and any(g.op[x] == POW and g.b[x] < 0 for x in g.kids[node])
        if not divided or g.op[bare] != ADD or bare in rates:
            return bare
        return node if is_exact_rate(system, node) else bare

    return list_atoms(g, energy, degree, strip)


def energy_as_squares(system: System) -> Node:
    """T, or an equal sum of squares where it was multiplied out: where it has products of forms, and factors that move."""
    g = system.graph
    memo = _squares(g)
    if system.T not in memo:
        memo[system.T] = system.T
        may, degree = not system.rotations and "completed squares" not in g.off, degrees(g, system.v)
        written = may and _has_products(g, system.T, degree) and _is_multiplied_out(system)
        if written or (may and _has_lone_points(system, degree)):
            from nhc.mechanics.energies.absolute import complete_squares  # here, for few specs need it

            memo[system.T] = complete_squares(system, longer=not written) or system.T
    return memo[system.T]


def keep_as_written(graph: Graph, energy: Node) -> None:
    """Let an energy be the sum of squares that it is: nothing in it is looked for."""
    _squares(graph)[energy] = energy


def _squares(graph: Graph) -> dict[Node, Node]:
    found: dict[Node, Node] = graph.memory.setdefault("energy as squares", {})
    return found


def _has_products(graph: Graph, root: Node, degree: Sequence[int]) -> bool:
    """Whether two forms are factors of one product somewhere."""
    stack, seen = [root], set[Node]()
    while stack:
        node = stack.pop()
        if node in seen or degree[node] != 2:
            continue
        seen.add(node)
        children = graph.children(node)
        if graph.op[node] == MUL and degree[children[0]] == degree[children[1]] == 1:
            return True
        stack.extend(children)
    return False


def _is_multiplied_out(system: System) -> bool:
    """Whether factors of its forms' products move, or velocities are multiplied with what is no velocity of a coordinate."""
    g, kinetic = system.graph, _structure(system, system.T)
    constants, plain = g.mask(system.p), [atom in system.v for atom in kinetic.atoms]
    return any(
        g.depends(h, ~constants) or (h != g.zero and plain[i] != plain[j])
        for i, row in enumerate(kinetic.hessian)
        for j, h in enumerate(row[: i + 1])
    )


def _has_lone_points(system: System, degree: Sequence[int]) -> bool:
    """Whether a mass that is a point of its own by one velocity, m l^2 a'^2, stands beside forms of several velocities."""
    g, mask = system.graph, system.graph.mask(system.p)
    if degree[system.T] != 2:
        return False
    kinetic = _structure(system, system.T)
    lone = [k for k, atom in enumerate(kinetic.atoms) if atom in system.v]
    if not lone or len(lone) == len(kinetic.atoms):
        return False
    found = [split_parameters(g, kinetic.hessian[k][k], mask) for k in lone]
    return any(rest == g.one and any(n > 1 for n in factor.powers.values()) for factor, rest in found)


def list_atoms(graph: Graph, root: Node, degree: Sequence[int], strip: Callable[[Node], Node]) -> list[Node]:
    """The largest nodes of degree one under the root, in the order of their numbers; ``strip`` takes factors off them."""
    found: set[Node] = set()
    stack, seen = [root], set()
    while stack:
        node = stack.pop()
        if node in seen or degree[node] == 0:
            continue
        seen.add(node)
        if degree[node] == 1:
            found.add(strip(node))
        else:
            stack.extend(graph.children(node))
    return sorted(found)


def _without_factor(graph: Graph, node: Node, degree: Sequence[int]) -> Node:
    """A form times a function is that function times a simpler form."""
    while graph.op[node] == MUL or graph.op[node] == NEG:
        children = graph.children(node)
        moving = [c for c in children if degree[c]]
        if len(moving) != 1:
            break
        node = moving[0]
    return node


def _without_constants(graph: Graph, node: Node, constants: int) -> Node:
    """The node without its sign and factors that depend on the symbols of ``constants`` only."""
    while True:
        op, a, b = graph.op[node], graph.a[node], graph.b[node]
        if op == NEG or (op == MUL and not graph.depends(b, ~constants)):
            node = a
        elif op == MUL and not graph.depends(a, ~constants):
            node = b
        else:
            return node


def _is_sum_of_squares(graph: Graph, root: Node, values: dict[Node, float], constants: int) -> bool:
    stack = [root]
    while stack:
        node = stack.pop()
        op, a, b = graph.op[node], graph.a[node], graph.b[node]
        if op == ADD:
            stack += [a, b]
        elif op == MUL:
            factor, rest = (b, a) if graph.depends(a, ~constants) else (a, b)
            if graph.depends(factor, ~constants) or not _is_positive(graph, factor, values):
                return False
            stack.append(rest)
        elif not (op == POW and b > 0 and b % 2 == 0) and not _is_positive(graph, node, values):
            return False
    return True


def _is_positive(graph: Graph, node: Node, values: dict[Node, float]) -> bool:
    """Whether a constant is positive for these values of the parameters."""
    try:
        return float(evaluate(graph, [node], values)[0]) > 0
    except (ArithmeticError, ValueError, KeyError):
        return False


def kinetic_structure(system: System) -> Kinetic:
    """T's velocity forms; where T is no polynomial in the velocities they are the velocities themselves."""
    return _structure(system, energy_as_squares(system))


def _structure(system: System, energy: Node) -> Kinetic:
    """That of T as it is written, or as squares; each is made once."""
    memo: dict[tuple[int, Node], Kinetic] = system.graph.memory.setdefault("kinetic structures", {})
    known = memo.get((id(system), energy))
    if known is None or known.system is not system:
        known = memo[id(system), energy] = _read_structure(system, energy)
    return known


def _read_structure(system: System, energy: Node) -> Kinetic:
    g = system.graph
    atoms = _forms_of(system, energy)
    mask = g.mask(system.v)
    u = tuple(g.symbol(f"u{k + 1}", "form") for k in range(len(atoms)))
    tau = substitute(g, [energy], dict(zip(atoms, u, strict=True)))[0] if atoms else energy
    if not atoms or g.depends(tau, mask):
        atoms = [v for v in system.v if g.depends(energy, g.deps[v])]
        u = tuple(g.symbol(f"u{k + 1}", "form") for k in range(len(atoms)))
        tau = substitute(g, [energy], dict(zip(atoms, u, strict=True)))[0]
    slope = tuple(gradient(g, tau, u))
    hessian = tuple(tuple(gradient(g, pi, u)) for pi in slope)
    return Kinetic(system, tuple(atoms), u, tau, slope, hessian)


def _as_form(system: System, atom: Node, name: str = "") -> Form:
    g = system.graph
    coefficients, constant = linear_form(g, atom, system.v)
    return Form(name, coefficients, constant, place=g.labels.get(atom, ""), value=atom)


def is_exact_rate(system: System, node: Node) -> bool:
    """Whether an expression that is affine in the velocities is the rate of something."""
    return _is_exact(system, _as_form(system, node))


def _is_exact(system: System, form: Form) -> bool:
    g = system.graph
    if not any(g.deps[a] for a in (*form.coefficients, form.constant)):
        return True
    reach = _reach(system, form)
    moved = [i for i, node in enumerate((*system.q, system.t)) if g.deps[node] & reach]
    first, second = [g.zero] * (system.n + 1), [g.zero] * (system.n + 1)
    for i in moved:
        first[i], second[i] = g.symbol(f"first_{i}", "test"), g.symbol(f"second_{i}", "test")
    x, e = Direction(system, first[:-1], first[-1]), Direction(system, second[:-1])
    return is_zero(g, exterior_derivative(system, form, x, e))


def exterior_derivative(system: System, form: Form, x: Direction, e: Direction) -> Node:
    """domega(X, e) for omega = W_i dq_i + W_0 dt, a vector X and a vector e without time component."""
    g = system.graph
    if not _reach(system, form) & e.reach:
        return g.zero
    closed = turning.derivative_by_turns(system, form, x, e) if system.rotations else None
    if closed is not None:
        return closed
    total = g.dot(x.slopes(form.coefficients), e.x)
    turned = tangent(g, [*form.coefficients, form.constant], e.seeds)
    back = g.dot(turned, (*x.x, x.time))
    return g.sub(total, back)


def _reach(system: System, form: Form) -> int:
    """The coordinates, t among them, of which the form has a differential or on which it depends."""
    g = system.graph
    memo: dict[tuple[Node, Node], int] = g.memory.setdefault("reach of forms", {})
    value = g.dot(form.coefficients, system.v) if form.value is None else form.value
    key = value, form.constant
    if key not in memo:
        own = g.deps[value] | g.deps[form.constant]
        differentials = [q for q, v in zip(system.q, system.v, strict=True) if own & g.deps[v]]
        if form.constant != g.zero:
            differentials.append(system.t)  # d(W_0 dt) = dW_0 ^ dt, whether or not anything depends on t
        memo[key] = own | g.mask(differentials)
    return memo[key]
