"""The loop around a Runge-Kutta method in Python, step for step as ``templates/c/methods/loop.c.jinja`` has it."""

from __future__ import annotations

import math
import sys
from copy import copy
from dataclasses import replace

from nhc.program.ir import CORNER
from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods import collocation, explicit
from nhc.simulate.methods.step import NoSolution, Step
from nhc.simulate.methods.tableau import Explicit, Tableau
from nhc.simulate.stepping.beating import find_turn
from nhc.simulate.stepping.foretelling import expect_foretold, find_unmet, go_back, look_on
from nhc.simulate.stepping.holding import hold_end
from nhc.simulate.stepping.inside import has_more_stages, is_wild
from nhc.simulate.stepping.leaping import find_held, find_most, hop
from nhc.simulate.stepping.lengths import find_growth, guess_length, limit_growth
from nhc.simulate.stepping.rounding import is_faint, look_at_length, reconsider
from nhc.simulate.stepping.state import LEAST_ERROR, Run, Watched
from nhc.simulate.stepping.stops import cross, foresee, next_bound
from nhc.simulate.stepping.watching import (
    MOST_HALVINGS,
    approaches,
    find_change,
    find_event,
    find_trend,
    keep_signs,
    may_dip,
    may_touch,
    watch_start,
)
from nhc.simulate.task import (
    CROSSED,
    DONE,
    EVENT,
    HELD,
    NO_SOLUTION,
    SINGULAR,
    STALLED,
    STOPPED,
    TOO_MANY,
    UNDERFLOW,
    News,
    Outcome,
    Task,
)

_EPSILON = sys.float_info.epsilon


def integrate(model: Watched, method: Tableau, task: Task, news: News) -> Outcome:
    """Fill the rows of a task; the outcome says how far it came."""
    step = Step(model, task.p, task.times[0], list(task.y), 0.0 if task.step > 0 else task.tolerance)
    step.size = [max(a, b) for a, b in zip(step.size, task.sizes or step.size, strict=True)]
    run = Run(model, method, task, news, step, [list(task.y)], since=task.times[0])
    run.stop, run.bound = next_bound(task, step.t, 0)
    try:
        step.slope = step.rhs(step.t, step.y)
        run.before = watch_start(model, step.t, step.y, task.p, model.events)
        foresee(step, task)
        run.growth = limit_growth(method)
        run.former = 1.0  # no error came before
        run.next = guess_length(step, method, task.times[-1] - task.times[0])
        if model.dips < len(run.before):
            h = 1e-3 * math.copysign(run.next, task.times[-1] - task.times[0])
            run.trend, run.span = find_trend(step, model, run.before, h), 1e3 * h
        if (held := _leave_held(run, run.next)) is not None:
            return held
    except ArithmeticError as error:
        return run.leave(SINGULAR, getattr(error, "status", 0))
    while True:
        try:
            done = _advance(run)
        except ArithmeticError as error:
            done = run.leave(SINGULAR, getattr(error, "status", 0))
        if not _goes_back(run, done) and done is not None:
            return (_leave_held(run) if done.kind == UNDERFLOW else None) or done


def _remember(run: Run) -> None:
    """Before a step is taken that was held to foretold sizes: where the run goes back to if they are not reached."""
    s = run.step
    if not any(s.foretold):
        return
    if not s.expecting:
        run.back = replace(run, step=copy(s), states=list(run.states), ends=list(run.ends), back=None)
    expect_foretold(s)


def _goes_back(run: Run, done: Outcome | None) -> bool:
    """Whether sizes to come that steps were held to have not come by their time, or before the run ends (``done``): then it goes on
    from the first of these steps.
    """
    s, back = run.step, run.back
    if not s.expecting or back is None or (done is not None and done.kind == STOPPED):
        return False
    s.expecting = any(find_unmet(s))
    if not s.expecting or (done is None and s.h * (s.until - s.t) > 0.0):
        return False
    go_back(s, back.step)
    vars(run).update(vars(back) | {"step": s, "growth": 1.0, "former": 1.0, "next": abs(s.h)})
    return True


def _plan(run: Run) -> tuple[float, float] | None:
    """(end of the next step, its length without sign); None where the step is too short to count."""
    task, s = run.task, run.step
    start, end = task.times[0], task.times[-1]
    sign, rest = math.copysign(1.0, end - start), abs(run.bound - s.t)
    if task.step > 0:
        count = math.ceil(abs(end - start) / task.step - 1e-9)
        last = run.steps + 1 >= count
        reach = end if last else start + (end - start) * ((run.steps + 1) / count)
        return reach, abs(reach - s.t)
    run.next = min(run.next, abs(end - start))
    last = run.next >= 0.999 * rest
    h = rest if last else run.next
    reach = run.bound if last else s.t + sign * h
    return None if reach == s.t or (not last and h < 4 * _EPSILON * abs(s.t)) else (reach, h)


def _is_stalled(run: Run) -> bool:
    """Whether the rest would take more steps than any run does, if they stay as short as the last: a motion slides along a jump."""
    tried, s = run.steps + run.rejected, run.step
    if run.task.step > 0 or tried - run.marked < LIMITS.stride:
        return False
    passed, run.marked, run.since = abs(s.t - run.since), tried, s.t
    run.stalls = run.stalls + 1 if passed < LIMITS.few * abs(run.task.times[-1] - s.t) else 0
    if run.stalls > 0:  # what stalls it may be next to nothing
        s.floor_part = [1e-6] * len(s.y)
    return run.stalls >= LIMITS.patience


def _leave_held(run: Run, length: float = 0.0) -> Outcome | None:
    """An outcome where adaptive steps, the next of which has this ``length``, cannot leave a place at which the forces jump."""
    task, s = run.task, run.step
    if task.step > 0 or CORNER not in run.model.parts:
        return None
    way = task.times[-1] - task.times[0]
    held = find_held(s, run.model, math.copysign(length or guess_length(s, run.method, way), way))
    return run.leave(HELD, held) if held >= 0 else None


def _attempt(run: Run, reach: float) -> tuple[float, int]:
    """(error relative to what is allowed, outcome to leave with where it is no number)."""
    s, run.landing = run.step, 1.0
    try:
        error = _measure_error(run)
    except NoSolution:
        return math.nan, NO_SOLUTION
    except ArithmeticError as singular:
        s.status = getattr(singular, "status", 0)
        return math.nan, SINGULAR if s.status else UNDERFLOW
    if not all(map(math.isfinite, s.reached)):
        return math.nan, UNDERFLOW
    if error >= 0.0:
        run.most, run.landing = find_most(s, run.model, run.task, error, run.landings)
    if 0.0 <= error <= 1.0 and run.landing == 1.0:
        run.most = min(run.most, find_turn(s, run.model, run.task, run.method.turn))
        if run.most == 0.0:
            return math.nan, UNDERFLOW
    if 0.0 <= error <= 1.0 and run.model.holds and not hold_end(s, run.model, reach, run.steps == 0):
        return math.nan, SINGULAR
    return error, UNDERFLOW


def _measure_error(run: Run) -> float:
    """That of an attempt, with what rounding allows where it may be rounding that is too much."""
    s, method, twice = run.step, run.method, run.growth == 1.0
    error = explicit.attempt(s, method) if isinstance(method, Explicit) else collocation.attempt(s, method)
    if not error > 1.0 or not (twice or is_faint(s)):
        return error
    if isinstance(method, Explicit):
        return reconsider(s, error, twice, lambda: explicit.again(s, method))
    return reconsider(s, error, twice, lambda: collocation.attempt(s, method))


def _advance(run: Run) -> Outcome | None:
    """One step, accepted or not; an outcome where the run ends."""
    task, s = run.task, run.step
    duration = abs(task.times[-1] - task.times[0])
    if run.news.stop:
        return run.leave(STOPPED)
    if run.steps + run.rejected >= task.most:
        return run.leave(TOO_MANY)
    if _is_stalled(run):
        return run.leave(STALLED)
    if (run.steps + run.rejected + 1) % LIMITS.glance == 0 and (held := _leave_held(run)) is not None:
        return held
    plan = _plan(run)
    if plan is None:
        return run.leave(UNDERFLOW)
    reach, h = plan
    s.h, s.status = reach - s.t, 0
    error, reason = _attempt(run, reach)
    if run.landing < 1.0:
        run.rejected, run.landings, s.first, run.next = run.rejected + 1, run.landings + 1, True, run.landing * h
        return None
    if not 0.0 <= error <= 1.0:
        run.rejected += 1
        run.growth, run.landings, s.first = 1.0, 0, True
        run.next = h * (max(find_growth(run.method, error, run.former, True), 0.333) if error > 1.0 else 0.25)
        if task.step <= 0:
            square = error if isinstance(run.method, Explicit) else error * error
            s.learn_sizes(square if error > 1.0 else sys.float_info.max, run.method.trust)
        if task.step > 0 or run.next < 4 * _EPSILON * max(abs(s.t), 1e-3 * duration):
            return run.leave(reason, s.status)
        return None
    _remember(run)
    if task.step <= 0:
        growth = find_growth(run.method, error, run.former, False) if error > 0 else run.growth
        run.next = min(h * min(run.growth, max(growth, 0.333)), run.most)
        run.growth, run.former = limit_growth(run.method), max(error, LEAST_ERROR)
    start, landed = s.t, run.landings > 0
    done = _accept(run, reach)
    if landed and s.t != start:  # behind a corner the motion is another one
        run.landings, run.growth, run.former = 0, limit_growth(run.method), 1.0
        run.next = min(max(run.next, guess_length(s, run.method, task.times[-1] - task.times[0])), run.most)
        if done is None:
            done = _leave_held(run, run.next)
        if done is None:
            hop(s, run.model, run.next, run.bound)
    return done


def _accept(run: Run, reach: float) -> Outcome | None:
    task, s, model = run.task, run.step, run.model
    if _looks_inside(run) and is_wild(s):
        run.next, run.rejected = 0.25 * abs(s.h), run.rejected + 1
        return None
    if model.holds:
        s.arrived = s.rhs(reach, s.reached)
    cut, which = 2.0, -1
    if model.watched:
        before, after = run.before, model.watch(reach, s.reached, task.p)
        if approaches(before, after, model.frames) and _halves(run):
            return None
        near = bool(run.trend) and may_dip(run.before, run.trend, after, s.h, run.span, model.dips)
        near = near and may_touch(s, model, run.before, after)
        if run.trend:
            run.span, run.trend = s.h, [(b - a) / s.h for a, b in zip(run.before, after, strict=True)]
        if model.events or near or find_change(run.before, after) >= 0:
            cut, which = _find_event(run)
            weak = model.frames[1] > 0 and which >= model.frames[0]
            if weak and after[which] > 0.0 < before[which] and _halves(run):
                run.before = before
                return None
        run.halved = 0
        run.before = keep_signs(run.before, after)
    _fill(run, cut)
    run.steps += 1
    if task.logged:
        run.ends.append(reach)
    if which >= 0:
        s.y, s.t = _point(run, cut), s.t + cut * s.h
        s.seen = [max(a, abs(b)) for a, b in zip(s.seen, s.y, strict=True)] if s.expecting else s.seen
        return run.leave(EVENT if which < model.events else CROSSED, which)
    if s.expecting:
        look_on(s, run.method)
    s.move(reach)
    if task.step <= 0 and reach != run.bound:
        look_at_length(s)
    run.news.t = reach
    if reach == task.times[-1]:
        return run.leave(DONE)
    return _pass_stop(run) if reach == run.bound else None


def _looks_inside(run: Run) -> bool:
    """Whether rows or events lie in the step, so that the interpolant is made, and may be worse than the end."""
    s, due = run.step, run.task.times[len(run.states)]
    inside = run.model.events > 0 or (due - s.t) / s.h < 1.0 - 1e-12
    return inside and run.task.step <= 0 and has_more_stages(run.method) and bool(_point(run, 0.5))


def _halves(run: Run) -> bool:
    """Whether the step is not taken but halved, for it comes too near to a singular place or has gone over it."""
    if run.task.step > 0 or run.halved >= MOST_HALVINGS:
        return False
    run.next = 0.5 * abs(run.step.h)
    run.halved += 1
    run.rejected += 1
    return True


def _pass_stop(run: Run) -> Outcome | None:
    """The run goes on behind a stop, where the slope may be another one; nothing moves at a jump."""
    s, task = run.step, run.task
    s.t, rows = cross(task, s.t, run.stop, len(run.states))
    run.states += [list(s.y) for _ in range(rows)]
    run.stop, run.bound = next_bound(task, s.t, run.stop)
    if s.t == task.times[-1]:
        return run.leave(DONE)
    s.first, s.longest_since, run.next = True, 0.0, max(run.next, 4 * _EPSILON * abs(s.t))
    s.slope = s.rhs(s.t, s.y)
    return _leave_held(run, run.next)


def _point(run: Run, part: float) -> list[float]:
    s = run.step
    if s.shape is None:
        module = explicit if isinstance(run.method, Explicit) else collocation
        s.shape = module.shape(s, run.method)
    return s.interpolate(part)


def _fill(run: Run, cut: float) -> None:
    s, times = run.step, run.task.times
    while len(run.states) < len(times):
        part = (times[len(run.states)] - s.t) / s.h
        if part > cut or part > 1.0 + 1e-12:
            return
        if part >= 1.0 - 1e-12:
            run.states.append(list(s.reached))
        else:
            point = _point(run, part)
            run.states.append(run.model.hold(times[len(run.states)], point, run.task.p) if run.model.holds else point)


def _find_event(run: Run) -> tuple[float, int]:
    """(part of the step, index of the watched value) where one changes its sign; (2, -1) where none does."""
    s, task = run.step, run.task

    def look(part: float) -> list[float]:
        y = s.reached if part == 1.0 else _point(run, part)
        return run.model.watch(s.t + part * s.h, y, task.p)

    _point(run, 0.5)  # makes the interpolant
    cut, which, run.before = find_event(look, run.before, run.model.events, run.model.dips)
    return cut, which
