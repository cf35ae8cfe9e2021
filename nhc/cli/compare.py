"""``nhc compare``: do all formulations agree, and how far off are the tempting wrong ones?  Or: do two specs?"""

from __future__ import annotations

from math import ceil
from typing import TYPE_CHECKING

import click

from nhc.cli.options import json_option, spec_argument, verb
from nhc.cli.progress import Parts, show_line
from nhc.cli.reading import MIB, read_bounded
from nhc.cli.specs import complete_spec, open_spec
from nhc.cli.terminal import Exit, put_json, put_text, say
from nhc.cli.write import check_place, deliver

if TYPE_CHECKING:
    from nhc.mechanics.certificates.certificate import Certificate, Rejection
    from nhc.program.validation.validate import Kept

LARGEST_CERTIFICATE = 64 * MIB


@verb(
    "compare",
    "nhc compare chaplygin_sleigh",
    "nhc compare bicycle --certificate bicycle.json",
    "nhc compare bicycle bodies/bicycle",
)
@spec_argument
@click.argument("other", required=False, default="", shell_complete=complete_spec)
@click.option(
    "--map", "maps", metavar="NAME=EXPR", multiple=True, help="What a coordinate or parameter of SPEC is in OTHER."
)
@click.option("--certificate", metavar="FILE", help="Write the certificate to FILE (`-`: stdout, alone).")
@click.option("--check-certificate", "old", metavar="FILE", help="Check a certificate that was written before.")
@click.option("--force", is_flag=True, help="Replace the file after `--certificate` when it exists.")
@json_option
def command(
    spec: str,
    other: str,
    maps: tuple[str, ...],
    certificate: str | None,
    old: str | None,
    force: bool,
    as_json: bool,
) -> int:
    """Show that all formulations of a spec agree, or that two specs do.

    Solves every formulation that applies to SPEC at random points of a prime field and compares accelerations and reactions
    exactly with Lagrange's equations with multipliers; then measures how far tempting wrong derivations are off.  The exit
    code is 1 when the formulations disagree or a certificate does not hold.

    With OTHER, whether both specs allow the same velocities and give the same accelerations.  Coordinates and parameters
    are the same by name, or by `--map`.  The exit code is 1 when the specs differ.
    """
    if other:
        if old is not None or certificate is not None:
            raise click.UsageError("certificates are for one spec: leave `OTHER` out")
        if spec == other == "-":
            raise click.UsageError("one of two specs can come from stdin, not both")
        return _compare_two(spec, other, maps, as_json)
    if maps:
        raise click.UsageError("`--map` says what something is in a second spec: name that, too")
    if old is not None and (certificate is not None or as_json):
        raise click.UsageError("`--check-certificate` excludes `--certificate` and `--json`")
    if as_json and certificate == "-":
        raise click.UsageError("`--json` and `--certificate -` cannot both go to stdout")
    if certificate not in (None, "-"):
        check_place(certificate)
    source = open_spec(spec)
    from nhc import pipeline
    from nhc.mechanics.certificates.file import is_sound, to_data, write

    if old is not None:
        return _check(pipeline.check_certificate(source, _read(old)), old)
    try:
        made, emitted = pipeline.compare(source, Parts().show)
    finally:
        show_line("")
    if as_json:
        data = {**to_data(made, source.text), "emitted": emitted}
        put_json("nhc.compare/1", {key: data[key] for key in data if key not in ("schema", "nhc")})
    elif certificate != "-":
        _print(made, emitted)
    if certificate is not None:
        deliver(write(made, source.text), certificate, force=force)
    kept = all(False not in functions.values() for functions in emitted.values())
    return Exit.DONE if is_sound(made) and kept else Exit.FAILED


def _compare_two(spec: str, other: str, maps: tuple[str, ...], as_json: bool) -> int:
    sources = open_spec(spec), open_spec(other)
    from nhc.cli.compare_specs import print_comparison, to_data
    from nhc.mechanics.pairs.verdict import compare_specs

    first, second = ("stdin" if name == "-" else name for name in (spec, other))
    names = ("the first", "the second") if first == second else (first, second)
    made = compare_specs(*sources, maps, names)
    if as_json:
        put_json("nhc.compare-specs/1", to_data(made))
    else:
        print_comparison(made)
    return Exit.DONE if made.agrees else Exit.FAILED


def _read(path: str) -> str:
    content = read_bounded(path, LARGEST_CERTIFICATE, ["name a file that `nhc compare` wrote"])
    return content.decode(errors="replace")


def _check(wrong: list[str], path: str) -> int:
    if not wrong:
        put_text(f"{path}: holds")
        return Exit.DONE
    put_text(f"{path}: does not hold")
    for line in wrong:
        say(f"  {line}")
    return Exit.FAILED


def _print(made: Certificate, emitted: dict[str, Kept]) -> None:
    from nhc.mechanics.certificates.file import power_of_ten

    names = len(made.agreements)
    verdict = f"{names} formulations agree" if made.holds else "the formulations disagree"
    put_text(f"{made.system}: {verdict}{_where(made)}")
    width = max(len(a.name) for a in made.agreements)
    for a in made.agreements:
        exact = [
            f"{what} {'equal' if same else 'DIFFERENT'}"
            for what, same in (("accelerations", a.accelerations), ("reactions", a.reactions))
        ]
        far = power_of_ten(max(a.distance.accelerations, a.distance.reactions))
        doubles = f"in doubles within {far} at {a.distance.states} states"
        if not a.distance.states:
            doubles = "not tried in doubles: singular at every state that was looked at"
        put_text(f"  {a.name:{width}}  {a.number:6}  {', '.join(exact)}; {doubles}")
    put_text(f"exact: {len(made.points)} points modulo primes of 61 bits against I.4.1 straight from T;")
    put_text(f"  a difference passes unseen with a probability below {_bound(made)} ({_why(made)})")
    for line in _emitted(emitted):
        put_text(line)
    if made.rejections:
        put_text("wrong derivations, and how far their accelerations are from the truth (relative):")
    width = max((len(r.name) for r in made.rejections), default=0)
    for r in made.rejections:
        put_text(f"  {r.name:{width}}  {_fate(r, made.is_far(r))}")


def _emitted(emitted: dict[str, Kept]) -> list[str]:
    """Whether emitted code does what the equations say."""
    from nhc.program.validation import UNDECIDED

    held = [name for name, functions in emitted.items() if set(functions.values()) == {True}]
    names = dict.fromkeys(function for name in held for function in emitted[name])
    lines = [f"emitted code does exactly what these equations say ({', '.join(held)}):", f"  {', '.join(names)}"]
    lines = lines if held else []
    for name, functions in emitted.items():
        broken = [function for function, holds in functions.items() if holds is False]
        if broken:
            lines.append(
                f"emitted code: {', '.join(broken)} of {name} do NOT give what its equations say, which is an error of nhc;"
                " use another formulation"
            )
        unknown = [function for function, holds in functions.items() if holds is None]
        if unknown:
            lines.append(f"emitted code: not decided for {', '.join(unknown)} of {name}: {UNDECIDED}")
    return lines


def _bound(made: Certificate) -> str:
    return f"10^{ceil(made.log10_bound)}" if made.log10_bound <= -1.0 else f"{ceil(100 * 10**made.log10_bound) / 100:g}"


def _where(made: Certificate) -> str:
    if made.is_sure or not made.holds:
        return ", for all values of the parameters"
    return f" at {len(made.points)} points; elsewhere they need not, with so many signs or roots"


def _why(made: Certificate) -> str:
    if not made.signed:
        return f"degree {made.degree:.3g} or less"
    return f"signs occur: {2**made.signs - 1}/{2**made.signs} at each point"


def _fate(r: Rejection, far: bool) -> str:
    number = f" (erratum {r.erratum})" if r.erratum else ""
    if r.told_apart is None:
        return f"determines no motion: {r.about}{number}"
    if not r.told_apart:
        return f"this system cannot tell it apart: {r.about}{number}"
    if not far:  # other values of the parameters show it, or states where its frame exists
        return f"wrong, but not seen in doubles at {r.distance.states} states: {r.about}{number}"
    return f"{r.distance.accelerations:.2g} off: {r.about}{number}"
