"""``nhc`` without its start: a process that has imported all of it forks once for each command of a transcript.

What a command sees is its own: arguments, folder, environment and streams are handed over by `CALL`, which runs without the
library's site and ends as the child does.  It starts a new interpreter where a stream is missing, or a variable differs that is
read only when an interpreter starts.
"""

from __future__ import annotations

import atexit
import gc
import os
import pkgutil
import socket
import subprocess
import sys
import tempfile
import traceback
from collections.abc import Mapping
from contextlib import suppress
from importlib import import_module
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CALL = """import os, sys
try:
    from _socket import AF_UNIX, SCM_RIGHTS, SHUT_WR, SOL_SOCKET, socket
    if {at_start!r} != {{k: v for k, v in os.environ.items() if k.startswith(("PYTHON", "LC_", "LANG"))}}:
        raise OSError
    streams = b"".join((os.fstat(k), k.to_bytes(4, sys.byteorder))[1] for k in (0, 1, 2))
    line = socket(AF_UNIX)
    line.connect({address!r})
    line.sendmsg([b"-"], [(SOL_SOCKET, SCM_RIGHTS, streams)])
    words = [os.getcwd(), str(len(sys.argv) - 1), *sys.argv[1:], *(f"{{k}}={{v}}" for k, v in os.environ.items())]
    line.sendall(b"\\0".join(map(os.fsencode, words)))
    line.shutdown(SHUT_WR)
except OSError:
    os.execv({python!r}, [{python!r}, "-m", "nhc", *sys.argv[1:]])
os._exit(line.recv(1)[0])
"""


def start(environment: Mapping[str, str]) -> str:
    """Start a server with this environment; the text of a program that is ``nhc`` by way of it."""
    folder = tempfile.mkdtemp(prefix="nhc-serve-")
    address = f"{folder}/door"
    command = [sys.executable, str(Path(__file__)), address]
    server = subprocess.Popen(command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
    assert server.stdout is not None and server.stdout.readline() == b"ready\n"
    atexit.register(server.kill)
    at_start = {k: v for k, v in environment.items() if k.startswith(("PYTHON", "LC_", "LANG"))}
    return CALL.format(address=address, python=sys.executable, at_start=at_start)


def serve(address: str) -> None:
    """Until the process that started this one is gone."""
    sys.path[0] = str(ROOT)
    for package in ("nhc", "numpy", "scipy"):
        import_module(package)
    for module in pkgutil.walk_packages(import_module("nhc").__path__, "nhc."):
        if not module.name.endswith("__main__"):
            import_module(module.name)
    gc.freeze()
    parent = os.getppid()
    with socket.socket(socket.AF_UNIX) as door:
        door.bind(address)
        door.listen()
        door.settimeout(1.0)
        os.write(1, b"ready\n")
        while os.getppid() == parent:
            with suppress(TimeoutError):
                line, _ = door.accept()
                if os.fork() == 0:
                    door.close()
                    _answer(line)
                line.close()
            with suppress(ChildProcessError):
                while os.waitpid(-1, os.WNOHANG)[0]:
                    pass


def _answer(line: socket.socket) -> None:
    """One command, in a process of its own."""
    code = 70
    try:
        line.settimeout(None)
        _, streams, _, _ = socket.recv_fds(line, 1, 3)
        for number, stream in enumerate(streams):
            os.dup2(stream, number)
            os.close(stream)
        sys.stdin, sys.stdout, sys.stderr = os.fdopen(0), os.fdopen(1, "w"), os.fdopen(2, "w", buffering=1)
        folder, count, *words = b"".join(iter(lambda: line.recv(65536), b"")).split(b"\0")
        os.chdir(folder)
        os.environ.clear()
        os.environb.update(word.split(b"=", 1) for word in words[int(count) :])
        from nhc.cli import main

        sys.argv = ["nhc", *map(os.fsdecode, words[: int(count)])]
        code = main()
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
    except BaseException:
        traceback.print_exc()
    finally:
        line.send(bytes([code]))
        os._exit(code)


if __name__ == "__main__":
    serve(sys.argv[1])
