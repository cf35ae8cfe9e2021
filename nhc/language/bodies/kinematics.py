"""Axes, places and velocities of bodies, written out as definitions of the language.

A body's axes follow from those that it stands on by turns, one after another.  For a turn by alpha about the axis k the
two others become e_i cos(alpha) + e_j sin(alpha) and e_j cos(alpha) - e_i sin(alpha), and the angular velocity gains
alpha' e_k.  A rotation R is one turn with its matrix and its own angular velocity.  The velocity of matter at P is that of the
body's origin O and omega x (P - O) (E. T. Whittaker, Analytical Dynamics, 4th ed. (1937), sections 13-17).
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.diagnostics import Span
from nhc.language.bodies import pieces
from nhc.language.bodies.pieces import Piece, Triple, add, each, multiply, write
from nhc.language.yaml_tree.nodes import Text
from nhc.records import fresh, record, structure

AXES = "xyz"
Axes = tuple[Triple, Triple, Triple]


@record
class Turn:
    """A turn about the axis 0, 1 or 2."""

    axis: int
    angle: Piece


@record
class Turning:
    """What a rotation brings: its matrix row by row, and its angular velocity ``on_body`` or in space."""

    name: str
    matrix: Axes
    omega: Triple
    on_body: bool


@record
class Spin:
    """The last turn, by ``angle`` about an axis of ``axes``; what turns about one axis in a row, on any bodies, is one turn.

    So angles add up along a chain in the plane.  Turns by constants stay by themselves: the axes before them are where the body
    before has its own mass.  ``omega`` is the angular velocity on ``axes`` without this turn.
    """

    axis: int
    angle: Piece
    axes: Axes
    omega: Triple


@record
class Frame:
    """``axes[k]`` are the components in space of the axis k, ``omega`` the angular velocity on the axes, ``origin`` in space.

    ``at`` is the origin on the axes of ``on``, and ``relative`` the angular velocity against them, on them.  ``before`` is the
    angular velocity on the axes before the last turn of these axes, that turn included, and ``last`` its axis; all three after a
    rotation whose velocities are in space, none on the axes of space and after a rotation with velocities on its body's axes,
    where ``before`` would be longer.  ``heading`` is the whole angle about the z axis of space where there are no other turns.
    """

    name: str
    place: int
    on: str
    at: Triple
    origin: Triple
    axes: Axes
    omega: Triple
    relative: Triple
    spin: Spin | None
    before: Triple
    last: tuple[int, ...]
    heading: Piece | None


@structure
class Ledger:
    """The definitions that are made, by name, in an order in which each uses earlier ones or those of the spec.

    ``constant`` are the names of what never changes, ``declared`` what the spec declares without bodies, ``velocities`` the
    names of velocities, also where nothing but the time moves what they belong to, ``twice`` the first that a body or point
    would bring once more.
    """

    constant: set[str]
    declared: frozenset[str]
    velocities: set[str] = fresh(factory=set)
    made: dict[str, tuple[Piece, Span]] = fresh(factory=dict)
    twice: dict[Span, str] = fresh(factory=dict)

    def name(self, name: str, piece: Piece, span: Span) -> Piece:
        """Define a name; return what stands for it: itself, or a number or name that it would only repeat."""
        if piece.text == name and not piece.minus and name in self.declared:
            return piece  # a rotation and its body have one name, and mean the same by it
        if name in self.made:
            self.twice.setdefault(span, name)
        self.made[name] = piece, span
        if self.is_still(piece):
            self.constant.add(name)
        return piece if piece.number is not None or piece.is_name else write(name, span.start)

    def names(self, prefix: str, letters: Sequence[str], values: Triple, span: Span) -> Triple:
        """Define the components of a vector."""
        return each(lambda k: self.name(f"{prefix}{letters[k]}", values[k], span))

    def rates(self, prefix: str, letters: Sequence[str], values: Triple, span: Span) -> Triple:
        """Define the components of a velocity."""
        self.velocities.update(f"{prefix}{letter}" for letter in letters)
        return self.names(prefix, letters, values, span)

    def is_still(self, piece: Piece) -> bool:
        """Whether an expression is a constant."""
        return piece.number is not None or pieces.names_in_text(piece.text) <= self.constant

    def rate(self, position: Piece, place: int) -> Piece:
        """The time derivative of a position."""
        if self.is_still(position):
            return write("0", place)
        return write("1", place) if position.text == "t" and not position.minus else pieces.rate(position, place)


def space(place: int = 0) -> Frame:
    """The axes of space."""
    zero, one = write("0", place), write("1", place)
    still = zero, zero, zero
    axes = (one, zero, zero), (zero, one, zero), (zero, zero, one)
    return Frame("", place, "", still, still, axes, still, still, None, still, (), zero)


def place_frame(name: Text, on: Frame, at: Triple, turns: Sequence[Turn] | Turning, ledger: Ledger) -> Frame:
    """The frame of a body at ``at`` on the axes of ``on``; its origin, axes and angular velocity are defined by name."""
    here, span = name.span.start, name.span
    origin = _spot(name, on, at, ledger)
    spin, last, heading = None, tuple[int, ...](), None
    if isinstance(turns, Turning):
        axes, omega, relative = _rotated(on, turns, here)
        before, last = (omega, ()) if turns.on_body else (pieces.plus(on.omega, relative, here), (0, 1, 2))
    elif not turns:
        axes, omega, relative, spin, heading = on.axes, on.omega, space(here).omega, on.spin, on.heading
        before, last = on.before, on.last
    else:
        spin, before, relative = _spin(on, turns, ledger, here)
        angle = ledger.name(f"{name.value}_angle", spin.angle, span)
        spin, last = Spin(spin.axis, angle, spin.axes, spin.omega), (spin.axis,)
        axes, omega = _after(spin, ledger, here)
        if on.heading is not None and all(step.axis == 2 for step in turns):
            heading = add([on.heading, *(step.angle for step in turns)], here)
    named = tuple(ledger.names(f"{name.value}_", [f"{x}{k + 1}" for x in AXES], axes[k], span) for k in range(3))
    spoken = ledger.rates(f"{name.value}_w", "123", omega, span)
    return Frame(
        name.value,
        here,
        on.name,
        at,
        origin,
        (named[0], named[1], named[2]),
        spoken,
        relative,
        spin,
        before,
        last,
        heading,
    )


def _spot(name: Text, on: Frame, at: Triple, ledger: Ledger) -> Triple:
    """The place in space of what stands at ``at`` on the axes of ``on``, its coordinates defined by name."""
    here, span = name.span.start, name.span
    offset = each(lambda k: pieces.dot(at, _row(on.axes, k), here))
    return ledger.names(f"{name.value}_", AXES, pieces.plus(on.origin, offset, here), span)


def _rotated(on: Frame, turns: Turning, place: int) -> tuple[Axes, Triple, Triple]:
    """Axes, angular velocity and that against ``on`` of what a rotation carries."""
    columns = _columns(turns.matrix)
    axes = _compose(on.axes, columns, place)
    carried = each(lambda k: pieces.dot(columns[k], on.omega, place))
    own = turns.omega if turns.on_body else each(lambda k: pieces.dot(columns[k], turns.omega, place))
    relative = each(lambda k: pieces.dot(turns.matrix[k], own, place)) if turns.on_body else turns.omega
    return axes, pieces.plus(carried, own, place), relative


def _spin(on: Frame, turns: Sequence[Turn], ledger: Ledger, place: int) -> tuple[Spin, Triple, Triple]:
    """The last turn with those about the same axis right before it; the angular velocity before it; all turns against ``on``."""
    unit = space(place).axes
    spin, omega, before, relative, columns = on.spin, on.omega, on.omega, space(place).omega, unit
    for step in turns:
        rate, moves = ledger.rate(step.angle, place), not ledger.is_still(step.angle)
        relative = pieces.plus(relative, along(columns[step.axis], rate, place), place)
        columns = _turned(columns, step.axis, step.angle, place)
        before = pieces.plus(omega, along(unit[step.axis], rate, place), place)
        omega = pieces.turn(before, step.axis, step.angle, place)
        if spin is not None and spin.axis == step.axis and moves and not ledger.is_still(spin.angle):
            spin = Spin(spin.axis, add([spin.angle, step.angle], place), spin.axes, spin.omega)
        elif spin is None or spin is on.spin:
            spin = Spin(step.axis, step.angle, on.axes, on.omega)
        else:
            spin = Spin(step.axis, step.angle, *_after(spin, ledger, place))
    assert spin is not None
    return spin, before, relative


def _after(spin: Spin, ledger: Ledger, place: int) -> tuple[Axes, Triple]:
    """Axes and angular velocity after a turn."""
    turning = along(space(place).axes[spin.axis], ledger.rate(spin.angle, place), place)
    omega = pieces.turn(pieces.plus(spin.omega, turning, place), spin.axis, spin.angle, place)
    return _turned(spin.axes, spin.axis, spin.angle, place), omega


def along(axis: Triple, length: Piece, place: int) -> Triple:
    """A vector of this length along an axis."""
    return each(lambda k: multiply(length, axis[k], place))


def _row(columns: Sequence[Triple], k: int) -> Triple:
    return columns[0][k], columns[1][k], columns[2][k]


def _columns(rows: Sequence[Triple]) -> Axes:
    return _row(rows, 0), _row(rows, 1), _row(rows, 2)


def _compose(axes: Sequence[Triple], columns: Sequence[Triple], place: int) -> Axes:
    """Axes given by their components on other axes."""

    def axis(k: int) -> Triple:
        return each(lambda x: pieces.dot(columns[k], _row(axes, x), place))

    return axis(0), axis(1), axis(2)


def _turned(axes: Sequence[Triple], axis: int, angle: Piece, place: int) -> Axes:
    """Axes after one more turn about one of them."""
    return _columns([pieces.turn(_row(axes, x), axis, angle, place) for x in range(3)])


# --- velocities of points -------------------------------------------------------------------------------------


def place_point(name: Text, on: Frame, of: Frame | None, at: Triple, ledger: Ledger) -> None:
    """Define the place of a point in space, and the velocity of the matter of ``of`` there, in space and on the axes of ``on``."""
    here, span = name.span.start, name.span
    spot = _spot(name, on, at, ledger)
    if of is None:
        return
    turned = None
    if of is on and all(map(ledger.is_still, at)):
        velocity = each(lambda k: ledger.rate(spot[k], here))
        carried = velocity
    else:
        carried = each(lambda k: ledger.rate(of.origin[k], here))
        if of is on or of.on == on.name != "":
            arm = at if of is on else pieces.minus(at, of.at, here)
            omega = on.omega if of is on else pieces.plus(on.omega, of.relative, here)
            turned = pieces.cross(omega, arm, here)
            swept = each(lambda k: pieces.dot(turned, _row(on.axes, k), here))
        else:
            is_known = of.on == "" and len(of.last) == 3
            omega = of.before if is_known else each(lambda k: pieces.dot(of.omega, _row(of.axes, k), here))
            swept = pieces.cross(omega, pieces.minus(spot, of.origin, here), here)
        velocity = pieces.plus(carried, swept, here)
    moving = ledger.rates(f"{name.value}_v", AXES, velocity, span)
    if on.name:
        if turned is None:
            carried = moving
        own = each(lambda k: pieces.dot(on.axes[k], carried, here))
        ledger.rates(f"{name.value}_v", "123", pieces.plus(own, turned, here) if turned else own, span)


# --- energies -------------------------------------------------------------------------------------------------


@record
class Inertia:
    """The entries of the inertia matrix about the centre of mass, on the body's axes: xx, yy, zz and yz, xz, xy."""

    diagonal: Triple
    products: Triple

    def is_round(self, axis: int) -> bool:
        """Whether turns about an axis leave the matrix as it is."""
        i, j = (axis + 1) % 3, (axis + 2) % 3
        a, b = self.diagonal[i], self.diagonal[j]
        return all(p.is_zero for p in self.products) and (a.shown.text == b.shown.text)


def kinetic_energy(frame: Frame, mass: Piece | None, centre: Triple, inertia: Inertia | None, ledger: Ledger) -> Piece:
    """m v^2/2 of the centre of mass and omega.J omega/2 about it.

    What is round about the axis of the last turn, or a ball after a rotation, is the same before it, where the angular velocity
    is shorter.
    """
    here = frame.place
    terms = []
    if mass is not None:
        squares = [pieces.square(ledger.rate(c, here), here) for c in centre]
        terms.append(multiply(pieces.halve(mass, here), add(squares, here), here))
    if inertia is not None:
        (xx, yy, zz), omega = inertia.diagonal, frame.omega
        if frame.last and all(map(inertia.is_round, frame.last)):
            omega = frame.before
        (yz, xz, xy), (p, q, r) = inertia.products, omega
        if xx.shown.text == yy.shown.text == zz.shown.text:
            squares = [pieces.square(w, here) for w in omega]
            terms.append(multiply(pieces.halve(xx, here), add(squares, here), here))
        else:
            terms += [
                multiply(pieces.halve(j, here), pieces.square(w, here), here) for j, w in ((xx, p), (yy, q), (zz, r))
            ]
        mixed = ((xy, p, q), (xz, p, r), (yz, q, r))
        terms += [multiply(j, multiply(a, b, here), here) for j, a, b in mixed]
    return add(terms, here)
