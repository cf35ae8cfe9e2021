"""A function with its sweeps, rolled: what each body computes has one layout, which the sweeps know."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from nhc.emit.c.rolled.cells import Cells, Layout, UnfitError, furnish
from nhc.emit.c.rolled.lines import CARRIED, KEPT, Body, may_roll
from nhc.emit.c.rolled.loops import LoopWriter
from nhc.emit.c.rolled.roll import SEED, Rolled, roll
from nhc.emit.names import list_bound_names
from nhc.emit.statements import collect_refs
from nhc.program.ir import Load, Statement, Sweep


def roll_function(
    loads: Mapping[str, Load], straight: Sequence[Statement], sweeps: Sequence[Sweep], longest: int
) -> tuple[Body, tuple[Body | None, ...]] | None:
    """The straight code and the sweeps with loops, each where that makes it much shorter; None where nothing does."""
    given = set(list_bound_names(straight))
    turned: list[Rolled | None] = []
    for sweep in sweeps:
        seeds = {name: Load(name, SEED, k) for k, name in enumerate(sweep.seeds)}
        turned.append(roll(sweep.body, {**loads, **seeds}, given) if may_roll(sweep.body, longest) else None)
    found = [rolled for rolled in turned if rolled]
    hints = [names for rolled in found for names in rolled.list_hints()]
    main = roll(straight, loads, (), hints) if may_roll(straight, longest) else None
    try:
        cells = _ask(main, found)
    except UnfitError:  # sweeps need what this body's loops compute in an order that these do not have
        main, cells = None, _ask(None, found)
    if main is None and not found:
        return None
    taken = {*given, *loads, *(name for sweep in sweeps for name in list_bound_names([sweep]))}
    bodies = [(rolled, furnish(rolled.cells)) if rolled else None for rolled in turned]
    wanted = {name for sweep in sweeps for name in collect_refs(sweep)} & given if main else set[str]()
    if main:
        main.ask_singles(wanted)
    layout = furnish(cells)
    empty = Layout(0, {}, {})
    done: list[Body | None] = []
    for pair in bodies:
        done.append(_finish(LoopWriter(pair[0], CARRIED, pair[1], KEPT, layout, taken)) if pair else None)
    if main:
        return _finish(LoopWriter(main, KEPT, layout, "", empty, taken)), tuple(done)
    return Body(tuple(straight), layout.places, layout.size, ()), tuple(done)


def roll_body(loads: Mapping[str, Load], lines: Sequence[Statement], longest: int) -> Body | None:
    """Code without sweeps."""
    found = roll_function(loads, lines, (), longest)
    return found[0] if found else None


def _ask(main: Rolled | None, sweeps: Iterable[Rolled]) -> Cells:
    """The cells of the straight code, with what sweeps need of it.  Raises UnfitError."""
    cells = main.cells if main else Cells()
    for rolled in sweeps:
        rolled.ask_numbers(cells)
    return cells


def _finish(writer: LoopWriter) -> Body:
    before = set(writer.taken)
    lines = tuple(writer.write())
    return Body(lines, writer.own.places, writer.own.size, tuple(sorted(writer.taken - before)))
