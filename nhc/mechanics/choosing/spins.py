"""The spin of a body that rolls about the normal of what it rolls on: the angular velocity that rolling leaves free.

Rolling without slipping is two rows a . omega = ... and b . omega = ... of the body's angular velocity; with the velocity of its
place, a x b . omega completes them: it belongs to the direction in which neither of them holds the body.
"""

from __future__ import annotations

from nhc.algebra.parts import take_out_common
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.mechanics.choosing.minors import unused_name
from nhc.mechanics.frame import form_value
from nhc.mechanics.rotations.turning import rows_in_base
from nhc.mechanics.rotations.turns import cross
from nhc.mechanics.system import Form, System

_TERMS = 120


def spins(system: System) -> list[Form]:
    """One form for each rotation that two rows hold, which hold no other, if these do not see how it has turned."""
    g, found, names = system.graph, list[Form](), list[str]()
    base = rows_in_base(system, system.constraints)
    held = [[[row[k] for k in rotation.places[1:]] for rotation in system.rotations] for row in base]
    by_name = {form.name: form for form in system.quasi}
    for k, (rotation, written) in enumerate(zip(system.rotations, system.spec.rotations, strict=True)):
        rows = [row for row in held if any(x != g.zero for x in row[k])]
        if len(rows) != 2 or not by_name.keys() >= set(written.velocities):
            continue
        if any(x != g.zero for row in rows for j, part in enumerate(row) if j != k for x in part):
            continue
        first, second = (row[k] for row in rows)
        across = cross(g, (first[0], first[1], first[2]), (second[0], second[1], second[2]))
        _, normal = take_out_common(g, [normalise_angles(g, x, _TERMS) for x in across])
        signs = [g.split_coefficient(x)[0] for x in normal if x != g.zero]
        normal = [g.neg(x) for x in normal] if 2 * sum(sign < 0 for sign in signs) > len(signs) else normal
        turned = g.mask([system.q[place] for place in rotation.places])
        if any(g.depends(x, turned) for x in normal):
            continue
        value = g.dot(normal, [form_value(system, by_name[w]) for w in written.velocities])
        names.append(unused_name(system, names))
        found.append(Form.written(names[-1], value, g, system.v, ""))
    return found
