"""A motion named on the command line: a scene, or ``name=value`` pairs, as a scene's start and as nodes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.algebra.dense import Singular
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import depends, solve_rows
from nhc.diagnostics import Bag, Source, Span, quote, suggest
from nhc.language import Definition, Initial, Name, Override, Prime, Scene, Spec, Syntax, walk
from nhc.language.advice import meant_rate
from nhc.language.constants import constant_definitions
from nhc.language.expressions.names import fold_typed
from nhc.language.expressions.parser import parse_expression
from nhc.language.orientation import with_unit_quaternions
from nhc.mechanics.flow import Flow
from nhc.mechanics.frame import Frame, kept_forms
from nhc.mechanics.linearize import quantity
from nhc.mechanics.resolving.expressions import Resolver
from nhc.mechanics.starts.scenes import Start, kept_velocities, report_scene
from nhc.records import record


@record
class Pair:
    """``name = value``; the value holds numbers, pi, parameters and definitions of these."""

    name: str
    value: Syntax
    span: Span


def read_pairs(text: str, option: str) -> tuple[Source, tuple[Pair, ...]]:
    """The pairs (name, expression) of an option such as ``a=1, b'=-v/2``; commas inside parentheses do not separate pairs.

    Raises:
        nhc.diagnostics.SpecError: with places in the option's text.
    """
    source = Source(option, text)
    bag, pairs = Bag(source), list[Pair]()
    for start, part in _split(text):
        name, equals, value = part.partition("=")
        blank = len(part) - len(part.lstrip())
        span = Span(start + blank, start + len(part.rstrip()))
        if not equals:
            decimals = start > 0 and part.strip().isdigit()  # of a number with a comma
            help = "decimal numbers are written with `.`" if decimals else "write `name=value`, separated by commas"
            bag.error("E0208", f"`{part.strip()}` has no `=`", span, help=(help,))
            continue
        if "=" in value:
            help = "write `name=value`, separated by commas"
            bag.error("E0208", f"`{part.strip()}` has more than one `=`", span, help=(help,))
            continue
        tree = parse_expression(value, _places_from(start + len(name) + 1), bag)
        wanted = fold_typed(name)
        if any(pair.name == wanted for pair in pairs):
            bag.error("E0305", f"`{wanted}` is given twice", span, help=("keep one of them",))
        elif tree is not None:
            pairs.append(Pair(wanted, tree, span))
    bag.raise_if_errors()
    return source, tuple(pairs)


def _places_from(offset: int) -> Callable[[int, int], Span]:
    """Places in the whole text by those in a part of it."""
    return lambda a, b: Span(offset + a, offset + b)


def _split(text: str) -> list[tuple[int, str]]:
    parts, depth, start = [], 0, 0
    for k, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if character == "," and depth == 0:
            parts.append((start, text[start:k]))
            start = k + 1
    parts.append((start, text[start:]))
    return [(offset, part) for offset, part in parts if part.strip()]


def scene_about(spec: Spec, about: str, settings: Sequence[str] = ()) -> Scene:
    """The scene that ``about`` names, or an empty one with its pairs; then the pairs of ``settings``.

    Raises:
        nhc.diagnostics.SpecError: an unknown scene or name, or a value that is not constant.
    """
    chosen = next((scene for scene in spec.scenes if scene.name == about.strip()), None)
    place = spec.key_span("coordinates")  # what is wrong with the start is reported in the spec's text
    base = chosen or Scene("", place, "", (), (), (Fraction(0), Fraction(1)), (), Fraction(1, 10**8))
    if chosen is None and about.strip() and "=" not in about:
        bag, help = Bag(Source("--about", about)), "name one of them, or write `name=value` pairs"
        report_scene(bag, Span(0, len(about)), about.strip(), spec, help)
        bag.raise_if_errors()
    texts = [*([("--about", about)] if chosen is None else []), *(("--set", text) for text in settings)]
    given = set[str]()
    for option, text in texts:
        source, pairs = read_pairs(text, option)
        bag = Bag(source)
        for pair in pairs:
            base = _with_pair(spec, base, pair, bag)
        bag.raise_if_errors()
        # poles and constants that are no numbers are said with their places in the option's text
        probe = Resolver(spec)
        for definition in _constants(spec):
            probe.names[definition.name] = probe.node(definition.value)
        probe.bag = bag
        for pair in pairs:
            probe.node(pair.value)
        bag.raise_if_errors()
        given |= {pair.name for pair in pairs}
    return with_unit_quaternions(spec.rotations, base, given)


def known_pairs(spec: Spec, settings: Sequence[str]) -> tuple[str, ...]:
    """The pairs of ``settings`` whose names the spec has: a coarser model lacks some that a finer one has.

    Raises:
        nhc.diagnostics.SpecError: what is no pair.
    """
    parameters, found = {p.name for p in spec.parameters}, list[str]()
    for text in settings:
        for pair in read_pairs(text, "--set")[1]:
            if pair.name in parameters or _target(spec, pair.name) is not None:
                found.append(text[pair.span.start : pair.span.end])
    return tuple(found)


def _with_pair(spec: Spec, scene: Scene, pair: Pair, bag: Bag) -> Scene:
    parameters = tuple(p.name for p in spec.parameters)
    constants = tuple(definition.name for definition in _constants(spec))
    allowed = ("pi",) if pair.name in parameters else (*parameters, "pi", *constants)
    place = scene.span
    named = (*spec.definitions, *spec.quasi_velocities, *spec.outputs)
    variables = {*(c.name for c in spec.coordinates), *(one.name for one in named), *parameters, "t", "pi"}
    for node in walk(pair.value):
        if isinstance(node, Name) and node.name not in variables:
            help = suggest(node.name, allowed, f"a value holds numbers and {quote(allowed[:12])}")
            bag.error("E0302", f"unknown name `{node.name}`", node.span, help=(help,))
            return scene
        if isinstance(node, Prime) or (isinstance(node, Name) and node.name not in allowed):
            start = "a start value holds numbers, `pi`, parameters and definitions of these"
            help = "the value of a parameter holds numbers and `pi` only" if pair.name in parameters else start
            bag.error("E0314", f"`{pair.name}` has a value that is not constant", node.span, help=(help,))
            return scene
    if pair.name in parameters:
        kept = tuple(entry for entry in scene.parameters if entry.name != pair.name)
        return replace(scene, parameters=(*kept, Override(pair.name, pair.value, place)))
    target = _target(spec, pair.name)
    if target is None:
        coordinates = [c.name for c in spec.coordinates]
        known = [*coordinates, *(f"{c}'" for c in coordinates), *(d.name for d in spec.quasi_velocities), *parameters]
        more = ", ..." if len(known) > 12 else ""
        time = "a motion has no time of its own; `nhc run` and `nhc chart` take `--time`" if pair.name == "t" else ""
        help = (
            time or meant_rate(pair.name, coordinates) or suggest(pair.name, known, f"known: {quote(known[:12])}{more}")
        )
        bag.error(
            "E0419", f"`{pair.name}` is no coordinate, velocity, quasi-velocity or parameter", pair.span, help=(help,)
        )
        return scene
    initial = tuple(entry for entry in scene.initial if (entry.kind, entry.name) != target)
    return replace(scene, initial=(*initial, Initial(*target, pair.value, place)))


def _constants(spec: Spec) -> tuple[Definition, ...]:
    return constant_definitions(spec.definitions, {p.name for p in spec.parameters})


def _target(spec: Spec, name: str) -> tuple[str, str] | None:
    coordinates = [c.name for c in spec.coordinates]
    if name in coordinates:
        return "coordinate", name
    if any(d.name == name for d in spec.quasi_velocities):
        return "quasi", name
    for tail in ("'", "dot"):
        if name.endswith(tail) and name.removesuffix(tail) in coordinates:
            return "velocity", name.removesuffix(tail)
    return None


def state_of(flow: Flow, frame: Frame | None, start: Start) -> tuple[float, ...]:
    """The start as a state of the flow."""
    return (*start.q, *kept_velocities(flow.system, kept_forms(flow.system, frame), start))


def point_of(flow: Flow, scene: Scene) -> dict[Node, Node] | None:
    """The scene's start as nodes over the parameters; None where velocities or coordinates follow from others by no formula.

    Velocities that the state does not keep are solved for as many of those that it keeps; whatever else is free is zero.
    """
    system, build = flow.system, Resolver(flow.system.spec)
    build.graph = g = system.graph
    names = {"pi": g.pi(), **{p.name: node for p, node in zip(system.spec.parameters, system.p, strict=True)}}
    for definition in _constants(system.spec):
        names[definition.name] = build.node(definition.value, names)
    point = dict.fromkeys(flow.y, g.zero)
    point.update((node, g.number(c.start)) for node, c in zip(system.q, system.spec.coordinates, strict=True))
    given, rows = set[Node](), list[Node]()
    for entry in scene.initial:
        name = f"{entry.name}'" if entry.kind == "velocity" else entry.name
        node = None if entry.near else quantity(flow, name)
        if node is None:
            return None
        value = build.node(entry.value, names)
        if name in flow.names:
            point[node] = value
            given.add(node)
        else:
            rows.append(g.sub(node, value))
    return _completed(flow, point, given, rows) if rows else point


def _completed(flow: Flow, point: dict[Node, Node], given: set[Node], rows: Sequence[Node]) -> dict[Node, Node] | None:
    """The point with as many of its velocities that were not given as there are rows, which are linear in them and vanish."""
    g, free = flow.graph, [w for w in flow.y[flow.system.n :] if w not in given]
    rows = substitute(g, rows, {symbol: value for symbol, value in point.items() if symbol not in free})
    asked = [w for w in free if any(depends(g, rows, [w]))]
    if len(asked) != len(rows):
        return None
    try:
        values, _ = solve_rows(g, rows, asked)
    except Singular:
        return None
    return {**point, **dict(zip(asked, values, strict=True))}
