"""Records behave as frozen dataclasses with slots do."""

from __future__ import annotations

import copy
import pickle
from dataclasses import asdict, is_dataclass, replace
from functools import cached_property

import pytest

from nhc.records import WIDEST, fresh, identity_record, record, structure


@record
class Point:
    """A place."""

    x: int
    y: int = 2

    @property
    def sum(self) -> int:
        return self.x + self.y


@record
class Other:
    x: int
    y: int = 2


@identity_record
class Leaf:
    name: str


@record
class Wide:
    a: int
    b: int
    c: int
    d: int
    e: int
    f: int
    g: int = 7
    h: str = "eight"


def test_wide_ones_take_their_fields_in_every_way() -> None:
    wide = Wide(1, 2, 3, 4, 5, f=6)
    assert wide == Wide(1, 2, 3, 4, 5, 6, 7, "eight") != replace(wide, h="h")
    assert repr(wide) == "Wide(a=1, b=2, c=3, d=4, e=5, f=6, g=7, h='eight')" and hash(wide) == hash(replace(wide))
    assert not hasattr(wide, "__dict__") and pickle.loads(pickle.dumps(wide)) == wide
    for mistaken in (lambda: Wide(1, 2, 3, 4, 5), lambda: Wide(*range(9)), lambda: Wide(*range(6), a=1)):
        with pytest.raises(TypeError, match="Wide"):
            mistaken()


def test_the_widest_has_no_field_to_spare() -> None:
    names = [f"f{k}" for k in range(WIDEST)]
    broad = record(type("Broad", (), {"__annotations__": dict.fromkeys(names, int)}))
    made = broad(*range(WIDEST))
    assert [getattr(made, name) for name in names] == list(range(WIDEST)) and made == broad(*range(WIDEST))


def test_equal_by_value_and_class() -> None:
    assert Point(1) == Point(1, 2) == Point(y=2, x=1) != Point(2)
    assert Point(1) != Other(1) and Point(1) != (1, 2)
    assert len({Point(1), Point(1, 2), Point(3)}) == 2
    assert repr(Point(1)) == "Point(x=1, y=2)" and Point(1).sum == 3 and Point.__doc__ == "A place."


def test_frozen_and_without_a_dictionary() -> None:
    point = Point(1)
    with pytest.raises(AttributeError, match="frozen"):
        point.x = 3  # type: ignore[misc]
    with pytest.raises(AttributeError, match="frozen"):
        del point.x
    with pytest.raises(AttributeError):
        point.z = 3  # type: ignore[attr-defined]
    assert not hasattr(point, "__dict__")


def test_matched_by_position_and_replaced() -> None:
    match Point(4, 5):
        case Point(x, 5):
            assert x == 4
        case _:
            pytest.fail("no match")
    assert replace(Point(4, 5), x=1) == Point(1, 5) and asdict(Point(4, 5)) == {"x": 4, "y": 5}
    assert is_dataclass(Point) and copy.copy(Point(1)) == Point(1)
    assert pickle.loads(pickle.dumps(Point(7))) == Point(7)


def test_an_identity_record_equals_itself_only() -> None:
    leaf = Leaf("a")
    assert leaf == leaf and leaf != Leaf("a") and len({leaf, Leaf("a")}) == 2


def test_missing_arguments_are_refused() -> None:
    with pytest.raises(TypeError):
        Point()  # type: ignore[call-arg]


@record
class Kept:
    size: int
    found: dict[int, int] = fresh(factory=dict)

    @cached_property
    def square(self) -> int:
        self.found[self.size] = self.found.get(self.size, 0) + 1
        return self.size**2


@structure
class Draft:
    name: str
    lines: list[str] = fresh(factory=list)
    note: str = ""
    a: int = 0
    b: int = 0
    c: int = 0
    d: list[int] = fresh(factory=list)
    e: int = 0


def test_a_fresh_default_is_made_for_each_instance() -> None:
    first, second = Kept(2), Kept(2)
    first.found[0] = 1
    assert second.found == {} and first != second == Kept(2, {})
    assert replace(first).found is first.found and Kept(3, first.found).found is first.found
    mine: list[int] = []
    assert Draft("a").d is not Draft("a").d and Draft("a", d=mine).d is mine


def test_a_frozen_record_keeps_what_its_properties_have_found() -> None:
    kept = Kept(3)
    assert kept.square == kept.square == 9 and kept.found == {3: 1}
    with pytest.raises(AttributeError, match="frozen"):
        kept.size = 4  # type: ignore[misc]


def test_a_structure_may_be_filled_step_by_step() -> None:
    draft = Draft("a", note="b")
    draft.name, draft.lines = "c", [*draft.lines, "d"]
    assert (draft.name, draft.lines, draft.note) == ("c", ["d"], "b")
    assert draft == draft and draft != Draft("c", ["d"], "b")
    assert asdict(replace(draft, note="")) == {**asdict(draft), "note": ""}
    again = copy.deepcopy(draft)
    assert again.lines == draft.lines and again.lines is not draft.lines
