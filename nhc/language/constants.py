"""Definitions that parameters and numbers alone make up: like parameters, they are constant in each scene."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from nhc.language.expressions.names import PI
from nhc.language.expressions.syntax import Differential, Name, Prime, walk
from nhc.language.spec import Definition


def constant_definitions(definitions: Iterable[Definition], parameters: Collection[str]) -> tuple[Definition, ...]:
    """Those of the definitions, each of which comes after what it needs, that hold parameters, numbers and one another only."""
    known, found = {PI, *parameters}, list[Definition]()
    for definition in definitions:
        if all(
            node.name in known if isinstance(node, Name) else not isinstance(node, Prime | Differential)
            for node in walk(definition.value)
        ):
            known.add(definition.name)
            found.append(definition)
    return tuple(found)
