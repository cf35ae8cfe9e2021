"""A derivation as text keeps to the width that it is given, its tables too."""

import pytest

from nhc.emit.text import print_derivation
from tests.unit.test_paper import derive


@pytest.mark.parametrize("name", ["chaplygin_sleigh", "vertical_disk", "rolling_disk"])
@pytest.mark.parametrize("width", [50, 80])
def test_no_line_is_wider(name: str, width: int) -> None:
    lines = print_derivation(derive(name)[0], width).splitlines()
    assert [line for line in lines if len(line) > width] == []
    assert any(line.startswith("  g ") for line in lines) or name != "rolling_disk"  # the table of parameters is there
