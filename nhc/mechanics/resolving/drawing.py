"""What a spec draws, as nodes beside the system; nothing that is derived or emitted depends on it."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Graph, Node
from nhc.language.spec import Figure, Place
from nhc.mechanics.resolving.expressions import Resolver, define_names
from nhc.mechanics.system import System
from nhc.records import record


@record
class Outline:
    """A shape; ``places`` index the sketch's nodes.

    Three nodes for each point of a point, line or body (whose corners are in the fixed axes by now); of a circle three
    of the centre, the radius, three of the normal.
    """

    kind: str
    name: str
    trace: bool
    places: tuple[int, ...]


@record
class Sketch:
    """All shapes, and each node of them once; ``spatial``: one of them leaves the plane z = 0."""

    outlines: tuple[Outline, ...] = ()
    nodes: tuple[Node, ...] = ()
    spatial: bool = False


def sketch_of(system: System) -> Sketch:
    """The shapes of the spec's ``draw`` over the system's own graph, to which their nodes are added.

    Raises:
        nhc.diagnostics.SpecError: one of them cannot be computed (as ``nhc check`` says, too).
    """
    if not system.spec.draw:
        return Sketch()
    build = Resolver(system.spec, system.graph)
    define_names(build)
    drawn = [_nodes(build, figure) for figure in system.spec.draw]
    build.bag.raise_if_errors()
    numbers: dict[Node, int] = {}
    for nodes in drawn:
        for node in nodes:
            numbers.setdefault(node, len(numbers))
    outlines = tuple(
        Outline(figure.kind, figure.name, figure.trace, tuple(numbers[node] for node in nodes))
        for figure, nodes in zip(system.spec.draw, drawn, strict=True)
    )
    return Sketch(outlines, tuple(numbers), any(figure.spatial for figure in system.spec.draw))


def _nodes(build: Resolver, figure: Figure) -> list[Node]:
    g = build.graph
    points = [_place(build, point) for point in figure.points]
    if figure.kind == "circle":
        assert figure.radius is not None
        normal = _place(build, figure.normal) if figure.normal else [g.zero, g.zero, g.one]
        return [*points[0], build.node(figure.radius), *normal]
    if figure.kind == "body":
        assert figure.angle is not None
        points = _turn(g, points, build.node(figure.angle), _place(build, figure.at))
    return [node for point in points for node in point]


def _place(build: Resolver, place: Place) -> list[Node]:
    """Three nodes; what is given in the plane is at z = 0."""
    nodes = [build.node(tree) for tree in place]
    return [*nodes, *[build.graph.zero] * (3 - len(nodes))]


def _turn(g: Graph, points: Sequence[list[Node]], angle: Node, at: Sequence[Node]) -> list[list[Node]]:
    """Corners on a body's axes, in the fixed ones."""
    c, s = g.function("cos", angle), g.function("sin", angle)
    turned = []
    for x, y, z in points:
        across = g.sub(g.mul(x, c), g.mul(y, s))
        along = g.add(g.mul(x, s), g.mul(y, c))
        turned.append([g.add(at[0], across), g.add(at[1], along), z])
    return turned
