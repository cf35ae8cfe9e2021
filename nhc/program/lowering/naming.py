"""Identifiers for the nodes of one function: the spec's names where there are any, else short systematic ones."""

from __future__ import annotations

import re

from nhc.algebra.graph import NUM, SYM, Graph, Node

_SUFFIX = {"velocity": "_dot", "acceleration": "_ddot", "rate": "_dot"}


def identifier(text: str) -> str:
    """The text over [A-Za-z0-9_], not starting with a digit."""
    text = text.replace("'", "_dot")
    text = re.sub(r"[^A-Za-z0-9_]", lambda m: f"u{ord(m.group()):04x}", text)
    return f"_{text}" if text[:1].isdigit() else text


class Namer:
    """Unique names within one function."""

    def __init__(self, graph: Graph, reserved: set[str]) -> None:
        self.graph, self.taken = graph, set(reserved)
        self._counts: dict[str, int] = {}

    def unique(self, wish: str) -> str:
        name, k = wish, 1
        while name in self.taken:
            k += 1
            name = f"{wish}_{k}"
        self.taken.add(name)
        return name

    def numbered(self, prefix: str) -> str:
        while True:
            self._counts[prefix] = self._counts.get(prefix, 0) + 1
            name = f"{prefix}{self._counts[prefix]}"
            if name not in self.taken:
                self.taken.add(name)
                return name

    def symbol(self, node: Node) -> str:
        symbol = self.graph.symbol_of(node)
        assert symbol is not None
        return self.unique(identifier(symbol.name) + _SUFFIX.get(symbol.kind, ""))

    def node(self, node: Node, constant: bool) -> str:
        """A name for a node that becomes a Let; ``constant`` if it depends on parameters only."""
        label = self.graph.labels.get(node)
        if label is not None:
            return self.unique(identifier(label))
        op = self.graph.op[node]
        if op in ("sin", "cos"):
            inner = self.graph.a[node]
            if self.graph.op[inner] == SYM:
                symbol = self.graph.symbol_of(inner)
                assert symbol is not None
                return self.unique(f"{op[0]}_{identifier(symbol.name)}")
            if inner in self.graph.labels:
                return self.unique(f"{op[0]}_{identifier(self.graph.labels[inner])}")
            return self.numbered(op[0])
        if op == NUM:
            return self.numbered("k")
        return self.numbered("k" if constant else "z")
