"""Whether a spec can be held against another one on a scene: what it lacks, with its place."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath

from nhc.diagnostics import Bag
from nhc.language.spec import Scene, Spec
from nhc.language.units.derived import derive_units
from nhc.language.units.dimensions import UnitError, base_words, parse_unit
from nhc.mechanics.starts.scenes import report_scene
from nhc.simulate.requests import list_needs


def check_comparable(spec: Spec, finest: Spec, scene: Scene, needs: Sequence[str], name: str) -> None:
    """Refuse a spec without the scene, with the scene over another time, or without a needed quantity.

    Raises:
        nhc.diagnostics.SpecError: all of it, at the places in that spec.
    """
    if spec is finest or spec.origin.path == finest.origin.path:
        return
    bag = Bag(spec.origin)
    base = PurePath(finest.origin.path).name
    own = next((s for s in spec.scenes if s.name == scene.name), None)
    if own is None:
        help = "models are compared on a scene that all of them have: add it, or name another after `--scene`"
        note = f"it is compared on the scene `{scene.name}` of `{base}`"
        report_scene(bag, spec.key_span("scenes"), scene.name, spec, help, note)
    elif own.time != scene.time:
        bag.error(
            "E0505",
            f"the scene `{own.name}` lasts from {float(own.time[0]):g} to {float(own.time[1]):g} here, "
            f"from {float(scene.time[0]):g} to {float(scene.time[1]):g} in `{base}`",
            own.span,
            notes=("errors are taken at the same times in all models",),
            help=("give both scenes the same `time`, or name one with `--time`",),
        )
    units, wanted = derive_units(spec), derive_units(finest)
    for need in needs:
        here, base_unit = units.get(need, ""), wanted.get(need, "")
        if here and base_unit and not _same(here, base_unit):
            bag.error(
                "E0505",
                f"`{need}` is in {here} here, in {base_unit} in `{base}`",
                spec.key_span("coordinates"),
                notes=("nhc does not convert units: it would compare the bare numbers",),
                help=("write both models in the same units",),
            )
    there = list_needs(spec)
    missing = [need for need in needs if need not in there]
    if missing:
        quantities = "quantity" if len(missing) == 1 else "quantities"
        bag.error(
            "E0505",
            f"`{name}` has no {quantities} {', '.join(f'`{need}`' for need in missing)} to be compared",
            spec.key_span("scenes") if own is None else own.span,
            notes=(f"the scene `{scene.name}` of `{base}`, which is the finest model, needs it",),
            help=("declare it under `outputs`, or name what all models have after `--need`",),
        )
    bag.raise_if_errors()


def _same(a: str, b: str) -> bool:
    """Whether two units are one: the same text, or the same product of the same base units (radians need no name)."""
    plain = [text.replace(" ", "").replace("·", "*") for text in (a, b)]
    try:
        alike = parse_unit(a) == parse_unit(b) and base_words([a]) == base_words([b]) is not None
    except UnitError:  # the root of a unit
        alike = False
    return plain[0] == plain[1] or alike
