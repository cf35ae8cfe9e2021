"""The agreement certificate on every gallery system, and that it can fail."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from functools import cache

import pytest

from nhc.algebra.exact.degree import Degrees
from nhc.algebra.graph import Graph
from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.associate import Equations
from nhc.mechanics.certificates import certificate as module
from nhc.mechanics.certificates.certificate import Certificate, certify
from nhc.mechanics.certificates.claims import Claim, wrong_claims
from nhc.mechanics.certificates.file import is_sound, power_of_ten, verify, write
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from tests.support import GALLERY, seldom, spec_path

# what each system can tell from the truth, measured beforehand by another program at random states
ON_REDUCED = ("lagrange_of_T_star", "boxed_I_3_sign", "I_4_9_mu_thrice", "noaffine")
TELLS = {
    "chaplygin_sleigh": (True, True, False, False),
    "skate_incline": (True, True, False, False),
    "vertical_disk": (False, False, False, False),
    "nh_particle": (True, True, False, False),
    "voronec_particle": (True, True, True, False),
    "affine_voronec": (True, True, True, True),
    "chaotic": (True, True, False, False),
    "charged_sleigh": (True, True, False, False),
    "snakeboard": (True, True, False, False),
    "diff_drive": (True, True, False, False),
    "n_trailer3": (True, True, True, False),
    "rolling_disk": (True, True, False, False),
    "ball_on_table": (True, True, True, True),
    "chaplygin_ball": (True, True, False, False),
    "suslov": (True, True, False, False),
    "veselova": (True, True, False, False),
    "rattleback": (True, True, False, False),
    "cartesian_pendulum": (False, False, False, False),
}


@cache
def system_of(name: str) -> System:
    return resolve(decode(read(str(spec_path(name)))))


@cache
def certificate_of(name: str) -> Certificate:
    return certify(system_of(name))


@pytest.mark.parametrize("force", ["-tanh(x')", "sin(x' - 2*y')*exp(-y')", "-cosh(theta' + x)", "x'*tanh(-x'/3)"])
def test_functions_of_velocities(force: str) -> None:
    """On the motion x' is v cos(theta), and tanh of the one must be tanh of the other."""
    text = f"""nhc: 1
system: rubbed
coordinates: [x, y, theta]
T: (x'^2 + y'^2 + theta'^2)/2
forces: {{x: "{force}", y: "sin(x)*{force}"}}
constraints: ["-sin(theta)*x' + cos(theta)*y' = 0"]
quasi_velocities: {{v: "x'*cos(theta) + y'*sin(theta)", w: theta'}}
"""
    made = certify(resolve(decode(Source("rubbed.yaml", text))))
    assert len(made.agreements) >= 4
    assert all(found.accelerations and found.reactions for found in made.agreements)


@pytest.mark.parametrize("part", ["accelerations", "reactions"])
@pytest.mark.parametrize("everywhere", [True, False])
def test_one_difference_at_some_of_the_points_is_enough(
    part: str, everywhere: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Voronec's equations with x too much in one entry, at all places or only where x is positive, agree no more; others do."""
    system = system_of("nh_particle")
    g, x = system.graph, system.q[0]
    extra = x if everywhere else g.mul(g.add(g.one, g.function("sign", x)), x)
    right = module.formulation_claim

    def spoilt(equations: Equations) -> Claim:
        claim = right(equations)
        if equations.formulation != "voronec":
            return claim
        (coefficients, constant), *others = getattr(claim, part)
        return replace(claim, **{part: ((coefficients, g.add(constant, extra)), *others)})

    monkeypatch.setattr(module, "formulation_claim", spoilt)
    found = certify(system)
    assert not found.holds
    for agreement in found.agreements:
        wrong = part if agreement.name == "voronec" else ""
        assert (agreement.accelerations, agreement.reactions) == (wrong != "accelerations", wrong != "reactions")


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", GALLERY)
def test_all_formulations_agree(name: str) -> None:
    found = certificate_of(name)
    assert found.holds
    assert is_sound(found)
    assert found.log10_bound < (-14 if found.signed else -30)
    assert found.states >= 9
    assert {a.name for a in found.agreements} == {f.name for f in applicable(system_of(name))}
    for a in found.agreements:
        assert max(a.distance.accelerations, a.distance.reactions) < 1e-8, a
        assert a.distance.states >= 6, a


def steered_snake(links: int) -> str:
    """Links in a row, under the middle of each an axle that is steered by itself."""
    x, y, define, kinetic, rows = "x", "y", list[str](), ["x'^2 + y'^2"], list[str]()
    for k in range(1, links + 1):
        if k > 1:
            define += [
                f"  x{k}: {x} - a*cos(th{k - 1}) - a*cos(th{k})",
                f"  y{k}: {y} - a*sin(th{k - 1}) - a*sin(th{k})",
            ]
            x, y = f"x{k}", f"y{k}"
            kinetic.append(f"{x}'^2 + {y}'^2")
        kinetic.append(f"0.1*th{k}'^2 + 0.01*(th{k}' + ps{k}')^2")
        rows.append(f"  - -sin(th{k} + ps{k})*{x}' + cos(th{k} + ps{k})*{y}' = 0")
    names = ", ".join(f"{name}{k}" for name in ("th", "ps") for k in range(1, links + 1))
    head = ["nhc: 1", "system: steered", f"coordinates: [x, y, {names}]", "parameters: {a: 0.5}", "define:", *define]
    return "\n".join([*head, f"T: ({' + '.join(kinetic)})/2", "constraints:", *rows, ""])


@pytest.mark.slow
def test_a_long_chain_of_pivots_is_not_singular_at_every_state() -> None:
    """The sum of a pivot's terms without their signs grows with each pivot before it, and says nothing after nine of them."""
    found = certify(resolve(decode(Source("steered.yaml", steered_snake(9)))))
    assert found.holds and found.states >= 6
    for a in found.agreements:
        assert a.distance.states >= 6 and max(a.distance.accelerations, a.distance.reactions) < 1e-6, a


@pytest.mark.parametrize("name", sorted(TELLS))
def test_wrong_derivations(name: str) -> None:
    found = {r.name: r for r in certificate_of(name).rejections}
    assert tuple(found[key].told_apart for key in ON_REDUCED) == TELLS[name]
    for r in found.values():
        if r.told_apart:
            assert r.distance.accelerations > 1e-3, r
        else:
            assert r.distance.accelerations < 1e-7, r


def test_the_printed_sum_over_free_momenta_is_told_apart() -> None:
    """Erratum E3 on every truly nonholonomic system whose quasi-velocities can show it."""
    for name in ("chaplygin_sleigh", "nh_particle", "rolling_disk", "snakeboard", "suslov", "veselova", "rattleback"):
        found = {r.name: r for r in certificate_of(name).rejections}
        assert found["III_2_6_as_printed"].told_apart, name
    assert {r.name: r for r in certificate_of("free_rigid_body").rejections}["III_2_4_doubled_gamma"].told_apart


def test_a_wrong_formulation_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    system = system_of("nh_particle")
    wrong = wrong_claims(system, applicable(system))[0].claim
    original = module.formulation_claim

    def mistaken(equations: object) -> object:
        right = original(equations)  # type: ignore[arg-type]
        return replace(wrong, name=right.name, reactions=right.reactions) if right.name == "voronec" else right

    monkeypatch.setattr(module, "formulation_claim", mistaken)
    found = certify(system)
    assert not found.holds
    assert [a.name for a in found.agreements if not a.accelerations] == ["voronec"]


def test_a_wrong_reaction_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    system = system_of("nh_particle")
    original, g = module.formulation_claim, system.graph

    def mistaken(equations: object) -> object:
        right = original(equations)  # type: ignore[arg-type]
        if right.name != "chaplygin":
            return right
        (coefficients, constant), *others = right.reactions
        return replace(right, reactions=((coefficients, g.neg(constant)), *others))

    monkeypatch.setattr(module, "formulation_claim", mistaken)
    found = certify(system)
    assert [(a.accelerations, a.reactions) for a in found.agreements if a.name == "chaplygin"] == [(True, False)]


def test_a_written_certificate_holds_and_a_changed_one_does_not() -> None:
    system = system_of("chaplygin_sleigh")
    text = write(certificate_of("chaplygin_sleigh"), system.spec.origin.text)
    assert text == write(certify(system), system.spec.origin.text)
    assert verify(text, system, system.spec.origin.text)[0] == []
    assert verify(text, system, system.spec.origin.text + "# other\n")[0] == [
        "it was written for another text of the spec"
    ]
    data = json.loads(text)
    for change, complaint in (
        (lambda d: d["points"][0].update(sha256="0" * 64), "`points`"),
        (lambda d: d["points"].pop(), "`log10_bound`"),
        (lambda d: d.update(degree="3"), "`degree`"),
        (lambda d: d["formulations"].pop(), "`formulations`"),
        (lambda d: d["formulations"][1].update(reactions="different"), "`formulations`"),
        (lambda d: d["formulations"][1]["double"].update(states=1), "`formulations`"),
        (lambda d: d["formulations"][1]["double"].update(accelerations="inf"), "`formulations`"),
        (lambda d: d["formulations"][1]["double"].update(accelerations="1e-3"), "`formulations`"),
        (lambda d: d["formulations"][1]["double"].update(reactions="0"), "`formulations`"),
        (lambda d: d.update(count=float(d["count"])), "`count`"),
        (lambda d: d.update(holds=1), "`holds`"),
        (lambda d: d.pop("nhc"), "`nhc`"),
        (lambda d: d.update(signature="good"), "`signature`"),
        (lambda d: d["wrong_derivations"][0].update(told_apart=False), "`wrong_derivations`"),
        (lambda d: d["wrong_derivations"][0].update(distance="1.0e-9"), "`wrong_derivations`"),
        (lambda d: d.update(points=7), "its points"),
        (lambda d: d.update(schema="nhc.certificate/0"), "it is not a certificate"),
    ):
        changed = json.loads(json.dumps(data))
        change(changed)
        found = verify(json.dumps(changed), system, system.spec.origin.text)[0]
        assert any(complaint in line for line in found), (complaint, found)
    for text in ("[", "[" * 100_000, "[]"):
        assert verify(text, system, "")[0][0].startswith("it is not ")


def test_rounding_is_no_distance() -> None:
    """A sleigh whose mass lies above its edge (a = 0) does not show the errors E2 and E3; another a does."""
    text = spec_path("chaplygin_sleigh").read_text()
    changed = re.sub(r"^  a: .*$", "  a: 0", text, count=1, flags=re.M)
    assert changed != text
    system = resolve(decode(Source("sleigh.yaml", changed)))
    found = certify(system)
    hidden = [r for r in found.rejections if r.told_apart and not found.is_far(r)]
    assert [r.erratum for r in hidden] == ["E3", "E2"]
    data = json.loads(write(found, changed))["wrong_derivations"]
    assert [d["distance"] for d in data if d["name"] in [r.name for r in hidden]] == ["0", "0"]
    known = certificate_of("chaplygin_sleigh")
    assert all(known.is_far(r) for r in known.rejections if r.told_apart)


def test_signs_are_right_by_chance_at_every_second_point() -> None:
    """More points, and a bound that says so."""
    text = (
        "nhc: 1\nsystem: rough\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nforces:\n  x: -abs(x')*x'\n"
        "constraints:\n  - c: z' - y*x' = 0\n"
    )
    found = certify(resolve(decode(Source("rough.yaml", text))))
    assert (found.holds, found.signed, len(found.points)) == (True, True, 48)
    assert -15 < found.log10_bound < -14


@pytest.mark.parametrize(("axes", "points"), [("xy", 384), seldom("xyz", 1536)])
def test_signs_that_are_multiplied_need_more_points(axes: str, points: int) -> None:
    """The inside of a box of four faces is met at one point of 16, of six faces at one of 64."""
    head = "nhc: 1\nsystem: region\ncoordinates: [x, y, z]\nparameters: {a: 1, b: 2, k: 3}\nT: (x'^2 + y'^2 + z'^2)/2\n"
    faces = "*".join(f"(1 + sign({s} - a))*(1 + sign(b - {s}))" for s in axes)
    found = certify(resolve(decode(Source("region.yaml", f"{head}forces: {{x: k*{faces}}}\n"))))
    assert (found.holds, found.signs, len(found.points)) == (True, 2 * len(axes), points)
    assert -11 < found.log10_bound < -10 and found.is_sure
    data = json.loads(write(found, ""))
    assert (data["count"], len(data["points"])) == (points, 64)


@pytest.mark.slow
def test_so_many_signs_that_no_number_of_points_makes_sure() -> None:
    names = [f"x{k}" for k in range(10)]
    corner = "*".join(f"(1 + sign({s} - a))*(1 + sign(b - {s}))" for s in names)
    squares = " + ".join(f"{s}'^2/2" for s in names)
    text = f"nhc: 1\nsystem: region\ncoordinates: [{', '.join(names)}]\nparameters: {{a: 1, b: 2}}\nT: {squares}\n"
    found = certify(resolve(decode(Source("region.yaml", f"{text}forces: {{x0: {corner}}}\n"))))
    assert (found.holds, found.signs, found.is_sure) == (True, 20, False)


def test_a_hidden_sign_of_a_root_counts() -> None:
    head = "nhc: 1\nsystem: region\ncoordinates: [x, y, z]\nparameters: {a: 1, b: 2, k: 3}\nT: (x'^2 + y'^2 + z'^2)/2\n"
    for force, signs in (("k*(sqrt((a*x)^2 + (b*x)^2) - x*sqrt(a^2 + b^2))", 1), ("k*sqrt(x^2 + y^2)", 0)):
        found = certify(resolve(decode(Source("region.yaml", f"{head}forces: {{x: {force}}}\n"))))
        assert (found.holds, found.signs) == (True, signs)


@pytest.mark.parametrize("force", ["3", "sign(x)", "0"])
def test_accelerations_that_are_numbers(force: str) -> None:
    """Of degree zero: two numbers that differ do so modulo a prime, but where it divides their difference."""
    text = f"nhc: 1\nsystem: falling\ncoordinates: [x]\nT: x'^2/2\nforces: {{x: {force}}}\n"
    found = certify(resolve(decode(Source("falling.yaml", text))))
    assert found.holds and found.degree == 0 and found.log10_bound < -14


def test_power_of_ten_rounds_up() -> None:
    assert [power_of_ten(x) for x in (0.0, 2e-16, 1e-12, 1.1e-12, 5.0)] == ["1e-15", "1e-15", "1e-12", "1e-11", "1e1"]


def test_degrees_bound_what_they_should() -> None:
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    sine = g.function("sin", x)
    quotient = g.div(g.add(g.power(x, 3), y), g.add(x, g.one))
    both = g.add(quotient, g.div(y, g.add(x, g.one)))
    root = g.function("sqrt", g.add(x, y))
    found = Degrees(g, [quotient, both, sine, root])
    assert found.over_common([quotient]) == 3
    assert found.over_common([both]) == 3  # one common denominator, not two
    assert found.over_common([sine]) == 2
    assert found.over_common([quotient, sine]) == 5
    assert found.roots == 1
    assert found.inflate(3) == 2 * 3 * 4


@pytest.mark.parametrize("name", ["f", "g", "h", "u"])
def test_wrong_derivations_are_told_apart_whatever_sign_the_first_points_have(name: str) -> None:
    """With K = max(0, f) the constraint z' = K y x' is z' = 0 at every second point, and everything agrees there."""
    text = f"""nhc: 1
system: valve
coordinates: [x, y, z]
parameters: {{m: 1, {name}: 2}}
T: m/2*(x'^2 + y'^2 + z'^2)
constraints:
  - c: z' = max(0, {name})*y*x'
"""
    made = certify(resolve(decode(Source("valve.yaml", text))))
    told = {one.name for one in made.rejections if one.told_apart}
    assert made.holds and told == {
        "lagrange_of_T_star",
        "boxed_I_3_sign",
        "III_2_6_as_printed",
        "III_2_4_doubled_gamma",
    }


def test_a_pole_of_the_coordinates_is_no_distance() -> None:
    """A trial point puts the hanging load to its pole, where accelerations of 1e33 leave no digit of the reactions."""
    text = """nhc: 1
system: crane_car
coordinates: [x, y, th, al, be]
parameters: {M: 40, J: 6, m: 5, a: 0.4, l: 1.2, g: 9.81, c: 0.3}
define:
  X: x + a*cos(th) + l*sin(al)*cos(th) - l*sin(be)*cos(al)*sin(th)
  Y: y + a*sin(th) + l*sin(al)*sin(th) + l*sin(be)*cos(al)*cos(th)
  Z: -l*cos(al)*cos(be)
T: M/2*(x'^2 + y'^2) + J/2*th'^2 + m/2*(X'^2 + Y'^2 + Z'^2)
V: m*g*Z
forces: {al: -c*al', be: -c*be'}
constraints:
  - edge: -sin(th)*x' + cos(th)*y' = 0
"""
    made = certify(resolve(decode(Source("crane_car.yaml", text))))
    assert {agreement.name for agreement in made.agreements} >= {"multipliers", "euler-lagrange", "voronec"}
    for agreement in made.agreements:
        assert agreement.distance.states >= 8
        assert max(agreement.distance.accelerations, agreement.distance.reactions) < 1e-11
