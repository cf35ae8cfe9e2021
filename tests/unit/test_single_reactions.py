"""The reaction of one constraint, needed without the others."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit, reduce_scene
from nhc.simulate.interpreted import TextModel
from nhc.simulate.opening import open_scene
from nhc.simulate.requests import RunError
from nhc.study.chart.jobs import prepare_jobs

# a bead on two wires: rod: r = 2 by the coordinates, slip: no velocity along z; both reactions are known by hand
SPEC = """nhc: 1
system: bead
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2)/2
V: 3*z
constraints: [slip: z' = 0]
holonomic: [rod: x^2 + y^2 = 4]
scenes: {go: {initial: {x: 2, y': 1}, time: [0, 1], need: NEED}}
"""


def bead(need: str) -> Source:
    return Source("bead.yaml", SPEC.replace("NEED", need))


@pytest.mark.parametrize("formulation", ["multipliers", "voronec"])
def test_a_run_has_single_reactions_and_none_twice(formulation: str) -> None:
    for needs, headings in (
        ((), ["lambda_rod", "x"]),
        (("lambda_slip",), ["lambda_slip"]),
        (("lambda_rod", "reactions", "y"), ["lambda_rod", "lambda_slip", "y"]),
    ):
        job = open_scene(bead("[lambda_rod, x]"), "go", formulation, needs=needs)
        assert [column.heading for column in job.columns] == headings
        (row,) = TextModel(job.program).quantities([0.0], [job.y], job.p)
        # x'' = -v^2/r = -1/2 by lambda 2x; z'' = 0 by 3
        wanted = {"lambda_rod": -0.125, "lambda_slip": 3.0, "x": 2.0, "y": 0.0}
        assert row == pytest.approx([wanted[name] for name in headings])


def test_a_chart_of_a_reduced_model_takes_what_is_asked_for() -> None:
    spec = decode(bead("[x]"))
    system, scene = resolve(spec), spec.scenes[0]
    for needs in (("lambda_slip",), ("lambda_slip", "reactions", "x'")):
        made = prepare_jobs(system, scene, (), needs, reduced=True)
        wanted = [
            name for need in needs[-2:] for name in (("lambda_slip", "lambda_rod") if need == "reactions" else (need,))
        ]
        for job in made.jobs.values():
            assert sorted(column.heading for column in job.columns) == sorted(wanted)


def test_a_reduced_model_delivers_it() -> None:
    made = reduce_scene(bead("[lambda_slip]"), Options(scene="go"))
    assert [wanted.name for wanted in made.reduction.outputs] == ["lambda_slip"]


@pytest.mark.parametrize(
    ("need", "code", "help"),
    [
        ("[lambda_slip, lambda_slip]", "E0305", "keep one of them"),
        ("[reactions, lambda_slip]", "E0305", "`reactions` is all of them: leave it out, or the single ones"),
        ("[lambda_slip, reactions]", "E0305", "`reactions` is all of them: leave it out, or the single ones"),
        ("[lambda_slop]", "E0419", "did you mean `lambda_slip`?"),
    ],
)
def test_slips(need: str, code: str, help: str) -> None:
    with pytest.raises(SpecError) as raised:
        decode(bead(need))
    assert [(d.code, d.help) for d in raised.value.diagnostics] == [(code, (help,))]


def test_the_option_is_named_where_it_asks_for_what_is_not_there() -> None:
    with pytest.raises(RunError, match="`--need` names `lambda_slop`, which is no quantity of this spec") as raised:
        open_scene(bead("[x]"), "go", needs=("lambda_slop",))
    assert raised.value.help == ("did you mean `lambda_slip`?",)


def test_a_driver_prints_it_alone() -> None:
    program = emit(bead("[lambda_slip]"), "c", Options(driver=True))["bead_main.c"]
    assert ("lambda_slip" in program, "lambda_rod" in program) == (True, False)
