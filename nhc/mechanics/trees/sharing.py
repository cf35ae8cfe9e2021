"""Points that begin alike: sums of vectors fixed on axes share what they begin with, from the root on."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.mechanics.moving.signatures import Signature
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.trees.frames import ZERO, Frame, Frames
from nhc.records import fresh, structure


@structure
class Point:
    """``base`` + the vectors d on their axes + what moves in other ways."""

    base: Point | None
    arms: list[tuple[Frame, Vector]]
    loose: Vector

    @property
    def turns(self) -> bool:
        """Whether it, or what it stands on, turns."""
        return bool(self.arms) or (self.base is not None and self.base.turns)


Path = tuple[tuple[Frame | None, Vector], ...]


@structure
class _Branch:
    """What is added to the point before; ``ends``: the places that are reached here."""

    part: tuple[Frame | None, Vector]
    ends: list[int] = fresh(factory=list)
    next: dict[tuple[int, tuple[Signature, ...]], _Branch] = fresh(factory=dict)


def share_beginnings(frames: Frames, paths: Sequence[Path]) -> list[Point]:
    """Points of which those with equal beginnings stand on one another."""
    root = _Branch((None, ZERO))
    for k, path in enumerate(paths):
        branch = root
        for frame, vector in path:
            branch = branch.next.setdefault((id(frame), frames.mark(vector)), _Branch((frame, vector)))
        branch.ends.append(k)
    found: list[Point | None] = [None] * len(paths)
    stack: list[tuple[_Branch, Point | None, Path]] = [(root, None, ())]
    while stack:
        branch, base, path = stack.pop()
        path = (*path, branch.part) if branch is not root else path
        if branch.ends or len(branch.next) > 1:
            arms = [(frame, vector) for frame, vector in path if frame is not None]
            loose = next((vector for frame, vector in path if frame is None), ZERO)
            base, path = Point(base, arms, loose) if path else base, ()
            for k in branch.ends:
                found[k] = base or Point(None, [], ZERO)
        stack += [(own, base, path) for own in branch.next.values()]
    return [point for point in found if point is not None]
