"""Starts of an ensemble: rows of a table, each made consistent like a scene's own start."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.diagnostics import SpecError, several, suggest
from nhc.language.expressions.names import fold_typed
from nhc.language.expressions.syntax import Number
from nhc.language.orientation import with_unit_quaternions
from nhc.language.spec import Initial, Override, Scene, Spec
from nhc.mechanics.starts.contradictions import PROJECT
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.mechanics.system import System
from nhc.records import record
from nhc.simulate.requests import RunError

_CELLS = "each row has one number for each name; an empty cell takes the scene's value"
_LONGEST = 60  # characters of a cell in a message

Key = tuple[str, str]
"""("coordinate", "velocity", "quasi" or "parameter", name)"""


@record
class Table:
    """``rows`` hold a number for each key, or None where the scene's own value stays."""

    keys: tuple[Key, ...]
    rows: tuple[tuple[float | None, ...], ...]


def read_starts(text: str, spec: Spec) -> Table:
    """The table of a CSV text with a header of the spec's names (``x`` , ``x'``, quasi-velocities, parameters).

    Raises:
        RunError: an unknown or repeated name, a row of another length, a cell that is no finite number, no rows.
    """
    try:
        header, *lines = [row for row in csv.reader(io.StringIO(text)) if row] or [[]]
    except csv.Error as error:
        raise RunError(f"this is no CSV table: {error}", ("a header of names, then one row for each start",)) from error
    known = _list_keys(spec)
    keys = tuple(_find_key(number, cell, known) for number, cell in enumerate(header, 1))
    for k, key in enumerate(keys):
        if key in keys[:k]:
            raise RunError(f"the header names `{_shorten(header[k])}` twice", ("keep one of the columns",))
    if not lines:
        raise RunError("the table has no starts", ("a header of names, then one row for each start",))
    return Table(keys, tuple(_read_row(number, header, line) for number, line in enumerate(lines, 1)))


def _shorten(cell: str) -> str:
    """A cell as a message shows it: what cannot be printed, or is long, is no table of the user's."""
    shown = "".join(letter if letter.isprintable() else "?" for letter in cell.strip())
    return shown if len(shown) <= _LONGEST else f"{shown[:_LONGEST]}..."


def _list_keys(spec: Spec) -> dict[str, Key]:
    known: dict[str, Key] = {}
    for parameter in spec.parameters:
        known[parameter.name] = ("parameter", parameter.name)
    for coordinate in spec.coordinates:
        known[coordinate.name] = ("coordinate", coordinate.name)
        known[f"{coordinate.name}'"] = ("velocity", coordinate.name)
    for quasi in spec.quasi_velocities:
        known[quasi.name] = ("quasi", quasi.name)
    return known


def _find_key(number: int, cell: str, known: dict[str, Key]) -> Key:
    name = fold_typed(cell)
    if name.endswith("dot") and name not in known:
        name = f"{name.removesuffix('dot')}'"
    if name in known:
        return known[name]
    hint = suggest(name, known, f"it can be {', '.join(known)}")
    if ";" in cell or "\t" in cell:
        hint = "part the columns by commas, and write decimal numbers with `.`"
    message = f"column {number} of the table, `{_shorten(cell)}`, is no coordinate, velocity or parameter of this spec"
    raise RunError(message, (hint,))


def _read_row(number: int, header: Sequence[str], line: Sequence[str]) -> tuple[float | None, ...]:
    if len(line) != len(header):
        raise RunError(
            f"row {number} has {several(len(line), 'value')}, the header {several(len(header), 'name')}", (_CELLS,)
        )
    values: list[float | None] = []
    for name, cell in zip(header, line, strict=True):
        try:
            value = float(cell) if cell.strip() else None
        except ValueError:
            value = math.nan
        if "_" in cell:  # Python's numbers may hold it, nobody else's
            value = math.nan
        if value is not None and not math.isfinite(value):
            raise RunError(f"row {number}: `{_shorten(cell)}` for `{_shorten(name)}` is not a finite number", (_CELLS,))
        values.append(value)
    return tuple(values)


def list_starts(system: System, scene: Scene, table: Table) -> list[Start]:
    """The consistent start of each row.

    Raises:
        RunError: a row that violates the constraints, with its number.
    """
    found = []
    for number, row in enumerate(table.rows, 1):
        try:
            found.append(start_of(system, vary(system.spec, scene, table.keys, row)))
        except SpecError as error:
            first = error.diagnostics[0]
            advice = [text for text in first.help if text != PROJECT]  # which is not for a table's rows
            raise RunError(f"row {number}: {first.message}", (*first.notes, *advice)) from error
    return found


def extreme_scenes(spec: Spec, scene: Scene, table: Table) -> tuple[Scene, ...]:
    """The scene at the rows that have the least or the largest value of a parameter; each row once, none without parameters."""
    found = dict[int, Scene]()
    for k, (kind, _) in enumerate(table.keys):
        given = [(value, number) for number, row in enumerate(table.rows) if (value := row[k]) is not None]
        if kind == "parameter" and given:
            for _, number in (min(given), max(given)):
                found[number] = vary(spec, scene, table.keys, table.rows[number])
    return tuple(found.values())


def vary(spec: Spec, scene: Scene, keys: Sequence[Key], row: Sequence[float | None]) -> Scene:
    """The scene with a row's values in place of its own."""
    given = {key: value for key, value in zip(keys, row, strict=True) if value is not None}
    numbers = {key: Fraction(value) for key, value in given.items()}
    parameters = {entry.name: entry for entry in scene.parameters}
    initial = {(entry.kind, entry.name): entry for entry in scene.initial}
    for (kind, name), value in numbers.items():
        if kind == "parameter":
            parameters[name] = Override(name, value, scene.span)
        else:
            initial[kind, name] = Initial(kind, name, Number(value, scene.span), scene.span)
    made = replace(scene, parameters=tuple(parameters.values()), initial=tuple(initial.values()))
    return with_unit_quaternions(spec.rotations, made, {name for _, name in numbers})
