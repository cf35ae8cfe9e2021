"""What building nhc does beside collecting files: an editable install gets compiled bytecode, as pip gives it to any other.

Where ``PYTHONDONTWRITEBYTECODE`` is set, as in many containers, Python would otherwise compile nhc anew at every start,
which takes longer than to derive the equations of a bicycle.  A file that is changed later is compiled as ever.
"""

from __future__ import annotations

import compileall
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class Bytecode(BuildHookInterface[Any]):
    """Compile the package where it stands, once it is installed in place."""

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Write ``__pycache__`` beside the sources of an editable install; what cannot be written is left out."""
        if version == "editable":
            compileall.compile_dir(Path(self.root, "nhc"), quiet=2)
