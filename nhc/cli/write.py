"""Files on disk: all of an emission or nothing, and never over a file that a user has edited.

Devices and pipes (`/dev/stdout`, a process substitution of the shell) hold nothing that could be lost: they are written to, neither
read before nor replaced.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from nhc.cli.terminal import Exit, Failure, describe_os_error, put, put_text, say
from nhc.stamp import is_untouched

_FILES = (".c", ".h", ".py", ".tex", ".pdf", ".json", ".txt", ".yaml", ".csv", ".html", ".md")
"""Endings of files: a name with one of them is not meant for a new folder."""

_LARGEST = 1 << 26  # bytes


def deliver(text: str, output: str | None, *, force: bool, fitted: bool = False) -> None:
    """Give one text with a final line break to stdout (``output`` None or ``-``), or write it to that file.

    A terminal gets it ``fitted`` to its width where that is asked for.
    """
    text = text if text.endswith("\n") else text + "\n"
    if output is None or output == "-":
        (put_text if fitted else put)(text)
        return
    path = Path(output)
    if path.is_dir():
        raise Failure(f"`{output}` is a folder", ["name a file after `-o`"])
    if not force:
        refuse_to_overwrite({path: text}, edited_only=False)
    write_files({path: text})


def is_same_file(output: str, other: str) -> bool:
    """Whether two names, of which either may be none of a file, are of one."""
    first, second = Path(output), Path(other)
    return first.is_file() and second.is_file() and first.samefile(second)


def is_stream(path: Path) -> bool:
    """Whether there is a device or a pipe."""
    return path.exists() and not (path.is_file() or path.is_dir())


def check_place(output: str | Path, *, inside: bool = False) -> None:
    """Raise ``Failure`` where no file can be put, ``inside`` a folder of that name: before work that it would be a pity to lose."""
    path = Path(output).absolute()
    if is_stream(path):
        return
    folder = next(place for place in ((path, *path.parents) if inside else path.parents) if place.exists())
    if not folder.is_dir():
        raise Failure(f"cannot write `{output}`: `{folder}` is no folder", ["name another place"])
    if not os.access(folder, os.W_OK | os.X_OK):
        raise Failure(f"cannot write `{output}`: permission denied", ["name another place"])


def refuse_existing(output: str, force: bool) -> None:
    """Raise ``Failure`` where there is a file already, or none can be put: before a run, as :func:`check_place`."""
    check_place(output)
    path = Path(output)
    if path.exists() and not (force or is_stream(path)):
        raise Failure(f"`{output}` exists", ["give `--force` to overwrite it"], "E0501", Exit.FAILED)


def place_files(files: Mapping[str, str], output: str | None) -> dict[Path, str]:
    """Decide where ``files`` (name -> text) go: into the folder ``output``, by default the current one.

    A single file goes to ``output`` itself when the suffix says that it is such a file; several go beside the one of them that
    ``output`` names.
    """
    target = Path(output or ".")
    if len(files) == 1 and not target.is_dir():
        ((name, text),) = files.items()
        suffix = Path(name).suffix
        if target.suffix == suffix:
            return {target: text}
        if target.exists() or target.suffix in _FILES:
            raise Failure(
                f"`{output}` names a file, but no `{suffix}` file", [f"name a folder after `-o`, or a `{suffix}` file"]
            )
    if not target.is_dir() and target.name in files:
        return {target.parent / name: text for name, text in files.items()}
    if not target.is_dir() and (target.exists() or target.suffix in _FILES):
        listed = ", ".join(f"`{name}`" for name in files)
        raise Failure(
            f"`{output}` names one file, but {len(files)} are to be written: {listed}", ["name a folder after `-o`"]
        )
    return {target / name: text for name, text in files.items()}


def compare_files(files: Mapping[Path, str]) -> Exit:
    """Say which of ``files`` are missing or differ on disk; writes nothing."""
    result = Exit.DONE
    for path, text in files.items():
        current = _read(path)
        if current != text:
            say(f"{'missing' if current is None else 'differs'}: {path}")
            result = Exit.FAILED
    return result


def refuse_to_overwrite(files: Mapping[Path, str], *, edited_only: bool = True) -> None:
    """Raise ``Failure`` when one of ``files`` exists with another text.

    With ``edited_only`` a file that still is as nhc wrote it may go: its stamp fits its text.
    """
    for path, text in files.items():
        current = _read(path)
        if current is None or current == text or (edited_only and is_untouched(current)):
            continue
        reason = "is not as nhc wrote it: someone has edited it" if edited_only else "exists"
        advice = ["keep your changes under another name, or give `--force` to lose them"]
        raise Failure(f"`{path}` {reason}", advice, "E0501", Exit.FAILED)


def write_files(files: Mapping[Path, str]) -> None:
    """Write all of ``files`` or none, each by renaming a finished temporary file, and say so on stderr."""
    changed = {path: text for path, text in files.items() if _read(path) != text}
    streams = [path for path in changed if is_stream(path)]
    try:
        with _written_beside({path: text for path, text in changed.items() if path not in streams}) as temporaries:
            _replace_all(temporaries)
        for path in streams:
            path.write_bytes(changed[path].encode())
    except OSError as error:
        own = {str(_temporary(path.resolve())): path for path in changed}  # a user knows nothing of it
        named = own.get(str(error.filename), error.filename)
        where = named or ", ".join(map(str, changed))  # a full disk names no file
        raise Failure(
            f"cannot write `{where}`: {describe_os_error(error)}", [], notes=["nothing was written"]
        ) from error
    for path in files:
        say(f"{'wrote' if path in changed else 'unchanged'} {path}")


def _temporary(final: Path) -> Path:
    """What is written beside a file before it takes its place."""
    return final.with_name(f".{final.name}.{os.getpid()}.tmp")


def write_bytes(path: Path, content: bytes) -> None:
    """Write one file, text or not, by renaming a finished temporary one, and say so on stderr."""
    final = path.resolve()
    temporary = _temporary(final)
    try:
        if is_stream(path):
            path.write_bytes(content)
        else:
            final.parent.mkdir(parents=True, exist_ok=True)
            temporary.write_bytes(content)
            os.replace(temporary, final)
    except OSError as error:
        raise Failure(
            f"cannot write `{path}`: {describe_os_error(error)}", [], notes=["nothing was written"]
        ) from error
    finally:
        with suppress(OSError):  # what should be its folder is a file
            temporary.unlink(missing_ok=True)
    say(f"wrote {path}")


@contextmanager
def _written_beside(files: Mapping[Path, str]) -> Iterator[dict[Path, Path]]:
    """Write each text beside its place and yield temporary -> final; what is left of them at the end is removed, and new folders
    without files.
    """
    temporaries: dict[Path, Path] = {}
    made = list[Path]()
    try:
        for path, text in files.items():
            final = path.resolve()  # a link stays a link
            made += [folder for folder in final.parents if not folder.exists()]
            final.parent.mkdir(parents=True, exist_ok=True)
            temporary = _temporary(final)
            temporaries[temporary] = final
            temporary.write_bytes(text.encode())
            if final.exists():
                os.chmod(temporary, os.stat(final).st_mode & 0o7777)
        yield temporaries
    finally:
        for temporary in temporaries:
            with suppress(OSError):  # a name that is too long
                temporary.unlink(missing_ok=True)
        for folder in made:  # the innermost first
            with suppress(OSError):
                folder.rmdir()


def _replace_all(temporaries: Mapping[Path, Path]) -> None:
    """Move every temporary to its place; when one cannot move, put the earlier ones back as they were."""
    before: dict[Path, bytes | None] = {}
    try:
        for temporary, final in temporaries.items():
            before[final] = final.read_bytes() if final.exists() else None
            os.replace(temporary, final)
    except (OSError, KeyboardInterrupt):
        for final, content in before.items():
            if content is None:
                final.unlink(missing_ok=True)
            elif final.is_file():
                final.write_bytes(content)
        raise


def _read(path: Path) -> str | None:
    """Return the text of ``path`` with its line ends as they are, None when there is no such file, or a stream.

    Of a file larger than any that nhc writes as text this is a part: it differs, and carries no stamp that fits.
    """
    try:
        if is_stream(path):
            return None
        with path.open("rb") as stream:
            return stream.read(_LARGEST).decode(errors="replace")
    except FileNotFoundError:
        return None
    except OSError as error:
        raise Failure(f"cannot read `{path}`: {describe_os_error(error)}", ["name another place after `-o`"]) from error
