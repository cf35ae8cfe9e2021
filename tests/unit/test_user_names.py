"""Names that the user gave stay with what they name, through every substitution."""

from __future__ import annotations

from nhc.algebra.exact.modular import are_zero
from nhc.emit.text import print_derivation
from nhc.language import Source, decode
from nhc.mechanics.choosing.choose import applicable, formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from nhc.program.paper import derivation


def test_a_name_of_the_user_means_one_thing() -> None:
    """Not what is left of it where a velocity was put to zero to find a coefficient."""
    text = (
        "nhc: 1\nsystem: one\ncoordinates: [th]\nT: om^2/2\nforces: {th: -om}\nquasi_velocities: {om: th' + 2*sin(t)}\n"
    )
    system = resolve(decode(Source("one.yaml", text)))
    for formulation in applicable(system):
        made = derivation(system, formulation, equations_of(system, formulation))
        lines = [line.strip() for line in print_derivation(made).splitlines()]
        assert {line for line in lines if line.startswith("om = ")} == {"om = th' + 2*sin(t)"}


def test_an_integral_is_written_in_names_that_mean_what_they_say() -> None:
    """Of a linkage whose bars' middles have names: the sine of one angle put to zero is no such middle."""
    text = (
        "nhc: 1\nsystem: bars\ncoordinates: [a, b, c]\ndefine: {X: 3*cos(a) + cos(b), Y: 3*sin(a) + sin(b)}\n"
        "T: (X'^2 + Y'^2 + a'^2 + c'^2)/2\nholonomic: [3*cos(a) + 2*cos(b) = 4 + cos(c), 3*sin(a) + 2*sin(b) = sin(c)]\n"
    )
    system = resolve(decode(Source("bars.yaml", text)))
    equations_of(system, formulate(system))
    g = system.graph
    for node, name in g.labels.items():
        if name in ("X", "Y"):
            angle = g.function("cos" if name == "X" else "sin", system.q[1])
            bar = g.function("cos" if name == "X" else "sin", system.q[0])
            assert are_zero(g, [g.sub(node, g.add(g.mul(g.number(3), bar), angle))]) == [True]


def test_names_that_are_the_same_in_ascii_are_told_apart_in_the_header() -> None:
    """An accent is dropped where nothing else is called so, and its letter named where something is."""
    text = (
        "nhc: 1\nsystem: ua\ncoordinates: [\u00e9, e, \u00f6]\nparameters: {\u00e4: 1, a: 2}\n"
        "T: (\u00e4*\u00e9'^2 + a*e'^2 + \u00f6'^2)/2\n"
    )
    header = emit(Source("ua.yaml", text), "c", Options())["ua.h"]
    assert header.isascii()
    lines = [line.removeprefix(" * ") for line in header.splitlines()]
    for line in (
        "y[0] = <U+00E9>",
        "y[1] = e",
        "y[2] = o",
        "y[3] = <U+00E9>'",
        "p[0]: <U+00E4> = 1.0",
        "p[1]: a = 2.0",
    ):
        assert line in lines
