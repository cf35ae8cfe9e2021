"""Shorter forms of the pieces between shared nodes.

What is used twice is computed once and stands for itself; between such nodes an expression is a tree. Where a spec has numbers
in its energy, derivatives, sums over bodies and eliminations leave trees such as ``(2 x a + 6 x b)/2 + x c``. A tree in which
something occurs twice, or two numbers, is brought to canonical form with the shared nodes as unknowns, and the shorter of the
two is taken.
"""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence

from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import rebuild, rebuild_over, substitute
from nhc.algebra.rewriting.digits import keep_digits
from nhc.algebra.walks import count, reachable
from nhc.records import record

_TERMS = 24
"""Terms of a canonical form; longer ones are seldom shorter than the tree."""
_LEAVES = 100
"""Leaves of a tree; beyond them the canonical form is not tried."""
_FEW = 25
"""Nodes for each multiplication by a number, up to which every tree is tried."""
_LARGE, _DENSE, _SPARE = 1000, 40, 8
"""Nodes, altogether and for each sine and cosine, from which smaller trees are tried in an expression without numbers: bodies in
space have that many, and become up to four percent shorter, where plane chains have nothing to win."""
_SMALL, _REPEATED = 80, 2
"""In other expressions without numbers: leaves of a tree, and how many of them repeat others, the squares not counted.  A vector
that is turned and turned back has its sine and cosine twice."""
_OPEN = frozenset({ADD, MUL, NEG, POW})
"""What a canonical form looks into."""


@record
class _Limits:
    """How many leaves a tree may have, how many operations there may be to win (where more could be, the tree is a large one), and
    how many leaves must repeat others.
    """

    leaves: int
    spare: int
    repeated: int


def shorten_pieces(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    """Equal roots with shorter trees between the nodes that are used more than once."""
    if "pieces" in graph.off:
        return list(roots)
    nodes = reachable(graph, roots)
    made = _pass_over(graph, roots, nodes)
    if made == list(roots) or len(nodes) >= _LARGE:
        return made
    # a shorter tree may leave a node that is used only once, so that another tree goes on through it
    return _pass_over(graph, made, reachable(graph, made))


def _pass_over(graph: Graph, roots: Sequence[Node], nodes: Sequence[Node]) -> list[Node]:
    limits = _limit(graph, nodes)
    whole = _list_shared(graph, nodes, roots)
    new: dict[Node, Node] = {}
    for node in nodes:
        made = _shorten(graph, node, whole, new, limits) if node in whole else None
        if made is not None:
            graph.pass_label(node, made)
        else:
            made = rebuild_over(graph, node, new)
        if made is not None:
            new[node] = made
    return [new.get(root, root) for root in roots]


def _limit(graph: Graph, nodes: Sequence[Node]) -> _Limits:
    op, first = graph.op, graph.a
    numbers = sum(op[node] == MUL and op[first[node]] == NUM for node in nodes)
    numbers += sum(op[node] == POW and graph.b[node] > 2 for node in nodes)
    if numbers * _FEW >= len(nodes):
        return _Limits(_LEAVES, _LEAVES, 0)
    if len(nodes) >= max(_LARGE, _DENSE * sum(op[node] in ("sin", "cos") for node in nodes)):
        return _Limits(_LEAVES, _SPARE, 0)
    return _Limits(_SMALL, _LEAVES, _REPEATED)


def _list_shared(graph: Graph, nodes: Sequence[Node], roots: Sequence[Node]) -> set[Node]:
    """Roots, what is used twice, and the operands of whatever is no sum or product."""
    found, used = set(roots), set[Node]()
    op, kids = graph.op, graph.kids
    for node in nodes:
        if op[node] in (ADD, MUL, NEG):
            for child in kids[node]:
                (found if child in used else used).add(child)
        else:
            found.update(kids[node])
    return found


def _shorten(
    graph: Graph, node: Node, whole: Container[Node], new: Mapping[Node, Node], limits: _Limits
) -> Node | None:
    """The shorter form of the tree below a node, over what the tree's leaves have become; None where there is none.

    A tree has one operation less than leaves, and cannot have fewer than one less than different leaves.
    """
    op, kids = graph.op, graph.kids
    if op[node] not in (ADD, MUL) or not any([_is_inner(graph, kid, whole) for kid in kids[node]]):
        return None
    leaves, squares = _list_leaves(graph, node, whole)
    symbolic = [leaf for leaf in leaves if op[leaf] != NUM]
    distinct = dict.fromkeys(symbolic)
    if len(symbolic) == len(distinct) and len(leaves) - len(symbolic) < 2:
        return None
    if len(leaves) > limits.leaves or len(leaves) - len(distinct) > limits.spare:
        return None
    if max(len(symbolic) - squares - len(distinct), len(leaves) - len(symbolic)) < limits.repeated:
        return None
    opaque = [leaf for leaf in distinct if op[leaf] in _OPEN]
    places = {leaf: graph.symbol(f"piece {k}") for k, leaf in enumerate(opaque)}
    tree = _copy(graph, node, whole, places)
    made = normalise(graph, tree, _TERMS)
    if (
        count(graph, [made]) >= count(graph, [tree])
        or keep_digits(graph, [tree], [made]) == [tree]
        or not _is_over(graph, made, {places.get(x, x) for x in distinct})
    ):
        return None
    back = {places.get(leaf, leaf): new.get(leaf, leaf) for leaf in distinct if leaf in places or leaf in new}
    return substitute(graph, [made], back)[0] if back else made


def _is_inner(graph: Graph, node: Node, whole: Container[Node]) -> bool:
    return node not in whole and (graph.op[node] in (ADD, MUL, NEG) or (graph.op[node] == POW and graph.b[node] > 0))


def _list_leaves(graph: Graph, node: Node, whole: Container[Node]) -> tuple[list[Node], int]:
    """The leaves of the tree below a node, each as often as it occurs, in a power twice; how many powers there are."""
    found, powers, stack = list[Node](), 0, list(graph.kids[node])
    while stack:
        top = stack.pop()
        if _is_inner(graph, top, whole):
            stack += graph.kids[top]
            if graph.op[top] == POW:
                found.append(graph.a[top])
                powers += 1
        else:
            found.append(top)
    return found, powers


def _copy(graph: Graph, node: Node, whole: Container[Node], places: Mapping[Node, Node]) -> Node:
    """The tree with symbols in the places of its opaque leaves."""
    kids = [
        _copy(graph, kid, whole, places) if _is_inner(graph, kid, whole) else places.get(kid, kid)
        for kid in graph.kids[node]
    ]
    return rebuild(graph, node, kids)


def _is_over(graph: Graph, node: Node, atoms: Container[Node]) -> bool:
    """Whether an expression calls no function that is not at hand: canonical forms may turn sin^2 into 1 - cos^2."""
    return all(n in atoms for n in reachable(graph, [node]) if graph.kids[n] and graph.op[n] not in _OPEN)
