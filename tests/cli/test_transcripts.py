"""Sessions of the command line: tests/cli/*.txt, and what README.md and docs/ show in ``console`` blocks."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.cli.transcript import ROOT, matches, parse, run

HERE = Path(__file__).parent
TRANSCRIPTS = sorted(HERE.glob("*.txt"))
DOCUMENTS = [
    path for path in (ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))) if "```console" in path.read_text()
]


@pytest.mark.parametrize("path", TRANSCRIPTS, ids=lambda path: path.stem)
def test_transcript(path: Path, tmp_path: Path, update: bool) -> None:
    folder = tmp_path / "session"
    folder.mkdir()
    steps, tail = parse(path.read_text())
    assert steps, "a transcript without a command"
    written: list[str] = []
    for step in steps:
        actual = run(step.command, folder)
        assert "[exit 70]" not in actual, "\n".join(actual)  # never to be recorded
        fits = matches(step.expected, actual)
        written += [*step.before, f"$ {step.command}", *(step.expected if fits else actual)]
        assert fits or update, _differ(step.command, step.expected, actual)
    if update:
        path.write_text("\n".join([*written, *tail]) + "\n")


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_examples_of_a_document_run_as_printed(path: Path, tmp_path: Path) -> None:
    """Blocks in their order: `console` ones are run, those with a file's name after the language are written there."""
    folder = tmp_path / "session"
    folder.mkdir()
    blocks = re.findall(r"^```([^\n]*)\n(.*?)^```$", path.read_text(), re.MULTILINE | re.DOTALL)
    sessions = 0
    for info, block in blocks:
        for file in re.findall(r" (\w+\.\w+)", info):
            (folder / file).write_text(block)
        if info != "console":
            continue
        steps, _ = parse(block)
        assert steps, f"a block without a command:\n{block}"
        sessions += 1
        for step in steps:
            actual = run(step.command, folder, merged=True)
            assert matches(step.expected, actual), _differ(step.command, step.expected, actual)
    assert sessions


def _differ(command: str, expected: tuple[str, ...], actual: list[str]) -> str:
    return "\n".join([f"$ {command}", "--- expected", *expected, "--- actual", *actual])


def test_transcripts_exist() -> None:
    assert len(TRANSCRIPTS) >= 5
    assert ROOT / "README.md" in DOCUMENTS
