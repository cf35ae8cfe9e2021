"""``nhc linearize --scene``: a scene to start from, as ``--about`` takes it."""

from __future__ import annotations

import pytest

from nhc.cli import main


def test_a_scene_is_where_about_starts(capsys: pytest.CaptureFixture[str]) -> None:
    shown = []
    for option in ("--scene", "--about"):
        assert main(["linearize", "pendulum", option, "small"]) == 0
        shown.append(capsys.readouterr().out)
    assert shown[0] == shown[1] and "eigenvalues" in shown[0]


@pytest.mark.parametrize(
    ("options", "wanted"),
    [
        (["--scene", "small", "--about", "theta=0"], "give one of them"),
        (["--scene", "nowhere"], "no scene `nowhere`"),
        (["--scene", "theta=0"], "no scene `theta=0`"),
    ],
)
def test_what_is_no_scene(options: list[str], wanted: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["linearize", "pendulum", *options]) == 2
    assert wanted in capsys.readouterr().err
