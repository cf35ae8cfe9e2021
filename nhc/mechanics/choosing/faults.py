"""Why quasi-velocities are no basis together with the constraints: which of them is one too many, and for what reason."""

from __future__ import annotations

from nhc.algebra.exact.modular import rank
from nhc.diagnostics import quote, several
from nhc.mechanics.system import Form, System


def list_faults(system: System) -> list[str]:
    """One sentence for each fault of the spec's quasi-velocities, in their order; that they are too many comes last."""
    given = [form for form in system.quasi if form.name not in system.angular]
    found: list[str] = []
    basis: list[Form] = []
    for form in given:
        if not form.coefficients or all(x == system.graph.zero for x in form.coefficients):
            found.append(f"`{form.name}` contains no velocity")
        elif _is_new(system, [*system.constraints, *basis], form):
            basis.append(form)
        else:
            found.append(f"`{form.name}` follows from {_sources(system, basis, form)}")
    free = system.n - system.l
    if len(given) > free:
        held = f"the {several(system.l, 'constraint')} leave" if system.l > 1 else "the constraint leaves"
        room = f"{held} {free} of the {system.n} velocities free" if system.l else f"there are {system.n} velocities"
        found.append(f"{room}, and {len(given)} quasi-velocities are given")
    return found


def _is_new(system: System, others: list[Form], form: Form) -> bool:
    rows = [list(other.coefficients) for other in (*others, form)]
    return rank(system.graph, rows) > rank(system.graph, rows[:-1])


def _sources(system: System, basis: list[Form], form: Form) -> str:
    """The constraints and the quasi-velocities before it of which its terms in the velocities are a combination."""
    forms = [*system.constraints, *basis]
    for other in tuple(forms):  # what it follows without is no source
        rest = [one for one in forms if one is not other]
        if not _is_new(system, rest, form):
            forms = rest
    held = [other.name for other in system.constraints if other in forms]
    words = [f"the constraint{'s' if len(held) > 1 else ''} {quote(held)}"] if held else []
    own = [other.name for other in basis if other in forms]
    return " and ".join([*words, *([quote(own)] if own else [])])
