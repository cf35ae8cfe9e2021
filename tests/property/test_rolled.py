"""Rolled code computes what straight code does: random chains with recursions both ways, odd bodies, sweeps.

A value that is read from a place where nothing has been left is an error, and so is a place that is written twice.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Mapping, Sequence

import pytest

from nhc.emit.c.rolled import roll
from nhc.emit.c.rolled.lines import Fetch, Leave, Line, Loop
from nhc.emit.c.rolled.whole import roll_function
from nhc.emit.statements import drop_unused
from nhc.program.ir import Binary, Call, Expr, Let, Load, Negate, Number, Ref, Statement, Store, Sweep
from tests.unit.emit_cases import E, call, let, ref, store

Members = dict[int, str]
"""By body."""


@pytest.fixture(autouse=True)
def always(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(roll, "WORTH", 9.0)


class Chain:
    """Random statements for ``bodies`` bodies; ``inputs`` name one entry for each, ``others`` are what ends and single places take.

    ``factors``: members of another chain's families, by which operands of this one are multiplied.
    """

    def __init__(
        self, draw: random.Random, name: str, bodies: int, inputs: Sequence[str], others: Sequence[str]
    ) -> None:
        self.draw, self.name, self.bodies = draw, name, bodies
        self.inputs, self.others = inputs, list(others)
        self.factors: list[Members] = []
        self.families: list[Members] = []
        self.lines: list[Statement] = []

    def write(self, output: str) -> tuple[Statement, ...]:
        """Families, single statements made of some members, and results of some families."""
        draw = self.draw
        for number in range(draw.randint(3, 9)):
            self.add_family(f"{self.name}{number}")
        shown = draw.sample(self.families, min(len(self.families), draw.randint(1, 3)))
        for place, members in enumerate(shown):
            for k, member in members.items():
                value = ref(member) if draw.random() < 0.03 else ref(member) - ref(self.others[0])
                self.lines.append(store(output, k * len(shown) + place, value))
        self.lines.append(store(output, self.bodies * len(shown), ref(self.others[-1])))
        return drop_unused(tuple(self.lines))

    def add_family(self, name: str) -> None:
        """A statement for most bodies, perhaps with the one before or behind, some of another kind."""
        draw, sign = self.draw, self.draw.choice((1, 1, -1, 0))
        takes = [self.choose() for _ in range(draw.randint(1, 3))]
        low, high = draw.choice((0, 0, 0, 1, 2)), self.bodies - draw.choice((0, 0, 0, 1, 2))
        members: Members = {}
        for k in range(low, high) if sign >= 0 else range(high - 1, low - 1, -1):
            value = takes[0](k)
            for take in takes[1:]:
                value = value + take(k) * 0.5
            if sign:
                value = value + self.at(members, k - sign) * 0.25
            if draw.random() < 0.06:
                value = -value - ref(self.others[0])
            members[k] = f"{name}x{k}"
            self.lines.append(let(members[k], value))
        self.families.append(members)
        if draw.random() < 0.5:
            one, other = (draw.choice(list(members.values())) for _ in range(2))
            self.lines.append(let(f"{name}s", ref(one) + ref(other) * 0.5))
            self.others += [f"{name}s", *([one] if draw.random() < 0.5 else [])]

    def at(self, members: Members, k: int) -> E:
        """A member, or beyond the ends something else."""
        return ref(members[k] if k in members else self.draw.choice(self.others))

    def choose(self) -> Callable[[int], E]:
        """How an operand is found of each body."""
        draw, ahead = self.draw, self.draw.choice((0, 0, 0, 1, -1, 2))
        kind, other = draw.random(), draw.choice(self.others)
        inputs = dict(enumerate(self.inputs))
        members = draw.choice(self.families) if self.families else inputs
        factor = draw.choice(self.factors) if self.factors else None
        last = draw.choice(list(factor.values())) if factor else ""

        def take(k: int) -> E:
            found = ref(other) if kind < 0.15 else self.at(inputs if kind < 0.4 else members, k + ahead)
            if factor is None:
                return call("sin", found) if 0.4 < kind < 0.5 else found
            return found * ref(factor.get(k - ahead, last))

        return take


class Reader:
    """Computes lines as the C that is printed of them: ``arrays`` are inputs, ``places`` where ``passed`` has what is bound."""

    def __init__(self, arrays: dict[str, Mapping[int, float]], passed: str, places: Mapping[str, tuple[int, ...]]):
        self.arrays, self.places = arrays, places
        self.cells: dict[int, float] = {}
        self.arrays[passed] = self.cells
        self.known: dict[str, float] = {}
        self.out: dict[int, float] = {}

    def name(self, name: str) -> float:
        return self.known[name] if name in self.known else self.cells[self.places[name][0]]

    def leave(self, place: int, value: float) -> None:
        assert place not in self.cells
        self.cells[place] = value

    def put(self, index: int, value: float) -> None:
        assert index not in self.out
        self.out[index] = value

    def read(self, lines: Sequence[Line]) -> None:
        for line in lines:
            if isinstance(line, Let):
                assert line.name not in self.known
                self.known[line.name] = value_of(line.value, self.name)
                for place in self.places.get(line.name, ()):
                    self.leave(place, self.known[line.name])
            elif isinstance(line, Store):
                self.put(line.index, value_of(line.value, self.name))
            elif isinstance(line, Leave):
                self.leave(line.first, self.name(line.name))
            else:
                assert isinstance(line, Loop)
                for turn in range(line.count):
                    self.read_pass(line, turn)

    def read_pass(self, loop: Loop, turn: int) -> None:
        own: dict[str, float] = {}

        def name(name: str) -> float:
            return own[name] if name not in loop.outside else self.name(name)

        for line in loop.body:
            if isinstance(line, Fetch):
                own[line.name] = self.arrays[line.array][line.first + line.step * turn]
            elif isinstance(line, Let):
                own[line.name] = value_of(line.value, name)
            elif isinstance(line, Leave):
                self.leave(line.first + line.step * turn, own[line.name])
            else:
                self.put(line.store.index + line.step * turn, value_of(line.store.value, name))


def value_of(expression: Expr, name: Callable[[str], float]) -> float:
    match expression:
        case Ref():
            return name(expression.name)
        case Number():
            return float(expression.value)
        case Negate():
            return -value_of(expression.operand, name)
        case Call():
            return math.sin(value_of(expression.arguments[0], name))
        case Binary():
            a, b = value_of(expression.left, name), value_of(expression.right, name)
            return {"+": a + b, "-": a - b, "*": a * b}[expression.op]
    raise AssertionError(expression)


def check(seed: int) -> int:
    """The number of loops of a random function with a random sweep."""
    draw = random.Random(seed)
    bodies = draw.randint(7, 14)
    loads = {f"q{k}": Load(f"q{k}", "y", 2 * k) for k in range(bodies)}
    loads |= {"m": Load("m", "p", 0), "l": Load("l", "p", 1)}
    first = Chain(draw, "f", bodies, [f"q{k}" for k in range(bodies)], ["m", "l"])
    straight = first.write("out")
    kept = {s.name for s in straight if isinstance(s, Let)}
    seeds = tuple(f"e{k}" for k in range(bodies))
    second = Chain(draw, "g", bodies, seeds, ["e0"])
    second.factors = [full for m in first.families if len(full := {k: n for k, n in m.items() if n in kept}) > 2]
    swept = second.write("J")
    numbers: dict[str, Mapping[int, float]] = {
        "y": {k: draw.uniform(-1, 1) for k in range(2 * bodies)},
        "p": {0: 0.9, 1: 0.7},
        "seed": {k: draw.uniform(-1, 1) for k in range(bodies)},
    }
    main, turned = Reader(dict(numbers), "kept", {}), Reader(dict(numbers), "carried", {})
    main.known = {name: numbers[load.array][load.index] for name, load in loads.items()}
    main.read(straight)
    turned.known = main.known | {name: numbers["seed"][k] for k, name in enumerate(seeds)}
    turned.read(swept)
    found = roll_function(loads, straight, [Sweep("", seeds, (0,), swept)], 1)
    if found is None:
        return 0
    body, (other,) = found
    again = Reader(dict(numbers), "kept", body.places)
    again.known = {name: numbers[load.array][load.index] for name, load in loads.items()}
    again.read(body.lines)
    assert again.out == main.out
    if other is not None:
        sweep = Reader({**numbers, "kept": again.cells}, "carried", other.places)
        sweep.known = {name: x for name, x in turned.known.items() if name in seeds or name in main.known}
        sweep.read(other.lines)
        assert sweep.out == turned.out
    lines = (*body.lines, *(other.lines if other else ()))
    return sum(isinstance(line, Loop) for line in lines)


def test_random_chains() -> None:
    loops = [check(seed) for seed in range(250)]
    assert sum(count > 0 for count in loops) > 200 and sum(loops) > 500
