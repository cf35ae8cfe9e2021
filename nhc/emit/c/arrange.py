"""The order of statements that compilers make the best of: sines and cosines first, refusals last.

A call destroys all floating-point registers, so that what lives across it goes to memory and back; a branch ends the stretch in
which a compiler can move work.  No value changes: a guard only says whether the output counts.
"""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.statements import collect_refs, drop_empty, split_hoisted
from nhc.program.ir import Call, Evaluate, Expr, Guard, Let, Load, Result, Section, Solve, Statement, Sweep

TURNED = ("sin", "cos")


def arrange(body: tuple[Statement, ...]) -> tuple[Statement, ...]:
    """The same statements in another order; a body with a dense solve stays, for its guards protect the elimination."""
    if any(isinstance(statement, Solve) for statement in body):
        return body
    early = find_early(body)
    wanted = collect_needs(body, early)
    heads = [s for s in body if isinstance(s, Evaluate)]
    first = [s for s in body if isinstance(s, Load | Let) and s.name in wanted]
    loads = [s for s in first if isinstance(s, Load)]
    turns = pair([s for s in first if isinstance(s, Let)], early)
    moved = {id(s) for s in (*heads, *first)}
    rest = [s for s in body if id(s) not in moved]
    last = [s for s in rest if isinstance(s, Guard)] + [s for s in rest if isinstance(s, Result | Sweep)]
    middle = [s for s in rest if not isinstance(s, Guard | Result | Sweep)]
    title = [Section("sines and cosines")] if turns else []
    others = [Section("what else is read")] if turns and middle and isinstance(middle[0], Load) else []
    made = drop_empty((*heads, *loads, *title, *turns, *others, *middle, *last))
    return made if turns else read_late(made)  # behind the sines the others are read late enough


def read_late(body: Iterable[Statement]) -> tuple[Statement, ...]:
    """Each number is read just before what needs it, so that it need not be kept till then."""
    waiting = {s.name: s for s in body if isinstance(s, Load)}
    places = {name: place for place, name in enumerate(waiting)}
    made: list[Statement] = []
    for statement in body:
        if isinstance(statement, Load):
            continue
        for name in sorted(collect_refs(statement) & waiting.keys(), key=places.__getitem__):
            made.append(waiting.pop(name))
        made.append(statement)
    return tuple(made)


def find_early(body: tuple[Statement, ...]) -> list[str]:
    """The names of sines and cosines whose angles need none of them, those of angles that are parameters first."""
    fixed = {s.name for s in split_hoisted(body)[0] if isinstance(s, Let)}
    late = set[str]()
    found = []
    for statement in body:
        if not isinstance(statement, Let):
            continue
        turned = isinstance(statement.value, Call) and statement.value.function in TURNED
        if collect_refs(statement) & late:
            late.add(statement.name)
        elif turned:
            found.append(statement.name)
            late.add(statement.name)
    return sorted(found, key=lambda name: name not in fixed)


def pair(lets: list[Let], turned: list[str]) -> list[Let]:
    """The angles, then sine and cosine of each angle beside each other: compilers compute what they share once."""
    values = {s.name: s for s in lets}
    places: dict[Expr, int] = {}
    for name in turned:
        places.setdefault(angle_of(values[name]), len(places))
    beside = set(turned)
    angles = [s for s in lets if s.name not in beside]
    return angles + sorted((values[name] for name in turned), key=lambda s: places[angle_of(s)])


def angle_of(statement: Let) -> Expr:
    """The angle of a sine or cosine."""
    assert isinstance(statement.value, Call)
    return statement.value.arguments[0]


def collect_needs(body: tuple[Statement, ...], names: Iterable[str]) -> set[str]:
    """The names and all that they are computed from."""
    needed = set(names)
    for statement in reversed(body):
        if isinstance(statement, Let) and statement.name in needed:
            needed |= collect_refs(statement)
    return needed
