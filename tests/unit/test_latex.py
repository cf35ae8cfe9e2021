"""The LaTeX document: names, escaping, width, and that pdflatex runs clean on it."""

from __future__ import annotations

import itertools
import re
import shutil
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

from nhc.emit.environment import create_environment
from nhc.emit.latex import list_context, render
from nhc.emit.latex.document import TEMPLATE
from nhc.emit.latex.math import LatexMath
from nhc.emit.latex.names import PLAIN
from nhc.emit.latex.spelling import escape, escape_breakable, spell_unit
from nhc.emit.latex.width import estimate
from nhc.emit.text.math import TextMath
from nhc.language import Source, decode, read
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from nhc.program.ir import Binary, Call, Number, Pi, Power
from nhc.program.paper import Derivation, Mark, derivation
from nhc.stamp import PLACEHOLDER, is_untouched, stamp

SPECS = Path(__file__).resolve().parents[2] / "specs"
LATEX = shutil.which("pdflatex")
COMPILED = (
    "chaplygin_sleigh",
    "rolling_disk",
    "snakeboard",
    "ball_on_table",
    "voronec_particle",
    "free_rigid_body",
    "double_pendulum",
    "bicycle",
    "rattleback",
    "diff_drive",
)


def derive(source: Source, formulation: str = "") -> Derivation:
    system = resolve(decode(source))
    chosen = formulate(system, formulation)
    return derivation(system, chosen, equations_of(system, chosen))


def load(name: str, formulation: str = "") -> Derivation:
    return derive(read(str(SPECS / f"{name}.yaml")), formulation)


@pytest.mark.parametrize(
    ("mark", "wanted"),
    [
        (Mark("theta", dots=2), r"\ddot{\theta}"),
        (Mark("theta1", dots=1), r"\dot{\theta}_{1}"),
        (Mark("x", dots=1, prefix="d"), r"d\dot{x}"),
        (Mark("pi", ("slip",), prefix="d"), r"d\pi_{\mathit{slip}}"),
        (Mark("gamma", ("v", "w"), ("slip",)), r"\gamma^{\mathit{slip}}_{v,w}"),
        (Mark("p", ("w",), star=True), "p^{*}_{w}"),
        (Mark("r_R"), "r_{R}"),
        (Mark("lam"), r"\mathit{lam}"),
        (Mark("rider_x", dots=1), r"\dot{\mathit{rider}}_{x}"),
        (Mark("m_rider"), r"m_{\mathrm{rider}}"),
        (Mark("I_xz"), "I_{xz}"),
        (Mark("e1x"), "e_{1x}"),
        (Mark("rider_x", prefix="d"), r"d\,\mathit{rider}_{x}"),
        (Mark("rider", dots=1, prefix="d"), r"d\,\dot{\mathit{rider}}"),
        (Mark("p", ("phi_1",)), r"p_{\varphi_{1}}"),
        (Mark("p", ("theta_rear",), star=True), r"p^{*}_{\theta_{\mathrm{rear}}}"),
        (Mark("Omega form", ("c",)), r"\boldsymbol{\Omega}_{c}"),
        (Mark("Beta"), r"\mathrm{B}"),
    ],
)
def test_marks_are_set_as_a_printer_would(mark: Mark, wanted: str) -> None:
    assert PLAIN.print_mark(mark) == wanted


def test_text_of_the_user_is_escaped() -> None:
    assert escape("50% of {a_b} & $x^2$ #1 ~ \\input") == (
        r"50\% of \{a\_b\} \& \$x\textasciicircum{}2\$ \#1 \textasciitilde{} \textbackslash{}input"
    )
    assert escape("Čaplygin, é, θ") == r"\v{C}aplygin, \'{e}, $\theta$"
    assert escape("“a” – ‘b’ — ∂") == (
        r"\textquotedblleft{}a\textquotedblright{} \textendash{} \textquoteleft{}b\textquoteright{} \textemdash{} $\partial$"
    )
    assert escape("3 m² ± 1 µm, ½, 90°, a → b, x₁") == (
        r"3 m$^{2}$ $\pm$ 1 $\mu$m, 1/2, 90$^{\circ}$, a $\to$ b, x$_{1}$"
    )
    assert escape("10⁻³") == "10$^{-}$$^{3}$"
    assert escape("\u202eevil") == "evil"
    assert escape("Чаплыгин, Я ь €") == r"\v{C}aplygin, \^{A} ' \texteuro{}"
    assert escape("雪") == r"\textless{}U+96EA\textgreater{}"
    assert spell_unit("kg*m^2/s^2") == r"kg\,m$^{2}$/s$^{2}$"


def test_widths_grow_with_the_formula() -> None:
    assert estimate("a + b") > estimate("a")
    assert estimate("x_{abc}") < estimate("xabc")


def test_document_is_stamped_numbered_and_sectioned() -> None:
    text = render(load("chaplygin_sleigh"))
    assert text.count(PLACEHOLDER) == 1
    assert is_untouched(stamp(text))
    for number in ("I.1.1", "I.2.3", "I.2.4", "I.2.11", "II.2.2", "III.2.5", "III.1.1", "I.2.15", "I.4.1"):
        assert rf"\tag{{{number}}}" in text
    assert text.count(r"\section{") == 10
    assert r"m\,\dot{v} &= m\,a\,w^{2}" in text
    assert r"\dot{w} &= -\frac{m\,a\,v\,w}{J + m\,a^{2}}" in text


def test_the_template_uses_what_it_is_given() -> None:
    from jinja2 import meta

    environment = create_environment()
    assert environment.loader is not None
    source, _, _ = environment.loader.get_source(environment, TEMPLATE)
    assert meta.find_undeclared_variables(environment.parse(source)) == set(list_context(load("pendulum")))


def test_the_bicycle_is_short() -> None:
    source = read(str(SPECS / "bicycle.yaml"))
    system = resolve(decode(source))
    chosen = formulate(system)
    equations = equations_of(system, chosen)
    text = render(derivation(system, chosen, equations))
    assert len(text.encode()) < 300_000


def compile_document(text: str, folder: Path) -> str:
    """The log of one run of pdflatex."""
    assert LATEX is not None
    (folder / "model.tex").write_text(text)
    command = [LATEX, "-interaction=nonstopmode", "-halt-on-error", "model.tex"]
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=120, check=False)
    log = (folder / "model.log").read_text(errors="replace")
    assert done.returncode == 0, log[-2000:]
    return log


def check_clean(log: str) -> None:
    widths = [float(width) for width in re.findall(r"Overfull \\hbox \(([\d.]+)pt", log)]
    assert max(widths, default=0.0) <= 20.0
    assert "Warning" not in log


if LATEX is not None:

    @pytest.mark.parametrize("name", COMPILED)
    def test_pdflatex_runs_clean(name: str, tmp_path: Path) -> None:
        check_clean(compile_document(stamp(render(load(name))), tmp_path))

    @pytest.mark.parametrize("formulation", ["multipliers", "voronec", "chaplygin"])
    def test_every_formulation_compiles(formulation: str, tmp_path: Path) -> None:
        check_clean(compile_document(render(load("rolling_disk", formulation)), tmp_path))

    def test_a_determinant_among_the_facts_stays_on_the_page(tmp_path: Path) -> None:
        check_clean(compile_document(render(load("n_snake3", "multipliers")), tmp_path))

    def test_formulas_of_several_lines_among_the_facts_stay_on_the_page(tmp_path: Path) -> None:
        """Two threads of a bifilar pendulum: their rank is lost where ten long products vanish."""
        thread = "  - (x {0} a*cos(th)*cos(phi) {1} a)^2 + (y {0} a*cos(th)*sin(phi))^2 + (z {0} a*sin(th))^2 = L^2\n"
        text = (
            "nhc: 1\nsystem: bifilar\ncoordinates: [x, y, z, phi, th]\nparameters: {m: 1, J: 0.05, a: 0.3, L: 1.2, g: 9.81}\n"
            "T: m/2*(x'^2 + y'^2 + z'^2) + J/2*(th'^2 + cos(th)^2*phi'^2)\nV: m*g*z\nholonomic:\n"
        )
        text += thread.format("+", "-") + thread.format("-", "+")
        text += "scenes: {twist: {initial: {phi: 0.2, z: {near: -1.2}}, time: [0, 1]}}\n"
        (document,) = emit(Source("bifilar.yaml", text), "latex", Options()).values()
        check_clean(compile_document(document, tmp_path))

    def test_roots_among_the_facts_stay_on_the_page(tmp_path: Path) -> None:
        """Particles with parallel velocities on a rod: no line ends below a root, which is a quarter of a line."""
        text = (
            "nhc: 1\nsystem: parallel\ncoordinates: [x1, y1, x2, y2]\nparameters: {m: 1, M: 2, l: 1}\n"
            "T: m/2*(x1'^2 + y1'^2) + M/2*(x2'^2 + y2'^2)\n"
            "constraints: [\"(x2 - x1)*(y1' + y2') = (y2 - y1)*(x1' + x2')\"]\n"
            'holonomic: [rod: "sqrt((x2 - x1)^2 + (y2 - y1)^2) - l = 0"]\n'
        )
        (document,) = emit(Source("parallel.yaml", text), "latex", Options()).values()
        check_clean(compile_document(document, tmp_path))

    def test_hostile_texts_compile(tmp_path: Path) -> None:
        text = (
            "nhc: 1\nsystem: hostile\nabout: '50% \\\\end{document} $ & # _ ^ ~ {} ünder 雪 `x`'\n"
            "coordinates:\n  lambda_1: {about: 'a & b', unit: m}\n  thetadotdot: {unit: '1'}\n"
            "parameters: {Omega: 1, mass_of_the_thing: 2, S: 0.1}\n"
            "T: mass_of_the_thing/2*(lambda_1'^2 + exp(-S*lambda_1)*thetadotdot'^2)\n"
            "U: -Omega*abs(lambda_1) + sqrt(1 + thetadotdot^2) + atan2(lambda_1, 2)\n"
        )
        check_clean(compile_document(render(derive(Source("hostile.yaml", text))), tmp_path))


def test_a_minus_inside_a_product_joins_the_sign_of_its_term() -> None:
    inner = Binary("*", Number(Fraction(-1, 4)), Call("sqrt", (Pi(),)))
    for op, sign in (("+", "-"), ("-", "+")):
        whole = Binary(op, Pi(), inner)
        for printed in (LatexMath({}).pieces(whole), TextMath({}).pieces(whole)):
            assert sign in [piece.text.strip() for piece in printed]
            assert not any(a.text.strip() in "+-" and b.text.strip() == "-" for a, b in itertools.pairwise(printed))


def test_long_expressions_in_prose_may_be_broken_and_cut_ones_end_in_dots() -> None:
    expression = "sin(theta+atan(sin(gamma)*sin(lf)/cos(lf)))*cos(theta…"
    text = escape_breakable(f"lost where {expression} = 0 (a*b)")
    assert text.replace(r"\allowbreak{}", "") == f"lost where {expression.replace('…', '...')} = 0 (a*b)"
    assert text.count(r"\allowbreak{}") == 9 and "(a*b)" in text


def test_bars_enclose_as_parentheses_do() -> None:
    pieces = LatexMath({}).pieces(Power(Call("abs", (Pi(),)), 3))
    assert "".join(piece.text for piece in pieces) == r"|\pi|^{3}"


def test_what_divides_a_sum_with_fractions_stands_ahead_of_it() -> None:
    half = Binary("+", Pi(), Binary("/", Call("sin", (Pi(),)), Call("cos", (Pi(),))))
    quotient = Binary("/", Binary("*", Call("sin", (Pi(),)), half), Call("exp", (Pi(),)))
    text = "".join(piece.text for piece in LatexMath({}).pieces(quotient))
    assert text.startswith(r"\frac{\sin(\pi)}{\exp(\pi)}\,\Bigl(\pi + \frac{") and "^{-1}" not in text
