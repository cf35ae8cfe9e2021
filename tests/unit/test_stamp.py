"""The mark that tells nhc's own files from edited ones."""

from __future__ import annotations

import pytest

from nhc.stamp import PLACEHOLDER, is_untouched, stamp

TEXT = f"/* made by nhc 1.0\n * {PLACEHOLDER} */\nint x = 1;\n"


def test_stamp_is_pure_and_idempotent() -> None:
    stamped = stamp(TEXT)
    assert stamped != TEXT
    assert PLACEHOLDER not in stamped
    assert stamp(stamped) == stamped == stamp(TEXT)
    assert len(stamped) == len(TEXT)


@pytest.mark.parametrize(
    "edit",
    [
        lambda text: text.replace("1;", "2;"),
        lambda text: text + "\n",
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text.replace("made", "Made"),
    ],
)
def test_an_edit_anywhere_shows(edit) -> None:
    stamped = stamp(TEXT)
    assert is_untouched(stamped)
    assert not is_untouched(edit(stamped))


def test_a_text_without_mark_is_not_ours() -> None:
    assert not is_untouched("int x = 1;\n")
    assert not is_untouched("")
    assert not is_untouched(TEXT)
    with pytest.raises(ValueError, match="first 12 lines"):
        stamp("\n" * 12 + PLACEHOLDER)


def test_a_mark_in_the_content_is_content() -> None:
    deep = TEXT + "\n" * 12 + "nhc:0123456789abcdef\n"
    assert is_untouched(stamp(deep))
    assert stamp(deep).endswith("nhc:0123456789abcdef\n")
