"""What nhc has written before, kept: the same question to the same nhc has the same answer, and it is derived once.

A question is a verb, its options and the texts of the spec; nhc itself is part of it, as the sizes and times of its own
files, so that a new version or an edited template asks anew.  An answer is a set of texts by file name, in JSON, in
``answers`` below the cache folder; it appears by a rename and is taken only when it is whole.  Whatever goes wrong with
the folder costs the time of deriving again and nothing else.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

from nhc.kept import clear, keep, recall
from nhc.resources import PACKAGE, cache_folder, find_templates
from nhc.version import __version__

MOST = 256
"""Answers kept; one more, and the quarter that was asked for least recently goes."""
LARGEST = 1 << 20
"""Characters of an answer that is kept."""

Answer = dict[str, str]


def answer(question: Sequence[str], make: Callable[[], Answer]) -> Answer:
    """The texts by name that answer ``question``: those of last time, else what ``make`` returns, which is kept.

    Raises what ``make`` raises; errors are not kept.
    """
    try:
        path = cache_folder() / "answers" / f"{_key(question)}.json"
    except OSError:
        return make()
    kept = _recall(path)
    if kept is not None:
        return kept
    made = make()
    _keep(path, made)
    return made


def _key(question: Sequence[str]) -> str:
    digest = sha256()
    for part in (*question, *_identity()):
        digest.update(f"{len(part)}:{part}".encode(errors="surrogatepass"))
    return digest.hexdigest()[:32]


def _identity() -> Iterator[str]:
    """What decides about the answer beside the question: this nhc, the libraries that print, and Python."""
    yield __version__
    yield sys.version
    for folder in (PACKAGE, find_templates()):
        yield from _describe(folder)
    for library in ("yaml", "jinja2"):
        found = find_spec(library)
        if found is not None and found.origin:
            yield _stand(found.origin, os.stat(found.origin))


def _describe(folder: Path | str) -> Iterator[str]:
    """Name, size and time of each source file below a folder, in an order of their own."""
    with os.scandir(folder) as entries:
        for entry in sorted(entries, key=lambda entry: entry.name):
            if entry.is_dir():
                if entry.name != "__pycache__":
                    yield from _describe(entry.path)
            else:
                yield _stand(entry.path, entry.stat())


def _stand(path: str, status: os.stat_result) -> str:
    return f"{path} {status.st_size} {status.st_mtime_ns}"


def _recall(path: Path) -> Answer | None:
    """The answer in a file; None without one."""
    content = recall(path)
    if content is None:
        return None
    with suppress(OSError):  # a cache that others may read is of use to them too
        os.utime(path)
    kept: Answer = json.loads(content)
    return kept


def _keep(path: Path, made: Answer) -> None:
    text = json.dumps(made, ensure_ascii=False)
    if len(text) > LARGEST:
        return
    with suppress(OSError, ValueError):  # a full disk, a folder of someone else, half of a surrogate pair
        keep(path, text.encode())
        clear(path.parent)
        _make_room(path.parent)


def _make_room(folder: Path) -> None:
    names = [path for path in folder.iterdir() if path.suffix == ".json"]
    if len(names) <= MOST:
        return
    names.sort(key=lambda path: path.stat().st_mtime)
    for path in names[: MOST // 4]:
        path.unlink(missing_ok=True)
