"""A scene with other values and another time than the spec gives."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from nhc.diagnostics import Bag, Source, Span
from nhc.language import Scene, Spec
from nhc.language.scenes import check_time
from nhc.language.shape import Shapes
from nhc.language.yaml_tree.nodes import Text
from nhc.mechanics.about import scene_about
from nhc.records import record
from nhc.simulate.requests import scene_of_needs

_OPTION = "--time"
_HELP = "write `END`, or `START:END`, the smaller number first"


@record
class Changes:
    """What a run takes in place of what its scene says.

    ``values``: pairs such as ``a=1, v=2`` of its start and of parameters; ``time``: its end, such as ``20`` or ``2*pi``, or its
    start and its end, such as ``5:20``; ``needs``: names of what is wanted of it.
    """

    values: tuple[str, ...] = ()
    time: str = ""
    needs: tuple[str, ...] = ()

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader must know who has the spec beside the result; nothing where nothing was changed."""
        parts = [", ".join(self.values)] if self.values else []
        parts += [f"time {self.time}"] if self.time else []
        return (f"other values than those of the spec's scene: {'; '.join(parts)}",) if parts else ()


UNCHANGED = Changes()


def changed(spec: Spec, scene: Scene, changes: Changes) -> tuple[Spec, Scene]:
    """The spec with the scene changed, and the scene.

    Raises:
        nhc.diagnostics.SpecError: an unknown name, a value that is not constant, or a time that does not end after its start;
            with places in the options' texts.
        nhc.simulate.requests.RunError: a need that is no quantity of the spec.
    """
    other = scene_about(spec, scene.name, changes.values) if changes.values else scene
    if changes.time:
        other = replace(other, time=_read_time(changes.time, scene.time[0]))
    other = scene_of_needs(spec, other, changes.needs)
    return replace(spec, scenes=tuple(other if one is scene else one for one in spec.scenes)), other


def _read_time(text: str, start: Fraction) -> tuple[Fraction, Fraction]:
    bag, whole = Bag(Source(_OPTION, text)), Span(0, len(text))
    parts = text.split(":")
    if len(parts) > 2 or not all(part.strip() for part in parts):
        bag.error("E0301", f"expected a time or two, found `{text}`", whole, help=(_HELP,))
        bag.raise_if_errors()
    shapes, places = Shapes(bag), range(len(text) + 1)
    found, offset = list[Fraction | None](), 0
    for part in parts:
        found.append(shapes.number(_text(part, offset, places), f"`{_OPTION}`"))
        offset += len(part) + 1
    bag.raise_if_errors()
    low, high = (start, *found) if len(found) == 1 else found
    assert low is not None and high is not None
    if low >= high:
        own = f"; the scene starts at {float(start):.10g}" if len(found) == 1 else ""
        bag.error("E0313", f"`{_OPTION}` ends where it starts, or before{own}", whole, help=(_HELP,))
    else:
        check_time(bag, (low, high), whole)
    bag.raise_if_errors()
    return low, high


def _text(part: str, offset: int, places: range) -> Text:
    offset += len(part) - len(part.lstrip())
    length = len(part.strip())
    return Text(part.strip(), Span(offset, offset + length), True, places[offset : offset + length + 1])
