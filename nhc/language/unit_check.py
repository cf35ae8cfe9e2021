"""Dimensional analysis, for specs that give every coordinate and parameter a unit."""

from __future__ import annotations

from nhc.diagnostics import Bag

from .spec import Spec


def check_units(spec: Spec, bag: Bag) -> None:
    """Report what does not fit (E0413); says nothing where a coordinate or parameter has no unit."""
