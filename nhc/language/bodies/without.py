"""Specs without bodies: as they are, or with their bodies written out."""

from __future__ import annotations

from nhc.diagnostics import Bag
from nhc.language.bodies.plain import Plain
from nhc.language.keys import BODILY
from nhc.language.yaml_tree.nodes import Table


def without_bodies(root: Table, bag: Bag, asked: str = "") -> Plain:
    """The spec with its ``bodies`` written out; names in the expression ``asked`` count as used."""
    if not any(text.value in BODILY for text, _ in root.entries):
        return Plain(root)
    from nhc.language.bodies.write_out import write_out  # few specs need it, and it is large

    return write_out(root, bag, asked)
