r"""One spelling for each name of a document.

``x1`` and ``x_1`` would both be set as x with index 1, ``A`` and ``Alpha`` both as a capital A.  The shortest such name is set
as it would be alone, the others in typewriter with their underscores; so is what would look like a differential.  A name that
would fill a line gets a number in place of its end.  What is set in another way is listed, so that a reader finds the name of the
spec back.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from nhc.emit.latex.spelling import escape_exactly, spell_base, spell_index, spell_part, spell_word
from nhc.emit.latex.width import estimate
from nhc.language.expressions.names import FUNCTIONS
from nhc.program.sheets.model import Derivation, Item, Mark, Statement, Table

WIDEST = 170.0
"""Points that a name may fill: two of them, as in a wedge of differentials, fit a line."""

_KEPT = 12  # letters of a name that is too wide
_DOTS = ("", r"\dot", r"\ddot", r"\dddot")
_WORDS = tuple(f"{dot}{{{word}" if dot else word for dot in _DOTS for word in (r"\mathit{", r"\mathrm{"))
_Spelled = tuple[str, tuple[str, ...]]


class Names:
    """How the names of one document are set: as :mod:`spelling` has them but for ``changed``; ``listed`` are to be explained."""

    def __init__(
        self, changed: Mapping[str, _Spelled], names: tuple[str, ...] = (), listed: tuple[str, ...] = ()
    ) -> None:
        self.changed, self.names, self.listed = changed, names, listed
        self._printed: dict[Mark, str] = {}

    def print_mark(self, mark: Mark) -> str:
        r"""``\ddot{\theta}``, ``dx``, ``\gamma^{slip}_{v,w}``."""
        text = self._printed.get(mark)
        if text is None:
            text = self._printed[mark] = self._print(mark)
        return text

    def print_index(self, name: str) -> str:
        """A name as it stands below or above a letter."""
        return self._index(name)

    def _print(self, mark: Mark) -> str:
        base, own = self._base(mark.base)
        if mark.dots:
            base = f"{_DOTS[mark.dots]}{{{base}}}"
        index = spell_index if _is_form(mark) else self._index
        lower = ",".join([*own, *(index(x) for x in mark.lower)])
        upper = ",".join([*("*" for _ in range(mark.star)), *(self._index(x) for x in mark.upper)])
        text = base + (f"^{{{upper}}}" if upper else "") + (f"_{{{lower}}}" if lower else "")
        # the d of a differential does not run together with a word
        before = (r"d\," if base.startswith(_WORDS) else "d") if mark.prefix else ""
        return before + text + mark.at

    def _base(self, name: str) -> _Spelled:
        if name in self.changed:
            return self.changed[name]
        base, own = spell_base(name)
        return base, tuple(spell_part(x) for x in own)

    def _index(self, name: str) -> str:
        if name not in self.changed:
            return spell_index(name)
        base, lower = self.changed[name]
        return base + (f"_{{{','.join(lower)}}}" if lower else "")


PLAIN = Names({})
"""No name changed: what a mark looks like by itself."""


def name_document(derivation: Derivation) -> Names:
    """One spelling for each name that the document uses, none for two of them."""
    marks = dict.fromkeys(_list_marks(derivation))
    bases = dict.fromkeys(mark.base for mark in marks if _is_name(mark))
    indexed = [x for mark in marks if not _is_form(mark) for x in (*mark.lower, *mark.upper)]
    indices = dict.fromkeys(x for x in indexed if not x.isdigit())
    spec = derivation.system.spec
    groups = (spec.coordinates, spec.parameters, spec.definitions, spec.quasi_velocities)
    given = {entry.name for group in groups for entry in group}
    alike = _group((_look(Mark(name)), name) for name in bases)
    alike += _group((_look(Mark("", (name,))), name) for name in indices)
    changed: dict[str, _Spelled] = {}
    listed: dict[str, None] = {}
    for group in alike:
        first, *others = sorted(group, key=lambda name: (name in given, not name.isascii(), len(name)))
        listed |= dict.fromkeys([first, *others])
        changed |= {name: _typewriter(name) for name in others}
    made = {_look(mark, Names(changed)) for mark in marks if mark.prefix or not _is_name(mark)}
    made |= {"d", "ln", *FUNCTIONS}  # `sin_` beside x looks like a sine of x
    # d times x' looks like the differential dx', dx stands beside x, Delta_1 beside the first of nhc's determinants
    for name in bases:
        if name in given and name not in changed and _look(Mark(name)) in made:
            changed[name], listed[name] = _typewriter(name), None
    wide = [name for name in {**bases, **indices} if estimate(Names(changed).print_mark(Mark(name))) > WIDEST]
    for number, name in enumerate(wide, 1):
        changed[name], listed[name] = _numbered(name, number), None
    return Names(changed, (*bases, *indices), tuple(listed))


def _list_marks(derivation: Derivation) -> Iterator[Mark]:
    """All marks of the document; dots and arguments aside, which tell marks apart by themselves."""
    items: list[Item] = [item for sheet in derivation.sheets for item in (*sheet.lets, *sheet.items)]
    for item in items:
        found: Iterable[Mark | str | None] = ()
        if isinstance(item, Statement):
            found = [item.label, *(mark for term in (*item.left, *item.right) for mark in term.factors)]
        elif isinstance(item, Table):
            found = [cell for row in item.rows for cell in row]
        yield from (_bare(mark) for mark in found if isinstance(mark, Mark))
    yield from (_bare(symbol.mark) for symbol in derivation.symbols.values())


def _bare(mark: Mark) -> Mark:
    return Mark(mark.base, mark.lower, mark.upper, 0, mark.prefix if not mark.dots else "", mark.star)


def _is_name(mark: Mark) -> bool:
    """Whether the base is a name by itself; with indices of nhc's it is a letter of the theory."""
    return not (mark.lower or mark.upper or mark.star)


def _is_form(mark: Mark) -> bool:
    """Whether it is Omega or Theta, whose indices c, d and r are letters of the thesis, not names."""
    return " form" in mark.base


def _group(looks: Iterable[tuple[str, str]]) -> list[list[str]]:
    """The names that look the same, where there are several."""
    found: dict[str, list[str]] = {}
    for look, name in looks:
        found.setdefault(look, []).append(name)
    return [names for names in found.values() if len(names) > 1]


def _look(mark: Mark, names: Names = PLAIN) -> str:
    """What a reader sees, who does not tell upright from italic."""
    return (
        re.sub(r"\\(?:mathrm|mathit|text)\{([^{}]*)\}", r"\1", names.print_mark(mark))
        .replace("$", "")
        .replace(r"\,", "")
    )


def _typewriter(name: str) -> _Spelled:
    text = escape_exactly(name)
    return (rf"\mathtt{{{text}}}" if name.isascii() else rf"\text{{\ttfamily {text}}}"), ()


def _numbered(name: str, number: int) -> _Spelled:
    """The first letters, and a number in brackets that no name has."""
    letters = "".join(re.findall("[A-Za-z]", name.split("_")[0] or name))[:_KEPT] or "name"
    return spell_word(letters), (rf"\langle {number}\rangle",)
