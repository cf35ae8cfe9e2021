"""The spec language: reading, expressions, the Spec, its schema and its template."""

from nhc.diagnostics import Source

from .decode import decode
from .reading import read
from .spec import (
    FORMULATIONS,
    Constraint,
    Coordinate,
    Definition,
    Holonomic,
    Initial,
    Need,
    Override,
    Parameter,
    Scene,
    Spec,
)
from .syntax import Binary, Call, Differential, Name, Negate, Number, Prime, Syntax

__all__ = [
    "FORMULATIONS",
    "Binary",
    "Call",
    "Constraint",
    "Coordinate",
    "Definition",
    "Differential",
    "Holonomic",
    "Initial",
    "Name",
    "Need",
    "Negate",
    "Number",
    "Override",
    "Parameter",
    "Prime",
    "Scene",
    "Source",
    "Spec",
    "Syntax",
    "decode",
    "read",
]
