"""The extremes of steps that take velocity from their neighbours: of polynomials at points, of two pulses by heights.

Positions are at points too. Velocity and acceleration of a law of two pulses are exact by the heights of its pulses,
its jerk by its pieces' ends.
"""

from collections.abc import Callable
from math import isfinite, perm
from typing import Any

import numpy as np

from engine.motion import Phase
from engine.motion.handover import PULSES, Handover
from engine.motion.pieces import MotionPiece
from workbook.book.cell_tables import cell_tables
from workbook.book.checks import ZERO
from workbook.book.declare import Book, Quantity, Sheet
from workbook.book.rows import filled
from workbook.machines.machine.boundary.handover import AxisHandover
from workbook.machines.machine.view import POINTS, at_points

CELLS = cell_tables(__file__)

PLACE = "[d]*xi*([c1]+[d]*xi*([c2]+[d]*xi*[c3]))+[A]*SIN([om]*[d]*xi+[ph])"
"""position, from its begin, on a piece of a pulse, whose acceleration is a straight line and a sine"""


def points(book: Book, sheet: Sheet) -> None:
    """Declare the points that pieces and polynomials are looked at."""
    cell = CELLS["points"]
    title = "Points of a polynomial or a piece, as shares of its duration"
    sheet.table("piece_points", title, len(POINTS), cell("xi", POINTS.tolist()))
    book.name("piece_points", xi="xi")


def horner(powers: int, order: int) -> str:
    """Return the formula of a derivative (order 0 is y) of Σ e_n ξⁿ, per unit of ξ."""
    text = ""
    for n in range(powers - 1, max(order, 1) - 1, -1):
        share = perm(n, order)
        scaled = f"[e{n}]" if share == 1 else f"{share}*[e{n}]"
        inner = f"({text})" if "*" in text or "+" in text else text
        text = f"{scaled}+xi*{inner}" if text else scaled
    return text if order else f"xi*({text})"


def polynomial_extremes(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of the extremes of polynomials per unit of ξ, and the greatest velocity of two pulses."""
    column = handover.columns(CELLS["polynomial_extremes"])
    place, velocity, acceleration, jerk = (horner(handover.rows.powers, order) for order in range(4))

    def curved(step: Handover) -> bool:
        return step.ended and step.mode != PULSES

    def scaled(figure: Callable[[Phase], float], order: int) -> list[Any]:
        return handover.of(lambda step: figure(step.phase) * step.phase.duration**order if curved(step) else 0.0)

    def low_high(end: int) -> list[Any]:
        both = zip(handover.handed, handover.motion.reaches, handover.motion.ends, strict=True)
        return handover.spread([reach[end] - at.begin.y if curved(step) else 0.0 for step, reach, at in both])

    def fastest(step: Handover) -> float:
        speed = abs(step.reversing) if step.mode == PULSES else step.phase.y1_max if step.ended else 0.0
        return speed * step.phase.duration

    return [
        column("pv", fastest, order=0, velocity=velocity),
        column("pa", scaled(lambda phase: phase.y2_max, 2), order=0, acceleration=acceleration),
        column("pj", scaled(lambda phase: phase.y3_max, 3), order=0, jerk=jerk),
        column("plow", low_high(0), order=0, place=place),
        column("phigh", low_high(1), order=0, place=place),
    ]


def step_extremes(handover: AxisHandover) -> list[Quantity]:
    """Return the columns of the greatest velocity, acceleration and jerk, and both positions."""
    column = handover.columns(CELLS["step_extremes"])

    def ended(figure: Callable[[Phase], float]) -> list[Any]:
        return handover.of(lambda step: figure(step.phase) if step.ended else 0.0)

    def reaches(end: int) -> list[Any]:
        both = zip(handover.handed, handover.motion.reaches, strict=True)
        return handover.spread([reach[end] if step.ended else 0.0 for step, reach in both])

    jerks = [value if isfinite(value) else "∞" for value in ended(lambda phase: phase.y3_max)]
    return [
        column("vmax", ended(lambda phase: phase.y1_max), order=1),
        column("amax", ended(lambda phase: phase.y2_max), order=2),
        column("jumps", jumps(handover)),
        column("jmax", jerks, order=3),
        column("low", reaches(0), order=0),
        column("high", reaches(1), order=0),
    ]


def at_ends(piece: MotionPiece, order: int) -> list[float]:
    """Return a derivative at the begin and at the end of a piece."""
    return [float(y) for y in piece.curves[order](np.array([0.0, piece.duration]))]


def leaps(handover: AxisHandover) -> tuple[list[float], list[int]]:
    """Return y'' at the end of the piece before, within the phase (0 for its first), and whether y'' jumps there."""
    before, earlier, leaps_before = [0.0] * handover.room, [], []
    for piece in handover.rows.pieces:
        lasts, (first, last) = piece.duration > 0.0, at_ends(piece, 2)
        earlier.append(before[piece.phase] if lasts else 0.0)
        leaps_before.append(int(lasts and abs(first - earlier[-1]) > ZERO * handover.step_of(piece).phase.y2_max))
        if lasts:
            before[piece.phase] = last
    return earlier, leaps_before


def jumps(handover: AxisHandover) -> list[int]:
    """Return the number of jumps of y'' at the pieces of each step of two pulses, and at its end."""
    counts = [0] * handover.room
    for piece, leap in zip(handover.rows.pieces, leaps(handover)[1], strict=True):
        counts[piece.phase] += leap
    for place, step, at in zip(handover.axis.places, handover.handed, handover.motion.ends, strict=True):
        last = abs(at.end.y2) > ZERO * step.phase.y2_max
        counts[place] = counts[place] + last if step.mode == PULSES else 0
    return counts


def pulse_extremes(handover: AxisHandover, room: int) -> list[Quantity]:
    """Return the columns of the pieces' table: what pieces of laws of two pulses add to the extremes of their steps."""
    column = handover.columns(CELLS["pulse_extremes"])
    joints = handover.rows.at.pieces.replace("_pieces", "_joints")
    earlier, jumping = leaps(handover)

    def of(figure: Callable[[MotionPiece], float]) -> list[float]:
        both = ((piece, handover.step_of(piece)) for piece in handover.rows.pieces)
        return filled((figure(piece) if step.mode == PULSES and piece.duration else 0.0 for piece, step in both), room)

    lows = of(lambda piece: float(at_points(piece, 0).min()) - handover.begin_of(piece))
    highs = of(lambda piece: float(at_points(piece, 0).max()) - handover.begin_of(piece))
    return [
        column("before", filled(earlier, room), order=2, joints=joints),
        column("leap", filled(jumping, room), joints=joints),
        column("jerk", of(lambda piece: max(map(abs, at_ends(piece, 3)))), order=3),
        column("low", lows, order=0, place=PLACE),
        column("high", highs, order=0, place=PLACE),
    ]
