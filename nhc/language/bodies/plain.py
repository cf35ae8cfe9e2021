"""A spec with its bodies written out, and what is still known of them."""

from __future__ import annotations

from nhc.language.spec import Body, Point
from nhc.language.yaml_tree.nodes import Table
from nhc.records import record


@record
class Plain:
    """A spec without bodies: ``offered`` are all names that they declare, used or not.

    A derivation shows ``bodies`` and ``points``; ``velocities`` are the names among those offered that stand for components of
    velocities.
    """

    root: Table
    offered: tuple[str, ...] = ()
    bodies: tuple[Body, ...] = ()
    points: tuple[Point, ...] = ()
    velocities: frozenset[str] = frozenset()
