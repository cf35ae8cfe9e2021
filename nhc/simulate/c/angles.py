"""The angles of a body whose sines and cosines need not wait for one another."""

from __future__ import annotations

from collections.abc import Iterator

from nhc.emit.statements import collect_refs, iterate_refs
from nhc.program.contents import list_expressions, walk
from nhc.program.ir import Binary, Call, Expr, Guard, Let, Load, Negate, Power, Ref, Statement, Store
from nhc.records import record

TURNED = ("sin", "cos")


def name_turned(function: str, index: int) -> str:
    """The name of an angle's sine or cosine; no spec can have it."""
    return f"{function}:{index}"


@record
class Turn:
    """Here the sines and cosines of these angles are computed; ``first`` is the first one's index."""

    angles: tuple[Expr, ...]
    first: int


def gather_angles(body: tuple[Statement, ...]) -> list[Statement | Turn]:
    """The body with its sines and cosines replaced by names, all of those first that need none themselves."""
    turned: set[str] = set()  # names that depend on a sine or cosine
    places: dict[Expr, int] = {}
    for statement in body:
        calls = list(_iterate_turns(statement))
        for call in calls:
            (angle,) = call.arguments
            if turned.isdisjoint(iterate_refs(angle)) and not any(map(_is_turn, walk(angle))):
                places.setdefault(angle, len(places))
        if isinstance(statement, Let) and (calls or collect_refs(statement) & turned):
            turned.add(statement.name)
    wanted = {name for angle in places for name in iterate_refs(angle)}
    for statement in reversed(body):
        if isinstance(statement, Let) and statement.name in wanted:
            wanted |= collect_refs(statement)
    early = [s for s in body if isinstance(s, Load | Let) and s.name in wanted]
    found: list[Statement | Turn] = [*early, Turn(tuple(places), 0)] if places else []
    for statement in body:
        if statement in early:
            continue
        while True:
            late = next((call for call in _iterate_turns(_replace_in(statement, places)) if _is_last(call)), None)
            if late is None:
                break
            (angle,) = late.arguments
            found.append(Turn((angle,), len(places)))
            places[angle] = len(places)
        found.append(_replace_in(statement, places))
    return found


def _is_last(call: Call) -> bool:
    """No sine or cosine is left inside."""
    return not any(_is_turn(part) for argument in call.arguments for part in walk(argument))


def _is_turn(expression: Expr) -> bool:
    return isinstance(expression, Call) and expression.function in TURNED


def _iterate_turns(statement: Statement) -> Iterator[Call]:
    for whole in list_expressions(statement):
        for part in walk(whole):
            if isinstance(part, Call) and _is_turn(part):
                yield part


def _replace_in(statement: Statement, places: dict[Expr, int]) -> Statement:
    match statement:
        case Let():
            return Let(statement.name, _replace(statement.value, places), statement.origin)
        case Store():
            value = _replace(statement.value, places)
            return Store(statement.array, statement.index, value, statement.about, statement.origin)
        case Guard():
            value, scale = _replace(statement.value, places), _replace(statement.scale, places)
            return Guard(value, scale, statement.tolerance, statement.status, statement.what)
        case _:
            return statement


def _replace(expression: Expr, places: dict[Expr, int]) -> Expr:
    match expression:
        case Call():
            arguments = tuple(_replace(a, places) for a in expression.arguments)
            for angle in (expression.arguments[0], arguments[0]):
                if _is_turn(expression) and angle in places:
                    return Ref(name_turned(expression.function, places[angle]))
            return Call(expression.function, arguments)
        case Binary():
            return Binary(expression.op, _replace(expression.left, places), _replace(expression.right, places))
        case Negate():
            return Negate(_replace(expression.operand, places))
        case Power():
            return Power(_replace(expression.base, places), expression.exponent)
        case _:
            return expression
