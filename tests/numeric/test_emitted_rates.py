"""The rates that are emitted solve the equations: exactly, and a wrong way to them is told."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from nhc.cli.entry import main
from nhc.diagnostics import Source
from nhc.language import read
from nhc.mechanics.trees.sphere import Sphere
from nhc.program.emitted_rates import check_emitted
from tests.numeric.test_spheres import hanging
from tests.support import ROOT

GALLERY = sorted((ROOT / "specs").glob("*.yaml"))


@pytest.mark.parametrize("path", GALLERY, ids=lambda path: path.stem)
def test_of_every_gallery_system(path: Path) -> None:
    found = check_emitted(read(str(path)))
    assert found and set(found.values()) <= {True, None} and True in found.values()
    assert all(holds is None for name, holds in found.items() if name == "multipliers" and "chaplygin" in found)


def test_an_error_on_the_way_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Rods of unequal lengths that are taken for those of equal ones: an error that there was."""
    text = hanging("fixed", 2, 5).replace(" l1*(", " 2*(").replace(" l2*(", " 3*(")
    assert check_emitted(Source("rods.yaml", text))["lagrange"]
    whole = Sphere.on_foot
    monkeypatch.setattr(
        Sphere, "on_foot", lambda self, graph, vector: [graph.scale(2, x) for x in whole(self, graph, vector)]
    )
    assert check_emitted(Source("rods.yaml", text))["lagrange"] is False
    path = tmp_path / "rods.yaml"
    path.write_text(text)
    assert main(["compare", str(path)]) == 1
    assert "the rates of lagrange do NOT solve its equations" in capsys.readouterr().out
    assert main(["compare", str(path), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["emitted"]["lagrange"] is False
