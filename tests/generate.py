"""Random specs that are valid by construction, in many styles of writing.

Regular by construction: T is a sum of squares of n forms with a unit lower triangle (so its matrix is positive), the rows of the
constraints hold a unit block in the dependent velocities, the quasi-velocities one in the others.  Positions that a holonomic
constraint determines are functions that vanish at the origin at t = 0, so that a scene may start there.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field

COORDINATES = (
    *("x", "y", "z", "theta", "phi", "psi", "s", "r1", "q_2", "u", "alpha", "beta2"),
    *(
        "θ",
        "φ1",
        "ψ",
        "α",
        "β",
        "δx",
        "Ω",
        "ξ",
        "é",
        "lambda",
        "I",
        "E",
        "double",
        "class",
        "y0",
        "j1",
        "None",
        "N",
        "p",
        "dydt",
    ),
)
PARAMETERS = (
    "m",
    "J",
    "a",
    "b",
    "k",
    "c",
    "g",
    "μ",
    "κ_1",
    "int",
    "gamma",
    "status",
    "R",
    "ell",
    "I_zz",
    "self",
    "scale",
)
NAMED = (
    "w",
    "v1",
    "X",
    "Y",
    "Z",
    "vx",
    "vy",
    "h",
    "A1",
    "B1",
    "f_1",
    "χ",
    "e1",
    "e2",
    "count",
    "sum",
    "math",
    "main",
    "out",
    "NULL",
)
FREE = ("w_1", "w_2", "w_3", "w_4", "w_5")
FOLDED = {
    "θ": "theta",
    "φ1": "phi1",
    "ψ": "psi",
    "α": "alpha",
    "β": "beta",
    "δx": "deltax",
    "Ω": "Omega",
    "ξ": "xi",
    "é": "é",
}


@dataclass
class Writer:
    """The choices of one spec; ``q`` are coordinates as they are written, ``free`` and ``bound`` split their indices."""

    rng: random.Random
    n: int
    q: list[str] = field(default_factory=list)
    parameters: list[str] = field(default_factory=list)
    define: list[tuple[str, str]] = field(default_factory=list)
    bound: list[int] = field(default_factory=list)
    free: list[int] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    timed: bool = False
    over: list[int] = field(default_factory=list)  # the coordinates that functions contain

    # --- pieces -------------------------------------------------------------------------------------------

    def number(self) -> str:
        return self.rng.choice(("0.3", "0.7", "1.2", "1/3", "2/5", "0.25", "3e-1", "0.45", "1.1"))

    def sign(self) -> str:
        return self.rng.choice(("", "-"))

    def velocity(self, i: int) -> str:
        name = self.q[i]
        forms = [f"{name}'", f"dot({name})"]
        if name.isascii():
            forms.append(f"{name}dot")
        return self.rng.choice(forms)

    def angle(self, over: list[int]) -> str:
        a, b = self.q[self.rng.choice(over)], self.q[self.rng.choice(over)]
        forms = [a, a, f"2*{a}", f"{a} - {b}", f"{a}/2 + {b}"]
        if self.timed:
            forms += ["t", f"{a} + 0.5*t"]
        return self.rng.choice(forms)

    def function(self, over: list[int]) -> str:
        """A bounded, smooth function of some coordinates (and of t where the spec moves), as a factor."""
        c, angle = self.coefficient(), self.angle(over)
        a, b = self.q[self.rng.choice(over)], self.q[self.rng.choice(over)]
        forms = (
            *(
                c,
                f"{c}*sin({angle})",
                f"{c}*cos({angle})",
                f"{c}*{a}",
                f"({self.sign()}{c}*cos({angle}) + {self.number()}*{a})",
            ),
            *(f"{c}*{a}*cos({b})", f"{c}/(2 + cos({angle}))", f"{c}*{a}*{b}", f"{c}*tanh({a})", f"{c}*exp(-{a}^2)"),
            *(
                f"{c}*sqrt(1 + {a}**2)",
                f"{c}*sin({a})*cos({b})",
                f"{c}*atan({angle})",
                f"{c}*sin({a})^2",
                f"({a} + {c})^3/5",
            ),
        )
        return self.rng.choice(forms)

    def positive(self, over: list[int]) -> str:
        """A function that has no zero."""
        return f"(2 + cos({self.angle(over)}))"

    def coefficient(self) -> str:
        if self.parameters and self.rng.random() < 0.4:
            return self.rng.choice(self.parameters)
        return self.number()

    def vanishing(self, over: list[int]) -> str:
        """A function that is 0 at the origin at t = 0."""
        if not over:
            return "0.3*sin(t)"
        a, b, c = self.q[self.rng.choice(over)], self.q[self.rng.choice(over)], self.coefficient()
        forms = [f"{c}*sin({a})", f"{c}*{a}^2 + {b}", f"{c}*(1 - cos({a} - {b}))", f"{c}*{a}*{b} - 0.2*{a}"]
        if self.timed:
            forms.append(f"{c}*sin({a}) - 0.4*t^2")
        return self.rng.choice(forms)

    def name(self, value: str, wish: float = 0.5) -> str:
        """The text itself in parentheses, or a new name of ``define`` for it."""
        if not self.names or self.rng.random() > wish:
            return f"({value})"
        name = self.names.pop()
        self.define.append((name, value))
        return name

    # --- forms --------------------------------------------------------------------------------------------

    def triangular(self, lead: int, others: list[int]) -> str:
        """q_lead' + sum f_j q_j' + f_0."""
        rng, everything = self.rng, self.over
        if rng.random() < 0.35:  # the velocity of a position
            terms = [self.q[lead], *(self.vanishing([j]) for j in others if j in everything and rng.random() < 0.6)]
            if self.timed and rng.random() < 0.5:
                terms.append("0.2*sin(t)")
            position = " + ".join(terms)
            made = self.name(position, 0.7)
            return f"{made}'" if rng.random() < 0.7 else f"dot{made if made.startswith('(') else f'({made})'}"
        terms = [self.velocity(lead)]
        terms += [f"{self.function(everything)}*{self.velocity(j)}" for j in others if rng.random() < 0.7]
        if rng.random() < 0.25:
            terms.append(self.function(everything))
        rng.shuffle(terms)
        return " + ".join(terms)

    def kinetic(self) -> str:
        rng, order, everything = self.rng, list(range(self.n)), self.over
        rng.shuffle(order)
        terms = []
        for k, lead in enumerate(order):
            form = self.name(self.triangular(lead, order[:k]))
            mass = rng.choice((*self.parameters, "1.5", f"(2 + sin({self.q[rng.choice(everything)]}))"))
            terms.append(rng.choice((f"{mass}/2*{form}^2", f"0.5*{mass}*{form}**2", f"{mass}*{form}*{form}/2")))
        if rng.random() < 0.5:
            form = self.name(self.triangular(rng.choice(order), order))
            terms.append(f"0.4*{form}^2")
        if rng.random() < 0.4:
            terms.append(f"{self.function(everything)}*{self.velocity(rng.choice(order))}")
        if rng.random() < 0.3:
            terms.append(self.function(everything))
        return " + ".join(terms)

    def constraint(self, lead: int, differential: bool) -> str:
        """Left and right side of a row with a unit at ``lead`` and functions at the free velocities."""
        rng, everything = self.rng, self.over

        def rate(i: int) -> str:
            return f"d{self.q[i]}" if differential else self.velocity(i)

        terms = [f"{self.function(everything)}*{rate(j)}" for j in self.free if rng.random() < 0.75]
        if rng.random() < 0.3:
            terms.append(f"{self.function(everything)}*dt" if differential else self.function(everything))
        if not differential and rng.random() < 0.2 and terms:
            terms[0] = self.name(terms[0], 0.8)
        right = " + ".join(terms) or "0"
        if rng.random() < 0.5:
            return f"{rate(lead)} = {right}"
        factor = rng.choice(("", "2*", f"{self.positive(everything)}*"))
        return f"{factor}({rate(lead)} - ({right})) = 0"


def write_spec(rng: random.Random, system: str, n: int = 0) -> str:
    """A random valid spec of ``n`` coordinates (1 to 5 by default)."""
    n = n or rng.randint(1, 5)
    w = Writer(rng, n, timed=rng.random() < 0.5)
    _take_names(w)
    count = rng.randint(0, n - 1)
    order = list(range(n))
    rng.shuffle(order)
    w.bound, w.free = sorted(order[:count]), sorted(order[count:])
    w.over = w.free if rng.random() < 0.35 else list(range(n))  # the first: Čaplygin's hypotheses may hold
    lines = ["nhc: 1", f"system: {system}", "about: 'made by chance: {{ }} << >> \\ % $ _ ^'"]
    sections = {"coordinates": _coordinates(w), "parameters": _parameters(w)}
    sections["T"] = f"T: {_quote(w.kinetic())}"
    sections["potential"] = _potential(w)
    sections["forces"] = _forces(w)
    constraints, holonomic, positions = _constraints(w)
    sections["constraints"], sections["holonomic"] = constraints, holonomic
    quasi = _quasi(w)
    sections["quasi"] = "\n".join(["quasi_velocities:", *(f"  {k}: {_quote(v)}" for k, v in quasi)]) if quasi else ""
    if w.bound and rng.random() < 0.4:
        sections["dependent"] = f"dependent: [{', '.join(w.q[i] for i in w.bound)}]"
    outputs = _outputs(w, [k for k, _ in quasi])
    sections["outputs"] = outputs
    sections["define"] = "\n".join(["define:", *(f"  {k}: {_quote(v)}" for k, v in w.define)]) if w.define else ""
    sections["scenes"] = _scenes(w, positions)
    bodies = [text for text in sections.values() if text]
    rng.shuffle(bodies)
    return "\n".join([*lines, *bodies]) + "\n"


def _take_names(w: Writer) -> None:
    taken: set[str] = set()

    def take(pool: tuple[str, ...], count: int) -> list[str]:
        found = []
        for name in w.rng.sample(pool, len(pool)):
            folded = FOLDED.get(name, name)
            if len(found) < count and folded not in taken:
                taken.add(folded)
                found.append(name)
        return found

    w.q = take(COORDINATES, w.n)
    w.parameters = take(PARAMETERS, w.rng.randint(0, 4))
    w.names = take(NAMED, 8)


def _quote(text: str) -> str:
    return f'"{text}"'


def _coordinates(w: Writer) -> str:
    if w.rng.random() < 0.6:
        return f"coordinates: [{', '.join(_quote(name) for name in w.q)}]"
    return "\n".join(["coordinates:", *(f'  {_quote(name)}: {{about: "*/ \\\\ {{{{ }}}}"}}' for name in w.q)])


def _parameters(w: Writer) -> str:
    if not w.parameters:
        return ""
    values = (
        f"  {_quote(name)}: {w.rng.choice(('1.3', '0.8', '{value: 0.6, about: what}', 'pi/4', '2'))}"
        for name in w.parameters
    )
    return "\n".join(["parameters:", *values])


def _potential(w: Writer) -> str:
    if w.rng.random() < 0.25:
        return ""
    terms = [w.function(w.over) for _ in range(w.rng.randint(1, 3))]
    return f"{w.rng.choice('UV')}: {_quote(' + '.join(terms))}"


def _forces(w: Writer) -> str:
    rows = []
    for i in range(w.n):
        if w.rng.random() < 0.4:
            form = w.rng.choice(("{f}", "-0.1*{v}", "{f}*{v} - 0.05*{v}^3", "0.2*sin(t) - 0.1*{v}"))
            rows.append(f"  {_quote(w.q[i])}: {_quote(form.format(f=w.function(w.over), v=w.velocity(i)))}")
    return "\n".join(["forces:", *rows]) if rows else ""


def _constraints(w: Writer) -> tuple[str, str, bool]:
    """The two sections, and whether positions are bound."""
    rows, held = [], []
    for k, lead in enumerate(w.bound):
        if w.rng.random() < 0.2:
            text = f"{w.q[lead]} = {w.vanishing(w.free)}"
            held.append(f"  - {_quote(text)}" if w.rng.random() < 0.5 else f"  - held{k}: {_quote(text)}")
            continue
        text = w.constraint(lead, w.rng.random() < 0.4)
        rows.append(f"  - {_quote(text)}" if w.rng.random() < 0.5 else f"  - row{k}: {_quote(text)}")
    first = "\n".join(["constraints:", *rows]) if rows else ""
    second = "\n".join(["holonomic:", *held]) if held else ""
    return first, second, bool(held)


def _quasi(w: Writer) -> list[tuple[str, str]]:
    if w.rng.random() < 0.4:
        return []
    order = list(w.free)
    w.rng.shuffle(order)
    forms = []
    for k, lead in enumerate(order):
        terms = [w.velocity(lead), *(f"{w.function(w.over)}*{w.velocity(j)}" for j in order[:k])]
        if w.rng.random() < 0.2:
            terms.append(w.function(w.over))
        forms.append((FREE[k], " + ".join(terms)))
    fewer = w.bound and w.rng.random() < 0.2
    return forms[:-1] if fewer else forms


def _outputs(w: Writer, quasi: list[str]) -> str:
    rows = [f"  out_1: {_quote('T + ' + w.function(w.over))}"]
    if quasi:
        rows.append(f"  out_2: {_quote(f'{quasi[0]}*' + w.velocity(0))}")
    rows.append("  energy2: energy")
    return "\n".join(["outputs:", *rows]) if w.rng.random() < 0.7 else ""


def _scenes(w: Writer, positions: bool) -> str:
    if w.rng.random() < 0.3:
        return ""
    start = []
    for i in range(w.n):
        if not positions and w.rng.random() < 0.7:
            start.append(f"{_quote(w.q[i])}: {w.rng.choice(('0.2', '-0.3', 'pi/10', '0'))}")
    start += [f'"{w.q[i]}\'": {w.rng.choice(("0.5", "-0.4", "1e-1"))}' for i in w.free]
    need = "" if w.rng.random() < 0.5 else "\n    need: [energy]"
    return f"scenes:\n  first:\n    initial: {{{', '.join(start)}}}\n    time: [0, 1]{need}\n    tolerance: 1e-6"
