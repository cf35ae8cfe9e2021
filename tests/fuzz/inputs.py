"""Inputs for the reader and the parser: random, but the same for the same seed and number."""

from __future__ import annotations

import random
from collections.abc import Callable
from functools import cache

from tests.generate import write_spec
from tests.support import SPECS

WORDS = (
    *(
        "x",
        "y",
        "theta",
        "θ",
        "m",
        "t",
        "pi",
        "T",
        "U",
        "q",
        "dx",
        "dt",
        "xdot",
        "x'",
        "lambda",
        "I",
        "E",
        "None",
        "class",
    ),
    *(
        "sin(",
        "cos(",
        "atan2(",
        "dot(",
        "sqrt(",
        "min(",
        "exp(",
        "pow(",
        "abs(",
        "eval(",
        "open(",
        "__import__(",
        "foo(",
    ),
    *(
        "+",
        "-",
        "*",
        "/",
        "^",
        "**",
        "=",
        "==",
        ",",
        ".",
        "'",
        "''",
        "(",
        ")",
        "((",
        "))",
        "[",
        "]",
        "{",
        "}",
        "|",
        "%",
        "@",
        "!",
    ),
    *(
        "0",
        "1",
        "2",
        "0.5",
        "1e-3",
        ".5",
        "5.",
        "1..2",
        "1_000",
        "0x10",
        "010",
        "1e999",
        "1e-99999",
        "9" * 40,
        "1e",
        "+1",
        "1/0",
    ),
    *(
        ":",
        ": ",
        " #",
        "- ",
        "\n",
        "\n  ",
        "\t",
        "  ",
        "&a ",
        "*a",
        "!!python/object/apply:os.system",
        "---",
        "...",
        "|",
        ">",
        "'",
        '"',
    ),
    *(
        "{{ 7*7 }}",
        "<< x >>",
        "<% if %>",
        "${x}",
        "%s",
        "{0}",
        "\\end{document}",
        "\\input{/etc/passwd}",
        "*/",
        '"""',
        "'''",
        "//",
    ),
    *(
        "lambda: 0",
        "__class__",
        "os.system('true')",
        "import os",
        "exec",
        "\\x00",
        "\\u202e",
        "nhc: 1",
        "about",
        "null",
        "~",
        "yes",
    ),
    *(
        "\x00",
        "\x07",
        "\x1b[31m",
        "\u202e",
        "\u200b",
        "\ufeff",
        "\u2028",
        "\x85",
        "é",
        "ｘ",
        "𝜃",
        "ſ",
        "ß",
        "İ",
        "²",
        "′",
        "−",
        "·",
        "\ud7ff",
        "💥",
    ),
)
SECTIONS = (
    *(
        "nhc",
        "system",
        "about",
        "source",
        "coordinates",
        "parameters",
        "define",
        "T",
        "U",
        "V",
        "forces",
        "constraints",
    ),
    *("holonomic", "quasi_velocities", "dependent", "formulation", "outputs", "scenes", "unknown", "Coordinates", "t"),
)
MINIMAL = """nhc: 1
system: mass
coordinates: [x, y]
parameters: {{m: 1, a: 0.5}}
define: {{h: "x*a"}}
T: {T}
{key}: {value}
"""
PLACES = ("U", "V", "about", "source", "formulation")


@cache
def gallery() -> tuple[str, ...]:
    """The texts of the gallery."""
    return tuple(
        path.read_text(encoding="utf-8") for path in sorted([*SPECS.glob("*.yaml"), *SPECS.glob("bodies/*.yaml")])
    )


def random_expression(rng: random.Random, depth: int = 0) -> str:
    """An expression of the grammar, valid but for its names now and then."""
    if depth > 6 or rng.random() < 0.3:
        return rng.choice(
            ("x", "y", "m", "a", "h", "t", "pi", "x'", "y'", "h'", "2", "0.5", "1e-3", "1/3", "z", "θ", "dx")
        )
    kind = rng.randrange(6)
    one = random_expression(rng, depth + 1)
    if kind == 0:
        return f"{one} {rng.choice('+-*/^')} {random_expression(rng, depth + 1)}"
    if kind == 1:
        return f"{rng.choice(('sin', 'cos', 'sqrt', 'exp', 'log', 'tan', 'abs', 'sign', 'tanh', 'dot'))}({one})"
    if kind == 2:
        return f"({one}){rng.choice(('', '', '', chr(39)))}"
    if kind == 3:
        return f"-{one}"
    if kind == 4:
        return f"{rng.choice(('atan2', 'min', 'max'))}({one}, {random_expression(rng, depth + 1)})"
    return f"({one} + {random_expression(rng, depth + 1)})^{rng.choice(('2', '-1', '0.5', 'a', '3'))}"


def word_salad(rng: random.Random) -> str:
    glue = rng.choice(("", " ", " ", ""))
    return glue.join(rng.choice(WORDS) for _ in range(rng.randint(0, 14)))


def repetition(rng: random.Random) -> str:
    """The same again and again: depth and length."""
    piece, count = (
        rng.choice(("(", "-", "sin(", "x^", "x+", "x*", "1", "(x)'", "[", "{", "'", ")", "x' ", "- ", "a: ")),
        rng.randint(1, 400),
    )
    return piece * count + rng.choice(("", "x", "x" + ")" * count))


def character_salad(rng: random.Random) -> str:
    high = rng.choice((127, 255, 0x3FF, 0xFFFF, 0x10FFFF))
    drawn = (rng.randrange(high) for _ in range(rng.randint(0, 30)))
    return "".join(chr(k) for k in drawn if not 0xD800 <= k < 0xE000)


def mutate(text: str, rng: random.Random) -> str:
    """A few cuts, copies, swaps and insertions."""
    for _ in range(rng.randint(1, 5)):
        at, size = rng.randint(0, len(text)), rng.randint(1, 12)
        kind = rng.randrange(8)
        lines = text.split("\n")
        row = rng.randrange(len(lines))
        if kind == 0:
            text = text[:at] + text[at + size :]
        elif kind == 1:
            text = text[:at] + rng.choice(WORDS) + text[at:]
        elif kind == 2:
            text = text[:at] + rng.choice(WORDS) + text[at + size :]
        elif kind == 3:
            del lines[row]
            text = "\n".join(lines)
        elif kind == 4:
            lines.insert(rng.randrange(len(lines) + 1), lines[row])
            text = "\n".join(lines)
        elif kind == 5:
            other = rng.choice(gallery())
            start = rng.randrange(len(other))
            text = text[:at] + other[start : start + rng.randint(1, 200)] + text[at:]
        elif kind == 6:
            lines[row] = " " * rng.randint(0, 6) + lines[row].lstrip()
            text = "\n".join(lines)
        else:
            text = text[:at] + random_expression(rng) + text[at:]
    return text


def random_tree(rng: random.Random, depth: int = 0) -> str:
    """YAML of random shape with the language's keys, in flow style."""
    kind = rng.randrange(4) if depth < 5 else 0
    if kind < 2:
        return rng.choice((word_salad, random_expression, character_salad))(rng).replace("\n", " ")
    parts = [random_tree(rng, depth + 1) for _ in range(rng.randint(0, 3))]
    if kind == 2:
        return f"[{', '.join(parts)}]"
    return "{" + ", ".join(f"{rng.choice((*SECTIONS, 'x', 'y'))}: {part}" for part in parts) + "}"


def small_spec(rng: random.Random) -> str:
    """A valid spec but for the one place that is tried."""
    pieces: tuple[Callable[[random.Random], str], ...] = (
        random_expression,
        word_salad,
        repetition,
        character_salad,
        random_tree,
    )
    drawn = rng.choice(pieces)(rng)
    quoted = "'" + drawn.replace("'", "''").replace("\n", " ") + "'" if rng.random() < 0.6 else drawn
    kinetic = quoted if rng.random() < 0.3 else "m/2*(x'^2 + y'^2)"
    key = rng.choice(PLACES)
    value = quoted
    if rng.random() < 0.6:
        key = rng.choice(("constraints", "holonomic", "outputs", "quasi_velocities", "forces", "scenes", "dependent"))
        value = {"constraints": f"[{quoted}]", "holonomic": f"[r: {quoted}]", "dependent": f"[{quoted}]"}.get(
            key, f"{{{rng.choice(('x', 'y', 'w', 'first', drawn[:8]))}: {quoted}}}"
        )
    return MINIMAL.format(T=kinetic, key=key, value=value)


def shape(rng: random.Random) -> str:
    return "\n".join(f"{rng.choice(SECTIONS)}: {random_tree(rng)}" for _ in range(rng.randint(0, 8)))


def mutated_gallery(rng: random.Random) -> str:
    return mutate(rng.choice(gallery()), rng)


def mutated_random(rng: random.Random) -> str:
    text = write_spec(rng, "fuzzed", rng.randint(1, 3))
    return mutate(text, rng) if rng.random() < 0.8 else text


EXPRESSIONS: tuple[Callable[[random.Random], str], ...] = (random_expression, word_salad, repetition, character_salad)
SPEC_TEXTS: tuple[tuple[Callable[[random.Random], str], int], ...] = (
    *((small_spec, 10), (mutated_gallery, 3), (mutated_random, 3), (shape, 2), (word_salad, 1), (character_salad, 1)),
)


def draw_expression(rng: random.Random) -> str:
    text = rng.choice(EXPRESSIONS)(rng)
    return mutate(text, rng) if rng.random() < 0.2 else text


def draw_spec(rng: random.Random) -> bytes:
    """A spec's bytes; now and then not UTF-8."""
    makers, weights = zip(*SPEC_TEXTS, strict=True)
    data = rng.choices(makers, weights)[0](rng).encode("utf-8")
    if rng.random() < 0.05:
        at = rng.randint(0, len(data))
        data = data[:at] + bytes(rng.randrange(256) for _ in range(rng.randint(1, 4))) + data[at:]
    return data
