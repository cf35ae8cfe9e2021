"""`auto` does not solve for velocities that a mechanism's motion cannot be solved for somewhere on its way."""

from __future__ import annotations

import math

import pytest

from nhc.diagnostics import Source
from nhc.emit.text import print_derivation
from nhc.pipeline import Options, check, derivation, emit, model
from tests.support import python_model

HEAD = "nhc: 1\nsystem: s\n"
DOUBLE = """coordinates: [x1, y1, x2, y2]
parameters: {l: 1, k: 1, g: 9.81}
T: (x1'^2 + y1'^2 + x2'^2 + y2'^2)/2
V: g*(y1 + y2)
holonomic:
  - x1^2 + y1^2 = l^2
  - (x2 - x1)^2 + (y2 - y1)^2 = k^2
scenes: {a: {initial: {x1: 0.6, y1: -0.8, x2: 1.6, y2: -0.8}, time: [0, 5]}}
"""
SPHERE = """coordinates: [x, y, z]
parameters: {l: 5, g: 9.81}
T: (x'^2 + y'^2 + z'^2)/2
V: g*z
holonomic: [x^2 + y^2 + z^2 = l^2]
dependent: [z]
scenes: {a: {initial: {x: 3, z: -4}, time: [0, 5]}}
"""
ROD = """coordinates: [x1, y1, x2, y2]
parameters: {l: 0.8}
T: (x1'^2 + y1'^2 + x2'^2 + 2*y2'^2)/2
constraints:
  - (x2 - x1)*(y1' + y2') - (y2 - y1)*(x1' + x2') = 0
holonomic:
  - (x2 - x1)^2 + (y2 - y1)^2 = l^2
scenes: {a: {initial: {x2: l}, time: [0, 5]}}
"""
CRANK = """coordinates: [f, b, x]
parameters: {r: 0.2, l: 0.7}
T: (f'^2 + b'^2 + x'^2)/2
holonomic:
  - x = r*cos(f) + l*cos(b)
  - r*sin(f) = l*sin(b)
scenes: {a: {initial: {x: r + l}, time: [0, 5]}}
"""
FOUR_BAR = """coordinates: [x1, y1, x2, y2]
parameters: {l: 1, g: 9.81}
T: (2*x1'^2 + 2*y1'^2 + x1'*x2' + y1'*y2' + 2*x2'^2 + 2*y2'^2)/6
V: g*(y1 + y2)
holonomic:
  - x1^2 + y1^2 = l^2
  - (x2 - x1)^2 + (y2 - y1)^2 = l^2
  - (x2 - l)^2 + y2^2 = l^2
"""
DOUBLE_FOUR_BAR = """coordinates: [x1, y1, x2, y2, x3, y3]
parameters: {l: 1, g: 9.81}
T: (x1'^2 + y1'^2 + x2'^2 + y2'^2 + x3'^2 + y3'^2)/3 + (x1'*x2' + y1'*y2' + x2'*x3' + y2'*y3')/6
V: g*(y1 + y2 + y3)
holonomic:
  - x1^2 + y1^2 = l^2
  - (x2 - x1)^2 + (y2 - y1)^2 = l^2
  - (x2 - l)^2 + y2^2 = l^2
  - (x3 - x2)^2 + (y3 - y2)^2 = l^2
  - (x3 - 2*l)^2 + y3^2 = l^2
"""
BASIC_POINTS = """coordinates: [ax, ay, az, bx, by, bz, cx, cy, cz]
T: (ax'^2 + ay'^2 + az'^2 + 2*bx'^2 + 2*by'^2 + 2*bz'^2 + 3*cx'^2 + 3*cy'^2 + 3*cz'^2)/2
V: 9.81*(az + 2*bz + 3*cz)
holonomic:
  - ax^2 + ay^2 + az^2 = 1
  - bx^2 + by^2 + bz^2 = 1
  - cx^2 + cy^2 + cz^2 = 1
  - ax*bx + ay*by + az*bz = 0
  - ax*cx + ay*cy + az*cz = 0
  - bx*cx + by*cy + bz*cz = 0
"""


def _linkage(
    lengths: list[float], joints: list[tuple[tuple[int, float], tuple[int, float]]], pivots: list[float]
) -> str:
    """Bars by the places of their middles and their angles; ends of bars, or places on them, are joined or at (pivot, 0).

    A joint: two bars and how far along each, from -1/2 to 1/2.  The bars 0, 2, 4 ... begin at the pivots.
    """

    def end(bar: int, along: float) -> tuple[str, str]:
        size = along * lengths[bar]
        return f"x{bar} + {size}*cos(a{bar})", f"y{bar} + {size}*sin(a{bar})"

    held = [(end(2 * k, -0.5), (str(pivot), "0")) for k, pivot in enumerate(pivots)]
    held += [(end(*one), end(*other)) for one, other in joints]
    bars = range(len(lengths))
    return "\n".join(
        [
            f"coordinates: [{', '.join(f'x{k}, y{k}, a{k}' for k in bars)}]",
            "T: " + " + ".join(f"(x{k}'^2 + y{k}'^2)/2 + {lengths[k] ** 2}/24*a{k}'^2" for k in bars),
            f"V: 9.81*({' + '.join(f'y{k}' for k in bars)})",
            "holonomic:",
            *(f"  - {one} = {other}" for pair in held for one, other in zip(*pair, strict=True)),
            "",
        ]
    )


FOUR_BARS = _linkage([1, 2.2, 1.7], [((0, 0.5), (1, -0.5)), ((1, 0.5), (2, 0.5))], [0, 2.1])
SIX_BARS = _linkage(
    [1, 2.2, 1.7, 1.9, 2],
    [((0, 0.5), (1, -0.5)), ((1, 0.5), (2, 0.5)), ((2, 0.3), (3, -0.5)), ((3, 0.5), (4, 0.5))],
    [0, 2.1, 4],
)


@pytest.mark.parametrize("text", [SPHERE, BASIC_POINTS])
def test_multipliers_where_every_choice_is_singular_on_the_way(text: str) -> None:
    """A spherical pendulum in Cartesian coordinates; no three of the velocities of the points of a body that turns freely are
    independent throughout.
    """
    formulation = model(Source("s.yaml", HEAD + text)).formulation
    assert formulation.name == "multipliers" and "can reach" in formulation.reason


@pytest.mark.parametrize("scenes", [0, 1, 2, 3])
def test_how_many_scenes_are_alike_does_not_matter(scenes: int) -> None:
    """A rod flies, and nobody knows along which of its points' coordinates it will lie: four velocities are free."""
    text = "nhc: 1\nsystem: rod\ncoordinates: [x, y, X, Y, n]\nparameters: {m: 1, M: 2, L: 1.5}\n"
    text += "T: n'^2/2 + m/2*(x'^2 + y'^2) + M/2*(X'^2 + Y'^2)\nholonomic: [rod: (X - x)^2 + (Y - y)^2 = L^2]\n"
    one = "{initial: {X: 1.5, y': 1}, time: [0, 5]}"
    text += "scenes: {" + ", ".join(f"s{k}: {one}" for k in range(scenes)) + "}\n" if scenes else ""
    formulation = model(Source("rod.yaml", text)).formulation
    assert formulation.name == "multipliers" and "can reach" in formulation.reason


@pytest.mark.parametrize("text", [ROD, CRANK, DOUBLE])
def test_what_stays_regular_on_all_positions_is_kept(text: str) -> None:
    """The determinants of rods between points are their lengths squared; a crank shorter than its rod keeps cos(b) from zero."""
    assert model(Source("s.yaml", HEAD + text)).formulation.name in ("euler-lagrange", "voronec", "chaplygin")


@pytest.mark.parametrize("crank", [-1.1, 0.0, 0.4, math.pi])
def test_three_rows_and_their_minors_are_solved_for_without_pivots(crank: float) -> None:
    """A square of bars (Gonzalez et al. 2006) with its crank upright, where a fixed order of elimination met a pivot x1 = 0.

    Three unit bars that turn together by f from upright: m/3 f'^2 (two) and m/2 f'^2 make 5/6 f'^2, V = 2 g cos(f).
    """
    source = Source("s.yaml", HEAD + FOUR_BAR)
    assert model(source).formulation.name == "euler-lagrange"
    module = python_model(
        emit(source, "python", Options())["s.py"], f"square{crank:.1f}".replace(".", "_").replace("-", "m")
    )
    s, c, w, g = math.sin(crank), math.cos(crank), 1.7, 9.81
    y = module.state(0.0, [s, c, 1 + s, c], [w * c, -w * s, w * c, -w * s])
    turn = 2 * g * s / (5 / 3)
    expected = [turn * c - w * w * s, -turn * s - w * w * c] * 2
    assert module.accelerations(0.0, y) == pytest.approx(expected, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("turn", [0.5, math.pi / 2, 2.0, 4.0])
def test_a_mechanism_that_has_folded_is_solved_there(turn: float) -> None:
    """Two squares of bars, of which the first has folded, so that its crank lies on the ground: 5/3 f'' = -2 g cos(f)."""
    source = Source("s.yaml", HEAD + DOUBLE_FOUR_BAR)
    module = python_model(emit(source, "python", Options())["s.py"], f"folded{turn:.1f}".replace(".", "_"))
    c, s, w, g = math.cos(turn), math.sin(turn), 1.3, 9.81
    y = module.state(0.0, [1, 0, 1 + c, s, 2 + c, s], [0, 0, -w * s, w * c, -w * s, w * c])
    turning = -2 * g * c / (5 / 3)
    expected = [0, 0, *[-turning * s - w * w * c, turning * c - w * w * s] * 2]
    assert module.accelerations(0.0, y) == pytest.approx(expected, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("text", [FOUR_BARS, SIX_BARS])
def test_a_mechanism_is_led_by_the_velocity_that_can_lead_it_all_the_way(text: str) -> None:
    """The crank turns around; the couplers and the rockers swing, and stand still where they turn back (Grashof)."""
    made = model(Source("s.yaml", HEAD + text))
    assert made.formulation.dependent is not None
    led = {made.system.q_names[j] for j in made.formulation.dependent.dependent}
    assert set(made.system.q_names) - led == {"a0"}


def test_the_emitted_double_pendulum_hangs_straight() -> None:
    """At rest below each other with one speed: x1'' = x2'' = 0, and both ends are pulled towards their pivots."""
    (text,) = emit(Source("s.yaml", HEAD + DOUBLE), "python").values()
    module = python_model(text, "hanging")
    u, w = 0.7, -0.4
    y = module.state(0.0, [0, -1, 0, -2], [u, 0, w, 0])
    assert module.accelerations(0.0, y) == pytest.approx([0, u**2, 0, u**2 + (w - u) ** 2], abs=1e-12)
    assert all(map(math.isfinite, module.rhs(0.0, y)))


@pytest.mark.sample(2)
@pytest.mark.parametrize("count", [5, 9, 12])
@pytest.mark.parametrize("axes", ["xy", "xyz"])
def test_long_chains_of_rods_between_points_hang_at_rest(count: int, axes: str) -> None:
    """Too many coordinates for a walk, and for multipliers: the velocities across each rod are free, and no y' alone."""
    names = [[f"{axis}{k}" for axis in axes] for k in range(count)]
    before = [["0"] * len(axes), *names]
    rods = [
        " + ".join(f"({a} - {b})^2" for a, b in zip(own, last, strict=True))
        for own, last in zip(names, before, strict=False)
    ]
    text = HEAD + "\n".join(
        [
            f"coordinates: [{', '.join(x for own in names for x in own)}]",
            "T: (" + " + ".join(f"{x}'^2" for own in names for x in own) + ")/2",
            f"V: 9.81*({' + '.join(own[1] for own in names)})",
            "holonomic:",
            *(f"  - {rod} = 1" for rod in rods),
            f"scenes: {{a: {{initial: {{{', '.join(f'x{k}: {k + 1}' for k in range(count))}}}, time: [0, 1]}}}}",
            "",
        ]
    )
    source = Source("s.yaml", text)
    free = model(source).formulation.frame
    assert free is not None
    written = python_model(emit(source, "python", Options(only=("rhs",)))["s.py"], "rods")
    hanging = [float(-k - 1) if axis == "y" else 0.0 for k in range(count) for axis in axes]
    rates = written.rhs(0.0, [*hanging, *[0.0] * len(free.free)])
    assert max(map(abs, rates)) == 0.0


@pytest.mark.parametrize(("first", "said"), [("x1*y1' - y1*x1'", []), ("x1'", ["W0408"])])
def test_quasi_velocities_are_singular_only_at_positions_that_are_allowed(first: str, said: list[str]) -> None:
    """x1^2 + y1^2 is a length; y1 is zero where the first rod is level."""
    quasi = f"quasi_velocities: {{v: {first}, w: (x2 - x1)*y2' - (y2 - y1)*x2'}}\n"
    assert [d.code for d in check(Source("s.yaml", HEAD + DOUBLE + quasi)).diagnostics] == said


SIX_BAR = """coordinates: {a: {}, b: {range: [0.1, 1.2]}, c: {range: [0.8, 2.2]}, e: {range: [-1, 0.9]}, f: {range: [0.9, 2.9]}}
T: (a'^2 + b'^2 + c'^2 + e'^2 + f'^2)/2
MORE
holonomic:
  - 0.3*cos(a) + cos(b) = 0.9 + 0.8*cos(c)
  - 0.3*sin(a) + sin(b) = 0.8*sin(c)
  - 0.3*cos(a) + cos(b)/2 + 0.9*cos(e) = 1.3 + 0.7*cos(f)
  - 0.3*sin(a) + sin(b)/2 + 0.9*sin(e) = -0.2 + 0.7*sin(f)
scenes: {go: {initial: {a: 0.5, b: {near: 0.6}, c: {near: 1.4}, e: {near: 0.2}, f: {near: 1.6}, a': 3}, time: [0, 1]}}
"""
_TRIED = "as it does on none of the positions that were tried"


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("more", "warned", "used"),
    [
        ("", "", "(chosen): b', c', e', f'"),
        ("dependent: [b, c, e, f]", "", "(given): b', c', e', f'"),
        ("dependent: [a, b, c, e]", "a', b', c', e'", "(chosen): b', c', e', f'"),
        ("formulation: voronec", "", "(chosen): b', c', e', f'"),
        ("dependent: [b, c, e, f]\nformulation: voronec", "b', c', e', f'", "(given): b', c', e', f'"),
    ],
)
def test_who_asked_for_dependent_velocities_is_warned_of_them(more: str, warned: str, used: str) -> None:
    """Those that `auto` takes, since no motion that it tries comes near where they are singular, need no other advice."""
    source = Source("s.yaml", HEAD + SIX_BAR.replace("MORE", more))
    found = check(source)
    messages = [one.message for one in found.diagnostics if one.code == "W0408"]
    assert [text.partition("velocities ")[2].partition(" are")[0] for text in messages] == ([warned] if warned else [])
    (line,) = [line for line in found.facts if line.startswith("dependent velocities")]
    assert used in line and (_TRIED in line) == (more.count(":") < 2)


def test_a_derivation_names_the_dependent_velocities_that_it_solves_for() -> None:
    paper = derivation(Source("s.yaml", HEAD + SIX_BAR.replace("MORE", "")), Options())
    text = " ".join(print_derivation(paper).split())
    assert "Dependent velocities (chosen): b', c', e', f'; determinant" in text
    assert _TRIED in text and "solved for the dependent velocities `b'`, `c'`, `e'`, `f'`" in text
