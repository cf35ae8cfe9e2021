"""Sheets before lowering: the same statements over graph nodes, and the desk on which they are made."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence, Set
from dataclasses import dataclass, field, replace

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import ADD, NEG, Node
from nhc.algebra.parts import split_powers
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.paper import shortest
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.shared import factor
from nhc.algebra.walks import count
from nhc.exterior import Form
from nhc.language.spec import reaction_name
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.rotations.rotation import name_entries
from nhc.mechanics.rotations.turning import moving, rows_in_base
from nhc.mechanics.system import Form as VelocityForm
from nhc.mechanics.system import System
from nhc.program.sheets.model import LATIN, OTHER, Formula, Mark, Prose, Table
from nhc.records import record

CANONICAL = 60  # terms of a canonical polynomial that may be shorter than what it came from
_WORTH = 250  # operations beyond which no canonical form is tried
_WRITTEN = 3000  # the same for the expression written out

Part = tuple[Node, tuple[Mark, ...]]
_KINDS = {"velocity": 1, "rate": 1, "acceleration": 2}


def _split_name(name: str) -> tuple[str, ...]:
    """A name as it is set: a symbol and its indices; ``z1`` and ``z_1`` are one, ``Epsilon`` is a capital E."""
    return tuple(LATIN.get(part, part) for part in re.findall(r"[^\W\d_]+|\d+", name))


@record
class Draft:
    """A statement over nodes; see :class:`nhc.program.sheets.model.Statement`."""

    left: tuple[Part, ...]
    right: tuple[Part, ...]
    relation: str = "="
    equation: str = ""
    place: str = ""
    note: str = ""
    label: Mark | None = None


DraftItem = Draft | Formula | Prose | Table


@dataclass
class DraftSheet:
    """A section in the making."""

    key: str
    title: str
    items: list[DraftItem] = field(default_factory=list)

    def say(self, text: str) -> None:
        self.items.append(Prose(text))

    def add(self, *items: DraftItem) -> None:
        self.items.extend(items)


class Desk:
    """One derivation's system, and how its nodes become parts of statements."""

    def __init__(self, system: System, formulation: Formulation, equations: Equations, simplify: float = 0.0) -> None:
        self.system, self.formulation, self.equations = system, formulation, equations
        self.graph = system.graph
        self._short: dict[Node, Node] = {}
        self._sizes: dict[Node, int] = {}
        self._simplify = self._simplifier(simplify)
        self._entries: dict[Node, Node] = {}
        self.matrices = list[list[list[Node]]]()
        """Symbols for the entries of the rotations' matrices."""
        for rotation, declared in zip(system.rotations, system.spec.rotations, strict=True):
            self._entries |= name_entries(self.graph, rotation, declared.entries, declared.velocities)
            symbols = [self.graph.symbol(name, "entry") for name in declared.entries]
            self.matrices.append([symbols[k : k + 3] for k in (0, 3, 6)])
        spec = system.spec
        self.defined = frozenset(entry.name for entry in spec.definitions)
        self.named = self.defined | {entry.name for entry in spec.quasi_velocities}
        groups = (spec.coordinates, spec.parameters, spec.definitions, spec.quasi_velocities, spec.outputs)
        self._taken = {_split_name(entry.name) for group in groups for entry in group}
        self.reshaped: dict[Mark, None] = {}
        """The symbols of the theory that were written in another shape, in the order of their use."""

    # --- nodes ------------------------------------------------------------------------------------------------

    def by_entries(self, node: Node) -> Node:
        """The node with the entries of rotations and their angular velocities by name: in coordinates they would fill lines."""
        return substitute(self.graph, [node], self._entries, named=False)[0] if self._entries else node

    def short(self, node: Node) -> Node:
        """The node in canonical form where that is small and shorter, rotations by their entries."""
        known, first = self._short.get(node), node
        if known is None:
            known = node = self.by_entries(node)
            if self.graph.children(node) and self.size(node) <= _WRITTEN and count(self.graph, [node]) <= _WORTH:
                known = self._simplify(shortest(self.graph, node, CANONICAL, self.size))
            self._short[first] = known
        return known

    def _simplifier(self, seconds: float) -> Callable[[Node], Node]:
        """SymPy's simplify within a time limit, only where it was asked for."""
        if seconds <= 0:
            return lambda node: node
        from nhc.algebra.bridge import Simplifier

        return Simplifier(self.graph, seconds, self.size)

    def size(self, node: Node) -> int:
        """Operations of the expression written out; signs are free."""
        g, stack = self.graph, [node]
        while stack:
            top = stack[-1]
            waiting = [c for c in g.children(top) if c not in self._sizes]
            if waiting:
                stack.extend(waiting)
                continue
            stack.pop()
            own = 0 if not g.children(top) or g.op[top] == NEG else 1
            self._sizes[top] = own + sum(self._sizes[c] for c in g.children(top))
        return self._sizes[node]

    def nonzero(self, nodes: Sequence[Node]) -> list[bool]:
        """Which nodes do not vanish identically (exact test)."""
        return [not zero for zero in are_zero(self.graph, nodes)]

    # --- marks ------------------------------------------------------------------------------------------------

    def mark(self, symbol: Node, further: int = 0) -> Mark:
        """How a symbol is written; ``further`` dots on top."""
        known = self.graph.symbol_of(symbol)
        assert known is not None
        for k, form in enumerate(self.system.constraints):
            if known.kind == "multiplier" and known.name == reaction_name(form.name):
                return self.own("lambda", form.name)
            frame = self.formulation.frame
            if frame is not None and frame.omega[k] == symbol:
                return replace(self.own("omega", form.name), dots=further)
        return Mark(known.name, dots=_KINDS.get(known.kind, 0) + further)

    def own(self, base: str, *lower: str) -> Mark:
        """A symbol of the theory; in another shape where a name of the spec would look the same (E, U, Q_x, lambda_slip)."""
        shown = tuple(part for name in (base, *lower) for part in _split_name(name))
        if shown not in self._taken:
            return Mark(base, lower)
        mark = Mark(f"{base}{OTHER}", lower)
        self.reshaped[mark] = None
        return mark

    def form_mark(self, letter: str, *lower: str) -> Mark:
        """A form of the theory, Theta or Omega; in another shape beside a quantity of the spec with that name."""
        return Mark(f"{letter} form{OTHER if (letter, *lower) in self._taken else ''}", lower)

    def vector_field(self) -> str:
        """The letter of a vector field: X, or the first of some others that is no name of the spec; Newton's X_i are forces."""
        letters = "YZWN" if self.formulation.name == "newton" else "XYZWN"
        return next((letter for letter in letters if (letter,) not in self._taken), "X")

    def is_free(self, letter: str) -> bool:
        """Whether no name of the spec looks like the letter or the letter with a number."""
        shown = LATIN.get(letter, letter)
        return not any(name[:1] == (shown,) and all(part.isdigit() for part in name[1:]) for name in self._taken)

    def is_named(self, letter: str) -> bool:
        """Whether the letter is a name of the spec."""
        return (letter,) in self._taken

    def coordinate(self, i: int, dots: int = 0) -> Mark:
        return Mark(self.system.q_names[i], dots=dots)

    def basis(self, form: Form) -> list[Mark]:
        """The marks of a coframe's basis: (omega, domega, dt) of all velocities or of the free ones."""
        count_, n = (len(form.coframe) - 1) // 2, self.system.n
        frame, name = self.formulation.frame, self.formulation.name
        if frame is None or name != "euler-lagrange":
            dependent = (
                () if count_ == n or self.formulation.dependent is None else self.formulation.dependent.dependent
            )
            kept = [i for i in range(n) if i not in dependent]
            heads = [Mark(self.system.q_names[i], prefix="d") for i in kept]
            rates = [Mark(self.system.q_names[i], dots=1, prefix="d") for i in kept]
            return [*heads, *rates, Mark("t", prefix="d")]
        first = n - count_
        heads = [self.quasi_differential(j) for j in range(first, n)]
        speeds = [self.mark(w) for w in frame.omega[first:]]
        rates = [Mark(m.base, m.lower, m.upper, m.dots, "d") for m in speeds]
        return [*heads, *rates, Mark("t", prefix="d")]

    def quasi_differential(self, j: int) -> Mark:
        """dpi_j; a coordinate's own differential where the form is one."""
        frame = self.formulation.frame
        assert frame is not None
        if j >= self.system.l and frame.omega[j] in self.system.v:
            return Mark(self.system.q_names[self.system.v.index(frame.omega[j])], prefix="d")
        return Mark("pi", (frame.forms[j].name,), prefix="d")

    # --- parts ------------------------------------------------------------------------------------------------

    def name(self, mark: Mark) -> tuple[Part, ...]:
        return ((self.graph.one, (mark,)),)

    def value(self, node: Node) -> tuple[Part, ...]:
        """The node alone, in short form."""
        node = self.short(node)
        return () if node == self.graph.zero else ((node, ()),)

    def determinant(self, node: Node) -> tuple[Part, ...]:
        """The node as a product of sums where it is one: the factors tell where it vanishes."""
        made = factor(self.graph, self.by_entries(node))
        sums = [base for base in split_powers(self.graph, made)[1] if self.graph.op[base] == ADD]
        return self.plain(made) if len(sums) > 1 and self.size(made) <= _WORTH else self.value(node)

    def energy(self, node: Node, still: Node) -> tuple[Part, ...]:
        """An energy on the motion: as it is, or as T in the words of the axes on which the rows were made, plus ``still``.

        The shorter one, shortened as in emitted code.
        """
        g, kinetic = self.graph, None if self.matrices else self.equations.kinetic()
        forms = [node, *shorten(g, [node])]
        if kinetic is not None:
            (whole,) = substitute(g, [g.add(kinetic, still)], moving(self.system, self.equations.motion.velocities))
            forms += [whole, *shorten(g, [whole])]
        shown = [self.short(form) for form in dict.fromkeys(forms)]
        return self.plain(min(shown, key=lambda form: (count(g, [form]), self.size(form))))

    def plain(self, node: Node) -> tuple[Part, ...]:
        """The node as it stands."""
        return () if node == self.graph.zero else ((node, ()),)

    def linear(
        self, coefficients: Sequence[Node], marks: Sequence[Mark], constant: Node | None = None
    ) -> tuple[Part, ...]:
        """sum coefficient_k mark_k + constant without the terms that vanish identically."""
        nodes = [*coefficients, *(() if constant is None else (constant,))]
        factors: list[tuple[Mark, ...]] = [(mark,) for mark in marks]
        factors += [()] * (constant is not None)
        kept = self.nonzero(nodes)
        return tuple((self.short(n), f) for n, f, keep in zip(nodes, factors, kept, strict=True) if keep)

    def shortened(self, form: Form) -> Form:
        """The form with its coefficients in short form; those that vanish identically are gone.

        Rotations are not written by their entries here, which are not independent: the form is still computed with.
        """
        indices = sorted(form.terms)
        kept = self.nonzero([form.terms[index] for index in indices])
        short = (lambda node: node) if self._entries else self.short
        terms = {i: short(form.terms[i]) for i, keep in zip(indices, kept, strict=True) if keep}
        return Form(form.coframe, form.degree, terms)

    def velocity_form(self, form: VelocityForm) -> tuple[Part, ...] | None:
        """A velocity form in q' and the angular velocities of rotations; None where these do not make it shorter."""
        row = self._row_by_rotations(form)
        if row is None:
            return None
        marks = [Mark(name, dots=1) for name in self.system.q_names]
        for rotation, declared in zip(self.system.rotations, self.system.spec.rotations, strict=True):
            for k, name in zip(rotation.places[1:], declared.velocities, strict=True):
                marks[k] = Mark(name)
        return self.linear(row, marks, form.constant)

    def differential_form(self, form: VelocityForm, known: Set[str]) -> tuple[Part, ...] | None:
        """The same in dq, dt and the dpi of angular velocities; None also where one of these is not among the ``known``."""
        velocities = [name for declared in self.system.spec.rotations for name in declared.velocities]
        row = None if form.name in velocities or not known >= {*velocities} else self._row_by_rotations(form)
        if row is None:
            return None
        marks = [Mark(name, prefix="d") for name in self.system.q_names]
        for rotation, declared in zip(self.system.rotations, self.system.spec.rotations, strict=True):
            for k, name in zip(rotation.places[1:], declared.velocities, strict=True):
                marks[k] = Mark("pi", (name,), prefix="d")
        return self.linear([*row, form.constant], [*marks, Mark("t", prefix="d")])

    def _row_by_rotations(self, form: VelocityForm) -> list[Node] | None:
        """Coefficients of q', with angular velocities at the last three places of each quaternion.

        None where the form has no angular velocity, or changes the length of a quaternion.
        """
        (row,) = rows_in_base(self.system, [form])
        turning = [row[k] for rotation in self.system.rotations for k in rotation.places[1:]]
        lengths = [row[rotation.places[0]] for rotation in self.system.rotations]
        return row if any(self.nonzero(turning)) and not any(self.nonzero(lengths)) else None

    def form(self, form: Form) -> tuple[Part, ...]:
        """A form's nonzero coefficients with the wedges of their basis forms."""
        basis = self.basis(form)
        terms = self.shortened(form).terms.items()
        return tuple((self.short(n), tuple(basis[k] for k in index)) for index, n in terms)
