"""All warnings about units: what fits without being right."""

from __future__ import annotations

from nhc.diagnostics import Bag
from nhc.language.spec import Spec
from nhc.language.units.degrees import warn_of_degrees
from nhc.language.units.primes import warn_lost_primes
from nhc.language.units.scales import warn_of_scales


def warn_of_units(spec: Spec, bag: Bag) -> None:
    """Add warnings of primes that may be lost (W0428), units that do not go together (W0430), and angles like degrees (W0431)."""
    warn_lost_primes(spec, bag)
    warn_of_scales(spec, bag)
    warn_of_degrees(spec, bag)
