"""The moving picture on a run's page: its numbers are the trajectory's, and nothing comes from elsewhere."""

from __future__ import annotations

import json
import math
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from nhc.cli import main
from nhc.diagnostics import Source, SpecError
from nhc.dump import dump_decode
from nhc.language import decode
from nhc.language.schema import schema
from nhc.pipeline import Options, check, emit
from nhc.report.drawing import MOST_FRAMES, describe_drawing
from nhc.report.trajectory import make_file
from nhc.resources import find_specs
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run

SPEC = """\
nhc: 1
system: cart
coordinates: {x: {}, y: {}, theta: {range: [-9, 9]}}
parameters: {m: 1, J: 0.5, L: 2}
define: {tip: x + L*cos(theta)}
T: m/2*(x'^2 + y'^2) + J/2*theta'^2
constraints: ["-sin(theta)*x' + cos(theta)*y' = 0"]
scenes: {go: {initial: {x': 1, theta': 0.7}, time: [0, 3], need: [x, y, theta, x']}}
"""
DRAW = """\
draw:
  - {point: [x, y + t], name: "</script> & co", trace: true}
  - line: [[x, y], [tip, y + L*sin(theta)], [x', 0]]
  - body: {at: [x, y], angle: theta, shape: [[0, 0], [L, 0], [0, L/2]]}
"""
SPATIAL = """\
  - circle: {centre: [x, y, L], radius: L/4, normal: [cos(theta), sin(theta), 0]}
  - line: [[0, 0, 0], [x, y, sqrt(L)]]
"""
ROLLING = {"rolling_disk": 1, "vertical_disk": 1, "disk_chain2": 2, "bicycle": 2}  # discs
IN_SPACE = (
    *(
        "ball_on_table",
        "bicycle",
        "chaplygin_ball",
        "chaplygin_ball_quaternion",
        "contact_oscillator",
        "contact_oscillator_eps",
    ),
    *(
        "disk_chain2",
        "free_rigid_body",
        "free_rigid_body_quaternion",
        "heavy_top",
        "heavy_top_quaternion",
        "nh_particle",
    ),
    *(
        "nh_particle_pot",
        "point_mass",
        "rattleback",
        "rolling_disk",
        "routh_sphere",
        "smooth_tippe_top",
        "spherical_pendulum",
    ),
    *("skate_incline", "suslov", "vertical_disk", "veselova"),
)
DRAWN = sorted(path.stem for path in find_specs().glob("*.yaml") if "\ndraw:" in path.read_text())


def run_drawn(text: str, points: int = 31, compiled: bool = False) -> Trajectory:
    job = open_scene(Source("cart.yaml", text), checks=True, draw=True)
    return run(job, Settings(points=points, compiled=compiled))


def value(drawing: dict, place: int, k: int) -> float:
    column = drawing["columns"][place]
    return column[k] if isinstance(column, list) else column


def points_of(drawing: dict, shape: int, k: int) -> list[tuple[float, ...]]:
    values = [value(drawing, place, k) for place in drawing["shapes"][shape]["places"]]
    return [tuple(values[i : i + 3]) for i in range(0, len(values), 3)]


def near(points: list[tuple[float, ...]]) -> object:
    return [pytest.approx(point, rel=1e-8, abs=1e-8) for point in points]


def page_of(path: Path, spec: Path | str, capsys: pytest.CaptureFixture[str], *more: str) -> str:
    assert main(["run", str(spec), "-o", str(path), "--force", *more]) == 0
    capsys.readouterr()
    return path.read_text()


def drawing_in(page: str) -> dict:
    return json.loads(page.split('id="drawing">')[1].split("</script>")[0])


def test_the_picture_is_the_trajectory(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "cart.yaml"
    spec.write_text(SPEC + DRAW)
    found = run_drawn(SPEC + DRAW)
    drawing = drawing_in(page_of(tmp_path / "cart.html", spec, capsys, "--points", "31", "--python"))
    assert drawing == describe_drawing(found)
    assert drawing["spatial"] is False and [s["kind"] for s in drawing["shapes"]] == ["point", "line", "body"]
    assert [s["trace"] for s in drawing["shapes"]] == [True, False, False]
    assert drawing["times"] == pytest.approx(found.times, rel=1e-8)
    for k, (t, (x, y, theta, vx)) in enumerate(zip(found.times, found.rows, strict=True)):
        c, s = math.cos(theta), math.sin(theta)
        assert points_of(drawing, 0, k) == near([(x, y + t, 0)])
        assert points_of(drawing, 1, k) == near([(x, y, 0), (x + 2 * c, y + 2 * s, 0), (vx, 0, 0)])
        assert points_of(drawing, 2, k) == near([(x, y, 0), (x + 2 * c, y + 2 * s, 0), (x - s, y + c, 0)])


STAGE = """
const written = [];
const pen = { measureText: (text) => ({ width: 6.5 * text.length }), fillText: (...where) => written.push(where) };
for (const name of ["setTransform", "clearRect", "beginPath", "lineTo", "fill", "arc", "strokeText"]) { pen[name] = () => {}; }
pen.stroke = () => { if (written.length && ["#eee", "#bbb"].includes(pen.strokeStyle)) { throw "a line over a label"; } };
const part = () => ({ addEventListener() {}, style: {}, clientWidth: 760, clientHeight: 506, getContext: () => pen });
const window = { devicePixelRatio: 1, addEventListener() {} };
const document = { getElementById: () => ({ textContent: DATA }), querySelector: () => ({ querySelector: part }) };
"""


def written_on(point: str, start: str) -> list[tuple[str, float, float]]:
    """The texts on the canvas of a point that moves with these start values, and their places."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("no node")
    text = "nhc: 1\nsystem: far\ncoordinates: [x, y, z]\nT: x'^2 + y'^2 + z'^2\n"
    text += f"scenes: {{go: {{initial: {start}, time: [0, 10]}}}}\ndraw: [{{point: {point}, trace: true}}]\n"
    page = make_file(run_drawn(text), ".html").decode()
    data = json.dumps(json.dumps(drawing_in(page)))
    script = page.rsplit("<script>", 1)[1].split("</script>")[0]
    stage = f"const DATA = {data};\n{STAGE}{script}\nconsole.log(JSON.stringify(written));\n"
    done = subprocess.run([node, "-"], input=stage, capture_output=True, text=True, timeout=20, check=True)
    return [(text, x, y) for text, x, y in json.loads(done.stdout)]


@pytest.mark.parametrize(
    ("start", "texts"),
    [
        ("{x: 7000000, y: -3000000, x': 1, y': 2}", {"7000005", "-2999985", "7000010"}),
        ("{x': 1e-7, y': 2e-7}", {"5e-7", "1e-6"}),
        ("{x: 1e20}", {"1e20", "8e19"}),
        ("{}", {"0", "0.2", "-0.4"}),
    ],
)
def test_the_grid_tells_its_lines_apart(start: str, texts: set[str]) -> None:
    """Each label is that of one line, whole, and covers no other; what is at rest far away is shown as well.

    The stage refuses lines of the grid after the first label: they would cross it.
    """
    written = written_on("[x, y]", start)
    assert texts <= {text for text, _, _ in written}
    for places in ([(text, x) for text, x, y in written if y == 501], [(text, y) for text, x, y in written if x == 4]):
        assert len({text for text, _ in places}) == len(places) >= 2
    boxes = [(x, y - 9, x + 6.5 * len(text), y + 3) for text, x, y in written]
    assert all(a >= 0 and b >= 0 and c <= 760 and d <= 506 for a, b, c, d in boxes)
    for k, (a, b, c, d) in enumerate(boxes):
        assert all(c < e or g < a or d < f or h < b for e, f, g, h in boxes[:k])


def test_the_view_in_space_says_where_it_is() -> None:
    """Numbers beside the axes are places, not lengths, and a motion high above the ground is no dot."""
    written = {text for text, _, _ in written_on("[x, y, z]", "{x: 7000, z: 5000, x': 1, y': 2, z': 1}")}
    assert {"x", "y", "z", "7005", "5005", "15"} <= written
    assert {"x", "y", "z", "0", "20"} <= {text for text, _, _ in written_on("[x, y, z]", "{z: 8, x': 2, z': 1}")}


def test_shapes_in_space() -> None:
    found = run_drawn(SPEC + DRAW + SPATIAL)
    drawing = describe_drawing(found)
    assert drawing is not None and drawing["spatial"] is True
    for k, (x, y, theta, _) in enumerate(found.rows):
        places = drawing["shapes"][3]["places"]  # type: ignore[index]
        expected = (x, y, 2, 0.5, math.cos(theta), math.sin(theta), 0)
        assert [value(drawing, place, k) for place in places] == pytest.approx(expected, rel=1e-8, abs=1e-8)
        assert points_of(drawing, 4, k) == near([(0, 0, 0), (x, y, math.sqrt(2))])


def test_a_page_has_all_it_needs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "cart.yaml"
    spec.write_text(SPEC + DRAW + SPATIAL)
    page = page_of(tmp_path / "cart.html", spec, capsys, "--python")
    assert "http" not in page.replace("http://www.w3.org/2000/svg", "")
    assert not re.search(r"<(link|img|iframe|object)\b|<script[^>]*\bsrc\b|@import|url\(|fetch\(|import\(|eval\(", page)
    assert page.count("<script") == page.count("</script>") == 4  # a name of the user closes none
    assert drawing_in(page)["shapes"][0]["name"] == "</script> & co"
    assert "<canvas" in page and 'type="range"' in page


def test_without_draw_nothing_is_drawn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    spec = tmp_path / "cart.yaml"
    spec.write_text(SPEC)
    page = page_of(tmp_path / "cart.html", spec, capsys, "--python")
    assert "canvas" not in page and "drawing" not in page
    found = run_drawn(SPEC)
    assert describe_drawing(found) is None and set(found.drawn) == {()}


def test_a_long_run_is_thinned() -> None:
    drawing = describe_drawing(run_drawn(SPEC + DRAW, 3 * MOST_FRAMES))
    assert drawing is not None
    count = len(drawing["times"])  # type: ignore[arg-type]
    assert count == MOST_FRAMES + 1 and drawing["times"][-1] == 3  # type: ignore[index]
    assert {len(c) for c in drawing["columns"] if isinstance(c, list)} == {count}  # type: ignore[attr-defined]


def test_the_other_files_do_not_know_of_it() -> None:
    plain, drawn = Source("cart.yaml", SPEC), Source("cart.yaml", SPEC + DRAW + SPATIAL)
    for language in ("c", "python", "latex"):
        assert emit(plain, language, Options()) == emit(drawn, language, Options())
    first = run(open_scene(plain), Settings(points=5, compiled=False))
    second = run(open_scene(drawn), Settings(points=5, compiled=False))
    assert (first.rows, first.headings, second.drawn) == (second.rows, second.headings, ((),) * 5)


@pytest.mark.sample(6)
@pytest.mark.parametrize("name", DRAWN)
def test_the_gallery_draws(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = page_of(tmp_path / "a.html", find_specs() / f"{name}.yaml", capsys, "--points", "21")
    drawing = drawing_in(page)
    assert drawing["spatial"] == (name in IN_SPACE)
    downwards = name in ("bicycle", "rattleback")
    assert drawing["axes"] == (["x", "\u2212y", "\u2212z"] if downwards else ["x", "y", "z"])
    assert len(drawing["times"]) == 21 and any(shape["trace"] for shape in drawing["shapes"])
    if name == "double_pendulum":  # rods keep their lengths
        for k in range(21):
            first, second, third = points_of(drawing, 0, k)
            assert (math.dist(first, second), math.dist(second, third)) == pytest.approx((1, 1), rel=1e-7)
    circles = [shape for shape in drawing["shapes"] if name in ROLLING and len(shape["places"]) == 7]
    assert len(circles) == ROLLING.get(name, 0)
    for k in range(21 if circles else 0):  # a point of each circle is one that is drawn, on the floor
        drawn = [points_of(drawing, i, k)[0] for i, shape in enumerate(drawing["shapes"]) if len(shape["places"]) == 3]
        contacts = [point for point in drawn if point[2] == pytest.approx(0, abs=1e-7)]
        for circle in circles:
            *centre, radius, n1, n2, n3 = [value(drawing, place, k) for place in circle["places"]]
            arms = [[a - b for a, b in zip(point, centre, strict=True)] for point in contacts]
            offs = [max(abs(math.hypot(*arm) - radius), abs(arm[0] * n1 + arm[1] * n2 + arm[2] * n3)) for arm in arms]
            assert min(offs) < 1e-6


@pytest.mark.parametrize("ask", [check, run_drawn])
def test_a_division_by_zero_is_said(ask: Callable[[Any], object]) -> None:
    text = SPEC + "draw: [{point: [x, 1/0]}]\n"
    with pytest.raises(SpecError) as caught:
        ask(text if ask is run_drawn else Source("cart.yaml", text))
    assert [(d.code, d.span.start) for d in caught.value.diagnostics] == [("E0417", len(SPEC) + 21)]
    assert emit(Source("cart.yaml", text), "c")


def test_schema_and_dump() -> None:
    import yaml

    validator = jsonschema.Draft202012Validator(schema())
    assert validator.is_valid(yaml.safe_load(SPEC + DRAW + SPATIAL))
    for wrong in (
        "[{point: [x]}]",
        "[{trace: true}]",
        "[{point: [x, y], line: [[0, 0], [1, 1]]}]",
        "[{circle: {centre: [x, y]}}]",
        "[{body: {at: [x, y], angle: 0, shape: [[0, 0], [1, 0]]}}]",
        "[{point: [x, y], trace: maybe}]",
        "{point: [x, y]}",
    ):
        assert not validator.is_valid(yaml.safe_load(SPEC + f"draw: {wrong}\n")), wrong
        with pytest.raises(SpecError):
            decode(Source("cart.yaml", SPEC + f"draw: {wrong}\n"))
    assert "draw point x, y + t\n" in dump_decode(Source("cart.yaml", SPEC + DRAW), Options())


def test_what_is_drawn_and_has_no_value_is_named() -> None:
    found = run_drawn(SPEC + "draw: [{point: [x, sqrt(2 - t)]}]\n", points=4)
    assert (found.ended, found.times[-1], found.outcome.t) == ("failed", 2.0, pytest.approx(2.0, abs=1e-7))
    assert found.reason == "`sqrt(2 - t)` under `draw` has no real, finite value"


def test_the_start_of_a_rotation_is_told_by_its_angular_velocity() -> None:
    """As a scene gives it; the rates of a quaternion are nobody's numbers, and half as large."""
    text = "nhc: 1\nsystem: spin\ncoordinates: [x]\nrotation: {R: {velocities: [p, q, r]}}\nT: x'^2 + p^2 + 2*q^2 + 3*r^2\n"
    text += "scenes: {go: {initial: {R: [1, 0, 0, 0], q: 0.8, r: -0.5, x': 2}, time: [0, 1]}}\n"
    found = run(open_scene(Source("spin.yaml", text), checks=True), Settings(points=3, compiled=False))
    page = make_file(found, ".html").decode().replace("\u00a0", " ")
    assert "R_0 = 1, x' = 2, q = 0.8, r = -0.5<" in page.replace("&#x27;", "'").replace("&#39;", "'")
