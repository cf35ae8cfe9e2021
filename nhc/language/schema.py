"""The JSON Schema of a spec (draft 2020-12), for editors; made from the table of keys."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from nhc.diagnostics import quote
from nhc.language.keys import (
    BODY_KEYS,
    CIRCLE_KEYS,
    COORDINATE_KEYS,
    DRAW_KEYS,
    DRAWN_BODY_KEYS,
    INERTIA_KEYS,
    NEAR_KEYS,
    PARAMETER_KEYS,
    POINT_KEYS,
    ROTATION_KEYS,
    SCENE_KEYS,
    SPEC_KEYS,
    START_KEYS,
    SYSTEM_PATTERN,
    VERSION,
    Key,
)
from nhc.language.spec import FIGURES

_NAME = "^[A-Za-z_\\u0080-\\uffff][A-Za-z0-9_\\u0080-\\uffff]*$"
_TARGET = "^[A-Za-z_\\u0080-\\uffff][A-Za-z0-9_\\u0080-\\uffff]*['\\u2032]?$"
_FILLED = {"type": "string", "minLength": 1}
_VALUE = {"anyOf": [{"type": "number"}, _FILLED]}


def _named(value: dict[str, Any], pattern: str = _NAME) -> dict[str, Any]:
    return {"type": "object", "propertyNames": {"pattern": pattern}, "additionalProperties": value}


def _listed(item: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": item}


def _numbers(least: int, most: int) -> dict[str, Any]:
    return {**_listed(_VALUE), "minItems": least, "maxItems": most}


_EQUATION = {
    "anyOf": [
        {"type": "string", "pattern": "="},
        {**_named({"type": "string", "pattern": "="}), "minProperties": 1, "maxProperties": 1},
    ]
}


def _object(keys: Sequence[Key]) -> dict[str, Any]:
    found: dict[str, Any] = {
        "type": "object",
        "properties": {key.name: {"description": key.about, **_shape(key)} for key in keys},
        "additionalProperties": False,
    }
    required = [key.name for key in keys if key.required]
    return {**found, "required": required} if required else found


def _shape(key: Key) -> dict[str, Any]:
    return {"enum": list(key.choices)} if key.kind == "choice" else SHAPES[key.kind]()


def _names(least: int, most: int) -> dict[str, Any]:
    return {**_listed({"type": "string", "pattern": _NAME}), "minItems": least, "maxItems": most}


def _names_or(keyed: dict[str, Any], least: int = 1) -> dict[str, Any]:
    """A list of names, or each of them with more about it."""
    size = {"minItems": 1} if least else {}
    names = {**_listed({"type": "string", "pattern": _NAME}), **size, "uniqueItems": True}
    return {"anyOf": [names, {**keyed, "minProperties": 1} if least else keyed]}


def _places(least: int) -> dict[str, Any]:
    return {**_listed(_numbers(2, 3)), "minItems": least}


def _turns() -> dict[str, Any]:
    turn = {"type": "object", "minProperties": 1, "maxProperties": 1, "additionalProperties": False}
    return _listed({**turn, "properties": {axis: _VALUE for axis in "xyz"}})


def _figures() -> dict[str, Any]:
    one = {"oneOf": [{"required": [kind]} for kind in FIGURES]}
    return _listed({**_object(DRAW_KEYS), **one})


SHAPES: dict[str, Callable[[], dict[str, Any]]] = {
    "version": lambda: {"enum": [VERSION, str(VERSION)]},
    "system": lambda: {"type": "string", "pattern": f"^{SYSTEM_PATTERN}$"},
    "text": lambda: {"type": ["string", "number", "boolean"]},
    "texts": lambda: {"anyOf": [_FILLED, _listed(_FILLED)]},
    "flag": lambda: {"type": "boolean"},
    "unit": lambda: {"anyOf": [_FILLED, {"const": 1}]},
    "name": lambda: {"type": "string", "pattern": _NAME},
    "names": lambda: _listed({"type": "string", "pattern": _TARGET}),
    "needs": lambda: {
        "anyOf": [{"type": "string", "pattern": _TARGET}, _listed({"type": "string", "pattern": _TARGET})]
    },
    "three": lambda: _names(3, 3),
    "four": lambda: _names(4, 4),
    "order": lambda: {"type": "string", "pattern": "^[xyz]{3}$"},
    "number": lambda: _VALUE,
    "numbers": lambda: _named(_VALUE),
    "interval": lambda: _numbers(2, 2),
    "expression": lambda: _VALUE,
    "expressions": lambda: _named(_VALUE),
    "equations": lambda: _listed(_EQUATION),
    "coordinates": lambda: _names_or(_named(_object(COORDINATE_KEYS))),
    "rotations": lambda: _names_or(_named(_object(ROTATION_KEYS))),
    "parameters": lambda: _names_or(_named({"anyOf": [_VALUE, _object(PARAMETER_KEYS)]}), least=0),
    "bodies": lambda: {**_named(_object(BODY_KEYS)), "minProperties": 1},
    "points": lambda: {**_named(_object(POINT_KEYS)), "minProperties": 1},
    "turns": _turns,
    "inertia": lambda: {"anyOf": [_VALUE, _numbers(3, 3), _object(INERTIA_KEYS)]},
    "scenes": lambda: _named(_object(SCENE_KEYS)),
    "start": lambda: _named({"anyOf": [_VALUE, _numbers(4, 4), _object(START_KEYS), _object(NEAR_KEYS)]}, _TARGET),
    "figures": _figures,
    "body": lambda: {**_object(DRAWN_BODY_KEYS), "required": ["shape"]},  # `at` and `angle` where it is not on a body
    "circle": lambda: _object(CIRCLE_KEYS),
    "polygon": lambda: _places(3),  # of three numbers on a body in space
    "places": lambda: _places(2),
    "place": lambda: _numbers(2, 3),
    "spot": lambda: _numbers(2, 2),
    "vector": lambda: _numbers(3, 3),
}
"""By the kind of a key, what its value may be; the values of a ``choice`` stand with the key."""


def _as_change(tree: dict[str, Any]) -> dict[str, Any]:
    """The schema of what is merged with a base: nothing is required, and an entry that is null leaves the base's out."""
    made: dict[str, Any] = {key: _as_change(value) if isinstance(value, dict) else value for key, value in tree.items()}
    for key in ("anyOf", "oneOf"):
        if key in made:
            made[key] = [_as_change(way) for way in made[key]]
    if "properties" in made:
        made["properties"] = {name: _or_null(value) for name, value in made["properties"].items()}
    if isinstance(made.get("additionalProperties"), dict):
        made["additionalProperties"] = _or_null(made["additionalProperties"])
    if made.get("type") == "object":
        for key in ("required", "minProperties"):
            made.pop(key, None)
    return made


def _or_null(value: dict[str, Any]) -> dict[str, Any]:
    if "type" in value:
        kinds = value["type"] if isinstance(value["type"], list) else [value["type"]]
        return {**value, "type": [*kinds, "null"]}
    if "enum" in value:
        return {**value, "enum": [*value["enum"], None]}
    return {**value, "anyOf": [*value["anyOf"], {"type": "null"}]}


def schema() -> dict[str, Any]:
    """Return the schema as a tree that ``json.dumps`` takes.

    What stands at its top is all that a spec with `extends` must fit; another one fits ``whole`` too.
    """
    filled = {"not": {"type": "null"}}
    whole = _object(SPEC_KEYS)
    required = whole.pop("required")
    ways = [
        [{"coordinates": placed, "T": energy}.get(key, key) for key in required]
        for placed in ("coordinates", "rotation")
        for energy in ("T", "bodies")
    ]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"nhc spec, language version {VERSION}",
        **_as_change(whole),
        "required": ["nhc"],
        "anyOf": [{"required": keys} for keys in (["extends"], *ways)],
        "not": {"required": ["U", "V"], "properties": {"U": filled, "V": filled}},
        "if": {"not": {"required": ["extends"]}},
        "then": {"$ref": "#/$defs/whole"},
        "$defs": {"whole": whole},
    }


def reference_table() -> str:
    """Return the keys of the language as Markdown tables, for the reference."""
    parts = []
    tables = {
        "spec": SPEC_KEYS,
        "coordinate": COORDINATE_KEYS,
        "rotation": ROTATION_KEYS,
        "start of a coordinate": NEAR_KEYS,
        "start of a rotation": START_KEYS,
        "body": BODY_KEYS,
        "body's inertia": INERTIA_KEYS,
        "point": POINT_KEYS,
        "parameter": PARAMETER_KEYS,
        "scene": SCENE_KEYS,
        "shape to draw": DRAW_KEYS,
        "circle": CIRCLE_KEYS,
        "body to draw": DRAWN_BODY_KEYS,
    }
    for title, keys in tables.items():
        rows = [f"| `{key.name}` | {'yes' if key.required else ''} | {_about(key)} |" for key in keys]
        head = [f"### Keys of a {title}", "", "| key | required | what it is |", "|---|---|---|"]
        parts.append("\n".join([*head, *rows]))
    return "\n\n".join(parts) + "\n"


def _about(key: Key) -> str:
    choices = quote(key.choices)
    return f"{key.about}: {choices}" if choices else key.about
