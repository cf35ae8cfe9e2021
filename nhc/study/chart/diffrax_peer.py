"""diffrax as a peer: the emitted JAX under its Dopri8, compiled once for all tolerances; that compilation is not in the times."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

from nhc.emit import EmitOptions, render
from nhc.simulate.interpreted import load_text
from nhc.study.chart.single import Rig
from nhc.study.chart.slope import absolute_tolerance

LANGUAGE, METHOD = "diffrax", "Dopri8"
MOST_OPERATIONS = 600  # XLA takes tens of seconds for larger right-hand sides in an adaptive loop
MOST_STEPS = 50_000


class NoDiffrax(Exception):
    """The right-hand side is too large for its compiler, or its run fails."""


def bind(rig: Rig) -> Callable[[bool, float], tuple[list[list[float]], int]]:
    """Runs at any tolerance: with the rows of the reference (and the number of steps), or with the last one alone.

    Raises:
        NoDiffrax: it is too large.
    """
    program = rig.job.program
    size = sum(f.adds + f.multiplications + f.divisions for f in program.functions if f.name == "rhs")
    if size > MOST_OPERATIONS:
        raise NoDiffrax(f"{size} operations are more than XLA compiles in good time")
    jax, numpy, diffrax = import_module("jax"), import_module("jax.numpy"), import_module("diffrax")
    jax.config.update("jax_enable_x64", True)
    (text,) = render(program, "python", EmitOptions(only=("rhs",), array="jax")).values()
    rhs = load_text(text, f"{program.system}_jax").rhs
    p, start = numpy.asarray(rig.job.p), numpy.asarray(rig.job.y)
    term = diffrax.ODETerm(lambda t, y, args: numpy.stack(numpy.asarray(rhs(t, y, p))))
    times = numpy.asarray(rig.times)

    def solve_at(save: Any) -> Any:
        def solve(relative: Any, absolute: Any) -> Any:
            control = diffrax.PIDController(rtol=relative, atol=absolute)
            found = diffrax.diffeqsolve(
                *(term, diffrax.Dopri8(), rig.times[0], rig.times[-1], None, start),
                saveat=save,
                stepsize_controller=control,
                max_steps=MOST_STEPS,
                throw=False,
            )
            return found.ys, found.stats["num_steps"], found.result == diffrax.RESULTS.successful

        return jax.jit(solve)

    every, last = solve_at(diffrax.SaveAt(ts=times)), solve_at(diffrax.SaveAt(t1=True))

    def run(rows: bool, tolerance: float) -> tuple[list[list[float]], int]:
        states, steps, good = (every if rows else last)(tolerance, absolute_tolerance(rig, tolerance))
        states.block_until_ready()
        if not rows:
            return [], 0
        if not bool(good):
            raise NoDiffrax("it stops before the end")
        return [[float(x) for x in row] for row in states], int(steps)

    return run
