"""Small programs made by hand for the tests of the back ends; nothing here goes through a spec."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from nhc.program.ir import (
    Argument,
    Binary,
    Call,
    Expr,
    Function,
    Guard,
    Let,
    Load,
    Negate,
    Number,
    Origin,
    Power,
    Program,
    Quantity,
    Ref,
    Result,
    SceneData,
    Section,
    Solve,
    Statement,
    Store,
)


@dataclass(frozen=True)
class E:
    """An expression that Python's operators build."""

    node: Expr

    def __add__(self, other: E | float) -> E:
        return E(Binary("+", self.node, wrap(other).node))

    def __sub__(self, other: E | float) -> E:
        return E(Binary("-", self.node, wrap(other).node))

    def __mul__(self, other: E | float) -> E:
        return E(Binary("*", self.node, wrap(other).node))

    def __truediv__(self, other: E | float) -> E:
        return E(Binary("/", self.node, wrap(other).node))

    def __neg__(self) -> E:
        return E(Negate(self.node))

    def __pow__(self, exponent: int) -> E:
        return E(Power(self.node, exponent))


def wrap(value: E | float) -> E:
    """A number as an expression."""
    return value if isinstance(value, E) else E(Number(Fraction(value)))


def ref(name: str) -> E:
    return E(Ref(name))


def call(function: str, *arguments: E | float) -> E:
    return E(Call(function, tuple(wrap(argument).node for argument in arguments)))


def let(name: str, value: E, equation: str = "", place: str = "") -> Let:
    return Let(name, value.node, Origin(equation, place))


def store(array: str, index: int, value: E | float, about: str = "") -> Store:
    return Store(array, index, wrap(value).node, about)


T, Y, P = Argument("t", -1), "y", "p"


def function(
    name: str,
    body: tuple[Statement, ...],
    sizes: tuple[int, int],
    output: tuple[str, int] | None,
    inputs: tuple[Argument, ...] = (),
) -> Function:
    """``sizes`` are those of y and p; ``inputs`` replaces the usual (t, y, p)."""
    usual = (T, Argument("y", sizes[0]), Argument("p", sizes[1]))
    target = None if output is None else Argument(*output)
    return Function(name, f"the {name} of the model", inputs or usual, target, body, "I.2.15", 3, 2, 1, 1)


def loads(array: str, *names: str) -> tuple[Load, ...]:
    return tuple(Load(name, array, index, f"{name} [m]") for index, name in enumerate(names))


def quantities(*names: str) -> tuple[Quantity, ...]:
    return tuple(Quantity(name, "m", f"about {name}") for name in names)


def make_oscillator() -> Program:
    """x'' = -k x with the closed solution x = cos(t) for k = 1; no constraint, no output, ``t`` read by nobody."""
    state = loads("y", "x", "x_dot")
    sizes = (2, 1)
    half = wrap(0.5)
    energy = half * ref("x_dot") ** 2 + half * ref("k") * ref("x") ** 2
    functions = (
        function(
            "rhs",
            (*state, *loads("p", "k"), store("dydt", 0, ref("x_dot"), "x'"), store("dydt", 1, -(ref("k") * ref("x")))),
            sizes,
            ("dydt", 2),
        ),
        function("velocities", (*state, store("qdot", 0, ref("x_dot"))), sizes, ("qdot", 1)),
        function("residuals", (), sizes, ("r", 0), (T, Argument("q", 1), Argument("qdot", 1), Argument("p", 1))),
        function("reactions", (), sizes, ("lambda", 0)),
        function("energy", (*state, *loads("p", "k"), Result(energy.node)), sizes, None),
        function("jacobian", (*loads("p", "k"), store("J", 1, 1.0), store("J", 2, -ref("k"))), sizes, ("J", 4)),
        function("outputs", (), sizes, ("out", 0)),
    )
    scene = SceneData("swing", "one period", (1.0, 0.0), (1.0,), (0.0, 6.5), ("x", "x'", "energy"), 1e-11)
    other = SceneData("rest", "", (0.0, 0.0), (4.0,), (1.0, 2.0), (), 1e-8)
    parameter = Quantity("k", "1/s^2", "stiffness", Fraction(1))
    return Program(
        "oscillator", "A mass on a spring.", "lagrange", "I.2.3", "no constraints", quantities("x"),
        quantities("x", "x'"), (parameter,), (), (), functions, (scene, other),
    )  # fmt: skip


def make_sleigh() -> Program:
    """The Chaplygin sleigh in quasi-velocities: guards, hoisted work, reserved names (x, y, p, I, l, lambda)."""
    state = (*loads("y", "x", "y", "theta", "v", "w"), Load("t", "t", -1))
    parameters = loads("p", "m", "I", "lambda")
    hoisted = (
        Section("from the parameters alone"),
        let("J", ref("I") + ref("m") * ref("lambda") ** 2, "I.2.15", "sleigh.yaml:4:1"),
        Guard(ref("J").node, (call("abs", ref("I")) + ref("m")).node, 1e-12, 1, "the moment of inertia is singular"),
    )
    body = (
        *state,
        *parameters,
        *hoisted,
        Section("kinematics", Origin("I.2.1", "sleigh.yaml:9:1")),
        let("c", call("cos", ref("theta"))),
        let("s1", call("sin", ref("theta"))),
        let("unused", ref("c") + 1.0),
        Guard(ref("m").node, Number(Fraction(1)), 0.0, 2, "the mass vanishes"),
        Guard((ref("w") - 7.0).node, (ref("w") ** 2 + 1.0).node, 1e-9, 3, "w is seven"),
        store("dydt", 0, ref("v") * ref("c"), "x'"),
        store("dydt", 1, ref("v") * ref("s1"), "y'"),
        store("dydt", 2, ref("w"), "theta'"),
        store("dydt", 3, ref("lambda") * ref("w") * ref("w"), "v'"),
        store("dydt", 4, -(ref("m") * ref("lambda") / ref("J") * ref("v") * ref("w")) + ref("t") * 0.0, "w'"),
    )
    sizes = (5, 3)
    velocities = (
        *loads("y", "x", "y", "theta", "v", "w"),
        store("qdot", 0, ref("v") * call("cos", ref("theta"))),
        store("qdot", 1, ref("v") * call("sin", ref("theta"))),
        store("qdot", 2, ref("w")),
    )
    reactions = (
        *loads("y", "x", "y", "theta", "v", "w"),
        *parameters,
        store("lambda", 0, ref("m") * ref("v") * ref("w")),
    )
    outputs = (*loads("y", "x", "y", "theta", "v", "w"), store("out", 0, call("log", ref("v"))))
    energy = (
        *loads("y", "x", "y", "theta", "v", "w"),
        *parameters,
        Guard(ref("m").node, Number(Fraction(1)), 0.0, 2, "the mass vanishes"),
        Result(
            (wrap(0.5) * (ref("m") * ref("v") ** 2 + (ref("I") + ref("m") * ref("lambda") ** 2) * ref("w") ** 2)).node
        ),
    )
    functions = (
        function("rhs", body, sizes, ("dydt", 5)),
        function("velocities", velocities, sizes, ("qdot", 3)),
        function("reactions", reactions, sizes, ("lambda", 1)),
        function("outputs", outputs, sizes, ("out", 1)),
        function("energy", energy, sizes, None),
    )
    scene = SceneData(
        "glide", "starts straight", (0.0, 0.0, 0.1, 1.0, 0.5), (1.0, 0.3, 0.25), (0.0, 20.0),
        ("y", "theta'", "v", "lnv", "reactions", "energy"), 1e-9,
    )  # fmt: skip
    given = (
        Quantity("m", "kg", "mass", Fraction(1)),
        Quantity("I", "", "", Fraction(3, 10)),
        Quantity("lambda", "m", "offset", None),
    )
    return Program(
        "sleigh", "A rigid body on a knife edge.", "euler-lagrange", "I.2.15", "cheapest",
        quantities("x", "y", "theta"), quantities("x", "y", "theta", "v", "w"), given, quantities("slip"),
        quantities("lnv"), functions, (scene,), ("a note",),
    )  # fmt: skip


def make_solver(size: int = 3, band: int = 99) -> Program:
    """A linear system with two right sides whose matrix needs pivoting: its diagonal is y, zero at the start.

    Entries farther than ``band`` from the diagonal are zero.
    """
    names = tuple(f"u{i}" for i in range(size))
    matrix = tuple(
        tuple(
            (ref(names[i]) if i == j else wrap(1.0 / (1 + i + j) if abs(i - j) <= band else 0.0)).node
            for j in range(size)
        )
        for i in range(size)
    )
    columns = (
        tuple(wrap(float(i + 1)).node for i in range(size)),
        tuple(call("sin", ref(names[i])).node for i in range(size)),
    )
    found = tuple(tuple(f"{letter}_{i}" for i in range(size)) for letter in "ab")
    solve = Solve(matrix, columns, found, 1e-13, 1, "the mass matrix is singular")
    stores = tuple(store("dydt", i, ref(f"a_{i}") + ref(f"b_{i}") if i else ref("a_0")) for i in range(size))
    rhs = function("rhs", (*loads("y", *names), solve, *stores), (size, 0), ("dydt", size))
    return Program("solver", "", "multipliers", "", "", quantities(*names), quantities(*names), (), (), (), (rhs,))


def make_calculator() -> Program:
    """Every function and operation of the IR, one per output, of two numbers."""
    a, b = ref("a"), ref("b")
    unary = ("sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs", "sign")
    values = [call(name, a) for name in unary]
    values += [call(name, a, b) for name in ("atan2", "min", "max", "pow")]
    values += [call("min", a, b, wrap(0.25)), call("max", b, a, wrap(0.25))]
    values += [
        a - (b - a),
        a - (b + a),
        a / (b / a),
        a / (b * a),
        -(a + b),
        -(a * b),
        E(Negate(Negate(a.node))),
        a - -b,
        a + -(b * a),
    ]
    values += [a * -b, (-a) ** 2, -(a**2), (a + b) ** 3, a**-2, wrap(-2.0) ** 3 * a, call("sin", a) ** 2, a * (b * a)]
    values += [wrap(1e300) * 1e-300, E(Number(Fraction(1, 3))) - E(Number(Fraction(-1, 3))), wrap(10.0**22)]
    stores = tuple(store("out", i, value) for i, value in enumerate(values))
    names = tuple(f"out{i}" for i in range(len(values)))
    outputs = function("outputs", (*loads("y", "a", "b"), *stores), (2, 0), ("out", len(values)))
    return Program(
        "calculator", "", "newton", "", "", quantities("a"), quantities("a", "b"), (), (),
        quantities(*names), (outputs,),
    )  # fmt: skip


HOSTILE_TEXT = '*/ ??/ """ \' {{ 7*7 }} <<name>> <% raw %> \\N{BULLET} \\ \n# Čaplygin θ \u202e end\\'
HOSTILE_NAMES = (
    "double", "lambda", "y", "p", "t", "dydt", "count", "i", "bad", "gamma", "j0", "y1", "M_PI", "errno", "linux", "I",
    "l", "class", "None", "math", "float", "abs", "rhs", "y_", "lambda_", "s1", "n" * 80, "n" * 80 + "m", "hostile_rhs",
    "HOSTILE_NQ", "np", "shape", "__x", "E", "S", "error", "DEFAULTS", "status",
)  # fmt: skip


def make_hostile() -> Program:
    """Names that the languages reserve and texts that try to leave their comments."""
    size = len(HOSTILE_NAMES)
    origin = Origin("I.1 */", HOSTILE_TEXT)
    total = ref(HOSTILE_NAMES[0])
    for name in HOSTILE_NAMES[1:]:
        total = total * 0.5 + ref(name)
    body: tuple[Statement, ...] = (
        Section(HOSTILE_TEXT, origin),
        *(Load(name, "y", i, HOSTILE_TEXT) for i, name in enumerate(HOSTILE_NAMES)),
        Let("total", total.node, origin),
        Guard(ref("total").node, total.node, 1e-30, 1, HOSTILE_TEXT),
        *(Store("dydt", i, (ref("total") * float(i)).node, HOSTILE_TEXT, origin) for i in range(size)),
    )
    names = tuple(Quantity(name, HOSTILE_TEXT, HOSTILE_TEXT, Fraction(1)) for name in HOSTILE_NAMES)
    rhs = Function("rhs", HOSTILE_TEXT, (T, Argument("y", size), Argument("p", 0)), Argument("dydt", size), body)
    scene = SceneData("s", HOSTILE_TEXT, (0.0,) * size, (), (0.0, 1.0), (), 1e-6)
    return Program(
        "hostile", HOSTILE_TEXT, HOSTILE_TEXT, "", HOSTILE_TEXT, names[:3], names, (), names[:2],
        names[:1], (rhs,), (scene,), (HOSTILE_TEXT,),
    )  # fmt: skip


CASES = {
    program.system: program
    for program in (make_oscillator(), make_sleigh(), make_solver(), make_calculator(), make_hostile())
}
