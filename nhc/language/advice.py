"""What people write for something of this language, and how it is written here."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection

from nhc.diagnostics import quote
from nhc.language.expressions.loanwords import ACCELERATIONS
from nhc.language.expressions.names import ENERGIES, FUNCTIONS, is_name

_DOT, _DOTS = "\u0307", "\u0308"  # combining marks of first and second derivatives
# how a rate is spelled elsewhere; the most telling first
_RATES = tuple(
    map(
        re.compile,
        (r"(.+)_dot", r"dot_(.+)", r"d_?(.+?)_?dt", r"d_?(.+)", r"v_?(.+)", r"(.+)_dt?", r"(.+)_prime", r"(.+)dt"),
    )
)
_SECOND = re.compile(r"(.+?)_?(?:ddot|dotdot)|(?:ddot_?|dd_?|d2_?)(.+?)(?:_?dt2)?")
# key of a spec as others call it -> (this language's key, what to do)
_ENERGIES = "a Lagrangian is given by its energies: `T: ...`, and `V: ...` with L = T - V"
_FRICTION = "friction is given as forces: `forces: {x: -c*x'}`"
_UNITS = "a unit stands beside what has it: `coordinates: {x: {unit: m}}`, `parameters: {a: {value: 1, unit: m}}`"
_SCENE = "it belongs in a scene: `scenes: {go: {initial: {...}, time: [0, 10]}}`"
KEYS: dict[str, tuple[str, str]] = {
    **dict.fromkeys(("L", "lagrangian", "lagrange"), ("T", _ENERGIES)),
    **dict.fromkeys(("D", "dissipation", "rayleigh", "friction", "damping"), ("forces", _FRICTION)),
    **dict.fromkeys(("hamiltonian",), ("T", "give the energies in velocities: `T: ...` and `V: ...`")),
    **dict.fromkeys(("kinetic", "kinetic_energy"), ("T", "write `T: ...`")),
    **dict.fromkeys(("potential", "potential_energy"), ("V", "write `V: ...`")),
    **dict.fromkeys(("variables", "vars", "generalized_coordinates", "states", "state"), ("coordinates", "")),
    **dict.fromkeys(("constants", "const"), ("parameters", "")),
    **dict.fromkeys(("let", "where", "definitions", "expressions", "auxiliary"), ("define", "")),
    **dict.fromkeys(("holonomic_constraints", "geometric_constraints", "position_constraints"), ("holonomic", "")),
    **dict.fromkeys(("Q", "force", "torques", "inputs", "generalized_forces"), ("forces", "")),
    **dict.fromkeys(("velocities", "speeds", "pseudo_velocities", "quasivelocities"), ("quasi_velocities", "")),
    **dict.fromkeys(("nonholonomic", "nonholonomic_constraints", "constraint"), ("constraints", "")),
    **dict.fromkeys(("title", "description", "comment"), ("about", "")),
    **dict.fromkeys(("name",), ("system", "")),
    **dict.fromkeys(("unit", "units", "dimensions"), ("", _UNITS)),
    **dict.fromkeys(("initial", "initial_conditions", "ic", "time", "tspan", "need", "tolerance"), ("", _SCENE)),
}

# key of a scene as others call it -> this language's key
_SCENE_WORDS = {
    "time": ("t", "tspan", "t_span", "times", "duration", "interval"),
    "initial": ("initial_conditions", "initial_state", "initial_values", "ic", "x0", "q0", "start"),
    "need": ("needs", "output", "outputs", "want"),
    "tolerance": ("tol", "rtol", "accuracy"),
    "parameters": ("values", "constants", "params"),
}
SCENE_KEYS: dict[str, tuple[str, str]] = {
    word: (key, f"write `{key}`") for key, words in _SCENE_WORDS.items() for word in words
}

# key of a body or point as others call it -> this language's key
_BODY_KEYS: dict[str, str] = {
    **dict.fromkeys(("on", "base", "frame", "relative_to", "attached_to", "reference"), "parent"),
    **dict.fromkeys(("position", "origin", "offset", "location", "place", "pos"), "at"),
    **dict.fromkeys(("angles", "orientation", "turn", "joints", "joint", "rotate"), "turns"),
    **dict.fromkeys(("center", "com", "cog", "centre_of_mass", "center_of_mass"), "centre"),
    **dict.fromkeys(("moment", "moments", "moment_of_inertia", "i", "j"), "inertia"),
    **dict.fromkeys(("m", "weight"), "mass"),
}

# formulation as others call it -> this language's word
_FORMULATIONS: dict[str, str] = {
    **dict.fromkeys(
        ("hamel", "boltzmann-hamel", "poincare", "euler-poincare", "kane", "maggi", "appell"), "euler-lagrange"
    ),
    **dict.fromkeys(("dalembert", "lagrange-dalembert", "index-1", "dae", "reactions"), "multipliers"),
    **dict.fromkeys(("caplygin", "tchaplygin"), "chaplygin"),
    **dict.fromkeys(("voronets", "woronetz"), "voronec"),
    "newton-euler": "newton",
}


def meant_formulation(name: str) -> str:
    """The formulation that a word stands for elsewhere, or nothing."""
    spelled = unicodedata.normalize("NFD", name.casefold())
    plain = re.sub("[^a-z0-9-]", "", spelled.replace("_", "-").replace(" ", "-"))
    return _FORMULATIONS.get(plain, "")


def meant_scene_key(name: str, present: Collection[str]) -> tuple[str, str]:
    """The key of a scene that a word stands for elsewhere, and what to do about it, as :func:`meant_key` says it."""
    key, advice = SCENE_KEYS.get(name, ("", ""))
    return (key, advice) if key not in present else ("", "")


def meant_key(name: str, present: Collection[str]) -> tuple[str, str]:
    """The key of a spec that a word stands for elsewhere, and what to do about it.

    Empty where nothing is known, or that key is ``present``.
    """
    spelled = name if name in KEYS else name.casefold().replace("-", "_").replace(" ", "_")
    key, advice = KEYS.get(spelled, ("", "")) if len(spelled) > 1 or spelled == name else ("", "")
    if key in present:
        return "", ""
    return key, advice or (f"write `{key}`" if key else "")


def meant_body_key(name: str, present: Collection[str]) -> tuple[str, str]:
    """The key of a body or point that a word stands for elsewhere, and what to do about it, as :func:`meant_key`."""
    key = _BODY_KEYS.get(name.casefold().replace("-", "_").replace(" ", "_"), "")
    return ("", "") if not key or key in present else (key, f"write `{key}`")


def meant_rate(name: str, known: Collection[str]) -> str:
    """What to write where a name spells a rate as others do: ``theta_dot``, ``dtheta``, a dot above the letter."""
    parts = unicodedata.normalize("NFD", name)
    bare = unicodedata.normalize("NFC", parts.replace(_DOT, "").replace(_DOTS, ""))
    if bare in known and bare != name:
        if _DOTS in parts:
            return ACCELERATIONS
        return f"the velocity is written `{bare}'`"
    for spelling in _RATES:
        found = spelling.fullmatch(name)
        if found and found[1] in known:
            return f"the velocity is written `{found[1]}'`"
    second = _SECOND.fullmatch(name)
    return ACCELERATIONS if second and (second[1] or second[2]) in known else ""


def advise_need(name: str) -> str:
    """How a scene comes to need what it cannot name: a definition or an energy."""
    return f"show it under `outputs`: `{name if name not in ENERGIES else f'{name}_shown'}: {name}`"


def foreign_name(name: str, known: Collection[str]) -> str:
    """What to do about a name that means something elsewhere and nothing here; empty for others."""
    for function in FUNCTIONS:
        if name.startswith(function) and name.removeprefix(function) in known:
            return f"write `{function}({name.removeprefix(function)})`"
    if name == "e":
        return "a power of e is written `exp(...)`; another `e` is to be declared"
    if name in ("deg", "degree", "degrees"):
        return "angles are in radians: write `*pi/180`"
    if re.fullmatch(r"(lambda|reaction)s?_?\w*", name):
        return "reactions are no part of expressions: a scene asks for them by `need: [reactions]`"
    point = re.fullmatch(r"(.+)_v[xyz123]", name)
    if point and f"{point[1]}_x" in known and f"{point[1]}_cx" not in known:  # a body has that
        rates = quote([f"{point[1]}_{axis}'" for axis in "xyz" if f"{point[1]}_{axis}" in known])
        if f"{point[1]}_vx" in known:
            own = quote([f"{point[1]}_v{axis}" for axis in "xyz" if f"{point[1]}_v{axis}" in known])
            return f"`{point[1]}` has no parent body on whose axes this would be; in space its velocity is {own}"
        return f"`{point[1]}` is of no body, and has only the rates {rates}; `of` says whose matter moves with the velocity there"
    return ""


def meant_name(shown: str) -> str:
    """What to write for a text that is no name and stands where one is due."""
    if shown[:1].isdigit() and is_name(f"a{shown}"):
        return f"a name starts with no digit: write `{shown.lstrip('0123456789_') or 'a'}{shown[:1]}`, for example"
    parts = re.split(r"[\s,;]+", shown.strip(" ,;"))
    plain = re.sub(r"_*\W+_*", "_", unicodedata.normalize("NFKC", shown)).strip("_")
    if len(parts) == 1 and "'" not in shown and is_name(plain):  # x₁, l-1, $\mu$
        return f"write `{plain}`, for example: a name is made of letters, digits and `_`"
    if len(parts) > 1 and all(map(is_name, parts)):
        if ";" in shown:
            return f"commas separate names: write `{', '.join(parts)}`"
        return f"a name holds no blanks: write `{'_'.join(parts)}`, or `{', '.join(parts)}` for several names"
    pair = re.fullmatch(r"(\w+)\s+=\s+([^=]+)", shown)
    if pair and is_name(pair[1]):
        return f"write `{pair[1]}: {pair[2].strip()}`, without a `-` before it"
    return "a name is made of letters, digits and `_`, and starts with no digit"


def meant_entry(name: str, known: Collection[str]) -> str:
    """The entry of a matrix of rotation that others write with two numbers or two letters: `R_33` and `R_zz` are `R_z3`."""
    found = re.fullmatch(r"(.+?)_?([xyz123])_?([xyz123])", name)
    if not found:
        return ""
    base, row, column = found.groups()
    row, column = "xyz"["xyz123".index(row) % 3], "123"["xyz123".index(column) % 3]
    entry = f"{base}_{row}{column}"
    return entry if entry in known and entry != name else ""


def meant_force(name: str, offered: Collection[str]) -> str:
    """How a force on a whole body or point is given: by the components that these declare."""
    if f"{name}_w1" in offered:
        torque = f"a torque as `{name}_w1`, `{name}_w2` or `{name}_w3`"
        return f"write a force on a body by its components, as `{name}_x: ...` at its origin, {torque}"
    return f"write a force at a point by its components, as `{name}_x: ...`" if f"{name}_vx" in offered else ""
