"""A spec with its bodies written out, and what is still known of them."""

from __future__ import annotations

from nhc.diagnostics import Bag
from nhc.language.keys import BODILY
from nhc.language.spec import Body
from nhc.language.yaml_tree.nodes import Table
from nhc.records import record


@record
class Plain:
    """A spec without bodies: ``offered`` are all names that they declare, used or not; a derivation shows ``bodies``.

    ``velocities`` are the names among those offered that stand for components of velocities.
    """

    root: Table
    offered: tuple[str, ...] = ()
    bodies: tuple[Body, ...] = ()
    velocities: frozenset[str] = frozenset()


def plain(root: Table, bag: Bag, asked: str = "") -> Plain:
    """The spec with its ``bodies`` written out; names in the expression ``asked`` count as used."""
    if not any(text.value in BODILY for text, _ in root.entries):
        return Plain(root)
    from nhc.language.bodies.write_out import write_out  # few specs need it, and it is large

    return Plain(*write_out(root, bag, asked))
