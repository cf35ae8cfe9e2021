"""The spec language: reading, expressions, the Spec.  Beside them stand its `schema`, a `template` and `unparse`."""

from nhc.diagnostics import Source
from nhc.language.decode import decode
from nhc.language.expressions.syntax import (
    Binary,
    Call,
    Differential,
    Name,
    Negate,
    Number,
    Prime,
    Syntax,
    fold_tree,
    same,
    walk,
)
from nhc.language.reading import read
from nhc.language.spec import (
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
    "fold_tree",
    "read",
    "same",
    "walk",
]
