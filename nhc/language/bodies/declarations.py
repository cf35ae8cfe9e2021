"""``bodies`` and ``points`` as they are read: names, places, turns, masses, inertia."""

from __future__ import annotations

from collections.abc import Collection

from nhc.diagnostics import Span, nearest
from nhc.language.advice import meant_body_key
from nhc.language.bodies.kinematics import AXES, Inertia, Turn, Turning
from nhc.language.bodies.pieces import Piece, Triple, each, piece_of, write
from nhc.language.expressions.names import fold
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Name, Prime, walk
from nhc.language.keys import BODY_KEYS, INERTIA_KEYS
from nhc.language.rotation import entry_names, foretell_rotations
from nhc.language.scope import check_name
from nhc.language.shape import Shapes
from nhc.language.spec import Body as Told
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import is_empty
from nhc.records import record

MOST_TURNS = 6
_VECTOR = "write `[X, Y]`, or `[X, Y, Z]`"
_ENTRIES = tuple(key.name for key in INERTIA_KEYS)


@record
class Body:
    """``mass`` and ``inertia`` are None where the body has none, ``parent`` in space; ``weighed`` is where ``inertia`` stands."""

    name: Text
    parent: Text | None
    at: Triple
    turns: tuple[Turn, ...] | Turning
    mass: Piece | None
    centre: Triple
    inertia: Inertia | None
    about: str
    weighed: Span

    @property
    def on(self) -> str:
        """The body that it stands on; empty in space."""
        return fold(self.parent.value) if self.parent is not None else ""

    @property
    def told(self) -> Told:
        """What a person is told of it."""
        turning, inertia = self.turns, self.inertia
        turns = () if isinstance(turning, Turning) else tuple((AXES[s.axis], _shown(s.angle)) for s in turning)
        entries: tuple[tuple[str, str], ...] = ()
        if inertia is not None:
            shown = [_shown(piece) for piece in (*inertia.diagonal, *inertia.products)]
            same = len(set(shown[:3])) == 1
            kept = [(key, text) for key, text in zip(_ENTRIES, shown, strict=True) if text != "0"]
            entries = (("", shown[0]), *kept[3:]) if same else tuple(kept)
        return Told(
            name=self.name.value,
            on=self.on,
            at=tuple(map(_shown, self.at)) if any(not x.is_zero for x in self.at) else (),
            turns=turns,
            rotation=turning.name if isinstance(turning, Turning) else "",
            mass=_shown(self.mass) if self.mass is not None else "",
            centre=tuple(map(_shown, self.centre)) if any(not x.is_zero for x in self.centre) else (),
            inertia=entries,
            about=self.about,
            place=self.weighed,
        )


def _shown(piece: Piece) -> str:
    return piece.shown.text


class BodyReader:
    """Reads the entries of ``bodies`` and ``points``; what is wrong with them goes into the bag.

    ``moving`` are names of velocities, which have no place there; None where velocities are allowed, as in drawings.
    """

    def __init__(self, root: Table, shapes: Shapes, moving: Collection[str] | None) -> None:
        self.root, self.shapes, self.bag, self.moving = root, shapes, shapes.bag, moving

    def entries(self, key: str, wanted: str, help: str) -> tuple[tuple[Text, Node], ...]:
        node = self.root.get(key)
        table = self.shapes.table(node, wanted, help) if node is not None else None
        if table is not None and not table.entries:
            self.bag.error("E0301", f"`{key}` is empty", table.span, help=(help,))
        return tuple((t, n) for t, n in table.entries if check_name(t, self.bag)) if table is not None else ()

    def body(self, name: Text, node: Node) -> Body | None:
        what = f"body `{name.value}`"
        table = self.shapes.table(node, f"a mapping for {what}", f"write `{name.value}: {{mass: m, at: [x, y]}}`")
        if table is None:
            return None
        self.shapes.check_keys(table, BODY_KEYS, what, name.span, meant_body_key)
        about = self.shapes.line(table.get("about"))
        here = name.span.start
        at, turns = self.vector(table.get("at"), here), self._turns(table, name)
        centre, heavy = self.vector(table.get("centre"), here), table.get("inertia")
        inertia = self._inertia(heavy, name)
        mass = self.piece(table.get("mass"), "a mass")
        if at is None or turns is None or centre is None:
            return None
        return Body(
            Text(fold(name.value), name.span, True),
            self.name_under(table, "parent"),
            at,
            turns,
            mass,
            centre,
            inertia,
            about,
            heavy.span if heavy is not None else name.span,
        )

    def name_under(self, table: Node, key: str) -> Text | None:
        """The name of a body."""
        node = table.get(key) if isinstance(table, Table) else None
        return self.shapes.text(node, "the name of a body") if node is not None else None

    def piece(self, node: Node | None, what: str) -> Piece | None:
        """An expression, of positions unless velocities are allowed; None where there is none, or a wrong one."""
        text = self.shapes.text(node, f"an expression for {what}") if node is not None else None
        tree = parse_expression(text.value, text.locate, self.bag) if text is not None else None
        if tree is None or text is None:
            return None
        moving = self.moving
        if moving is None:
            return piece_of(text, tree)
        for part in walk(tree):
            if isinstance(part, Prime) or (isinstance(part, Name) and part.name in moving):
                help = "bodies are described by positions; velocities belong in `constraints`, `forces` or `T`"
                self.bag.error("E0414", f"a velocity in {what}", part.span, help=(help,))
                return None
        return piece_of(text, tree)

    def vector(self, node: Node | None, here: int, what: str = "a place") -> Triple | None:
        """Three components; the third is 0 where there are two, and all are where nothing is said."""
        zero = write("0", here)
        if node is None:
            return zero, zero, zero
        items = self.shapes.items(node, f"a list of two or three expressions for {what}", _VECTOR)
        if items is None:
            return None
        if len(items.items) not in (2, 3):
            message = f"expected a list of two or three expressions for {what}, found {len(items.items)}"
            self.bag.error("E0301", message, items.span, help=(_VECTOR,))
            return None
        found = [self.piece(item, what) for item in items.items]
        x, y, z = (*found, zero) if len(found) == 2 else found
        return None if x is None or y is None or z is None else (x, y, z)

    def _turns(self, table: Table, name: Text) -> tuple[Turn, ...] | Turning | None:
        turns, rotation = table.get("turns"), table.get("rotation")
        if rotation is not None:
            text = self.shapes.text(rotation, "the name of a rotation")
            if turns is not None and text is not None:
                help = "keep one of them; for both, put a body without mass in between"
                self.bag.error("E0318", f"`{name.value}` has both `rotation` and `turns`", text.span, help=(help,))
            return self._rotation(text) if text is not None else None
        if turns is None:
            return ()
        example = "write `turns: [z: yaw, x: roll]`"
        items = self.shapes.items(turns, "a list of turns", example)
        found = [self._turn(item, example) for item in items.items] if items is not None else [None]
        if len(found) > MOST_TURNS:
            help = "give the first turns to a body without mass, and make it the `parent` of this one"
            message = f"`{name.value}` turns {len(found)} times, {MOST_TURNS} are the most of one body"
            self.bag.error("E0318", message, turns.span, help=(help,))
            return None
        made = tuple(step for step in found if step is not None)
        return made if len(made) == len(found) else None

    def _turn(self, item: Node, example: str) -> Turn | None:
        table = self.shapes.table(item, "an axis with its angle", example)
        if table is None:
            return None
        if len(table.entries) != 1:
            self.bag.error("E0301", f"a turn has one axis, found {len(table.entries)}", table.span, help=(example,))
            return None
        axis, value = table.entries[0]
        if axis.value not in AXES or len(axis.value) != 1:
            help = "write `x`, `y` or `z`: the body's first, second or third axis"
            self.bag.error("E0312", f"`{axis.value}` is not an axis to turn about", axis.span, help=(help,))
            return None
        angle = self.piece(value, "an angle")
        return Turn(AXES.index(axis.value), angle) if angle is not None else None

    def _rotation(self, text: Text) -> Turning | None:
        """The names that a rotation of the spec brings."""
        declared, name, here = foretell_rotations(self.root.get("rotation")), fold(text.value), text.span.start
        if name not in declared:
            near = nearest(name, declared)
            help = f"did you mean `{near}`?" if near else f"declare it: `rotation: [{text.value}]`"
            self.bag.error("E0302", f"unknown rotation `{text.value}`", text.span, help=(help,))
            return None
        spoken, on_body = declared[name]
        entries = [write(entry, here) for entry in entry_names(name)]

        def row(x: int) -> Triple:
            return each(lambda k: entries[3 * x + k])

        return Turning(name, (row(0), row(1), row(2)), each(lambda k: write(spoken[k], here)), on_body)

    def _inertia(self, node: Node | None, name: Text) -> Inertia | None:
        here = name.span.start
        zero = write("0", here)
        if node is None or is_empty(node):
            return None
        if isinstance(node, Text):
            one = self.piece(node, "a moment of inertia")
            return Inertia((one, one, one), (zero, zero, zero)) if one is not None else None
        if isinstance(node, Items):
            help = "write `[xx, yy, zz]`, or `{xx: A, yy: B, zz: C, xz: D}`"
            if len(node.items) != 3:
                message = f"expected three moments of inertia, found {len(node.items)}"
                self.bag.error("E0301", message, node.span, help=(help,))
                return None
            x, y, z = (self.piece(item, "a moment of inertia") for item in node.items)
            return None if x is None or y is None or z is None else Inertia((x, y, z), (zero, zero, zero))
        self.shapes.check_keys(node, INERTIA_KEYS, f"the inertia of `{name.value}`", name.span)
        known = {key: self.piece(node.get(key), "an entry of the inertia matrix") or zero for key in _ENTRIES}
        xx, yy, zz, yz, xz, xy = (known[key] for key in _ENTRIES)
        return Inertia((xx, yy, zz), (yz, xz, xy))
