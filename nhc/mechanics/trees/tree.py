"""Accelerations of chains and trees from the leaves to the root, as straight-line code.

The least of a sparse quadratic function is found by taking its variables away one after another: a form is replaced by what it is
made of once nothing else is made of it, a rate by its optimum once no form holds it.  For a tree of bodies these are the
articulated inertias of R. Featherstone, Int. J. Robot. Res. 2 (1983) 13, and the pivots are those of L D L^T of the mass matrix in
this order: positive wherever the matrix is.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import sum_products
from nhc.mechanics.trees.chain import Chain
from nhc.mechanics.trees.order import choose_order
from nhc.mechanics.trees.recursion import Terms, Weights
from nhc.mechanics.trees.rods import Rods
from nhc.mechanics.trees.spheres import Spheres
from nhc.records import structure

_NEAR = 9  # forms in the order among which those are sought that move together


@structure
class Step:
    """Variable number ``index`` was replaced by ``terms``; a rate also by its pull times ``reciprocal``."""

    index: int
    terms: Terms
    reciprocal: Node | None = None


class Elimination:
    """Steps from the leaves to the root; ``pivots`` are (pivot, what it is measured by) in the chain's units.

    ``beside`` is what will be computed together with the rates.
    """

    def __init__(self, chain: Chain, beside: Sequence[Node] = ()) -> None:
        self.chain, self.beside = chain, beside
        self.steps: list[Step] = []
        self.pivots: list[tuple[Node, Node]] = []
        self.graph: Graph = chain.graph
        self.rows: list[Terms] = [{} for _ in range(chain.size)]
        self.rods, self.spheres = Rods(chain, self.beside), Spheres(chain)
        self._gone = [False] * chain.size
        for i in (*self.rods.variables, *self.spheres.variables):
            self._gone[i] = True
        self.pivots += [*self.rods.pivots, *self.spheres.pivots]
        for (a, b), weight in chain.weights.items():
            if not self._gone[a] and not self._gone[b]:
                self._add(a, b, weight)
        for a, b, weight in (*self.rods.weights(), *self.spheres.weights()):
            self._add(a, b, weight)
        self._waits = [0] * chain.size
        for k, terms in enumerate(chain.definitions):
            for c in terms if not self._gone[chain.rates + k] else ():
                self._waits[c] += 1
        self._holders: list[list[int]] = [[] for _ in range(chain.rates)]
        for k, terms in enumerate(chain.definitions):
            for c in terms:
                if c < chain.rates:
                    self._holders[c].append(chain.rates + k)
        self._measures: dict[int, Node] = {}
        self._eliminate(self._gone.copy())

    # --- from the leaves to the root ----------------------------------------------------------------------------

    def _eliminate(self, gone: list[bool]) -> None:
        chain = self.chain
        self._ready = [i for i in range(chain.rates) if not gone[i] and not self._waits[i]]
        self._take_rates()
        order = choose_order(chain.rates, chain.definitions)
        for place, j in enumerate(order):
            if gone[j]:
                continue
            group = self._group(order[place : place + _NEAR], gone)
            self._replace(group)
            for k in group:
                gone[k] = True
            self._take_rates()

    def _group(self, near: Sequence[int], gone: Sequence[bool]) -> list[int]:
        """The first of these forms and those that are ready too and hold what it holds with a moving coefficient."""
        chain, g = self.chain, self.graph
        j, *others = near
        shared = {c for c, a in chain.definitions[j - chain.rates].items() if g.value(a) is None}
        found = [j]
        for k in others:
            if gone[k] or self._waits[k]:
                continue
            if any(g.value(a) is None and c in shared for c, a in chain.definitions[k - chain.rates].items()):
                found.append(k)
        return found

    def _take_rates(self) -> None:
        while self._ready:
            first = min(self._ready, key=lambda i: (len(self.rows[i]), -i))
            self._ready.remove(first)
            self._pivot(first)

    def _add(self, a: int, b: int, value: Node) -> None:
        if value != self.graph.zero:
            total = self.graph.add(self.rows[a].get(b, self.graph.zero), value)
            self.rows[a][b] = self.rows[b][a] = total

    def _replace(self, group: Sequence[int]) -> None:
        """Forms that move together become what they are made of."""
        g, chain, rows = self.graph, self.chain, self.rows
        terms = {j: chain.definitions[j - chain.rates] for j in group}
        inner: dict[int, Terms] = {j: {} for j in group}  # H times the coefficients
        for j in group:
            for k in group:
                h = rows[j].get(k, g.zero)
                for c, a in terms[k].items() if h != g.zero else ():
                    inner[j][c] = g.add(inner[j].get(c, g.zero), g.mul(h, a))
        masses = {j: rows[j].get(j, g.zero) for j in group}
        outside = [(o, j, h) for j in group for o, h in rows[j].items() if o not in terms]
        for j in group:
            for o in list(rows[j]):
                rows[o].pop(j, None)
            rows[j] = {}
        for o, j, h in outside:
            for c, a in terms[j].items():
                self._add(o, c, g.mul(g.number(2 if o == c else 1), g.mul(h, a)))
        self._add_congruence(terms, inner)
        for j in group:
            self.steps.append(Step(j, terms[j]))
            for c, a in terms[j].items():
                self._waits[c] -= 1
                if c < chain.rates:
                    grown = g.mul(g.power(a, 2), masses[j])
                    self._measures[c] = g.add(self._measures.get(c, g.zero), grown)
                    if not self._waits[c]:
                        self._ready.append(c)

    def _add_congruence(self, terms: dict[int, Terms], inner: dict[int, Terms]) -> None:
        g = self.graph
        variables = list(dict.fromkeys(c for row in terms.values() for c in row))
        moving = {c: sum(g.value(row[c]) is None for row in terms.values() if c in row) for c in variables}
        variables.sort(key=lambda c: moving[c])
        for x, c in enumerate(variables):
            for d in variables[x:]:
                parts = [g.mul(row[c], inner[j][d]) for j, row in terms.items() if c in row and d in inner[j]]
                together = moving[c] and moving[d]
                self._add(c, d, sum_products(g, parts, self.chain.parameters) if together else g.sum(parts))

    def _pivot(self, i: int) -> None:
        g, row = self.graph, self.rows[i]
        pivot = row.pop(i, g.zero)
        reciprocal = g.inverse(pivot)
        self.pivots.append((pivot, self._measure(i)))
        others = [c for c in row if row[c] != g.zero]
        shares = {c: g.mul(row[c], reciprocal) for c in others}
        for x, c in enumerate(others):
            for d in others[x:]:
                self._add(c, d, g.neg(g.mul(shares[c], row[d])))
        for c in row:
            self.rows[c].pop(i, None)
        self.steps.append(Step(i, shares, reciprocal))

    def _measure(self, i: int) -> Node:
        """What a pivot is held against: the inertia of what the rate moves by itself where it is constant, else also of what
        hangs on that.
        """
        g, weights = self.graph, self.chain.weights
        terms = [weights.get((i, i), g.zero)]
        for j in self._holders[i]:
            a = self.chain.definitions[j - self.chain.rates][i]
            terms.append(g.mul(g.power(a, 2), weights.get((j, j), g.zero)))
        own = sum_products(g, [term for term in terms if term != g.zero], self.chain.parameters)
        if own != g.zero and not g.deps[own] & ~self.chain.parameters:
            return own
        return g.add(terms[0], self._measures.get(i, g.zero))

    # --- right sides ----------------------------------------------------------------------------------------------

    @cached_property
    def rates(self) -> list[Node]:
        """The rates w' that the chain's own forces make."""
        chain, gone = self.chain, self._gone
        drift = self._carry([self.graph.zero] * chain.rates)
        kept = {(a, b): weight for (a, b), weight in chain.weights.items() if not (gone[a] or gone[b])}
        return self._solve(self._pull(kept, drift), drift, moving=True)

    def solve(self, right: Sequence[Node]) -> list[Node]:
        """x with M x = right, M the mass matrix of the rates."""
        g, chain, right = self.graph, self.chain, list(right)
        for turned in chain.turned:
            turned.from_space(g, right)
        pull = [g.div(f, g.mul(s, chain.unit)) for f, s in zip(right, chain.scale, strict=True)]
        still = [g.zero] * chain.size
        return self._solve([*pull, *still[chain.rates :]], still, moving=False)

    def residual(self, rates: Sequence[Node]) -> list[Node]:
        """force - M rates, row by row: accelerations out to the leaves and forces back, without M (J. Y. S. Luh, M. W. Walker
        and R. P. C. Paul, J. Dyn. Syst. Meas. Control 102 (1980) 69).
        """
        g, chain, rates = self.graph, self.chain, list(rates)
        for turned in chain.turned:
            turned.from_space(g, rates)
        pull = self._pull(chain.weights, self._carry([g.mul(s, x) for s, x in zip(chain.scale, rates, strict=True)]))
        for k, terms in reversed(list(enumerate(chain.definitions))):
            for c, a in terms.items():
                pull[c] = g.add(pull[c], g.mul(a, pull[chain.rates + k]))
        left = [g.mul(force, g.mul(s, chain.unit)) for force, s in zip(pull, chain.scale, strict=False)]
        return self._to_space(left)

    def _carry(self, rates: Sequence[Node]) -> list[Node]:
        """The accelerations of all variables, those of the forms from the rates that they are made of."""
        g, chain, found = self.graph, self.chain, list(rates)
        for terms, turn, offset in zip(chain.definitions, chain.turn, chain.offset, strict=True):
            carried = g.sum([g.mul(a, found[c]) for c, a in terms.items()])
            found.append(g.add(g.add(carried, offset), turn))
        return found

    def _pull(self, weights: Weights, accelerations: Sequence[Node]) -> list[Node]:
        """The forces without what these weights take at the accelerations, variable by variable."""
        g, pull = self.graph, list(self.chain.force)
        for (a, b), weight in weights.items():
            pull[a] = g.sub(pull[a], g.mul(weight, accelerations[b]))
            if a != b:
                pull[b] = g.sub(pull[b], g.mul(weight, accelerations[a]))
        return pull

    def _solve(self, pull: list[Node], drift: list[Node], *, moving: bool) -> list[Node]:
        g, chain = self.graph, self.chain
        pushed = self.rods.push(pull, drift, moving=moving)
        loads = self.spheres.push(pull, drift, moving=moving)
        for step in self.steps:
            force = pull[step.index]
            for c, a in step.terms.items():
                given = g.mul(a, force)
                pull[c] = g.add(pull[c], given) if step.reciprocal is None else g.sub(pull[c], given)
        found = [g.zero] * chain.size
        for step in reversed(self.steps):
            parts = g.sum([g.mul(a, found[c]) for c, a in step.terms.items()])
            if step.reciprocal is not None:
                parts = g.sub(g.mul(pull[step.index], step.reciprocal), parts)
            found[step.index] = parts
        self.rods.answer(found, pull, drift, pushed, moving=moving)
        self.spheres.answer(found, pull, drift, loads, moving=moving)
        return self._to_space([g.div(found[i], s) for i, s in enumerate(chain.scale)])

    def _to_space(self, values: list[Node]) -> list[Node]:
        for turned in self.chain.turned:
            turned.to_space(self.graph, values)
        return values
