"""Axes, places and velocities of bodies, written out as definitions of the language.

A body's axes follow from those that it stands on by turns, one after another.  For a turn by alpha about the axis k the
two others become e_i cos(alpha) + e_j sin(alpha) and e_j cos(alpha) - e_i sin(alpha), and the angular velocity gains
alpha' e_k.  A rotation R is one turn with its matrix and its own angular velocity.  The velocity of matter at P is that of the
body's origin O and omega x (P - O) (E. T. Whittaker, Analytical Dynamics, 4th ed. (1937), sections 13-17).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from nhc.diagnostics import Span
from nhc.records import record

from . import pieces
from .nodes import Text
from .pieces import Piece, Triple, add, each, multiply, write

AXES = "xyz"


@record
class Turn:
    """A turn about the axis 0, 1 or 2."""

    axis: int
    angle: Piece


@record
class Turning:
    """What a rotation brings: its matrix row by row, and its angular velocity ``on_body`` or in space."""

    matrix: tuple[Triple, Triple, Triple]
    omega: Triple
    on_body: bool


@record
class Frame:
    """``axes[k]`` are the components in space of the axis k, ``omega`` the angular velocity on the axes, ``origin`` in space.

    ``at`` is the origin on the axes of ``on``, and ``relative`` the angular velocity against them, on them.  ``before`` is
    the angular velocity on the axes before the last turn, the turn itself included.
    """

    name: str
    place: int
    on: str
    at: Triple
    origin: Triple
    axes: tuple[Triple, Triple, Triple]
    omega: Triple
    relative: Triple
    before: Triple
    last: int | None


@dataclass
class Ledger:
    """The definitions that are made, by name, in an order in which each uses earlier ones or those of the spec.

    ``constant`` are the names of what never changes, ``twice`` the first that a
    body or point would bring once more.
    """

    constant: set[str]
    made: dict[str, tuple[Piece, Span]] = field(default_factory=dict)
    twice: dict[Span, str] = field(default_factory=dict)

    def name(self, name: str, piece: Piece, span: Span) -> Piece:
        """Define a name; return what stands for it: itself, or a number or name that it would only repeat."""
        if piece.text == name and not piece.minus:  # a rotation and its body have one name, and mean the same by it
            return piece
        if name in self.made:
            self.twice.setdefault(span, name)
        self.made[name] = piece, span
        if self.is_still(piece):
            self.constant.add(name)
        return piece if piece.number is not None or piece.is_name else write(name, span.start)

    def names(self, prefix: str, letters: Sequence[str], values: Triple, span: Span) -> Triple:
        """Define the components of a vector."""
        return each(lambda k: self.name(f"{prefix}{letters[k]}", values[k], span))

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
    return Frame("", place, "", still, still, axes, still, still, still, None)


def place_frame(name: Text, on: Frame, at: Triple, turns: Sequence[Turn] | Turning, ledger: Ledger) -> Frame:
    """The frame of a body at ``at`` on the axes of ``on``; its origin, axes and angular velocity are defined by name."""
    here, span = name.span.start, name.span
    offset = each(lambda k: pieces.dot(at, _row(on.axes, k), here))
    origin = ledger.names(f"{name.value}_", AXES, pieces.plus(on.origin, offset, here), span)
    unit = space(here).axes
    before, last = on.omega, None
    if isinstance(turns, Turning):
        columns = _columns(turns.matrix)
        axes = _compose(on.axes, columns, here)
        carried = each(lambda k: pieces.dot(columns[k], on.omega, here))
        own = turns.omega if turns.on_body else each(lambda k: pieces.dot(columns[k], turns.omega, here))
        relative = each(lambda k: pieces.dot(turns.matrix[k], own, here)) if turns.on_body else turns.omega
        omega = pieces.plus(carried, own, here)
    else:
        axes, omega, relative, columns = on.axes, on.omega, space(here).omega, unit
        for step in turns:
            rate = ledger.rate(step.angle, here)
            spin = along(unit[step.axis], rate, here)
            before, last = pieces.plus(omega, spin, here), step.axis
            relative = pieces.plus(relative, along(columns[step.axis], rate, here), here)
            omega = pieces.turn(before, step.axis, step.angle, here)
            axes, columns = _turned(axes, step, here), _turned(columns, step, here)
    named = tuple(ledger.names(f"{name.value}_", [f"{x}{k + 1}" for x in AXES], axes[k], span) for k in range(3))
    spoken = ledger.names(f"{name.value}_w", "123", omega, span)
    return Frame(name.value, here, on.name, at, origin, (named[0], named[1], named[2]), spoken, relative, before, last)


def along(axis: Triple, length: Piece, place: int) -> Triple:
    """A vector of this length along an axis."""
    return each(lambda k: multiply(length, axis[k], place))


def _row(columns: Sequence[Triple], k: int) -> Triple:
    return columns[0][k], columns[1][k], columns[2][k]


def _columns(rows: Sequence[Triple]) -> tuple[Triple, Triple, Triple]:
    return _row(rows, 0), _row(rows, 1), _row(rows, 2)


def _compose(axes: Sequence[Triple], columns: Sequence[Triple], place: int) -> tuple[Triple, Triple, Triple]:
    """Axes given by their components on other axes."""

    def axis(k: int) -> Triple:
        return each(lambda x: pieces.dot(columns[k], _row(axes, x), place))

    return axis(0), axis(1), axis(2)


def _turned(axes: Sequence[Triple], step: Turn, place: int) -> tuple[Triple, Triple, Triple]:
    """Axes after one more turn about one of them."""
    rows = [pieces.turn(_row(axes, x), step.axis, step.angle, place) for x in range(3)]
    return _columns(rows)


# --- velocities of points -------------------------------------------------------------------------------------


def place_point(name: Text, on: Frame, of: Frame | None, at: Triple, ledger: Ledger) -> None:
    """Define the place of a point in space, and the velocity of the matter of ``of`` there, in space and on the axes of ``on``."""
    here, span = name.span.start, name.span
    offset = each(lambda k: pieces.dot(at, _row(on.axes, k), here))
    spot = ledger.names(f"{name.value}_", AXES, pieces.plus(on.origin, offset, here), span)
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
            omega = each(lambda k: pieces.dot(of.omega, _row(of.axes, k), here))
            swept = pieces.cross(omega, pieces.minus(spot, of.origin, here), here)
        velocity = pieces.plus(carried, swept, here)
    moving = ledger.names(f"{name.value}_v", AXES, velocity, span)
    if on.name:
        if turned is None:
            carried = moving
        own = each(lambda k: pieces.dot(on.axes[k], carried, here))
        ledger.names(f"{name.value}_v", "123", pieces.plus(own, turned, here) if turned else own, span)


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

    What is round about the axis of the last turn is the same before it, where the angular velocity is shorter.
    """
    here = frame.place
    terms = []
    if mass is not None:
        squares = [pieces.square(ledger.rate(c, here), here) for c in centre]
        terms.append(multiply(pieces.halve(mass, here), add(squares, here), here))
    if inertia is not None:
        (xx, yy, zz), omega = inertia.diagonal, frame.omega
        if frame.last is not None and inertia.is_round(frame.last):
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
