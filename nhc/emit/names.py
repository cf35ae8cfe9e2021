"""Names of one emitted function: the spec's own wherever the language allows it, made unique where it does not."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.program.ir import Let, Load, Solve, Statement, Sweep


class Scope:
    """A one-to-one map from the IR's names to the language's, with room for the printer's own temporaries."""

    def __init__(self, reserved: Iterable[str], longest: int) -> None:
        self._taken = set(reserved)
        self._longest = longest
        self._numbers: dict[str, int] = {}  # of each prefix the last that was given: none becomes free again
        self.spellings: dict[str, str] = {}  # what each name is in the language

    def bind_all(self, names: Iterable[str]) -> None:
        """Give each name its spelling; names that may stay as they are go first, so that they do stay."""
        awkward = []
        for name in dict.fromkeys(names):
            if name in self._taken or len(name) > self._longest:
                awkward.append(name)
            else:
                self._enter(name, name)
        for name in awkward:
            self._enter(name, self._respell(name))

    def fresh(self, prefix: str) -> str:
        """A name for a temporary: ``prefix`` and the first number that is free."""
        number = self._numbers.get(prefix, 0) + 1
        while f"{prefix}{number}" in self._taken:
            number += 1
        self._numbers[prefix] = number
        name = f"{prefix}{number}"
        self._taken.add(name)
        return name

    def alias(self, name: str, spelling: str) -> None:
        """Spell a bound name as something that exists already."""
        self.spellings[name] = spelling

    def __getitem__(self, name: str) -> str:
        return self.spellings[name]

    def _enter(self, name: str, spelling: str) -> None:
        self.spellings[name] = spelling
        self._taken.add(spelling)

    def _respell(self, name: str) -> str:
        spelling = name
        while spelling in self._taken and len(spelling) < self._longest:
            spelling += "_"
        if spelling not in self._taken and len(spelling) <= self._longest:
            return spelling
        number = 1
        while True:
            tail = f"_{number}"
            spelling = name[: self._longest - len(tail)] + tail
            if spelling not in self._taken:
                return spelling
            number += 1


def list_bound_names(statements: Iterable[Statement]) -> list[str]:
    """The names that the statements bind, in their order."""
    names: list[str] = []
    for statement in statements:
        if isinstance(statement, Load | Let):
            names.append(statement.name)
        elif isinstance(statement, Solve):
            names.extend(name for column in statement.names for name in column)
        elif isinstance(statement, Sweep):
            names += [*statement.seeds, *list_bound_names(statement.body)]
    return names
