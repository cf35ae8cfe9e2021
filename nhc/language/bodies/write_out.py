"""``bodies``, ``points`` and ``gravity``: rigid bodies said by mass, inertia, place and turns, written out as a plain spec.

What they bring becomes entries of ``define`` and terms of ``T`` and ``V`` before anything else reads the spec, so that the
rest of nhc knows energies, definitions and constraints only.  Of the names that a body brings those are kept that something uses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from nhc.diagnostics import Bag, Span, nearest, quote
from nhc.language.advice import meant_body_key
from nhc.language.bodies import kinematics, pieces
from nhc.language.bodies.declarations import Body, BodyReader
from nhc.language.bodies.draw_on import put_into_space
from nhc.language.bodies.kinematics import AXES, Frame, Ledger
from nhc.language.bodies.pieces import Piece, Triple, add, each, multiply, piece_of
from nhc.language.bodies.plain import Plain
from nhc.language.expressions.names import DOT, PI, fold
from nhc.language.expressions.parser import parse_expression
from nhc.language.keys import BODILY, POINT_KEYS
from nhc.language.rotation import entry_names, foretell_rotations
from nhc.language.shape import Shapes
from nhc.language.spec import Point
from nhc.language.yaml_tree.extend import declared_names
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import is_empty

_OF_BODIES = ("w1", "w2", "w3", "T")  # what a body brings that holds velocities
_OF_POINTS = ("vx", "vy", "vz", "v1", "v2", "v3")


def write_out(root: Table, bag: Bag, asked: str = "") -> Plain:
    """The spec with definitions and energies in place of ``bodies``, ``points`` and ``gravity``.

    Those that the expression ``asked`` names are made, too.
    """
    writer = _Writer(root, bag, asked)
    root, made = writer.run(), writer.ledger
    bodies, points = tuple(body.told for body in writer.bodies), tuple(writer.points)
    return Plain(root, tuple(made.made), bodies, points, frozenset(made.velocities))


class _Writer:
    def __init__(self, root: Table, bag: Bag, asked: str) -> None:
        self.root, self.bag, self.asked = root, bag, asked
        self.reader = BodyReader(root, Shapes(bag), _velocities(root))
        self.ledger = Ledger(_constants(root), _declared(root))
        self.declared: frozenset[str] = frozenset()
        self.frames: dict[str, Frame] = {"": kinematics.space()}
        self.bodies: list[Body] = []
        self.points: list[Point] = []
        self.energies: list[Piece] = []
        self.weights: list[Piece] = []

    def run(self) -> Table:
        bodies = self.reader.entries("bodies", "a mapping of bodies by name", "write `name: {mass: m, at: [x, y]}`")
        read: dict[str, Body | None] = {}
        for text, node in bodies:
            name = fold(text.value)
            if name in read:
                self.bag.error("E0305", f"two bodies are named `{name}`", text.span, help=("rename one of them",))
            read[name] = self.reader.body(text, node)
        self.declared = frozenset(read)
        known = {name: body for name, body in read.items() if body is not None}
        for text, node in bodies:
            parent = self.reader.name_under(node, "parent") if fold(text.value) not in known else None
            if parent is not None and fold(parent.value) not in self.declared:
                self._unknown_body(parent)
        gravity = self._gravity()
        self.bodies += self._in_order(known)
        for body in self.bodies:
            self._place(body, gravity)
        for text, node in self.reader.entries(
            "points", "a mapping of points by name", "write `name: {parent: body, at: [a, 0]}`"
        ):
            self._point(text, node)
        if bodies and not self.energies and self.root.get("T") is None and not self.bag.has_errors:
            place = next(text.span for text, _ in self.root.entries if text.value == "bodies")
            help = "give bodies `mass` or `inertia`, or write `T: ...`"
            self.bag.error("E0318", "no body has a mass or an inertia, and there is no `T`", place, help=(help,))
        for span, name in self.ledger.twice.items():
            help = "rename a body or a point: each declares names that begin with its own and `_`"
            self.bag.error("E0305", f"`{name}` is declared by two things", span, help=(help,))
        return self._merged()

    def _gravity(self) -> Triple | None:
        node = self.root.get("gravity")
        if node is None:
            return None
        key = next(text for text, _ in self.root.entries if text.value == "gravity")
        if self.root.get("bodies") is None:
            help = "add `bodies`, or write the potential: `V: m*g*z`"
            self.bag.error("E0318", "`gravity` acts on `bodies`, and there are none", key.span, help=(help,))
        return self.reader.vector(node, key.span.start, "the acceleration of gravity")

    # --- placing ---

    def _in_order(self, known: dict[str, Body]) -> Iterator[Body]:
        """Each body after the one that it stands on; what stands on itself is reported and left out."""
        done, placed = set[str](), set[str]()
        for start in known:
            path: list[str] = []
            name = start
            while name and name not in done and name in known and name not in path:
                path.append(name)
                name = known[name].on
            if name in path:
                cycle = " on ".join([*path[path.index(name) :], name])
                help = "put one of them in space: leave out its `parent`"
                self.bag.error("E0318", f"bodies form a cycle: {cycle}", known[name].name.span, help=(help,))
                done.update(path)
                continue
            parent = known[path[-1]].parent if path else None
            if parent is not None and name not in self.declared:
                self._unknown_body(parent)
            for name in reversed(path):
                done.add(name)
                if known[name].on in ("", *placed):
                    placed.add(name)
                    yield known[name]

    def _unknown_body(self, text: Text) -> None:
        message = f"unknown body `{text.value}`"
        if self.bag.again("E0302", message, text.span):
            return
        near, names = nearest(fold(text.value), sorted(self.declared)), quote(sorted(self.declared))
        help = f"the bodies are {names}" if self.declared else "declare it under `bodies`"
        self.bag.error("E0302", message, text.span, help=(f"did you mean `{near}`?" if near else help,))

    def _place(self, body: Body, gravity: Triple | None) -> None:
        name, ledger, here = body.name, self.ledger, body.name.span.start
        frame = kinematics.place_frame(name, self.frames[body.on], body.at, body.turns, ledger)
        self.frames[name.value] = frame
        out = each(lambda x: pieces.dot(body.centre, each(lambda k: frame.axes[k][x]), here))
        centre = ledger.names(f"{name.value}_c", AXES, pieces.plus(frame.origin, out, here), name.span)
        energy = kinematics.kinetic_energy(frame, body.mass, centre, body.inertia, ledger)
        named = ledger.name(f"{name.value}_T", energy, name.span)  # that of a body at rest, or without mass, is 0
        if not energy.is_zero:
            self.energies.append(named)
        if gravity is not None and body.mass is not None:
            self.weights.append(multiply(body.mass, pieces.dot(gravity, centre, here), here))

    def _point(self, name: Text, node: Node) -> None:
        what = f"point `{name.value}`"
        table = self.reader.shapes.table(
            node, f"a mapping for {what}", f"write `{name.value}: {{parent: body, at: [a, 0]}}`"
        )
        if table is None:
            return
        self.reader.shapes.check_keys(table, POINT_KEYS, what, name.span, meant_body_key)
        about = self.reader.shapes.line(table.get("about"))
        at = self.reader.vector(table.get("at"), name.span.start)
        parent, matter = self.reader.name_under(table, "parent"), self.reader.name_under(table, "of")
        for text in (parent, matter):
            if text is not None and fold(text.value) not in self.declared:
                self._unknown_body(text)
        on = fold(parent.value) if parent is not None else ""
        of = fold(matter.value) if matter is not None else on
        if at is not None and on in self.frames and of in self.frames:
            folded = Text(fold(name.value), name.span, True)
            kinematics.place_point(folded, self.frames[on], self.frames[of] if of else None, at, self.ledger)
            self.points.append(Point(folded.value, on, of, tuple(piece.shown.text for piece in at), about))

    # --- the plain spec ---

    def _merged(self) -> Table:
        """The entries of the spec without the keys that are written out, with what stands for them."""
        entries = [
            (text, self._drawn(node) if text.value == "draw" else node)
            for text, node in self.root.entries
            if text.value not in BODILY
        ]
        nodes = [node for key, node in (*self.root.entries, *entries) if key.value not in ("about", "source")]
        spoken = set(_words([*nodes, Text(self.asked, self.root.span, True)]))
        made = self._used(spoken | {piece.text for piece in self.energies})
        entries = self._with_energy(entries, "T", self.energies)
        potential = "U" if self.root.get("U") is not None else "V"
        signed = self.weights if potential == "U" else [weight.negative() for weight in self.weights]
        entries = self._with_energy(entries, potential, signed)
        if not made:
            return Table(tuple(entries), self.root.span)
        define = next((node for key, node in entries if key.value == "define"), None)
        if define is None:
            key = Text("define", made[0][0].span, True)
            return Table((*entries, (key, Table(tuple(made), made[0][0].span))), self.root.span)
        if isinstance(define, Table):
            define = Table((*define.entries, *made), define.span)
        return Table(tuple((k, define if k.value == "define" else v) for k, v in entries), self.root.span)

    def _drawn(self, node: Node) -> Node:
        """The shapes, those on bodies' axes put into space."""
        if not isinstance(node, Items):
            return node
        items: list[Node] = []
        reader = BodyReader(self.root, self.reader.shapes, None)  # a picture may show velocities
        for item in node.items:
            parent = self.reader.name_under(item, "parent") if isinstance(item, Table) else None
            on = fold(parent.value) if parent is not None else ""
            if isinstance(item, Table) and on and on in self.frames:
                made = put_into_space(item, self.frames[on], reader)
                items += [made] if not self.bag.has_errors else []  # what is wrong is said once
            elif not on or on not in self.declared:  # what is wrong with a declared one has been said
                items.append(item)
        return Items(tuple(items), node.span)

    def _used(self, spoken: set[str]) -> list[tuple[Text, Node]]:
        """The definitions that something needs."""
        weights = {name for piece in self.weights for name in pieces.names_in_text(piece.text)}
        pending, kept = [name for name in self.ledger.made if name in spoken | weights], set[str]()
        while pending:
            name = pending.pop()
            if name in kept:
                continue
            kept.add(name)
            needs = pieces.names_in_text(self.ledger.made[name][0].text)
            pending += [other for other in needs if other in self.ledger.made]
        found: list[tuple[Text, Node]] = []
        for name, (piece, span) in self.ledger.made.items():
            if name in kept:
                found.append((Text(name, span, True), piece.as_text(span)))
        return found

    def _with_energy(
        self, entries: list[tuple[Text, Node]], key: str, terms: Sequence[Piece]
    ) -> list[tuple[Text, Node]]:
        kept = [term for term in terms if not term.is_zero]
        if not kept:
            return entries
        own = next(((text, node) for text, node in entries if text.value == key), None)
        first = None
        if own is not None:
            text = own[1] if isinstance(own[1], Text) and not is_empty(own[1]) else None
            tree = parse_expression(text.value, text.locate, Bag(self.bag.source)) if text is not None else None
            if text is None or tree is None:  # the decoder says what is wrong
                return entries
            first = piece_of(text, tree)
        place = kept[0].places[0]
        value = add([*([first] if first is not None else []), *kept], place)
        node = value.as_text(own[1].span if own is not None else Span(place, place + 1))
        if own is None:
            return [*entries, (Text(key, node.span, True), node)]
        return [(text, node if text.value == key else value) for text, value in entries]


def _declared(root: Table) -> frozenset[str]:
    """The names that stand for something without the bodies."""
    found = set[str]().union(*(declared_names(root, key) for key in ("coordinates", "parameters", "define")))
    for name, (velocities, _) in foretell_rotations(root.get("rotation")).items():
        found.update(velocities, entry_names(name))
    return frozenset(found)


def _constants(root: Table) -> set[str]:
    """The names of parameters and pi, and of definitions that are made of these."""
    return _closure(root, {PI, *declared_names(root, "parameters")}, lambda words, known: words <= known)


def _velocities(root: Table) -> set[str]:
    """The names of quasi-velocities, of angular velocities and points' velocities, and of definitions that hold any velocity."""
    found = {DOT, *(f"{name}dot" for name in declared_names(root, "coordinates"))}
    for key, ends in (("bodies", _OF_BODIES), ("points", _OF_POINTS)):
        node = root.get(key)
        for text, _ in node.entries if isinstance(node, Table) else ():
            found.update(f"{fold(text.value)}_{end}" for end in ends)
    for key in ("quasi_velocities", "define"):
        node = root.get(key)
        for text, value in node.entries if isinstance(node, Table) else ():
            if key == "quasi_velocities" or (isinstance(value, Text) and "'" in value.value):
                found.add(fold(text.value))
    for names, _ in foretell_rotations(root.get("rotation")).values():
        found.update(names)
    # what is declared twice is said to be so elsewhere
    found -= {*declared_names(root, "parameters"), *declared_names(root, "coordinates")}
    return _closure(root, found, lambda words, known: not words.isdisjoint(known))


def _closure(root: Table, start: set[str], takes: Callable[[set[str], set[str]], bool]) -> set[str]:
    """Names with those of definitions whose words take them in, and so on."""
    define, found = root.get("define"), set(start)
    waiting = {
        fold(text.value): set(_words([value])) for text, value in (define.entries if isinstance(define, Table) else ())
    }
    while True:
        more = {name for name, words in waiting.items() if takes(words, found)} - found
        if not more:
            return found
        found |= more


def _words(nodes: Sequence[Node]) -> Iterator[str]:
    """Every name in some texts, keys included; ``xdot`` and ``dx`` are ones of ``x`` as well."""
    pending = list(nodes)
    while pending:
        node = pending.pop()
        match node:
            case Text():
                for name in pieces.names_in_text(node.value):
                    yield name
                    if name.endswith("dot"):
                        yield name[:-3]
                    if name.startswith("d"):
                        yield name[1:]
            case Items():
                pending += node.items
            case Table():
                for text, value in node.entries:
                    pending += (text, value)
