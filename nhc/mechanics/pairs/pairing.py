"""Two specs side by side: which coordinate and parameter of the first is what in the second.

What has one name in both is the same; a map says what else a coordinate or a parameter of the first spec is, as an expression of
the second's.  So the first system is pulled back along q_1 = phi(q_2, t), and coordinates that only one of them has are left out.
A parameter that only one of them has takes its value there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.diagnostics import Bag, Span, quote, suggest
from nhc.language import Name, Parameter, Prime, Spec, walk
from nhc.mechanics.about import Pair, read_pairs
from nhc.mechanics.resolving.expressions import Resolver, define_names
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import parameter_value
from nhc.records import record

OPTION = "--map"


@record
class Pairing:
    """``images`` are the first system's coordinates by their index, as nodes over the second's; ``parameters`` its parameters.

    Both systems have the values of what only they have put in: ``fixed`` names these parameters with their values as text, once
    for each system.  ``open_parameters`` are such without a value, which may have any.  ``alone`` are the coordinates that only
    one of the systems has, by their indices.
    """

    first: System
    second: System
    images: tuple[tuple[int, Node], ...]
    alone: tuple[tuple[int, ...], tuple[int, ...]]
    parameters: tuple[tuple[Node, Node], ...]
    fixed: tuple[tuple[str, ...], tuple[str, ...]]
    open_parameters: tuple[str, ...]

    @property
    def common(self) -> tuple[int, ...]:
        """The coordinates of the first system that both have."""
        return tuple(i for i, _ in self.images)

    def place_of(self, i: int) -> int | None:
        """The coordinate of the second system that one of the first is; None where it is another function."""
        image = dict(self.images).get(i)
        return self.second.q.index(image) if image in self.second.q else None

    @property
    def is_plain(self) -> bool:
        """Whether everything is what has its name in the second system."""
        same = all(self.first.q_names[i] == _name_of(self.second, node) for i, node in self.images)
        return same and all(self.first.symbol_name(p) == _name_of(self.second, node) for p, node in self.parameters)

    @property
    def is_renaming(self) -> bool:
        """Whether every common coordinate is one of the second system, each another."""
        places = [self.place_of(i) for i in self.common]
        return None not in places and len(set(places)) == len(places)


def pair(first: System, second: System, maps: Sequence[str]) -> Pairing:
    """The systems side by side, ``maps`` being texts such as ``theta=phi, x=l*sin(phi)``.

    Raises:
        nhc.diagnostics.SpecError: a map that says nothing, or nothing in common (E0506).
    """
    images, parameters = _by_name(first, second)
    for text in maps:
        _read(text, first, second, images, parameters)
    if not images:
        bag = Bag(first.spec.origin)
        help = f"say what they are in the other spec: `{OPTION} '{first.q_names[0]}={second.q_names[0]}'`"
        bag.error("E0506", "the specs have no coordinate in common", first.spec.key_span("coordinates"), help=(help,))
        bag.raise_if_errors()
    g = second.graph
    held = [*images.values(), *parameters.values()]
    used = [any(g.depends(node, g.deps[symbol]) for node in held) for symbol in second.p]
    own = {symbol: entry for symbol, entry, use in zip(second.p, second.spec.parameters, used, strict=True) if not use}
    lone = {s: e for s, e in zip(first.p, first.spec.parameters, strict=True) if s not in parameters}
    values = [_values(system, those) for system, those in ((first, lone), (second, own))]
    left = {
        c.name for those, known in zip((lone, own), values, strict=True) for s, c in those.items() if s not in known
    }
    return Pairing(
        _with_values(first, values[0]),
        _with_values(second, values[1]),
        tuple(sorted(images.items())),
        (
            tuple(i for i in range(first.n) if i not in images),
            tuple(j for j, q in enumerate(second.q) if not any(g.depends(x, g.deps[q]) for x in images.values())),
        ),
        tuple(parameters.items()),
        (_shown(lone, values[0]), _shown(own, values[1])),
        tuple(sorted(left)),
    )


def _name_of(system: System, node: Node) -> str:
    symbol = system.graph.symbol_of(node)
    return "" if symbol is None else symbol.name


def _by_name(first: System, second: System) -> tuple[dict[int, Node], dict[Node, Node]]:
    places = {name: node for name, node in zip(second.q_names, second.q, strict=True)}
    images = {i: places[name] for i, name in enumerate(first.q_names) if name in places}
    known = {second.symbol_name(node): node for node in second.p}
    parameters = {node: known[first.symbol_name(node)] for node in first.p if first.symbol_name(node) in known}
    return images, parameters


# --- the maps -----------------------------------------------------------------------------------------------


def _read(text: str, first: System, second: System, images: dict[int, Node], parameters: dict[Node, Node]) -> None:
    source, pairs = read_pairs(text, OPTION)
    bag = Bag(source)
    if not pairs:
        help = f"write `{OPTION} 'theta=phi'`: a coordinate or parameter of the first spec by those of the second"
        bag.error("E0506", f"`{OPTION}` maps nothing", Span(0, len(text)), help=(help,))
    build = Resolver(second.spec, second.graph)
    define_names(build)
    build.bag = bag
    names = [first.symbol_name(node) for node in first.p]
    for entry in pairs:
        known = [*first.q_names, *names]
        if entry.name not in known:
            help = suggest(entry.name, known, f"known: {quote(known[:12])}")
            bag.error(
                "E0506", f"`{entry.name}` is no coordinate or parameter of the first spec", entry.span, help=(help,)
            )
        elif _is_known(entry, build, bag):
            node = build.node(entry.value)
            if entry.name in first.q_names and _holds_only(second, node, (*second.q, *second.p, second.t)):
                images[first.q_names.index(entry.name)] = node
            elif entry.name in names and _holds_only(second, node, second.p):
                parameters[first.p[names.index(entry.name)]] = node
            else:
                _refuse(entry, bag, in_coordinates=entry.name in first.q_names)
    bag.raise_if_errors()


def _is_known(entry: Pair, build: Resolver, bag: Bag) -> bool:
    for node in walk(entry.value):
        if isinstance(node, Prime):
            _refuse(entry, bag, in_coordinates=True)
            return False
        if isinstance(node, Name) and node.name not in build.names:
            help = suggest(node.name, build.names, "name coordinates, parameters and definitions of the second spec")
            bag.error("E0302", f"unknown name `{node.name}`", node.span, help=(help,))
            return False
    return True


def _holds_only(system: System, node: Node, symbols: Sequence[Node]) -> bool:
    return not system.graph.deps[node] & ~system.graph.mask(tuple(symbols))


def _refuse(entry: Pair, bag: Bag, *, in_coordinates: bool) -> None:
    what = "coordinates, parameters and the time" if in_coordinates else "parameters"
    help = f"write it with {what} of the second spec"
    bag.error("E0506", f"`{entry.name}` is mapped to what is no function of {what}", entry.span, help=(help,))


# --- parameters that only one spec has ------------------------------------------------------------------------


def _values(system: System, lone: Mapping[Node, Parameter]) -> dict[Node, Node]:
    """Their values as nodes of the system; none for those that each scene has to give."""
    build = Resolver(system.spec, system.graph)
    found = {}
    for symbol, entry in lone.items():
        if isinstance(entry.value, Fraction):
            whole = entry.value.denominator == 1
            found[symbol] = system.graph.number(entry.value.numerator if whole else entry.value)
        elif entry.value is not None:
            found[symbol] = build.node(entry.value)
    return found


def _shown(lone: Mapping[Node, Parameter], values: Mapping[Node, Node]) -> tuple[str, ...]:
    return tuple(f"{entry.name} = {parameter_value(entry.value):g}" for s, entry in lone.items() if s in values)


def _with_values(system: System, values: Mapping[Node, Node]) -> System:
    """The system with numbers in place of some parameters' symbols.

    Raises:
        nhc.diagnostics.SpecError: something has no value with these (E0506).
    """
    if not values:
        return system
    g = system.graph
    try:
        T, U, *Q = substitute(g, [system.T, system.U, *system.Q], values)
        torques = [substitute(g, torque, values) for torque in system.torques]
        constraints = tuple(_form_with(g, form, values) for form in system.constraints)
    except ZeroDivisionError:
        _refuse_values(system.spec, [system.symbol_name(symbol) for symbol in values])
        raise
    done = tuple((x, y, z) for x, y, z in torques)
    return replace(system, T=T, U=U, Q=tuple(Q), torques=done, constraints=constraints, pulls=None)


def _form_with(g: Graph, form: Form, values: Mapping[Node, Node]) -> Form:
    *coefficients, constant = substitute(g, [*form.coefficients, form.constant], values)
    equation = None if form.equation is None else substitute(g, [form.equation], values)[0]
    value = None if form.value is None else substitute(g, [form.value], values)[0]
    return Form(form.name, tuple(coefficients), constant, form.place, equation, value)


def _refuse_values(spec: Spec, names: Sequence[str]) -> None:
    bag = Bag(spec.origin)
    message = f"the values of {quote(names)}, which only this spec has, divide by zero"
    help = f"give them other values, or say with `{OPTION}` what they are in the other spec"
    bag.error("E0506", message, spec.key_span("parameters"), help=(help,))
    bag.raise_if_errors()
