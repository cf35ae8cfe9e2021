"""``python -m nhc.study.atlas FILE``: run every scenario and rewrite the table between the marks in FILE."""

from __future__ import annotations

import re
import sys
from pathlib import Path

from nhc.study.atlas.table import lines, markdown, run_all

_PART = re.compile(r"^<!-- generated: atlas -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)


def main(arguments: list[str]) -> int:
    """0 where all pass, 1 where one does not, 2 for a file without the marks."""
    path = Path(arguments[0]) if len(arguments) == 1 else None
    text = path.read_text(encoding="utf-8") if path is not None and path.is_file() else ""
    if path is None or not _PART.search(text):
        sys.stderr.write("error: name a file that has the marks `<!-- generated: atlas -->` and `<!-- end -->`\n")
        return 2
    results = run_all(slow=True, tell=lambda line: print(line, file=sys.stderr))
    table = f"<!-- generated: atlas -->\n{markdown(results).strip()}\n<!-- end -->"
    path.write_text(_PART.sub(lambda _: table, text), encoding="utf-8")
    print(lines(results)[-1])
    return 0 if all(verdict.passed for _, verdict in results) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
