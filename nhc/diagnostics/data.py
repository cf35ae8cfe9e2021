"""Diagnostics as data: made where a mistake is found, rendered last."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum

from nhc.records import record

from .codes import TITLES
from .source import Source, Span

_SHOWN_PLACES = 3  # of a mistake that stands at several, besides the first


class Severity(Enum):
    """How bad it is; only an error stops the compiler."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


@record
class Label:
    """A marked place with a few words (possibly none) to be written beside the mark."""

    span: Span
    text: str = ""


@record
class Diagnostic:
    """One finding. ``labels[0]`` is the primary place; ``help`` holds instructions that show the right spelling."""

    code: str
    severity: Severity
    message: str
    labels: tuple[Label, ...]
    notes: tuple[str, ...] = ()
    help: tuple[str, ...] = ()

    @property
    def span(self) -> Span:
        """The primary place."""
        return self.labels[0].span

    def placed(self, labels: tuple[Label, ...], notes: tuple[str, ...]) -> Diagnostic:
        """The same finding with other places and notes."""
        return Diagnostic(self.code, self.severity, self.message, labels, notes, self.help)


def localize(source: Source, diagnostic: Diagnostic) -> tuple[Source, Diagnostic]:
    """Return the text that holds the primary place, with the diagnostic's places in it; places elsewhere become notes."""
    part, start = source.find(diagnostic.span.start)
    if not source.bases:
        return source, diagnostic
    labels, notes = [], list(diagnostic.notes)
    for label in diagnostic.labels:
        other, _ = source.find(label.span.start)
        if other is part:
            labels.append(Label(Span(label.span.start - start, label.span.end - start), label.text))
            continue
        line, column = source.position(label.span.start)
        notes.append(f"{label.text or 'see'}: {other.path}:{line}:{column}")
    return part, diagnostic.placed(tuple(labels), tuple(notes))


def _order(diagnostic: Diagnostic) -> tuple[int, int, str, str]:
    return (diagnostic.span.start, diagnostic.span.end, diagnostic.code, diagnostic.message)


_USAGE = frozenset({"E0101", "E0503"})


class SpecError(Exception):
    """A spec cannot be compiled; carries every diagnostic that was found, in the order of their places."""

    def __init__(self, diagnostics: Iterable[Diagnostic], source: Source) -> None:
        self.diagnostics: tuple[Diagnostic, ...] = tuple(diagnostics)
        self.source = source
        super().__init__(self.diagnostics, source)

    @property
    def is_usage(self) -> bool:
        """Whether nothing is wrong with a spec, but with what was asked: an option's text, a file or a scene that is not there."""
        errors = {diagnostic.code for diagnostic in self.diagnostics if diagnostic.severity is Severity.ERROR}
        return self.source.path.startswith("--") or (bool(errors) and errors <= _USAGE)

    def __str__(self) -> str:
        parts = []
        for diagnostic in self.diagnostics:
            line, column = self.source.position(diagnostic.span.start)
            parts.append(
                f"{self.source.find(diagnostic.span.start)[0].path}:{line}:{column}: {diagnostic.code}: {diagnostic.message}"
            )
        return "\n".join(parts)


class Bag:
    """Collects diagnostics of one source, so that all are reported at once."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self._found: list[Diagnostic] = []
        self._places: dict[tuple[str, str], list[Span]] = {}

    def add(self, diagnostic: Diagnostic) -> None:
        """Add a finding; raises ``KeyError`` for a code that is not registered (an error of nhc, not of the user)."""
        if diagnostic.code not in TITLES:
            raise KeyError(diagnostic.code)
        self._found.append(diagnostic)

    def extend(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Add findings of another bag."""
        for diagnostic in diagnostics:
            self.add(diagnostic)

    def error(
        self,
        code: str,
        message: str,
        span: Span,
        label: str = "",
        *,
        labels: tuple[Label, ...] = (),
        notes: tuple[str, ...] = (),
        help: tuple[str, ...],
    ) -> None:
        """Add an error at ``span``; ``labels`` are further places."""
        self.add(Diagnostic(code, Severity.ERROR, message, (Label(span, label), *labels), notes, help))

    def warning(
        self,
        code: str,
        message: str,
        span: Span,
        *,
        labels: tuple[Label, ...] = (),
        notes: tuple[str, ...] = (),
        help: tuple[str, ...],
    ) -> None:
        """Add a warning at ``span``; ``labels`` are further places."""
        self.add(Diagnostic(code, Severity.WARNING, message, (Label(span), *labels), notes, help))

    def again(self, code: str, message: str, span: Span) -> bool:
        """Note a place of a mistake that stands at several, which is told once; say whether it was noted before."""
        places = self._places.setdefault((code, message), [])
        places.append(span)
        return len(places) > 1

    def is_noted(self, code: str, message: str) -> bool:
        """Whether :meth:`again` has noted a place of this mistake."""
        return (code, message) in self._places

    def _gather(self, found: Diagnostic) -> Diagnostic:
        """The finding with the places that :meth:`again` has noted of it, the first one in front."""
        places = self._places.get((found.code, found.message), [])
        if len(places) < 2:
            return found
        first, *others = sorted(dict.fromkeys(places), key=lambda span: (span.start, span.end))
        more = len(others) - _SHOWN_PLACES
        notes = (f"and at {more} more place{'s' if more > 1 else ''}",) if more > 0 else ()
        labels = [Label(place, "here too") for place in others[:_SHOWN_PLACES]]
        return found.placed((Label(first, found.labels[0].text), *found.labels[1:], *labels), (*found.notes, *notes))

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What was found so far, in the order of the places, without repetitions."""
        return tuple(dict.fromkeys(sorted(map(self._gather, self._found), key=_order)))

    @property
    def has_errors(self) -> bool:
        """Whether an error was found."""
        return any(diagnostic.severity is Severity.ERROR for diagnostic in self._found)

    def raise_if_errors(self) -> None:
        """Raise ``SpecError`` with everything that was found, if there is an error among it."""
        if self.has_errors:
            raise SpecError(self.diagnostics, self.source)
