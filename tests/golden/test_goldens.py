"""Every stage of every gallery system as it was accepted before; the emitted C compiles strictly and agrees with Python."""

from __future__ import annotations

import ctypes
import random
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from nhc.dump import DUMPS
from nhc.language import read
from nhc.pipeline import Options, emit
from tests.support import GALLERY, CModel, compile_c, error, made_once, python_model, spec_path

HERE = Path(__file__).resolve().parent
STAGES = {"form.txt": "form", "equations.txt": "associate"}
FILES = ("form.txt", "equations.txt", "derivation.tex", "model.h", "model.c", "model.py")
# model.c and model.py have every statement of every program: its own text needs no more than each kind of statement
PROGRAMS = ("bead_on_rod", "bicycle", "chaplygin_sleigh", "contact_oscillator", "heavy_top_quaternion", "rolling_disk")
RENAMED = {"latex": {".tex": "derivation.tex"}, "c": {".h": "model.h", ".c": "model.c"}, "python": {".py": "model.py"}}


def artefacts(name: str) -> dict[str, str]:
    """Golden file name -> text, as the command line would print it."""
    source = read(str(spec_path(name)))
    texts = {file: DUMPS[stage](source, Options()) for file, stage in STAGES.items()}
    for language, endings in RENAMED.items():
        for file, text in emit(source, language, Options()).items():
            texts[endings[Path(file).suffix]] = text
    return texts


@pytest.mark.parametrize("name", PROGRAMS)
def test_golden_program(name: str, golden: Callable[[Path, str], None]) -> None:
    golden(HERE / name / "program.txt", DUMPS["lower"](read(str(spec_path(name))), Options()))


@pytest.mark.parametrize("name", GALLERY)
def test_golden(name: str, golden: Callable[[Path, str], None]) -> None:
    with made_once():
        found = artefacts(name)
    assert tuple(sorted(found)) == tuple(sorted(FILES))
    for file in FILES:
        golden(HERE / name / file, found[file])


def test_no_orphans() -> None:
    kept = {path.relative_to(HERE).as_posix() for path in HERE.rglob("*") if path.is_file() and path.suffix != ".pyc"}
    wanted = {f"{name}/{file}" for name in GALLERY for file in FILES} | {"test_goldens.py"}
    wanted |= {f"{name}/program.txt" for name in PROGRAMS}
    assert kept <= wanted


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", GALLERY)
def test_golden_c_compiles_and_agrees_with_python(name: str, tmp_path: Path) -> None:
    folder = HERE / name
    texts = {f"{name}.h": (folder / "model.h").read_text(), f"{name}.c": (folder / "model.c").read_text()}
    library = compile_c(texts, tmp_path, name, ("-O2",))
    c, python = CModel(name, ctypes.CDLL(str(library)), {}), python_model((folder / "model.py").read_text(), name)
    size, n, l = len(python.STATE), len(python.COORDINATES), len(python.CONSTRAINTS)  # noqa: E741
    p, rng, compared = list(python.DEFAULTS), random.Random(name), 0
    for _ in range(12):
        t, y = rng.uniform(0, 2), [rng.uniform(0.1, 0.9) for _ in range(size)]
        try:
            expected = python.rhs(t, y)
        except python.SingularModelError:
            continue
        compared += 1
        assert error(c("rhs", size, t, y, p), expected) < 1e-11
        assert error(c("accelerations", n, t, y, p), python.accelerations(t, y)) < 1e-11
        assert error(c("reactions", l, t, y, p), python.reactions(t, y)) < 1e-11
        assert error([c.energy(t, y, p)], [python.energy(t, y)]) < 1e-12
    assert compared >= 3


@pytest.mark.parametrize("name", GALLERY)
def test_no_line_of_c_ends_between_a_type_and_its_name(name: str) -> None:
    lines = [line for file in ("model.c", "model.h") for line in (HERE / name / file).read_text().splitlines()]
    assert [line for line in lines if re.search(r"\b(const|double|int|size_t|restrict)$", line)] == []
