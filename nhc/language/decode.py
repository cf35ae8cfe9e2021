"""Nodes to a Spec, or to all the diagnostics at once."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from fractions import Fraction

from nhc.diagnostics import Bag, Source, Span, SpecError, quote, several, suggest
from nhc.language.advice import meant_formulation, meant_key
from nhc.language.bodies.without import without_bodies
from nhc.language.constants import constant_definitions
from nhc.language.drawing import decode_drawing
from nhc.language.equations import Equations
from nhc.language.expressions.names import fold, is_name
from nhc.language.expressions.one_forms import check_form
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Name, Number, Syntax
from nhc.language.keys import INSTEAD, SPEC_KEYS, SYSTEM_PATTERN, VERSION
from nhc.language.order import order_definitions
from nhc.language.rotation import (
    coordinates_of,
    decode_rotations,
    entries_of,
    norm_of,
    pushes_quaternion,
    velocities_of,
)
from nhc.language.scenes import decode_scenes
from nhc.language.scope import Scope, check_reactions, names_in
from nhc.language.sections import decode_coordinates, decode_parameters
from nhc.language.shape import Shapes
from nhc.language.spec import FORMULATIONS, Constraint, Coordinate, Definition, Holonomic, Parameter, Rotation, Spec
from nhc.language.units.beside import check_sound_units
from nhc.language.yaml_tree.extend import merge_bases
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import is_empty, is_null, read_nodes
from nhc.records import fresh, structure

_KEYS = frozenset(key.name for key in SPEC_KEYS)
_DECLARING = ("coordinates", "rotation", "parameters", "define", "quasi_velocities", "outputs")

_VECTOR = "write one expression: a vector takes one name for each component, such as `X` and `Y`"


@structure
class _Draft:
    """What is known of the spec while it is decoded."""

    coordinates: list[Coordinate] = fresh(factory=list)
    rotations: list[Rotation] = fresh(factory=list)
    parameters: list[Parameter] = fresh(factory=list)
    define: list[Definition] = fresh(factory=list)
    quasi: list[Definition] = fresh(factory=list)
    outputs: list[Definition] = fresh(factory=list)
    forces: list[Definition] = fresh(factory=list)
    order: tuple[str, ...] = ()
    velocities: dict[str, bool] = fresh(factory=dict)


class _Decoder:
    def __init__(self, source: Source, written: Table, bag: Bag, asked: str, left_out: Mapping[str, Span]) -> None:
        self.source, self.written, self.left_out = source, written, left_out
        self.plain = without_bodies(written, bag, asked)
        self.root = self.plain.root
        self.bag = bag
        self.shapes = Shapes(bag)
        self.scope = Scope(bag, self.plain.offered)
        self.scope.open = bag.has_errors
        self.draft = _Draft()

    def run(self) -> Spec:
        place = self.written.entries[0][0].span if self.written.entries else self.written.span
        present = {text.value for text, _ in self.written.entries}
        keys = [key.optional() if INSTEAD.get(key.name) in present else key for key in SPEC_KEYS]
        meant = self.shapes.check_keys(self.written, keys, "the spec", place, meant_key, self.left_out)
        strange = any(text.value not in _KEYS and not isinstance(node, Text) for text, node in self.root.entries)
        unknown = strange or any(key in _DECLARING for key in meant)  # what it declares is not known
        self.scope.open = self.scope.open or unknown
        uncounted = strange or "constraints" in meant or "holonomic" in meant  # they may be under a misspelled key
        version, system = self._version(), self._system()
        self._declare()
        self._resolve_named()
        kinetic = self._expression("T")
        potential_kind, potential = self._potential()
        forces = self._forces()
        outputs = self._entries(self.draft.outputs, "output")
        rotations = self.draft.rotations
        equations = Equations(self.root, self.shapes, self.bag, rotations)
        constraints, holonomic = self._constraints(equations), self._holonomic(equations)
        check_reactions(equations.taken, self.scope)
        counted = not (uncounted or equations.uncounted or self.scope.open)
        dependent = self._dependent(equations.count if counted else None)
        constrained = bool(rotations) or any(map(self.root.get, ("constraints", "holonomic")))
        given = self.draft.parameters
        asked = self.root.get("scenes"), self.shapes, self.scope
        scenes = decode_scenes(*asked, given, rotations, constrained, equations.taken)
        draw = decode_drawing(self.root.get("draw"), self.shapes, self._read)
        definitions = self._in_order()
        spec = Spec(
            origin=self.source,
            version=version,
            system=system,
            about=self._text("about"),
            sources=self.shapes.lines(self.root.get("source")),
            coordinates=(*self.draft.coordinates, *(c for r in rotations for c in coordinates_of(r))),
            parameters=tuple(self.draft.parameters),
            definitions=definitions,
            kinetic=kinetic or Number(Fraction(0), Span(0, 0)),
            potential=potential,
            potential_kind=potential_kind,
            forces=forces,
            constraints=constraints,
            holonomic=(*holonomic, *(norm_of(r) for r in rotations)),
            quasi_velocities=(*self.draft.quasi, *(w for r in rotations for w in velocities_of(r))),
            named_order=self.draft.order,
            dependent=dependent,
            formulation=self._formulation(),
            outputs=outputs,
            draw=draw,
            scenes=scenes,
            key_spans=tuple((text.value, text.span) for text, _ in self.root.entries),
            rotations=tuple(rotations),
            bodies=self.plain.bodies,
            points=self.plain.points,
            velocities=self.plain.velocities,
        )
        if not self.bag.has_errors or (kinetic is not None and not self.scope.open):
            check_sound_units(spec, self.written, self.bag)
        self.bag.raise_if_errors()
        return spec

    # --- single values ---

    def _version(self) -> int:
        node = self.root.get("nhc")
        text = self.shapes.text(node, "the language version") if node else None
        if text is not None and text.value != str(VERSION):
            help = f"write `nhc: {VERSION}`"
            self.bag.error("E0309", f"unsupported language version `{text.value}`", text.span, help=(help,))
        return VERSION

    def _system(self) -> str:
        node = self.root.get("system")
        text = self.shapes.text(node, "the system's name") if node else None
        if text is None:
            return ""
        if not re.fullmatch(SYSTEM_PATTERN, text.value):
            bare = "".join(x for x in unicodedata.normalize("NFKD", fold(text.value)) if not unicodedata.combining(x))
            better = re.sub("[^a-z0-9_]+", "_", bare.lower()).strip("_")
            help = f"write `{better}`" if re.fullmatch(SYSTEM_PATTERN, better) else "write a name such as `my_system`"
            message = f"`{text.value}` is no name of a system: lower case letters, digits and `_`, a letter first"
            self.bag.error("E0310", message, text.span, help=(help,))
        return text.value

    def _text(self, key: str) -> str:
        return self.shapes.line(self.root.get(key))

    def _formulation(self) -> str:
        node = self.root.get("formulation")
        text = self.shapes.text(node, "a formulation") if node else None
        if text is None:
            return "auto"
        if text.value not in FORMULATIONS:
            meant = meant_formulation(text.value)
            help = f"write `{meant}`" if meant else suggest(text.value, FORMULATIONS, f"one of {quote(FORMULATIONS)}")
            self.bag.error("E0312", f"unknown formulation `{text.value}`", text.span, help=(help,))
        return text.value

    # --- names ---

    def _declare(self) -> None:
        draft, shapes, scope = self.draft, self.shapes, self.scope
        places = self.root.get("coordinates"), self.root.get("rotation")
        if places[0] is not None or places[1] is None:
            draft.coordinates = decode_coordinates(places[0], shapes, scope)
        draft.rotations = decode_rotations(places[1], shapes, scope)
        draft.velocities = {name: True for rotation in draft.rotations for name in rotation.velocities}
        draft.parameters = decode_parameters(self.root.get("parameters"), shapes, scope)
        draft.define = self._named("define", "define")
        draft.quasi = self._named("quasi_velocities", "quasi")
        draft.outputs = self._named("outputs", "output")

    def _named(self, key: str, kind: str) -> list[Definition]:
        """Declare the names of a section and parse their expressions, without looking names up yet."""
        node = self.root.get(key)
        if node is None:
            return []
        table = self.shapes.table(node, "a mapping of names to expressions", "write `name: expression`")
        if table is None:
            self.scope.open = True
            return []
        found = []
        for text, value in table.entries:
            if is_empty(value) and not is_name(text.value):
                continue  # the end of a text with a comma in it, reported as an empty value
            tree = self._parse(value)
            if kind == "output" and isinstance(tree, Name) and self.scope.show_definition(text, tree.name):
                found.append(Definition(tree.name, tree, text.span))
                continue
            name = self.scope.declare(text, kind)
            if name is not None and tree is not None:
                found.append(Definition(name, tree, text.span))
        return found

    def _resolve_named(self) -> None:
        draft = self.draft
        draft.define = [Definition(d.name, self.scope.resolve(d.value, ""), d.span) for d in draft.define]
        draft.quasi = [Definition(d.name, self.scope.resolve(d.value, ""), d.span) for d in draft.quasi]
        named = {d.name: d.value for d in (*draft.define, *draft.quasi)}
        spans = {d.name: d.span for d in (*draft.define, *draft.quasi)}
        draft.order = order_definitions(named, spans, self.bag)
        for name in draft.order:
            draft.velocities[name] = self.scope.holds_velocities(named[name], draft.velocities)
        constants = constant_definitions(self._in_order(), {p.name for p in draft.parameters})
        self.scope.constants = frozenset(d.name for d in constants)

    def _in_order(self) -> tuple[Definition, ...]:
        """Definitions, after the entries of rotations' matrices that are spoken of."""
        by_name = {definition.name: definition for definition in self.draft.define}
        entries = [entry for rotation in self.draft.rotations for entry in entries_of(rotation)]
        used = [entry for entry in entries if entry.name in self.scope.used]
        return (*used, *(by_name[name] for name in self.draft.order if name in by_name))

    # --- expressions ---

    def _parse(self, node: Node) -> Syntax | None:
        text = self.shapes.text(node, "an expression", _VECTOR if isinstance(node, Items) else "")
        return parse_expression(text.value, text.locate, self.bag) if text else None

    def _check(self, tree: Syntax, place: str) -> Syntax:
        resolved = self.scope.resolve(tree, place)
        self.scope.holds_velocities(resolved, self.draft.velocities)
        return resolved

    def _read(self, node: Node) -> Syntax | None:
        tree = self._parse(node)
        return self._check(tree, "") if tree is not None else None

    def _expression(self, key: str) -> Syntax | None:
        node = self.root.get(key)
        return self._read(node) if node is not None else None

    def _potential(self) -> tuple[str, Syntax | None]:
        force_function, potential = self._expression("U"), self._expression("V")
        keys = {text.value: text for text, _ in self.root.entries}
        if "U" in keys and "V" in keys:
            help = "keep one: `U` is the force function (Q_i = + dU/dq_i), `V` the potential energy (Q_i = - dV/dq_i)"
            self.bag.error("E0311", "both `U` and `V` are given", keys["V"].span, help=(help,))
        if "U" in keys:
            return "U", force_function
        return ("V", potential) if "V" in keys else ("", None)

    def _entries(self, definitions: list[Definition], place: str) -> tuple[Definition, ...]:
        return tuple(Definition(d.name, self._check(d.value, place), d.span) for d in definitions)

    def _forces(self) -> tuple[Definition, ...]:
        node = self.root.get("forces")
        help = f"write `{next(iter(self.scope.of_kind('coordinate')), 'x')}: ...`, each force with its coordinate"
        table = self.shapes.table(node, "a mapping of coordinates to expressions", help) if node is not None else None
        found: dict[str, Definition] = {}
        hidden = [name for rotation in self.draft.rotations for name in rotation.coordinates]
        hidden += [f"{body.name}_T" for body in self.plain.bodies]
        for text, value in table.entries if table else ():
            name = fold(text.value)
            tree = self._parse(value)
            if self.scope.kind(name) == "entry":
                self.scope.used.add(name)
            elif not self.scope.check_pushed(text, hidden):
                continue
            if pushes_quaternion(text, self.draft.rotations, self.bag):
                continue
            if name in found:
                self.bag.error("E0305", f"the force on `{name}` is given twice", text.span, help=("add them up",))
            elif tree is not None:
                found[name] = Definition(name, self._check(tree, ""), text.span)
        return tuple(found.values())

    # --- constraints ---

    def _constraints(self, equations: Equations) -> tuple[Constraint, ...]:
        found = []
        for name, span, left, right in equations.read("constraints", "c"):
            left, right = self._check(left, "equation"), self._check(right, "equation")
            strange = self.scope.open or any(map(self.scope.is_strange, (*names_in(left), *names_in(right))))
            form = check_form(left, right, self.draft.velocities, Bag(self.source) if strange else self.bag)
            found.append(Constraint(name, left, right, form, span))
        return tuple(found)

    def _holonomic(self, equations: Equations) -> tuple[Holonomic, ...]:
        return tuple(
            Holonomic(name, self._check(left, "holonomic"), self._check(right, "holonomic"), span)
            for name, span, left, right in equations.read("holonomic", "h")
        )

    def _dependent(self, count: int | None) -> tuple[str, ...]:
        """The dependent coordinates; ``count`` is the number of constraints, None where mistakes leave it open."""
        node = self.root.get("dependent")
        single = node.value if isinstance(node, Text) and is_name(node.value.rstrip("'")) else "x, y"
        items = self.shapes.items(node, "a list of coordinates", f"write `[{single}]`") if node is not None else None
        if items is None:
            return ()
        found: dict[str, None] = {}
        for item in items.items:
            text = self.shapes.text(item, "the name of a coordinate")
            if text is None:
                continue
            name = self.scope.velocity_of(text.value) or fold(text.value)
            if self.scope.kind(name) != "coordinate" and not self.scope.check_coordinate(text):
                continue
            if name in found:
                message = f"`{name}` is named twice in `dependent`"
                self.bag.error("E0305", message, text.span, help=("keep one of them",))
            found[name] = None
        if count is not None and len(items.items) != count:
            message = f"`dependent` names {len(items.items)} velocities for {several(count, 'constraint')}"
            help = "name one velocity for each constraint, or leave `dependent` out and let nhc choose"
            self.bag.error("E0315", message, items.span, help=(help,))
        return tuple(found)


def decode(source: Source, asked: str = "") -> Spec:
    """Return the Spec; raises ``SpecError`` with every diagnostic, in the order of places.  Names in ``asked`` count as used."""
    bag = Bag(source)
    root = read_nodes(source, bag)
    if root is None:
        if not bag.has_errors:
            help = "begin with `nhc: 1`; `nhc new NAME` writes an example"
            bag.error("E0111", "the spec is empty", Span(0, 0), help=(help,))
        raise SpecError(bag.diagnostics, source)
    if not isinstance(root, Table):
        start = root.span.start
        place = Span(start, start + 1)
        bag.error("E0301", "a spec is a mapping of keys to values", place, help=("begin with `nhc: 1`",))
        raise SpecError(bag.diagnostics, source)
    left_out = {text.value: text.span for text, value in root.entries if is_null(value)}
    made = _Decoder(source, merge_bases(source, root, bag), bag, asked, left_out)
    sections = [section for key in _DECLARING if isinstance(section := root.get(key), Table)]
    made.scope.left_out = {
        fold(key.value): key.span for part in sections for key, value in part.entries if is_null(value)
    }
    return made.run()
