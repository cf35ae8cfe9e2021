"""Every formula of a derivation, read back from the text and from the LaTeX, has the value of what was to be printed."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from pathlib import Path

import pytest

from nhc.emit.latex.math import LatexMath
from nhc.emit.latex.names import name_document
from nhc.emit.text.math import TextMath, print_mark
from nhc.language import Source, decode, read
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.program.paper import Derivation, Side, Statement, derivation
from nhc.program.sheets.model import Mark
from tests.ir_values import value
from tests.readers import LatexReader, TextReader

SPECS = Path(__file__).resolve().parents[2] / "specs"
GALLERY = ("affine_voronec", "ball_on_table", "chaplygin_sleigh", "heavy_top_quaternion", "roller_racer", "suslov")
FUNCTIONAL = """nhc: 1
system: functional
coordinates: [x, y, z]
parameters: {m: 1, a: 0.4}
T: m/2*(x'^2*exp(-y) + y'^2*sqrt(1 + x^2) + z'^2*(2 + atan2(x, 1 + y^2))) + x'*y'*log(3 + z^2)/7
V: a*tanh(x)*cosh(y) + abs(z)^3 + max(x, y) + x^(5/2) + 9.81*x/(1 + x*y) + asin(x/4) - pi*tan(z)^2
constraints: [s: z'*(1 + x^2)^2 - y*x'/(1 + z^2) + tan(z)*y'/3 = 0]
"""
NAMES = """nhc: 1
system: names
coordinates: [E, T, H, p]
parameters: {gamma: 1, eps: 0.4, k: 2, z: 0.7, Theta: 0.3, Omega: 2, Delta: 1}
T: (gamma + eps*cos(E*T)^2)*(E'^2 + T'^2)/2 + Theta/2*(H'^2 + Omega*p'^2) + k*E'*z
V: Delta*E*T^2 + z*sin(H)*p
constraints:
  - lambda: H' - T*E' - z*T' = 0
  - omega: p' - E^2*T' = 0
"""


def list_cases() -> Iterator[tuple[str, System]]:
    for name in GALLERY:
        yield name, resolve(decode(read(str(SPECS / f"{name}.yaml"))))
    for text in (FUNCTIONAL, NAMES):
        system = resolve(decode(Source("case.yaml", text)))
        yield system.name, system


CASES = dict(list_cases())


def list_sides(made: Derivation) -> Iterator[Side]:
    for sheet in made.sheets:
        for item in (*sheet.lets, *sheet.items):
            if isinstance(item, Statement):
                yield from (item.left, item.right)


@pytest.mark.sample(4)
@pytest.mark.parametrize(("name", "formulation"), [(n, f.name) for n, s in CASES.items() for f in applicable(s)])
def test_formulas_are_read_back(name: str, formulation: str) -> None:
    system = CASES[name]
    (chosen,) = [f for f in applicable(system) if f.name == formulation]
    made = derivation(system, chosen, equations_of(system, chosen))
    spelling, rng = name_document(made), random.Random(5)
    sides = list(list_sides(made))
    marks = {symbol.mark for symbol in made.symbols.values()}
    marks |= {factor for side in sides for term in side for factor in term.factors}
    worth: dict[Mark, float] = {mark: rng.uniform(0.3, 0.8) for mark in sorted(marks, key=repr)}
    known = {key: worth[symbol.mark] for key, symbol in made.symbols.items()}
    text = {print_mark(mark): number for mark, number in worth.items()}
    latex = {spelling.print_mark(mark): number for mark, number in worth.items()}
    assert len(text) == len(latex) == len(worth), "two symbols look the same"
    in_text, in_latex = TextMath(made.symbols), LatexMath(made.symbols, spelling)
    for side in sides:
        wanted = sum(value(t.coefficient, known) * math.prod(worth[f] for f in t.factors) for t in side)
        plain = "".join(piece.text for piece in in_text.side(side))
        typeset = "".join(piece.text for piece in in_latex.side(side))
        assert TextReader(plain, text).value() == pytest.approx(wanted, rel=1e-9, abs=1e-9), plain
        assert LatexReader(typeset, latex).value() == pytest.approx(wanted, rel=1e-9, abs=1e-9), typeset
