"""A load that follows the angle of its axis, in cells: a slide on a press crank, the weight of a swinging arm."""

from typing import Any

import numpy as np

from engine.drive.mechanisms.by_angle import PressCrank as Crank
from engine.drive.quadrature import LoadPoints
from workbook.book.cell_tables import cell_tables
from workbook.book.declare import Quantity
from workbook.book.sentence import amount, quoted
from workbook.entries.phase import TURN
from workbook.fields.units import shown
from workbook.machines.machine.drive.driven import Driven, of_kind
from workbook.machines.machine.drive.mechanisms import slides
from workbook.machines.machine.drive.mechanisms.page import Column, constant_sizes
from workbook.machines.machine.drive.view import DriveView
from workbook.machines.machine.mechanism import PressCrank

CELLS = cell_tables(__file__)

NEAR = 1e-9  # of a turn, and of the sheet's check_zero: how near to whole turns a cycle must end


def crank_sizes(driven: Driven) -> list[Quantity]:
    """Return the rows of the ratios, and of the crank in m and rad."""
    cell = CELLS["crank_sizes"]
    crank = of_kind(Crank, driven.by_angle)
    return [
        *constant_sizes(driven),
        cell("@r", crank.crank),
        cell("@l", crank.rod),
        cell("@e", crank.offset),
        cell("@psi0", crank.start),
    ]


def varied(i: int, k: int) -> dict[str, Any]:
    """Return other sizes for the i-th axis in the k-th variation."""
    crank = 20.0 + 9 * k + i
    return {
        "crank_radius": crank,
        "rod_length": crank * (5.0 - 0.5 * k),
        "offset": (None, 0.2 * crank, -0.3 * crank)[k % 3],
    }


def slide(driven: Driven, load: LoadPoints, of: Column) -> list[Quantity]:
    """Return the columns of the slide: where it is by the crank's angle, its velocity and its acceleration."""
    cell = CELLS["slide"]
    crank = of_kind(Crank, driven.by_angle)
    psi, x = load.position + crank.start, crank.position(load.position)
    velocity, acceleration = load.moving
    return [
        cell("psi", of(psi), scale=max(float(np.abs(psi).max()), 1.0)),
        *slides.pin(crank.crank, psi, of),
        cell("X", of(x), scale=crank.rod),
        *slides.travel(crank.crank, crank.offset, psi, x, of),
        cell("vs", of(velocity), scale=crank.crank * max(float(np.abs(load.velocity).max()), 1e-9)),
        cell("as", of(acceleration), scale=max(float(np.abs(acceleration).max()), 1e-9)),
    ]


def resisting(view: DriveView, steady: str, friction: str) -> str:
    """Return the formula, without =, of what resists at the axis without inertia, by those of both its parts."""
    if view.slides:
        return f"[dx]*{steady}+[dir]*ABS([dx])*{friction}"
    return f"{steady}+[dir]*{friction}" + ("+@arm*COS([y]+RADIANS(@arm_angle))" if view.driven.by_angle else "")


def forces(view: DriveView) -> tuple[tuple[str, str], tuple[str, str]]:
    """Return the resisting torque at the axis without inertia, and the driving torque: formula and equation."""
    resists = f"={resisting(view, 'INDEX([@iv.steady],[iv])', 'INDEX([@iv.friction],[iv])')}"
    viscous = f"+@viscous*{'[vs]' if view.slides else '[v]'}" if view.is_viscous else ""
    if view.slides:
        return (resists, "dx/dψ F_r, without inertia"), (f"=[R]+[dx]*(@m*[as]{viscous})", "F_r + dx/dψ m ẍ")
    return (resists, "without inertia"), (f"=[R]+@m*[a]{viscous}", "F_r + m ÿ")


def ends_in_place(driven: Driven) -> bool:
    """Return whether a cycle ends at the angle where it begins: after whole turns, or none."""
    turns = shown(driven.axis.motion.lifts_sum, driven.axis.unit) / TURN
    return abs(turns - round(turns)) <= NEAR


def checks(view: DriveView) -> list[Quantity]:
    """Return the checks that a cycle ends in the angle in which it begins, and that a crank can turn round."""
    driven, i, crank = view.driven, view.driven.number, slides.CRANK_SLIDER
    travel = amount(
        f"[axes.travel.{i}]",
        shown(driven.axis.motion.lifts_sum, driven.axis.unit),
        "it ends ",
        " ° from where it begins",
    )
    cell = CELLS["checks"].sharing(**view.parts)
    whole = cell("@ok_turns", ends_in_place(driven), says=travel)
    if not view.slides:
        return [whole]
    apart = quoted(PressCrank.APART)
    return [cell("@ok_linked", True, fits=crank.fits, holds=crank.holds, says=apart), whole]
