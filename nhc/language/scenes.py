"""Scenes: overrides, starts, times, needs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from fractions import Fraction

from nhc.diagnostics import Bag, Span, nearest, quote
from nhc.language.advice import advise_need, meant_rate, meant_scene_key
from nhc.language.expressions.loanwords import ACCELERATIONS
from nhc.language.expressions.names import ENERGIES, fold
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Number, Syntax
from nhc.language.keys import NEAR_KEYS, SCENE_KEYS
from nhc.language.orientation import read_orientation, with_unit_quaternions
from nhc.language.scope import Scope, check_name, names_in
from nhc.language.shape import Shapes
from nhc.language.spec import (
    DEFAULT_TOLERANCE,
    LEAST_PART,
    LEAST_TIME,
    LEAST_TOLERANCE,
    Initial,
    Need,
    Override,
    Parameter,
    Rotation,
    Scene,
    reaction_name,
)
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import is_empty

ENERGY, REACTIONS, REACTION = "energy", "reactions", "reaction"
_NEEDED = "quantity that a scene can need"


def decode_scenes(
    node: Node | None,
    shapes: Shapes,
    scope: Scope,
    parameters: Sequence[Parameter],
    rotations: Sequence[Rotation],
    constrained: bool,
    constraints: Iterable[str] = (),
) -> tuple[Scene, ...]:
    """Return the scenes; ``parameters`` and ``rotations`` are those of the spec, which is ``constrained`` if it has constraints,
    and so are the names of its ``constraints`` as far as they could be read.
    """
    table = shapes.table(node, "a mapping of scenes by name", "write `name:` with its keys below") if node else None
    if table is None:
        return ()
    reader = _SceneReader(shapes, scope, parameters, rotations, constrained, constraints)
    found: dict[str, Scene] = {}
    if isinstance(table.get("time"), Items):
        help = "give the scene a name: `scenes: {go: {initial: {...}, time: [0, 10]}}`"
        shapes.bag.error("E0301", "a scene without a name", table.entries[0][0].span, help=(help,))
        return ()
    for text, value in table.entries:
        good = check_name(text, shapes.bag)
        scene = reader.read(text, value)
        name = fold(text.value)
        if good and name in found:
            shapes.bag.error("E0305", f"two scenes are named `{name}`", text.span, help=("rename one of them",))
        elif scene is not None:
            found[name] = scene
    return tuple(found.values())


def check_time(bag: Bag, time: tuple[Fraction, Fraction], span: Span) -> bool:
    """Whether start and end are some thousand doubles apart at least, and squares of steps no zeros; reports where they are not."""
    if time[1] - time[0] < LEAST_TIME:
        help = "take a unit of time in which it lasts longer"
        bag.error("E0313", f"`time` is shorter than {float(LEAST_TIME):g}: steps underflow", span, help=(help,))
        return False
    if time[1] - time[0] >= LEAST_PART * max(map(abs, time)):
        return True
    help = "doubles hold some 16 digits; begin at 0, and let the forces count from there"
    bag.error("E0313", "`time` is too short for so late a time: its times are not told apart", span, help=(help,))
    return False


class _SceneReader:
    def __init__(
        self,
        shapes: Shapes,
        scope: Scope,
        parameters: Sequence[Parameter],
        rotations: Sequence[Rotation],
        constrained: bool,
        constraints: Iterable[str],
    ) -> None:
        self.shapes = shapes
        self.scope = scope
        self.bag = shapes.bag
        self.parameters = parameters
        self.rotations = {rotation.name: rotation for rotation in rotations}
        self.reactions = tuple(reaction_name(constraint) for constraint in constraints)
        self.own_needs = (ENERGY, *((REACTIONS,) if constrained else ()), *self.reactions)

    def read(self, text: Text, value: Node) -> Scene | None:
        help = f"write `{text.value}: {{time: [0, 10]}}`"
        table = self.shapes.table(value, f"a mapping for scene `{text.value}`", help)
        if table is None:
            return None
        what = f"scene `{text.value}`"
        self.shapes.check_keys(table, SCENE_KEYS, what, text.span, meant_scene_key)
        overrides = self._overrides(table.get("parameters"))
        self._check_values(text, overrides)
        initial = self._initial(table.get("initial"))
        time_node = table.get("time")
        time = self._time(time_node) if time_node is not None else None
        scene = Scene(
            name=fold(text.value),
            span=text.span,
            about=self.shapes.line(table.get("about")),
            parameters=overrides,
            initial=initial,
            time=time or (Fraction(0), Fraction(1)),
            need=self._need(table.get("need")),
            tolerance=self._tolerance(table.get("tolerance")),
        )
        start = table.get("initial")
        alone = {fold(name.value) for name, _ in start.entries} if isinstance(start, Table) else set[str]()
        return with_unit_quaternions(self.rotations.values(), scene, alone)

    def _unknown(self, text: Text, what: str, known: Sequence[str]) -> None:
        if self.scope.open:
            return
        name, message = fold(text.value), f"`{text.value}` is no {what}"
        if self.scope.is_unknown(name.rstrip("'"), text.span) or self.bag.again("E0419", message, text.span):
            return
        near = nearest(name, known)
        rate = meant_rate(name, [other for other in self.scope.of_kind("coordinate") if f"{other}'" in known])
        defined = self.scope.kind(name) in ("define", "entry", "output")
        several = re.split(r"[\s,;]+", text.value.strip())
        if what == _NEEDED and len(several) > 1 and all(fold(part) in known for part in several):
            help = f"write `need: [{', '.join(several)}]`"
        elif what == _NEEDED and (defined or name in ENERGIES):
            help = advise_need(name)
        elif defined:
            help = f"`{name}` follows from others: give the values of these"
            if self.scope.kind(name) != "entry" and what != "parameter":
                help += ", or move it to `quasi_velocities` where it is a velocity"
        elif self.scope.kind(name) == "parameter" and what != _NEEDED:
            help = f"values of parameters stand beside `initial`: `parameters: {{{name}: ...}}`"
        elif rate or name.endswith("''"):
            help = rate or ACCELERATIONS
        elif near:
            help = f"did you mean `{near}`?"
        elif known:
            help = "known: " + quote(known[:12])
        else:
            help = "the spec declares none"
        self.bag.error("E0419", message, text.span, help=(help,))

    def _overrides(self, node: Node | None) -> tuple[Override, ...]:
        table = self.shapes.table(node, "a mapping of parameters to numbers") if node is not None else None
        found: dict[str, Override] = {}
        for text, value in table.entries if table else ():
            name = fold(text.value)
            number = self.shapes.constant(value, f"parameter `{text.value}`")
            if self.scope.kind(name) != "parameter":
                self._unknown(text, "parameter", self.scope.of_kind("parameter"))
            elif name in found:
                self.bag.error("E0305", f"`{name}` is set twice", text.span, help=("keep one of them",))
            else:
                found[name] = Override(name, number if number is not None else Fraction(0), text.span)
        return tuple(found.values())

    def _check_values(self, text: Text, overrides: tuple[Override, ...]) -> None:
        given = {override.name for override in overrides}
        missing = [p.name for p in self.parameters if p.value is None and p.name not in given]
        if missing:
            names = quote(missing)
            plural = "s" if len(missing) > 1 else ""
            help = f"write `parameters: {{{missing[0]}: 1.0}}` in the scene, or give a value under `parameters`"
            message = f"scene `{text.value}` has no value for the parameter{plural} {names}"
            self.bag.error("E0418", message, text.span, help=(help,))

    def _initial(self, node: Node | None) -> tuple[Initial, ...]:
        help = f"write `{{{next(iter(self.scope.of_kind('coordinate')), 'x')}: 1}}`, each value with its name"
        table = self.shapes.table(node, "a mapping of start values", help) if node is not None else None
        found: dict[tuple[str, str], Initial] = {}
        for text, value in table.entries if table else ():
            rotation = self.rotations.get(fold(text.value))
            if rotation is not None:
                self._orientation(rotation, text, value, found)
                continue
            if self.scope.kind(fold(text.value)) == "rotation":
                continue  # reported where it is declared
            target = self._target(text)
            near = isinstance(value, Table) and target is not None and target[0] == "coordinate"
            place = self._near(text, value) if near else value
            tree = self._start_value(place) if place is not None else None
            if target is None and is_empty(value):
                continue  # the end of a text with a comma in it, reported as an empty value
            if target is None:
                parts = {name for rotation in self.rotations.values() for name in rotation.coordinates}
                own = tuple(name for name in self.scope.of_kind("coordinate") if name not in parts)
                known = (*self.scope.of_kind("rotation"), *own, *self.scope.of_kind("quasi"))
                velocities = tuple(f"{name}'" for name in own)
                self._unknown(text, "coordinate, velocity or quasi-velocity", (*known, *velocities))
            elif target in found:
                self.bag.error("E0305", f"the start of `{text.value}` is set twice", text.span, help=("keep one",))
            else:
                found[target] = Initial(*target, tree or Number(Fraction(0), value.span), text.span, near)
        return tuple(found.values())

    def _near(self, text: Text, value: Node) -> Node | None:
        """Where to look for a coordinate; None where that is not said."""
        assert isinstance(value, Table)
        self.shapes.check_keys(value, NEAR_KEYS, f"the start of `{text.value}`", text.span)
        return value.get("near")

    def _orientation(self, rotation: Rotation, text: Text, value: Node, found: dict[tuple[str, str], Initial]) -> None:
        """The start of a rotation as that of its four coordinates."""
        parts = read_orientation(f"`{text.value}`", value, self.shapes, self._start_value)
        for name, tree in zip(rotation.coordinates, parts or (), strict=False):
            if ("coordinate", name) in found:
                self.bag.error("E0305", f"the start of `{name}` is set twice", text.span, help=("keep one",))
            found["coordinate", name] = Initial("coordinate", name, tree, text.span)

    def _target(self, text: Text) -> tuple[str, str] | None:
        name = fold(text.value)
        kind = self.scope.kind(name)
        if kind in ("coordinate", "quasi"):
            return kind, name
        velocity = self.scope.velocity_of(text.value)
        return ("velocity", velocity) if velocity is not None else None

    def _start_value(self, node: Node) -> Syntax | None:
        if self.scope.open and not isinstance(node, Text):
            return None  # it may be the orientation of what could not be read
        text = self.shapes.text(node, "a number")
        # YAML lets a number carry a plus; an expression does not
        plus = len(text.value) - len(text.value.removeprefix("+")) if text is not None and text.plain else 0
        if text is None:
            return None
        known = self.scope.of_kind("parameter")
        if self.shapes.refuse_unit(text, known) or self.shapes.refuse_infinite(text, known):
            return None
        tree = parse_expression(text.value[plus:], lambda start, end: text.locate(start + plus, end + plus), self.bag)
        if tree is None:
            return None
        tree = self.scope.resolve(tree, "start")
        self.scope.holds_velocities(tree, {})
        for name in names_in(tree):
            if name in self.scope.constants:
                continue
            if self.scope.kind(name) not in ("parameter", "rotation", "") or name == "t":
                message = (
                    f"`{name}` is not constant: a start value holds numbers, `pi`, parameters and definitions of these"
                )
                self.bag.error("E0314", message, text.span, help=(f"write the number that `{name}` starts with",))
        return tree

    def _need(self, node: Node | None) -> tuple[Need, ...]:
        if isinstance(node, Text):
            node = Items((node,), node.span)
        items = self.shapes.items(node, "a list of names", "write `[x, y]`") if node is not None else None
        if items is not None and not items.items:
            help = "name what is wanted, or leave `need` out: then it is all coordinates"
            self.bag.error("E0301", "`need` names nothing", items.span, help=(help,))
        found: dict[tuple[str, str], Need] = {}
        for item in items.items if items else ():
            text = self.shapes.text(item, "a name")
            need = self._needed(text) if text is not None else None
            if text is None:
                continue
            if need is None:
                known = (*self.scope.of_kind("coordinate", "quasi", "output"), *self.scope.shown)
                velocities = tuple(f"{name}'" for name in self.scope.of_kind("coordinate"))
                if fold(text.value) == REACTIONS and not self.scope.open:
                    message = "there are no reactions: this spec has no constraint"
                    self.bag.error("E0419", message, text.span, help=("leave `reactions` out",))
                else:
                    self._unknown(text, _NEEDED, (*known, *velocities, *self.own_needs))
            elif (need.kind, need.name) in found:
                self.bag.error("E0305", f"`{text.value}` is needed twice", text.span, help=("keep one of them",))
            elif need.kind in (REACTION, REACTIONS) and self._is_both(need, found):
                help = f"`{REACTIONS}` is all of them: leave it out, or the single ones"
                self.bag.error("E0305", f"`{text.value}` is needed twice", text.span, help=(help,))
            else:
                found[need.kind, need.name] = need
        if items is None or not items.items:
            names = self.scope.of_kind("coordinate")
            return tuple(Need("coordinate", name, self.scope.names[name].span) for name in names)
        return tuple(found.values())

    def _needed(self, text: Text) -> Need | None:
        name = fold(text.value)
        kind = "output" if name in self.scope.shown else self.scope.kind(name)
        if kind in ("coordinate", "quasi", "output"):
            return Need(kind, name, text.span)
        velocity = self.scope.velocity_of(text.value)
        if velocity is not None:
            return Need("velocity", f"{velocity}'", text.span)
        if name in self.reactions:
            return Need(REACTION, name, text.span)
        return Need(name, name, text.span) if name in self.own_needs else None

    @staticmethod
    def _is_both(need: Need, found: Iterable[tuple[str, str]]) -> bool:
        """Whether a reaction is needed by itself and among all of them."""
        return (REACTION if need.kind == REACTIONS else REACTIONS) in {kind for kind, _ in found}

    def _time(self, node: Node) -> tuple[Fraction, Fraction] | None:
        time = self.shapes.interval(node, "`time`")
        return time if time is not None and check_time(self.bag, time, node.span) else None

    def _tolerance(self, node: Node | None) -> Fraction:
        value = self.shapes.number(node, "`tolerance`") if node is not None else None
        if value is None:
            return DEFAULT_TOLERANCE
        if not 0 < value < 1 and node is not None:
            help = "write a relative accuracy such as `1e-8`"
            self.bag.error("E0313", "`tolerance` must lie between 0 and 1", node.span, help=(help,))
            return DEFAULT_TOLERANCE
        if value < LEAST_TOLERANCE and node is not None:
            help = "doubles hold some 16 digits; the least that can be asked for is `1e-15`"
            self.bag.error("E0313", "`tolerance` is finer than the numbers of a run", node.span, help=(help,))
            return DEFAULT_TOLERANCE
        return value
