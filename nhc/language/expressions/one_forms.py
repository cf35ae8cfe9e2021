"""Constraints that are written with differentials: each must be a 1-form, one differential in every term."""

from __future__ import annotations

from collections.abc import Mapping

from nhc.diagnostics import Bag, Label
from nhc.language.expressions.names import TIME
from nhc.language.expressions.syntax import (
    Binary,
    Call,
    Differential,
    Name,
    Negate,
    Number,
    Prime,
    Syntax,
    fold_tree,
    walk,
)

_ANY = -1  # of a zero, which is a form of each degree
_NONE = -2  # of what has been reported
_EACH = "each term of such a constraint has one differential as a factor: `dz - y*dx - c*dt = 0`"


def check_form(left: Syntax, right: Syntax, known: Mapping[str, bool], bag: Bag) -> str:
    """Return the form of a constraint, "velocity" or "differential"; report one that mixes them, or is no 1-form.

    ``known`` says of the names of ``define`` and ``quasi_velocities`` whether they hold velocities.
    """
    form: Differential | None = None
    velocity: Syntax | None = None
    for side in (left, right):
        for node in walk(side):
            if isinstance(node, Differential):
                form = form or node
            elif isinstance(node, Prime) or (isinstance(node, Name) and known.get(node.name, False)):
                velocity = velocity or node
    if form is None:
        return "velocity"
    if velocity is not None:
        label = Label(velocity.span, "a velocity")
        help = "write the whole constraint with velocities, or with differentials (`dt` for the free term)"
        message = "a constraint mixes differentials with velocities"
        bag.error("E0209", message, form.span, "a differential", labels=(label,), help=(help,))
        return "differential"
    degrees = _Degrees(bag)
    for side in (left, right):
        degrees.refuse_constant(side, degrees.of(side))
    return "differential"


class _Degrees:
    """How many differentials are factors of each term: 0, 1, ``_ANY`` or ``_NONE``.

    What has more of them, or has them elsewhere, is reported.
    """

    def __init__(self, bag: Bag) -> None:
        self.bag = bag

    def of(self, tree: Syntax) -> int:
        return fold_tree(tree, self._visit)

    def refuse_constant(self, tree: Syntax, degree: int) -> None:
        """Report a term without a differential where one is due."""
        if degree == 0:
            help = f"multiply it by `dt` if it is a velocity's share; {_EACH}"
            self.bag.error("E0209", "this term of a 1-form has no differential", tree.span, help=(help,))

    def _visit(self, node: Syntax, parts: tuple[int, ...]) -> int:
        match node:
            case Differential():
                return 1
            case Number():
                return 0 if node.value else _ANY
            case Negate():
                return parts[0]
            case _ if _NONE in parts:
                return _NONE
            case Binary() if node.op in "+-":
                return self._sum(node, parts)
            case Binary() if node.op == "*" and 1 in parts:
                return self._refuse(node, "a product of differentials is no 1-form") if parts == (1, 1) else 1
            case Binary() if node.op == "/" and parts[0] == 1 and parts[1] != 1:
                return 1
            case Binary() if 1 in parts:
                if node.op == "^":
                    return self._refuse(node, "a power with a differential is no 1-form")
                found = next((part for part in walk(node.left) if isinstance(part, Differential)), None)
                help = "a constraint on velocities is written with a prime: `x' - y*z' = 0`"
                if found and found.name != TIME and isinstance(node.right, Differential) and node.right.name == TIME:
                    help = f"write `{found.name}'` in place of `d{found.name}/dt`"
                return self._refuse(node, "a quotient by a differential is no 1-form", help)
            case Call() if 1 in parts:
                return self._refuse(node, f"`{node.function}` of a differential is no 1-form")
            case _:
                return _ANY if _ANY in parts else 0

    def _sum(self, node: Binary, parts: tuple[int, ...]) -> int:
        if 1 in parts:
            for tree, degree in zip((node.left, node.right), parts, strict=True):
                self.refuse_constant(tree, degree)
            return 1
        return max(parts)

    def _refuse(self, node: Syntax, message: str, help: str = _EACH) -> int:
        self.bag.error("E0209", message, node.span, help=(help,))
        return _NONE
