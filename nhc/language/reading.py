"""Files to texts, with the specs that they extend."""

from __future__ import annotations

from pathlib import Path

from nhc.diagnostics import Source
from nhc.diagnostics.files import STDIN, read_source, read_text
from nhc.language.yaml_tree.extend import DEEPEST, base_name, folder_of, refuse, what_is_wrong


def read(path: str | Path) -> Source:
    """Return the text of a file, or of standard input for ``-``, with the specs that it extends; line ends become ``\\n``.

    Raises ``SpecError`` where the file cannot be opened (E0101), is not UTF-8 (E0102) or is over 1 MiB (E0103), or
    extends what it cannot (E0112).
    """
    return with_bases(read_source(str(path)))


def with_bases(source: Source) -> Source:
    """Return the source with the specs that it extends, the nearest first; raises ``SpecError`` (E0112) like :func:`read`."""
    return _with_bases(source, (source.path,))


def _with_bases(source: Source, chain: tuple[str, ...]) -> Source:
    """The source with the specs that it extends, the nearest first."""
    found = base_name(source)
    if found is None or source.path == STDIN:
        return source
    wrong = what_is_wrong(found.value)
    if wrong:
        raise refuse(source, found.span, wrong)
    path = (folder_of(source) / found.value).as_posix()
    if str(Path(path).resolve()) in [str(Path(name).resolve()) for name in chain]:
        raise refuse(source, found.span, f"`{found.value}` extends this spec itself, directly or through others")
    if len(chain) >= DEEPEST:
        raise refuse(source, found.span, f"more than {DEEPEST} specs extend one another")
    if not Path(path).is_file():
        raise refuse(source, found.span, f"there is no file `{path}`")
    text = read_text(path)
    base = _with_bases(Source(path, text), (*chain, path))
    return Source(source.path, source.text, (Source(path, text), *base.bases))
