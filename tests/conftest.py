"""Shared by all tests: ``--update`` rewrites expected files, ``golden`` compares with them."""

from __future__ import annotations

import gc
import importlib
import importlib.util
import os
import shutil
import sys
import types
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path

import numpy
import pytest

from nhc.cli.entry import RARE_COLLECTION
from nhc.simulate import workshop
from nhc.simulate.c import compile as compiling
from tests.support import QUICK, UNOPTIMISED

ROOT = Path(__file__).resolve().parent.parent


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--update``."""
    parser.addoption("--update", action="store_true", help="rewrite the expected files in place of comparing with them")


def pytest_configure(config: pytest.Config) -> None:
    """Refuse to run without a C compiler: most of what is tested is compiled, and skipped tests look like passed ones.

    Raises:
        pytest.UsageError: there is none.
    """
    if not any(shutil.which(name) for name in ("cc", "gcc", "clang")):
        raise pytest.UsageError("the tests compile C, and there is no cc, gcc or clang on the path")
    gc.set_threshold(*RARE_COLLECTION)  # as the command line has it


@pytest.hookimpl(tryfirst=True)  # before `-m` chooses
def pytest_collection_modifyitems(items: Sequence[pytest.Item]) -> None:
    """Of the cases of a test that is marked ``sample(n)`` one in n is for every day, the others are slow.

    One of each n in a row, and not the same each time: with cases that are pairs, both halves are met.
    """
    met: Counter[str] = Counter()
    for item in items:
        mark = item.get_closest_marker("sample")
        if mark is None:
            continue
        test = item.nodeid.partition("[")[0]
        block, place = divmod(met[test], mark.args[0])
        met[test] += 1
        if place != block % mark.args[0]:
            item.add_marker(pytest.mark.slow)


Compile = Callable[[Mapping[str, str], str, Sequence[str], Path], None]


def _shared(factory: pytest.TempPathFactory) -> Path:
    """The folder of all workers."""
    folder = factory.getbasetemp()
    return folder.parent if "PYTEST_XDIST_WORKER" in os.environ else folder


@pytest.fixture(scope="session", autouse=True)
def quick_models(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Compile]:
    """One cache for all tests and workers, not the user's, of models that the compiler takes as they are.

    Else the compiler takes half of the time of all tests.  Its level changes no result: the flags keep to IEEE arithmetic as it is
    written.  clang does it in half of gcc's time, where it is there.  Gives what compiles as for users.
    """
    careful = compiling._compile

    def quick(sources: Mapping[str, str], unit: str, command: Sequence[str], library: Path) -> None:
        kept = (flag for flag in command[1:] if not flag.startswith(("-fpeel", "-frename")))  # gcc's alone
        careful(sources, unit, (QUICK, *kept, *UNOPTIMISED), library)

    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NHC_CACHE", str(_shared(tmp_path_factory) / "cache"))
        patch.setattr(compiling, "_compile", quick)
        yield careful


@pytest.fixture(scope="module")
def optimised_models(tmp_path_factory: pytest.TempPathFactory, quick_models: Compile) -> Iterator[None]:
    """Models compiled as for users, in one cache of their own: for tests of what becomes of their loops, and for long runs."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("NHC_CACHE", str(_shared(tmp_path_factory) / "optimised"))
        patch.setattr(compiling, "_compile", quick_models)
        patch.setattr(workshop, "HASTE", 0)
        yield


@pytest.fixture
def jax_is_numpy(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where JAX is not installed its array functions are NumPy's, which mean the same for what emitted modules call."""
    if importlib.util.find_spec("jax") is None:
        stand_in = types.ModuleType("jax")
        stand_in.Array = numpy.ndarray  # type: ignore[attr-defined]
        stand_in.numpy = numpy  # type: ignore[attr-defined]
        stand_in.lax = types.SimpleNamespace(cond=lambda good, one, other: one() if good else other())  # type: ignore[attr-defined]
        monkeypatch.setitem(sys.modules, "jax", stand_in)
        monkeypatch.setitem(sys.modules, "jax.numpy", numpy)
    else:
        importlib.import_module("jax").config.update("jax_enable_x64", True)


@pytest.fixture
def update(request: pytest.FixtureRequest) -> bool:
    """Whether expected files are to be rewritten."""
    return bool(request.config.getoption("--update"))


@pytest.fixture
def root() -> Path:
    """The top of the repository."""
    return ROOT


@pytest.fixture
def golden(update: bool) -> Callable[[Path, str], None]:
    """A function ``golden(path, text)`` that compares ``text`` with a file, or rewrites that under ``--update``."""

    def compare(path: Path, text: str) -> None:
        if update:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text.encode())
            return
        assert path.is_file(), f"no expected file {path.relative_to(ROOT)}; `pytest --update` writes it"
        assert text == path.read_bytes().decode(), f"{path.relative_to(ROOT)} differs; `pytest --update` rewrites it"

    return compare
