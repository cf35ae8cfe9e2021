"""Where the files lie that nhc reads at run time: ``templates/`` and ``specs/``.

A wheel carries them inside the package (``nhc/_data/<name>``); in a checkout and in an editable install they are
beside it.  Nothing else in the project may look for these folders.
"""

from __future__ import annotations

import errno
import os
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent
INSIDE_A_WHEEL = "_data"


def list_candidates(name: str, package: Path = PACKAGE) -> tuple[Path, ...]:
    """The places where the folder ``name`` may be, the likeliest first."""
    return (package / INSIDE_A_WHEEL / name, package.parent / name)


def find_folder(name: str, package: Path = PACKAGE) -> Path:
    """The folder ``name`` ("templates" or "specs").

    Raises FileNotFoundError with the places that were tried: the installation is broken then, not the user's input.
    """
    candidates = list_candidates(name, package)
    for candidate in candidates:
        if candidate.is_dir():
            return candidate
    tried = ", ".join(str(candidate) for candidate in candidates)
    raise FileNotFoundError(f"the folder `{name}` is not part of this installation (tried {tried})")


def find_templates() -> Path:
    """The folder of templates, one folder per language in it."""
    return find_folder("templates")


def find_specs() -> Path:
    """The folder of the gallery: ``<name>.yaml`` and ``<name>.md``."""
    return find_folder("specs")


def cache_folder() -> Path:
    """Where compiled models, templates and answers are kept: ``$NHC_CACHE``, else ``nhc`` in the user's cache folder.

    Raises FileNotFoundError for a user without a home, as the user of a container may be.
    """
    if os.environ.get("NHC_CACHE"):
        return Path(os.environ["NHC_CACHE"])
    if os.environ.get("XDG_CACHE_HOME"):
        return Path(os.environ["XDG_CACHE_HOME"]) / "nhc"
    try:
        return Path.home() / ".cache" / "nhc"
    except RuntimeError as error:
        raise FileNotFoundError(errno.ENOENT, "the user has no home folder") from error
