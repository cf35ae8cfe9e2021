"""Names, texts and sizes that are meant to break the reader, the back ends or the compilers behind them."""

from __future__ import annotations

import builtins
import itertools
import keyword
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from nhc.diagnostics import Source, SpecError, render_text
from nhc.emit import EmitError
from nhc.language.expressions.names import RESERVED
from nhc.pipeline import Options, check, derive, emit
from tests.support import STRICT, made_once, python_model

COMPILERS = [c for c in ("gcc", "clang", "clang-14") if shutil.which(c)][:2]
HANG = 60.0  # seconds of the processor, so that a busy machine is no hang; what takes longer hangs

C_WORDS = (
    *(
        "auto",
        "break",
        "case",
        "char",
        "const",
        "double",
        "else",
        "enum",
        "extern",
        "float",
        "for",
        "goto",
        "if",
        "inline",
        "int",
    ),
    *(
        "long",
        "register",
        "restrict",
        "return",
        "short",
        "signed",
        "sizeof",
        "static",
        "struct",
        "switch",
        "typedef",
        "union",
    ),
    *(
        "unsigned",
        "void",
        "volatile",
        "while",
        "do",
        "default",
        "_Bool",
        "_Complex",
        "bool",
        "true",
        "false",
        "nullptr",
        "asm",
    ),
    *(
        "typeof",
        "alignas",
        "constexpr",
        "NULL",
        "NAN",
        "INFINITY",
        "HUGE_VAL",
        "M_PI",
        "FP_NAN",
        "EOF",
        "BUFSIZ",
        "errno",
        "stdin",
    ),
    *(
        "DBL_MAX",
        "FLT_EPSILON",
        "size_t",
        "linux",
        "unix",
        "i386",
        "__FILE__",
        "__LINE__",
        "__func__",
        "_x",
        "__x",
        "main",
        "I",
    ),
)
LIBRARY = (
    *(
        "gamma",
        "lgamma",
        "tgamma",
        "j0",
        "j1",
        "jn",
        "y0",
        "y1",
        "yn",
        "hypot",
        "floor",
        "fabs",
        "fmin",
        "fma",
        "cbrt",
        "erf",
        "pow",
    ),
    *(
        "ldexp",
        "div",
        "round",
        "index",
        "signgam",
        "printf",
        "malloc",
        "exit",
        "scalb",
        "significand",
        "drem",
        "finite",
        "isnan",
    ),
)
OWN_WORDS = (
    *(
        "y",
        "p",
        "q",
        "qdot",
        "qddot",
        "dydt",
        "J",
        "out",
        "r",
        "count",
        "status",
        "t_",
        "i",
        "j",
        "k",
        "row",
        "column",
        "NY",
        "NQ",
    ),
    *(
        "self",
        "state",
        "rhs",
        "energy",
        "velocities",
        "jacobian",
        "outputs",
        "Sequence",
        "math",
        "np",
        "jnp",
        "jax",
        "numpy",
        "cls",
    ),
    *(
        "STATE",
        "DEFAULTS",
        "SingularModelError",
        "NOT_FINITE",
        "REASONS",
        "error",
        "_finish",
        "_solve",
        "float",
        "annotations",
    ),
    *(
        "z1",
        "s1",
        "c1",
        "k1",
        "s_x",
        "c_x",
        "x_dot",
        "x_ddot",
        "lambda_1",
        "STAGES",
        "column",
        "scene",
        "solution",
        "stages",
        "h",
    ),
)
MACHINES = (
    "E",
    "S",
    "N",
    "O",
    "Q",
    "C",
    "D",
    "beta",
    "zeta",
    "Symbol",
    "oo",
    "nan",
    "inf",
    "true",
    "yes",
    "no",
    "on",
    "null_",
    "e1",
    "0x",
)
REFUSED = (
    "t",
    "pi",
    "sin",
    "atan2",
    "dot",
    "sqrt",
    "2x",
    "a-b",
    "a b",
    "a.b",
    "x'",
    "",
    "$x",
    "a;b",
    "__import__('os')",
    "é́·",
)

SPEC = """nhc: 1
system: {system}
about: "{about}"
source: ["{about}"]
coordinates:
  "{a}": {{about: "{about}", unit: m}}
  "{b}": {{about: "{about}", unit: m}}
  third: {{unit: m}}
parameters:
  "{c}": {{value: 1.5, about: "{about}"}}
define:
  "{d}": "{a}' + {b}*third'/({b} + third)"
T: "{c}/2*({d}^2 + 2*{b}'^2 + third'^2)"
forces:
  "{a}": "-0.1*{c}*{a}'/(1 + sin(third/({b} + third))^2)"
constraints:
  - "{e}": "third' = {a}/({b} + 3*{a})*{b}'"
quasi_velocities:
  "{f}": "{a}'"
  second_one: "{b}'"
outputs:
  "{g}": "{f}*{d}"
scenes:
  "{h}":
    about: "{about}"
    initial: {{"{a}": 0.3, "{b}": 0.4, "{f}": 1}}
    time: [0, 1]
    need: ["{a}", reactions, "{g}"]
"""
PLAIN = dict(zip("abcdefgh", ("x", "y", "m", "w", "row", "u", "shown", "first"), strict=True)) | {
    "system": "hostile",
    "about": "nothing",
}


def make(**changes: str) -> Source:
    return Source("hostile.yaml", SPEC.format(**(PLAIN | changes)))


def compile_all(files: dict[str, str], folder: Path) -> None:
    for file, text in files.items():
        (folder / file).write_text(text, encoding="ascii")
    sources = [file for file in files if file.endswith(".c")]
    for compiler in COMPILERS:
        command = [compiler, *STRICT, "-fsyntax-only", *sources]
        done = subprocess.run(command, capture_output=True, text=True, cwd=folder)
        assert done.returncode == 0, done.stderr


def carry_through(source: Source, folder: Path, *, paper: bool = True, driver: bool = True) -> None:
    """The spec is valid, its C compiles strictly everywhere, its Python runs, and its derivations are written."""
    try:
        check(source)
        with made_once():
            compile_all(emit(source, "c", Options(driver=driver)), folder)
            for array in ("", "numpy"):
                (text,) = emit(source, "python", Options(array=array)).values()
                run_python(python_model(text, "hostile_" + array))
            for to in ("text", "latex") if paper else ():
                assert derive(source, Options(to=to))
    except SpecError as error:
        raise AssertionError(render_text(error.source, error.diagnostics)) from error


def run_python(module: object) -> None:
    sizes = {k: len(getattr(module, k)) for k in ("COORDINATES", "STATE")}
    q, y = [0.3 + 0.1 * k for k in range(sizes["COORDINATES"])], [0.3 + 0.05 * k for k in range(sizes["STATE"])]
    for name in ("rhs", "accelerations", "reactions", "energy", "jacobian", "outputs", "velocities"):
        getattr(module, name)(0.1, y)
    for name in ("state", "residuals"):
        getattr(module, name)(0.1, q, q)


def refusal(source: Source) -> tuple[str, ...]:
    """The codes of the diagnostics that a spec is refused with."""
    with pytest.raises(SpecError) as caught:
        check(source)
    assert render_text(caught.value.source, caught.value.diagnostics)
    return tuple(diagnostic.code for diagnostic in caught.value.diagnostics)


def names_of(pool: tuple[str, ...]) -> list[str]:
    python = (*keyword.kwlist, *keyword.softkwlist)
    return sorted({name for name in (*pool, *python) if name.isidentifier() and name not in RESERVED})


PYTHON = tuple(name for name in dir(builtins) if not name.endswith(("Error", "Warning", "Exception")))
GROUPS = [
    *(names_of((*C_WORDS, *LIBRARY, *OWN_WORDS, *MACHINES, *PYTHON))[k : k + 8] for k in range(0, 400, 8)),
]


@pytest.mark.sample(8)
@pytest.mark.parametrize("group", [g for g in GROUPS if g], ids=lambda g: g[0])
def test_reserved_words_are_good_names(group: list[str], tmp_path: Path) -> None:
    """Each word as a coordinate, a parameter, a definition, a constraint, a quasi-velocity, an output and a scene."""
    names = dict(zip("abcdefgh", group, strict=False))
    if len(set(names.values())) < 8 or {"third", "second_one"} & set(group):
        names = names | {key: PLAIN[key] for key in "abcdefgh" if key not in names}
    carry_through(make(**names), tmp_path, paper=len(group[0]) % 6 == 0)


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    "system",
    [
        "double",
        "int",
        "main",
        "class",
        "lambda",
        "math",
        "sys",
        "os",
        "json",
        "numpy",
        "errno",
        "stdio",
        "y",
        "exp",
        "j0",
        "t",
        "none",
        "e1",
        "x" * 1000,
    ],
)
def test_systems_are_named_like_words_and_modules(system: str, tmp_path: Path) -> None:
    source = make(system=system)
    files = emit(source, "c", Options(driver=True))
    for file, text in files.items():
        (tmp_path / (file if len(file) < 200 else file[-100:])).write_text(text.replace("x" * 1000, "x" * 91))
    files = {
        (file if len(file) < 200 else "x" * 91 + file[1000:]): text.replace("x" * 1000, "x" * 91)
        for file, text in files.items()
    }
    compile_all(files, tmp_path)
    (text,) = emit(source, "python").values()
    run_python(python_model(text, "named"))


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_name_is_refused(name: str) -> None:
    assert refusal(make(a=name.replace('"', "")))


PAIRS = (
    ("theta", "θ"),
    ("alpha", "α"),
    ("Omega", "Ω"),
    ("a", "ａ"),
    ("sigma", "ς"),
    ("epsilon", "ϵ"),
    ("phi", "ϕ"),
    ("mu", "µ"),
    ("K", "\u212a"),
)


@pytest.mark.parametrize(("ascii_name", "other"), PAIRS)
def test_names_that_fold_together_are_refused(ascii_name: str, other: str) -> None:
    assert "E0305" in refusal(make(a=ascii_name, b=other))


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("first", "second"),
    [("é", "u00e9"), ("x", "х"), ("x_dot", "x"), ("ж", "u0436"), ("Å", "A"), ("s_x", "x"), ("ab", "a_b")],
)
def test_names_that_look_alike_stay_apart(first: str, second: str, tmp_path: Path) -> None:
    """Identifiers of both exist in the emitted code, and they differ."""
    carry_through(make(a=first, b=second), tmp_path)


ABOUTS = (
    "*/ int main(void) { return 1; } /*",
    "/* // ??/",
    "'''",
    '\\"\\"\\"',
    "\\\\end{document} \\\\input{x} \\\\write18{true}",
    "{{ 7*7 }} {% raw %} {# #}",
    "<< 7*7 >> <% if x %> <# #>",
    "ends with a backslash \\\\",
    "100 % of $x$ & #1 ~ _ ^ { }",
    "trigraphs ??= ??( ??/ ??'",
    "%s %n %d {0} {x!r}",
    "\\u202e right to left \\u2066",
    "é ü λ 漢字 💥",
    "\\\\N{BULLET} \\\\x41 \\\\u0041",
    "x" * 5000,
    "a " * 5000,
    "-- ]]> <script>alert(1)</script> &amp;",
    "#define double int",
    "\\\\verb|x| \\\\begin{verbatim}",
    "``` ```",
)


@pytest.mark.sample(6)
@pytest.mark.parametrize("about", ABOUTS, ids=range(len(ABOUTS)))
def test_texts_do_not_leave_their_comments(about: str, tmp_path: Path) -> None:
    carry_through(make(about=about), tmp_path)


@pytest.mark.parametrize("about", ["\\u0007", "\\u0000", "\x07", "\ufeff", "\\u001b[31m"])
def test_control_characters_are_refused(about: str) -> None:
    assert "E0102" in refusal(make(about=about))


def timed(label: str, seconds: float, started: float) -> None:
    elapsed = time.process_time() - started
    print(f"{label}: {elapsed:.2f} s", file=sys.stderr)
    assert elapsed < seconds, label


def test_very_long_names(tmp_path: Path) -> None:
    long = {key: key * 1000 for key in "abcdefgh"}
    started = time.process_time()
    carry_through(make(**long), tmp_path)
    timed("names of 1000 characters", HANG, started)


@pytest.mark.slow
def test_three_hundred_coordinates() -> None:
    names = [f"x{k}" for k in range(300)]
    energy = " + ".join(f"{a}'^2/2" for a in names)
    springs = " + ".join(f"({a} - {b})^2/2" for a, b in itertools.pairwise(names))
    text = f"nhc: 1\nsystem: chain\ncoordinates: [{', '.join(names)}]\nT: {energy}\nV: {springs}\n"
    started = time.process_time()
    (module,) = emit(Source("chain.yaml", text), "python", Options(only=("rhs",))).values()
    model = python_model(module, "chain")
    y = [0.01 * k * k for k in range(300)] + [0.0] * 300
    assert model.rhs(0.0, y)[300 + 5] == pytest.approx(0.02)
    timed("300 coordinates", HANG, started)


@pytest.mark.slow
def test_a_spec_of_900_kilobytes(tmp_path: Path) -> None:
    lines = [f'  d{k}: "x*{k}.5 + sin({k}*x) - cos(x)^{2 + k % 7} + {"1.0*x + " * 8}{k}"' for k in range(8500)]
    last = "d8499 + d17"
    head = "nhc: 1\nsystem: large\ncoordinates: [x]\ndefine:\n"
    text = head + "\n".join(lines) + f'\nT: "x\'^2/2"\nV: {last}\n'
    assert 900_000 < len(text) < 1 << 20
    started = time.process_time()
    compile_all(emit(Source("large.yaml", text), "c", Options(only=("rhs", "energy"))), tmp_path)
    timed("a spec of 900 kB", HANG, started)


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "piece",
    ["x*", "x^2*{k} - ", *(pytest.param(x, marks=pytest.mark.slow) for x in ("sin({k}*x) + ", "x/({k} + x) + "))],
)
def test_an_expression_of_90000_characters(piece: str, tmp_path: Path) -> None:
    body, k = "", 1
    while len(body) < 90_000:
        body, k = body + piece.format(k=k), k + 1
    text = f'nhc: 1\nsystem: long\ncoordinates: [x]\nT: "x\'^2/2"\nU: {body}1\n'
    source = Source("long.yaml", text)
    started = time.process_time()
    check(source)
    (module,) = emit(source, "python", Options(only=("rhs", "energy"))).values()
    python_model(module, "long").rhs(0.0, [0.4, 0.0])
    compile_all(emit(source, "c", Options(only=("rhs", "energy"))), tmp_path)
    timed(f"90000 characters of {piece}", HANG, started)


@pytest.mark.sample(3)
@pytest.mark.parametrize("nest", ["({})", "sin({})", "-{}", "1/(2 + {})", "({})^2", "x^({})", "atan2({}, 2)"])
@pytest.mark.parametrize("depth", [60, 198, 5000])
def test_deep_nesting(nest: str, depth: int, tmp_path: Path) -> None:
    """To the depth of the language it is carried through, or refused where it explodes; beyond it is refused."""
    body = "x"
    for _ in range(depth):
        body = nest.format(body)
        if len(body) > 90_000:
            break
    text = f'nhc: 1\nsystem: deep\ncoordinates: [x]\nT: "x\'^2/2"\nforces: {{x: "{body}"}}\n'
    source = Source("deep.yaml", text)
    started = time.process_time()
    try:
        check(source)
        (module,) = emit(source, "python", Options(only=("rhs",))).values()
        compile_all(emit(source, "c", Options(only=("rhs",))), tmp_path)
        python_model(module, "deep")
    except SpecError as error:
        assert depth > 100, render_text(error.source, error.diagnostics)
    timed(f"nesting {nest} {depth}", HANG, started)


def test_unknown_functions_are_refused_by_name() -> None:
    with pytest.raises(EmitError):
        emit(make(), "c", Options(only=("rhs; system('true')",)))
