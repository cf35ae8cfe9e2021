"""The page of each diagnostic code: its wrong example really yields the code, and what it advises does not."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.diagnostics import SpecError, codes, page
from nhc.language import read
from tests.cli.transcript import run
from tests.unit.fragments import SPECS, Block, blocks, complete, errors_in, found_in

# examples that a page can only hint at, as bytes of a file: wrong, instead
BYTES = {
    "E0102": (b'nhc: 1\nsource: ["Poincar\xe9 1901"]\n', 'source: ["Poincaré 1901"]\n'.encode()),
    "E0205": (b"T: " + b"(" * 201 + b"x'^2" + b")" * 201, b"define:\n  part: x'^2\nT: m/2*part\n"),
}
# codes whose examples are commands: what is run before the wrong one
SESSIONS = {
    "E0101": "mkdir specs && cp sleigh.yaml specs",
    "E0103": "yes '0.1,0.2,0.3' | head -c 1100000 > measurements.csv",
    "E0112": "printf 'nhc: 1\\nextends: ../sleigh.yaml\\n' > outwards.yaml && "
    "printf 'nhc: 1\\nextends: sleigh.yaml\\nsystem: heavy\\nparameters: {m: 9}\\n' > heavy.yaml",
    "E0501": "nhc emit sleigh.yaml --lang c && echo '/* mine */' >> chaplygin_sleigh.c",
    "E0502": "true",
    "E0503": "true",
    "E0504": "true",
    "E0505": "printf 'nhc: 1\\nextends: sleigh.yaml\\nscenes: {glide: {time: [0, 9]}}\\n' > shorter.yaml",
    "E0506": "true",
}


def examples(code: str, heading: str) -> list[Block]:
    return [block for block in blocks(page(code)) if block.heading == heading]


@pytest.mark.parametrize("code", codes())
def test_each_page_has_its_parts(code: str) -> None:
    text = page(code)
    assert [line for line in text.splitlines() if line.startswith("## ")] == ["## Why", "## Wrong", "## Instead"]
    assert len(examples(code, "Wrong")) == len(examples(code, "Instead")) == 1
    words = {block.words for block in blocks(text)}
    assert words == {("sh",)} if code in SESSIONS else words <= {("yaml",), ("text",)}
    assert code in BYTES or ("text",) not in words


@pytest.mark.parametrize("code", [code for code in codes() if code not in SESSIONS and code not in BYTES])
def test_the_wrong_example_yields_the_code(code: str) -> None:
    (wrong,) = examples(code, "Wrong")
    assert code in found_in(complete(wrong.text))


@pytest.mark.parametrize("code", [code for code in codes() if code not in SESSIONS and code not in BYTES])
def test_what_is_advised_is_good(code: str) -> None:
    (instead,) = examples(code, "Instead")
    assert errors_in(complete(instead.text)) == []
    assert code not in found_in(complete(instead.text))


def _found_in_file(path: Path) -> list[str]:
    try:
        return found_in(complete(read(path).text))
    except SpecError as error:
        return [diagnostic.code for diagnostic in error.diagnostics]


@pytest.mark.parametrize("code", BYTES)
def test_examples_of_bytes(code: str, tmp_path: Path) -> None:
    path = tmp_path / "example.yaml"
    for data, expected in zip(BYTES[code], ([code], []), strict=True):
        path.write_bytes(data)
        assert _found_in_file(path) == expected


@pytest.mark.parametrize("code", SESSIONS)
def test_examples_of_commands(code: str, tmp_path: Path) -> None:
    folder = tmp_path / "session"
    folder.mkdir()
    (folder / "sleigh.yaml").write_text((SPECS / "chaplygin_sleigh.yaml").read_text())
    assert not any("error" in line for line in run(SESSIONS[code], folder))
    (wrong,), (instead,) = examples(code, "Wrong"), examples(code, "Instead")
    assert any(f"error[{code}]" in line for line in run(wrong.text.strip(), folder))
    for command in instead.text.strip().splitlines():
        actual = run(command, folder)
        assert not any("error" in line or line.startswith("[exit") for line in actual), actual
