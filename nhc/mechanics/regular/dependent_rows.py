"""Constraints that follow from others, or contradict them."""

from __future__ import annotations

import random
from collections.abc import Sequence
from collections.abc import Set as AbstractSet

from nhc.algebra.calculus import gradient
from nhc.algebra.evaluate import Mpmath, evaluate
from nhc.algebra.exact.modular import are_zero, is_zero, rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.linear import is_clearly_regular
from nhc.diagnostics import Bag, quote, several
from nhc.language import Spec
from nhc.mechanics.regular.given_rank import find_dependent_as_given
from nhc.mechanics.system import Form, System

_DRAWS, _POINTS, _DIGITS = 60, 3, 1e-30


def check_rank(bag: Bag, spec: Spec, system: System) -> None:
    """Dependent constraints and contradictory ones, row by row."""
    g = system.graph
    if all(form.value is not None for form in system.constraints) and _is_clear(system):
        return
    kept: list[Form] = []
    spans = [c.span for c in spec.constraints] + [h.span for h in spec.holonomic]
    norms = {f"{rotation.name}_norm" for rotation in spec.rotations}
    rows = sorted(zip(system.constraints, spans, strict=True), key=lambda row: row[0].name not in norms)
    for form, span in rows:  # what a rotation brings comes first: what repeats it is the user's
        linear = [list(f.coefficients) for f in (*kept, form)]
        if _are_independent(g, linear):
            kept.append(form)
            continue
        full = [[*f.coefficients, f.constant] for f in (*kept, form)]
        empty = all(are_zero(g, form.coefficients))
        if _are_independent(g, full) or _is_apart(g, system, form, kept):
            bag.error(
                "E0403",
                f"the constraint `{form.name}` " + ("cannot hold" if empty else "contradicts those before it"),
                span,
                notes=("no velocity is left in it",) if empty else (),
                help=(_advise(system, form, empty),),
            )
        else:
            bag.error(
                "E0402",
                f"the constraint `{form.name}` " + ("restricts nothing" if empty else "follows from those before it"),
                span,
                notes=(
                    "no velocity is left in it"
                    if empty
                    else f"{_tell_sources(g, form, kept, norms)}, so the reactions would not be unique",
                ),
                help=(_advise_repeated(form, kept, empty),),
            )


def _are_independent(g: Graph, matrix: Sequence[Sequence[Node]]) -> bool:
    return rank(g, matrix) == len(matrix) and not loses_rank(g, matrix)


def _tell_sources(g: Graph, form: Form, kept: Sequence[Form], norms: AbstractSet[str]) -> str:
    """Of which rows a dependent one is made: those without which it is independent of the rest."""
    sources = list(kept)
    for other in kept:
        fewer = [one for one in sources if one is not other]
        if fewer and not _are_independent(g, [list(f.coefficients) for f in (*fewer, form)]):
            sources = fewer
    names = [f.name for f in sources if f.name not in norms]
    if not names:
        return f"it says what the rotation `{sources[0].name.removesuffix('_norm')}` says by itself"
    if len(names) == 1:
        return f"it is `{names[0]}` times a factor"
    return f"it is a combination of {quote(names[:-1])} and {quote(names[-1:])}"


def _advise_repeated(form: Form, kept: Sequence[Form], empty: bool) -> str:
    """What to do with a row that says nothing new; an equation of positions says more than its rate."""
    if not empty and form.equation is not None and any(other.equation is None for other in kept):
        return "remove what says the same under `constraints:`, for this holds positions too; or remove it"
    return "remove it"


def _is_clear(system: System) -> bool:
    """Whether the constraints are certainly independent; with the quasi-velocities first, where these should make a basis."""
    rows = [form.value for form in (*system.constraints, *system.quasi) if form.value is not None]
    if system.constraints and len(rows) == system.n > system.l and is_clearly_regular(system.graph, rows, system.v):
        return True
    return is_clearly_regular(system.graph, rows[: system.l], system.v)


def check_freedom(bag: Bag, spec: Spec, system: System) -> None:
    """As many constraints as coordinates leave nothing to derive; where positions fit, some of them may say the same."""
    if system.l < system.n:
        return
    form, held = find_dependent_as_given(system) if spec.holonomic else (None, False)
    span = spec.constraint_spans.get(form.name) if form and held else None
    if form is not None and span is not None:
        bag.error(
            "E0402",
            f"the constraint `{form.name}` follows from the others where the equations under `holonomic:` hold",
            span,
            notes=("at other positions the constraints leave no free velocity, so nothing can be derived with it",),
            help=("remove it",),
        )
        return
    leave = "leaves" if system.l == 1 else "leave"
    bag.error(
        "E0420",
        f"{several(system.l, 'constraint')} on {several(system.n, 'coordinate')} {leave} no velocity free",
        spec.key_span("constraints" if spec.constraints else "holonomic"),
        help=("remove a constraint, or declare the coordinate that is missing",),
    )


def loses_rank(g: Graph, matrix: Sequence[Sequence[Node]]) -> bool:
    """Whether the rows are dependent to 30 of 50 digits at three real points, by identities that no field knows (of logarithms).

    False where no such points were found.
    """
    import mpmath

    flat = [entry for row in matrix for entry in row]
    symbols = sorted({symbol for entry in flat for symbol in g.symbols_in(entry)})
    seen = 0
    with mpmath.workdps(50):
        for draw in range(_DRAWS):
            rng = random.Random(draw)
            place = {symbol: mpmath.mpf(rng.randrange(1, 10**6)) / 400_000 for symbol in symbols}
            try:
                values = iter(evaluate(g, flat, place, Mpmath()))
            except (ArithmeticError, ValueError, TypeError, AttributeError):
                continue
            rows = [[next(values) for _ in row] for row in matrix]
            if not all(mpmath.im(x) == 0 and mpmath.isfinite(x) for row in rows for x in row):
                continue
            sizes = [max(map(abs, row)) or 1 for row in rows]
            scaled = mpmath.matrix([[mpmath.re(x) / size for x in row] for row, size in zip(rows, sizes, strict=True)])
            if min(mpmath.svd_r(scaled, compute_uv=False)) > _DIGITS:
                return False
            seen += 1
            if seen == _POINTS:
                return True
    return False


def _advise(system: System, form: Form, empty: bool) -> str:
    """What to do with a row whose terms in the velocities vanish, or follow from others, and whose free term does not."""
    g = system.graph
    if empty and form.equation is not None:
        return "remove it, or correct its terms: no coordinate is left in it, so no motion can change it"
    if form.equation is None and any(g.depends(form.constant, g.deps[x]) for x in system.q):
        return (
            "a relation between positions belongs under `holonomic:`"
            if empty
            else "remove it, or correct its terms: together they leave no velocity, and a relation of positions"
        )
    asked = "it asks" if empty else "together they ask"
    free = any(g.deps[row.constant] for row in system.constraints)
    what = "a relation of parameters or the time alone" if free else "`0 = 1`"
    return f"remove it, or correct its terms: {asked} for {what}"


def _is_apart(g: Graph, system: System, form: Form, before: Sequence[Form]) -> bool:
    """Whether an equation of positions differs from a multiple of one before it, or from zero, by a constant."""
    moving = (*system.q, system.t)
    for other in (g.zero, *(f.equation for f in before)):
        if form.equation is None or other is None:
            continue
        slopes, own = gradient(g, other, moving), gradient(g, form.equation, moving)
        ratio = next((g.div(a, b) for a, b in zip(own, slopes, strict=True) if b != g.zero), g.zero)
        rest = g.sub(form.equation, g.mul(ratio, other))
        if all(are_zero(g, gradient(g, rest, moving))) and not is_zero(g, rest):
            return True
    return False
