"""Every number of the thesis is accounted for, and the documents say what the registry says."""

from __future__ import annotations

import importlib
import pkgutil
import re
import unicodedata
from collections.abc import Callable
from pathlib import Path

import pytest

import nhc.mechanics
from nhc.thesis.errata import ERRATA
from nhc.thesis.pages import equation_page, equation_table, errata_page
from nhc.thesis.plain import plain
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
    assert page.startswith(f"({number}) ") and page.endswith(entry.latex)
    text = plain(entry.latex)
    assert f"\n    {text}\n" in page and "\\" not in text and "  " not in text
    assert all(text.count(opening) == text.count(closing) for opening, closing in ("()", "[]", "{}"))
    written = re.sub(r"\\(?!det)[A-Za-z]+|{vmatrix}", "", entry.latex)
    assert sorted(re.findall("[A-Za-z]", unicodedata.normalize("NFD", text))) == sorted(re.findall("[A-Za-z]", written))
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


@pytest.mark.parametrize(
    ("number", "text"),
    [
        ("I.1.1", "a_αi q'_i + a_α = 0"),
        ("I.2.4", "q'_j = b_jk ω_k + b_{j,n+1}, b_{j,n+1} = -b_jk a_{k,n+1}"),
        ("II.1.2", "Ω(d, δ) = |u(d), w(d); u(δ), w(δ)|"),
        ("III.2.2", "d[(p*_j ω_j - T) dt] = d(p*_j ω_j - T) ∧ dt"),
        ("III.4", "Ω̃ = (d(∂T*/∂q'_μ) - p_α db_αμ - R_μ dt) ∧ (dq_μ - q'_μ dt)"),
        ("III.3.4", "∂²T*/∂q'_ν∂q'_μ = T_νμ + T_νβ b_βμ + b_αν T_αμ + b_αν T_αβ b_βμ"),
    ],
)
def test_formulas_fit_on_a_line(number: str, text: str) -> None:
    assert plain(EQUATIONS[number].latex) == unicodedata.normalize("NFC", text)
