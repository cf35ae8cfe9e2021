"""The derivation as a LaTeX document of its own."""

from __future__ import annotations

from nhc.emit.latex.document import list_context, render

__all__ = ["list_context", "render"]
