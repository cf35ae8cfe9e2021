"""Plans of a scene's functions over the state that its model keeps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import MUL, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.solving.blocks import Matrix, without_sign
from nhc.algebra.walks import reachable
from nhc.mechanics.associate import Equations
from nhc.mechanics.formulate import bordered_system
from nhc.mechanics.motion import Motion
from nhc.mechanics.reduction.reduce import Reduction
from nhc.mechanics.starts.scenes import Start, kept_velocities
from nhc.program.ir import Quantity
from nhc.program.plan import Entry, FunctionPlan
from nhc.program.planning.planner import Planner


@dataclass(eq=False, repr=False)
class ScenePlanner(Planner):
    """Plans over the kept state; what is left out has been given a value that its equations do not depend on."""

    reduction: Reduction = field(kw_only=True)
    shorter: bool = field(default=True, kw_only=True)

    def _arrange(self) -> None:
        made, system, w = self.reduction, self.system, self.equations.motion.w
        self.kept_q = tuple(i for i in made.kept if i < system.n)
        self.kept_w = tuple(i - system.n for i in made.kept if i >= system.n)
        entries = (*system.q, *w)
        symbols = (*(entries[i] for i in made.constants), *(integral.symbol for integral in made.integrals))
        self.parameters = (*system.p, *symbols)
        self.put_in = dict(made.fixed)
        self.original, self.equations = self.equations, self._fixed_equations()
        super()._arrange()
        names = (*(made.names[i] for i in made.constants), *(integral.text for integral in made.integrals))
        for k, (node, name) in enumerate(zip(symbols, names, strict=True)):
            self.state_loads[node] = ("p", len(system.p) + k, f"constant of the motion: {name}")

    @property
    def full_equations(self) -> Equations:
        return self.original

    def eliminated(self) -> dict[Node, Matrix]:
        g, known = self.graph, super().eliminated()
        pivots = [x for x, _ in self.original.guards if without_sign(g, x) in known]
        blocks = [known[without_sign(g, x)] for x in pivots]
        flat = iter(substitute(g, [*pivots, *(x for block in blocks for row in block for x in row)], self.put_in))
        fixed = [without_sign(g, next(flat)) for _ in pivots]
        return dict(
            zip(fixed, [tuple(tuple(next(flat) for _ in row) for row in block) for block in blocks], strict=True)
        )

    def fix(self, nodes: Sequence[Node]) -> list[Node]:
        """Nodes over the full state in terms of what is kept; shorter where they can be."""
        made = substitute(self.graph, nodes, self.put_in)
        if made == list(nodes):
            return made
        zero = are_zero(self.graph, made)
        made = [self.graph.zero if z else x for x, z in zip(made, zero, strict=True)]
        return shorten(self.graph, made) if self.shorter else made

    def _fixed_equations(self) -> Equations:
        equations, g = self.equations, self.graph
        size, motion = len(equations.mass), equations.motion
        held = {i for i in (*self.reduction.kept, *self.reduction.constants) if i < len(motion.velocities)}
        velocities = iter(self.fix([node for i, node in enumerate(motion.velocities) if i in held]))
        moved = tuple(next(velocities) if i in held else g.zero for i in range(len(motion.velocities)))
        made = Motion(motion.w, motion.rates, moved, motion.vectors)
        guards = [x for pair in equations.guards for x in pair]
        guards = substitute(g, guards, self.put_in)
        moving = [(guards[k], guards[k + 1]) for k in range(0, len(guards), 2) if g.value(guards[k]) is None]
        pairs = tuple(dict.fromkeys(moving))
        if not equations.definite:
            return replace(equations, motion=made, guards=pairs, kinetic=lambda: None)
        flat = self.fix([*(x for row in equations.mass for x in row), *equations.force])
        mass = tuple(tuple(flat[k * size : (k + 1) * size]) for k in range(size))
        force = tuple(flat[size * size :])
        return replace(equations, motion=made, assemble=lambda: (mass, force), guards=pairs, kinetic=lambda: None)

    def _solve(self) -> None:
        super()._solve()
        if not self.mass_guards:
            return
        wanted = [self.solved[self.equations.motion.rates[k]] for k in self.kept_w]
        wanted += self.known([node for node, _ in self._columns()])
        seen = set(reachable(self.graph, wanted))
        turned = tuple(guard for guard in self.turned_guards if seen.issuperset(self._factors(guard.value)))
        self.mass_guards = tuple(guard for guard in self.mass_guards if guard in turned or guard.value in seen)
        self.turned_guards = turned

    def _factors(self, node: Node) -> list[Node]:
        """A divisor's, by each of which is divided: those of them that move."""
        g = self.graph
        if g.op[node] != MUL:
            return [node]
        return [
            factor for factor in (*self._factors(g.a[node]), *self._factors(g.b[node])) if not self.is_constant(factor)
        ]

    def dense_system(self) -> tuple[list[list[Node]], list[Node]]:
        """The fixed equations; a bordered system is made from the full ones first."""
        size = len(self.original.mass)
        if self.original.multipliers:
            matrix, right = bordered_system(self.original)
            size = len(right)
            flat = self.fix([*(x for row in matrix for x in row), *right])
        elif self.original.definite:
            return [list(row) for row in self.equations.mass], list(self.equations.force)
        else:
            flat = self.fix([*(x for row in self.original.mass for x in row), *self.original.force])
        return [flat[k * size : (k + 1) * size] for k in range(size)], flat[size * size :]

    def _columns(self) -> list[tuple[Node, str]]:
        nodes = substitute(self.graph, [column.node for column in self.reduction.outputs], self.put_in)
        return [(node, column.name) for node, column in zip(nodes, self.reduction.outputs, strict=True)]

    def list_constants(self, start: Start) -> tuple[Quantity, ...]:
        """The parameters after the spec's, with their values at the start as defaults."""
        system, made, g = self.system, self.reduction, self.graph
        values = (*start.q, *kept_velocities(system, self.kept_forms(), start))
        place = {**start.values(system), **dict(zip((*system.q, *self.equations.motion.w), values, strict=True))}
        whole = self.state_quantities()
        about = "constant of the motion, from the start of the scene"
        found = [replace(whole[i], about=about, default=values[i]) for i in made.constants]
        for integral in made.integrals:
            symbol = g.symbol_of(integral.symbol)
            assert symbol is not None
            default = values[integral.index] - float(evaluate(g, [integral.written], place)[0])
            place[integral.symbol] = default  # what was found later may contain it
            unit = whole[integral.index].unit
            found.append(Quantity(symbol.name, unit, f"in {integral.text}", default))
        return tuple(found)

    def needed_nodes(self) -> list[Node]:
        """The scene's needs in terms of what is kept (and of the unknowns of the planner's solves)."""
        return shorten(self.graph, self.known([node for node, _ in self._columns()]))

    def outputs(self) -> FunctionPlan:
        """What the scene needs, in its order."""
        columns = self._columns()
        nodes = self.needed_nodes()
        rates = self.graph.mask((*self.equations.motion.rates, *self.equations.multipliers))
        moving = any(self.graph.depends(node, rates) for node, _ in columns)
        written = [Entry(node, name) for node, (_, name) in zip(nodes, columns, strict=True)]
        plain = all(node in self.state_loads for node in nodes)  # then there is nothing that can be singular
        guards = () if plain else self.frame_guards() + (self.mass_guards if moving else ())
        return self.plan("outputs", "what the scene needs", "", written, guards, self.solves if moving else ())
