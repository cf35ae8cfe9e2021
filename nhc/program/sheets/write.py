"""Draft sheets -> sheets: nodes become expressions, and long or repeated ones abbreviations.

The style of paper: sines and cosines are written out, integer powers stay powers, and an abbreviation is made only for what the
user named under ``define:``, for what is long and used more than once, and for what would be too long to read.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from nhc.algebra.graph import ADD, NEG, SYM, Node
from nhc.algebra.reading import Reading
from nhc.algebra.walks import reachable
from nhc.program.ir import Binary, Expr, Negate, Power, Ref
from nhc.program.lowering.lower import Lowering
from nhc.program.lowering.naming import identifier
from nhc.program.plan import FunctionPlan, Target
from nhc.program.sheets.draft import Desk, Draft, DraftSheet, Part
from nhc.program.sheets.model import RANK_STEP, Item, Mark, Sheet, Statement, Symbol, Term
from nhc.program.sheets.tidy import choose_names, find_owners, list_roots, tidy

_LETTERS = ("z", "k", "h", "s", "u", "zeta", "chi", "xi", "Z")
_RANKS = {
    "parameter": 1,
    "time": 2,
    "coordinate": 3,
    "entry": 3,
    "velocity": 5,
    "quasi": 5,
    "rate": 6,
    "acceleration": 6,
}
_CONSTANT_RANK, _LET_RANK, _OTHER_RANK = 2, 4, 7


class PaperLowering(Lowering):
    """One lowering for all sheets, so that an abbreviation means the same everywhere."""

    def __init__(self, desk: Desk, roots: Sequence[Node]) -> None:
        self.owners = find_owners(desk)
        self.bases = _find_bases(desk, roots, self.owners)
        roots = [*roots, *self.bases.values()]
        targets = tuple(Target(k, root) for k, root in enumerate(roots))
        plan = FunctionPlan("derivation", "", "", (), None, {}, targets)
        super().__init__(desk.graph, plan, desk.system.p)
        self.desk = desk
        self.symbols: dict[str, Symbol] = {}
        self.chosen = choose_names(desk.graph, self.needed, self.owners)
        self.chosen |= {node: self.chosen.get(node, 1) for node in self.bases.values() if desk.graph.children(node)}
        self.letter = self._free_letter()
        system = desk.system
        quasi = desk.formulation.frame.omega if desk.formulation.frame is not None else ()
        groups = (system.p, system.q, quasi, system.v)
        self.positions = {node: k for group in groups for k, node in enumerate(group)}
        self.reading = Reading(desk.graph, [*system.q, *quasi, *system.v])
        self._name_symbols()

    def _free_letter(self) -> str:
        return next((letter for letter in _LETTERS if self.desk.is_free(letter)), "zz")

    def _name_symbols(self) -> None:
        for node in self.needed:
            if self.graph.op[node] == SYM:
                symbol = self.graph.symbol_of(node)
                assert symbol is not None
                name = self.names[node] = self.namer.symbol(node)
                rank = _RANKS.get(symbol.kind, _OTHER_RANK) * RANK_STEP + self.positions.get(node, 0)
                self.symbols[name] = Symbol(self.desk.mark(node), rank)

    # --- abbreviations ----------------------------------------------------------------------------------------

    def lets_below(self, roots: Iterable[Node]) -> list[tuple[str, Statement]]:
        """The abbreviations that the roots need and that have not been made yet, in order."""
        inner = [child for root in roots for child in self.graph.children(self._body(root))]
        inner += [self.bases[node] for node in reachable(self.graph, inner) if node in self.bases]
        found = []
        for node in reachable(self.graph, inner):
            if node not in self.chosen or node in self.names:
                continue
            value = self.expression(node)
            name, mark = self._abbreviate(node)
            statement = Statement((Term(Ref(name), ()),), (Term(value),))
            self.symbols[name] = Symbol(mark, (_CONSTANT_RANK if self._constant(node) else _LET_RANK) * RANK_STEP)
            self.names[node] = name
            found.append((name, statement))
        return found

    def _abbreviate(self, node: Node) -> tuple[str, Mark]:
        label = self.graph.labels.get(node)
        if label is None or node not in self.owners:
            name = self.namer.numbered(self.letter)
            return name, Mark(self.letter, (name[len(self.letter) :],))
        if label.endswith("_dot") and label not in self.desk.defined:
            return self.namer.unique(identifier(label)), Mark(label.removesuffix("_dot"), dots=1)
        return self.namer.unique(identifier(label)), Mark(label)

    def written_out(self, node: Node) -> Expr:
        """The node's own expression, also where it is an abbreviation elsewhere."""
        body = self._body(node)
        name = self.names.pop(body, None) if body in self.chosen else None
        try:
            return self.expression(node)
        finally:
            if name is not None:
                self.names[body] = name

    def _body(self, node: Node) -> Node:
        return self.graph.a[node] if self.graph.op[node] == NEG else node

    def _arrange(self, needed: list[Node]) -> tuple[Sequence[Node], Sequence[tuple[Node, ...]]]:
        return needed, self.graph.kids  # on paper a power is a power

    def expression(self, node: Node) -> Expr:
        inner = self._body(node)
        if self.graph.op[inner] != ADD or node in self.names or inner in self.names:
            return super().expression(node)
        total: Expr | None = None
        for negative, term in self.reading.terms(node, self.names):
            if total is not None:
                total = Binary("-" if negative else "+", total, self.expression(term))
            else:
                total = Negate(self.expression(term)) if negative else self.expression(term)
        assert total is not None
        return total

    def _power(self, base: Node, n: int) -> Expr:
        return super()._power(base, n) if n <= 1 else Power(self.expression(base), n)


def _find_bases(desk: Desk, roots: Sequence[Node], owners: Collection[Node]) -> dict[Node, Node]:
    """For rates of what the user has defined the definition itself: who reads of its rate wants to know whose.

    What a body brings is explained in words.
    """
    labels, own = desk.graph.labels, {}
    for node in owners:
        own[labels[node]] = node
    rates = [node for node in reachable(desk.graph, roots) if node in owners and labels[node] not in desk.named]
    bases = {node: labels[node].removesuffix("_dot") for node in rates}
    return {node: own[name] for node, name in bases.items() if name in own and not desk.system.spec.is_brought(name)}


def _side(lowering: PaperLowering, parts: Sequence[Part]) -> tuple[Term, ...]:
    return tuple(Term(lowering.written_out(node), factors) for node, factors in parts)


def write_sheets(
    desk: Desk, drafts: Sequence[DraftSheet]
) -> tuple[tuple[Sheet, ...], dict[str, Symbol], dict[str, Statement]]:
    """The sheets, the symbols of their expressions, and all abbreviations by name."""
    drafts = tidy(desk, drafts)
    lowering = PaperLowering(desk, list_roots(drafts))
    sheets: list[Sheet] = []
    known: dict[str, Statement] = {}
    for sheet in drafts:
        own = lowering.lets_below(list_roots([sheet]))
        known.update(own)
        items: list[Item] = []
        for item in sheet.items:
            if isinstance(item, Draft):
                left, right = _side(lowering, item.left), _side(lowering, item.right)
                items.append(Statement(left, right, item.relation, item.equation, item.place, item.note, item.label))
            else:
                items.append(item)
        sheets.append(Sheet(sheet.key, sheet.title, tuple(statement for _, statement in own), tuple(items)))
    return tuple(sheets), lowering.symbols, known
