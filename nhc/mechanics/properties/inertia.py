"""Can a rigid body have the inertia that a spec gives?  If not, a sign or a number is wrong, and the spec is warned of."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.dense import symmetric_eigenvalues
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, Span
from nhc.language.expressions.parser import parse_expression
from nhc.language.scope import names_in
from nhc.language.spec import Body
from nhc.mechanics.resolving.expressions import Resolver, define_names
from nhc.mechanics.system import System
from nhc.mechanics.values import scene_values

_ENTRIES = ("xx", "yy", "zz", "yz", "xz", "xy")
_ROUNDING = 1e-9  # of the trace: a rod and a disc stand on the edge


def warn_of_inertia(system: System, bag: Bag) -> None:
    """Add a warning (W0427) for each body whose principal moments, for the parameters' values in the spec or in a scene, are such
    that one is more than the two others together, or negative.

    They are sums of m (y^2 + z^2), m (z^2 + x^2) and m (x^2 + y^2).  A moment of zero says that its part is neglected, and of
    such a body nothing is said; nor of what depends on the state, nor of bodies that turn about one axis, where one moment counts.
    """
    every = {body.name: body for body in system.spec.bodies}
    bodies = [body for body in every.values() if len(body.inertia) > 1 and _turns_in_space(body, every)]
    if not bodies:
        return
    build = Resolver(system.spec, system.graph)
    define_names(build)
    for body in bodies:
        nodes = _entries(build, body)
        if nodes is None:
            continue
        for values, where in _given(system, nodes):
            try:
                what = _fault(body, [float(x) for x in evaluate(system.graph, nodes, values)])
            except (ArithmeticError, ValueError):
                continue  # said of the scene itself
            if what:
                _warn(body, f"{what}{where}", bag)
                break


def _turns_in_space(body: Body, every: Mapping[str, Body]) -> bool:
    """Whether it turns about more than one axis, with the bodies that it stands on."""
    axes, own = set[str](), body
    while True:
        axes.update(axis for axis, _ in own.turns)
        if own.rotation or len(axes) > 1:
            return True
        if own.on not in every:
            return False
        own = every[own.on]


def _entries(build: Resolver, body: Body) -> list[Node] | None:
    """xx, yy, zz, yz, xz, xy of a body; None where they are not made of parameters."""
    g, said = build.graph, dict(body.inertia)
    if "" in said:
        said.update(dict.fromkeys(_ENTRIES[:3], said.pop("")))
    nodes = []
    for key in _ENTRIES:
        tree = parse_expression(said.get(key, "0"), _nowhere, build.bag)
        if tree is None or not set(names_in(tree)) <= build.names.keys():
            return None
        nodes.append(build.node(tree))
    state = g.mask((build.t, *build.q, *build.v))
    return None if any(g.depends(node, state) for node in nodes) else nodes


def _nowhere(start: int, end: int) -> Span:
    """Expressions are read a second time here: what is wrong with one was said the first time."""
    return Span(start, end)


def _given(system: System, nodes: Sequence[Node]) -> list[tuple[dict[Node, float], str]]:
    """The values of the parameters and whose they are, without those for which a parameter of these nodes has no value."""
    g, (own, *others) = system.graph, scene_values(system)
    pairs = zip(system.p, system.spec.parameters, strict=True)
    lacking = [p for p, said in pairs if said.value is None and any(g.depends(node, g.deps[p]) for node in nodes)]
    scenes = [(values, ", for the values of a scene") for values in others]
    return scenes if lacking else [(own, ""), *scenes]


def _fault(body: Body, entries: Sequence[float]) -> str:
    """What no body can have; empty where all is well, or a part is neglected."""
    xx, yy, zz, yz, xz, xy = entries
    if not xx or not yy or not zz:
        return ""
    least, middle, most = sorted(symmetric_eigenvalues([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
    edge = _ROUNDING * (abs(least) + abs(middle) + abs(most))
    if not most > least + middle + edge and not least < -edge:
        return ""
    principal = not yz and not xz and not xy
    if least < -edge:
        name = f"`{_ENTRIES[[xx, yy, zz].index(least)]}`" if principal else "a principal moment of inertia"
        return f"{name} of `{body.name}` is negative: {least:.6g}"
    if principal:
        k = [xx, yy, zz].index(most)
        others = " + ".join(f"`{key}`" for i, key in enumerate(_ENTRIES[:3]) if i != k)
        return f"`{_ENTRIES[k]}` of `{body.name}` is {most:.6g}, more than {others} = {least + middle:.6g}"
    return f"a principal moment of inertia of `{body.name}` is {most:.6g}, more than both others together, {least + middle:.6g}"


def _warn(body: Body, what: str, bag: Bag) -> None:
    bag.warning(
        "W0427",
        what,
        body.place,
        notes=("no rigid body has such an inertia: m (x^2 + y^2) is at most m (y^2 + z^2) + m (z^2 + x^2)",),
        help=(
            "give moments about the centre of mass, on the body's own axes, with `xz` minus the sum of m x z; or 0 for"
            " what is neglected",
        ),
    )
