"""A constraint that follows from others: which ones it follows from."""

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve

SPEC = "nhc: 1\nsystem: rows\ncoordinates: [x, y, z, u]\nT: (x'^2 + y'^2 + z'^2 + u'^2)/2\nconstraints:\n"
BALL = """\
nhc: 1
system: ball
coordinates: [x, y]
rotation: {R: {velocities: [w1, w2, w3]}}
T: (x'^2 + y'^2 + w1^2 + w2^2 + w3^2)/2
constraints:
"""


@pytest.mark.parametrize(
    ("head", "rows", "note"),
    [
        (SPEC, ("a: x' = y'", "b: 2*cos(z)*x' = 2*cos(z)*y'"), "it is `a` times a factor"),
        (
            SPEC,
            ("a: x' = y'", "b: y' = z*u'", "c: x' = z*u'"),
            "it is a combination of `a` and `b`",
        ),
        (
            SPEC,
            ("a: x' = y'", "b: y' = sin(u)*z'", "c: u' = y'", "d: x' - u' = 0"),
            "it is a combination of `a` and `c`",
        ),
        (BALL, ("a: R_0*R_0' + R_1*R_1' + R_2*R_2' + R_3*R_3' = 0",), "it says what the rotation `R` says by itself"),
        (BALL, ("a: x' = w1", "b: y' = w2", "c: x' + y' = w1 + w2"), "it is a combination of `a` and `b`"),
    ],
)
def test_of_which_rows_a_dependent_one_is_made(head: str, rows: tuple[str, ...], note: str) -> None:
    text = head + "".join(f"  - {row}\n" for row in rows)
    with pytest.raises(SpecError) as caught:
        resolve(decode(Source("rows.yaml", text)))
    (one,) = caught.value.diagnostics
    assert (one.code, one.notes) == ("E0402", (f"{note}, so the reactions would not be unique",))
