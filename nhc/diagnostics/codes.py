"""The registry of diagnostic codes; each has one page of explanation beside it.

E01xx reading and YAML, E02xx expressions, E03xx the spec's content, E04xx mechanics, E05xx emission and command line;
a code that starts with W is a warning.
"""

from __future__ import annotations

from pathlib import Path

TITLES: dict[str, str] = {
    "E0101": "the file cannot be read",
    "E0102": "the file is not plain UTF-8 text",
    "E0103": "the file is too large",
    "E0104": "YAML syntax error",
    "E0105": "duplicate key",
    "E0106": "anchor or alias",
    "E0107": "tag",
    "E0108": "several documents",
    "E0109": "empty value",
    "E0110": "lists or mappings nested too deep",
    "E0111": "empty spec",
    "E0112": "the base cannot be extended",
    "E0201": "unexpected character",
    "E0202": "unexpected token",
    "E0203": "implicit multiplication",
    "E0204": "unbalanced parenthesis",
    "E0205": "expression too deep or too long",
    "E0206": "function used wrongly",
    "E0207": "second time derivative",
    "E0208": "misplaced or missing `=`",
    "E0209": "differential out of place",
    "E0210": "malformed number",
    "E0212": "time derivative of a constant",
    "E0301": "wrong type of value",
    "E0302": "unknown name",
    "E0303": "unknown key",
    "E0304": "missing key",
    "E0305": "name declared twice",
    "E0306": "reserved name",
    "E0307": "malformed name",
    "E0308": "definitions form a cycle",
    "E0309": "unsupported language version",
    "E0310": "malformed system name",
    "E0311": "both `U` and `V`",
    "E0312": "not one of the allowed words",
    "E0313": "value out of range",
    "E0314": "value is not constant",
    "E0315": "wrong number of dependent velocities",
    "E0316": "unknown unit",
    "E0317": "impossible rotation",
    "E0318": "impossible body",
    "E0401": "constraint not linear in the velocities",
    "E0402": "dependent constraints",
    "E0403": "contradictory constraints",
    "E0404": "singular mass matrix",
    "E0405": "potential depends on velocities",
    "E0406": "quasi-velocities are no basis",
    "E0407": "choice of dependent velocities is singular",
    "W0408": "choice of dependent velocities is singular somewhere",
    "E0409": "initial state violates a constraint",
    "W0410": "integrable constraint",
    "E0411": "formulation does not apply",
    "E0412": "quasi-velocity not linear in the velocities",
    "E0413": "units do not fit",
    "E0414": "time derivative of a velocity",
    "E0415": "holonomic constraint depends on velocities",
    "W0416": "kink or jump",
    "E0417": "division by zero",
    "E0418": "parameter without a value",
    "E0419": "unknown name in a scene",
    "E0420": "no motion is left",
    "W0421": "scene that cannot run",
    "W0422": "no motion for the values given",
    "W0423": "negative kinetic energy",
    "E0424": "force on what has no linear velocity",
    "W0425": "quasi-velocities that lose digits",
    "W0426": "coordinate without inertia",
    "W0427": "inertia that no body has",
    "W0428": "prime that may be lost",
    "W0429": "start outside of a declared range",
    "W0430": "units that do not go together",
    "W0431": "an angle that looks like degrees",
    "E0501": "file would be overwritten",
    "E0502": "unknown stage",
    "E0503": "no such scene",
    "E0504": "cannot be emitted as asked",
    "E0505": "models cannot be compared",
    "E0506": "specs cannot be compared",
}


def codes() -> tuple[str, ...]:
    """Return all codes, in the order of the registry."""
    return tuple(TITLES)


def page(code: str) -> str:
    """Return the page of a code as Markdown; raises ``KeyError`` for a code that is not registered."""
    name = code.strip().upper()
    if name not in TITLES:
        raise KeyError(code)
    return (Path(__file__).parent / "pages" / f"{name}.md").read_text(encoding="utf-8")
