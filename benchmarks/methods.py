"""The best method beside ``dop853``: ``python -m benchmarks.methods`` charts four scenes and rewrites a table of docs/chart.md."""

from __future__ import annotations

import re
import sys

from benchmarks.systems import ROOT
from nhc.language import read
from nhc.resources import find_specs
from nhc.study.chart.advice import TARGETS, fastest
from nhc.study.chart.case import Study
from nhc.study.chart.grid import Grid
from nhc.study.chart.study import chart
from nhc.study.chart.words import spell_power

PAGE = ROOT / "docs" / "chart.md"
PART = re.compile(r"^<!-- measured: methods -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)
SYSTEMS = ("chaplygin_sleigh", "disk_chain2", "pendulum", "rolling_disk")
METHOD, BUDGET = "dop853", 0.05


def ratio(study: Study, target: float) -> str:
    """The time of the best other method over that of ``dop853``, both in C and with the best formulation; which it is."""
    floor = study.reference.error
    compiled = [result for result in study.results if result.case.language == "c"]
    own = fastest([r for r in compiled if r.case.method == METHOD], target, floor)
    other = fastest([r for r in compiled if r.case.method != METHOD], target, floor)
    if own is None or other is None:
        return "-"
    return f"{other.best / own.best:.2g} ({other.case.method})"


def print_table(studies: list[Study]) -> str:
    """The table with its head, the references' errors and the machine."""
    rows = [f"| scene | {' | '.join(map(spell_power, TARGETS))} |", "|---" * (len(TARGETS) + 1) + "|"]
    rows += [f"| {s.system}, {s.scene} | {' | '.join(ratio(s, target) for target in TARGETS)} |" for s in studies]
    worst = max(study.reference.error for study in studies)
    known = f"The references are known to {worst:.0e} or better."
    return "\n".join([*rows, "", f"{known}  Machine: {studies[0].machine.line}."])


def main() -> None:
    """Rewrite the part of the page between its marks."""
    text = PAGE.read_text()
    assert PART.search(text), f"{PAGE} has lost its marks"
    studies = []
    for name in SYSTEMS:
        source = read(str(find_specs() / f"{name}.yaml"))
        studies.append(chart(source, Grid(languages=("c",), peers=False, budget=BUDGET)))
        print(name, *(ratio(studies[-1], target) for target in TARGETS), file=sys.stderr)
    table = print_table(studies)
    PAGE.write_text(PART.sub(lambda _: f"<!-- measured: methods -->\n{table}\n<!-- end -->", text))


if __name__ == "__main__":
    main()
