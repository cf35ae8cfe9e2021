"""The gallery with parts left out, at right angles: systems near it that nobody has written, where special things happen.

Random states miss what is wrong where an angle is a multiple of 90 degrees; what is left out changes which velocities are kept, and
how the constraints are solved for the others.
"""

from __future__ import annotations

import math
import random
import zlib
from collections.abc import Iterator
from types import ModuleType

import pytest

from nhc.algebra.graph import Node
from nhc.diagnostics import Source, SpecError
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import Formulation, applicable, formulate
from nhc.mechanics.choosing.conditioning import conditioning, evaluate_rows, is_mass_sound
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.properties.singular import smallest_singular_value
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.program.model import build_program
from nhc.simulate.interpreted import TextModel
from nhc.simulate.opening import open_scene
from nhc.study.simplify.draft import draft_of
from nhc.study.simplify.text import NoLimit, write_draft
from tests.support import GALLERY, seldom, spec_path

MODELS, STATES = 2, 25  # of each system
ANGLES = (0.0, 0.0, 0.0, math.pi / 2, -math.pi / 2, math.pi, math.pi / 4, 1.0)
TURNS = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.5, 0.5, 0.5, 0.5), (math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)))
REGULAR, RANK = 1e-4, 1e-4  # of a coframe's determinant, and of the constraints' smallest singular value
BESIDE, LARGEST = 1e-7, 1e6
TOLERANCE = 1e-7
SPECS = {name: decode(read(str(spec_path(name)))) for name in GALLERY}
WITH_CONSTRAINTS = [name for name, spec in SPECS.items() if spec.scenes and (spec.constraints or spec.holonomic)]


def smaller(name: str, rng: random.Random) -> Iterator[Source]:
    """Specs without one, two or three of what `nhc reduce` may leave out."""
    source = read(str(spec_path(name)))
    scene = SPECS[name].scenes[0]
    draft = draft_of(source, scene)
    candidates = draft.candidates(open_scene(source, scene.name).start)
    for count in (1, 1, 1, 2, 2, 3, 1, 2)[: 2 * MODELS + 2]:
        try:
            yield Source(
                "less.yaml", write_draft(draft, draft.change(rng.sample(candidates, min(count, len(candidates)))))
            )
        except NoLimit:
            continue


def emitted(system: System, formulation: Formulation) -> ModuleType:
    only = ("rhs", "velocities", "accelerations")
    program = build_program(system, formulation, equations_of(system, formulation), only, scenes=False)
    module: ModuleType = TextModel(program).module
    return module


def draw(system: System, kept: int, rng: random.Random) -> list[float]:
    q = [rng.choice((*ANGLES, rng.uniform(-2, 2))) for _ in range(system.n)]
    for rotation in system.rotations:
        for place, x in zip(rotation.places, rng.choice(TURNS), strict=True):
            q[place] = x
    return [*q, *(rng.choice((0.0, 1.0, rng.uniform(-2, 2))) for _ in range(kept))]


def place_of(system: System, t: float, state: list[float], p: list[float]) -> dict[Node, float]:
    pairs = zip((*system.q, *system.v), state, strict=False)  # velocities where they are needed
    return {system.t: t, **dict(zip(system.p, p, strict=True)), **dict(pairs)}


def is_regular(system: System, formulation: Formulation, t: float, q: list[float], p: list[float]) -> bool:
    """Whether the coframe and the constraints are, and do not jump there (the point of contact of a wheel that lies flat)."""
    places = [
        place_of(system, t, at, p)
        for at in [[x + side * BESIDE * math.cos(7 * k) for k, x in enumerate(q)] for side in (0, 1, -1)]
    ]
    try:
        sound = conditioning(system, formulation, places[0]) ** max(system.l, 1) > REGULAR
        rows = [evaluate_rows(system, system.constraints, place) for place in places]
        entries = [[x for row in own for x in row] for own in rows]
        steady = all(max(x) - min(x) < 1e3 * BESIDE * (1 + abs(x[0])) for x in zip(*entries, strict=True))
        return sound and steady and smallest_singular_value(system, places[0]) > RANK
    except (ArithmeticError, ValueError):
        return False


def compare(system: System, formulation: Formulation, whole: ModuleType, rng: random.Random) -> int:
    """At how many states a formulation was held against all velocities with multipliers."""
    model, seen = emitted(system, formulation), 0
    p = [float(x) for x in model.DEFAULTS]
    for _ in range(STATES):
        t, y = rng.choice((0.0, 0.7)), draw(system, len(model.STATE) - system.n, rng)
        q = y[: system.n]
        if not is_regular(system, formulation, t, q, p):
            continue
        try:
            v = model.velocities(t, y, p)  # a regular coframe is never refused ...
        except ArithmeticError as error:
            pytest.fail(f"{formulation.name}: {error} at {t}, {y}")
        try:
            expected = whole.accelerations(t, [*q, *v], p)
        except ArithmeticError:
            continue  # the mass matrix may be singular: then nothing is determined
        if (
            not is_mass_sound(system, formulation, place_of(system, t, [*q, *v], p))
            or max(map(abs, expected)) > LARGEST
        ):
            continue  # or all but singular, for the cosine of a right angle is 6e-17
        found = model.accelerations(t, y, p)  # ... nor are accelerations that the multipliers have
        scale = 1 + max(map(abs, expected))
        assert max(abs(a - b) for a, b in zip(found, expected, strict=True)) < TOLERANCE * scale, (
            formulation.name,
            t,
            y,
        )
        seen += 1
    return seen


@pytest.mark.sample(6)
@pytest.mark.parametrize("name", [seldom(name) if name == "bicycle" else name for name in WITH_CONSTRAINTS])
def test_formulations_agree_at_right_angles(name: str) -> None:
    rng, seen = random.Random(zlib.crc32(name.encode())), []
    for source in smaller(name, rng):
        try:
            seen.append(compare_all(resolve(decode(source)), rng))
        except SpecError:  # without a part it may be no model
            continue
        if len(seen) == MODELS:
            break
    assert sum(seen) > 0


def compare_all(system: System, rng: random.Random) -> int:
    """At how many states the formulations that apply were held against all velocities with multipliers."""
    formulations = {f.name: f for f in (*applicable(system), formulate(system))}
    whole = emitted(system, formulations.pop("multipliers"))
    return sum(compare(system, formulation, whole, rng) for formulation in formulations.values())
