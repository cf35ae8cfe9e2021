"""What ``nhc compare`` says of two specs: whether they describe the same motion, and where they do not."""

from __future__ import annotations

from math import ceil
from typing import TYPE_CHECKING, Any

from nhc.cli.terminal import put_text

if TYPE_CHECKING:
    from nhc.mechanics.pairs.verdict import Comparison

_SEEN = 1e-12  # a smaller difference is rounding


def print_comparison(made: Comparison) -> None:
    """Text for a person: the verdict, each acceleration, then what was compared how."""
    put_text(f"{made.names[0]} and {made.names[1]}: {_verdict(made)}")
    for line in (
        *_velocities(made),
        *_accelerations(made),
        *_clue(made),
        *_left_out(made),
        *made.notes,
        *_exactness(made),
    ):
        put_text(f"  {line}")


def to_data(made: Comparison) -> dict[str, Any]:
    """The same as data."""
    from nhc.mechanics.certificates.file import power_of_ten

    pairing, found = made.pairing, made.found
    return {
        "specs": list(made.names),
        "systems": [pairing.first.name, pairing.second.name],
        "agree": made.agrees,
        "open": made.is_open,
        "coordinates": [pairing.first.q_names[i] for i in pairing.common],
        "left_out": [list(names) for names in _alone(made)],
        "values_of_one_spec": [list(values) for values in pairing.fixed],
        "velocities": {
            "equal": found.same_velocities,
            "free": list(found.freedom),
            "broken": [list(names) for names in found.violated],
        },
        "positions": {"free": list(found.places), "broken": list(found.off)},
        "accelerations": [
            {"name": name, "equal": equal, "difference": power_of_ten(off) if equal else f"{off:.1e}"}
            for name, equal, off in zip(_rates(made), found.equal, _differences(made), strict=False)
        ],
        "most_different": None if made.agrees else _worst_data(made),
        "equal_without_forces": None if made.bare is None else made.bare.agrees,
        "decided_at_states": made.by_states or made.fitting > 0,
        "states": made.measured.states,
        "points": len(found.primes),
        "log10_bound": ceil(made.log10_bound),
        "notes": list(made.notes),
    }


def _worst_data(made: Comparison) -> dict[str, Any] | None:
    worst = made.measured.worst
    if worst is None:
        return None
    pairs = zip(_rates(made), worst.first, worst.second, strict=True)
    return {"at": worst.state, "state": dict(worst.values), "accelerations": {name: [x, y] for name, x, y in pairs}}


# --- the lines ----------------------------------------------------------------------------------------------


def _verdict(made: Comparison) -> str:
    found, names = made.found, _rates(made)
    if made.agrees and (made.by_states or made.fitting):
        return f"the same motion, as far as double precision tells at {_count(made.fitting or made.measured.states, 'state')}"
    if made.agrees:
        what = "the same motion" if not any(_alone(made)) else f"the same motion of {_list(made)}"
        if made.is_sure:
            return f"{what}, {_for_which(made)}"
        return f"{what} at {len(found.primes)} points; elsewhere it need not be, with so many signs or roots"
    if not found.same_velocities:
        return "they DIFFER in the velocities that the constraints allow"
    if not found.same_places:
        return "they DIFFER in the positions that they allow"
    if made.is_open:
        return "not shown to be the same: exact arithmetic tells them apart, double precision does not"
    if not all(found.equal):
        return f"they DIFFER in {_join([x for x, same in zip(names, found.equal, strict=True) if not same])}"
    return "exactly the same, but double precision differs"


def _for_which(made: Comparison) -> str:
    """For which values of the parameters."""
    if not any(made.pairing.fixed):
        return "for all values of the parameters"
    return (
        "for all values of the parameters that both have" if made.pairing.parameters else "for the parameters' values"
    )


def _velocities(made: Comparison) -> list[str]:
    found, (first, second) = made.found, made.names
    lines = []
    if found.same_velocities:
        lines.append(f"velocities: both allow the same, {_count(found.freedom[0], 'free one')}")
    for broken, own, other in ((found.violated[0], first, second), (found.violated[1], second, first)):
        if broken:
            lines.append(f"velocities: {other} allows some that break {_quoted(broken)} of {own}")
    if found.freedom[0] != found.freedom[1]:
        lines.append(f"velocities: {found.freedom[0]} of them are free in {first}, {found.freedom[1]} in {second}")
    if made.fitting:
        lines.append(f"positions: those of {second} are on the equations of {first}, in doubles at {made.fitting}")
    if found.off and found.same_places:
        lines.append(f"positions: {_quoted(found.off)} of {first} chooses among those that {second} can start from")
    elif found.off:
        lines.append(f"positions: those of {second} break {_quoted(found.off)} of {first}")
    elif found.places[0] > found.places[1]:
        lines.append(f"positions: {first} can start from more of them than {second}")
    return lines


def _accelerations(made: Comparison) -> list[str]:
    from nhc.mechanics.certificates.file import power_of_ten

    names, worst, states = _rates(made), made.measured.worst, _count(made.measured.states, "state")
    width, lines = max(len(name) for name in names), []
    for k, (name, equal, off) in enumerate(zip(names, made.found.equal, _differences(made), strict=False)):
        word = (
            "equal" if equal else "equal at the states" if made.by_states else "open" if made.is_open else "DIFFERENT"
        )
        if worst is None:
            far = "not tried in doubles: no state was found with a motion in both"
        elif equal or made.by_states or made.is_open:
            far = f"in doubles within {power_of_ten(off)} at {states}"
        elif off <= _SEEN:
            far = f"but not seen in doubles at {states}"
        elif abs(worst.first[k] - worst.second[k]) <= _SEEN * max(1.0, abs(worst.first[k])):
            far = f"by {off:.2g} at another state (relative)"
        else:
            x, y = _tell_apart(worst.first[k], worst.second[k])
            far = f"{x} in {made.names[0]}, {y} in {made.names[1]}"
        lines.append(f"{name:{width}}  {word}; {far}")
    if worst is not None and not made.agrees and made.largest > _SEEN:
        shown = ", ".join(f"{name} = {value:.6g}" for name, value in worst.values)
        lines.append(f"this is where they differ most, {worst.state}: {shown}")
    return lines


def _tell_apart(x: float, y: float) -> tuple[str, str]:
    """Both with as many digits as it takes to see that they differ, six at least."""
    digits = next((n for n in range(6, 17) if f"{x:.{n}g}" != f"{y:.{n}g}"), 17)
    return f"{x:.{digits}g}", f"{y:.{digits}g}"


def _rates(made: Comparison) -> list[str]:
    return [f"{made.pairing.first.q_names[i]}''" for i in made.pairing.common]


def _differences(made: Comparison) -> tuple[float, ...]:
    return made.measured.differences or (0.0,) * len(made.found.equal)


def _clue(made: Comparison) -> list[str]:
    """Where to look."""
    lines = []
    if made.is_open:
        lines.append(
            "either they differ by very little, or by an identity that nhc does not know, as log(x*y) = log(x) + log(y)"
        )
    elif not made.by_states and made.bare is not None and made.bare.agrees:
        lines.append("without potential and forces they agree: look at `U`, `V` and `forces`")
    elif not made.by_states and made.bare is not None:
        where = "`T`" if made.pairing.is_plain else "`T`, and at what `--map` says"
        lines.append(f"without potential and forces they differ too: look at {where}")
    if not made.agrees:
        for names, spec in zip(made.suspects, made.names, strict=True):
            if names:
                lines.append(f"{_quoted(names)}, which only {spec} has, may act on the others")
    return lines


def _left_out(made: Comparison) -> list[str]:
    lines = []
    for names, values, spec in zip(_alone(made), made.pairing.fixed, made.names, strict=True):
        if names:
            lines.append(f"left out: {_quoted(names)}, which only {spec} has, at any value")
        if values:
            lines.append(f"parameters that only {spec} has, at their values there: {', '.join(values)}")
    if made.pairing.open_parameters:
        lines.append(
            f"parameters that only one spec has, and without a value, at any: {_quoted(made.pairing.open_parameters)}"
        )
    return lines


def _exactness(made: Comparison) -> list[str]:
    bound = made.log10_bound
    small = f"10^{ceil(bound)}" if bound <= -1.0 else f"{ceil(100 * 10**bound) / 100:g}"
    lines = [f"exact: {_count(len(made.found.primes), 'point')} modulo primes of 61 bits"]
    if any(made.found.equal):  # what is found to differ does
        lines[0] += f"; a difference passes unseen with a probability below {small}"
    if not made.on_leaf:
        lines.append("  at all levels of the equations under `holonomic:`, not only where they are zero")
    return [*lines, "not compared: reactions, energies, outputs, scenes"]


def _alone(made: Comparison) -> tuple[list[str], list[str]]:
    pairing = made.pairing
    used = [pairing.first.q_names[i] for i in pairing.alone[0]]
    return used, [pairing.second.q_names[j] for j in pairing.alone[1]]


def _list(made: Comparison) -> str:
    return _join([made.pairing.first.q_names[i] for i in made.pairing.common])


def _join(names: list[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _quoted(names: tuple[str, ...] | list[str]) -> str:
    return _join([f"`{name}`" for name in names])


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
