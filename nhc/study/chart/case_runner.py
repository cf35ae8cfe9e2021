"""Which runs of a default chart are worth their time: a line of cases ends where they get too slow."""

from __future__ import annotations

from dataclasses import dataclass, field

from nhc.study.chart.case import Case, Result
from nhc.study.chart.grid import MOST_PYTHON, PYTHON_STRIDE
from nhc.study.chart.measure import choose_clock
from nhc.study.chart.single import Rig, run_case

SLOW = {"c": 0.6, "python": 1.2}  # seconds of a case with its repeats, after which its line has no finer ones
TIMES = 150.0  # the interpreter takes at least that many times the time of compiled code
Left = list[tuple[str, str]]


@dataclass
class CaseRunner:
    """Runs the cases of a formulation; ``explicit``: the user named the tolerances, so that each is run."""

    rig: Rig
    explicit: bool
    budget: float
    slow: list[str] = field(default_factory=list)
    many: list[str] = field(default_factory=list)
    _ended: set[tuple[str, str]] = field(default_factory=set)
    _twins: dict[tuple[str, float], Result] = field(default_factory=dict)
    _times: dict[str, float] = field(default_factory=dict)

    def run(self, case: Case, rung: int) -> list[Result]:
        """The case's result; nothing where it is left out."""
        language, line = case.language, (case.method, case.language)
        if not self.explicit and ((language == "python" and rung % PYTHON_STRIDE != 1) or line in self._ended):
            return []
        twin = self._twins.get((case.method, case.tolerance))
        if language == "python" and not self._may_interpret(case.method, twin):
            self.many.append(case.method)
            return []
        clock = choose_clock()
        before = clock()
        made = run_case(self.rig, case, self.budget)
        if clock() - before > SLOW[language] and not self.explicit:
            self._ended.add(line)
            self.slow.append(f"{case.method} in {'C' if language == 'c' else 'Python'}")
        if language == "c":
            self._twins[case.method, case.tolerance] = made
        elif twin is not None and made.best > TIMES * twin.best:
            self._times[case.method] = made.best / twin.best
        return [made]

    def _may_interpret(self, method: str, twin: Result | None) -> bool:
        """Whether what took that much in compiled code may be interpreted; not what took that too long already."""
        if twin is None:
            return (method, "c") not in self._ended
        times = self._times.get(twin.case.method, TIMES)
        calls = twin.calls + 4 * twin.jacobians
        return calls <= MOST_PYTHON and (self.explicit or not times * twin.best > SLOW["python"])

    def left(self) -> Left:
        """What was left out, with the reason."""
        found = Left()
        if self.many:
            names = ", ".join(dict.fromkeys(self.many))
            why = f"its finer tolerances take more than {MOST_PYTHON} right-hand sides or {SLOW['python']:g} s"
            found.append((f"{self.rig.name} with {names} in Python", why))
        if self.slow:
            names = ", ".join(dict.fromkeys(self.slow))
            found.append(
                (f"{self.rig.name} with {names}", "its finer tolerances take too long; name them to have them run")
            )
        return found
