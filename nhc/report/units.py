"""Units as they are printed: ``kg m²`` for the ``kg*m^2`` of a spec."""

from __future__ import annotations

import re

_RAISED = str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079")


def typeset_unit(unit: str) -> str:
    """The unit with blanks that no line ends at for its products, and whole powers raised; others stay as they are."""
    raised = re.sub(
        r"\^(?:(-?\d+)(?![\d.])|\((-?\d+)\))", lambda found: found[found.lastindex or 0].translate(_RAISED), unit
    )
    return raised.replace("*", "\u00a0")


def typeset_label(label: str) -> str:
    """The label of an axis with the unit in brackets at its end typeset."""
    return re.sub(r" \[([^\[\]]*)\]$", lambda found: f" [{typeset_unit(found[1])}]", label)
