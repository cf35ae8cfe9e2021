"""The rules of the house that no other tool checks."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from nhc.cli.specs import EXTENDS
from nhc.language.yaml_tree.extend import KEY

ROOT = Path(__file__).resolve().parents[2]
MODULES = sorted((ROOT / "nhc").rglob("*.py"))
MAX_LINES, MAX_FUNCTION_LINES = 350, 60
FLOORS = [
    *("cli", "pipeline", "report", "study", "simulate", "emit", "program", "mechanics"),
    *("exterior", "algebra", "language", "diagnostics", "thesis"),
]


def _tracked() -> list[Path]:
    """The files of the repository; without git (an unpacked sdist) everything below its folders."""
    done = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode == 0 and done.stdout:
        return [ROOT / name for name in done.stdout.split("\0") if name and (ROOT / name).is_file()]
    tops = ("nhc", "templates", "specs", "tests", "docs", "benchmarks")
    return [path for top in tops for path in sorted((ROOT / top).rglob("*")) if path.is_file()]


def _texts() -> Iterator[tuple[str, str]]:
    for path in _tracked():
        if path.suffix not in (".png", ".pdf", ".npz"):
            yield path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")


@cache
def _nodes(path: Path) -> tuple[ast.FunctionDef | ast.AsyncFunctionDef | ast.Call, ...]:
    """The functions and calls of a module."""
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Call)
    return tuple(node for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, kinds))


def _functions(path: Path) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    return (node for node in _nodes(path) if not isinstance(node, ast.Call))


def test_files_are_short() -> None:
    lengths = {path.relative_to(ROOT).as_posix(): path.read_text().count("\n") for path in MODULES}
    assert len(lengths) > 20
    assert {name: length for name, length in lengths.items() if length > MAX_LINES} == {}


def test_functions_are_short() -> None:
    long = {}
    for path in MODULES:
        for function in _functions(path):
            assert function.end_lineno is not None
            length = function.end_lineno - function.lineno + 1
            if length > MAX_FUNCTION_LINES:
                long[f"{path.relative_to(ROOT)}:{function.name}"] = length
    assert long == {}


def test_no_state_travels_in_keyword_mappings() -> None:
    found = [
        f"{path.relative_to(ROOT)}:{function.lineno}"
        for path in MODULES
        for function in _functions(path)
        if function.args.kwarg is not None
    ]
    assert found == []


def test_no_text_is_evaluated() -> None:
    forbidden = {"eval", "exec", "sympify", "parse_expr", "compile"}
    found = []
    for path in MODULES:
        for node in _nodes(path):
            if isinstance(node, ast.Call):
                name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
                harmless = isinstance(node.func, ast.Attribute) and getattr(node.func.value, "id", "") in ("re", "nhc")
                if name in forbidden and not harmless:
                    found.append(f"{path.relative_to(ROOT)}:{node.lineno} {name}")
    assert found == []


def test_the_floors_are_those_of_the_drawing() -> None:
    drawing = (ROOT / "docs/architecture.md").read_text()
    assert " -> ".join(FLOORS) in drawing.replace("\n", " ")
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text())
    layers = settings["tool"]["importlinter"]["contracts"][0]["layers"]
    assert [layer.split(" : ")[0].strip("()").removeprefix("nhc.") for layer in layers][: len(FLOORS)] == FLOORS


def test_imports_keep_to_the_floors() -> None:
    program = [
        sys.executable,
        "-c",
        "from importlinter.cli import lint_imports_command; lint_imports_command()",
        "--no-cache",
    ]
    done = subprocess.run(program, cwd=ROOT, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"]
    assert f"{len(contracts)} kept, 0 broken" in done.stdout


HEAVY = ("sympy", "jinja2", "yaml", "numpy", "scipy")


@pytest.mark.parametrize(
    ("arguments", "allowed"),
    [
        (["--help"], ()),
        (["--version"], ()),
        (["check", "-h"], ()),
        (["emit", "-h"], ()),
        (["explain", "E0302"], ()),
        (["check", "chaplygin_sleigh"], ("yaml",)),
        (["emit", "chaplygin_sleigh", "--lang", "c", "--stdout"], ("yaml", "jinja2")),
        (["emit", "chaplygin_sleigh", "--lang", "python", "--stdout"], ("yaml", "jinja2")),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_cheap_paths_import_nothing_heavy(arguments: list[str], allowed: tuple[str, ...]) -> None:
    program = (
        "import sys, io\n"
        "from nhc.cli import main\n"
        "out, sys.stdout = sys.stdout, io.StringIO()\n"
        f"code = main({arguments!r})\n"
        f"print(code, *(name for name in {HEAVY!r} if name in sys.modules), file=out)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    code, *imported = done.stdout.split()
    assert code == "0", done.stderr
    assert [name for name in imported if name not in allowed] == []


def test_an_answer_that_is_kept_is_found_without_the_language(tmp_path: Path) -> None:
    question = ["emit", "chaplygin_sleigh", "--lang", "c", "--stdout"]
    program = (
        "import sys, io\n"
        "from nhc.cli import main\n"
        "out, sys.stdout = sys.stdout, io.StringIO()\n"
        f"code = main({question!r})\n"
        f"print(code, *(name for name in {(*HEAVY, 'nhc.language', 'nhc.pipeline')!r} if name in sys.modules), file=out)\n"
    )
    command, own = [sys.executable, "-c", program], os.environ | {"NHC_CACHE": str(tmp_path)}
    first, again = (
        subprocess.run(command, cwd=ROOT, env=own, capture_output=True, text=True, check=True) for _ in "12"
    )
    assert first.stdout.split() == ["0", "jinja2", "yaml", "nhc.language", "nhc.pipeline"]
    assert again.stdout.split() == ["0"]
    assert EXTENDS == KEY


def test_importing_the_package_costs_nothing() -> None:
    program = "import sys; before = set(sys.modules); import nhc; print(*sorted(set(sys.modules) - before))"
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True)
    assert not set(done.stdout.split()) & {*HEAVY, "click", "nhc.pipeline", "nhc.language"}


def test_what_every_command_imports_compiles_no_methods() -> None:
    """``dataclass`` does at each start; records and structures do not."""
    program = (
        "import sys, nhc.pipeline, nhc.emit.c.printer, nhc.emit.python.printer\n"
        "own = [(m, x) for name, m in list(sys.modules.items()) if name.startswith('nhc') for x in vars(m).values()]\n"
        "made = {x for m, x in own if isinstance(x, type) and '__dataclass_params__' in vars(x)}\n"
        "print(*sorted(x.__name__ for x in made if x.__module__.startswith('nhc')), 'importlib.resources' in sys.modules)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["PlannerBase", "False"]  # which has heirs with fields of their own


def test_no_file_names_a_machine() -> None:
    """Neither the place of this checkout, nor a home folder, nor a temporary one of whoever wrote the file."""
    machine = re.compile(rf"{re.escape(str(ROOT.parent))}/|/(?:home|Users)/\w+/|/tmp/\w+")
    if ROOT.parent == Path(ROOT.anchor):
        machine = re.compile(r"/(?:home|Users)/\w+/|/tmp/\w+")
    found = {name: match.group() for name, text in _texts() if (match := machine.search(text))}
    found.pop(Path(__file__).relative_to(ROOT).as_posix(), None)
    assert found == {}


def test_text_files_are_clean() -> None:
    """UTF-8 (reading them shows it), plain line feeds, no tab in Python and YAML, a final line feed (JSON aside)."""
    wrong = []
    for name, text in _texts():
        if "/bad/" in name:  # specs that are wrong on purpose
            continue
        open_end = text and not text.endswith("\n") and not name.endswith(".json")
        if "\r" in text or open_end or (name.endswith((".py", ".yaml")) and "\t" in text):
            wrong.append(name)
    assert wrong == []


def test_nothing_is_left_undone() -> None:
    marks = re.compile(
        "|".join(["TO" + "DO", "FIX" + "ME", "NotImplemented" + "Error", r"pytest\.mark\.(?:skip|xfail)\b"])
    )
    found = {
        name: match.group()
        for name, text in _texts()
        if name.startswith(("nhc/", "tests/", "templates/", "specs/")) and (match := marks.search(text))
    }
    found.pop(Path(__file__).relative_to(ROOT).as_posix(), None)
    assert found == {}


def test_links_of_documents_lead_somewhere() -> None:
    documents = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").rglob("*.md"))]
    dead, count = [], 0
    for path in documents:
        prose = re.sub(r"^```.*?^```$", "", path.read_text(), flags=re.MULTILINE | re.DOTALL)
        for target in re.findall(r"\]\(([^()\s]+)\)", prose):
            if re.match(r"[a-z]+:", target):
                continue
            count += 1
            if not (path.parent / target.split("#")[0]).exists():
                dead.append(f"{path.relative_to(ROOT)}: {target}")
    assert count > 5
    assert dead == []
