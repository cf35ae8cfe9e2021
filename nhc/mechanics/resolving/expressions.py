"""Expressions of a spec as nodes: what its names mean, rates, and velocity forms."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from fractions import Fraction

from nhc.algebra.calculus import Derivation
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.nodes import NumberTooLong
from nhc.algebra.solving.linear import NotLinear, depends, is_clearly_linear, linear_form
from nhc.diagnostics import Bag, Span
from nhc.language import Spec
from nhc.language.expressions.numbers import DOUBLES
from nhc.language.expressions.syntax import Binary, Call, Differential, Name, Negate, Number, Prime, Syntax
from nhc.language.spec import Rotation
from nhc.mechanics.resolving.phases import Phases, known_pair, list_phases, split_turn
from nhc.mechanics.rotations import rotation as mechanics
from nhc.mechanics.system import Form

_LARGEST = Fraction(sys.float_info.max)
_LARGEST_EXPONENT = 2**53


class Resolver:
    """Builds nodes for one spec; ``names`` grows as definitions are read."""

    def __init__(self, spec: Spec, graph: Graph | None = None, phases: Phases | None = None) -> None:
        self._phases = phases
        self.spec, self.graph, self.bag = spec, graph if graph is not None else Graph(), Bag(spec.origin)
        g = self.graph
        self.t = g.symbol("t", "time")
        self.q = tuple(g.symbol(c.name, "coordinate") for c in spec.coordinates)
        self.v = tuple(g.symbol(c.name, "velocity") for c in spec.coordinates)
        self.p = tuple(g.symbol(c.name, "parameter") for c in spec.parameters)
        self.names: dict[str, Node] = {"t": self.t, "pi": g.pi()}
        self.names.update((c.name, node) for c, node in zip(spec.coordinates, self.q, strict=True))
        self.names.update((c.name, node) for c, node in zip(spec.parameters, self.p, strict=True))
        self._rates = {**dict(zip(self.q, self.v, strict=True)), self.t: g.one}
        self.rotations = tuple(self._rotation(rotation) for rotation in spec.rotations)
        self.derivation = Derivation(g, self._rates)

    def _rotation(self, declared: Rotation) -> mechanics.Rotation:
        """The nodes of a rotation, which take the places of what its names stand for in the spec."""
        g = self.graph
        places = [self.coordinate(name) for name in declared.coordinates]
        e, v = ([nodes[k] for k in places] for nodes in (self.q, self.v))
        made = mechanics.make_rotation(g, declared.name, places, 1 if declared.frame == "body" else -1, e, v)
        entries = [node for row in made.matrix for node in row]
        for name, node in zip((*declared.entries, *declared.velocities), (*entries, *made.omega), strict=True):
            self.names[name] = node
            g.labels.setdefault(node, name)
        self._rates.update(made.seeds(g, v))
        return made

    # --- expressions --------------------------------------------------------------------------------------

    def node(self, tree: Syntax, names: Mapping[str, Node] | None = None) -> Node:
        """The node of a syntax tree; a division by a constant zero is reported and stands as zero."""
        return self._build(tree, self.names if names is None else names)

    def _build(self, tree: Syntax, names: Mapping[str, Node]) -> Node:
        """Left operands by a loop, for sums are as deep as they are long; what else nests is bounded by the parser."""
        spine: list[Binary] = []
        while isinstance(tree, Binary):
            spine.append(tree)
            tree = tree.left
        result = self._operand(tree, names)
        while spine:
            part = spine.pop()
            right = self._build(part.right, names)
            try:
                result = self._binary(part, result, right)
            except NumberTooLong:
                moves = part.op == "^" and self.graph.deps[result]
                result = self._refuse_power(part) if moves else self._refuse_number(part)
            if not self.graph.deps[result]:
                result = self._check_constant(part, result)
        return result

    def _operand(self, part: Syntax, names: Mapping[str, Node]) -> Node:
        g = self.graph
        try:
            match part:
                case Name():
                    return names[part.name]
                case Number():
                    value = part.value
                    return g.number(value.numerator if value.denominator == 1 else value)
                case Prime():
                    return self._rate(self._build(part.operand, names))
                case Negate():
                    return g.neg(self._build(part.operand, names))
                case Differential():
                    return g.one if part.name == "t" else self._rate(names[part.name])
                case Call():
                    return self._call(part, [self._build(x, names) for x in part.arguments])
                case Binary():
                    return self._build(part, names)
        except NumberTooLong:
            return self._refuse_number(part)

    def _call(self, part: Call, operands: Sequence[Node]) -> Node:
        g = self.graph
        try:
            pair = self._turned(operands[0]) if part.function in ("sin", "cos", "tan") else None
            if pair is None:
                made = g.function(part.function, *operands)
            else:
                made = g.div(*pair) if part.function == "tan" else pair[part.function == "cos"]
        except ZeroDivisionError:  # tan is a quotient, and the only one
            help = "take an angle that is no odd quarter turn: the cosine is zero there"
            self.bag.error("E0417", f"`{part.function}` divides by zero here", part.span, help=(help,))
            return g.zero
        return made if g.deps[made] else self._check_constant(part, made)

    def _turned(self, angle: Node) -> tuple[Node, Node] | None:
        """Sine and cosine of an angle with a known part of a turn in it, from those of fewer angles."""
        base, turns = split_turn(self.graph, angle)
        if not turns:
            return None
        if self._phases is None:
            self._phases = _read_phases(self.spec)
        return known_pair(self.graph, base, turns, self._phases)

    def _refuse_number(self, part: Syntax, what: str = "too long to be written exactly") -> Node:
        self.bag.error("E0210", f"this constant is {what}", part.span, help=(DOUBLES,))
        return self.graph.one

    def _refuse_power(self, part: Syntax) -> Node:
        help = "leave numbers out of what is raised to a high power: u^n in place of (2*u)^n"
        self.bag.error(
            "E0210", "a number in this power is too long to be written exactly", part.span, help=(help, DOUBLES)
        )
        return self.graph.one

    def _check_constant(self, part: Syntax, node: Node) -> Node:
        """A constant must be a number that doubles hold; another is reported and stands as one."""
        g, exact = self.graph, self.graph.value(node)
        if exact is not None:
            if abs(exact) > _LARGEST:
                return self._refuse_number(part, "too large for a double")
            return self._refuse_number(part, "too small for a double") if exact and not float(exact) else node
        try:
            if math.isfinite(evaluate(g, [node], {})[0]):
                return node
        except (ArithmeticError, ValueError):
            pass
        help = "keep arguments where the function is real, and results below 1e308"
        self.bag.error("E0313", "this constant has no real, finite value", part.span, help=(help,))
        return g.one

    def _rate(self, node: Node) -> Node:
        g = self.graph
        rate = self.derivation.of(node)
        if node in g.labels and g.children(rate):
            g.labels.setdefault(rate, f"{g.labels[node]}_dot")
        g.rate_of.setdefault(rate, node)
        return rate

    def _binary(self, part: Binary, x: Node, y: Node) -> Node:
        g, op = self.graph, part.op
        if op == "*":
            return g.mul(x, y)
        if op == "+":
            return g.add(x, y)
        if op == "-":
            return g.sub(x, y)
        exponent = g.value(y)
        divides = op == "/" or (exponent is not None and exponent < 0)
        if divides and (exponent if op == "/" else g.value(x)) == 0:
            place = part.right.span if op == "/" else part.span
            self.bag.error(
                "E0417", "this divides by zero", place, help=("remove the division, or correct the divisor",)
            )
            return g.zero
        if op == "/":
            return g.div(x, y)
        if exponent is not None and abs(exponent) > _LARGEST_EXPONENT:
            help = "write an exponent below 2^53: doubles beyond are all even"
            self.bag.error("E0210", "this exponent is too large", part.right.span, help=(help,))
            return g.one
        if exponent is not None and exponent.denominator == 1 and abs(exponent) <= 1000:
            return g.power(x, int(exponent))
        if not g.deps[x] and g.deps[y] & g.mask((*self.q, *self.v, self.t)) and evaluate(g, [x], {})[0] <= 0.0:
            return self._refuse_base(part)
        return g.function("powf", x, y)

    def _refuse_base(self, part: Binary) -> Node:
        """The rate of a power with an exponent that varies holds the logarithm of its base."""
        help = "write a base that is positive: otherwise powers are real for some exponents only, and have no rate"
        self.bag.error("E0313", "a power of a constant that is not positive varies", part.span, help=(help,))
        return self.graph.one

    def coordinate(self, name: str) -> int:
        return next(i for i, c in enumerate(self.spec.coordinates) if c.name == name)

    def place(self, span: Span) -> str:
        origin = self.spec.origin
        (line, column), part = origin.position(span.start), origin.find(span.start)[0]
        return f"{line}:{column}" if part is origin else f"{part.path.rsplit('/', 1)[-1]}:{line}:{column}"

    # --- forms --------------------------------------------------------------------------------------------

    def form(self, name: str, node: Node, span: Span, code: str, what: str) -> Form:
        """A velocity form, or a diagnostic and a zero form in its place."""
        if is_clearly_linear(self.graph, node, self.v):
            return Form.written(name, node, self.graph, self.v, self.place(span))
        try:
            coefficients, constant = linear_form(self.graph, node, self.v)
        except NotLinear as error:
            symbol = self.graph.symbol_of(error.symbol)
            assert symbol is not None
            self.bag.error(
                code,
                f"{what} `{name}` is not linear in `{symbol.name}'`",
                span,
                help=(
                    f"write {what} as a sum of terms `a(q, t)*x'`; other relations between velocities are outside this theory",
                ),
            )
            constant = self.graph.zero
            coefficients = (self.graph.zero,) * len(self.q)
        g = self.graph
        value = g.add(g.dot(coefficients, self.v), constant)
        return Form(name, coefficients, constant, self.place(span), value=value)


def _read_phases(spec: Spec) -> Phases:
    """The phases of all angles of a spec, by a first reading of what moves it; mistakes are for the second one."""
    build = Resolver(spec, phases={})
    define_names(build)
    trees = [spec.kinetic, *(force.value for force in spec.forces)]
    trees += [spec.potential] if spec.potential is not None else []
    trees += [side for row in spec.constraints for side in (row.left, row.right)]
    trees += [side for held in spec.holonomic for side in (held.left, held.right)]
    for tree in trees:
        build.node(tree)
    g = build.graph
    return list_phases(g, [g.a[node] for node in range(len(g.op)) if g.op[node] in ("sin", "cos")])


def define_names(build: Resolver) -> None:
    """Add the definitions and quasi-velocities to what the resolver knows."""
    for name, value in build.spec.named_values:
        node = build.node(value)
        build.names[name] = node
        if build.graph.children(node):
            build.graph.labels.setdefault(node, name)


def tangent_slopes(graph: Graph, node: Node, symbols: Sequence[Node]) -> list[bool]:
    """For each symbol whether the node depends on it (exactly, not only by sight)."""
    seen = [s for s in symbols if graph.depends(node, graph.deps[s])]
    return [s in seen and depends(graph, [node], [s])[0] for s in symbols]
