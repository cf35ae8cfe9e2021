"""The gallery and random specs under changes that leave the motion as it is.

``NHC_TEST_SIZE`` multiplies the number of systems (1 is the size of ``make test``).
"""

from __future__ import annotations

import os
import random
from dataclasses import replace
from types import ModuleType

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from nhc.algebra.exact.modular import Unlucky
from nhc.language import read
from tests.generate import Writer, write_spec
from tests.metamorphic.changes import Change, changes_for, write_as_forms, writer_for
from tests.metamorphic.exact import admissible, exact_accelerations
from tests.metamorphic.models import (
    State,
    accelerations,
    default_parameters,
    distance,
    draw_state,
    formulations_of,
    load_python,
    reactions,
    source_of,
)
from tests.metamorphic.texts import Draft, take_apart, tree_of, write
from tests.support import GALLERY, spec_path

SIZE = int(os.environ.get("NHC_TEST_SIZE", "1"))
HANDFUL = (
    "affine_voronec",
    "ball_on_table",
    "chaplygin_sleigh",
    "charged_sleigh",
    "cvt",
    "disk_chain2",
    "holonomic_pendulum",
    "pumped_pendulum",
    "rolling_disk",
    "voronec_particle",
)
SYSTEMS = HANDFUL if SIZE == 1 else GALLERY
EXACT = tuple(name for name in SYSTEMS if len(take_apart(read(str(spec_path(name)))).coordinates) <= 6)
TOLERANCE = 1e-9
TAME, LARGEST = 1e3, 1e5


def draft_of(name: str) -> Draft:
    return take_apart(read(str(spec_path(name))))


def is_tame(model: ModuleType, p: list[float], state: State) -> bool:
    """Whether the state is not so near to a singular one that rounding alone could exceed the tolerance."""
    try:
        y = model.state(state.t, state.q, state.v, p)
        here = model.accelerations(state.t, y, p)
        for k in range(len(y)):
            near = list(y)
            near[k] += 1e-6
            if distance(model.accelerations(state.t, near, p), here) > 1e-6 * TAME:
                return False
        forces = model.reactions(state.t, y, p)
    except ArithmeticError:
        return False
    return max([abs(x) for x in (*here, *forces)], default=0.0) < LARGEST


def tame_states(model: ModuleType, p: list[float], rng: random.Random, count: int) -> list[State]:
    drawn = (draw_state(model, p, rng) for _ in range(20 * count))
    return [state for state in drawn if is_tame(model, p, state)][:count]


def check_change(base: ModuleType, change: Change, p: list[float], states: list[State]) -> int:
    """Compare a changed spec, in each formulation that it concerns, with the old one; how often it was compared."""
    compared = 0
    for formulation in formulations_of(change.text):
        if change.formulations and formulation not in change.formulations:
            continue
        model = load_python(change.text, formulation)
        for state in states:
            new = change.enter(state)
            if not is_tame(model, p_of(model, base, p), new):
                continue
            own = p_of(model, base, p)
            found = change.q_back(accelerations(model, own, new), state)
            assert distance(found, accelerations(base, p, state)) < TOLERANCE, (formulation, change.text)
            forces = change.lambda_back(reactions(model, own, new), state)
            assert distance(forces, reactions(base, p, state)) < TOLERANCE, (formulation, change.text)
            compared += 1
    return compared


def p_of(model: ModuleType, base: ModuleType, p: list[float]) -> list[float]:
    """The parameters in the changed spec's order."""
    values = dict(zip(base.PARAMETERS, p, strict=True))
    return [values[name] for name in model.PARAMETERS]


def check_draft(draft: Draft, rng: random.Random, count: int = 2) -> None:
    text = write(draft)
    base = load_python(text, formulations_of(text)[0])
    p = default_parameters(base, rng)
    states = tame_states(base, p, rng, 4 * count)
    assert len(states) >= count
    for make in changes_for(draft):
        change = make(draft, writer_for(draft, rng))
        assert check_change(base, change, p, states) >= count, make.__name__


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", SYSTEMS)
def test_changes_leave_the_motion_of_the_gallery(name: str) -> None:
    check_draft(draft_of(name), random.Random(f"{name} {SIZE}"))


@settings(max_examples=4 * SIZE, derandomize=SIZE == 1, deadline=None, suppress_health_check=list(HealthCheck))
@given(seed=st.integers(0, 2**32), n=st.integers(1, 5))
def test_changes_leave_the_motion_of_random_specs(seed: int, n: int) -> None:
    rng = random.Random(seed)
    check_draft(take_apart(source_of(write_spec(rng, "drawn", n))), rng, count=1)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", EXACT)
def test_changes_leave_the_motion_of_the_gallery_exactly(name: str) -> None:
    draft, rng = draft_of(name), random.Random(name)
    text = write(draft)
    makers = [make for make in changes_for(draft) if make.__name__ not in ("rescale", "move_point")]
    for make in makers:
        change = make(draft, writer_for(draft, rng, exact=True))
        chosen = change.formulations or formulations_of(change.text)
        for formulation in formulations_of(change.text):
            if formulation in chosen:
                first, second = exact_pair(text, change.text, formulation)
                assert first == second, (make.__name__, formulation)


def exact_pair(old: str, new: str, formulation: str) -> tuple[dict[str, int], dict[str, int]]:
    """Accelerations of the old spec by the reference, of the new one by ``formulation``, at one exact state."""
    for seed in range(30):
        try:
            v = admissible(old, seed)
            return (
                exact_accelerations(old, formulations_of(old)[0], seed, v),
                exact_accelerations(new, formulation, seed, v),
            )
        except Unlucky:
            continue
    raise AssertionError("30 unlucky points")


def test_a_wrong_gauge_is_noticed() -> None:
    """x*theta' is no total derivative: the comparison must fail, in doubles and exactly."""
    draft = draft_of("chaplygin_sleigh")
    spoiled = replace(draft, kinetic=tree_of("Tk + 0.01*x*theta'"), define=(*draft.define, ("Tk", draft.kinetic)))
    rng = random.Random(3)
    base = load_python(write(draft), "multipliers")
    p = default_parameters(base, rng)
    with pytest.raises(AssertionError):
        check_change(base, Change(write(spoiled)), p, tame_states(base, p, rng, 4))
    first, second = exact_pair(write(draft), write(spoiled), "voronec")
    assert first != second


def test_writing_a_draft_keeps_it() -> None:
    for name in SYSTEMS:
        text = write(draft_of(name))
        assert write(take_apart(source_of(text))) == text


def test_forms_are_really_written_as_forms() -> None:
    draft = draft_of("rolling_disk")
    made = write_as_forms(draft, Writer(random.Random(0), 1))
    assert "*dt" in made.text or " dt" in made.text
    assert all(row.form == "differential" for row in take_apart(source_of(made.text)).rows)
