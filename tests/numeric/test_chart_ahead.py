"""What a chart compiles is compiled before anything is timed."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.language import read
from nhc.simulate.c import compile as compiling
from nhc.study.chart import study
from nhc.study.chart.ahead import compile_ahead
from nhc.study.chart.grid import Grid
from nhc.study.chart.reference import Solution
from tests.support import spec_path


def test_nothing_is_compiled_once_the_reference_is_run(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Formulations, structure-preserving methods and the reference's own long double are all in the cache by then."""
    monkeypatch.setenv("NHC_CACHE", str(tmp_path))
    made: list[str] = []
    whole = compiling._compile

    def compile_one(sources: dict[str, str], unit: str, command: tuple[str, ...], library: Path) -> None:
        made.append(unit)
        whole(sources, unit, command, library)

    reference = study.make_reference
    before: list[str] = []

    def make_reference(*arguments: object) -> Solution:
        before.extend(made)
        return reference(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(compiling, "_compile", compile_one)
    monkeypatch.setattr(study, "make_reference", make_reference)
    grid = Grid(tolerances=(1e-4,), languages=("c",), peers=False)
    study.chart(read(str(spec_path("nh_particle_pot"))), grid)
    assert sorted(made) == sorted(before)
    names = [f"nh_particle_pot_{kind}.c" for kind in ("chart", "long")]
    assert set(made) == set(names)
    assert made.count(names[0]) > 3 and made.count(names[1]) == 1


def test_what_does_not_compile_is_met_where_it_is_needed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    from nhc.simulate.c.compile import CompileError
    from nhc.simulate.opening import open_scene
    from nhc.study.chart.model import compile_chart

    monkeypatch.setenv("NHC_CACHE", str(tmp_path))

    def refuse(*_: object) -> None:
        raise CompileError("no")

    monkeypatch.setattr(compiling, "_compile", refuse)
    job = open_scene(read(str(spec_path("nh_particle_pot"))))
    compile_ahead(job, [job], ("dop853",), None, ())
    with pytest.raises(CompileError):
        compile_chart(job, "dop853")
