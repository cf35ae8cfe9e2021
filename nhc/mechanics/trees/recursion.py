"""Velocity forms as a recursion: each form from the forms and rates it is made of.

A chain's velocities stand in the graph as they were written: X_k' = X_{k-1}' + l cos(th_k) th_k'.  What several forms
share is a form of its own here, so that n links are n short definitions and no n^2 coefficients are ever written out.
Forms whose sums were written from the far end, or without anything in common, get the prefixes that their terms share.
"""

from __future__ import annotations

from collections.abc import Container, Sequence

from nhc.algebra.graph import ADD, MUL, NEG, Graph, Node
from nhc.algebra.parts import Factor, split_parameters, tidy
from nhc.algebra.walks import reachable
from nhc.records import fresh, structure

Terms = dict[int, Node]
Term = tuple[int, Node]  # rate and coefficient
Weights = dict[tuple[int, int], Node]
_MANY = 4  # terms of a form for each rate beyond which it is no sum along a chain
_SHORT = 2  # terms of definitions, beyond which the forms are read again from their terms


@structure
class Recursion:
    """Variables 0 .. rates - 1 are the kept velocities; number rates + k is ``definitions[k]`` . variables +
    ``constants[k]``, made of variables before it.  ``forms[k]`` says what the k-th velocity form is of them.
    """

    rates: int
    definitions: list[Terms] = fresh(factory=list)
    constants: list[Node] = fresh(factory=list)
    forms: list[Terms] = fresh(factory=list)

    @property
    def size(self) -> int:
        return self.rates + len(self.definitions)

    def define(self, terms: Terms, constant: Node) -> int:
        self.definitions.append(terms)
        self.constants.append(constant)
        return self.size - 1


def read_recursion(
    graph: Graph, forms: Sequence[Node], w: Sequence[Node], parameters: int, inner: Container[Node]
) -> Recursion | None:
    """The recursion behind nodes that are affine in w; None where one is not built of sums and products alone.

    What is ``inner`` to a body, the rate of an entry of its matrix, is no form of its own, however often it is used.
    """
    found = _as_written(graph, forms, w, parameters, inner)
    if found is not None:
        found = _continue_single_terms(graph, found, parameters)
    if found is None:
        return None
    heads = {next(iter(form)) for form in found.forms if form}
    between = len(found.definitions) > sum(i >= found.rates for i in heads)  # sums that are no forms of T
    if not between and max(map(len, found.definitions), default=0) <= _SHORT:
        return found
    other = _continue_single_terms(graph, _by_terms(graph, found), parameters)
    return min(found, other, key=lambda r: sum(map(len, r.definitions)))


def _as_written(
    graph: Graph, forms: Sequence[Node], w: Sequence[Node], parameters: int, inner: Container[Node]
) -> Recursion | None:
    nodes = reachable(graph, forms, graph.mask(tuple(w)))
    uses, summed = dict.fromkeys(nodes, 0), dict.fromkeys(nodes, 0)
    for node in nodes:
        for child in graph.children(node):
            if child in uses:
                uses[child] += 1
                summed[child] += graph.op[node] == ADD
    for node in forms:
        if node in uses:
            uses[node] += 1
    atoms = set(forms)
    made = Recursion(len(w))
    rates = {symbol: i for i, symbol in enumerate(w)}
    known: dict[Node, tuple[Terms, Node]] = {}
    for node in nodes:
        if node in rates:
            known[node] = {rates[node]: graph.one}, graph.zero
            continue
        parts = _combine(graph, node, known, uses)
        if parts is None:
            return None
        terms, constant = parts
        shared = (summed[node] > 1 or (graph.op[node] == ADD and uses[node] > 1)) and node not in inner
        if (shared or node in atoms) and not _is_plain(graph, terms, constant, parameters):
            known[node] = {made.define(terms, constant): graph.one}, graph.zero
        else:
            known[node] = terms, constant
    for node in dict.fromkeys(forms):
        if node not in uses:  # no rate moves it: constraints prescribe what it is
            known[node] = ({made.define({}, node): graph.one} if node != graph.zero else {}), graph.zero
    made.forms = [known[node][0] for node in forms]
    return made


def _is_plain(graph: Graph, terms: Terms, constant: Node, parameters: int) -> bool:
    """Nothing at all, or one variable times parameters."""
    if constant != graph.zero or len(terms) > 1:
        return False
    return not any(graph.deps[factor] & ~parameters for factor in terms.values())


def _combine(
    graph: Graph, node: Node, known: dict[Node, tuple[Terms, Node]], uses: dict[Node, int]
) -> tuple[Terms, Node] | None:
    """(terms, constant) of a sum, a product with one moving factor, or a negative."""
    op, children = graph.op[node], graph.children(node)
    moving = [c for c in children if c in uses]
    if op == NEG or (op == MUL and len(moving) == 1):
        terms, constant = known[moving[0]]
        if op == NEG:
            return {i: graph.neg(a) for i, a in terms.items()}, graph.neg(constant)
        factor = children[0] if children[1] == moving[0] else children[1]
        return {i: graph.mul(factor, a) for i, a in terms.items()}, graph.mul(factor, constant)
    if op != ADD:
        return None
    first, *others = sorted(moving, key=lambda c: -len(known[c][0]))
    total, constant = known[first]
    if uses[first] > 1:
        total = dict(total)
    for other in others:
        terms, more = known[other]
        constant = graph.add(constant, more)
        for i, a in terms.items():
            total[i] = graph.add(total.get(i, graph.zero), a)
    for still in children:
        if still not in uses:
            constant = graph.add(constant, still)
    return {i: a for i, a in total.items() if a != graph.zero}, constant


def _continue_single_terms(graph: Graph, made: Recursion, parameters: int) -> Recursion:
    """Forms of one rate come first, and where their term begins another form, that form continues them."""
    rates = made.rates
    single = [k for k, terms in enumerate(made.definitions) if len(terms) == 1 and next(iter(terms)) < rates]
    single = [k for k in single if made.constants[k] == graph.zero]
    order = [*single, *(k for k in range(len(made.definitions)) if k not in single)]
    number = {rates + k: rates + place for place, k in enumerate(order)}
    terms = [{number.get(c, c): a for c, a in made.definitions[k].items()} for k in order]
    starts: dict[Term, tuple[int, Factor, bool]] = {}
    for place in range(len(single)):
        ((i, a),) = terms[place].items()
        outer, rest = split_parameters(graph, a, parameters)
        negative = graph.op[rest] == NEG
        starts.setdefault((i, graph.a[rest] if negative else rest), (rates + place, outer, negative))
    for place in range(len(single), len(terms)) if starts else ():
        for i, a in list(terms[place].items()):
            outer, rest = split_parameters(graph, a, parameters)
            negative = graph.op[rest] == NEG
            start = starts.get((i, graph.a[rest] if negative else rest))
            if start is None or start[0] in terms[place] or not outer.divisible_by(start[1]):
                continue
            j, divisor, turned = start
            quotient = tidy(graph, graph.div(outer.node(graph), divisor.node(graph)), parameters)
            del terms[place][i]
            terms[place][j] = graph.neg(quotient) if negative != turned else quotient
    constants = [made.constants[k] for k in order]
    return Recursion(rates, terms, constants, [{number.get(c, c): a for c, a in form.items()} for form in made.forms])


def _by_terms(graph: Graph, wide: Recursion) -> Recursion:
    """The same forms with the prefixes that their terms share: terms that many forms have come first."""
    flat: list[list[Term]] = []
    for terms, constant in zip(wide.definitions, wide.constants, strict=True):
        if sum(1 if i < wide.rates else len(flat[i - wide.rates]) for i in terms) > _MANY * wide.rates:
            return wide  # definitions that hold several others each: written out, they double with every one
        flat.append(_flatten(graph, wide.rates, terms, flat))
        if constant != graph.zero or len(set(flat[-1])) < len(flat[-1]):
            return wide
    heads = [form for form in wide.forms if form and next(iter(form)) >= wide.rates]
    wanted = sorted({next(iter(form)) - wide.rates for form in heads})
    turned = _turn_alike(graph, flat, wanted)
    count: dict[Term, int] = {}
    for k in wanted:
        for term in flat[k]:
            count[term] = count.get(term, 0) + 1
    paths = {k: sorted(flat[k], key=lambda term: (-count[term], term)) for k in wanted}
    made = Recursion(wide.rates)
    numbers = _trie(graph, made, paths)
    made.forms = [
        {numbers.get(i - wide.rates, i): graph.neg(a) if i - wide.rates in turned else a for i, a in form.items()}
        for form in wide.forms
    ]
    return made


def _turn_alike(graph: Graph, flat: list[list[Term]], wanted: Sequence[int]) -> set[int]:
    """Changes the signs of those that have more terms with forms before them in common then, and says which."""
    met, turned = set[Term](), set[int]()
    for k in wanted:
        opposite = [(rate, graph.neg(a)) for rate, a in flat[k]]
        if sum(term in met for term in opposite) > sum(term in met for term in flat[k]):
            flat[k] = opposite
            turned.add(k)
        met.update(flat[k])
    return turned


def _flatten(graph: Graph, rates: int, terms: Terms, before: Sequence[Sequence[Term]]) -> list[Term]:
    found: list[Term] = []
    for i, a in terms.items():
        inner = [(i, graph.one)] if i < rates else before[i - rates]
        found += [(rate, graph.mul(a, b)) for rate, b in inner]
    return found


def _trie(graph: Graph, made: Recursion, paths: dict[int, list[Term]]) -> dict[int, int]:
    """A variable for each end of a path and each place where paths part; path -> variable."""
    children: list[dict[Term, int]] = [{}]
    ends: dict[int, list[int]] = {}
    for k, path in paths.items():
        place = 0
        for term in path:
            if term not in children[place]:
                children[place][term] = len(children)
                children.append({})
            place = children[place][term]
        ends.setdefault(place, []).append(k)
    numbers: dict[int, int] = {}
    stack: list[tuple[int, Terms]] = [(0, {})]
    while stack:
        place, terms = stack.pop()
        if place and (place in ends or (len(children[place]) > 1 and len(terms) > 1)):
            number = made.define(terms, graph.zero)
            numbers.update(dict.fromkeys(ends.get(place, ()), number))
            terms = {number: graph.one}
        for (rate, a), child in reversed(list(children[place].items())):
            longer = dict(terms)
            longer[rate] = graph.add(longer.get(rate, graph.zero), a)
            stack.append((child, longer))
    return numbers
