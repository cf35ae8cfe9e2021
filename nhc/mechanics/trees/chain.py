"""The equations of motion of a chain or tree as the least of a sparse quadratic function: Gauss's principle by recursion.

With T's velocity forms z_k = a_kc z_c + constants (:mod:`nhc.mechanics.trees.recursion`), the rates make

    1/2 (z' - free)^T H (z' - free) - force . z'        (K. F. Gauss, J. reine angew. Math. 4 (1829) 232)

least, where z' = a z' + turn: H is T's Hessian by the forms, ``turn`` the rate of a form where those it is made of have none.
Nothing here is a matrix over all rates: the cost follows the tree.  Forces are gathered by one reverse sweep.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from nhc.algebra.calculus import pullback_gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import split_parameters, tidy
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import count
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.motion import Motion
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import System
from nhc.mechanics.trees.bodies import Spatial
from nhc.mechanics.trees.covectors import Covector, Sweeps
from nhc.mechanics.trees.recursion import Recursion, Terms, Weights, read_recursion
from nhc.mechanics.trees.units import common_mass, scales
from nhc.mechanics.trees.views import Turned
from nhc.mechanics.trees.weight import weigh
from nhc.records import record

_MANY = 6  # forms per rate beyond which no recursion is sought: they are the forms of a few bodies under constraints


@record
class Chain:
    """Variable i < ``rates`` is ``scale[i]`` times the i-th rate, or what ``turned`` puts in its place; the others are forms in
    units that keep coefficients free of parameters; ``weights[a, b]`` (a <= b) is H, ``force[i]`` what pulls at variable i, both
    over one mass ``unit``.

    ``turn[k]``, ``steady[k]`` (no constant of the form moves) and ``offset[k]`` (an acceleration given to the form and to all
    that continue it) belong to variable rates + k.
    """

    graph: Graph
    rates: int
    definitions: tuple[Terms, ...]
    weights: Weights
    turn: tuple[Node, ...]
    steady: tuple[bool, ...]
    offset: tuple[Node, ...]
    force: tuple[Node, ...]
    velocity: tuple[Node, ...]
    scale: tuple[Node, ...]
    unit: Node
    parameters: int
    velocities: tuple[Node, ...]  # the kept ones, as symbols
    along: dict[Node, Node]  # the motion: what q and t change by
    places: Callable[[], dict[int, Node]]  # what the spec differentiated for a form to be its rate
    turned: tuple[Turned, ...] = ()  # three variables that are R^T times what else they would be

    @property
    def size(self) -> int:
        return self.rates + len(self.definitions)


def find_chain(system: System, motion: Motion, kinetic: Kinetic, spatial: Spatial | None = None) -> Chain | None:
    """The recursion of T's velocity forms (:func:`nhc.mechanics.energies.whole_forms.whole_kinetic`) along a motion, with forces;
    None where the forms are not sums and products.  ``spatial`` is a recursion that was read from the bodies' positions.
    """
    if len(kinetic.u) > _MANY * len(motion.w):
        return None
    g = system.graph
    mask = g.mask(system.p)
    forms, to_motion = on_motion(kinetic, motion)
    sweeps = Sweeps(system, motion.velocities)
    if spatial is None:
        recursion = read_recursion(g, forms, motion.w, mask, sweeps.rates_of_entries())
    else:
        recursion = spatial.recursion
    if recursion is None:
        return None
    placed = recursion.forms if spatial is None else spatial.placed
    weights, pull = _hessian(g, kinetic, recursion, placed, to_motion, sweeps.seeds)
    weighed = spatial.weighed if spatial is not None else None
    potential, places, weight = weighed or weigh(system, kinetic)
    for k, force in weight.items() if spatial is None or not spatial.offsets else ():
        for i, a in placed[k].items():
            pull[i] = g.add(pull[i], g.mul(a, force))
    forces = forces_of(kinetic, sweeps, potential, places, to_motion, spatial.known if spatial is not None else ())
    if forces is None:
        return None
    own = pullback_gradient(g, forces, motion.w)
    for turned in spatial.turned if spatial is not None else ():
        turned.from_space(g, own)
    for i, force in enumerate(own):
        pull[i] = g.add(pull[i], force)
    if spatial is None:
        return _in_units(
            system, motion, recursion, weights, pull, sweeps.seeds, places=lambda: _places(kinetic, recursion)
        )
    torques = substitute(g, [torque for _, torque in spatial.torques], to_motion)
    for (i, _), torque in zip(spatial.torques, torques, strict=True):
        pull[i] = g.add(pull[i], torque)
    return _in_units(system, motion, recursion, weights, pull, sweeps.seeds, spatial)


def on_motion(kinetic: Kinetic, motion: Motion) -> tuple[list[Node], dict[Node, Node]]:
    """T's forms along a motion, and what it makes of the velocities and of the forms' symbols."""
    to_motion = moving(kinetic.system, motion.velocities)
    forms = substitute(kinetic.system.graph, kinetic.atoms, to_motion)
    return forms, {**to_motion, **dict(zip(kinetic.u, forms, strict=True))}


# --- T's Hessian and the forces --------------------------------------------------------------------------------


def _hessian(
    g: Graph,
    kinetic: Kinetic,
    recursion: Recursion,
    placed: Sequence[Terms],
    to_motion: dict[Node, Node],
    along: dict[Node, Node],
) -> tuple[Weights, list[Node]]:
    """H over the variables, and minus the rates of T's slopes at fixed forms (where T's coefficients move)."""
    weights: Weights = {}
    pull = [g.zero] * recursion.size
    explicit = substitute(g, tangent(g, kinetic.slope, along), to_motion)
    for k, row in enumerate(kinetic.hessian):
        for i, a in placed[k].items():
            pull[i] = g.sub(pull[i], g.mul(a, explicit[k]))
        for j in range(k + 1):
            if row[j] == g.zero:
                continue
            h = substitute(g, [row[j]], to_motion)[0]
            for i, a in recursion.forms[k].items():
                for c, b in recursion.forms[j].items():
                    key = (min(i, c), max(i, c))
                    twice = 2 if i == c and j < k else 1
                    value = g.mul(g.number(twice), g.mul(g.mul(a, b), h))
                    weights[key] = g.add(weights.get(key, g.zero), value)
    return {key: h for key, h in weights.items() if h != g.zero}, pull


def forces_of(
    kinetic: Kinetic,
    sweeps: Sweeps,
    potential: Node,
    places: dict[Node, Node],
    to_motion: dict[Node, Node],
    known: Collection[int],
) -> list[tuple[Node, Node]] | None:
    """(velocity on the motion, what pulls at it) apart from T's forms: dT/dq, dU/dq, Q, and the forms that are not exact, without
    those whose turning is ``known``.

    None where these hold a quaternion's own rates.
    """
    g, system = sweeps.graph, kinetic.system
    turned = _turning(kinetic, sweeps, to_motion, known)
    if turned is None:
        return None
    applied = Covector(tuple(0 if k in sweeps.quaternions else x for k, x in enumerate(system.Q)), system.torques)
    total = sweeps.slopes_of(potential).put(g, places).plus(g, applied)
    if system.pulls is not None:
        joined = sweeps.slopes([(potential, g.one), *system.pulls.forces]).put(g, places)
        joined = joined.plus(g, Covector(system.pulls.rest, system.torques))
        if count(g, joined.forces) < count(g, total.forces):
            total = joined
    total = sweeps.slopes_of(kinetic.tau).plus(g, total).put(g, to_motion)
    return sweeps.pairs(total.plus(g, turned, -1))


def _turning(kinetic: Kinetic, sweeps: Sweeps, to_motion: dict[Node, Node], known: Collection[int]) -> Covector | None:
    """pi_k domega_k(X, e) summed over the forms that are not exact, by reverse sweeps over pi_k u_k with pi_k held."""
    g = sweeps.graph
    held = [k for k in range(len(kinetic.u)) if k not in known and not kinetic.is_exact(k)]
    forms = sweeps.named([kinetic.atoms[k] for k in held])
    if sweeps.has_own_rates(forms):
        return None
    symbols = [g.symbol(f"slope{k + 1}", "held") for k in held]
    turned = sweeps.turned(list(zip(forms, symbols, strict=True)))
    slopes = substitute(g, [kinetic.slope[k] for k in held], to_motion)
    return turned.put(g, to_motion).put(g, dict(zip(symbols, slopes, strict=True)))


def _places(kinetic: Kinetic, recursion: Recursion) -> dict[int, Node]:
    """The positions whose rates the variables are but for positive constants, where the spec has these."""
    g, found = kinetic.system.graph, dict[int, Node]()
    mask, bare = g.mask(kinetic.system.p), dict[Node, Node]()
    for rate, place in g.rate_of.items():
        _, rest = split_parameters(g, rate, mask)  # T's forms have no parameters in front of them, and no sign
        bare.update({rest: place, g.neg(rest): g.neg(place)})
    for form, atom in zip(recursion.forms, kinetic.atoms, strict=True):
        place = g.rate_of.get(atom, bare.get(atom, -1))
        for i, a in form.items():
            if place >= 0 and len(form) == 1 and g.value(a) in (1, -1):
                found.setdefault(i, place if a == g.one else g.neg(place))
    return found


# --- units -----------------------------------------------------------------------------------------------------


def _in_units(
    system: System,
    motion: Motion,
    recursion: Recursion,
    weights: Weights,
    pull: list[Node],
    along: dict[Node, Node],
    spatial: Spatial | None = None,
    places: Callable[[], dict[int, Node]] = dict,
) -> Chain:
    g, rates = system.graph, recursion.rates
    mask = g.mask(system.p)
    scale = scales(g, recursion, weights, mask)

    known: dict[tuple[Node, ...], Node] = {}

    def divided(*parts: Node) -> Node:
        if parts not in known:
            node, *by = parts
            for divisor in by:
                node = g.div(node, divisor)
            known[parts] = tidy(g, node, mask)
        return known[parts]

    weights = {(a, b): divided(h, scale[a], scale[b]) for (a, b), h in weights.items()}
    unit = common_mass(g, recursion, weights, mask)
    definitions = tuple(
        {c: divided(g.mul(a, scale[rates + k]), scale[c]) for c, a in terms.items()}
        for k, terms in enumerate(recursion.definitions)
    )
    kept = list(motion.w)
    turns, turned, offsets = (spatial.turns, spatial.turned, spatial.offsets) if spatial is not None else ((), (), ())
    for own in turned:
        own.from_space(g, kept)
    velocity, turn, steady = _motion_of(g, motion, recursion, definitions, scale, along, turns, mask, kept)
    return Chain(
        graph=g,
        rates=rates,
        definitions=definitions,
        weights={key: divided(h, unit) for key, h in weights.items()},
        turn=tuple(turn),
        steady=tuple(steady),
        offset=tuple(map(g.mul, scale[rates:], offsets)) if offsets else (g.zero,) * len(definitions),
        force=tuple(divided(f, s, unit) for f, s in zip(pull, scale, strict=True)),
        velocity=tuple(velocity),
        scale=tuple(scale[:rates]),
        unit=unit,
        parameters=mask,
        velocities=motion.w,
        along=along,
        places=places,
        turned=tuple(turned),
    )


def _motion_of(
    g: Graph,
    motion: Motion,
    recursion: Recursion,
    definitions: Sequence[Terms],
    scale: Sequence[Node],
    along: dict[Node, Node],
    turns: Sequence[Node],
    mask: int,
    kept: Sequence[Node],
) -> tuple[list[Node], list[Node], list[bool]]:
    """Velocities of all variables, the ``turn`` of the definitions where ``turns`` does not give it, and which are ``steady``."""
    velocity = [g.mul(s, w) for s, w in zip(scale[: recursion.rates], kept, strict=True)]
    turn, steady = [], []
    for k, (terms, held) in enumerate(zip(definitions, recursion.constants, strict=True)):
        own = scale[recursion.rates + k]
        *moving, growth = tangent(g, [*(terms.values() if k >= len(turns) else ()), held], along)
        pairs = zip(terms, moving, strict=False)
        parts = [join(g, rate, velocity[c], mask, motion.w) for c, rate in pairs if rate != g.zero]
        turn.append(g.mul(own, turns[k]) if k < len(turns) else g.add(g.sum(parts), g.mul(own, growth)))
        steady.append(growth == g.zero)
        velocity.append(g.add(g.sum([g.mul(a, velocity[c]) for c, a in terms.items()]), g.mul(own, held)))
    return velocity, turn, steady


def join(graph: Graph, x: Node, y: Node, parameters: int, w: Sequence[Node]) -> Node:
    """x y, with parameters and velocities multiplied first: what two components of a vector share is then one node."""
    outer, rest = split_parameters(graph, graph.mul(x, y), parameters | graph.mask(tuple(w)))
    return graph.mul(outer.node(graph), rest)
