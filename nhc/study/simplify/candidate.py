"""What may be left out of a spec: terms, parameters set to a limit, coordinates that a limit makes known."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import combinations

from nhc.diagnostics import Span
from nhc.language.expressions.syntax import Binary, Differential, Name, Prime, Syntax
from nhc.records import identity_record
from nhc.study.simplify.zero import INFINITE, ZERO, is_named

_NOWHERE = Span(0, 0)
_STILL = 1e-12  # a rate below it is rounding in a start that stands still
_MOST = 5  # coordinates of which pairs are tried


@identity_record
class Candidate:
    """One thing that can go; ``about`` says it.

    A term (``node``) becomes 0.  A parameter (``name``, ``kind`` "zero" or "infinite") becomes that.  A coordinate (``name``)
    that is "held" stays where it starts, the limit of a stiff spring; one that is "driven" keeps its starting rate, the limit of
    a heavy rotor.  Their start and rate are parameters ``start`` and ``rate`` of these values; no name where it is 0.
    Several of these together are a "group" of ``parts``.  Those of a lower ``rank`` are measured first, for not all may be.
    """

    about: str
    kind: str = "term"
    node: Syntax | None = None
    name: str = ""
    start: str = ""
    rate: str = ""
    values: tuple[float, float] = (0.0, 0.0)
    parts: tuple[Candidate, ...] = ()
    rank: int = 1

    @property
    def takes_coordinate(self) -> bool:
        return self.kind in ("held", "driven")

    def swap(self, node: Syntax) -> Syntax | None:
        """What stands for a node of an expression; None for the node itself."""
        if self.kind == "term":
            return ZERO if node is self.node else None
        if not self.takes_coordinate:
            return (ZERO if self.kind == "zero" else INFINITE) if is_named(node, self.name) else None
        if isinstance(node, Differential) and node.name == self.name:
            return self._times(Differential("t", _NOWHERE)) if self.rate else ZERO
        if isinstance(node, Prime) and is_named(node.operand, self.name):
            return Name(self.rate, _NOWHERE) if self.rate else ZERO
        return self._position() if is_named(node, self.name) else None

    def _position(self) -> Syntax:
        start = Name(self.start, _NOWHERE) if self.start else None
        if not self.rate:
            return start or ZERO
        moved = self._times(Name("t", _NOWHERE))
        return Binary("+", start, moved, _NOWHERE, _NOWHERE) if start else moved

    def _times(self, other: Syntax) -> Syntax:
        return Binary("*", Name(self.rate, _NOWHERE), other, _NOWHERE, _NOWHERE)

    def parameters(self, unit: str) -> list[tuple[str, str, str]]:
        """(name, value, unit) of the parameters that it brings; ``unit`` is the coordinate's."""
        found = [(self.start, repr(self.values[0]), unit)] if self.start else []
        return found + ([(self.rate, repr(self.values[1]), f"({unit})/s" if unit else "")] if self.rate else [])


def hold(name: str, taken: set[str], start: float, rate: float) -> list[Candidate]:
    """The limits of a coordinate that starts at ``start`` with the rate ``rate``, under parameters that nobody else has."""
    own = "" if start == 0 else _free(f"{name}_0", taken)
    at = f"its start {start:.6g}"
    found = [Candidate(f"coordinate `{name}`, held at {at} (stiff)", "held", name=name, start=own, values=(start, 0.0))]
    if abs(rate) > _STILL:
        moving = _free(f"{name}_rate", taken)
        about = f"coordinate `{name}`, driven at its starting rate {rate:.6g} (heavy)"
        found.append(Candidate(about, "driven", name=name, start=own, rate=moving, values=(start, rate)))
    return found


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name


def group(candidates: Sequence[Candidate]) -> list[Candidate]:
    """Coordinates that are held together, two of them and all of them: one alone may be worse than none or both."""
    held = [c for c in candidates if c.kind == "held"][:_MOST]
    sets = [*combinations(held, 2), *([tuple(held)] if len(held) > 2 else [])]
    return [Candidate(_name_held(parts), "group", parts=parts) for parts in sets]


def name_beyond(candidate: Candidate, gone: Iterable[Candidate]) -> str:
    """What a candidate leaves out beyond what is gone: of coordinates that are held together, those that were not."""
    before = expand(gone)
    parts = [part for part in candidate.parts if part not in before]
    if not 0 < len(parts) < len(candidate.parts):
        return candidate.about
    return parts[0].about if len(parts) == 1 else _name_held(parts)


def _name_held(parts: Sequence[Candidate]) -> str:
    return f"coordinates {', '.join(f'`{c.name}`' for c in parts)}, held where they start (stiff)"


def expand(candidates: Iterable[Candidate]) -> tuple[Candidate, ...]:
    """Groups as their parts, each once."""
    return tuple(dict.fromkeys(part for c in candidates for part in (c.parts or (c,))))
