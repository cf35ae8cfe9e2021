"""A spec with its bodies written out, and what is still known of them."""

from __future__ import annotations

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
