"""Drafts before they are printed: which nodes get a name on paper, and shorter forms of what stands between them.

What a derivation hands over is in canonical form where a coefficient as a whole is short.  A long one has parts that would look
odd in print, such as ``(R c^2 + R s^2)/b``: between the nodes that get a name every part is brought to canonical form by itself.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import rebuild, substitute
from nhc.algebra.rewriting.joined import close_circles, find_whole, join_sums
from nhc.algebra.rewriting.orthonormal import Orthonormal
from nhc.algebra.rewriting.values import find_equal
from nhc.algebra.walks import count, reachable
from nhc.program.sheets.draft import CANONICAL, Desk, Draft, DraftItem, DraftSheet, Part

_REPEATED = 8  # operations from which a repeated expression gets a name
_LONG = 80  # operations, on some five lines, beyond which any expression does
_NAMED, _BROUGHT = 2, 4  # operations from which a name of the user's is kept, and one that a body brings
_PART = 4  # operations from which a part is not looked into
_ROUNDS, _LITTLE = 4, 30  # at most so many, and none after one that gained less than this part
_SHARES = (Fraction(1), Fraction(1, 2))  # of a part's operations, below which its canonical form is taken
_LARGE = 15_000  # printed operations
_GIVEN = ("data",)  # the sheet of what the spec says


def tidy(desk: Desk, drafts: Sequence[DraftSheet]) -> tuple[DraftSheet, ...]:
    """The drafts without sums that vanish, and with shorter parts; no value changes."""
    owners = find_owners(desk)
    best = _by_orthonormal_rows(desk, _drop_zeros(desk, drafts), owners)
    printed = start = _count_printed(desk.graph, best, owners)
    shortener = _Shortener(desk)
    for share in _SHARES if printed <= _LARGE else _SHARES[1:]:  # sharing that is lost costs large ones most, and time
        for _ in range(_ROUNDS):  # what became shorter makes other parts
            changed = _shorten_parts(shortener, best, owners, share)
            now = _count_printed(desk.graph, changed, owners)
            if now >= printed:  # what was shared may be so no longer
                break
            gained, best, printed = printed - now, changed, now
            if gained * _LITTLE < now:
                break
        if printed < start:
            break
    return _name_once(desk.graph, _square_cosines(desk.graph, _join_angles(desk.graph, best, owners), owners), owners)


def list_roots(drafts: Iterable[DraftSheet]) -> list[Node]:
    """The nodes of all statements."""
    items = (item for sheet in drafts for item in sheet.items if isinstance(item, Draft))
    return [node for draft in items for node, _ in (*draft.left, *draft.right)]


# --- which nodes get a name -------------------------------------------------------------------------------------


def find_owners(desk: Desk) -> set[Node]:
    """The node that got each of the user's names first: what follows from it by substitution is no longer it.

    It need not be the first node: what is left of y' + a*c' where y' is zero was there before the sum.  Names that a derivation
    has made for itself say nothing to a reader, and those that bodies bring no more than what is as short: a height that is
    a cos(lean) is no height in a horizontal velocity.
    """
    first: dict[str, Node] = {}
    for node, label in desk.graph.labels.items():
        if label in desk.named or label.removesuffix("_dot") in desk.named:
            first.setdefault(label, node)
    brought = desk.system.spec.is_brought
    return {node for label, node in first.items() if desk.size(node) >= _BROUGHT or not brought(label)}


def choose_names(graph: Graph, needed: Sequence[Node], owners: Collection[Node]) -> dict[Node, int]:
    """What the user named, what is long and used more than once, and what would be too long to read; each with its operations."""
    uses, size = _count_uses(graph, needed), dict[Node, int]()
    chosen: dict[Node, int] = {}
    for node in needed:
        size[node] = sum(size[c] for c in graph.children(node))
        if not graph.children(node) or graph.op[node] == NEG:
            continue
        size[node] += 1
        labelled = node in owners and size[node] >= _NAMED
        if labelled or (uses[node] > 1 and size[node] >= _REPEATED) or size[node] > _LONG:
            chosen[node] = size[node]
            size[node] = 1
    return chosen


def _count_uses(graph: Graph, needed: Sequence[Node]) -> dict[Node, int]:
    """How often each node is an operand; standing alone in a statement does not count."""
    uses: dict[Node, int] = dict.fromkeys(needed, 0)
    for node in reversed(needed):
        weight = uses[node] if graph.op[node] == NEG else 1
        for child in graph.children(node):
            uses[child] += weight
    return uses


# --- shorter statements -----------------------------------------------------------------------------------------


def _drop_zeros(desk: Desk, drafts: Sequence[DraftSheet]) -> tuple[DraftSheet, ...]:
    """Without sums that vanish identically although their nodes do not show it: in print their terms would cancel."""
    g = desk.graph
    roots = list_roots(drafts)
    sums = [node for node in reachable(g, roots) if g.op[node] == ADD]
    vanishing = {node: g.zero for node, zero in zip(sums, are_zero(g, sums), strict=True) if zero}
    if not vanishing:
        return tuple(drafts)
    new = dict(zip(roots, substitute(g, roots, vanishing), strict=True))

    def side(parts: Sequence[Part]) -> tuple[Part, ...]:
        found = tuple((new[node], factors) for node, factors in parts)
        return tuple(part for part in found if part[0] != g.zero) or found[:1]

    return _change_sides(drafts, side)


def _by_orthonormal_rows(desk: Desk, drafts: Sequence[DraftSheet], owners: Collection[Node]) -> tuple[DraftSheet, ...]:
    """With shorter sums where entries of a rotation's matrix are 0, 1 or one entry together, from the inside; what the user named
    stays as it is.
    """
    if not desk.matrices:
        return tuple(drafts)
    g, rule = desk.graph, Orthonormal(desk.graph, desk.matrices)
    roots = list_roots(sheet for sheet in drafts if sheet.key not in _GIVEN)
    needed = reachable(g, roots)
    whole, new = find_whole(g, roots, needed), dict[Node, Node]()
    names = {node: g.symbol(f"named {node}") for node in needed if node in owners and g.children(node)}
    meaning = {symbol: node for node, symbol in names.items()}
    for node in needed:
        made = new[node] = node if node in names else rebuild(g, node, [new[kid] for kid in g.children(node)])
        if node in whole and node not in names and g.op[made] == ADD and g.depends(made, rule.mask):
            closed = substitute(g, [made], names, named=False)[0]
            new[node] = substitute(g, [rule.shorten(closed, desk.size)], meaning, named=False)[0]
    return _put(drafts, new)


def _join_angles(graph: Graph, drafts: Sequence[DraftSheet], owners: Collection[Node]) -> tuple[DraftSheet, ...]:
    """With cos(a - b) where the addition theorem is written out; what the user named stays as it is."""
    roots = list_roots(sheet for sheet in drafts if sheet.key not in _GIVEN)
    new = dict(zip(roots, join_sums(graph, roots, {node: node for node in owners}), strict=True))
    return _put(drafts, new)


def _square_cosines(graph: Graph, drafts: Sequence[DraftSheet], owners: Collection[Node]) -> tuple[DraftSheet, ...]:
    """With cos(x)^2 for 1 - sin(x)^2 and the other way round, for canonical forms know one of the two only; without circles."""
    best = tuple(drafts)
    for _ in range(_ROUNDS):  # a sum inside of one that changes waits for the next
        roots = list_roots(sheet for sheet in best if sheet.key not in _GIVEN)
        needed = reachable(graph, roots)
        whole = find_whole(graph, roots, needed)
        changed = {node: node for node in needed if node in owners and graph.children(node)}
        for node in needed:
            if graph.op[node] == ADD and node in whole and node not in changed:
                made = _with_squares(graph, close_circles(graph, node))
                if made != node:
                    changed[node] = made
        if all(node == made for node, made in changed.items()):
            break
        best = _put(best, dict(zip(roots, substitute(graph, roots, changed), strict=True)))
    return best


def _name_once(graph: Graph, drafts: Sequence[DraftSheet], owners: Collection[Node]) -> tuple[DraftSheet, ...]:
    """With one name for what has one value, however it was made: that of the user, or the first."""
    best = tuple(drafts)
    for _ in range(_ROUNDS):  # what is used more often then may get a name, too
        roots = list_roots(best)
        chosen = choose_names(graph, reachable(graph, roots), owners)
        changed = {node: same for node, same in find_equal(graph, sorted(chosen), owners).items() if node not in owners}
        if not changed:
            break
        kept = substitute(graph, list(changed.values()), changed)  # what stays may contain what goes
        new = substitute(graph, roots, dict(zip(changed, kept, strict=True)))
        best = _put(best, dict(zip(roots, new, strict=True)))
    return best


def _put(drafts: Sequence[DraftSheet], new: Mapping[Node, Node]) -> tuple[DraftSheet, ...]:
    """With other nodes in the place of some."""
    return _change_sides(drafts, lambda parts: tuple((new.get(node, node), factors) for node, factors in parts))


def _with_squares(graph: Graph, total: Node) -> Node:
    """The sum with n - n sin(x)^2 as n cos(x)^2."""
    terms, stack = list[tuple[Fraction, Node]](), [(Fraction(1), total)]
    while stack:
        sign, part = stack.pop()
        if graph.op[part] in (ADD, NEG):
            stack += [(-sign if graph.op[part] == NEG else sign, kid) for kid in graph.children(part)]
            continue
        coefficient, core = graph.split_coefficient(part)
        terms.append((sign * coefficient, core))
    constant = sum((size for size, core in terms if core == graph.one), Fraction(0))
    for k, (size, core) in enumerate(terms):
        base = graph.a[core] if graph.op[core] == POW and graph.b[core] == 2 else graph.one
        if constant and size == -constant and graph.op[base] in ("sin", "cos"):
            other = graph.function("cos" if graph.op[base] == "sin" else "sin", graph.children(base)[0])
            rest = [graph.mul(graph.number(s), c) for j, (s, c) in enumerate(terms) if j != k and c != graph.one]
            return graph.sum([*rest, graph.mul(graph.number(constant), graph.power(other, 2))])
    return total


def _shorten_parts(
    shortener: _Shortener, drafts: Sequence[DraftSheet], owners: Collection[Node], share: Fraction
) -> tuple[DraftSheet, ...]:
    """With canonical forms, where they are shorter, between the nodes that get a name; the user's own stay as they are."""
    g, size = shortener.graph, shortener.desk.size
    roots = list_roots(sheet for sheet in drafts if sheet.key not in _GIVEN)
    needed = reachable(g, roots)
    chosen, ends = choose_names(g, needed, owners), set(roots)
    new: dict[Node, Node] = {}
    kept: set[Node] = set()  # what is still so long that it stays a part by itself
    for node in needed:
        made = new[node] = node if node in owners else _rebuild(g, node, [new[kid] for kid in g.children(node)])
        if node in owners:
            kept.add(made)
        elif node in chosen or node in ends:
            made = new[node] = shortener.shorten(made, kept, share)
            kept.update(part for part in _list_kept(g, made) if size(part) >= _PART)
    return _put(drafts, new)


def _count_printed(graph: Graph, drafts: Iterable[DraftSheet], owners: Collection[Node]) -> int:
    """Operations that stand on paper, in statements and abbreviations."""
    roots = list_roots(drafts)
    needed = reachable(graph, roots)
    chosen = choose_names(graph, needed, owners)
    own: dict[Node, int] = {}
    for node in needed:
        kids = graph.children(node)
        own[node] = sum(1 if kid in chosen else own[kid] for kid in kids) + (bool(kids) and graph.op[node] != NEG)
    return sum(chosen.values()) + sum(own[root] for root in roots)


def _rebuild(graph: Graph, node: Node, children: Sequence[Node]) -> Node:
    """The node on other children; factors that stand above and below a fraction line are gone."""
    made = node if children == list(graph.children(node)) else rebuild(graph, node, children)
    if graph.op[made] != MUL:
        return made
    negative, stack = False, [made]
    powers: dict[Node, int] = {}
    above, below = set[Node](), set[Node]()
    while stack:
        part = stack.pop()
        if graph.op[part] in (MUL, NEG):
            stack += graph.children(part)
            negative ^= graph.op[part] == NEG
            continue
        base, exponent = (graph.a[part], graph.b[part]) if graph.op[part] == POW else (part, 1)
        (above if exponent > 0 else below).add(base)
        powers[base] = powers.get(base, 0) + exponent
    if not above & below:
        return made
    made = graph.product(graph.power(base, exponent) for base, exponent in powers.items())
    return graph.neg(made) if negative else made


def _list_kept(graph: Graph, node: Node) -> list[Node]:
    """What of a node stays a part by itself: all but its sign and number, or the sums in a quotient, whose factors may cancel."""
    sums, stack = list[Node](), [node]
    divided = False
    while stack:
        part = stack.pop()
        if graph.op[part] == ADD:
            sums.append(part)
        elif graph.op[part] in (MUL, NEG, POW):
            divided = divided or (graph.op[part] == POW and graph.b[part] < 0)
            stack += graph.children(part)
    return sums if divided else [graph.core[node]]


class _Shortener:
    """Canonical forms over parts; the same question is answered once."""

    def __init__(self, desk: Desk) -> None:
        self.desk, self.graph = desk, desk.graph
        self._known: dict[tuple[Node, frozenset[Node]], tuple[Node, Fraction]] = {}

    def shorten(self, node: Node, kept: Collection[Node], share: Fraction) -> Node:
        """The node over the parts below it that are kept, in canonical form if that has less than this share of its operations."""
        parts, repeats = self._look(node, kept)
        if not repeats:
            return node
        key = node, frozenset(parts)
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = self._try(node, parts)
        return found[0] if found[1] < share else node

    def _look(self, node: Node, kept: Collection[Node]) -> tuple[set[Node], bool]:
        """The kept parts below a node; whether something stands there twice, or two numbers do, or the square of a sine.

        Nothing else has a shorter form.
        """
        op, parts, seen, numbers, repeats = self.graph.op, set[Node](), set[Node](), 0, False
        stack = list(self.graph.children(node))
        while stack:
            part = stack.pop()
            kind = op[part]
            if part in kept:
                parts.add(part)
            elif kind == NUM:
                numbers += 1
                continue
            elif kind in (ADD, MUL, NEG):
                stack += self.graph.children(part)
                continue
            elif kind == POW:
                repeats = repeats or (self.graph.b[part] > 1 and op[self.graph.a[part]] in ("sin", "cos"))
                stack.append(self.graph.a[part])
                continue
            else:
                stack += self.graph.children(part)  # for the parts in arguments
            repeats = repeats or part in seen
            seen.add(part)
        return parts, repeats or numbers > 1

    def _try(self, node: Node, parts: Collection[Node]) -> tuple[Node, Fraction]:
        """The canonical form, and the share of the operations that it has; 1 where it is not taken."""
        g, size = self.graph, self.desk.size
        places = {part: g.symbol(f"part {k}") for k, part in enumerate(sorted(parts))}
        tree = rebuild(g, node, substitute(g, g.children(node), places))  # the node may itself be a kept part
        candidate = normalise(g, tree, CANONICAL)
        if size(candidate) >= size(tree) or count(g, [candidate]) > count(g, [tree]):
            return node, Fraction(1)
        made = substitute(g, [candidate], {symbol: part for part, symbol in places.items()})[0]
        return made, Fraction(size(candidate), size(tree))


def _change_sides(
    drafts: Sequence[DraftSheet], side: Callable[[Sequence[Part]], tuple[Part, ...]]
) -> tuple[DraftSheet, ...]:
    def item(old: DraftItem) -> DraftItem:
        return replace(old, left=side(old.left), right=side(old.right)) if isinstance(old, Draft) else old

    return tuple(replace(sheet, items=[item(old) for old in sheet.items]) for sheet in drafts)
