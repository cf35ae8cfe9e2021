"""The JSON Schema of a spec (draft 2020-12), for editors; made from the table of keys."""

from __future__ import annotations

from collections.abc import Sequence
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
_EXPRESSION = _VALUE


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
    match key.kind:
        case "version":
            return {"const": VERSION}
        case "system":
            return {"type": "string", "pattern": f"^{SYSTEM_PATTERN}$"}
        case "text":
            return {"type": ["string", "number", "boolean"]}
        case "unit":
            return {"anyOf": [_FILLED, {"const": 1}]}
        case "texts":
            return {"anyOf": [_FILLED, _listed(_FILLED)]}
        case "choice":
            return {"enum": list(key.choices)}
        case "expression" | "number":
            return _VALUE
        case "expressions" | "numbers":
            return _named(_VALUE)
        case "start":
            return _named({"anyOf": [_VALUE, _numbers(4, 4), _object(START_KEYS), _object(NEAR_KEYS)]}, _TARGET)
        case "rotations":
            names = {**_listed({"type": "string", "pattern": _NAME}), "minItems": 1, "uniqueItems": True}
            return {"anyOf": [names, {**_named(_object(ROTATION_KEYS)), "minProperties": 1}]}
        case "three" | "four":
            count = 3 if key.kind == "three" else 4
            return {**_listed({"type": "string", "pattern": _NAME}), "minItems": count, "maxItems": count}
        case "name":
            return {"type": "string", "pattern": _NAME}
        case "bodies" | "points":
            return {**_named(_object(BODY_KEYS if key.kind == "bodies" else POINT_KEYS)), "minProperties": 1}
        case "turns":
            turns = {"type": "object", "minProperties": 1, "maxProperties": 1, "additionalProperties": False}
            return _listed({**turns, "properties": {axis: _VALUE for axis in "xyz"}})
        case "inertia":
            return {"anyOf": [_VALUE, _numbers(3, 3), _object(INERTIA_KEYS)]}
        case "order":
            return {"type": "string", "pattern": "^[xyz]{3}$"}
        case "equations":
            return _listed(_EQUATION)
        case "names":
            return _listed({"type": "string", "pattern": _TARGET})
        case "interval":
            return _numbers(2, 2)
        case "coordinates":
            names = {**_listed({"type": "string", "pattern": _NAME}), "minItems": 1, "uniqueItems": True}
            return {"anyOf": [names, {**_named(_object(COORDINATE_KEYS)), "minProperties": 1}]}
        case "parameters":
            names = {**_listed({"type": "string", "pattern": _NAME}), "uniqueItems": True}
            return {"anyOf": [names, _named({"anyOf": [_VALUE, _object(PARAMETER_KEYS)]})]}
        case "scenes":
            return _named(_object(SCENE_KEYS))
        case _:
            return _drawn_shape(key)


def _drawn_shape(key: Key) -> dict[str, Any]:
    match key.kind:
        case "flag":
            return {"type": "boolean"}
        case "place":
            return _numbers(2, 3)
        case "places":
            return {**_listed(_numbers(2, 3)), "minItems": 2}
        case "spot":
            return _numbers(2, 2)
        case "vector":
            return _numbers(3, 3)
        case "polygon":
            return {**_listed(_numbers(2, 3)), "minItems": 3}  # three numbers on a body in space
        case "circle":
            return _object(CIRCLE_KEYS)
        case "body":
            return {**_object(DRAWN_BODY_KEYS), "required": ["shape"]}  # `at` and `angle` where it is not on a body
        case "figures":
            one = {"oneOf": [{"required": [kind]} for kind in FIGURES]}
            return _listed({**_object(DRAW_KEYS), **one})
        case _:
            raise ValueError(key.kind)


def _spec() -> dict[str, Any]:
    """A spec that extends another need not hold what that has."""
    made = _object(SPEC_KEYS)
    required = made.pop("required")
    ways = [{"required": ["extends"]}]
    for placed in ("coordinates", "rotation"):
        for energy in ("T", "bodies"):
            other = {"coordinates": placed, "T": energy}
            ways.append({"required": [other.get(key, key) for key in required]})
    return {**made, "required": ["nhc"], "anyOf": ways}


def schema() -> dict[str, Any]:
    """Return the schema as a tree that ``json.dumps`` takes."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"nhc spec, language version {VERSION}",
        **_spec(),
        "not": {"required": ["U", "V"]},
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
