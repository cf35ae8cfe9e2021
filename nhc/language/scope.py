"""What the names of a spec mean: declarations, look-up, velocities."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache

from nhc.diagnostics import Bag, Label, Span, nearest, quote, suggest
from nhc.language.advice import foreign_name, meant_entry, meant_force, meant_name, meant_rate
from nhc.language.expressions.names import DOT, ENERGIES, FUNCTIONS, PI, RESERVED, TIME, fold, fold_typed, is_name
from nhc.language.expressions.syntax import Binary, Differential, Name, Number, Prime, Syntax, fold_tree, rebuild, walk
from nhc.language.expressions.unparse import unparse
from nhc.language.spec import reaction_name
from nhc.language.yaml_tree.nodes import Text
from nhc.records import record

_SEARCHES = 50  # unknown names for which a near one is looked for; the search is slow
_ENERGY = "energy"
_PLACES = ("coordinate", "define", "entry")  # what has a rate and a differential
_PUSHED = (*_PLACES, "quasi")  # what a force may be given on
_KINDS = {
    "coordinate": "a coordinate",
    "parameter": "a parameter",
    "define": "a name of `define`",
    "quasi": "a quasi-velocity",
    "output": "an output",
    "rotation": "a rotation",
    "entry": "an entry of a rotation's matrix",
}


@record
class Declared:
    """``kind`` is coordinate, parameter, define, quasi, output, rotation or entry (of a rotation's matrix)."""

    kind: str
    span: Span


class Scope:
    """The declared names. ``open``: a declaring section could not be read, so unknown names are passed over.

    ``offered`` are names that would be declared if anything used them.
    """

    def __init__(self, bag: Bag, offered: Sequence[str] = ()) -> None:
        self.offered = offered
        self.bag = bag
        self.names: dict[str, Declared] = {}
        self.open = False
        self.used: set[str] = set()  # entries of rotations' matrices that the spec speaks of
        self.constants: frozenset[str] = frozenset()  # names of `define` that parameters alone make up
        self.shown: dict[str, Span] = {}  # names of `define` that are outputs as well, under their own names
        self.left_out: Mapping[str, Span] = {}  # names of a base that the spec says `null` of
        self._searches = 0

    # --- declarations ---

    def declare(self, text: Text, kind: str) -> str | None:
        """Declare a name; return it folded, or None where it is refused."""
        name = fold(text.value)
        if not check_name(text, self.bag):
            self.open = True
            return None
        if name in RESERVED:
            what = "a function" if name in FUNCTIONS or name == DOT else "a constant" if name == PI else "the time"
            help = f"take another name, such as `{name}_1`"
            self.bag.error("E0306", f"`{name}` is {what} in this language", text.span, help=(help,))
            return None
        if name in self.names:
            first = self.names[name]
            label = Label(first.span, f"first declared here, as {_KINDS[first.kind]}")
            message = f"`{name}` is declared twice"
            help = "rename one of them"
            if (first.kind, kind) == ("coordinate", "define"):
                help = f"leave `{name}` out of `coordinates` if this is what it is; else rename one of them"
            self.bag.error("E0305", message, text.span, labels=(label,), help=(help,))
            return None
        self.names[name] = Declared(kind, text.span)
        return name

    def show_definition(self, text: Text, target: str) -> bool:
        """Take ``X: X`` under ``outputs`` for what it plainly means: the defined ``X`` is an output too."""
        name = fold(text.value)
        if name != target or self.kind(name) not in ("define", "entry") or name in self.shown:
            return False
        self.shown[name] = text.span
        return True

    def kind(self, name: str) -> str:
        """Return what kind of thing a name is; empty for an undeclared one."""
        return self.names[name].kind if name in self.names else ""

    def of_kind(self, *kinds: str) -> tuple[str, ...]:
        """Return the names of some kinds, in the order of their declarations."""
        return tuple(name for name, declared in self.names.items() if declared.kind in kinds)

    def check_coordinate(self, text: Text) -> bool:
        """Say whether a text names a coordinate; report it where it does not."""
        name = fold(text.value)
        if self.kind(name) == "coordinate":
            return True
        if not self.open and not self.is_unknown(name, text.span):
            known = self.of_kind("coordinate")
            help = suggest(name, known, f"the coordinates are {quote(known)}")
            self.bag.error("E0302", f"unknown coordinate `{text.value}`", text.span, help=(help,))
        return False

    def check_pushed(self, text: Text, hidden: Sequence[str]) -> bool:
        """Say whether a force may be given on what a text names; report it where it may not, and propose nothing ``hidden``."""
        name = fold(text.value)
        if self.kind(name) in _PUSHED:
            return True
        if not self.open and not self.is_unknown(name, text.span):
            self.bag.error("E0302", f"unknown coordinate `{text.value}`", text.span, help=(self._advise(text, hidden),))
        return False

    def _advise(self, text: Text, hidden: Sequence[str]) -> str:
        """What a force can be given on that is near to a name; else the coordinates and the velocities of the spec."""
        name, coordinate = fold(text.value), self.velocity_of(text.value)
        if coordinate is not None:
            return f"write `{coordinate}`: the force on a coordinate does its work with this velocity"
        entries = self.of_kind("entry")
        shown, velocities = ([n for n in self.of_kind(kind) if n not in hidden] for kind in ("coordinate", "quasi"))
        offered = [n for n in (*self.of_kind("define"), *self.offered, *entries) if n not in hidden]
        parts = [f"the coordinates are {quote(shown)}"] if shown else []
        parts += [f"the velocities are {quote(velocities)}"] if velocities else []
        meant = meant_entry(name, entries)
        near = f"did you mean `{meant}`?" if meant else suggest(name, [*shown, *velocities, *offered], "; ".join(parts))
        return meant_force(name, self.offered) or near

    def is_strange(self, name: str) -> bool:
        """Whether a name means nothing here."""
        return not self.kind(name) and name not in (TIME, PI)

    def is_unknown(self, name: str, span: Span) -> bool:
        """Whether a name has been reported as unknown; this is then one more place of that mistake."""
        message = f"unknown name `{name}`"
        return not self.kind(name) and self.bag.is_noted("E0302", message) and self.bag.again("E0302", message, span)

    def velocity_of(self, text: str) -> str | None:
        """Return the coordinate whose velocity a text such as ``x'`` or ``xdot`` names."""
        name = fold_typed(text)
        base = ""
        if name.endswith("'"):
            base = name[:-1].strip()
        elif name.endswith("dot") and name not in self.names:
            base = name[:-3]
        return base if self.kind(base) == "coordinate" else None

    # --- look-up ---

    def resolve(self, tree: Syntax, place: str) -> Syntax:
        """Give every name of an expression its meaning; what has none is reported.

        ``place`` is "equation" (differentials are known), "output" (energies are known), "start" (what is constant is
        proposed) or empty.
        """

        quotients = self._report_quotients(tree) if place != "equation" else set[int]()
        exponents = {id(node.right): node for node in walk(tree) if isinstance(node, Binary) and node.op == "^"}

        def visit(node: Syntax, parts: tuple[Syntax, ...]) -> Syntax:
            if isinstance(node, Name):
                return node if id(node) in quotients else self._look_up(node, place)
            made = rebuild(node, parts)
            if isinstance(made, Prime):
                self._check_prime(made, exponents.get(id(node)))
            return made

        return fold_tree(tree, visit)

    def _report_quotients(self, tree: Syntax) -> set[int]:
        """Report rates that are written ``dx/dt``; return the identities of the names in them."""
        found: set[int] = set()
        for node in walk(tree):
            if not (isinstance(node, Binary) and node.op == "/" and self._is_form(node.right, f"d{TIME}")):
                continue
            above = node.left
            while isinstance(above, Binary) and above.op == "*":
                above = above.right
            if isinstance(above, Name) and self._is_form(above) and self.kind(above.name[1:]) == "coordinate":
                found |= {id(above), id(node.right)}
                span = Span(above.span.start, node.right.span.end)
                help = f"write `{above.name[1:]}'`"
                self.bag.error("E0209", "a velocity as a quotient of differentials", span, help=(help,))
        return found

    def _is_form(self, node: Syntax, name: str = "") -> bool:
        """Whether a node is spelled as a differential (that of ``name``) and is nothing that the spec declares."""
        spelled = isinstance(node, Name) and not self.kind(node.name) and node.name[:1] == "d"
        return spelled and (not name or (isinstance(node, Name) and node.name == name))

    def _look_up(self, node: Name, place: str) -> Syntax:
        name = node.name
        if name in FUNCTIONS or name == DOT:
            help = f"write `{name}(...)`"
            self.bag.error("E0206", f"`{name}` is a function and needs its argument", node.span, help=(help,))
            return node
        kind = self.kind(name)
        if kind == "entry":
            self.used.add(name)
        if (kind and kind not in ("output", "rotation")) or name in (PI, TIME):
            return node
        if name in ENERGIES and place == "output" and not kind:
            return node
        if name.endswith("dot") and self.kind(name[:-3]) in _PLACES:
            self.used.add(name[:-3])
            return Prime(Name(name[:-3], node.span), node.span)
        is_form = name.startswith("d") and (name == "dt" or self.kind(name[1:]) in _PLACES)
        if is_form and place == "equation":
            self.used.add(name[1:])
            return Differential(name[1:], node.span)
        if kind or not self.open:
            self._report_unknown(node, kind, is_form, place)
        return node

    def _report_unknown(self, node: Name, kind: str, is_form: bool, place: str) -> None:
        name = node.name
        message = f"the differential `{name}` outside of a constraint" if is_form else f"unknown name `{name}`"
        is_form_of_unknown = place == "equation" and name[0] == "d" and self.is_unknown(name[1:], node.span)
        if is_form_of_unknown or self.bag.again("E0209" if is_form else "E0302", message, node.span):
            return
        if is_form:
            instead = (
                f"the velocity is `{name[1:]}'`" if name != "dt" else "a velocity is written with a prime, as `x'`"
            )
            help = f"differentials are for `constraints` only; {instead}"
            if place == "holonomic":
                help = "move the equation to `constraints`: an equation with velocities or differentials has its place there"
            self.bag.error("E0209", message, node.span, help=(help,))
            return
        help = ""
        if kind == "output" and name in ENERGIES:
            help = f"this output hides nhc's own `{name}`; give the output another name, such as `{name}_shown: {name}`"
        elif kind == "output":
            help = f"`{name}` is an output; move it to `define` to use it elsewhere"
        elif kind == "rotation":
            help = f"`{name}` is a rotation; the entries of its matrix are `{name}_x1` to `{name}_z3`"
        elif name in ENERGIES:
            help = f"`{name}` is known under `outputs` only"
        else:
            self._searches += 1
            kinds = ("parameter",) if place == "start" else ("coordinate", "parameter", "define", "quasi", "entry")
            others = (*sorted(self.constants), PI) if place == "start" else (*self.offered, TIME, PI)
            known = (*self.of_kind(*kinds), *others)
            near = meant_entry(name, known) or (nearest(name, known) if self._searches <= _SEARCHES else None)
            rate = meant_rate(name, self.of_kind(*_PLACES)) if place != "start" else ""
            if place == "equation" and name[0] == "d":
                rate = rate or self._advise_differential(name[1:])
            where = "`parameters`" if place == "start" else "`parameters`, `coordinates` or `define`"
            otherwise = f"did you mean `{near}`?" if near else f"declare it under {where}"
            help = rate or foreign_name(name, known) or otherwise
        gone = (Label(self.left_out[name], "left out here"),) if name in self.left_out else ()
        self.bag.error("E0302", message, node.span, labels=gone, help=(help,))

    def _advise_differential(self, name: str) -> str:
        """What to write in place of the differential of something that is no position; empty for an unknown name."""
        advice = {
            "parameter": f"leave it out: `{name}` is constant, so its differential is 0",
            "quasi": f"`{name}` is a velocity: write the whole constraint with velocities",
        }
        return advice.get(self.kind(name), "")

    def _check_prime(self, node: Prime, power: Binary | None) -> None:
        """Refuse the prime of a constant; ``power`` has it for its exponent."""
        inner = node.operand
        constant = isinstance(inner, Number)
        if isinstance(inner, Name):
            constant = inner.name in (PI, TIME) or self.kind(inner.name) == "parameter"
        if constant:
            what = f"`{inner.name}`" if isinstance(inner, Name) else "a number"
            value = "1" if isinstance(inner, Name) and inner.name == TIME else "0"
            help = f"write `{value}`"
            if power is not None:
                whole = unparse(Binary("^", power.left, inner, power.span, power.operator))
                help = f"the prime binds tighter than `^`: write `({whole})'`"
                if any(isinstance(part, Prime) for part in walk(power.left)):
                    help = f"leave the prime of the exponent out: write `{whole}`"
            self.bag.error("E0212", f"the time derivative of {what} is {value}", node.span, help=(help,))

    # --- velocities ---

    def holds_velocities(self, tree: Syntax, known: Mapping[str, bool], report: bool = True) -> bool:
        """Say whether an expression holds velocities; a time derivative of something that does is reported (E0414).

        ``known`` says the same of the names of ``define`` and ``quasi_velocities``.
        """

        def visit(node: Syntax, parts: tuple[bool, ...]) -> bool:
            if isinstance(node, Name):
                return known.get(node.name, node.name in ("T", _ENERGY) and node.name not in self.names)
            if isinstance(node, Prime):
                if parts[0] and report:
                    self._report_velocities(node, node.operand, known)
                return True
            if isinstance(node, Differential) and known.get(node.name, False) and report:
                self._report_velocities(node, Name(node.name, node.span), known)
            return any(parts)

        return fold_tree(tree, visit)

    def _report_velocities(self, node: Syntax, inner: Syntax, known: Mapping[str, bool]) -> None:
        labels: tuple[Label, ...] = ()
        what = "an expression that holds velocities"
        if isinstance(inner, Name):
            what = f"`{inner.name}`, which holds velocities"
            if known.get(inner.name) and inner.name in self.names:
                labels = (Label(self.names[inner.name].span, "declared here"),)
        derivative, sign = (
            ("differential", "`d`") if isinstance(node, Differential) else ("time derivative", "the prime")
        )
        help = f"{sign} is for positions; accelerations are what nhc derives"
        self.bag.error("E0414", f"{derivative} of {what}", node.span, labels=labels, help=(help,))


def check_name(text: Text, bag: Bag) -> bool:
    """Report a text that is no name."""
    if is_name(text.value):
        return True
    shown = text.value[:40]
    bag.error("E0307", f"`{shown}` is not a name", text.span, help=(meant_name(shown),))
    return False


@lru_cache(maxsize=4096)  # trees compare by identity; a spec of which parts are left out asks some thousand times
def names_in(tree: Syntax) -> tuple[str, ...]:
    """Return the names that stand in an expression, or whose differentials do, each once, in the order of their first places."""
    return tuple(dict.fromkeys(node.name for node in walk(tree) if isinstance(node, Name | Differential)))


def check_reactions(constraints: Mapping[str, Span], scope: Scope) -> None:
    """Refuse names that a table's columns of reactions have: one of two columns of one name would be lost."""
    for name in constraints:
        taken = reaction_name(name)
        span = scope.shown.get(taken)
        if span is None and scope.kind(taken) in ("coordinate", "quasi", "output"):
            span = scope.names[taken].span
        if span is not None:
            message = f"`{taken}` is the name of a reaction in tables: that of the constraint `{name}`"
            help = "rename this, or the constraint; `need: [reactions]` shows the reaction itself"
            scope.bag.error("E0305", message, span, help=(help,))
