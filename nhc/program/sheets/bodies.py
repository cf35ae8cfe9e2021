"""Bodies and points in words, and what the names mean that they bring: only of those that occur."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

from nhc.language.expressions.names import fold
from nhc.language.spec import Spec
from nhc.program.sheets.draft import DraftSheet
from nhc.program.sheets.model import Mark, Prose, Sheet, Statement, Symbol, Table

_OF_BODIES = (
    (("x", "y", "z"), "a coordinate", "the coordinates", " of its origin in space"),
    (("cx", "cy", "cz"), "a coordinate", "the coordinates", " of its centre of mass in space"),
    (
        tuple(f"{axis}{k}" for k in (1, 2, 3) for axis in "xyz"),
        "a component",
        "components",
        " in space of its axes 1, 2, 3",
    ),
    (("w1", "w2", "w3"), "a component", "components", " of its angular velocity on its own axes"),
    (("angle",), "the angle of its last turn", "", ""),
    (("T",), "its kinetic energy", "", ""),
)
_OF_POINTS = (
    (("x", "y", "z"), "a coordinate", "the coordinates", " of it in space"),
    (("vx", "vy", "vz"), "a component", "components", " of the velocity in space of the matter there"),
    (
        ("v1", "v2", "v3"),
        "a component",
        "components",
        " of the velocity of the matter there, on the axes on which the point is placed",
    ),
)
_Meaning = tuple[tuple[str, ...], str, str, str]
"""Ends of names, and what one of them is, or several are, of what."""


def say_bodies(spec: Spec, sheet: DraftSheet) -> None:
    """Where bodies stand, how they turn, what they weigh; the letters of T and of the constraints follow from that."""
    if spec.bodies:
        sheet.say(
            "The bodies, each with what it stands on, its turns from there one after another, and its mass on its own axes:"
        )
    for body in spec.bodies:
        place = f", its origin at {_vector(body.at)}" if body.at else ""
        turns = [f"by {_math(angle)} about {axis}" for axis, angle in body.turns]
        turned = f", turned {', '.join(turns)}" if turns else f", turned by `{body.rotation}`" if body.rotation else ""
        parts = [f"`{body.name}` on `{body.on}`" if body.on else f"`{body.name}` in space", place, turned]
        if body.mass:
            centre = f" with its centre at {_vector(body.centre)}" if body.centre else ""
            parts.append(f"; mass {_math(body.mass)}{centre}")
        if body.inertia:
            parts.append(f"; {_moments(body.inertia)}")
        sheet.say(f"- {''.join(parts)}{_about(body.about)}")
    if spec.points:
        sheet.say("The points, each with the body on whose axes it is placed, and the one whose matter moves there:")
    for point in spec.points:
        whose = f", with the matter of `{point.of}`" if point.of != point.on else ""
        where = f"on `{point.on}`" if point.on else "in space"
        sheet.say(f"- `{point.name}` {where} at {_vector(point.at)}{whose}{_about(point.about)}")


def _about(text: str) -> str:
    return f" ({text.rstrip('.')})." if text[:1].islower() else f". {text}".rstrip()


def _moments(entries: tuple[tuple[str, str], ...]) -> str:
    keys = [key for key, _ in entries]
    if keys == [""]:
        return f"moment of inertia {_math(entries[0][1])}"
    if keys == ["xx", "yy", "zz"]:
        return f"moments of inertia {_vector(tuple(text for _, text in entries))}"
    return "inertia matrix " + ", ".join(f"{_math(text)} at {key}" for key, text in entries)


def _vector(parts: tuple[str, ...]) -> str:
    shown = parts[:2] if parts[2] == "0" else parts
    return f"({', '.join(_math(part) for part in shown)})"


def _math(text: str) -> str:
    """An expression of the user's with the names that formulas have."""
    folded = re.sub(r"[^\W\d]\w*", lambda name: fold(name[0]), text)
    return f"${folded}$"


def explain_names(spec: Spec, sheets: Sequence[Sheet], symbols: Mapping[str, Symbol]) -> tuple[Sheet, ...]:
    """The sheets with a sentence behind the bodies and points on the names of theirs that occur in any sheet."""
    used = {name for name in _list_names(sheets, symbols) if spec.is_brought(name)}
    texts = [
        _explain(f"Indices at the name of a {what}: ", [entry.name for entry in entries], meanings, used)
        for what, entries, meanings in (("body", spec.bodies, _OF_BODIES), ("point", spec.points, _OF_POINTS))
    ]
    text = " ".join(filter(None, texts))
    if not text:
        return tuple(sheets)
    first, *others = sheets
    at = 1 + max(k for k, item in enumerate(first.items) if isinstance(item, Prose) and item.text.startswith("- "))
    return (replace(first, items=(*first.items[:at], Prose(text), *first.items[at:])), *others)


def _explain(start: str, owners: Sequence[str], meanings: Sequence[_Meaning], used: Collection[str]) -> str:
    parts = []
    for ends, one, several, whose in meanings:
        found = [end for end in ends if any(f"{owner}_{end}" in used for owner in owners)]
        if found:
            parts.append(f"{', '.join(found)} {f'are {several}' if len(found) > 1 else f'is {one}'}{whose}")
    return f"{start}{'; '.join(parts)}." if parts else ""


def _list_names(sheets: Sequence[Sheet], symbols: Mapping[str, Symbol]) -> Iterator[str]:
    for sheet in sheets:
        for item in (*sheet.lets, *sheet.items):
            if isinstance(item, Statement):
                yield from (mark.base for term in (*item.left, *item.right) for mark in term.factors)
            elif isinstance(item, Table):
                yield from (cell.base for row in item.rows for cell in row if isinstance(cell, Mark))
            elif isinstance(item, Prose):
                yield from (word for part in re.findall(r"\$([^$]*)\$", item.text) for word in re.findall(r"\w+", part))
    yield from (symbol.mark.base for symbol in symbols.values())
