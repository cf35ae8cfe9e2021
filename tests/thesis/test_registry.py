"""Every number of the thesis is accounted for, and the documents say what the registry says."""

from __future__ import annotations

import importlib
import pkgutil
import re
from collections.abc import Callable
from pathlib import Path

import pytest

import nhc.mechanics
from nhc.thesis.errata import ERRATA
from nhc.thesis.pages import equation_page, equation_table, errata_page
from nhc.thesis.registry import EQUATIONS
from nhc.thesis.tie import IMPLEMENTED

for module in pkgutil.walk_packages(nhc.mechanics.__path__, "nhc.mechanics."):
    importlib.import_module(module.name)

# how many equations the text numbers in each section
SECTIONS = {
    "I.1": 2,
    "I.2": 15,
    "I.3": 4,
    "I.4": 9,
    "II.1": 5,
    "II.2": 3,
    "II.3": 1,
    "III.1": 2,
    "III.2": 6,
    "III.3": 7,
    "III.4": 5,
}
UNNUMBERED = {"I.3", "II.3", "III.3", "III.4"}


def test_every_number_has_an_entry() -> None:
    expected = {f"{section}.{k + 1}" for section, count in SECTIONS.items() for k in range(count)} | UNNUMBERED
    assert set(EQUATIONS) == expected


def test_decorated_numbers_are_known() -> None:
    assert set(IMPLEMENTED) - set(EQUATIONS) == set()


@pytest.mark.parametrize("number", EQUATIONS)
def test_an_equation_has_code_a_test_or_a_reason(number: str, root: Path) -> None:
    entry = EQUATIONS[number]
    assert sorted(entry.places) == sorted(IMPLEMENTED.get(number, []))
    assert entry.places or entry.test or entry.reason
    if entry.test:
        assert _exists(root, entry.test)
    assert all(name in ERRATA for name in entry.errata)
    assert entry.latex.count("{") == entry.latex.count("}")
    page = equation_page(number)
    assert page.startswith(f"({number}) ") and entry.latex in page
    assert all(f"({name}, " in page for name in entry.errata)


def _exists(root: Path, test: str) -> bool:
    path, name = test.split("::")
    return re.search(rf"^def {name}\(", (root / path).read_text(), re.MULTILINE) is not None


@pytest.mark.parametrize("name", ERRATA)
def test_erratum_has_its_test(name: str, root: Path) -> None:
    assert _exists(root, ERRATA[name].test)


def test_no_erratum_is_missing() -> None:
    assert list(ERRATA) == [f"E{k + 1}" for k in range(16)]
    mentioned = {name for entry in EQUATIONS.values() for name in entry.errata}
    assert mentioned == set(ERRATA)


def test_the_table_of_equations_is_written_from_the_registry(golden: Callable[[Path, str], None], root: Path) -> None:
    golden(root / "docs/thesis/equations.md", equation_table())


def test_the_page_of_errata_is_written_from_the_registry(golden: Callable[[Path, str], None], root: Path) -> None:
    golden(root / "docs/thesis/errata.md", errata_page())


def test_unknown_number() -> None:
    with pytest.raises(KeyError):
        equation_page("IV.1.1")
