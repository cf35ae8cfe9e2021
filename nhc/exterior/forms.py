"""Exterior forms of any degree in a coframe: wedge, d, interior product, pullback.

A form holds coefficients over strictly increasing index tuples.  The interior product is the thesis's left derivative:
the one-form i_X(u ^ w) = u(X) w - w(X) u, so that dOmega/d(dy) of a two-form is i_(d/dy) Omega.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.exterior.coframe import Coframe
from nhc.records import record

Index = tuple[int, ...]


@record
class Form:
    """``terms[I]`` is the coefficient of the wedge of the basis forms I, I strictly increasing; zero terms are absent."""

    coframe: Coframe
    degree: int
    terms: Mapping[Index, Node]

    @property
    def graph(self) -> Graph:
        return self.coframe.graph

    def coefficient(self, *index: int) -> Node:
        """The coefficient for indices in any order (with the sign of the permutation)."""
        ordered, sign = _sort(index)
        if sign == 0:
            return self.graph.zero
        value = self.terms.get(ordered, self.graph.zero)
        return value if sign > 0 else self.graph.neg(value)

    def __add__(self, other: Form) -> Form:
        collected = dict(self.terms)
        for index, value in other.terms.items():
            collected[index] = self.graph.add(collected.get(index, self.graph.zero), value)
        return Form(self.coframe, self.degree, _nonzero(self.graph, collected))

    def __neg__(self) -> Form:
        return Form(self.coframe, self.degree, {i: self.graph.neg(c) for i, c in self.terms.items()})

    def __sub__(self, other: Form) -> Form:
        return self + (-other)

    def scaled(self, factor: Node) -> Form:
        terms = {i: self.graph.mul(factor, c) for i, c in self.terms.items()}
        return Form(self.coframe, self.degree, _nonzero(self.graph, terms))

    def is_zero(self) -> bool:
        """Exactly, by the identity test."""
        return all(are_zero(self.graph, list(self.terms.values())))


def function_form(coframe: Coframe, value: Node) -> Form:
    """A function as a form of degree 0."""
    return Form(coframe, 0, _nonzero(coframe.graph, {(): value}))


def one_form(coframe: Coframe, coefficients: Mapping[int, Node]) -> Form:
    """The sum of coefficients[k] times the basis form k."""
    return Form(coframe, 1, _nonzero(coframe.graph, {(k,): c for k, c in coefficients.items()}))


def basis_form(coframe: Coframe, k: int) -> Form:
    """The k-th form of the coframe itself."""
    return Form(coframe, 1, {(k,): coframe.graph.one})


def wedge(left: Form, right: Form) -> Form:
    """left ^ right."""
    g = left.graph
    collected: dict[Index, Node] = {}
    for i, a in left.terms.items():
        for j, b in right.terms.items():
            index, sign = _sort(i + j)
            if sign == 0:
                continue
            term = g.mul(a, b)
            collected[index] = g.add(collected.get(index, g.zero), term if sign > 0 else g.neg(term))
    return Form(left.coframe, left.degree + right.degree, _nonzero(g, collected))


def d(form: Form) -> Form:
    """The exterior derivative, by Leibniz and the coframe's structure equations."""
    coframe, g = form.coframe, form.graph
    total = Form(coframe, form.degree + 1, {})
    for index, value in form.terms.items():
        monomial = Form(coframe, form.degree, {index: g.one})
        total = total + wedge(one_form(coframe, coframe.differential(value)), monomial)
        for position, k in enumerate(index):
            structure = coframe.structure.get(k)
            if not structure:
                continue
            before = Form(coframe, position, {index[:position]: g.one})
            middle = Form(coframe, 2, {pair: value for pair, value in structure.items()})
            after = Form(coframe, form.degree - position - 1, {index[position + 1 :]: g.one})
            term = wedge(wedge(before, middle), after).scaled(value)
            total = total + (-term if position % 2 else term)
    return total


def interior(vector: Sequence[Node], form: Form) -> Form:
    """i_X form, X given by its components along the dual basis."""
    g = form.graph
    collected: dict[Index, Node] = {}
    for index, value in form.terms.items():
        for position, k in enumerate(index):
            if vector[k] == g.zero:
                continue
            rest = index[:position] + index[position + 1 :]
            term = g.mul(vector[k], value)
            collected[rest] = g.add(collected.get(rest, g.zero), g.neg(term) if position % 2 else term)
    return Form(form.coframe, form.degree - 1, _nonzero(g, collected))


def pullback(form: Form, target: Coframe, images: Sequence[Form], functions: Mapping[Node, Node]) -> Form:
    """The form read in ``target``: each basis form goes to its image, coefficients by substitution of ``functions``."""
    g = target.graph
    values = substitute(g, list(form.terms.values()), functions)
    total = Form(target, form.degree, {})
    for index, value in zip(form.terms, values, strict=True):
        term = function_form(target, value)
        for k in index:
            term = wedge(term, images[k])
        total = total + Form(target, form.degree, term.terms)
    return total


def _sort(index: Sequence[int]) -> tuple[Index, int]:
    """The increasing order and the sign of the permutation; sign 0 for a repeated index."""
    items, sign = list(index), 1
    for i in range(1, len(items)):
        j = i
        while j and items[j - 1] > items[j]:
            items[j - 1], items[j] = items[j], items[j - 1]
            sign = -sign
            j -= 1
        if j and items[j - 1] == items[j]:
            return tuple(items), 0
    return tuple(items), sign


def _nonzero(graph: Graph, terms: Mapping[Index, Node]) -> dict[Index, Node]:
    return {index: value for index, value in terms.items() if value != graph.zero}
