"""Facts about straight-line code that every back end needs: what is used, what depends on parameters alone."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.program.contents import list_expressions, list_operands, walk
from nhc.program.ir import (
    Binary,
    Expr,
    Function,
    Guard,
    Let,
    Load,
    Number,
    Program,
    Ref,
    Section,
    Solve,
    Statement,
    Store,
    Sweep,
)
from nhc.records import record

ZERO = Number(Fraction(0))
_MANY = 1 << 14
_BOUND = (Load, Let)
# by identity, for comparing what statements say takes longer than looking through them; an entry keeps its statement alive
_REFS: dict[int, tuple[Statement, frozenset[str]]] = {}


def iterate_refs(expression: Expr) -> list[str]:
    """The names that an expression uses, with repetitions."""
    found: list[str] = []
    stack: list[Expr] = [expression]
    while stack:
        node = stack.pop()
        while type(node) is Binary:
            stack.append(node.right)
            node = node.left
        if type(node) is Ref:
            found.append(node.name)
        else:
            stack += list_operands(node)
    return found


def collect_refs(statement: Statement) -> frozenset[str]:
    """The names that a statement uses; asked several times for each statement, found once."""
    known = _REFS.get(id(statement))
    if known is None:
        if len(_REFS) >= _MANY:
            _REFS.clear()
        names = frozenset([name for expression in list_expressions(statement) for name in iterate_refs(expression)])
        known = _REFS[id(statement)] = statement, names
    return known[1]


def list_used_names(body: tuple[Statement, ...]) -> set[str]:
    """The names that reach a guard, a solve, a store or a result."""
    used: set[str] = set()
    for statement in reversed(body):
        if not isinstance(statement, Let) or statement.name in used:
            used |= collect_refs(statement)
    return used


def drop_unused(body: tuple[Statement, ...]) -> tuple[Statement, ...]:
    """The body without loads and lets that nothing uses: compilers and linters complain of them."""
    used = list_used_names(body)
    return drop_empty([s for s in body if not isinstance(s, _BOUND) or s.name in used])


def drop_empty(body: Sequence[Statement]) -> tuple[Statement, ...]:
    """The body without sections in which nothing is done."""
    ends = (*body[1:], Section("")) if body else ()
    return tuple(
        s for s, after in zip(body, ends, strict=True) if not (isinstance(s, Section) and isinstance(after, Section))
    )


def drop_unread(body: tuple[Statement, ...]) -> tuple[Statement, ...]:
    """The body without loads that none of its own statements uses; a sweep has loads of its own."""
    used = {name for statement in body for name in collect_refs(statement)}
    return tuple(s for s in body if not isinstance(s, Load) or s.name in used)


def place_guards(body: tuple[Statement, ...]) -> tuple[Statement, ...]:
    """Each guard once, as soon as its value is known: where a quotient by zero raises, what was singular has been said before.

    One that divides stands behind those before it: a mass may be divided by a determinant of the coframe.
    """
    waiting = [(guard, collect_refs(guard)) for guard in dict.fromkeys(s for s in body if isinstance(s, Guard))]
    known: set[str] = set()
    ordered: list[Statement] = []
    for statement in body:
        if isinstance(statement, Guard):
            continue
        ordered.append(statement)
        if isinstance(statement, _BOUND):
            known.add(statement.name)
        elif isinstance(statement, Solve):
            known.update(name for names in statement.names for name in names)
        held = [refs <= known for _, refs in waiting]
        ready = [pair for k, pair in enumerate(waiting) if held[k] and (all(held[:k]) or not _divides(pair[0]))]
        ordered += [guard for guard, _ in ready]
        waiting = [pair for pair in waiting if pair not in ready]
    return (*ordered, *(guard for guard, _ in waiting))


def _divides(guard: Guard) -> bool:
    return any(isinstance(part, Binary) and part.op == "/" for part in walk(guard.value))


def split_hoisted(body: tuple[Statement, ...]) -> tuple[tuple[Statement, ...], tuple[Statement, ...]]:
    """Statements that depend on the parameters alone (they may leave a loop over states), and the rest."""
    outside: list[Statement] = []
    inside: list[Statement] = []
    fixed: set[str] = set()
    for statement in body:
        if isinstance(statement, Load) and statement.array == "p":
            fixed.add(statement.name)
            outside.append(statement)
        elif isinstance(statement, Let | Guard) and collect_refs(statement) <= fixed:
            if isinstance(statement, Let):
                fixed.add(statement.name)
            outside.append(statement)
        elif not isinstance(statement, Section):
            inside.append(statement)
    return tuple(outside), tuple(inside)


def fill_stores(function: Function) -> tuple[Store, ...]:
    """The stores of a function, one per entry of the output and in its order; an entry that is never stored is zero."""
    output = function.output
    if output is None:
        return ()
    stored = {s.index: s for s in function.body if isinstance(s, Store)}
    return tuple(stored.get(index, Store(output.name, index, ZERO)) for index in range(output.size))


def list_missing(function: Function) -> tuple[Store, ...]:
    """Stores of zero for the entries of the output that the body leaves out."""
    written = list_written(function)
    return tuple(store for store in fill_stores(function) if store.index not in written)


def list_written(function: Function) -> set[int]:
    """The entries of the output that the body stores, in its sweeps too."""
    written: set[int] = set()
    for statement in function.body:
        if isinstance(statement, Store):
            written.add(statement.index)
        elif isinstance(statement, Sweep):
            stores = [inner.index for inner in statement.body if isinstance(inner, Store)]
            written.update(offset + index for offset in statement.offsets for index in stores)
    return written


@record
class Status:
    """A nonzero return code and its meaning."""

    code: int
    what: str


def list_statuses(program: Program) -> tuple[Status, ...]:
    """The singular blocks of all functions by code; whatever is selected, a code keeps its meaning."""
    meanings: dict[int, str] = {}
    for function in program.functions:
        for statement in (*function.body, *(function.otherwise.body if function.otherwise else ())):
            if isinstance(statement, Guard | Solve):
                meanings.setdefault(statement.status, statement.what)
    return tuple(Status(code, meanings[code]) for code in sorted(meanings))


def find_not_finite(program: Program) -> int:
    """The status for a result that is not finite: one more than the largest status of a singular block."""
    return max((status.code for status in list_statuses(program)), default=0) + 1
