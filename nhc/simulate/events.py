"""What ends a run early: an expression in the spec's names, of ``--until``."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, Source, Span, SpecError
from nhc.language import Spec
from nhc.language.expressions.names import ENERGIES
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Name, Syntax, fold_tree, rebuild
from nhc.language.scope import Declared, Scope
from nhc.language.spec import Definition
from nhc.mechanics.resolving.expressions import Resolver, define_names
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.simulate.requests import RunError

_EVENT, _OPTION = "until", "--until"


def resolve_event(spec: Spec, text: str) -> tuple[System, Node]:
    """The system, and the value whose zero ends the run.

    Raises:
        nhc.diagnostics.SpecError: the spec or the expression has errors.
        RunError: the expression never changes.
    """
    tree = parse_event(spec, text)
    try:
        system = resolve(replace(spec, outputs=(*spec.outputs, Definition(_EVENT, tree, Span(0, 0)))))
    except SpecError:
        # raises, too, unless the expression is to blame: then it is said with places in its own text
        resolve(spec)
        probe = Resolver(spec)
        define_names(probe)
        probe.bag = Bag(Source(_OPTION, text))
        energies = {name: probe.graph.symbol(name, "energy") for name in ENERGIES}  # they have values, whichever
        probe.node(tree, {**energies, **probe.names})
        probe.bag.raise_if_errors()
        raise
    event = system.outputs[-1][1]
    if not system.graph.deps[event] & ~system.graph.mask(system.p):
        advice = ('name something that moves: `--until "t - 0.5"` stops at the time 0.5',)
        raise RunError(f"`{text}` never crosses zero: it stays what it is during the run", advice)
    return replace(system, outputs=system.outputs[:-1]), event


def parse_event(spec: Spec, text: str) -> Syntax:
    """The tree of an expression in the spec's names, outputs among them, as an output would be read.

    Raises:
        nhc.diagnostics.SpecError: with the places in the text.
    """
    bag = Bag(Source(_OPTION, text))
    tree = parse_expression(text, Span, bag)
    if tree is not None:
        outputs = {output.name: output.value for output in spec.outputs}

        def visit(node: Syntax, parts: tuple[Syntax, ...]) -> Syntax:
            return outputs.get(node.name, node) if isinstance(node, Name) else rebuild(node, parts)

        tree = fold_tree(tree, visit)
        scope = Scope(bag)
        for kind, entries in (
            ("coordinate", spec.coordinates),
            ("parameter", spec.parameters),
            ("define", spec.definitions),
            ("quasi", spec.quasi_velocities),
        ):
            scope.names.update((entry.name, Declared(kind, entry.span)) for entry in entries)
        tree = scope.resolve(tree, "output")
        held: dict[str, bool] = {}
        for name, value in spec.named_values:
            held[name] = scope.holds_velocities(value, held, report=False)
        scope.holds_velocities(tree, held)
    bag.raise_if_errors()
    assert tree is not None
    return tree
