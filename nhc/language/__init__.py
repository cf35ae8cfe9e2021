"""The spec language: reading, expressions, the Spec.  Beside them stand its `schema`, a `template` and `unparse`."""

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
from .syntax import Binary, Call, Differential, Name, Negate, Number, Prime, Syntax, fold_tree, same, walk

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
