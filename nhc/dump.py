"""The text of each stage's result, for ``--dump``."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from nhc import pipeline
from nhc.algebra.show import to_text
from nhc.diagnostics import Bag, Source
from nhc.language import Syntax, decode
from nhc.language.expressions.unparse import unparse
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import read_nodes
from nhc.mechanics.system import System
from nhc.pipeline import Options

_LONGEST = 2000


def dump_read(source: Source, _: Options) -> str:
    """YAML nodes: kind, place and text."""
    bag = Bag(source)
    root = read_nodes(source, bag)
    bag.raise_if_errors()
    lines: list[str] = []
    stack: list[tuple[str, Node | None, int]] = [("", root, 0)]
    while stack:
        key, node, depth = stack.pop()
        if node is None:
            continue
        line, column = source.position(node.span.start)
        text = repr(node.value) if isinstance(node, Text) else "list" if isinstance(node, Items) else "mapping"
        lines.append(f"{'  ' * depth}{key}{text}  @{line}:{column}")
        if isinstance(node, Items):
            stack.extend(("- ", item, depth + 1) for item in reversed(node.items))
        elif isinstance(node, Table):
            stack.extend((f"{name.value}: ", item, depth + 1) for name, item in reversed(node.entries))
    return "\n".join(lines) + "\n"


def dump_decode(source: Source, _: Options) -> str:
    """Declarations and expressions."""
    spec = decode(source)
    lines = [f"system {spec.system}"]
    lines += [f"coordinate {c.name}{f' [{c.unit}]' if c.unit else ''}" for c in spec.coordinates]
    lines += [f"parameter {p.name} = {_value(p.value)}" for p in spec.parameters]
    lines += [f"define {d.name} = {unparse(d.value)}" for d in spec.definitions]
    lines.append(f"T = {unparse(spec.kinetic)}")
    if spec.potential is not None:
        lines.append(f"{spec.potential_kind} = {unparse(spec.potential)}")
    lines += [f"force {d.name} = {unparse(d.value)}" for d in spec.forces]
    lines += [f"constraint {c.name}: {unparse(c.left)} = {unparse(c.right)}" for c in spec.constraints]
    lines += [f"holonomic {c.name}: {unparse(c.left)} = {unparse(c.right)}" for c in spec.holonomic]
    lines += [f"quasi-velocity {d.name} = {unparse(d.value)}" for d in spec.quasi_velocities]
    lines += [f"output {d.name} = {unparse(d.value)}" for d in spec.outputs]
    lines += [f"draw {f.kind} {', '.join(unparse(tree) for tree in f.expressions)}" for f in spec.draw]
    lines += [f"scene {s.name}: t in [{s.time[0]}, {s.time[1]}]" for s in spec.scenes]
    return "\n".join(lines) + "\n"


def _value(value: Fraction | Syntax | None) -> str:
    if value is None:
        return "?"
    return str(value) if isinstance(value, Fraction) else unparse(value)


def dump_resolve(source: Source, options: Options) -> str:
    """T, U, Q and the constraint rows."""
    return _system(pipeline.model(source, options).system)


def _system(system: System) -> str:
    g = system.graph

    def text(node: int) -> str:
        return to_text(g, node, _LONGEST)

    lines = [f"system {system.name}: n = {system.n}, l = {system.l}, {len(g)} nodes"]
    lines += [f"T = {text(system.T)}", f"U = {text(system.U)}"]
    lines += [f"Q[{system.q_names[i]}] = {text(q)}" for i, q in enumerate(system.Q) if q != g.zero]
    for form in (*system.constraints, *system.quasi):
        terms = [f"({text(a)})*{system.q_names[i]}'" for i, a in enumerate(form.coefficients) if a != g.zero]
        if form.constant != g.zero:
            terms.append(f"({text(form.constant)})")
        lines.append(f"{form.name}: {' + '.join(terms) or '0'}{' = 0' if form in system.constraints else ''}")
    return "\n".join(lines) + "\n"


def dump_choose(source: Source, options: Options) -> str:
    """The formulation and its frame."""
    made = pipeline.model(source, options)
    formulation, system = made.formulation, made.system
    g = system.graph
    lines = [f"formulation {formulation.name} ({formulation.number}): {formulation.reason}"]
    lines += [f"broken hypothesis: {text}" for text in formulation.broken]
    if formulation.dependent is not None:
        names = ", ".join(system.q_names[i] for i in formulation.dependent.dependent)
        determinant = formulation.dependent.determinant
        lines.append(f"dependent: {names}")
        lines.append(f"determinant: {'(large)' if determinant is None else to_text(g, determinant, _LONGEST)}")
    for name, node in zip(system.q_names, made.equations.motion.velocities, strict=True):
        lines.append(f"{name}' = {to_text(g, node, _LONGEST)}")
    return "\n".join(lines) + "\n"


def dump_form(source: Source, options: Options) -> str:
    """Omega in its coframe."""
    from nhc.emit import text

    return text.print_form(pipeline.derivation(source, options))


def dump_associate(source: Source, options: Options) -> str:
    """The associated system."""
    from nhc.emit import text

    return text.print_equations(pipeline.derivation(source, options))


def dump_lower(source: Source, options: Options) -> str:
    """The program's text form."""
    from nhc.emit import text

    return text.print_program(pipeline.program(source, options))


def dump_render(source: Source, options: Options) -> str:
    """Names and sizes of the emitted files."""
    lines = []
    for language in ("c", "python", "latex"):
        for name, text in pipeline.emit(source, language, options).items():
            lines.append(f"{language:7} {name:32} {len(text.splitlines()):6} lines {len(text.encode()):8} bytes")
    return "\n".join(lines) + "\n"


DUMPS: dict[str, Callable[[Source, Options], str]] = {
    "read": dump_read,
    "decode": dump_decode,
    "resolve": dump_resolve,
    "choose": dump_choose,
    "form": dump_form,
    "associate": dump_associate,
    "lower": dump_lower,
    "render": dump_render,
}
