"""Random specs: every formulation against the multipliers, C against Python, and derivations that do not fail."""

from __future__ import annotations

import os
import random
from pathlib import Path

import pytest

from nhc.pipeline import Options, derive
from tests.fuzz.emission import check_formulations, make_case, run_batch, states_of
from tests.generate import write_spec
from tests.metamorphic.models import source_of
from tests.support import made_once

SIZE = int(os.environ.get("NHC_TEST_SIZE", "1"))
BATCH = 13


@pytest.mark.sample(2)
@pytest.mark.parametrize("first", range(0, 2 * BATCH * SIZE, BATCH))
def test_formulations_and_back_ends_agree(first: int, tmp_path: Path) -> None:
    between, back_ends = run_batch(range(first, first + BATCH), tmp_path)
    assert between < 1e-9
    assert back_ends < 1e-12


@pytest.mark.sample(2)
@pytest.mark.parametrize("seed", range(8 * SIZE))
def test_derivations_are_written(seed: int) -> None:
    source = source_of(write_spec(random.Random(seed), f"random_{seed}"))
    with made_once():
        texts = {to: derive(source, Options(to=to)) for to in ("text", "latex", "json")}
    for to, text in texts.items():
        assert "I." in text or "II." in text, to


def test_a_wrong_equation_is_noticed() -> None:
    """The comparison of formulations fails where one of them is off in the seventh digit."""
    first = make_case(5)
    module = first.models[1][1]
    states = states_of(module, 5, 2)
    assert check_formulations(first, states) < 1e-9
    spoiled = type(first)(
        first.name, first.text, first.formulation, (first.models[0], ("spoiled", Spoiled(module))), {}
    )
    with pytest.raises(AssertionError):
        check_formulations(spoiled, states)


class Spoiled:
    """A model whose accelerations are off by a little."""

    def __init__(self, module: object) -> None:
        self.module = module

    def __getattr__(self, name: str) -> object:
        return getattr(self.module, name)

    def accelerations(self, *arguments: object) -> list[float]:
        return [a * (1 + 1e-7) + 1e-7 for a in self.module.accelerations(*arguments)]  # type: ignore[attr-defined]
