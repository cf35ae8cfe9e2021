"""nhc compiles a description of a mechanical system with nonholonomic constraints into its equations of motion.

The two functions here are the whole of the public interface for Python; they import what they need when called, so that
``import nhc`` costs nothing.
"""

from __future__ import annotations

from os import PathLike
from typing import TYPE_CHECKING

from nhc.version import __version__

if TYPE_CHECKING:
    from nhc.language import Spec

__all__ = ["__version__", "compile", "load"]


def load(path: str | PathLike[str]) -> Spec:
    """Read and decode the spec at ``path``.

    Raises ``nhc.diagnostics.SpecError`` with all of its errors at once, ``OSError`` when it cannot be read.
    """
    from nhc.language import decode, read

    return decode(read(str(path)))


def compile(
    path: str | PathLike[str],
    language: str,
    *,
    formulation: str = "",
    scene: str = "",
    only: tuple[str, ...] = (),
    driver: bool = False,
    array: str = "",
) -> dict[str, str]:
    """Compile the spec at ``path`` into ``language`` (c, python, latex) and return file names with their texts.

    Nothing is written.  The options are those of ``nhc emit``; empty ones leave the choice to the spec.

    Raises ``nhc.diagnostics.SpecError`` as ``load`` does, and for options that do not fit the spec.
    """
    from nhc.language import read
    from nhc.pipeline import Options, emit

    options = Options(formulation=formulation, scene=scene, only=only, driver=driver, array=array)
    return emit(read(str(path)), language, options)
