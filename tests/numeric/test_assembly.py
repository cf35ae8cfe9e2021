"""Starts that follow from the holonomic constraints: ``{near: ...}``, against closed forms; what is said where there are none."""

from __future__ import annotations

import math
import re

import pytest
from scipy.optimize import minimize_scalar

from nhc.diagnostics import Source, SpecError
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.mechanics.system import System
from nhc.pipeline import check
from nhc.simulate.starts import list_starts, read_starts

CRANK = """\
nhc: 1
system: crank
coordinates: {a: {unit: rad}, b: {unit: rad}, x: {unit: m}}
parameters: {r: {value: UNIT*0.3, unit: m}, l: {value: UNIT, unit: m}, J: {value: 1, unit: kg*m^2}, m: {value: 2, unit: kg}}
T: J*(a'^2 + b'^2)/2 + m*x'^2/2
holonomic:
  - along: r*cos(a) + l*cos(b) = x
  - across: r*sin(a) - l*sin(b) = 0
scenes:
  go: {initial: {a: 0.8, b: {near: B}, x: {near: UNIT*X}, a': 2}, time: [0, 1], need: [x]}
"""
LINKAGE = """\
nhc: 1
system: six_bar
coordinates: [a, b, c, d, e]
T: (a'^2 + b'^2 + c'^2 + d'^2 + e'^2)/2
holonomic:
  - cos(a) + 1.5*cos(b) - 1.2*cos(c) = 2
  - sin(a) + 1.5*sin(b) - 1.2*sin(c) = 0
  - cos(a) + 0.8*cos(b + 0.5) + 1.3*cos(d) - 0.6*cos(e) = 2.4
  - sin(a) + 0.8*sin(b + 0.5) + 1.3*sin(d) - 0.6*sin(e) = -0.2
scenes:
  turn: {initial: {a: {near: 1.2}, b: {near: 0.1}, c: {near: 1.5}, d: {near: -0.9}, e: E}, time: [0, 1]}
"""


def open_start(text: str) -> tuple[System, Start]:
    system = resolve(decode(Source("assembly.yaml", text)))
    return system, start_of(system, system.spec.scenes[0])


def refuse(text: str) -> SpecError:
    with pytest.raises(SpecError) as refused:
        open_start(text)
    return refused.value


@pytest.mark.parametrize("unit", ["1", "1000", "1e-6"])
@pytest.mark.parametrize(("b", "x", "folded"), [("0", "1", False), ("0.4", "0", False), ("3", "-1", True)])
def test_slider_crank(unit: str, b: str, x: str, folded: bool) -> None:
    """Both branches, each from where it was looked for; dependent velocities follow as for any start."""
    _, start = open_start(CRANK.replace("UNIT", unit).replace("B}", f"{b}}}").replace("X}", f"{x}}}"))
    angle = math.asin(0.3 * math.sin(0.8))
    angle = math.pi - angle if folded else angle
    length = float(unit)
    assert start.q[0] == 0.8
    assert start.q[1] == pytest.approx(angle, rel=1e-14)
    assert start.q[2] == pytest.approx(length * (0.3 * math.cos(0.8) + math.cos(angle)), rel=1e-14)
    turning = 0.3 * math.cos(0.8) * 2 / math.cos(angle)
    assert start.v[1] == pytest.approx(turning, rel=1e-13)
    assert start.v[2] == pytest.approx(-length * (0.6 * math.sin(0.8) + math.sin(angle) * turning), rel=1e-13)


def test_what_is_open_moves_least() -> None:
    text = "nhc: 1\nsystem: rod\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nholonomic: [x^2 + y^2 = 1]\n"
    _, start = open_start(text + "scenes: {go: {initial: {x: {near: 0.63}, y: {near: 0.84}, z: 3}, time: [0, 1]}}\n")
    assert start.q == pytest.approx((0.6, 0.8, 3), rel=1e-14)


@pytest.mark.parametrize(
    ("near", "mass"),
    [((0.8, 0.6), 1.0), ((0.1, 1.0), 1.0), ((0.8, 0.6), 7.0), ((-0.4, -0.01), 1.0), ((1.5, -2.0), 0.2)],
)
def test_the_place_is_the_nearest(near: tuple[float, float], mass: float) -> None:
    """On an ellipse, by a sum of squares with T's weights, against the best of many places on it."""
    x, y = near
    _, start = open_start(f"""nhc: 1
system: ellipse
coordinates: [x, y]
T: (x'^2 + {mass}*y'^2)/2
holonomic: [x^2 + 9*y^2 = 1]
scenes: {{go: {{initial: {{x: {{near: {x}}}, y: {{near: {y}}}}}, time: [0, 1]}}}}
""")

    def away(turn: float) -> float:
        return (math.cos(turn) - x) ** 2 + mass * (math.sin(turn) / 3 - y) ** 2

    turn = minimize_scalar(away, bracket=(math.atan2(3 * y, x) - 0.3, math.atan2(3 * y, x) + 0.3), tol=1e-14).x
    assert start.q == pytest.approx((math.cos(turn), math.sin(turn) / 3), abs=1e-7)
    assert start.q[0] ** 2 + 9 * start.q[1] ** 2 == pytest.approx(1, rel=1e-12)


def test_loops_that_share_links() -> None:
    _, start = open_start(LINKAGE.replace("e: E", "e: 2.2"))
    a, b, c, d, e = start.q
    assert e == 2.2
    left = (
        math.cos(a) + 1.5 * math.cos(b) - 1.2 * math.cos(c) - 2,
        math.sin(a) + 1.5 * math.sin(b) - 1.2 * math.sin(c),
        math.cos(a) + 0.8 * math.cos(b + 0.5) + 1.3 * math.cos(d) - 0.6 * math.cos(e) - 2.4,
        math.sin(a) + 0.8 * math.sin(b + 0.5) + 1.3 * math.sin(d) - 0.6 * math.sin(e) + 0.2,
    )
    assert max(map(abs, left)) < 1e-14
    assert all(abs(x - y) < 0.5 for x, y in zip(start.q, (1.2, 0.1, 1.5, -0.9, 2.2), strict=True))


@pytest.mark.parametrize("held", ["", "holonomic: ['x^2 + y^2 = 1']\n"])
def test_what_no_equation_moves_stands_where_it_is_near_to(held: str) -> None:
    text = f"nhc: 1\nsystem: free\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\n{held}"
    text += "scenes: {a: {initial: {x: 1, z: {near: 0.7}}, time: [0, 1]}}\n"
    system = resolve(decode(Source("free.yaml", text)))
    assert start_of(system, system.spec.scenes[0]).q == (1.0, 0.0, 0.7)


def test_the_place_that_is_offered_is_no_turn_away() -> None:
    """Steps towards x = 100, which is nowhere, had gone round nine times; the coordinates that are to follow are enough."""
    text = (
        "nhc: 1\nsystem: crank\ncoordinates: [a, b, x]\nT: (a'^2 + b'^2 + x'^2)/2\n"
        "holonomic: ['cos(a) + 3*cos(b) = x', 'sin(a) - 3*sin(b) = 0']\n"
        "scenes: {s: {initial: {a: 1, b: {near: 0.2}, x: 100}, time: [0, 1]}}\n"
    )
    with pytest.raises(SpecError) as caught:
        check(Source("assembly.yaml", text), explain=False)
    (found,) = caught.value.diagnostics
    a, b, x = (float(value) for value in re.findall(r": (-?[0-9.e-]+)", found.help[0].split("`")[1]))
    assert abs(a) < 1 and abs(b) < 1 and x == pytest.approx(math.cos(a) + 3 * math.cos(b), abs=1e-6)
    (offer,) = re.findall(r"`(.*)`", found.help[1])
    mended = re.sub(r"initial: \{.*\}, time", f"initial: {{{offer}}}, time", text)
    assert not check(Source("assembly.yaml", mended), explain=False).diagnostics


def test_no_place_near() -> None:
    """The linkage does not reach e = 0; the places that are offered are accepted as they are written."""
    text = LINKAGE.replace("e: E", "e: 0")
    (found,) = refuse(text).diagnostics
    assert found.code == "E0409"
    assert found.message.startswith("the scene `turn` starts off 4 constraints: `h1` by ")
    assert found.notes == ("this is left at the best place for `a`, `b`, `c`, `d` near what `initial` says",)
    for line in found.help:
        (offer,) = re.findall(r"`(.*)`", line)
        initial = f"initial: {{{offer}" + ("" if "e: " in offer else ", e: {near: 1.5}")
        mended = re.sub(r"initial: \{.*\}, time", f"{initial}}}, time", text)
        assert not check(Source("assembly.yaml", mended), explain=False).diagnostics, line


def test_parameters_move_the_start() -> None:
    """A scene's own values, and those of an ensemble's rows; a row that gives the coordinate itself is taken at its word."""
    text = CRANK.replace("UNIT", "1").replace("B}", "0}").replace("X}", "1}")
    _, start = open_start(text.replace("go: {", "go: {parameters: {r: 0.5}, "))
    assert start.q[1] == pytest.approx(math.asin(0.5 * math.sin(0.8)), rel=1e-14)
    system, _ = open_start(text)
    scene = system.spec.scenes[0]
    rows = list_starts(system, scene, read_starts("r,a\n0.3,0.8\n0.6,-0.2\n", system.spec))
    for row, (r, a) in zip(rows, ((0.3, 0.8), (0.6, -0.2)), strict=True):
        assert row.q[1] == pytest.approx(math.asin(r * math.sin(a)), rel=1e-14)
    (same,) = list_starts(system, scene, read_starts(f"b\n{rows[0].q[1]!r}\n", system.spec))
    assert same.q[1] == rows[0].q[1]


@pytest.mark.parametrize(
    ("wrong", "code", "message"),
    [
        ("b: {naer: 0}", "E0303", "unknown key `naer` in the start of `b`"),
        ("b: {}", "E0304", "missing key `near` in the start of `b`"),
        (
            "b: {near: x}",
            "E0314",
            "`x` is not constant: a start value holds numbers, `pi`, parameters and definitions of these",
        ),
        ("b': {near: 0}", "E0301", "expected a number, found a mapping"),
        ("b: {near: 1/0}", "E0313", ""),
    ],
)
def test_a_wrong_word_of_a_start_gets_its_code(wrong: str, code: str, message: str) -> None:
    text = CRANK.replace("UNIT", "1").replace("b: {near: B}", wrong).replace("X}", "1}")
    found = refuse(text).diagnostics
    assert code in [d.code for d in found] and any(message in d.message for d in found)


FOUR_BAR = """nhc: 1
system: four_bar
coordinates: [a, b, c]
T: a'^2 + b'^2 + c'^2
define: {px: 0.3*cos(a), py: 0.3*sin(a)}
holonomic:
  - px + cos(a + b) = 1.1 + 0.7*cos(c)
  - py + sin(a + b) = 0.7*sin(c)
scenes: {go: {initial: {a: ANGLE, b: {near: 0.8}, c: {near: 1.8}}, time: [0, 1]}}
"""


@pytest.mark.parametrize("angle", [0.0, 0.5, 1.0, 1.25, 1.5, 1.75, 2.0, 2.75, 3.0, 3.25, 4.5, 5.0, 6.0])
def test_a_linkage_is_assembled_near_to_what_was_given(angle: float) -> None:
    """No step near a dead point leads to another turn: both solutions, with all their turns, are known in closed form."""
    system = resolve(decode(Source("four_bar.yaml", FOUR_BAR.replace("ANGLE", str(angle)))))
    start = start_of(system, system.spec.scenes[0])
    px, py = 0.3 * math.cos(angle), 0.3 * math.sin(angle)
    way, far = math.atan2(py, px - 1.1), math.hypot(px - 1.1, py)
    near = math.acos((0.7**2 + far**2 - 1) / (2 * 0.7 * far))
    places = list[tuple[float, float]]()
    for c in (way + near, way - near):
        b = math.atan2(0.7 * math.sin(c) - py, 1.1 + 0.7 * math.cos(c) - px) - angle
        turns = (-4 * math.pi, -2 * math.pi, 0.0, 2 * math.pi, 4 * math.pi)
        places += [(b + one, c + other) for one in turns for other in turns]
    best = min(places, key=lambda place: math.hypot(place[0] - 0.8, place[1] - 1.8))
    assert start.q[1:] == pytest.approx(best, abs=1e-9)


def test_a_flat_place_is_left_on_its_own_side() -> None:
    text = "nhc: 1\nsystem: s\ncoordinates: [x, y]\nT: x'^2 + y'^2\nholonomic: [\"y = sin(x)\"]\n"
    text += "scenes: {go: {initial: {x: {near: 1.5}, y: 0.5}, time: [0, 1]}}\n"
    system = resolve(decode(Source("s.yaml", text)))
    assert start_of(system, system.spec.scenes[0]).q[0] == pytest.approx(math.pi / 6)
