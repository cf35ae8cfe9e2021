"""The one Jinja environment of all languages.

Jinja2 is imported when the first text is rendered, never before: start-up time matters.
"""

from __future__ import annotations

import functools
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING

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


def _keep_templates() -> BytecodeCache:
    """Compiled templates beside the compiled models: compiling them takes longer than printing a model.

    An entry is used only for the text it came from; a folder that cannot be written costs the time and nothing else.
    """
    from jinja2 import FileSystemBytecodeCache
    from jinja2.bccache import Bucket

    class Kept(FileSystemBytecodeCache):
        def load_bytecode(self, bucket: Bucket) -> None:
            try:
                super().load_bytecode(bucket)
            except (OSError, EOFError, ValueError, TypeError):
                bucket.reset()

        def dump_bytecode(self, bucket: Bucket) -> None:
            try:
                os.makedirs(self.directory, mode=0o700, exist_ok=True)
                super().dump_bytecode(bucket)
            except OSError:
                pass

    return Kept(str(cache_folder() / "templates"))


def render_file(file: File) -> str:
    """The text of one file, stamped; texts of the user are values here and never templates."""
    return stamp(create_environment().get_template(file.template).render(file.context))
