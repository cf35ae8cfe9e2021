"""What holds for all back ends: the environment, the templates' variables, determinism, where the templates are."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from nhc.emit import LANGUAGES, EmitError, EmitOptions, list_files, render
from nhc.emit.environment import File, create_environment, render_file
from nhc.emit.expressions import ExpressionPrinter
from nhc.emit.names import Scope
from nhc.emit.prose import clean, fold_ascii, wrap
from nhc.emit.python.body import PythonDialect
from nhc.emit.statements import drop_unused, list_used_names, split_hoisted
from nhc.language import read
from nhc.pipeline import Options
from nhc.pipeline import program as build_program
from nhc.program.ir import Load, Section, Store
from nhc.resources import find_folder, find_specs, find_templates, list_candidates
from nhc.stamp import is_untouched
from tests.support import spec_path
from tests.unit.emit_cases import CASES, E, call, let, make_oscillator, make_sleigh, ref, store

OPTIONS = {
    "c": (EmitOptions(), EmitOptions(driver=True), EmitOptions(driver=True, scene="swing", only=("rhs_batch",))),
    "python": (EmitOptions(), EmitOptions(array="numpy"), EmitOptions(array="jax"), EmitOptions(only=("rhs",))),
}


def find_variables(template: str) -> set[str]:
    """The variables of a template and of what it includes."""
    from jinja2 import meta

    environment = create_environment()
    assert environment.loader is not None
    tree = environment.parse(environment.loader.get_source(environment, template)[0])
    found = set(meta.find_undeclared_variables(tree))
    for other in meta.find_referenced_templates(tree):
        if other is not None:  # a name that stands in a variable is looked up by who calls
            found |= find_variables(other)
    return found


SIMULATORS = {"c/run.c.jinja", "c/natural.c.jinja"}  # nhc.simulate's, beside a model's own files


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_template_uses_exactly_what_it_is_given(language: str) -> None:
    seen = set()
    for options in OPTIONS[language]:
        for file in list_files(make_oscillator(), language, options):
            used = find_variables(file.template)
            prelude = file.context.get("prelude")
            if isinstance(prelude, str):
                used |= find_variables(prelude)
                seen.add(prelude)
            assert used == set(file.context), file.template
            seen.add(file.template)
    folder = find_templates()
    ours = {path.relative_to(folder).as_posix() for path in (folder / language).glob("*.jinja")} - SIMULATORS
    assert seen == ours


def test_an_unknown_variable_is_an_error_and_user_text_is_no_template(tmp_path: Path) -> None:
    from jinja2 import UndefinedError

    with pytest.raises(UndefinedError):
        render_file(File("x", "python/model.py.jinja", {}))
    environment = create_environment()
    assert environment.from_string("{{0}} << a >>\n").render(a="<< b >>") == "{{0}} << b >>\n"


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_file_is_stamped_and_names_no_machine(language: str) -> None:
    for program in CASES.values():
        for name, text in render(program, language, EmitOptions()).items():
            assert is_untouched(text), name
            assert text.endswith("\n") and not text.endswith("\n\n") and "\t" not in text and "\r" not in text
            assert str(Path.cwd()) not in text


def test_the_text_does_not_depend_on_the_hash_seed() -> None:
    code = (
        "import hashlib; from tests.unit.emit_cases import CASES; from nhc.emit import *\n"
        "for p in CASES.values():\n"
        "    for l, o in (('c', EmitOptions(driver=bool(p.scenes))), ('python', EmitOptions(array='jax'))):\n"
        "        print(hashlib.sha256(repr(render(p, l, o)).encode()).hexdigest())\n"
    )
    root = Path(__file__).resolve().parents[2]
    found = {
        subprocess.run(
            [sys.executable, "-c", code],
            env=os.environ | {"PYTHONHASHSEED": seed},
            cwd=root,
            check=True,
            capture_output=True,
        ).stdout
        for seed in ("0", "1", "77")
    }
    assert len(found) == 1


def test_importing_the_back_ends_imports_no_jinja() -> None:
    code = "import sys, nhc.emit, nhc.emit.c.printer, nhc.emit.python.printer; sys.exit('jinja2' in sys.modules)"
    root = Path(__file__).resolve().parents[2]
    assert subprocess.run([sys.executable, "-c", code], cwd=root, check=False).returncode == 0


def test_an_unknown_language_is_refused() -> None:
    with pytest.raises(EmitError, match="no back end `fortran`"):
        render(make_sleigh(), "fortran", EmitOptions())


def test_folders_are_found_in_a_checkout_and_in_a_wheel(tmp_path: Path) -> None:
    assert (find_templates() / "c" / "model.c.jinja").is_file()
    assert find_specs().name == "specs"
    package = tmp_path / "nhc"
    with pytest.raises(FileNotFoundError, match="the folder `specs` is not part of this installation"):
        find_folder("specs", package)
    beside = tmp_path / "specs"
    beside.mkdir()
    assert find_folder("specs", package) == beside
    inside = package / "_data" / "specs"
    inside.mkdir(parents=True)
    assert find_folder("specs", package) == inside == list_candidates("specs", package)[0]


def test_names_are_kept_where_they_can_be() -> None:
    scope = Scope({"int", "y"}, 8)
    scope.bind_all(["int", "int_", "x", "y", "a_name_that_is_long", "a_name_that_is_also_long"])
    names = ["int", "int_", "x", "y", "a_name_that_is_long", "a_name_that_is_also_long"]
    spelt = [scope[name] for name in names]
    assert spelt[1:4] == ["int_", "x", "y_"] and spelt[0] == "int__"
    assert len(set(spelt)) == 6 and all(len(name) <= 8 for name in spelt)
    assert scope.fresh("s") == "s1" and scope.fresh("s") == "s2"


def test_expressions_have_only_the_parentheses_they_need() -> None:
    a, b, c = ref("a"), ref("b"), ref("c")
    printer = ExpressionPrinter(PythonDialect("", set()), {name: name for name in "abc"})

    def show(expression: E) -> str:
        return printer.print(expression.node)

    assert show(a + b - c) == "a + b - c"
    assert show(a - (b - c)) == "a - (b - c)"
    assert show((a + b) * c / a) == "(a + b) * c / a"
    assert show(a / (b * c)) == "a / (b * c)"
    assert show(a - -b) == "a + b"
    assert show(a + -(b * c)) == "a - b * c"
    assert show(-(a * b) + c) == "-a * b + c"
    assert show(-(a**2) * b) == "-(a**2) * b"
    assert show(-(a + b)) == "-(a + b)"
    assert show((a * b) ** 2) == "(a * b) ** 2"
    assert show(call("sin", a + b) ** 3) == "math.sin(a + b) ** 3"
    assert show(call("max", a, b, c)) == "_maximum(_maximum(a, b), c)"


def test_dead_code_goes_and_parameter_work_is_found() -> None:
    body = (
        *(Load(name, "p", i) for i, name in enumerate("abc")),
        Load("x", "y", 0),
        Load("z", "y", 1),
        Section("nothing"),
        let("unused", ref("z") + ref("c")),
        Section("from the parameters alone"),
        let("k", ref("a") * ref("b")),
        let("m", ref("k") * ref("x")),
        let("n", ref("k") * 2.0),
        store("dydt", 0, ref("m") + ref("n")),
    )
    kept = drop_unused(body)
    assert list_used_names(body) == {"a", "b", "x", "k", "m", "n"}
    assert [s.title for s in kept if isinstance(s, Section)] == ["from the parameters alone"]
    outside, inside = split_hoisted(kept)
    assert [getattr(s, "name", "") for s in outside] == ["a", "b", "k", "n"]
    assert [getattr(s, "name", "") for s in inside] == ["x", "m", ""]


def test_texts_are_cleaned_folded_and_wrapped() -> None:
    assert clean("a\n\tb\u202e\x00 c ") == "a b c"
    assert fold_ascii("Čaplygin θ Ω · 中") == "Caplygin theta Omega * <U+4E2D>"
    assert fold_ascii("m/s² · µN, 10⁻¹² of x₁") == "m/s^2 * uN, 10^-12 of x1"
    assert wrap("one two three", 8, "  ") == ["one two", "  three"]


@pytest.mark.parametrize(
    ("formulation", "kinematics", "motion", "state"),
    [
        ("euler-lagrange", "I.2.4", "I.2.15", "I.2.1"),
        ("voronec", "I.1.2", "I.4.9", ""),
        ("chaplygin", "I.1.2", "III.3", ""),
        ("multipliers", "", "I.4.1", ""),
    ],
)
def test_the_rates_of_coordinates_have_the_number_of_the_kinematics(
    formulation: str, kinematics: str, motion: str, state: str
) -> None:
    sleigh = build_program(read(str(spec_path("chaplygin_sleigh"))), Options(formulation=formulation))
    functions = {function.name: function for function in sleigh.functions}
    stores = [s for s in functions["rhs"].body if isinstance(s, Store)]
    assert [s.origin.equation for s in stores[:3]] == [kinematics or motion] * 3
    assert {s.origin.equation for s in stores[3:]} == {motion}
    assert (functions["velocities"].equation, functions["state"].equation) == (kinematics, state)
