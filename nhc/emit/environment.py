"""The one Jinja environment of all languages.

Jinja2 is imported when the first text is rendered, never before: start-up time matters.
"""

from __future__ import annotations

import functools
import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from nhc.kept import keep, recall
from nhc.records import record
from nhc.resources import cache_folder, find_templates
from nhc.stamp import stamp

if TYPE_CHECKING:
    from jinja2 import BytecodeCache, Environment


@record
class File:
    """One file to be made: its name, the template it comes from and exactly what that template may use."""

    name: str
    template: str
    context: Mapping[str, object]


@functools.cache
def create_environment() -> Environment:
    """Delimiters that no target language uses; an unknown variable is an error, never an empty text."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    return Environment(
        loader=FileSystemLoader(find_templates(), encoding="utf-8"),
        bytecode_cache=_keep_templates(),
        block_start_string="<%",
        block_end_string="%>",
        variable_start_string="<<",
        variable_end_string=">>",
        comment_start_string="<#",
        comment_end_string="#>",
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        auto_reload=False,
    )


def _keep_templates() -> BytecodeCache | None:
    """Compiled templates beside the compiled models: compiling them takes longer than printing a model.

    An entry is used only for the text it came from; a folder that cannot be written costs the time and nothing else.
    """
    from jinja2 import BytecodeCache
    from jinja2 import __version__ as release
    from jinja2.bccache import Bucket

    class Kept(BytecodeCache):
        def __init__(self, folder: Path) -> None:
            self.folder = folder

        def load_bytecode(self, bucket: Bucket) -> None:
            content = recall(self._place(bucket))
            if content is not None:
                bucket.bytecode_from_string(content)

        def dump_bytecode(self, bucket: Bucket) -> None:
            with suppress(OSError):
                keep(self._place(bucket), bucket.bytecode_to_string())

        def _place(self, bucket: Bucket) -> Path:
            return self.folder / f"{bucket.key}-{sys.implementation.cache_tag}-{release}"

    try:
        return Kept(cache_folder() / "templates")
    except OSError:
        return None


def render_file(file: File) -> str:
    """The text of one file, stamped; texts of the user are values here and never templates."""
    return stamp(create_environment().get_template(file.template).render(file.context))
