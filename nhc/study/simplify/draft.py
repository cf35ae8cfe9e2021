"""A spec of which parts can be left out: its expressions as trees, its candidates, and what becomes of the trees without them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from nhc.diagnostics import Bag, Source
from nhc.language import Spec, decode
from nhc.language.bodies.without import without_bodies
from nhc.language.expressions.syntax import Binary, Name, Negate, Syntax, same
from nhc.language.expressions.unparse import unparse
from nhc.language.scope import names_in
from nhc.language.spec import Scene
from nhc.language.yaml_tree.extend import merge_bases
from nhc.language.yaml_tree.nodes import Table
from nhc.language.yaml_tree.reader import read_nodes
from nhc.mechanics.starts.scenes import Start
from nhc.records import record
from nhc.study.simplify.candidate import Candidate, expand, group, hold
from nhc.study.simplify.scene_table import with_scene
from nhc.study.simplify.zero import ZERO, is_infinite, is_zero, list_terms, replace_parts

Place = tuple[str, str]  # a top-level key, and a name below it, an index with its side, or nothing
FOLLOWING = ("quasi_velocities", "outputs")
"""Keys whose expressions are questions: they lose no terms, only coordinates that are no longer there."""

RANKS = {"T": 0, "U": 0, "V": 0, "forces": 0, "constraints": 2, "holonomic": 2, "define": 3}
"""What is measured first: energies and forces, then parameters and coordinates (1), constraints, and definitions, of which a large
spec may have hundreds that only describe positions.
"""


@record
class Changed:
    """The trees of a smaller model; ``copies`` are definitions that the model has otherwise than the outputs: (name, its copy)."""

    trees: Mapping[Place, Syntax]
    copies: Mapping[str, str]
    copied: Mapping[str, Syntax]
    gone: tuple[Candidate, ...]

    @property
    def coordinates(self) -> dict[str, Candidate]:
        """The coordinates that are no longer there."""
        return {c.name: c for c in self.gone if c.takes_coordinate}


@record
class Draft:
    """``trees`` are all expressions of the spec; ``shown`` the names of definitions that questions, drawings and starts use."""

    spec: Spec
    scene: Scene
    root: Table
    trees: Mapping[Place, Syntax]
    shown: frozenset[str]

    def candidates(self, start: Start) -> list[Candidate]:
        """Terms of T, of U or V, of forces, constraints and definitions; then parameters; then coordinates that a limit fixes."""
        found = []
        physics = {
            place: tree for place, tree in self.trees.items() if place[0] not in FOLLOWING and self._is_given(place)
        }
        for place, tree in physics.items():
            for node, minus in self._terms(place, tree):
                found.append(
                    Candidate(
                        f"term `{'-' if minus else ''}{unparse(node)}` of {self._where(place)}",
                        node=node,
                        rank=RANKS[place[0]],
                    )
                )
        used = {name for tree in physics.values() for name in names_in(tree)}
        for parameter in self.spec.parameters:
            if parameter.name not in used:
                continue
            found.append(Candidate(f"parameter `{parameter.name}`, set to 0", "zero", name=parameter.name))
            large = Candidate(f"parameter `{parameter.name}`, made infinite", "infinite", name=parameter.name)
            if not any(is_infinite(tree) for tree in self.change([large]).trees.values()):
                found.append(large)
        limits = self._limits(start)
        return number_twins([*found, *limits, *group(limits)])

    def _is_given(self, place: Place) -> bool:
        """Whether it stands in the spec: what nhc makes of a rotation has no terms to leave out."""
        return place[0] != "define" or place[1] in self.spec.named_order

    def _where(self, place: Place) -> str:
        key, name = place
        if key in ("constraints", "holonomic"):
            equations = self.spec.constraints if key == "constraints" else self.spec.holonomic
            name = equations[int(name.split()[0])].name
        return f"`{key}.{name}`" if name else f"`{key}`"

    def _terms(self, place: Place, tree: Syntax) -> list[tuple[Syntax, bool]]:
        terms = list(list_terms(tree, place[0] in ("U", "V", "forces", "constraints", "holonomic")))
        if place[0] in ("constraints", "holonomic"):
            other = self.trees[place[0], _other_side(place[1])]
            if is_zero(other) and len(list(_sum(tree))) < 2:  # without it nothing would be constrained
                terms = [(node, minus) for node, minus in terms if node is not next(_sum(tree))]
        return terms

    def _limits(self, start: Start) -> list[Candidate]:
        spec = self.spec
        turned = {name for rotation in spec.rotations for name in rotation.coordinates}
        kept = {need.name.removesuffix("'") for need in self.scene.need if need.kind in ("coordinate", "velocity")}
        taken = {*(c.name for c in spec.coordinates), *(p.name for p in spec.parameters)}
        taken |= {d.name for d in (*spec.definitions, *spec.quasi_velocities, *spec.outputs)}
        found = []
        for coordinate, q, v in zip(spec.coordinates, start.q, start.v, strict=True):
            if coordinate.name not in kept | turned and len(spec.coordinates) > 1:
                found += hold(coordinate.name, taken, q, v)
        return found

    def change(self, gone: Iterable[Candidate]) -> Changed:
        """All expressions without some candidates."""
        taken = expand(gone)
        limits = tuple(c for c in taken if c.takes_coordinate)
        model, question = self._rewrite(taken), self._rewrite(limits) if limits else dict(self.trees)
        definitions = {name: tree for (key, name), tree in question.items() if key == "define"}
        shown = reach(
            set(self.shown) | {n for (key, _), tree in question.items() if key in FOLLOWING for n in names_in(tree)},
            definitions,
        )
        copies: dict[str, str] = {}
        names = {name for _, name in self.trees} | {p.name for p in self.spec.parameters}
        while True:  # a definition that uses one that has a copy has one itself
            new = [
                name
                for name in definitions
                if name in shown
                and name not in copies
                and (
                    not same(model["define", name], definitions[name])
                    or any(n in copies for n in names_in(model["define", name]))
                )
            ]
            if not new:
                break
            copies.update((name, _fresh(f"{name}_model", names)) for name in new)
        trees, copied = {}, {}
        for place, tree in model.items():
            renamed = rename(tree, copies)
            if place[0] in FOLLOWING:
                trees[place] = question[place]
            elif place[0] == "define" and place[1] in copies:
                trees[place], copied[place[1]] = question[place], renamed
            else:
                trees[place] = renamed
        return Changed(trees, copies, copied, taken)

    def _rewrite(self, taken: Sequence[Candidate]) -> dict[Place, Syntax]:
        """Every tree with the candidates put in; definitions that come to stand still or vanish do so in what uses them, too."""
        still = {*(p.name for p in self.spec.parameters), "pi", *(n for c in taken for n in (c.start, c.rate) if n)}
        none: set[str] = set()

        def swap(node: Syntax) -> Syntax | None:
            if isinstance(node, Name) and node.name in none:
                return ZERO
            return next((new for c in taken if (new := c.swap(node)) is not None), None)

        made: dict[Place, Syntax] = {}
        moving = {c.name for c in self.spec.coordinates} - {c.name for c in taken if c.kind == "held"} | {"t"}
        for place, tree in self._in_order():
            made[place] = replace_parts(tree, swap, still)
            if place[0] in ("define", "quasi_velocities"):
                if is_zero(made[place]) and not is_zero(tree):
                    none.add(place[1])
                elif not any(n in moving or n not in still for n in names_in(made[place])):
                    still.add(place[1])
        return {place: made[place] for place in self.trees}

    def _in_order(self) -> Iterator[tuple[Place, Syntax]]:
        """Definitions and quasi-velocities before what uses them; those that nhc makes of a rotation first of all."""
        made = [name for key, name in self.trees if key in ("define", "quasi_velocities")]
        for name in dict.fromkeys([*(n for n in made if n not in self.spec.named_order), *self.spec.named_order]):
            for key in ("define", "quasi_velocities"):
                if (key, name) in self.trees:
                    yield (key, name), self.trees[key, name]
        for place, tree in self.trees.items():
            if place[0] not in ("define", "quasi_velocities"):
                yield place, tree


def number_twins(candidates: Sequence[Candidate]) -> list[Candidate]:
    """The candidates, those with the same words told apart by their number."""
    seen: dict[str, int] = {}
    found = []
    for candidate in candidates:
        number = seen[candidate.about] = seen.get(candidate.about, 0) + 1
        found.append(
            candidate if number == 1 else replace(candidate, about=f"{candidate.about} (number {number} there)")
        )
    return found


def draft_of(source: Source, scene: Scene, changed: bool = False) -> Draft:
    """The draft of a spec that decodes, for one of its scenes; ``changed``: it has other values than the spec gives it.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
    """
    spec = decode(source)
    bag = Bag(source)
    read = read_nodes(source, bag)
    bag.raise_if_errors()
    assert isinstance(read, Table)
    trees: dict[Place, Syntax] = {("T", ""): spec.kinetic}
    if spec.potential is not None:
        trees[spec.potential_kind, ""] = spec.potential
    trees.update((("define", d.name), d.value) for d in spec.definitions)
    trees.update((("forces", d.name), d.value) for d in spec.forces)
    for k, constraint in enumerate(spec.constraints):
        trees["constraints", f"{k} left"], trees["constraints", f"{k} right"] = constraint.left, constraint.right
    for k, holonomic in enumerate(spec.holonomic):
        trees["holonomic", f"{k} left"], trees["holonomic", f"{k} right"] = holonomic.left, holonomic.right
    trees.update((("quasi_velocities", d.name), d.value) for d in spec.quasi_velocities)
    trees.update((("outputs", d.name), d.value) for d in spec.outputs)
    shown = {name for figure in spec.draw for tree in figure.expressions for name in names_in(tree)}
    shown |= {name for entry in scene.initial for name in names_in(entry.value)}
    root = without_bodies(merge_bases(source, read, bag), bag).root
    return Draft(spec, scene, with_scene(root, scene) if changed else root, trees, frozenset(shown))


def _other_side(side: str) -> str:
    index, name = side.split()
    return f"{index} {'right' if name == 'left' else 'left'}"


def _fresh(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    taken.add(name)
    return name


def _sum(tree: Syntax) -> Iterator[Syntax]:
    """The terms of a sum at the top of a tree."""
    stack = [tree]
    while stack:
        node = stack.pop()
        if isinstance(node, Binary) and node.op in "+-":
            stack += [node.right, node.left]
        elif isinstance(node, Negate):
            stack.append(node.operand)
        else:
            yield node


def rename(tree: Syntax, names: Mapping[str, str]) -> Syntax:
    """The tree with other names."""
    if not names:
        return tree
    return replace_parts(
        tree, lambda n: Name(names[n.name], n.span) if isinstance(n, Name) and n.name in names else None
    )


def reach(start: set[str], definitions: Mapping[str, Syntax]) -> set[str]:
    """The names and all that their definitions use."""
    found, stack = set(start), sorted(start)
    while stack:
        name = stack.pop()
        for other in names_in(definitions[name]) if name in definitions else ():
            if other not in found:
                found.add(other)
                stack.append(other)
    return found
