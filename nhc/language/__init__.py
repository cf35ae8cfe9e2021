"""The spec language: reading, expressions, the Spec, its schema and its template."""

from nhc.diagnostics import Source

from .decode import decode
from .reading import read
from .schema import reference_table, schema
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
from .template import template
from .unparse import unparse

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
    "reference_table",
    "same",
    "schema",
    "template",
    "unparse",
    "walk",
]
