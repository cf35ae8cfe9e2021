"""A spec taken apart into trees and written as text again, so that a change of it runs through the whole compiler."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from nhc.diagnostics import Bag, Source, Span
from nhc.language import Differential, Name, Number, Prime, Spec, Syntax, decode, fold_tree, walk
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Binary, Call, Negate, rebuild
from nhc.language.expressions.unparse import unparse


@dataclass(frozen=True)
class Row:
    """``left = right``, a constraint or (``form`` is "position") a holonomic one."""

    name: str
    left: Syntax
    right: Syntax
    form: str


@dataclass(frozen=True)
class Draft:
    """The mechanics of a spec: no units, no scenes, no texts."""

    system: str
    coordinates: tuple[str, ...]
    parameters: tuple[tuple[str, str], ...]
    define: tuple[tuple[str, Syntax], ...]
    kinetic: Syntax
    potential: Syntax | None
    potential_kind: str
    forces: tuple[tuple[str, Syntax], ...]
    rows: tuple[Row, ...]
    held: tuple[Row, ...]
    quasi: tuple[tuple[str, Syntax], ...]
    dependent: tuple[str, ...]

    @property
    def names(self) -> set[str]:
        pairs = (*self.parameters, *self.define, *self.quasi)
        return {*self.coordinates, *(name for name, _ in pairs)}


def take_apart(source: Source) -> Draft:
    """The draft of a valid spec; a parameter without value takes the first scene's."""
    spec = decode(source)
    return Draft(
        system=spec.system,
        coordinates=tuple(c.name for c in spec.coordinates),
        parameters=tuple((p.name, _value_of(spec, k)) for k, p in enumerate(spec.parameters)),
        define=tuple((d.name, d.value) for d in spec.definitions),
        kinetic=spec.kinetic,
        potential=spec.potential,
        potential_kind=spec.potential_kind,
        forces=tuple((f.name, f.value) for f in spec.forces),
        rows=tuple(Row(c.name, c.left, c.right, c.form) for c in spec.constraints),
        held=tuple(Row(h.name, h.left, h.right, "position") for h in spec.holonomic),
        quasi=tuple((d.name, d.value) for d in spec.quasi_velocities),
        dependent=spec.dependent,
    )


def _value_of(spec: Spec, index: int) -> str:
    parameter = spec.parameters[index]
    value = parameter.value
    if value is None:
        value = next((o.value for s in spec.scenes for o in s.parameters if o.name == parameter.name), Fraction(1))
    return unparse(Number(value, parameter.span) if isinstance(value, Fraction) else value)


def write(draft: Draft) -> str:
    """The spec's text."""
    lines = ["nhc: 1", f"system: {draft.system}", f"coordinates: [{', '.join(draft.coordinates)}]"]

    def section(key: str, entries: tuple[tuple[str, str], ...]) -> None:
        if entries:
            lines.extend([f"{key}:", *(f'  {name}: "{text}"' for name, text in entries)])

    def rows(key: str, entries: tuple[Row, ...]) -> None:
        if entries:
            lines.append(f"{key}:")
            lines.extend(f'  - {r.name}: "{unparse(r.left)} = {unparse(r.right)}"' for r in entries)

    section("parameters", draft.parameters)
    section("define", tuple((name, unparse(tree)) for name, tree in draft.define))
    lines.append(f'T: "{unparse(draft.kinetic)}"')
    if draft.potential is not None:
        lines.append(f'{draft.potential_kind}: "{unparse(draft.potential)}"')
    section("forces", tuple((name, unparse(tree)) for name, tree in draft.forces))
    rows("constraints", draft.rows)
    rows("holonomic", draft.held)
    section("quasi_velocities", tuple((name, unparse(tree)) for name, tree in draft.quasi))
    if draft.dependent:
        lines.append(f"dependent: [{', '.join(draft.dependent)}]")
    return "\n".join(lines) + "\n"


def tree_of(text: str) -> Syntax:
    """The tree of an expression whose names are folded and known."""
    tree = parse_expression(text, Span, Bag(Source("text", text)))
    assert tree is not None, text
    return tree


def change_trees(draft: Draft, change: Callable[[Syntax], Syntax]) -> Draft:
    """The draft with every tree changed."""

    def pairs(entries: tuple[tuple[str, Syntax], ...]) -> tuple[tuple[str, Syntax], ...]:
        return tuple((name, change(tree)) for name, tree in entries)

    def rows(entries: tuple[Row, ...]) -> tuple[Row, ...]:
        return tuple(replace(r, left=change(r.left), right=change(r.right)) for r in entries)

    return replace(
        draft,
        define=pairs(draft.define),
        kinetic=change(draft.kinetic),
        potential=None if draft.potential is None else change(draft.potential),
        forces=pairs(draft.forces),
        rows=rows(draft.rows),
        held=rows(draft.held),
        quasi=pairs(draft.quasi),
    )


def replace_leaves(
    tree: Syntax,
    names: Mapping[str, Syntax],
    differentials: Mapping[str, Syntax] | None = None,
    prime: Callable[[Prime], Syntax] = lambda node: node,
) -> Syntax:
    """Put trees for names and for differentials, and what ``prime`` gives for each time derivative."""

    def visit(node: Syntax, parts: tuple[Syntax, ...]) -> Syntax:
        if isinstance(node, Name):
            return names.get(node.name, node)
        if isinstance(node, Differential):
            return (differentials or {}).get(node.name, node)
        made = rebuild(node, parts)
        return prime(made) if isinstance(made, Prime) else made

    return fold_tree(tree, visit)


def inline(draft: Draft) -> Draft:
    """Every definition (and quasi-velocity used by another) written out where it stands."""
    known: dict[str, Syntax] = {}
    pending = dict(draft.define) | dict(draft.quasi)
    while pending:
        for name, tree in list(pending.items()):
            if not any(isinstance(node, Name) and node.name in pending for node in walk(tree)):
                known[name] = replace_leaves(tree, known)
                del pending[name]
    return replace(change_trees(draft, lambda tree: replace_leaves(tree, known)), define=())


def value(tree: Syntax, values: Mapping[str, float]) -> float:
    """A tree without derivatives in floats: a second evaluator, which shares nothing with nhc's."""
    operators: dict[str, Callable[[float, float], float]] = {
        "+": lambda a, b: a + b,
        "-": lambda a, b: a - b,
        "*": lambda a, b: a * b,
        "/": lambda a, b: a / b,
        "^": lambda a, b: a**b,
    }

    def visit(node: Syntax, parts: tuple[float, ...]) -> float:
        match node:
            case Number():
                return float(node.value)
            case Name():
                return math.pi if node.name == "pi" else values[node.name]
            case Negate():
                return -parts[0]
            case Binary():
                return operators[node.op](*parts)
            case Call():
                return float(getattr(math, node.function)(*parts))
            case _:
                raise AssertionError(node)

    return fold_tree(tree, visit)
