"""All warnings about units: what fits without being right."""

from __future__ import annotations

from dataclasses import replace

from nhc.diagnostics import Bag, Source
from nhc.language.spec import Scene, Spec
from nhc.language.units.degrees import warn_of_degrees
from nhc.language.units.primes import warn_lost_primes
from nhc.language.units.scales import warn_of_scales


def warn_of_units(spec: Spec, bag: Bag) -> None:
    """Add warnings of primes that may be lost (W0428), units that do not go together (W0430), and angles like degrees (W0431)."""
    warn_lost_primes(spec, bag)
    warn_of_scales(spec, bag)
    warn_of_degrees(spec, bag)


def note_units(spec: Spec, scene: Scene, source: Source) -> tuple[str, ...]:
    """The same as notes of what runs in one scene, which may have other values than `nhc check` has seen."""
    own = {override.name: override.value for override in scene.parameters}
    parameters = tuple(replace(one, value=own.get(one.name, one.value)) for one in spec.parameters)
    bag = Bag(source)
    warn_of_units(replace(spec, parameters=parameters, scenes=(replace(scene, parameters=()),)), bag)
    return tuple(f"{found.message}: {found.help[0]} ({found.code})" for found in bag.diagnostics)
