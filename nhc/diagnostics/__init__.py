"""Source places, diagnostics as data, their codes and their rendering."""

from .codes import TITLES, codes, page
from .data import Bag, Diagnostic, Label, Severity, SpecError
from .nearest import nearest, quote, several, suggest
from .source import Source, Span
from .structured import to_json
from .text import render_concise, render_text

__all__ = [
    "TITLES",
    "Bag",
    "Diagnostic",
    "Label",
    "Severity",
    "Source",
    "Span",
    "SpecError",
    "codes",
    "nearest",
    "page",
    "quote",
    "render_concise",
    "render_text",
    "several",
    "suggest",
    "to_json",
]
